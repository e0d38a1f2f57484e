import assert from 'node:assert/strict';
import {test} from 'node:test';

import {
  LocalFrame, bearingDegrees, circleTouchesBox, clipSegment, gridStep, metresText, mixDegrees,
  pulseTriangle, roundStep, scaleBarMetres, wrapDegrees,
} from '../../../web/map/geometry.js';
import {Camera} from '../../../web/map/map_camera.js';
import {placesToFit} from '../../../web/map/map_places.js';

const near = (actual, expected, tolerance) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`);

// Computed with lib/base/geodesy (GeographicLib): origin, x, y, latitude, longitude.
const kGeodesy = [
  [43.8253, -70.3304, 1000, 2000, 43.843299663708, -70.317964817078],
  [43.8253, -70.3304, -8000, 6000, 43.879257483749, -70.429941204389],
  [43.8253, -70.3304, 120000, -150000, 42.466080678304, -68.871819948263],
  [-17, 179.9999, 1000, 2000, -16.981927902163, -179.990709979260],
  [-17, 179.9999, 120000, -150000, -18.351665243878, -178.865179007903],
  [78.2, 15.6, -8000, 6000, 78.253525378900, 15.248127979642],
  [78.2, 15.6, 120000, -150000, 76.813594107072, 20.313666527028],
];

test('latitude and longitude are those of lib/base/geodesy, to a tenth of a millimetre', () => {
  for (const [lat_deg, lon_deg, x, y, lat, lon] of kGeodesy) {
    const frame = new LocalFrame({lat_deg, lon_deg});
    const geo = frame.toGeo(x, y);
    near(geo.lat, lat, 1e-9);
    near(geo.lon, lon, 1e-9);
    const local = frame.toLocal(lat, lon);
    near(local.x, x, 1e-4);
    near(local.y, y, 1e-4);
  }
});

test('a degree of latitude North of the default origin is 111,129.880 m', () => {
  const north = new LocalFrame({lat_deg: 43.8253, lon_deg: -70.3304}).toLocal(44.8253, -70.3304);
  near(north.y, 111129.880234, 1e-5);
  near(north.x, 0, 1e-6);
});

test('the plane agrees with the radii of curvature of WGS84 near the origin', () => {
  const frame = new LocalFrame({lat_deg: 43.8253, lon_deg: -70.3304});
  const lat = 43.8253 * Math.PI / 180;
  const w2 = 1 - 0.00669437999014 * Math.sin(lat) ** 2;
  const meridian_m = 6378137 * (1 - 0.00669437999014) / w2 ** 1.5;
  const parallel_m = 6378137 / Math.sqrt(w2) * Math.cos(lat);
  near(frame.toLocal(43.8263, -70.3304).y, meridian_m * 0.001 * Math.PI / 180, 0.001);
  near(frame.toLocal(43.8253, -70.3294).x, parallel_m * 0.001 * Math.PI / 180, 0.001);
});

test('there is no map out of reach, nor for what is no point of the Earth', () => {
  const frame = new LocalFrame({lat_deg: 43.8253, lon_deg: -70.3304});
  for (const [lat, lon] of [[NaN, 0], [0, Infinity], [91, 0], [-43.8, 109.7], [0, 1e300], [null]]) {
    assert.equal(frame.toLocal(lat, lon), null);
  }
  assert.equal(frame.toGeo(NaN, 0).lat, null);
  assert.equal(frame.toGeo(1e300, 0).lon, null);
});

test('headings turn the short way', () => {
  near(mixDegrees(350, 10, 0.5), 0, 1e-9);
  near(mixDegrees(10, 350, 0.25), 5, 1e-9);
  near(mixDegrees(90, 180, 2), 270, 1e-9);
  near(wrapDegrees(-1e-20), 0, 1e-9);
  assert.ok(wrapDegrees(-1e-20) < 360);
  near(bearingDegrees(1, 0), 90, 1e-9);
  near(bearingDegrees(-1, -1), 225, 1e-9);
});

test('grid lines stand at round metres and neither too dense nor too rare', () => {
  for (let scale = 0.005; scale < 5000; scale *= 1.07) {
    const step = gridStep(scale, 90);
    assert.ok(step / scale >= 89.99 && step / scale <= 226, `${step} m at ${scale} m/px`);
    const lead = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
    assert.ok([1, 2, 5].some((round) => Math.abs(lead - round) < 1e-6), `${step}`);
  }
  assert.equal(gridStep(1, 90), 100);
  assert.equal(gridStep(2.3, 90), 500);
  assert.equal(roundStep(0.2), 0.2);
});

test('the scale bar is the longest round one that fits', () => {
  assert.equal(scaleBarMetres(1, 180), 100);
  assert.equal(scaleBarMetres(0.1, 180), 10);
  assert.equal(scaleBarMetres(3, 180), 500);
  assert.equal(scaleBarMetres(1, 200), 200);
});

test('metres are written as a sailor would', () => {
  assert.equal(metresText(250, 50), '250 m');
  assert.equal(metresText(0.5, 0.1), '0.5 m');
  assert.equal(metresText(12500, 500), '12.5 km');
  assert.equal(metresText(-3000, 1000), '-3 km');
});

test('a segment is cut to the box, also one that is 1e300 long', () => {
  assert.deepEqual(clipSegment(-10, 5, 20, 5, 0, 0, 10, 10), [0, 5, 10, 5]);
  assert.deepEqual(clipSegment(2, 2, 3, 3, 0, 0, 10, 10), [2, 2, 3, 3]);
  assert.equal(clipSegment(-5, 0, 0, 12, 0, 0, 10, 10), null);
  assert.equal(clipSegment(NaN, 0, 1, 1, 0, 0, 10, 10), null);
  const cut = clipSegment(5, 5, 1e300, 5, 0, 0, 10, 10);
  near(cut[2], 10, 1e-6);
});

test('a circle is drawn only where its line crosses the picture', () => {
  assert.ok(circleTouchesBox(5, 5, 3, 0, 0, 10, 10));
  assert.ok(!circleTouchesBox(5, 5, 100, 0, 0, 10, 10), 'it encloses the picture');
  assert.ok(!circleTouchesBox(100, 5, 50, 0, 0, 10, 10), 'it lies beside it');
  assert.ok(circleTouchesBox(100, 5, 95, 0, 0, 10, 10));
});

test('a pulse is a point at the source and as wide as given at the receiver', () => {
  const [x0, y0, x1, y1, x2, y2] = pulseTriangle({from: [0, 0], to: [100, 0], width: 10});
  assert.deepEqual([x0, y0, x1, y1, x2, y2], [0, 0, 100, 5, 100, -5]);
  const slant = pulseTriangle({from: [10, 10], to: [40, 50], width: 8});
  near(Math.hypot(slant[2] - slant[4], slant[3] - slant[5]), 8, 1e-9);
  near((slant[2] + slant[4]) / 2, 40, 1e-9);
  near((slant[2] - slant[4]) * 30 + (slant[3] - slant[5]) * 40, 0, 1e-9);
  assert.equal(pulseTriangle({from: [1, 1], to: [1, 1], width: 5}), null);
  assert.equal(pulseTriangle({from: [1, null], to: ['a', 1], width: 5}), null);
});

test('what lies under the pointer stays there while the view is zoomed', () => {
  const camera = new Camera(800, 600, 100, -50, 2);
  const [x, y] = [camera.x(700), camera.y(20)];
  camera.zoom(3.7, 700, 20);
  near(camera.x(700), x, 1e-9);
  near(camera.y(20), y, 1e-9);
  near(camera.metresPerPixel, 2 / 3.7, 1e-12);
  for (let i = 0; i < 500; ++i) camera.zoom(2);
  assert.ok(camera.metresPerPixel > 0);
  camera.set(NaN, Infinity, -1);
  near(camera.sy(camera.y(33)), 33, 1e-6);
});

test('what is fitted into the picture lies clear of its edges and of the scale bar', () => {
  const camera = new Camera(800, 600);
  camera.fit(-100, -200, 100, 300);
  assert.ok(camera.sy(-200) < 600 - 44 - 40 && camera.sy(300) > 40);
  near(camera.sx(0), 400, 1e-9);
  camera.fit(-1000, 0, 1000, 10);
  near(camera.sx(-1000), 800 / 12, 1e-6);
  const tiny = new Camera(10, 10);
  tiny.fit(0, 0, 100, 100);
  assert.ok(tiny.metresPerPixel > 0 && Number.isFinite(tiny.cy));
});

test('what is planned and what moved is shown, not a shore station far away', () => {
  const setup = {vehicles: [
    {name: 'boat', start: [0, 0], behaviors: [{name: 'go', points: [[600, 0], [600, 400]]}]},
    {name: 'driven', start: [0, -50]},
    {name: 'buoy', start: [700, 0]},
    {name: 'shore', start: [400, -9000]}]};
  const now = setup.vehicles.map(({name, start: [x, y]}) => ({name, x, y}));
  assert.deepEqual(placesToFit(setup, now), {left: 0, right: 700, bottom: -50, top: 400});
  const trail = {x: [0, 0], y: [-50, -500], count: 2};
  assert.equal(placesToFit(setup, now, (name) => (name === 'driven' ? trail : null)).bottom, -500);
  assert.equal(placesToFit({vehicles: [setup.vehicles[3]]}, [now[3]]).bottom, -9000,
               'where there is nothing else it is all');
});

test('the whole mission takes in vehicles, tasks with their radius, and the op area', () => {
  const setup = {op_area: [[0, 0], [400, -300]],
    vehicles: [{name: 'a', start: [-5, 0], tasks: [{points: [[0, 100]], radius_m: 30}]}, null,
      {tasks: 7}]};
  assert.deepEqual(placesToFit(setup, [{name: 'a', x: 900, y: null}, {name: 'b', x: 500, y: 0}]),
                   {left: -30, right: 500, bottom: -300, top: 130});
  assert.equal(placesToFit({}, []), null);
  const alone = placesToFit({}, [{x: 1, y: 1}]);
  assert.ok(alone.right - alone.left >= 60, 'one vehicle alone is not magnified without end');
});
