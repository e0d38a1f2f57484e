// Asks the viewer again and again while the answer is shown; not in a hidden tab.

import {failureOf} from './requests.js';

export class Poller {
  /**
   * @param interval_ms  from one question to the next
   * @param ask  async; a RequestError is dropped: the page's top line shows lost connections
   * @param {() => string | null} key  names what would be asked: the same as before is not asked again; null: always ask
   */
  constructor(interval_ms, ask, key = () => null, now = () => performance.now()) {
    this.interval_ms = interval_ms;
    this.ask = ask;
    this.key = key;
    this.now = now;
    /** @type {string | null} */
    this.asked_key = null;
    this.asked_ms = -Infinity;
    this.asking = false;
    /** @type {ReturnType<typeof setInterval> | undefined} */
    this.timer = undefined;
  }

  start() {
    if (this.timer !== undefined) return;
    this.timer = setInterval(() => this.tick(), 50);
    this.tick();
  }

  stop() {
    clearInterval(this.timer);
    this.timer = undefined;
  }

  /** Asks soon, whatever was asked before. */
  renew() {
    this.asked_ms = -Infinity;
    /** @type {string | null} */
    this.asked_key = null;
    if (this.timer !== null) this.tick();
  }

  async tick() {
    const now_ms = this.now();
    if (globalThis.document?.hidden) return;
    if (this.asking || now_ms - this.asked_ms < this.interval_ms) return;
    const key = this.key();
    if (key !== null && key === this.asked_key) return;
    this.asking = true;
    this.asked_ms = now_ms;
    this.asked_key = key;
    try {
      await this.ask();
    } catch (error) {
      this.asked_key = null;
      if (failureOf(error).status === undefined) console.error(error);
    } finally {
      this.asking = false;
    }
  }
}
