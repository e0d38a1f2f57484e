import assert from 'node:assert/strict';
import test from 'node:test';

import {commonUnit, hueOf, joinSeries, kMaxCharts, kMaxFields, readPlots, spansOf, unitOf, writePlots}
  from '../../../web/charts/field_series.js';
import {hasWords, stateFields} from '../../../web/panels/panel_data.js';

test('charts are written into the address and read again, whatever their fields are called', () => {
  const plots = [['NAV_ALPHA:x_m', 'A,B;C:d[0].e'], ['X:</script>']];
  assert.deepEqual(readPlots(writePlots(plots)), plots);
  assert.equal(writePlots([[]]), null);
});

test('what is no field is left out, and there are no more than fit', () => {
  assert.deepEqual(readPlots('a;NAV:x,NAV:x,:y,z:,%;,;'), [['NAV:x']]);
  assert.deepEqual(readPlots(null), []);
  const many = Array.from({length: 20}, (_, i) => `A:f${i}`);
  assert.equal(readPlots(many.join(','))[0].length, kMaxFields);
  assert.equal(readPlots(many.join(';')).length, kMaxCharts);
  assert.deepEqual(readPlots(`A:${'x'.repeat(400)}`), []);
});

test('a unit is that of the name, and of a chart where all have it', () => {
  assert.equal(unitOf('NAV_ALPHA:speed_mps'), 'm/s');
  assert.equal(unitOf('NAV_ALPHA:index'), '');
  assert.equal(commonUnit(['A:x_m', 'B:y_m']), 'm');
  assert.equal(commonUnit(['A:x_m', 'B:y_deg']), '');
});

test('series of different times come onto one axis', () => {
  const {t, columns} = joinSeries([{t: [1, 3], value: [10, 30]}, {t: [2, 3, NaN], value: [5, 'x', 1]}, null]);
  assert.deepEqual(t, [1, 2, 3]);
  assert.deepEqual(columns, [[10, null, 30], [null, 5, null], [null, null, null]]);
});

test('a text that stays the same is one span', () => {
  const spans = spansOf({t: [1, 2, 3, 5], value: ['PARK', 'PARK', 'DRIVE', 'PARK']}, 9);
  assert.deepEqual(spans, [{begin_s: 1, end_s: 3, text: 'PARK'}, {begin_s: 3, end_s: 5, text: 'DRIVE'},
    {begin_s: 5, end_s: 9, text: 'PARK'}]);
  assert.deepEqual(spansOf(null, 9), []);
  assert.equal(hueOf('DRIVE', 8), hueOf('DRIVE', 8));
});

test('a search needs all words', () => {
  assert.ok(hasWords('NAV_ALPHA:x_m', 'nav X_M'));
  assert.ok(!hasWords('NAV_ALPHA:x_m', 'nav y_m'));
});

test('the states of a vehicle are those of channels that there are', () => {
  assert.deepEqual(stateFields('alpha', ['HELM_STATE_ALPHA', 'HELM_STATE_BRAVO']),
    ['HELM_STATE_ALPHA:state', 'HELM_STATE_ALPHA:task']);
});
