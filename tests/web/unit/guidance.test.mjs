import assert from 'node:assert/strict';
import test from 'node:test';

import {guidanceFacts, layerWords} from '../../../web/panels/guidance.js';

const kGuidance = {t: 12, pitch: -2.14, crab: 4.2, layers: [
  {name: 'sonar', speed: 0.52, weight: 1}, {name: 'feed_forward', speed: 2, weight: 0.79}]};

test('shows pitch, crab angle and each layer with its weight', () => {
  assert.equal(layerWords(kGuidance.layers[0]), 'sonar 0.52 m/s × 1.00');
  const facts = guidanceFacts({guidance: kGuidance}, 13);
  assert.deepEqual(facts[0], ['Guidance', 'pitch -2.1°, crab angle by ALOS 4.2°']);
  assert.deepEqual(facts[1],
    ['Layers', 'sonar 0.52 m/s × 1.00, feed forward 2.00 m/s × 0.79']);
});

test('shows nothing of guidance that is old, absent or without layers', () => {
  assert.deepEqual(guidanceFacts({guidance: kGuidance}, 16), []);
  assert.deepEqual(guidanceFacts({guidance: null}, 16), []);
  assert.equal(guidanceFacts({guidance: {...kGuidance, layers: []}}, 12).length, 1);
});
