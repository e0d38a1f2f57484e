import assert from 'node:assert/strict';
import {test} from 'node:test';

import {contourLevels, contourLines, floorContours, isFloor} from '../../../web/map/contours.js';

function floorOf(nx, ny, depthAt, {x0 = 0, y0 = 0, step_m = 10} = {}) {
  const depth_m = [];
  for (let j = 0; j < ny; ++j) {
    for (let i = 0; i < nx; ++i) depth_m.push(depthAt(x0 + i * step_m, y0 + j * step_m));
  }
  return {x0, y0, step_m, nx, ny, depth_m};
}

const pointsOf = (line) =>
  Array.from({length: line.length / 2}, (_, i) => [line[2 * i], line[2 * i + 1]]);

test('on a plane that slopes East each contour is one straight line across', () => {
  const lines = contourLines(floorOf(11, 6, (x) => 20 + 0.5 * x), 33);
  assert.equal(lines.length, 1);
  const points = pointsOf(lines[0]);
  assert.equal(points.length, 6);
  for (const [x] of points) assert.ok(Math.abs(x - 26) < 1e-9);
  assert.deepEqual(points.map(([, y]) => y).sort((a, b) => a - b), [0, 10, 20, 30, 40, 50]);
});

test('around a cone each contour is one closed circle', () => {
  const floor = floorOf(41, 41, (x, y) => Math.hypot(x, y), {x0: -200, y0: -200});
  const lines = contourLines(floor, 105);
  assert.equal(lines.length, 1);
  const points = pointsOf(lines[0]);
  assert.deepEqual(points[0], points.at(-1));
  for (const [x, y] of points) assert.ok(Math.abs(Math.hypot(x, y) - 105) < 1);
  assert.ok(points.some(([x]) => x < -100) && points.some(([x]) => x > 100));
});

test('every point of a contour lies on an edge of the grid, at its depth', () => {
  const depthAt = (x, y) => 50 + 20 * Math.sin(x / 37) * Math.cos(y / 29) + 0.02 * x;
  const floor = floorOf(30, 25, depthAt);
  for (const {level, lines} of floorContours(floor)) {
    assert.ok(lines.length > 0, `${level}`);
    for (const [x, y] of lines.flatMap(pointsOf)) {
      const [i, j] = [x / 10, y / 10];
      const alongX = Math.abs(j - Math.round(j)) < 1e-9;
      assert.ok(alongX || Math.abs(i - Math.round(i)) < 1e-9);
      const [a, b] = alongX ? [[Math.floor(i), Math.round(j)], [Math.ceil(i), Math.round(j)]]
        : [[Math.round(i), Math.floor(j)], [Math.round(i), Math.ceil(j)]];
      const part = alongX ? i - a[0] : j - a[1];
      const [da, db] = [a, b].map(([k, l]) => floor.depth_m[l * 30 + k]);
      assert.ok(Math.abs(da + (db - da) * part - level) < 1e-6);
    }
  }
});

test('a saddle is cut by the depth of its middle', () => {
  const corners = (sw, se, nw, ne) =>
    ({x0: 0, y0: 0, step_m: 1, nx: 2, ny: 2, depth_m: [sw, se, nw, ne]});
  const ends = (floor) => contourLines(floor, 10).map((line) => pointsOf(line));
  // Deep South-West and North-East; the middle is deep: the shallow corners are cut off.
  for (const line of ends(corners(20, 4, 4, 20))) {
    const middle = [(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2];
    assert.ok((middle[0] > 0.5) !== (middle[1] > 0.5));
  }
  // The middle is shallow: the deep corners are.
  for (const line of ends(corners(12, 0, 0, 12))) {
    const middle = [(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2];
    assert.ok((middle[0] > 0.5) === (middle[1] > 0.5));
  }
});

test('cells with an unknown corner have no contour, the others keep theirs', () => {
  const floor = floorOf(6, 6, (x) => x);
  floor.depth_m[0] = null;
  const points = contourLines(floor, 5).flatMap(pointsOf);
  assert.ok(points.every(([, y]) => y >= 10));
  assert.ok(points.length >= 5);
});

test('levels are round and lie inside the range', () => {
  assert.deepEqual(contourLevels(12, 88, 10), [20, 30, 40, 50, 60, 70, 80]);
  assert.deepEqual(contourLevels(0, 1, 5), [0.2, 0.4, 0.6, 0.8, 1]);
  assert.deepEqual(contourLevels(80, 80), []);
  assert.deepEqual(contourLevels(-Infinity, Infinity), []);
  assert.ok(contourLevels(0, 4321).length <= 11);
});

test('what is no floor has no contours', () => {
  for (const floor of [null, undefined, {}, {nx: 2, ny: 2, step_m: 1, x0: 0, y0: 0, depth_m: [1]},
    {nx: 1e9, ny: 1e9, step_m: 1, x0: 0, y0: 0, depth_m: []},
    {nx: 2, ny: 2, step_m: 0, x0: 0, y0: 0, depth_m: [1, 2, 3, 4]},
    {nx: 2, ny: 2, step_m: 1, x0: 0, y0: 0, depth_m: [null, null, null, null]}]) {
    assert.deepEqual(floorContours(floor), []);
  }
  assert.ok(isFloor(floorOf(2, 2, () => 5)));
});
