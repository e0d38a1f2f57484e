// Where one vehicle was: times and positions in order of time, in bounded memory.

import {isNumber} from './geometry.js';

const kMaxPoints = 4096;

export class Trail {
  count = 0;
  t = new Float64Array(256);
  x = new Float32Array(256);
  y = new Float32Array(256);

  /** Appends a point. One that is not later than the last is ignored. */
  add(t, x, y) {
    if (!isNumber(t) || !isNumber(x) || !isNumber(y)) return;
    if (this.count > 0 && t <= this.t[this.count - 1]) return;
    if (this.count === kMaxPoints) this.#thin();
    if (this.count === this.t.length) this.#grow();
    this.t[this.count] = t;
    this.x[this.count] = x;
    this.y[this.count] = y;
    ++this.count;
  }

  /** Replaces all up to the last of `points` ([t, x, y] each), keeps what is later. */
  prepend(points) {
    const old = {t: this.t.slice(0, this.count), x: this.x, y: this.y};
    this.count = 0;
    this.x = this.x.slice();
    this.y = this.y.slice();
    for (const point of points) {
      if (Array.isArray(point)) this.add(point[0], point[1], point[2]);
    }
    old.t.forEach((t, i) => this.add(t, old.x[i], old.y[i]));
  }

  /** Forgets what is later than `t`. */
  cutAfter(t) {
    this.count = this.countUntil(t);
  }

  /** Returns how many points are not later than `t`. */
  countUntil(t) {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.t[middle] <= t) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  lastTime() {
    return this.count > 0 ? this.t[this.count - 1] : -Infinity;
  }

  #grow() {
    for (const key of ['t', 'x', 'y']) {
      const longer = new this[key].constructor(2 * this[key].length);
      longer.set(this[key]);
      this[key] = longer;
    }
  }

  // Drops every second point of the older three quarters.
  #thin() {
    const old = (this.count * 3) >> 2;
    let to = 0;
    for (let from = 0; from < this.count; ++from) {
      if (from < old && from % 2 === 1) continue;
      this.t[to] = this.t[from];
      this.x[to] = this.x[from];
      this.y[to] = this.y[from];
      ++to;
    }
    this.count = to;
  }
}
