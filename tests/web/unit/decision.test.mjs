import assert from 'node:assert/strict';
import test from 'node:test';

import {choiceWords, lossWords, roleWords} from '../../../web/panels/decision.js';

test('names course, speed and depth, and leaves out what may be any', () => {
  assert.equal(choiceWords({course: 74, speed: 2, depth: -1}), '74°, 2.0 m/s');
  assert.equal(choiceWords({course: 0, speed: -1, depth: 12.5}), '0°, 12.5 m deep');
  assert.equal(choiceWords({course: -1, speed: -1, depth: -1}), 'any');
});

test('names the contact, the rule and the numbers that decided', () => {
  assert.equal(roleWords({contact: 'ben', role: 'give-way:stern', rule: '15/16', range: 48.2,
    cpa: 3.1, age: 2}), 'give-way:stern toward ben (rule 15/16), 48.2 m, CPA 3.1 m, known 2.0 s ago');
  assert.equal(roleWords({contact: '', role: ''}), '');
  assert.equal(roleWords({contact: 'ben', role: 'avoid', rule: '', range: -1, cpa: -1, age: -1}),
    'avoid toward ben');
});

test('shows no loss of a behavior without a preference', () => {
  assert.equal(lossWords({weight: 0, loss: 0}), '–');
  assert.equal(lossWords({weight: 100, loss: 18.94}), '18.9');
});
