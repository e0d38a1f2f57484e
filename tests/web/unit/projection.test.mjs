import assert from 'node:assert/strict';
import {test} from 'node:test';

import {LocalFrame} from '../../../web/map/geometry.js';
import {groundImage} from '../../../web/map/ground_image.js';
import {fromUtm, fromWebMercator, projectionOf, tileCorner, tilePlace}
  from '../../../web/map/projection.js';

const near = (value, wanted, tolerance, what) => assert.ok(Math.abs(value - wanted) <= tolerance,
  `${what}: ${value}, wanted ${wanted}`);

/** UTM by the integral of the meridian and the series of the sphere, another way: Snyder (1987). */
function toUtm(lonDeg, latDeg, zone) {
  const [a, f, k0] = [6378137, 1 / 298.257223563, 0.9996];
  const e2 = f * (2 - f);
  const ep2 = e2 / (1 - e2);
  const lat = latDeg * Math.PI / 180;
  const along = (lonDeg - (6 * zone - 183)) * Math.PI / 180;
  const N = a / Math.sqrt(1 - e2 * Math.sin(lat) ** 2);
  const T = Math.tan(lat) ** 2;
  const C = ep2 * Math.cos(lat) ** 2;
  const A = along * Math.cos(lat);
  let meridian = 0;  // Simpson's rule.
  const steps = 2000;
  for (let i = 0; i <= steps; ++i) {
    const weight = i === 0 || i === steps ? 1 : i % 2 === 1 ? 4 : 2;
    meridian += weight * a * (1 - e2) / (1 - e2 * Math.sin(lat * i / steps) ** 2) ** 1.5;
  }
  meridian *= lat / steps / 3;
  const east = k0 * N * (A + (1 - T + C) * A ** 3 / 6
    + (5 - 18 * T + T ** 2 + 72 * C - 58 * ep2) * A ** 5 / 120) + 500000;
  const north = k0 * (meridian + N * Math.tan(lat) * (A ** 2 / 2
    + (5 - T + 9 * C + 4 * C ** 2) * A ** 4 / 24
    + (61 - 58 * T + T ** 2 + 600 * C - 330 * ep2) * A ** 6 / 720));
  return [east, north];
}

test('UTM leads back to the degrees that a second way began with', () => {
  for (const [lon, lat, zone] of [[-70.33, 43.825, 19], [-69, 0.5, 19], [9.3, 63.4, 32],
    [-66.5, 10, 19], [3, 83, 31]]) {
    const [east, north] = toUtm(lon, lat, zone);
    const [backLon, backLat] = fromUtm(east, north, zone);
    near(backLon, lon, 1e-7, `longitude of ${lon}, ${lat}`);
    near(backLat, lat, 1e-7, `latitude of ${lon}, ${lat}`);
  }
  const [lon, lat] = fromUtm(500000, 10_000_000, 19, true);
  near(lon, -69, 1e-12, 'the meridian');
  near(lat, 0, 1e-12, 'the equator');
});

test('a coordinate system is known by its number', () => {
  near(projectionOf(32619)(500000, 0)[0], -69, 1e-12, 'WGS 84 / UTM 19N');
  near(projectionOf(32733)(500000, 9_000_000)[1], -9.0456, 1e-3, 'WGS 84 / UTM 33S');
  near(projectionOf(25832)(500000, 6_000_000)[0], 9, 1e-9, 'ETRS89 / UTM 32N');
  near(projectionOf(26919)(500000, 4_800_000)[0], -69, 1e-9, 'NAD83 / UTM 19N');
  near(projectionOf(3857)(...[-70 * Math.PI / 180 * 6378137, 5311971.846945471])[1], 43, 1e-9, 'web');
  for (const epsg of [0, 2154, 32600, 32661, 32700, 32761, 25839, 32767, NaN]) {
    assert.equal(projectionOf(epsg), null, String(epsg));
  }
  near(fromWebMercator(0, 0)[1], 0, 1e-12, 'the equator');
});

test('tiles are counted from longitude -180 and from the North', () => {
  near(tilePlace(-180, 85.0511287798066, 3).x, 0, 1e-9, 'column');
  near(tilePlace(-180, 85.0511287798066, 3).y, 0, 1e-9, 'row');
  const {x, y} = tilePlace(-70.33, 43.825, 12);
  const [lon, lat] = tileCorner(x, y, 12);
  near(lon, -70.33, 1e-9, 'longitude');
  near(lat, 43.825, 1e-9, 'latitude');
  assert.ok(tileCorner(0, 0, 1)[1] > 85 && Math.abs(tileCorner(0, 1, 1)[1]) < 1e-9);
});

test('an image in a projection lies to half a pixel where each of its pixels belongs', () => {
  const frame = new LocalFrame({lat_deg: 43.8, lon_deg: -66.2});
  const [east, north] = toUtm(-66.2, 43.8, 19);
  const image = {width: 2000, height: 2000};
  const place = (u, v) => {
    const [lon, lat] = fromUtm(east - 20000 + 20 * u, north + 20000 - 20 * v, 19);
    return frame.toLocal(lat, lon);
  };
  const {cells, box} = groundImage(image, place);
  assert.ok(box.right - box.left > 40000, 'grid North is two degrees from North there');
  for (const {u, v, w, h, ul, ur, ll} of cells) {
    for (const [a, b] of [[0.5, 0.5], [1, 1], [0.2, 0.9]]) {
      const real = place(u + a * w, v + b * h);
      near(ul.x + a * (ur.x - ul.x) + b * (ll.x - ul.x), real.x, 20, 'East');
      near(ul.y + a * (ur.y - ul.y) + b * (ll.y - ul.y), real.y, 20, 'North');
    }
  }
  assert.equal(groundImage(image, () => null), null, 'out of reach');
});
