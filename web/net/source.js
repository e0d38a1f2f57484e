// Where frames come from: a running mission or a recorded one. Neither draws anything.
//
// A live source:
//
//   connecting --first frame--> live --silence, end of stream--> lost --> connecting
//
// After each loss it asks /api/setup again; another `boot` means that everything is new.

import {failureOf} from './requests.js';
import {tidyFrame, tidySetup} from './answers.js';

const kSilence_ms = 2200;       // Frames come twice per second at least.
const kWatchEvery_ms = 250;
const kFirstBackoff_ms = 250;
const kLongestBackoff_ms = 2000;
const kSetupTimeout_ms = 2000;
const kRequestEvery_ms = 33;
const kStreamEnded = 'the stream ended';
const kBeginsAgain_s = 1;       // A time earlier by more than this is of another mission.

/** Is `frame` of another mission than `before`? Only /api/setup knows for sure. */
export function mayBeAnotherMission(before, frame) {
  if (!before) return false;
  const idle = ['waiting', 'ended', 'lost'];
  const was = before.clock?.state;
  const is = frame.clock?.state;
  return frame.t < before.t - kBeginsAgain_s || (idle.includes(was) && !idle.includes(is));
}

export class LiveSource {
  /**
   * @param setup     the one that the page began with
   * @param requests  get(path, query, timeout_ms)
   * @param listener  onFrame(frame), onSetup(setup) of another mission or viewer, onReconnected(),
   *                  onConnection('connecting' | 'live' | 'lost', reason)
   * @param openStream  as in requests.js
   */
  constructor(setup, requests, listener, openStream, now = () => performance.now()) {
    this.setup = setup;
    this.requests = requests;
    this.listener = listener;
    this.openStream = openStream;
    this.now = now;
    this.state = 'connecting';
    this.failures = 0;
    this.backoff_ms = kFirstBackoff_ms;
    this.frame = null;
  }

  start() {
    this.#listen();
    this.watcher = setInterval(() => this.watch(), kWatchEvery_ms);
  }

  stop() {
    clearInterval(this.watcher);
    clearTimeout(this.retry);
    this.#closeStream();
    this.stopped = true;
  }

  /** Counts silence as a lost connection; for a timer. */
  watch() {
    if (this.stream && this.now() - (this.received_ms ?? 0) > kSilence_ms) this.#lose('no news');
  }

  /** Mission time is not asked for: it is now. */
  query() {
    return {};
  }

  #listen() {
    this.received_ms = this.now();
    const stream = {};
    this.stream = stream;
    const token = this.requests.token;
    stream.close = this.openStream(this.requests.address('/api/stream', {token}), {
      onText: (text) => {
        if (this.stream === stream) this.#take(text);
      },
      onFailure: () => {
        if (this.stream === stream) this.#lose(kStreamEnded);
      },
    }, this.failures >= 2).close;
  }

  #take(text) {
    this.received_ms = this.now();
    let frame = null;
    try {
      frame = tidyFrame(JSON.parse(text));
    } catch {
      return;
    }
    if (!frame) return;
    const another = mayBeAnotherMission(this.frame, frame);
    this.frame = frame;
    this.failures = 0;
    this.backoff_ms = kFirstBackoff_ms;
    if (this.state !== 'live') this.#enter('live', '');
    this.listener.onFrame(frame);
    if (another) this.#askSetup().catch(() => {});
  }

  async #askSetup() {
    const setup = tidySetup(await this.requests.get('/api/setup', {}, kSetupTimeout_ms));
    if (this.stopped || setup.boot === this.setup.boot) return false;
    this.setup = setup;
    this.frame = null;
    this.listener.onSetup(setup);
    return true;
  }

  // A stream that ends may begin again at once: the viewer has turned to another mission, or to the
  // recording of this one. It is lost when that fails.
  #lose(reason) {
    this.#closeStream();
    this.failures += 1;
    if (reason === kStreamEnded && this.failures === 1 && this.state === 'live') {
      this.#reconnect();
      return;
    }
    this.#enter('lost', reason);
    this.#retryLater();
  }

  #retryLater() {
    clearTimeout(this.retry);
    this.retry = setTimeout(() => this.#reconnect(), this.backoff_ms);
    this.backoff_ms = Math.min(kLongestBackoff_ms, 2 * this.backoff_ms);
  }

  async #reconnect() {
    try {
      const isNew = await this.#askSetup();
      if (this.stopped) return;
      if (!isNew) this.listener.onReconnected();
      this.#listen();
    } catch (error) {
      if (this.stopped) return;
      this.#enter('lost', failureOf(error).message);
      this.#retryLater();
    }
  }

  #closeStream() {
    this.stream?.close?.();
    this.stream = null;
  }

  #enter(state, reason) {
    this.state = state;
    this.listener.onConnection(state, reason);
  }
}

/** The speeds of a recorded mission, mission seconds per second. */
export const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16, 32, 64];

const kGrave = ['collision', 'aground', 'all_stop', 'missed'];
const kNearer_s = 0.01;

export const isGrave = (event) => kGrave.includes(event.kind);

