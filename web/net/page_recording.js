// A recorded mission that lies in the page itself (lib/tools/view/page_recording.h): answers what a
// viewer would (docs/extending/viewer_protocol.md), without one.

import {PageChannels} from './page_channels.js';
import {RequestError} from './requests.js';

const kCheckpointEvery = 32;
const kMaxPoints = 600;       // Of a chart.
const kMaxBins = 120;
const kLinkFates = 50;
const kLinkRanges = 300;
const kBlended = ['x', 'y', 'depth', 'speed', 'sog', 'pitch', 'roll', 'altitude'];
const kHeadings = ['heading', 'course'];

/**
 * Makes a state of the one before it. What did not change is shared between the two.
 * @param change  0: nothing; [value] in its place; else what changed of its members, 0 for one that
 *                is gone
 */
export function applyChange(before, change) {
  if (change === 0) return before;
  if (Array.isArray(change)) return change[0];
  const after = Array.isArray(before) ? before.slice() : {...before};
  for (const [key, part] of Object.entries(change)) {
    // It would set the prototype instead of a member.
    if (key === '__proto__') continue;
    if (part === 0) delete after[key];
    else after[key] = applyChange(after[key], part);
  }
  return after;
}

/** The states of something at equal steps, kept as changes. */
export class States {
  /** @param changes  the first state, then one change for each further one */
  constructor(changes) {
    this.changes = Array.isArray(changes) ? changes : [];
    this.checkpoints = [];
    /** @type {{place: number, state: any}} */
    this.last = {place: -1, state: null};
  }

  get length() { return this.changes.length; }

  /** @returns {any} */
  at(place) {
    if (!(place >= 0) || this.length === 0) return null;
    const wanted = Math.min(Math.floor(place), this.length - 1);
    let {place: i, state} = this.last;
    const checkpoint = Math.min(Math.floor(wanted / kCheckpointEvery), this.checkpoints.length - 1);
    if (i > wanted || checkpoint * kCheckpointEvery > i) {
      i = checkpoint < 0 ? -1 : checkpoint * kCheckpointEvery;
      state = checkpoint < 0 ? null : this.checkpoints[checkpoint];
    }
    while (i < wanted) {
      ++i;
      state = i === 0 ? this.changes[0] : applyChange(state, this.changes[i]);
      if (i === this.checkpoints.length * kCheckpointEvery) this.checkpoints.push(state);
    }
    this.last = {place: i, state};
    return state;
  }
}

