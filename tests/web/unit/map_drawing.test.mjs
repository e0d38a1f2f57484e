import assert from 'node:assert/strict';
import {test} from 'node:test';

import {
  chosenColors, kindColor, luminance, palette, parseColor, readable, setVehicles, vehicleColor,
} from '../../../web/page/colors.js';
import {labelLines, placeLabels} from '../../../web/map/draw_labels.js';
import {Camera} from '../../../web/map/map_camera.js';
import {coverageOf, surveysOf} from '../../../web/map/map_painter.js';
import {activeNames, drawTasks, rangesOf, tasksKey} from '../../../web/map/draw_tasks.js';
import {drawSwaths} from '../../../web/map/draw_trails.js';
import {drawBelieved, drawnLength, hullOf, isStopped} from '../../../web/map/draw_vehicles.js';
import {choosePulses} from '../../../web/map/draw_signals.js';

const size = (width, height = 20) => ({width, height});
const item = (x, y, more = {}) => ({x, y, radius: 10, sizes: [size(100, 35), size(40)], ...more});
const boxOf = (items, placed) => placed.flatMap((place, i) =>
  place ? [{...place, ...items[i].sizes[place.form]}] : []);

function overlaps(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

test('a label with room stands to the right, in full', () => {
  assert.deepEqual(placeLabels([item(100, 100)]), [{form: 0, side: 0, x: 112, y: 82.5}]);
});

test('a label keeps clear of a wreck or a small loiter, on a leader line where it must', () => {
  const beside = {x: 100, y: 60, width: 120, height: 80};
  const [moved] = placeLabels([item(100, 100)], 800, 600, [beside]);
  assert.ok(moved.side !== 0, 'not over it');
  const around = {x: 80, y: 75, width: 50, height: 50};
  const [led] = placeLabels([item(100, 100)], 800, 600, [around]);
  assert.ok(led.side >= 4, `a leader line: ${led.side}`);
  const everywhere = {x: 0, y: 0, width: 800, height: 600};
  assert.ok(placeLabels([item(100, 100)], 800, 600, [everywhere])[0].side < 4,
            'where there is no room it stands beside its vehicle');
});

test('labels never overlap, and where it is crowded some are shortened or left out', () => {
  const items = Array.from({length: 80},
                           (_, i) => item(200 + (i * 53) % 170, 200 + (i * 31) % 140));
  const placed = placeLabels(items, 1280, 720);
  const boxes = boxOf(items, placed);
  for (let i = 0; i < boxes.length; ++i) {
    for (let k = i + 1; k < boxes.length; ++k) assert.ok(!overlaps(boxes[i], boxes[k]));
  }
  assert.ok(placed.some((place) => place?.form === 1));
  assert.ok(placed.some((place) => place === null));
  assert.ok(boxes.length > 8);
});

test('every vehicle has its name before others have more', () => {
  const fleet = Array.from({length: 50}, (_, i) => ({x: 100 + 75 * (i % 10),
    y: 100 + 75 * Math.floor(i / 10), radius: 13, sizes: [size(90, 35), size(66, 19)]}));
  const placed = placeLabels(fleet, 870, 680);
  assert.equal(placed.filter((place) => place === null).length, 0);
  assert.ok(placed.some((place) => place.form === 0), 'where there is room for more');
});

test('the selected vehicle has its whole label whatever it covers', () => {
  const items = [item(100, 100), item(104, 101), item(101, 104), item(103, 103), item(102, 102)];
  items[4].must = true;
  assert.equal(placeLabels(items, 200, 200)[4].form, 0);
});

test('a stopped vehicle chooses before the others', () => {
  const room = [item(100, 100), item(112, 104)];
  const later = placeLabels(room)[1];
  room[1].first = true;
  const sooner = placeLabels(room)[1];
  assert.equal(sooner?.form, 0);
  assert.notDeepEqual(later, sooner);
});

test('a label keeps its side while there is room, and stays in the picture', () => {
  assert.equal(placeLabels([item(100, 100, {side: 3})])[0].side, 3);
  const [edge] = placeLabels([item(190, 100)], 200, 200);
  assert.equal(edge.side, 1);
});

test('a label shows what a user has to know first', () => {
  const vehicle = {name: 'alpha', mode: 'DRIVE survey', depth: 12.34, stale: false,
    helm: {state: 'DRIVE', all_stop: 'clear'}};
  assert.deepEqual(labelLines(vehicle, 20).map(({text}) => text),
                   ['alpha', 'DRIVE survey \u00b7 12.3 m']);
  const stopped = {...vehicle, helm: {state: 'ALL-STOP', all_stop: 'left the op area'}};
  assert.ok(isStopped(stopped) && !isStopped(vehicle) && !isStopped({helm: null}));
  assert.equal(labelLines(stopped, 20)[1].text, 'ALL-STOP: left the op area');
  const parked = {...vehicle, mode: 'PARK', helm: {state: 'PARK', all_stop: 'never deployed'}};
  assert.ok(!isStopped(parked), 'a parked vehicle is at rest');
  assert.deepEqual(labelLines(parked, 20).map(({text, color}) => [text, color]),
                   [['alpha', undefined], ['never deployed', undefined]]);
  const stale = {...vehicle, depth: 0, stale: true, report: {t: 4}};
  assert.deepEqual(labelLines(stale, 20).map(({text}) => text),
                   ['alpha', 'DRIVE survey', 'stale 16 s']);
  const silent = {name: 'x'.repeat(500), mode: 'y'.repeat(500), depth: null, stale: true};
  assert.ok(labelLines(silent, 0).every(({text}) => text.length <= 40));
});

test('every type has a hull, and none is drawn shorter than can be seen', () => {
  assert.deepEqual(['kayak', 'SHIP', 'mokai', 'uuv', 'glider', 'submarine', '', null, 'constructor']
      .map(hullOf),
  ['kayak', 'ship', 'mokai', 'auv', 'glider', 'dart', 'dart', 'dart', 'dart']);
  const camera = {metresPerPixel: 0.5};
  assert.equal(drawnLength({length_m: 40}, camera), 80);
  for (const length_m of [0, -1, 3, NaN, null, undefined]) {
    assert.ok(drawnLength({length_m}, camera) >= 12);
  }
  assert.ok(drawnLength({length_m: 1e300}, camera) < 1e5);
});

test('how far a vehicle sends and receives follows the rules in force', () => {
  const rules = {comms_range_m: 250, critical_range_m: 30,
    factors: {alpha: {stealth: 0.5, earange: 2}}};
  assert.deepEqual(rangesOf(rules, 'alpha'), {sends_m: 125, receives_m: 500, critical_m: 30});
  assert.deepEqual(rangesOf(rules, 'bravo'), {sends_m: 250, receives_m: 250, critical_m: 30});
  assert.deepEqual(rangesOf({comms_range_m: -1}, 'bravo'),
                   {sends_m: null, receives_m: null, critical_m: null});
  assert.equal(rangesOf(null, 'bravo').sends_m, null);
});

test('a vehicle is at the task of its helm and at what took part in its last decision', () => {
  const decision = {t: 10, aims: [{name: 'fence'}, {name: 'survey'}]};
  assert.deepEqual([...activeNames({helm: {task: 'b'}}, 10)], ['b']);
  assert.deepEqual([...activeNames({helm: {task: '', state: 'DRIVE'}, decision}, 11)],
                   ['fence', 'survey']);
  assert.equal(activeNames({decision}, 20).size, 0, 'it decides no longer');
  assert.equal(activeNames({helm: {task: 'b', state: 'PARK'}}, 0).size, 0, 'it has not begun');
  const at = (waypoint) => tasksKey([{helm: {task: 'a', waypoint}}], 'alpha', 0);
  assert.notEqual(at(1), at(2));
  assert.notEqual(tasksKey([{decision}], null, 10), tasksKey([{decision}], null, 20));
});

test('the whole plan is drawn, dimmed before and after it is active', () => {
  const part = (name, x) => ({name, points: [[x, 0], [x, 10]], area: []});
  const region = {name: 'fence', points: [], area: [[-40, -40], [40, -40], [40, 40]]};
  const plan = new Map([['alpha', [part('first', 10), part('second', 20), region]]]);
  const strokesAt = (helm, decision) => {
    const strokes = [];
    const ctx = {globalAlpha: 1, setLineDash() {}, beginPath() { this.x = []; },
      moveTo(x) { this.x.push(x); }, lineTo() {}, arc() {}, fill() {},
      stroke() { strokes.push([this.x[0], this.globalAlpha]); }};
    drawTasks(ctx, new Camera(100, 100), {light: true},
              [{name: 'alpha', color: 'red', helm, decision}], plan, null, 5);
    return new Map(strokes);
  };
  const atStart = strokesAt(null, null);
  assert.deepEqual([...atStart.keys()].sort(), [10, 60, 70], 'two tasks and a region');
  assert.ok([...atStart.values()].every((opacity) => opacity < 0.4), 'planned, not begun');
  const later = strokesAt({state: 'DRIVE', task: 'second', waypoint: 0},
                          {t: 5, aims: [{name: 'fence'}]});
  assert.ok(later.get(60) < 0.4, 'the first is done, and still to be seen');
  assert.ok(later.get(70) > 0.8 && later.get(10) >= 0.8, 'the second and the region are active');
});

test('few pulses are beams, many are thin lines, thinned; the chosen ones stand out', () => {
  const links = (count) => Array.from({length: count}, (_, i) => ({id: i, label: `A${i}2B${i}`}));
  const nothing = () => false;
  assert.equal(choosePulses(links(6), 'auto', nothing).beams.length, 6);
  const many = choosePulses(links(60), 'auto', nothing);
  assert.deepEqual([many.beams.length, many.lines.length], [0, 60]);
  const crowd = choosePulses(links(3000), 'auto', ({id}) => id === 7);
  assert.ok(crowd.lines.length < 120, 'thinned');
  assert.deepEqual(crowd.beams.map(({id}) => id), [7], 'still there for a chosen vehicle');
  const again = choosePulses(links(3000).reverse(), 'auto', ({id}) => id === 7);
  assert.deepEqual(new Set(again.lines.map(({id}) => id)), new Set(crowd.lines.map(({id}) => id)),
                   'the same links from picture to picture');
  assert.equal(choosePulses(links(3000), 'lines', nothing).lines.length, 3000);
  assert.equal(choosePulses(links(3000), 'beams', nothing).beams.length, 3000);
  const chosen = choosePulses(links(3000), 'chosen', ({id}) => id < 40);
  assert.deepEqual([chosen.beams.length, chosen.lines.length, chosen.chosen.length], [0, 0, 40]);
});

test('colours are known however MOOS writes them', () => {
  assert.equal(parseColor('dodgerblue'), 0x1e90ff);
  assert.equal(parseColor('Dodger_Blue'), 0x1e90ff);
  assert.equal(parseColor('light grey'), 0xd3d3d3);
  assert.equal(parseColor('#12aBf0'), 0x12abf0);
  assert.equal(parseColor('#abc'), 0xaabbcc);
  assert.equal(parseColor('hex:1f,44,88'), 0x1f4488);
  for (const text of ['', '#', '#12345', '#12345g', 'nocolour', null, 7, 'a'.repeat(1e6)]) {
    assert.equal(parseColor(text), null, String(text).slice(0, 20));
  }
});

// WCAG 2 contrast.
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

test('every colour can be seen on its ground', () => {
  const colors = ['black', 'navy', 'white', 'yellow', 'red', 'midnightblue', 'ivory', '#777', ''];
  for (const color of colors) {
    setVehicles([]);
    assert.ok(contrast(parseColor(vehicleColor('a', color, false)), 0x0b1622) >= 3, color);
    assert.ok(contrast(parseColor(vehicleColor('a', color, true)), 0xf2f6f9) >= 2.8, color);
  }
  for (const color of Object.values(palette)) {
    assert.ok(contrast(parseColor(readable(parseColor(color), false)), 0x0b1622) >= 3, color);
  }
});

test('a colour that can be seen is left as it is', () => {
  setVehicles([]);
  assert.equal(vehicleColor('a', 'orange', false), '#ffa500');
  assert.equal(vehicleColor('b', 'firebrick', true), '#b22222');
});

test('a vehicle without a colour has one, always the same', () => {
  setVehicles([]);
  assert.equal(vehicleColor('alpha', '', false), vehicleColor('alpha', undefined, false));
  const colors = new Set(Array.from({length: 40}, (_, i) => vehicleColor(`v${i}`, '', false)));
  assert.equal(colors.size, 40);
});

test('kinds have colours of their own, unknown ones too', () => {
  const kinds = ['report', 'message', 'ack', 'packet'];
  assert.equal(new Set(kinds.map((kind) => kindColor(kind, false))).size, 4);
  for (const cause of ['constructor', '', null, undefined]) {
    assert.match(kindColor(cause, true), /^#[0-9a-f]{6}$/);
  }
});

test('two vehicles that ask for one colour have different ones, those of the plots', () => {
  const vehicles = [{name: 'a', color: 'yellow', shown_color: '#ffff00'},
    {name: 'b', color: 'yellow', shown_color: '#1f77b4'}];
  assert.deepEqual([...chosenColors(vehicles)], [['a', 0xffff00], ['b', 0x1f77b4]]);
  setVehicles(vehicles);
  assert.notEqual(vehicleColor('a', 'yellow', false), vehicleColor('b', 'yellow', false));
});

test('a vehicle that came later gets a colour that no other has, and keeps it', () => {
  setVehicles([{name: 'a', color: 'yellow', shown_color: '#ffff00'}]);
  const first = vehicleColor('late', 'yellow', false);
  assert.notEqual(first, vehicleColor('a', 'yellow', false));
  assert.notEqual(vehicleColor('later', 'yellow', false), first);
  assert.equal(vehicleColor('late', 'yellow', false), first);
  const hundred = Array.from({length: 100}, (_, i) => ({name: `boat_${i}`, color: 'yellow'}));
  setVehicles(hundred);
  const colors = new Set(hundred.map(({name, color}) => vehicleColor(name, color, false)));
  assert.ok(colors.size > 90, `${colors.size} colours`);
  setVehicles([{name: 'x', shown_color: 'red; background: url(x)'}, {name: 'y', shown_color: 3}]);
  assert.match(vehicleColor('x', '', false), /^#[0-9a-f]{6}$/);
});

test('what sensors covered is drawn as broad as they see, for the vehicles that count', () => {
  const coverage = coverageOf({coverage: [{width_m: 20, areas: [], vehicles: ['alpha']}, {}, null]});
  assert.equal(coverage.length, 1);
  const strokes = [];
  const ctx = {globalAlpha: 1, setLineDash() {}, beginPath() { this.points = []; },
    moveTo(x, y) { this.points.push([x, y]); }, lineTo(x, y) { this.points.push([x, y]); },
    stroke() {
      strokes.push({width: this.lineWidth, points: this.points, opacity: this.globalAlpha});
    }};
  const trail = {t: [0, 10, 20, 30], x: [-90, 0, 90, 90], y: [-60, -60, -60, 60], count: 3};
  const world = {trail: () => trail};
  const vehicles = ['alpha', 'bravo'].map((name) => ({name, color: 'red'}));
  drawSwaths(ctx, new Camera(100, 100), {light: true}, world, coverage, vehicles, 25);
  assert.equal(strokes.length, 1);
  assert.equal(strokes[0].width, 20);
  assert.ok(strokes[0].opacity < 0.5 && ctx.globalAlpha === 1);
  // Half of the track lies in the picture's rim, which is as broad as the swath reaches into it.
  assert.deepEqual(strokes[0].points, [[-40, 110], [140, 110]]);
  drawSwaths(ctx, new Camera(100, 100, 0, 400), {light: true}, world, coverage, vehicles, 25);
  assert.deepEqual(strokes[1].points, []);
});

test('where a vehicle believes to be is drawn as its ellipse, with the way there', () => {
  const ellipses = [];
  const points = [];
  const ctx = {globalAlpha: 1, beginPath() {}, stroke() {},
    moveTo(x, y) { points.push([x, y]); }, lineTo(x, y) { points.push([x, y]); },
    ellipse(...what) { ellipses.push(what); }};
  const navigation = {x: 10, y: 20, major: 8, minor: 4, direction: 90};
  drawBelieved(ctx, new Camera(200, 200, 0, 0, 2), {light: true},
               [{name: 'alpha', x: 0, y: 0, navigation}, {name: 'bravo', x: 5, y: 5}]);
  // Two metres to a pixel; an axis to the East lies level.
  assert.deepEqual(ellipses, [[105, 90, 4, 2, 0, 0, 2 * Math.PI]]);
  assert.deepEqual(points, [[100, 100], [105, 90]]);
  assert.equal(ctx.globalAlpha, 1);
});

test('an area that several vehicles survey is drawn once', () => {
  const square = [[0, 0], [9, 0], [9, 9]];
  const setup = {vehicles: [{tasks: [{area: square}]}, {tasks: [{area: square}, {area: []}]}, null],
    coverage: [{width_m: 2, areas: [square, [[1, 1], [5, 1], [5, 5]]]}]};
  assert.equal(surveysOf(setup).length, 2);
  assert.deepEqual(surveysOf({}), []);
});
