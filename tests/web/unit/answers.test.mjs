import assert from 'node:assert/strict';
import {test} from 'node:test';

import {tidyEvents, tidyFrame, tidySetup, withoutMissingHelms} from '../../../web/net/answers.js';

const kNonsense = [null, undefined, 7, 'x', [], {}, NaN, {t: 'x', vehicles: []}, {t: 1}];

test('a frame without a time or vehicles is none', () => {
  for (const nonsense of kNonsense) assert.equal(tidyFrame(nonsense), null);
});

test('a frame has vehicles with names, each once, and at most a thousand', () => {
  const frame = tidyFrame({t: 1, vehicles: [null, {}, {name: 3}, {name: 'a', n: 1}, {name: 'a'}]});
  assert.deepEqual(frame.vehicles, [{name: 'a', n: 1}]);
  assert.deepEqual([frame.clock, frame.commands], [{}, []]);
  const many = Array.from({length: 5000}, (_, i) => ({name: `v${i}`}));
  assert.equal(tidyFrame({t: 1, vehicles: many}).vehicles.length, 1000);
});

test('a buoy or a station does not complain about the helm that it is not to have', () => {
  const setup = {vehicles: [{name: 'buoy', has_helm: false}, {name: 'alpha', has_helm: true}]};
  const vehicles = ['buoy', 'alpha'].map((name) => ({name, mode: 'NOHELM-EVER'}));
  assert.deepEqual(withoutMissingHelms(vehicles, setup).map(({mode}) => mode), ['', 'NOHELM-EVER']);
});

test('a good frame stays as it is', () => {
  const frame = {t: 1, vehicles: [{name: 'a'}], clock: {state: 'running'}, commands: [{id: 1}]};
  assert.deepEqual(tidyFrame(frame), frame);
});

test('a setup has vehicles, notes and a time line that does not go backward', () => {
  for (const nonsense of kNonsense) {
    const {vehicles, notes, begin_s, end_s} = tidySetup(nonsense);
    assert.deepEqual([vehicles, notes, begin_s, end_s], [[], [], 0, 0]);
  }
  assert.equal(tidySetup({begin_s: 5, end_s: 1}).end_s, 5);
  assert.deepEqual(tidySetup({notes: ['x', {}]}).notes, ['x']);
  assert.deepEqual(tidySetup({protocol: 2, notes: ['x']}).notes, ['x']);
  assert.match(tidySetup({protocol: 3, notes: ['x']}).notes[0], /protocol 3, this page 2: reload/);
});

test('events come in order of time, without those that have none', () => {
  const events = tidyEvents({events: [{t: 5, kind: 'b'}, {t: null, kind: 'x'}, null,
    {t: 1, kind: 'a', vehicles: null}, {t: 2}]});
  assert.deepEqual(events, [{t: 1, kind: 'a', vehicles: []}, {t: 5, kind: 'b', vehicles: []}]);
  for (const nonsense of kNonsense) assert.deepEqual(tidyEvents(nonsense), []);
});
