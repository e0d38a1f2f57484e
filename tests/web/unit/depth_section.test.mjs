import assert from 'node:assert/strict';
import test from 'node:test';

import {depthSection, floorDepthAt, isWorthShowing, placeOnTrail}
  from '../../../web/charts/depth_section.js';

const kFloor = {x0: 0, y0: 0, step_m: 10, nx: 2, ny: 2, depth_m: [10, 20, 30, 40]};
const kTrail = {t: [0, 10, 20], x: [0, 8, 8], y: [0, 0, 6], count: 3};

test('the floor is between the points of its grid, and nowhere else', () => {
  assert.equal(floorDepthAt(kFloor, 0, 0), 10);
  assert.equal(floorDepthAt(kFloor, 5, 5), 25);
  assert.equal(floorDepthAt(kFloor, -0.1, 5), null);
  assert.equal(floorDepthAt(kFloor, 5, 10), null);
  assert.equal(floorDepthAt({...kFloor, depth_m: [10, null, 'x', 40]}, 5, 5), null);
  assert.equal(floorDepthAt(null, 0, 0), null);
});

test('a place on the trail is between its points', () => {
  assert.deepEqual(placeOnTrail(kTrail, 5), {x: 4, y: 0});
  assert.deepEqual(placeOnTrail(kTrail, 15), {x: 8, y: 3});
  assert.deepEqual(placeOnTrail(kTrail, 99), {x: 8, y: 6});
  assert.equal(placeOnTrail(kTrail, -1), null);
  assert.equal(placeOnTrail(null, 1), null);
});

test('a section grows with the way, and stands still with the vehicle', () => {
  const section = depthSection({t: [0, 5, 5.1, 10, 20], depth: [0, 2, 2, null, 6],
    desired_depth: [0, 3, 3, 3, -1], altitude: [null, null, null, null, 9]}, kTrail, kFloor);
  assert.deepEqual(section.way_m.map(Math.round), [0, 4, 11]);
  assert.deepEqual(section.depth, [0, 2, 6]);
  assert.deepEqual(section.desired, [0, 3, null]);
  assert.deepEqual(section.floor, [10, 14, 15], 'of the grid, and where it is measured of that');
  assert.ok(isWorthShowing(section));
});

test('a surface craft without a floor has no section to look at', () => {
  assert.ok(!isWorthShowing(depthSection({t: [0, 5], depth: [0, 0]}, kTrail, null)));
  assert.ok(!isWorthShowing(depthSection(null, null, null)));
});
