import assert from 'node:assert/strict';
import test from 'node:test';

import {drawDrawings, labelPlace, tidyDrawings} from '../../../web/map/draw_drawings.js';
import {Camera} from '../../../web/map/map_camera.js';

/** A canvas that records what is drawn. */
function paper() {
  const calls = [];
  return new Proxy({calls}, {
    get: (target, name) => (name in target ? target[name]
      : (...args) => calls.push([name, ...args])),
    set: (target, name, value) => {
      if (name === 'fillStyle') calls.push(['color', value]);
      target[name] = value;
      return true;
    },
  });
}
const theme = {light: false, water: '#000'};
const camera = () => {
  const made = new Camera(400, 300);
  made.set(0, 0, 1);
  return made;
};
const drawn = (list) => {
  const ctx = paper();
  drawDrawings(ctx, camera(), theme, tidyDrawings(list));
  return ctx.calls;
};
const count = (calls, name) => calls.filter(([one]) => one === name).length;

test('whatever comes is tidied', () => {
  assert.deepEqual(tidyDrawings(null), []);
  assert.deepEqual(tidyDrawings([null, {}, {points: 'x'}, {kind: 'point', points: [[NaN, 1], ['a']]}]), []);
  const [one] = tidyDrawings([{kind: 'circle', label: 'x'.repeat(1000), radius: -5, fill: 7,
    points: [[1, 2], null]}]);
  assert.deepEqual([one.label.length, one.radius, one.fill, one.points], [60, 0, 1, [[1, 2]]]);
  assert.equal(tidyDrawings(Array(1000).fill({kind: 'point', points: [[0, 0]]})).length, 500);
});

test('each kind is drawn in its colour', () => {
  const points = [[0, 0], [50, 0], [50, 50]];
  const polygon = drawn([{kind: 'polygon', points, fill: 0.2, color: 'red'}]);
  assert.equal(count(polygon, 'fill'), 1);
  assert.equal(count(polygon, 'stroke'), 1);
  assert.match(polygon.find(([name]) => name === 'color')[1], /^#ff/);
  assert.equal(count(drawn([{kind: 'seglist', points, fill: 1}]), 'fill'), 0, 'a line has no inside');
  assert.equal(count(drawn([{kind: 'circle', points, radius: 20}]), 'arc'), 1);
  assert.equal(count(drawn([{kind: 'point', points, label: 'mine'}]), 'fillText'), 1);
  const text = drawn([{kind: 'text', points, text: 'start here', label: 'hidden'}]);
  assert.deepEqual(text.filter(([name]) => name === 'fillText').map((call) => call[1]), ['start here']);
  assert.equal(count(text, 'stroke'), 0);
});

test('a label stands in the middle of a shape, and at the begin of a line', () => {
  const points = [[0, 0], [100, 0], [100, 50]];
  assert.deepEqual(labelPlace({kind: 'polygon', points}), [50, 25]);
  assert.deepEqual(labelPlace({kind: 'seglist', points}), [0, 0]);
});

test('a polygon that reaches far beyond the map is filled within what a canvas can draw', () => {
  const calls = drawn([{kind: 'polygon', fill: 0.5, points: [[-1e7, -1e7], [1e7, -1e7], [0, 1e7]]}]);
  for (const [, x, y] of calls.filter(([name]) => name === 'lineTo')) {
    assert.ok(Math.abs(x) <= 30000 && Math.abs(y) <= 30000, `${x} ${y}`);
  }
});