/**
 * Finds the next event after `t`, or with direction -1 the last before it.
 * @param events  in order of time @returns null where there is none
 */
export function neighbourEvent(events, t, direction, onlyGrave) {
  const wanted = events.filter((event) => Number.isFinite(event.t)
      && (!onlyGrave || isGrave(event))
      && (direction > 0 ? event.t > t + kNearer_s : event.t < t - kNearer_s));
  return (direction > 0 ? wanted[0] : wanted[wanted.length - 1]) ?? null;
}

/** A recorded mission: at most one request in flight, and the newest wish wins. */
export class RecordedSource {
  /** @param listener  onFrame(frame), onConnection(state, reason), onPlay(), onReconnected() */
  constructor(setup, requests, listener, now = () => performance.now()) {
    this.setup = setup;
    this.requests = requests;
    this.listener = listener;
    this.now = now;
    this.t = setup.begin_s;
    this.playing = false;
    this.speed = 1;
    this.frame = null;
    this.asking = false;
    this.got_t = null;
    this.asked_ms = -Infinity;
    this.ready_ms = -Infinity;
    this.state = 'connecting';
    this.backoff_ms = kFirstBackoff_ms;
  }

  start() {
    this.pump();
    if (Number.isFinite(this.setup.indexing)) this.awaiting = setInterval(() => this.askForAll(), 500);
  }

  /** Of a long log whose begin is shown: asks whether all of it has been read. */
  async askForAll() {
    try {
      const setup = tidySetup(await this.requests.get('/api/setup', {}, kSetupTimeout_ms));
      if (this.stopped) return;
      if (setup.boot !== this.setup.boot) {
        clearInterval(this.awaiting);
        this.listener.onSetup(setup);
      } else {
        this.listener.onIndexing(setup.indexing);
      }
    } catch {
      // pump() sees that the viewer is not there.
    }
  }

  stop() {
    this.stopped = true;
  }

  query() {
    return {t: this.t};
  }

  play() {
    if (this.t >= this.setup.end_s) this.t = this.setup.begin_s;
    this.playing = true;
    this.ticked_ms = this.now();
    this.listener.onPlay();
  }

  pause() {
    this.playing = false;
    this.listener.onPlay();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(t) {
    if (!Number.isFinite(t)) return;
    this.t = Math.min(this.setup.end_s, Math.max(this.setup.begin_s, t));
    this.pump();
  }

  /** Goes by one step of the mission. */
  step(direction) {
    this.pause();
    const step_s = this.setup.tick_s > 0 ? this.setup.tick_s : 0.1;
    this.seek(this.t + direction * step_s);
  }

  setSpeed(speed) {
    this.speed = kSpeeds.includes(speed) ? speed : 1;
    this.listener.onPlay();
  }

  faster(direction) {
    const place = kSpeeds.indexOf(this.speed) + direction;
    this.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, place))]);
  }

  /** Moves the time on; for every picture. */
  tick() {
    const now_ms = this.now();
    if (this.playing) {
      const t = this.t + this.speed * (now_ms - (this.ticked_ms ?? now_ms)) / 1000;
      this.ticked_ms = now_ms;
      this.t = Math.min(this.setup.end_s, t);
      if (this.t >= this.setup.end_s) this.pause();
    }
    this.pump();
  }

  /**
   * Asks for the frame at the present time, unless another one is on its way. Asks for one that it
   * has, too, now and then, to see whether the viewer is still there.
   */
  async pump() {
    const now_ms = this.now();
    const waited_ms = now_ms - this.asked_ms;
    if (this.stopped || this.asking || now_ms < this.ready_ms) return;
    if (waited_ms < (this.t === this.got_t ? kSilence_ms : kRequestEvery_ms)) return;
    this.asking = true;
    this.asked_ms = now_ms;
    const t = this.t;
    try {
      const frame = tidyFrame(await this.requests.get('/api/frame', {t}, kSilence_ms));
      if (this.stopped) return;
      this.got_t = t;
      this.backoff_ms = kFirstBackoff_ms;
      if (this.state === 'lost') await this.#greetAgain();
      this.#enter('live', '');
      if (frame) {
        this.frame = frame;
        this.listener.onFrame(frame);
        // The viewer has turned to a mission that runs.
        if (frame.clock.state && frame.clock.state !== 'recorded') await this.askForAll();
      }
    } catch (error) {
      this.ready_ms = this.now() + this.backoff_ms;
      this.backoff_ms = Math.min(kLongestBackoff_ms, 2 * this.backoff_ms);
      this.#enter('lost', failureOf(error).message);
    } finally {
      this.asking = false;
    }
  }

  async #greetAgain() {
    const setup = tidySetup(await this.requests.get('/api/setup', {}, kSetupTimeout_ms));
    if (setup.boot !== this.setup.boot) this.listener.onSetup(setup);
    else this.listener.onReconnected();
  }

  #enter(state, reason) {
    if (state === this.state && state !== 'lost') return;
    this.state = state;
    this.listener.onConnection(state, reason);
  }
}