/** How many of `items`, in order, have a `timeOf` that is not later than `t`. */
function countUntil(items, t, timeOf) {
  let [low, high] = [0, items.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeOf(items[middle]) <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Things that are seen for a while each. */
export class Spans {
  constructor(items, beginOf, endOf) {
    this.items = [...(items ?? [])].sort((a, b) => beginOf(a) - beginOf(b));
    this.beginOf = beginOf;
    this.endOf = endOf;
    this.longest_s = this.items.reduce(
      (longest, item) => Math.max(longest, endOf(item) - beginOf(item)), 0);
  }

  /** Those that have begun at `t` and are not over. */
  at(t) {
    const begin = countUntil(this.items, t - this.longest_s - 1e-6, this.beginOf);
    const end = countUntil(this.items, t, this.beginOf);
    return this.items.slice(begin, end).filter((item) => t < this.endOf(item));
  }
}

const kPacketLasts_s = 10;  // As the viewer's frames have them.
const lastArrival_s = ({sent, to}) => (
  to.reduce((last, {arrives}) => Math.max(last, arrives), sent) + kPacketLasts_s);

const mix = (a, b, fraction) => (
  Number.isFinite(a) && Number.isFinite(b) ? a + (b - a) * fraction : a);
const mixHeading = (a, b, fraction) => {
  if (!Number.isFinite(a) || !Number.isFinite(b)) return a;
  const turn = ((b - a + 540) % 360) - 180;
  return (a + turn * fraction + 360) % 360;
};

/** A vehicle's `nav` between two frames. */
function blendNav(a, b, t, fraction) {
  if (!a || !b) return a;
  const nav = {...a, t: mix(a.t, b.t, fraction)};
  for (const key of kBlended) nav[key] = mix(a[key], b[key], fraction);
  for (const key of kHeadings) nav[key] = mixHeading(a[key], b[key], fraction);
  return nav;
}

const kFateKeys = ['id', 't', 'kind', 'source', 'destination', 'count', 'number', 'cause', 'rule',
  'text', 'range_m', 'limit_m', 'medium'];

function fateOf(row) {
  const fate = Object.fromEntries(kFateKeys.map((key, i) => [key, row[i]]));
  if (fate.medium === null) delete fate.medium;
  return fate;
}

export class PageRecording {
  /** @param data  as lib/tools/view/page_recording.cc writes it */
  constructor(data) {
    this.token = '';
    this.data = data;
    this.frames = new States(data.frames?.states);
    this.step_s = data.frames?.step_s > 0 ? data.frames.step_s : 1;
    this.links = new States(data.links?.states);
    this.media = new Map((data.media ?? []).map(({name, states}) => [name, new States(states)]));
    this.swarms = new Map((data.swarms?.of ?? []).map(
      ({name, states}) => [name, new States(states)]));
    this.pulses = new Spans(data.pulses, ({t}) => t, ({t, duration}) => t + duration);
    this.packets = new Spans(data.packets, ({sent}) => sent, lastArrival_s);
    this.fates = (data.fates ?? []).map(fateOf);
    this.received = new Set((data.setup?.causes ?? [])
      .filter(({outcome}) => outcome === 'whole' || outcome === 'damaged').map(({key}) => key));
    this.charts = new Map();
    const channels = new PageChannels(data.channels);
    this.answers = {
      '/api/channels': (query) => channels.channels(this.#time(query)),
      '/api/message': (query) => channels.message(query.channel, this.#time(query)),
      '/api/fields': (query) => channels.fields(query.text),
      '/api/series': (query) => channels.series(query.field, this.#time(query), Number(query.window ?? 120)),
      '/api/setup': () => data.setup,
      '/api/trails': () => data.trails,
      '/api/events': () => data.events,
      '/api/verdict': () => data.verdict,
      '/api/frame': (query) => this.#frame(this.#time(query)),
      '/api/links': (query) => this.#linksAt(query),
      '/api/link': (query) => this.#link(query),
      '/api/fates': (query) => this.#fatesOf(query),
      '/api/vehicle': (query) => this.#vehicle(query),
    };
  }

  /** Answers as the viewer does; rejects with a RequestError. */
  async get(path, query = {}) {
    const answer = this.answers[path];
    if (!answer) throw new RequestError('not available in a page without a viewer', 404);
    return answer(query);
  }

  /** Answers with the bytes of a background that the page holds. */
  async bytes(path, query) {
    const held = path === '/api/background' ? this.data.backgrounds?.[Number(query.number)] : null;
    const base64 = query.world ? held?.world : held?.bytes;
    if (typeof base64 !== 'string') throw new RequestError('not available in a page without a viewer', 404);
    return new Blob([bytesOf(base64)]);
  }

  async post(path) {
    throw new RequestError(path === '/api/command' ? 'a recorded mission takes no commands'
      : 'a page without a viewer cannot plan: shoal view LOG can', 404);
  }

  #time({t}) {
    const {begin_s, end_s} = this.data;
    const time_s = Number(t);
    return t === undefined || Number.isNaN(time_s) ? end_s
      : Math.min(end_s, Math.max(begin_s, time_s));
  }

  /** The time of a frame: the last is at the end, wherever the steps lead. */
  #timeOf(place) {
    return Math.min(this.data.end_s, this.data.begin_s + place * this.step_s);
  }

  #frame(t) {
    const place = Math.min(this.frames.length - 1,
      Math.floor((t - this.data.begin_s) / this.step_s + 1e-9));
    const before = this.frames.at(place);
    const after = this.frames.at(place + 1);
    const span_s = this.#timeOf(place + 1) - this.#timeOf(place);
    const fraction = span_s > 0 ? Math.min(1, Math.max(0, (t - this.#timeOf(place)) / span_s)) : 0;
    const next = new Map(after.vehicles.map((vehicle) => [vehicle.name, vehicle]));
    return {
      ...before,
      t,
      vehicles: before.vehicles.map((vehicle) => ({
        ...vehicle, nav: blendNav(vehicle.nav, next.get(vehicle.name)?.nav, t, fraction)})),
      pulses: this.pulses.at(t),
      packets: this.packets.at(t),
    };
  }

  #slow(states, step_s, t) {
    return states.at(Math.floor((t - this.data.begin_s) / step_s + 1e-9));
  }

  #linksAt(query) {
    const {medium} = query;
    const states = medium ? this.media.get(medium) : this.links;
    if (!states) throw new RequestError('no such medium', 404);
    return this.#slow(states, this.data.links.step_s, this.#time(query));
  }

  /** The fates until `t`, the oldest first. */
  #fatesUntil(t) {
    return this.fates.slice(0, countUntil(this.fates, t, (fate) => fate.t));
  }

  #fatesOf(query) {
    const known = this.#fatesUntil(this.#time(query));
    const same = (a, b) => a.toLowerCase() === b.toLowerCase();
    const {vehicle, kind, cause} = query;
    const after = Number(query.after ?? -1);
    const limit = Number(query.limit ?? 200);
    const wanted = known.filter((fate) => fate.id > after
      && (!vehicle || same(fate.source, vehicle) || same(fate.destination, vehicle))
      && (!kind || fate.kind === kind) && (!cause || fate.cause === cause)
      && (!query.blocked || !this.received.has(fate.cause)));
    const taken = after >= 0 ? wanted.slice(0, limit) : wanted.slice(-limit);
    return {
      fates: taken.reverse(),
      kinds: [...new Set(known.map((fate) => fate.kind))],
      causes: [...new Set(known.map((fate) => fate.cause))],
      forgotten: this.fates.length > 0 ? this.fates[0].id - 1 : 0,
    };
  }

  #link(query) {
    const t = this.#time(query);
    const fates = this.#fatesUntil(t).filter(
      (fate) => fate.source === query.from && fate.destination === query.to);
    const causes = {};
    const kinds = new Map();
    const bin_s = Math.max(1, Math.ceil((t - this.data.begin_s) / kMaxBins));
    const bins = new Map();
    for (const fate of fates) {
      causes[fate.cause] = (causes[fate.cause] ?? 0) + fate.count;
      const kind = kinds.get(fate.kind) ?? {delivered: 0, offered: 0};
      const begin_s = Math.floor(fate.t / bin_s) * bin_s;
      const bin = bins.get(begin_s) ?? {delivered: 0, offered: 0};
      for (const counts of [kind, bin]) {
        counts.offered += fate.count;
        if (this.received.has(fate.cause)) counts.delivered += fate.count;
      }
      kinds.set(fate.kind, kind);
      bins.set(begin_s, bin);
    }
    const ranges = fates.filter(({range_m}) => Number.isFinite(range_m)).slice(-kLinkRanges);
    const rows = [...bins.values()];
    return {
      from: query.from, to: query.to, causes, by_kind: Object.fromEntries(kinds),
      ratio: {t: [...bins.keys()], delivered: rows.map((bin) => bin.delivered),
        offered: rows.map((bin) => bin.offered)},
      range: {t: ranges.map((fate) => fate.t), range_m: ranges.map((fate) => fate.range_m),
        limit_m: ranges.map((fate) => fate.limit_m)},
      fates: fates.slice(-kLinkFates).reverse(),
    };
  }

  /** Columns of a vehicle over all frames. */
  #chartOf(name) {
    let chart = this.charts.get(name);
    if (chart) return chart;
    chart = {t: [], heading: [], desired_heading: [], speed: [], desired_speed: [], depth: [],
      desired_depth: [], altitude: []};
    const states = new States(this.frames.changes);
    for (let i = 0; i < states.length; ++i) {
      const vehicle = states.at(i).vehicles.find((one) => one.name === name);
      if (!vehicle) continue;
      const {nav, desired} = vehicle;
      chart.t.push(this.#timeOf(i));
      chart.altitude.push(nav?.altitude ?? null);
      for (const key of ['heading', 'speed', 'depth']) {
        chart[key].push(nav?.[key] ?? null);
        chart[`desired_${key}`].push(desired?.[key] ?? null);
      }
    }
    this.charts.set(name, chart);
    return chart;
  }

  #vehicle(query) {
    const t = this.#time(query);
    const {name} = query;
    const chart = this.#chartOf(name);
    if (chart.t.length === 0) throw new RequestError('no such vehicle', 404);
    const begin_s = t - Number(query.window ?? 120);
    const places = [...chart.t.keys()].filter((i) => chart.t[i] >= begin_s && chart.t[i] <= t);
    const stride = Math.max(1, Math.ceil(places.length / kMaxPoints));
    const seen = places.filter((_, i) => i % stride === 0);
    const columns = Object.fromEntries(Object.entries(chart).map(
      ([key, column]) => [key, seen.map((i) => column[i])]));
    const links = this.#slow(this.links, this.data.links.step_s, t)?.links ?? [];
    const swarm = this.swarms.has(name)
      ? this.#slow(this.swarms.get(name), this.data.swarms.step_s, t) : null;
    return {
      name, ...columns, swarm,
      receives_from: links.filter(({to, last_received_s}) => to === name && last_received_s !== null)
        .map(({from, last_received_s}) => ({name: from, last_received_s})),
    };
  }
}

const bytesOf = (base64) => Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));

/** Reads what DeflatedBase64 has written (apps/viewer/page_export.h). */
async function unpack(base64) {
  const packed = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(packed).text());
}

/** Returns the recording of a page that has one, or null. */
export async function recordingInPage() {
  const place = document.getElementById('recording');
  return place === null ? null : new PageRecording(await unpack(place.textContent));
}
