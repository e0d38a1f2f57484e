import assert from 'node:assert/strict';
import {test} from 'node:test';

import {Backgrounds, cornersOf, shapesOf} from '../../../web/map/background.js';
import {LocalFrame} from '../../../web/map/geometry.js';

const frame = new LocalFrame({lat_deg: 43, lon_deg: -70});
const feature = (type, coordinates) => ({type: 'Feature', geometry: {type, coordinates}});

test('lines and areas of GeoJSON lie where their degrees are', () => {
  const {shapes} = shapesOf({type: 'FeatureCollection', features: [
    feature('LineString', [[-70, 43], [-70, 43.001]]),
    feature('MultiPolygon', [[[[-70, 43], [-69.999, 43], [-69.999, 43.001], [-70, 43]]]]),
    {type: 'GeometryCollection', geometries: [{type: 'Point', coordinates: [-70, 43]}]}]}, frame);
  assert.equal(shapes.length, 3);
  assert.ok(Math.abs(shapes[0].x[1]) < 1e-3 && Math.abs(shapes[0].y[1] - 111.1) < 0.2);
  assert.deepEqual(shapes.map((shape) => shape.isArea), [false, true, false]);
  assert.ok(shapes[1].box.right > 80);
});

test('what is no GeoJSON, or too much of it, does no harm', () => {
  let deep = {type: 'Point', coordinates: [-70, 43]};
  for (let i = 0; i < 1000; ++i) deep = {type: 'GeometryCollection', geometries: [deep]};
  for (const json of [null, 7, 'x', [], {}, {type: 'FeatureCollection', features: 'no'}, deep,
    feature('Polygon', null), feature('Polygon', [7, null]), feature('LineString', [[NaN, 'x'], 3]),
    feature('__proto__', [[1, 2]]), feature('LineString', [[200, 100], [1e300, -1e300]])]) {
    assert.deepEqual(shapesOf(json, frame).shapes, []);
  }
  const line = Array.from({length: 600_000}, (_, i) => [-70 + i * 1e-7, 43]);
  const {shapes, num_left_out: more} = shapesOf(
    {type: 'FeatureCollection', features: [feature('LineString', line), feature('LineString', line)]},
    frame);
  assert.deepEqual([shapes.length, more], [1, 1], 'a million points are enough');
});

test('a world file puts an image into metres or degrees', () => {
  const metres = cornersOf('2\n0\n0\n-2\n-99\n49\n', 100, 50, frame);
  assert.deepEqual(metres, {left: -100, top: 50, right: 100, bottom: -50});
  const geo = cornersOf('0.0001 0 0 -0.0001 -70 43', 100, 100, frame);
  assert.ok(Math.abs(geo.right - geo.left - 815) < 5 && geo.top > 0 && geo.bottom < -1000);
  for (const text of ['', '1 2 3', '1 0.5 0 -1 0 0', 'x 0 0 -1 0 0', '-1 0 0 -1 0 0', '1 0 0 0 0 0']) {
    assert.equal(cornersOf(text, 10, 10, frame), null, text);
  }
});

test('a file that is none is named with the reason', async () => {
  const backgrounds = new Backgrounds();
  const file = (name, text, size = text.length) => ({name, size, text: async () => text});
  const words = await backgrounds.take([file('a.geojson', 'not json'), file('b.geojson', '{}'),
    file('c.geojson', '', 1e9)], frame, {left: 0, right: 1, bottom: 0, top: 1});
  assert.match(words[0], /^a.geojson: neither GeoJSON nor an image/);
  assert.match(words[1], /^b.geojson: no coast line/);
  assert.match(words[2], /^c.geojson: larger than 64 MB/);
  const good = JSON.stringify(feature('LineString', [[-70, 43], [-70, 43.001]]));
  assert.deepEqual(await backgrounds.take([file('coast.geojson', good)], frame, {}), []);
  assert.equal(backgrounds.all.length, 1);
  backgrounds.clear();
  assert.equal(backgrounds.all.length, 0);
});
