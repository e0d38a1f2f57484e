// The mission as the page knows it: the last frames, the trails, and the pulses and rings that are
// still to be seen.
//
//   const world = new World(setup);
//   world.addTrails(await (await fetch('/api/trails')).json());
//   source.onFrame = (frame) => world.addFrame(frame, performance.now());
//   const {t, vehicles} = world.at(performance.now());   // what to draw now
//
// Live, the page is one frame behind: it moves from the frame before the last to the last while it
// waits for the next. Recorded (setup.mode), frames come for any time, to and fro; setTime sets
// which time is shown.

import {clamp, finite, isNumber, mix, mixDegrees} from './geometry.js';
import {Trail} from './trail.js';

const kMaxVehicles = 1000;
const kMaxPulses = 4000;
const kMaxPackets = 400;
const kLeastTrailStep_s = 0.2;
// A gap of this much between frames is a break: the next frame is shown at once.
const kBreak_ms = 1500;
const kBreak_s = 10;
// No vehicle of ours is faster; one that is has been put elsewhere.
const kFastest_mps = 40;
const kFlash_s = 1.2;
const kLongestRing_s = 30;

/** Returns how opaque a pulse is at `t`: `fill` at first, fading linearly; 0 when it is over. */
export function pulseOpacity(pulse, t) {
  const duration = finite(pulse.duration);
  const age = Math.max(0, t - pulse.t);
  if (!(duration > 0) || !(age < duration)) return 0;
  return clamp(finite(pulse.fill, 0.35), 0, 1) * (1 - age / duration);
}

/**
 * Returns the kinds of transmissions that go over the acoustic network by `rules` of a frame: their
 * packets are seen as rings.
 */
export function acousticKinds(rules) {
  return [...(rules?.reports_over === 'acoustic' ? ['report'] : []),
    ...(rules?.messages_over === 'acoustic' ? ['message', 'ack'] : [])];
}

/** The entry of a frame between two others; `a` may be missing. */
function blend(shown, a, b, fraction, span_s) {
  Object.assign(shown, b);
  const nav = b.nav ?? b.report;
  shown.truth = b.nav != null;
  shown.x = finite(nav?.x, null);
  shown.y = finite(nav?.y, null);
  shown.depth = finite(nav?.depth, null);
  shown.heading = finite(nav?.heading, null);
  shown.speed = finite(nav?.speed, null);
  const before = b.nav ? a?.nav : a?.report;
  if (!before || shown.x === null || shown.y === null) return;
  if (!isNumber(before.x) || !isNumber(before.y)) return;
  const way_m = Math.hypot(shown.x - before.x, shown.y - before.y);
  if (!(way_m <= 5 + kFastest_mps * Math.abs(span_s))) return;
  shown.x = mix(before.x, shown.x, fraction);
  shown.y = mix(before.y, shown.y, fraction);
  if (isNumber(before.depth) && shown.depth !== null) {
    shown.depth = mix(before.depth, shown.depth, fraction);
  }
  if (isNumber(before.heading) && shown.heading !== null) {
    shown.heading = mixDegrees(before.heading, shown.heading, fraction);
  }
}

export class World {
  #setup;
  #recorded;
  /** @type {{frame: any, byName: Map<string, any>, arrived_ms: number} | null} */
  #last = null;
  /** @type {{frame: any, byName: Map<string, any>, arrived_ms: number} | null} null after a break. */
  #previous = null;
  #interval_ms = 67;
  /** @type {number | null} */
  #time_s = null;
  #trails = new Map();
  #pulses = new Map();
  #packets = new Map();
  /** @type {{t: number, vehicles: any[]}} */
  #shown = {t: 0, vehicles: []};
  #entries = new Map();

  constructor(setup) {
    this.#setup = setup ?? {};
    this.#recorded = ['recorded', 'planned'].includes(this.#setup.mode);
  }

