import assert from 'node:assert/strict';
import {test} from 'node:test';

import {Poller} from '../../../web/net/poller.js';
import {kSpeeds, LiveSource, mayBeAnotherMission, neighbourEvent, RecordedSource}
  from '../../../web/net/source.js';

const settle = () => new Promise((done) => { setImmediate(done); });
const frameAt = (t, state = 'running') => ({t, clock: {state}, vehicles: []});

/** A viewer whose stream and answers the test holds in its hand. */
function fakeViewer(boot = 'one') {
  const viewer = {boot, now_ms: 0, streams: [], asked: [], isDown: false, token: 'k',
    address: (path, query) => `${path}?token=${query.token}`};
  viewer.get = async (path) => {
    viewer.asked.push(path);
    if (viewer.isDown) throw Object.assign(new Error('the viewer does not answer'), {status: 0});
    return {mode: 'live', boot: viewer.boot};
  };
  viewer.openStream = (address, listener, alone) => {
    const stream = {address, alone, isOpen: true, ...listener};
    stream.close = () => { stream.isOpen = false; };
    viewer.streams.push(stream);
    return stream;
  };
  return viewer;
}

// Debian 12's Node.js 18 mocks timers in another way, and not all of them.
const skip = Number(process.versions.node.split('.')[0]) < 20 && 'needs Node.js 20';

function listen(viewer, timers) {
  const received = {frames: [], setups: [], states: [], reconnected: 0};
  const source = new LiveSource({mode: 'live', boot: viewer.boot}, viewer, {
    onFrame: (frame) => received.frames.push(frame.t),
    onSetup: (setup) => received.setups.push(setup.boot),
    onReconnected: () => { received.reconnected += 1; },
    onConnection: (state) => received.states.push(state),
  }, viewer.openStream, () => viewer.now_ms);
  source.start();
  timers.after(() => source.stop());
  return {source, received};
}

test('a live source is connected with its first frame, and asks with its token', {skip}, (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  assert.equal(viewer.streams[0].address, '/api/stream?token=k');
  viewer.streams[0].onText(JSON.stringify(frameAt(1)));
  assert.deepEqual([received.frames, received.states], [[1], ['live']]);
});

test('frames that are none are passed over', {skip}, (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  for (const text of ['', '{', 'null', '7', '{"t": null}', '{"t": 1}', '{"t": 1, "vehicles": 3}']) {
    viewer.streams[0].onText(text);
  }
  assert.deepEqual(received.frames, []);
});

test('silence shows within three seconds, and the page comes back by itself', {skip}, async (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  viewer.streams[0].onText(JSON.stringify(frameAt(1)));
  viewer.now_ms = 3000;
  timers.mock.timers.tick(250);
  assert.equal(received.states.at(-1), 'lost');
  assert.equal(viewer.streams[0].isOpen, false);
  timers.mock.timers.tick(250);
  await settle();
  assert.equal(viewer.streams.length, 2);
  assert.equal(received.reconnected, 1);
  viewer.streams[1].onText(JSON.stringify(frameAt(4)));
  assert.equal(received.states.at(-1), 'live');
  viewer.streams[0].onText(JSON.stringify(frameAt(2)));
  assert.deepEqual(received.frames, [1, 4]);
});

test('a stream that ends and begins again shows no lost connection', {skip}, async (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  viewer.streams[0].onText(JSON.stringify(frameAt(1)));
  viewer.streams[0].onFailure();
  await settle();
  assert.equal(viewer.streams.length, 2);
  viewer.streams[1].onText(JSON.stringify(frameAt(2)));
  assert.deepEqual(received.states, ['live']);
  viewer.isDown = true;
  viewer.streams[1].onFailure();
  await settle();
  assert.equal(received.states.at(-1), 'lost', 'where it does not begin again it is lost');
});

test('a viewer that was started again is asked everything again', {skip}, async (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  viewer.streams[0].onFailure();
  viewer.boot = 'two';
  timers.mock.timers.tick(250);
  await settle();
  assert.deepEqual(received.setups, ['two']);
  assert.equal(received.reconnected, 0);
});

test('a viewer that stays away is asked every two seconds at least', {skip}, async (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  viewer.isDown = true;
  viewer.streams[0].onFailure();
  for (let i = 0; i < 200; ++i) {
    timers.mock.timers.tick(100);
    await settle();
  }
  assert.ok(viewer.asked.length >= 10 && viewer.asked.length <= 14, `${viewer.asked.length}`);
  viewer.isDown = false;
  timers.mock.timers.tick(2000);
  await settle();
  viewer.streams.at(-1).onText(JSON.stringify(frameAt(9)));
  assert.equal(received.states.at(-1), 'live');
});

test('a stream that failed twice is opened without the shared worker', {skip}, async (timers) => {
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  listen(viewer, timers);
  for (let i = 0; i < 2; ++i) {
    viewer.streams.at(-1).onFailure();
    timers.mock.timers.tick(1000);
    await settle();
  }
  assert.deepEqual(viewer.streams.map(({alone}) => alone), [false, false, true]);
});

test('a time that goes back or a clock that wakes may be another mission', {skip}, async (timers) => {
  assert.equal(mayBeAnotherMission(null, frameAt(1)), false);
  assert.equal(mayBeAnotherMission(frameAt(100), frameAt(0)), true);
  assert.equal(mayBeAnotherMission(frameAt(100), frameAt(99.9)), false);
  assert.equal(mayBeAnotherMission(frameAt(0, 'waiting'), frameAt(0, 'gathering')), true);
  assert.equal(mayBeAnotherMission(frameAt(9, 'ended'), frameAt(9, 'ended')), false);
  assert.equal(mayBeAnotherMission(frameAt(9, 'paused'), frameAt(9, 'running')), false);
  timers.mock.timers.enable({apis: ['setTimeout', 'setInterval']});
  const viewer = fakeViewer();
  const {received} = listen(viewer, timers);
  viewer.boot = 'two';
  viewer.streams[0].onText(JSON.stringify(frameAt(100)));
  viewer.streams[0].onText(JSON.stringify(frameAt(0)));
  await settle();
  assert.deepEqual(received.setups, ['two']);
});

