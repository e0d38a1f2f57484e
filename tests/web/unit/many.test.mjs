import assert from 'node:assert/strict';
import {test} from 'node:test';

import {placeLabels} from '../../../web/map/draw_labels.js';
import {heatCell, heatColor} from '../../../web/panels/heat_map.js';
import {kMaxRows, rowsOf} from '../../../web/panels/vehicle_list.js';

const all = {text: '', sort: null, isDown: false, closed: new Set()};
const fleet = (count) => Array.from({length: count}, (_, i) => (
  {name: `boat_${i + 1}`, type: 'kayak', group: '', nav: {speed: (i * 7) % 5}}));
const names = ({rows}) => rows.map(({vehicle, group}) => vehicle?.name ?? `[${group}]`);

test('a list is searched by name, type, group and mode', () => {
  const vehicles = [...fleet(3), {name: 'deep', type: 'auv', group: 'divers', mode: 'DRIVE:square'}];
  assert.deepEqual(names(rowsOf(vehicles, 0, {...all, text: 'BOAT_2'})).filter((n) => n[0] !== '['),
                   ['boat_2']);
  for (const text of ['auv', 'divers', 'square']) {
    assert.equal(rowsOf(vehicles, 0, {...all, text}).num_found, 1, text);
  }
  assert.equal(rowsOf(vehicles, 0, {...all, text: 'nothing'}).num_found, 0);
});

test('a list is sorted by a column, to and fro, what is not known last', () => {
  const vehicles = [{name: 'b10', nav: {speed: 2}}, {name: 'b9', nav: {speed: 3}}, {name: 'b1'}];
  assert.deepEqual(names(rowsOf(vehicles, 0, all)), ['b10', 'b9', 'b1'], 'the mission\'s order');
  assert.deepEqual(names(rowsOf(vehicles, 0, {...all, sort: 'name'})), ['b1', 'b9', 'b10']);
  assert.deepEqual(names(rowsOf(vehicles, 0, {...all, sort: 'speed'})), ['b10', 'b9', 'b1']);
  assert.deepEqual(names(rowsOf(vehicles, 0, {...all, sort: 'speed', isDown: true})),
                   ['b9', 'b10', 'b1']);
  assert.deepEqual(names(rowsOf(vehicles, 0, {...all, sort: '__proto__'})), ['b10', 'b9', 'b1']);
});

test('groups have heads, and close', () => {
  const vehicles = [{name: 'a', group: 'x'}, {name: 'b', group: 'y'}, {name: 'c', group: 'x'}];
  assert.deepEqual(names(rowsOf(vehicles, 0, all)), ['[x]', 'a', 'c', '[y]', 'b']);
  const {rows} = rowsOf(vehicles, 0, {...all, closed: new Set(['x'])});
  assert.deepEqual(names({rows}), ['[x]', '[y]', 'b']);
  assert.equal(rows[0].count, 2);
  assert.deepEqual(names(rowsOf(fleet(2), 0, all)), ['boat_1', 'boat_2'], 'one group is none');
});

test('a list of a thousand shows what can be read, and how many more there are', () => {
  const found = rowsOf(fleet(1000), 0, all);
  assert.equal(found.rows.length, kMaxRows);
  assert.equal(found.left_out, 1000 - kMaxRows);
});

test('a heat map has cells that let all be seen, and colours from nothing to all', () => {
  assert.equal(heatCell(500, 100), 4);
  assert.equal(heatCell(500, 1000), 3, 'never too small to point at');
  assert.equal(heatCell(5000, 70), 16);
  assert.deepEqual(heatColor(0), [213, 94, 0]);
  assert.deepEqual(heatColor(1), [86, 180, 233]);
  assert.deepEqual(heatColor(7), heatColor(1));
});

test('of a thousand vehicles in the picture the labels are thinned out, the chosen one stays', () => {
  const items = Array.from({length: 1000}, (_, i) => ({x: (i % 40) * 100, y: Math.floor(i / 40) * 60,
    radius: 10, sizes: [{width: 80, height: 35}, {width: 40, height: 20}], must: i === 900}));
  const placed = placeLabels(items, 4000, 1600);
  assert.ok(placed[900]);
  assert.ok(placed.filter(Boolean).length <= 200);
});