  get setup() { return this.#setup; }
  /** The frame that came last, or null. */
  get frame() { return this.#last?.frame ?? null; }
  get rules() { return this.frame?.rules ?? null; }
  get recorded() { return this.#recorded; }
  /** Counts the trails' changes other than by their growth. */
  trailsVersion = 0;

  /** Takes a frame that came at `nowMs` of the wall clock. Returns false where it is none. */
  addFrame(frame, nowMs) {
    if (!isNumber(frame?.t) || !Array.isArray(frame.vehicles)) return false;
    const byName = new Map();
    for (const vehicle of frame.vehicles) {
      if (typeof vehicle?.name === 'string' && byName.size < kMaxVehicles) {
        byName.set(vehicle.name, vehicle);
      }
    }
    const before = this.#last;
    const gap_ms = before ? nowMs - before.arrived_ms : Infinity;
    const back = before !== null && frame.t < before.frame.t;
    if (!this.#recorded && back) this.#forgetAfter(frame.t);
    this.#previous = gap_ms < kBreak_ms && !(back && !this.#recorded) ? before : null;
    if (this.#previous && gap_ms > 0) {
      this.#interval_ms = clamp(mix(this.#interval_ms, gap_ms, 0.2), 16, 300);
    }
    this.#last = {frame, byName, arrived_ms: nowMs};
    this.#takePulses(frame);
    this.#takePackets(frame);
    if (!this.#recorded) this.#growTrails(frame.t, byName);
    return true;
  }

  /** Takes the answer of /api/trails. */
  addTrails(json) {
    for (const [name, points] of Object.entries(json?.trails ?? {})) {
      if (Array.isArray(points)) this.#trailOf(name)?.prepend(points);
    }
    ++this.trailsVersion;
  }

  /** Recorded missions: shows the mission as it was at `t`. */
  setTime(t) {
    if (isNumber(t)) this.#time_s = t;
  }

  /**
   * Returns {t, vehicles}: each vehicle's entry of the last frame with x, y, depth, heading and
   * speed as they are to be drawn (null where not known), `truth` false where they are reported
   * ones. The same objects come again at the next call.
   */
  at(nowMs) {
    const shown = this.#shown;
    if (!this.#last) return shown;
    const {a, b, fraction} = this.#recorded ? this.#framesAtTime(this.#last)
      : this.#framesAtWall(this.#last, nowMs);
    const span_s = a ? b.frame.t - a.frame.t : 0;
    shown.t = a ? a.frame.t + span_s * fraction : b.frame.t;
    shown.vehicles.length = 0;
    for (const [name, entry] of b.byName) {
      let vehicle = this.#entries.get(name);
      if (!vehicle) this.#entries.set(name, vehicle = {name});
      blend(vehicle, a?.byName.get(name), entry, fraction, span_s);
      shown.vehicles.push(vehicle);
    }
    if (this.#entries.size > b.byName.size + 100) this.#entries.clear();
    return shown;
  }

  /** Returns {t, x, y, count}: the points of a vehicle's trail that are not later than `t`. */
  trail(name, t) {
    const trail = this.#trails.get(name);
    if (!trail) return null;
    return {t: trail.t, x: trail.x, y: trail.y, count: trail.countUntil(t)};
  }

  /** Returns the pulses to be seen at `t`, each with its `opacity`. */
  pulses(t) {
    const seen = [];
    for (const [key, pulse] of this.#pulses) {
      pulse.opacity = this.#recorded && pulse.t > t ? 0 : pulseOpacity(pulse, t);
      if (pulse.opacity > 0) seen.push(pulse);
      else if (!this.#recorded) this.#pulses.delete(key);
    }
    return seen;
  }

  /**
   * Returns the acoustic packets to be seen at `t`: {x, y, kind, source, outer_m, inner_m, opacity,
   * flashes: [{name, cause, opacity}]}. A live viewer knows of a packet when it has arrived, so its
   * rings start then.
   */
  rings(t) {
    const rings = [];
    const sound_mps = this.#soundSpeed();
    for (const [key, packet] of this.#packets) {
      const age_s = t - packet.start_s;
      if (age_s > packet.reach_s + kFlash_s) {
        if (!this.#recorded) this.#packets.delete(key);
        continue;
      }
      if (age_s < 0) continue;
      const flashes = [];
      for (const {name, cause, delay_s} of packet.receivers) {
        const since_s = age_s - delay_s;
        if (since_s >= 0 && since_s < kFlash_s) {
          flashes.push({name, cause, opacity: 1 - since_s / kFlash_s});
        }
      }
      rings.push({
        x: packet.x, y: packet.y, kind: packet.kind, source: packet.source,
        outer_m: age_s * sound_mps,
        inner_m: Math.max(0, age_s - packet.air_s) * sound_mps,
        opacity: clamp(1 - 0.6 * age_s / packet.reach_s, 0, 1) * (age_s > packet.reach_s ? 0 : 1),
        flashes,
      });
    }
    return rings;
  }

  #soundSpeed() {
    const speed_mps = this.frame?.sound_mps;
    return speed_mps > 100 && speed_mps < 1e5 ? speed_mps : 1500;
  }

  #framesAtWall(b, nowMs) {
    return {a: this.#previous, b, fraction: clamp((nowMs - b.arrived_ms) / this.#interval_ms, 0, 1)};
  }

  // Runs on beyond the later frame by the time between the two at most.
  #framesAtTime(other) {
    const one = this.#previous;
    const span_s = one ? Math.abs(other.frame.t - one.frame.t) : 0;
    if (!one || !(span_s > 0 && span_s <= kBreak_s)) return {a: null, b: other, fraction: 1};
    const [a, b] = one.frame.t < other.frame.t ? [one, other] : [other, one];
    const fraction = ((this.#time_s ?? other.frame.t) - a.frame.t) / span_s;
    // The time is that of a frame that is still to come.
    if (!(Math.abs(fraction) < 1 + kBreak_s / span_s)) return {a: null, b: other, fraction: 1};
    return {a, b, fraction: clamp(fraction, 0, 2)};
  }

  #trailOf(name) {
    let trail = this.#trails.get(name);
    if (!trail && this.#trails.size < kMaxVehicles) this.#trails.set(name, trail = new Trail());
    return trail;
  }

  #growTrails(t, byName) {
    for (const [name, vehicle] of byName) {
      const place = vehicle.nav ?? vehicle.report;
      if (!place) continue;
      const trail = this.#trailOf(name);
      if (trail && t - trail.lastTime() >= kLeastTrailStep_s) trail.add(t, place.x, place.y);
    }
  }

  #forgetAfter(t) {
    for (const trail of this.#trails.values()) trail.cutAfter(t);
    this.#pulses.clear();
    this.#packets.clear();
    ++this.trailsVersion;
  }

  #takePulses(frame) {
    if (this.#recorded) this.#pulses.clear();
    for (const pulse of Array.isArray(frame.pulses) ? frame.pulses : []) {
      if (!isNumber(pulse?.t) || !Array.isArray(pulse.from) || !Array.isArray(pulse.to)) continue;
      // A pulse replaces the one of the same label.
      const key = pulse.label || `#${pulse.id}`;
      this.#pulses.delete(key);
      this.#pulses.set(key, {...pulse, opacity: 0});
      if (this.#pulses.size > kMaxPulses) this.#pulses.delete(this.#pulses.keys().next().value);
    }
  }

  #takePackets(frame) {
    if (this.#recorded) this.#packets.clear();
    for (const packet of Array.isArray(frame.packets) ? frame.packets : []) {
      const [x, y] = Array.isArray(packet?.from) ? packet.from : [];
      if (!isNumber(x) || !isNumber(y) || !isNumber(packet.sent)) continue;
      const receivers = (Array.isArray(packet.to) ? packet.to : [])
          .filter((to) => typeof to?.name === 'string' && isNumber(to.arrives))
          .map((to) => ({name: to.name, cause: to.cause,
            delay_s: clamp(to.arrives - packet.sent, 0, kLongestRing_s)}));
      const key = `${packet.source} ${packet.id}`;
      const reach_s = receivers.reduce((most, to) => Math.max(most, to.delay_s), 0.2);
      const known = this.#packets.get(key);
      if (known) {  // It has arrived elsewhere, too; its ring goes on.
        Object.assign(known, {receivers, reach_s});
        continue;
      }
      this.#packets.set(key, {
        x, y, source: packet.source, kind: packet.kind, receivers, reach_s,
        air_s: clamp(finite(packet.air), 0, kLongestRing_s),
        start_s: this.#recorded ? packet.sent : Math.max(packet.sent, frame.t),
      });
      if (this.#packets.size > kMaxPackets) {
        this.#packets.delete(this.#packets.keys().next().value);
      }
    }
  }
}
