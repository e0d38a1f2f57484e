import assert from 'node:assert/strict';
import {beforeEach, test} from 'node:test';

import {causeColor, causeWords, fateSign, isBlocked, setCauses} from '../../../web/page/causes.js';

beforeEach(() => setCauses([
  {key: 'delivered', text: 'delivered', color: '#009e73', outcome: 'whole'},
  {key: 'damaged', text: 'delivered damaged', color: '#f0e442', outcome: 'damaged'},
  {key: 'dropped', text: 'dropped at random', color: '#cc79a7', outcome: 'stopped'},
  {key: 'in_transit', text: 'in transit', color: '#999999', outcome: 'pending'},
  {key: 7}, null,
]));

test('only what is received is not blocked, and each outcome has its sign', () => {
  const causes = ['delivered', 'damaged', 'dropped', 'in_transit'];
  assert.deepEqual(causes.map(isBlocked), [false, false, true, true]);
  assert.equal(new Set(causes.map(fateSign)).size, 4);
});

test('texts and colours are those of the table', () => {
  assert.equal(causeWords('dropped'), 'dropped at random');
  assert.notEqual(causeColor('delivered', false), causeColor('dropped', false));
});

test('an unknown cause has its own name, a colour, and has stopped the transmission', () => {
  assert.equal(causeWords('eaten_by_a_whale'), 'eaten by a whale');
  assert.ok(isBlocked('eaten_by_a_whale'));
  for (const cause of ['constructor', '', null, undefined, 'eaten_by_a_whale']) {
    assert.match(causeColor(cause, false), /^#[0-9a-f]{6}$/);
    assert.equal(fateSign(cause), '✗');
  }
});

test('what is no table is an empty one', () => {
  for (const table of [undefined, null, 'x', {}]) {
    setCauses(table);
    assert.equal(causeWords('dropped'), 'dropped');
  }
});