const kSetup = {mode: 'recorded', boot: 'one', begin_s: 0, end_s: 100, tick_s: 0.1};

/** A recorded source whose answers come when the test lets them. */
function recorded() {
  const held = {now_ms: 0, waiting: [], frames: [], states: []};
  const source = new RecordedSource(kSetup, {
    get: (path, query) => new Promise((resolve, reject) => {
      held.waiting.push({t: query?.t, path, resolve, reject});
    }),
  }, {
    onFrame: (frame) => held.frames.push(frame.t), onPlay: () => {}, onReconnected: () => {},
    onConnection: (state) => held.states.push(state),
  }, () => held.now_ms);
  held.answer = async () => {
    const {t, resolve} = held.waiting.pop();
    resolve(frameAt(t, 'recorded'));
    await settle();
  };
  return {source, held};
}

test('of a long log it asks whether all of it has been read, and starts again then', async () => {
  const taken = [];
  const answers = [{...kSetup, indexing: 0.5}, new Error('busy'), {...kSetup, boot: 'two'}];
  const source = new RecordedSource({...kSetup, indexing: 0.1}, {
    get: async (path) => {
      assert.equal(path, '/api/setup');
      const answer = answers.shift();
      if (answer instanceof Error) throw answer;
      return answer;
    },
  }, {onIndexing: (share) => taken.push(share), onSetup: ({boot}) => taken.push(boot)});
  await source.askForAll();
  await source.askForAll();
  await source.askForAll();
  assert.deepEqual(taken, [0.5, 'two']);
});

test('scrubbing has one request in flight, and the newest wish wins', async () => {
  const {source, held} = recorded();
  source.start();
  for (const t of [10, 20, 30]) source.seek(t);
  assert.deepEqual(held.waiting.map(({t}) => t), [0]);
  await held.answer();
  held.now_ms = 100;
  source.tick();
  assert.deepEqual(held.waiting.map(({t}) => t), [30]);
  await held.answer();
  assert.deepEqual(held.frames, [0, 30]);
  held.now_ms = 200;
  source.tick();
  assert.equal(held.waiting.length, 0);
});

test('times beyond the log are those of its ends, and nonsense is none', () => {
  const {source} = recorded();
  source.seek(1e9);
  assert.equal(source.t, 100);
  source.seek(-5);
  assert.equal(source.t, 0);
  source.seek(NaN);
  assert.equal(source.t, 0);
});

test('playing goes as fast as asked for, stops at the end and begins again there', () => {
  const {source, held} = recorded();
  source.setSpeed(4);
  source.play();
  held.now_ms = 500;
  source.tick();
  assert.equal(source.t, 2);
  held.now_ms = 1e6;
  source.tick();
  assert.deepEqual([source.t, source.playing], [100, false]);
  source.play();
  assert.deepEqual([source.t, source.playing], [0, true]);
});

test('speeds stay on their ladder', () => {
  const {source} = recorded();
  for (let i = 0; i < 20; ++i) source.faster(1);
  assert.equal(source.speed, kSpeeds.at(-1));
  for (let i = 0; i < 20; ++i) source.faster(-1);
  assert.equal(source.speed, 0.25);
  source.setSpeed(1e9);
  assert.equal(source.speed, 1);
});

test('a step is one of the mission and ends playing', () => {
  const {source} = recorded();
  source.play();
  source.step(1);
  assert.deepEqual([source.t, source.playing], [0.1, false]);
});

test('a viewer of a log that does not answer is lost, and asked again', async () => {
  const {source, held} = recorded();
  source.start();
  held.waiting.pop().reject(new Error('gone'));
  await settle();
  assert.equal(held.states.at(-1), 'lost');
  source.tick();
  assert.equal(held.waiting.length, 0);
  held.now_ms = 1000;
  source.tick();
  assert.equal(held.waiting.length, 1);
});

test('a log that rests is asked for now and then, so that its loss is seen', async () => {
  const {source, held} = recorded();
  source.start();
  await held.answer();
  held.now_ms = 2600;
  source.tick();
  assert.equal(held.waiting.length, 1);
});

test('the next event is the nearest beyond the present time, grave or of any kind', () => {
  const events = [{t: 5, kind: 'first_contact'}, {t: 10, kind: 'collision'},
    {t: 10, kind: 'lost_contact'}, {t: 20, kind: 'all_stop'}, {t: NaN, kind: 'collision'}];
  assert.equal(neighbourEvent(events, 5, 1, false), events[1]);
  assert.equal(neighbourEvent(events, 10, 1, false), events[3]);
  assert.equal(neighbourEvent(events, 10, -1, false), events[0]);
  assert.equal(neighbourEvent(events, 20, -1, true), events[1]);
  assert.equal(neighbourEvent(events, 20, 1, false), null);
  assert.equal(neighbourEvent([], 0, 1, false), null);
});

test('a hidden page asks nothing again', async () => {
  let asked = 0;
  const poller = new Poller(100, async () => { asked += 1; }, () => null, () => 1000 * asked + 1e6);
  globalThis.document = {hidden: true};
  try {
    await poller.tick();
    assert.equal(asked, 0);
    globalThis.document.hidden = false;
    await poller.tick();
    assert.equal(asked, 1);
  } finally {
    delete globalThis.document;
  }
});
