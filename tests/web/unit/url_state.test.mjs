import assert from 'node:assert/strict';
import {test} from 'node:test';

import {readHash, writeHash} from '../../../web/page/url_state.js';

const kLayers = ['trails', 'names', 'grid'];

test('what is written is read again', () => {
  const state = {
    x: 12.5, y: -150, metresPerPixel: 0.5, follow: 'alpha', select: 'bravo', from: 'alpha',
    to: 'bravo', layers: {trails: true, names: false, grid: true}, tab: 'comms', t: 93.5,
    theme: 'light', plots: [['NAV_ALPHA:x_m', 'NAV_BRAVO:x_m'], ['A:b']],
    pulses: 'lines',
  };
  assert.deepEqual(readHash(writeHash(state), kLayers), state);
});

test('what is not given stays open', () => {
  const nothing = readHash('', kLayers);
  assert.ok(Object.values(nothing).every((value) => value === null));
  assert.equal(writeHash(nothing), '#');
  assert.equal(writeHash({t: 0, x: NaN, follow: null}), '#t=0');
});

test('no layer at all is something else than no word about layers', () => {
  const none = {trails: false, names: false, grid: false};
  assert.deepEqual(readHash(writeHash({layers: none}), kLayers).layers, none);
  assert.equal(readHash('#tab=comms', kLayers).layers, null);
});

test('a name with every kind of character comes back', () => {
  const name = 'a&b=c#d,e f%ä"<script>';
  assert.equal(readHash(writeHash({select: name}), kLayers).select, name);
});

test('numbers that are none, too large or not positive are left out', () => {
  const {x, y, metresPerPixel, t} = readHash('#x=NaN&y=1e300&mpp=-1&t=Infinity', kLayers);
  assert.deepEqual([x, y, metresPerPixel, t], [null, null, null, null]);
  assert.equal(readHash('#x=', kLayers).x, null);
});

test('unknown tabs, themes and layers and giant texts are left out', () => {
  const state = readHash(
    `#tab=__proto__&theme=pink&pulses=all&layers=nonsense&follow=${'a'.repeat(65)}`, kLayers);
  assert.deepEqual([state.tab, state.theme, state.follow, state.pulses], [null, null, null, null]);
  assert.deepEqual(state.layers, {trails: false, names: false, grid: false});
  assert.equal(readHash(`#follow=${'a'.repeat(1e6)}`, kLayers).follow, null);
});

test('a broken escape does not throw', () => {
  assert.doesNotThrow(() => readHash('#select=%E0%A4%A&x=%', kLayers));
});
