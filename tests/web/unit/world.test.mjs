import assert from 'node:assert/strict';
import {test} from 'node:test';

import {Trail} from '../../../web/map/trail.js';
import {World, acousticKinds, pulseOpacity} from '../../../web/map/world.js';

const near = (actual, expected, tolerance = 1e-6) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`);

function frameAt(t, nav, more = {}) {
  return {t, vehicles: [{name: 'alpha', nav: nav && {t, depth: 0, speed: 1, ...nav}}], ...more};
}

const only = (world, nowMs) => world.at(nowMs).vehicles[0];

test('a vehicle moves from frame to frame, and never beyond the last', () => {
  const world = new World({mode: 'live'});
  world.addFrame(frameAt(0, {x: 0, y: 0, heading: 350}), 1000);
  world.addFrame(frameAt(1, {x: 10, y: -20, heading: 10}), 1067);
  near(only(world, 1067).x, 0);
  const halfway = only(world, 1067 + 33.5);
  near(halfway.x, 5, 0.01);
  near(halfway.y, -10, 0.01);
  near((halfway.heading + 180) % 360, 180, 0.1);
  near(world.at(1067 + 33.5).t, 0.5, 0.01);
  near(only(world, 99999).x, 10);
  near(world.at(99999).t, 1);
});

test('after a pause of the stream the next frame is shown at once', () => {
  const world = new World({mode: 'live'});
  world.addFrame(frameAt(0, {x: 0, y: 0, heading: 0}), 1000);
  world.addFrame(frameAt(5, {x: 10, y: 0, heading: 0}), 6000);
  near(only(world, 6000).x, 10);
});

test('a vehicle that was put elsewhere does not fly there', () => {
  const world = new World({mode: 'live'});
  world.addFrame(frameAt(0, {x: 0, y: 0, heading: 0}), 1000);
  world.addFrame(frameAt(0.1, {x: 500, y: 0, heading: 0}), 1067);
  near(only(world, 1080).x, 500);
});

test('a vehicle without truth is where it was reported, one without either is nowhere', () => {
  const world = new World({mode: 'live'});
  world.addFrame({t: 1, vehicles: [{name: 'a', nav: null, report: {t: 0, x: 3, y: 4}},
    {name: 'b', nav: null, report: null}]}, 0);
  const [a, b] = world.at(0).vehicles;
  assert.deepEqual([a.truth, a.x, a.y, a.heading], [false, 3, 4, null]);
  assert.equal(b.x, null);
});

test('a recorded mission is shown at the time that is set, between its frames', () => {
  const world = new World({mode: 'recorded'});
  world.addFrame(frameAt(100, {x: 0, y: 0, heading: 0}), 0);
  world.addFrame(frameAt(101, {x: 2, y: 0, heading: 0}), 50);
  world.setTime(100.5);
  near(only(world, 0).x, 1);
  world.setTime(101.5);
  near(only(world, 0).x, 3);
  world.setTime(104);
  near(only(world, 0).x, 4, 1e-6);
  world.setTime(900);
  near(only(world, 0).x, 2);
  // Back again: the frames come in the other order.
  world.addFrame(frameAt(100.5, {x: 1, y: 0, heading: 0}), 100);
  world.setTime(100.75);
  near(only(world, 0).x, 1.5);
  world.addFrame(frameAt(3, {x: -50, y: 7, heading: 0}), 150);
  world.setTime(3);
  near(only(world, 0).x, -50);
  near(world.at(0).t, 3);
});

test('trails end at the time that is shown', () => {
  const world = new World({mode: 'recorded'});
  world.addTrails({trails: {alpha: [[0, 0, 0], [10, 1, 0], [20, 2, 0]]}});
  assert.equal(world.trail('alpha', 15).count, 2);
  assert.equal(world.trail('alpha', -1).count, 0);
  assert.equal(world.trail('alpha', 1e9).count, 3);
  assert.equal(world.trail('unknown', 1), null);
  world.addFrame(frameAt(500, {x: 9, y: 9, heading: 0}), 0);
  assert.equal(world.trail('alpha', 1e9).count, 3, 'frames of a recorded mission add nothing');
});

test('a live trail goes on where the answer of the viewer ends', () => {
  const world = new World({mode: 'live'});
  world.addFrame(frameAt(19.9, {x: 5, y: 0, heading: 0}), 0);
  world.addFrame(frameAt(21, {x: 6, y: 0, heading: 0}), 67);
  world.addTrails({trails: {alpha: [[0, 0, 0], [20, 5, 0]]}});
  const trail = world.trail('alpha', 100);
  assert.deepEqual([...trail.t.slice(0, trail.count)], [0, 20, 21]);
  assert.deepEqual([...trail.x.slice(0, trail.count)], [0, 5, 6]);
});

test('when a mission starts again its trails and pulses do too', () => {
  const world = new World({mode: 'live'});
  const pulses = [{id: 1, t: 50, from: [0, 0], to: [1, 1], duration: 1e6, fill: 1}];
  world.addFrame(frameAt(50, {x: 0, y: 0, heading: 0}, {pulses}), 0);
  assert.equal(world.pulses(50).length, 1);
  world.addFrame(frameAt(1, {x: 1, y: 0, heading: 0}), 67);
  assert.equal(world.trail('alpha', 1e9).t[0], 1);
  assert.equal(world.pulses(1).length, 0);
  near(only(world, 70).x, 1);
});

test('a trail takes no more room than its bound, and keeps beginning and end', () => {
  const trail = new Trail();
  for (let t = 0; t < 100000; ++t) trail.add(t, t, -t);
  assert.ok(trail.count <= 4096 && trail.count > 2000);
  assert.equal(trail.t.length, 4096);
  assert.equal(trail.t[0], 0);
  assert.equal(trail.t[trail.count - 1], 99999);
  for (let i = 1; i < trail.count; ++i) assert.ok(trail.t[i] > trail.t[i - 1]);
  for (let i = 0; i < trail.count; ++i) assert.equal(trail.x[i], trail.t[i]);
});

test('a pulse fades linearly from its fill to nothing', () => {
  const pulse = {t: 10, duration: 10, fill: 0.6};
  near(pulseOpacity(pulse, 10), 0.6);
  near(pulseOpacity(pulse, 15), 0.3);
  near(pulseOpacity(pulse, 19), 0.06);
  assert.equal(pulseOpacity(pulse, 20), 0);
  assert.equal(pulseOpacity({...pulse, duration: NaN}, 12), 0);
  near(pulseOpacity({...pulse, fill: 7}, 10), 1);
});

test('a pulse replaces the one of the same label', () => {
  const world = new World({mode: 'live'});
  const pulse = (id, t, label) => ({id, t, label, from: [0, 0], to: [9, 9], duration: 10, fill: 1});
  world.addFrame(frameAt(1, null, {pulses: [pulse(1, 1, 'A2B'), pulse(2, 1, 'A2B_MSG')]}), 0);
  world.addFrame(frameAt(2, null, {pulses: [pulse(3, 2, 'A2B')]}), 67);
  assert.deepEqual(world.pulses(2).map(({id}) => id).sort(), [2, 3]);
  assert.equal(world.pulses(30).length, 0);
});

test('of a recorded mission exactly the pulses of the frame are to be seen', () => {
  const world = new World({mode: 'recorded'});
  const pulses = [{id: 1, t: 8, from: [0, 0], to: [9, 9], duration: 10, fill: 1}];
  world.addFrame(frameAt(10, null, {pulses}), 0);
  assert.equal(world.pulses(10).length, 1);
  assert.equal(world.pulses(7).length, 0, 'it has not begun');
  world.addFrame(frameAt(5, null, {pulses: []}), 67);
  assert.equal(world.pulses(10).length, 0);
});

const kPacket = {id: 7, source: 'alpha', from: [0, 0], sent: 10, air: 0.4, kind: 'packet',
  to: [{name: 'bravo', arrives: 11, cause: 'delivered'},
    {name: 'charlie', arrives: 12, cause: 'collision'}]};

test('a ring grows with the sound and each receiver flashes when it arrives', () => {
  const world = new World({mode: 'recorded'});
  world.addFrame(frameAt(10, null, {packets: [kPacket], sound_mps: 1400}), 0);
  assert.equal(world.rings(9.9).length, 0);
  const [ring] = world.rings(10.5);
  near(ring.outer_m, 700);
  near(ring.inner_m, 140);
  assert.deepEqual(ring.flashes, []);
  assert.deepEqual(world.rings(11.1)[0].flashes.map(({name}) => name), ['bravo']);
  assert.deepEqual(world.rings(12.1)[0].flashes.map(({cause}) => cause),
                   ['delivered', 'collision']);
  assert.equal(world.rings(14).length, 0);
});

test('a live ring begins when the viewer knows of it', () => {
  const world = new World({mode: 'live'});
  world.addFrame(frameAt(12, null, {packets: [kPacket], sound_mps: 1500}), 0);
  near(world.rings(12)[0].outer_m, 0);
  near(world.rings(12.5)[0].outer_m, 750);
});

test('a live ring goes on to receivers that are added later', () => {
  const world = new World({mode: 'live'});
  const early = {...kPacket, to: kPacket.to.slice(0, 1)};
  world.addFrame(frameAt(11, null, {packets: [early], sound_mps: 1500}), 0);
  near(world.rings(11.5)[0].outer_m, 750);
  world.addFrame(frameAt(12, null, {packets: [kPacket], sound_mps: 1500}), 67);
  near(world.rings(12.5)[0].outer_m, 2250);
  assert.ok(world.rings(12.5)[0].opacity > 0, 'it has not reached charlie yet');
  assert.deepEqual(world.rings(13.1)[0].flashes.map(({name}) => name), ['bravo', 'charlie']);
});

test('what comes damaged changes nothing and breaks nothing', () => {
  const world = new World(null);
  for (const frame of [null, {}, {t: NaN, vehicles: []}, {t: 1}, 'x', {t: 1, vehicles: 'all'}]) {
    assert.equal(world.addFrame(frame, 0), false);
  }
  assert.deepEqual(world.at(0).vehicles, []);
  world.addTrails(null);
  world.addTrails({trails: {alpha: 'x', bravo: [null, [1], ['a', 2, 3], [NaN, 1, 1]]}});
  assert.ok(world.addFrame({t: 1, vehicles: [null, {}, {name: 7}, {name: 'a', nav: {x: 'q', y: {}}},
    {name: '__proto__', nav: {x: 1, y: 1e308}}], pulses: [null, {}, {t: 1}, {t: 1, from: 1, to: 2}],
  packets: [null, {}, {from: [0, 0], sent: 1}, {from: [0, 0], sent: 1, to: [null, {}]}],
  sound_mps: -1, rules: null}, 0));
  world.setTime(NaN);
  assert.equal(world.at(10).vehicles.length, 2);
  assert.equal(world.at(10).vehicles[0].x, null);
  world.pulses(1);
  world.rings(1);
});

test('whatever comes, a bounded number of things is kept', () => {
  const world = new World({mode: 'live'});
  for (let k = 0; k < 40; ++k) {
    world.addFrame({t: k, vehicles: Array.from({length: 200}, (_, i) =>
      ({name: `v${k}_${i}`, nav: {t: k, x: 0, y: 0}})), pulses: Array.from({length: 200}, (_, i) =>
      ({id: 1000 * k + i, t: k, from: [0, 0], to: [1, 1], duration: 1e9, fill: 1}))}, 67 * k);
    world.at(67 * k);
  }
  assert.ok(world.pulses(40).length <= 4000);
  assert.equal(world.trail('v39_199', 100), null, 'there is room for a thousand trails');
  assert.equal(world.at(1e6).vehicles.length, 200);
});

test('what goes over the acoustic network by the rules is to be seen as rings', () => {
  const rules = (reports_over, messages_over) => ({reports_over, messages_over});
  assert.deepEqual(acousticKinds(rules('direct', 'direct')), []);
  assert.deepEqual(acousticKinds(rules('acoustic', 'direct')), ['report']);
  assert.deepEqual(acousticKinds(rules('acoustic', 'acoustic')), ['report', 'message', 'ack']);
  assert.deepEqual(acousticKinds(null), []);
});
