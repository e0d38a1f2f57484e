// The messages that a page of its own holds of each channel (apps/viewer/page_channels.h): answers
// what a viewer would of /api/channels, message, fields and series.

import {RequestError} from './requests.js';

const kMaxFields = 100;
const kMaxPoints = 1500;

const general = (path) => path.replace(/\[\d+\]/g, '[]');
const wordsOf = (text) => String(text ?? '').toLowerCase().split(/\s+/).filter(Boolean);

export class PageChannels {
  #channels = new Map();

  /** @param list  as ChannelsForPage writes it */
  constructor(list) {
    for (const channel of Array.isArray(list) ? list : []) this.#channels.set(channel.name, channel);
  }

  /** How many samples of a channel are not later than `t`. */
  #until(channel, t) {
    let count = 0;
    while (count < channel.samples.length && channel.samples[count][0] <= t + 1e-9) ++count;
    return count;
  }

  #find(name) {
    const channel = this.#channels.get(name);
    if (!channel) throw new RequestError(`no channel ${name} in this page`, 404);
    return channel;
  }

  channels(t) {
    const shown = [];
    for (const channel of this.#channels.values()) {
      const last = channel.samples[this.#until(channel, t) - 1];
      if (!last) continue;
      const {name, type, count, rate_hz} = channel;
      shown.push({name, type, count, rate_hz, t: last[0]});
    }
    return {channels: shown};
  }

  message(name, t) {
    const channel = this.#find(name);
    const row = channel.samples[this.#until(channel, t) - 1];
    if (!row) throw new RequestError(`no message on ${name} until then`, 404);
    const fields = channel.fields.map(([path, number], i) => ({path, text: row[i + 2], number}))
      .filter(({text}) => text !== null);
    return {channel: name, type: channel.type, t: row[0], bytes: row[1], fields, left_out: 0};
  }

  fields(text) {
    const words = wordsOf(text);
    const found = new Set();
    for (const {name, fields} of this.#channels.values()) {
      for (const [path] of fields) {
        const field = `${name}:${general(path)}`;
        if (words.every((word) => field.toLowerCase().includes(word))) found.add(field);
      }
    }
    return {fields: [...found].slice(0, kMaxFields), more: found.size > kMaxFields};
  }

  series(field, t, window_s) {
    const colon = String(field).indexOf(':');
    const path = field.slice(colon + 1);
    const channel = this.#find(field.slice(0, colon));
    const places = [...channel.fields.keys()].filter((i) => (
      channel.fields[i][0] === path || general(channel.fields[i][0]) === path));
    if (places.length === 0) throw new RequestError(`${field}: no such field`, 404);
    /** @type {number[]} */
    const times = [];
    /** @type {string[]} */
    const texts = [];
    for (const row of channel.samples.slice(0, this.#until(channel, t)).slice(-kMaxPoints)) {
      const values = [...new Set(places.map((i) => row[i + 2]).filter((value) => value !== null))];
      if (row[0] < t - window_s || values.length === 0) continue;
      times.push(row[0]);
      texts.push(values.join(', '));
    }
    const numbers = texts.map((text) => (
      text === 'true' ? 1 : text === 'false' ? 0 : text.trim() === '' ? NaN : Number(text)));
    const isNumber = numbers.every(Number.isFinite);
    return {field, number: isNumber, t: times, value: isNumber ? numbers : texts};
  }
}
