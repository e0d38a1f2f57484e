import assert from 'node:assert/strict';
import test from 'node:test';

import {applyChange, PageRecording, Spans, States} from '../../../web/net/page_recording.js';

test('a change makes a state of the one before it and shares the rest', () => {
  const before = {a: {b: 1}, list: [{x: 1}, {x: 2}], gone: 1};
  const after = applyChange(before, {list: {1: {x: [3]}, 2: [{x: 4}]}, gone: 0, come: [[5]]});
  assert.deepEqual(after, {a: {b: 1}, list: [{x: 1}, {x: 3}, {x: 4}], come: [5]});
  assert.equal(after.a, before.a);
  assert.equal(after.list[0], before.list[0]);
  assert.deepEqual(before.list, [{x: 1}, {x: 2}]);
  assert.equal(applyChange(before, 0), before);
});

test('a member of any name sets no prototype', () => {
  const after = applyChange({}, JSON.parse('{"__proto__": [{"evil": 1}], "a": [1]}'));
  assert.equal(after.evil, undefined);
  assert.equal({}.evil, undefined);
  assert.equal(after.a, 1);
});

test('states come in any order', () => {
  const changes = [{n: 0}, ...Array.from({length: 199}, (_, i) => ({n: [i + 1]}))];
  const states = new States(changes);
  for (const place of [150, 3, 3, 199, 64, 63, 65, 0, 500]) {
    assert.equal(states.at(place).n, Math.min(place, 199), `place ${place}`);
  }
  assert.equal(states.at(-1), null);
  assert.equal(new States(null).at(0), null);
});

test('what lasts a while is seen from its begin to its end, whatever its order', () => {
  const spans = new Spans([{t: 5, duration: 1}, {t: 0, duration: 20}, {t: 3, duration: 1}],
    ({t}) => t, ({t, duration}) => t + duration);
  assert.deepEqual(spans.at(3.5).map(({t}) => t), [0, 3]);
  assert.deepEqual(spans.at(5).map(({t}) => t), [0, 5]);
  assert.deepEqual(spans.at(4).map(({t}) => t), [0]);
  assert.deepEqual(spans.at(20), []);
  assert.deepEqual(new Spans(undefined, Number, Number).at(1), []);
});

const vehicleAt = (x, heading) => ({name: 'alpha', nav: {t: 0, x, y: 0, heading, speed: 2, depth: 0},
  desired: {heading: 90, speed: 2, depth: null}});
const kRecording = {
  setup: {causes: [{key: 'delivered', outcome: 'whole'}, {key: 'too_soon', outcome: 'stopped'}]},
  begin_s: 0, end_s: 2.5,
  frames: {step_s: 1, states: [{t: 0, vehicles: [vehicleAt(0, 350)]},
    {vehicles: {0: {nav: {x: [10], heading: [10]}}}}, 0, {vehicles: {0: {nav: {x: [15]}}}}]},
  links: {step_s: 1, states: [{links: []}, {links: [[{from: 'bravo', to: 'alpha', last_received_s: 1}]]}]},
  pulses: [{id: 1, t: 1, duration: 1}], packets: [], media: [], swarms: {step_s: 5, of: []},
  fates: [[1, 0.5, 'report', 'alpha', 'bravo', 1, 1, 'delivered', '', 'a', 20, 250, null],
    [2, 1.5, 'report', 'alpha', 'bravo', 3, 2, 'too_soon', '', 'b', null, null, 'vhf']],
};
const ask = (path, query) => new PageRecording(structuredClone(kRecording)).get(path, query);

test('a frame between two is blended, its heading by the shorter way', async () => {
  const {t, vehicles: [{nav}], pulses} = await ask('/api/frame', {t: 0.5});
  assert.deepEqual([t, nav.x, nav.heading, pulses.length], [0.5, 5, 0, 0]);
  assert.equal((await ask('/api/frame', {t: 1})).pulses.length, 1);
  assert.equal((await ask('/api/frame', {t: 2.25})).vehicles[0].nav.x, 12.5, 'of the last half step');
  assert.equal((await ask('/api/frame', {t: 99})).vehicles[0].nav.x, 15);
});

test('fates and links are those until the time', async () => {
  assert.deepEqual((await ask('/api/fates', {t: 1})).fates.map(({id}) => id), [1]);
  assert.deepEqual((await ask('/api/fates', {})).fates.map(({id}) => id), [2, 1]);
  assert.deepEqual((await ask('/api/fates', {blocked: 1})).fates.map(({id}) => id), [2]);
  assert.deepEqual((await ask('/api/fates', {after: 1})).fates.map(({medium}) => medium), ['vhf']);
  const link = await ask('/api/link', {from: 'alpha', to: 'bravo'});
  assert.deepEqual(link.causes, {delivered: 1, too_soon: 3});
  assert.deepEqual(link.by_kind, {report: {delivered: 1, offered: 4}});
  assert.deepEqual(link.range, {t: [0.5], range_m: [20], limit_m: [250]});
});

test('a vehicle has columns of its frames', async () => {
  const {t, desired_heading: desired, depth} = await ask('/api/vehicle', {name: 'alpha', window: 2});
  assert.deepEqual([t, desired, depth], [[1, 2, 2.5], [90, 90, 90], [0, 0, 0]]);
  await assert.rejects(ask('/api/vehicle', {name: 'zulu'}), {status: 404});
  await assert.rejects(ask('/api/status'), {status: 404});
});
