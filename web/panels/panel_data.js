// All channels with their last messages, and charts of any of their fields.

import {failureOf} from '../net/requests.js';
import {FieldChart} from '../charts/field_chart.js';
import {kMaxCharts, kMaxFields} from '../charts/field_series.js';
import {Poller} from '../net/poller.js';
import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {age, clip, missionTime, quantity} from '../page/text.js';

const kWindows_s = [30, 120, 600, 3600, 86400];
const kMaxRows = 300;
const kMaxFound = 30;

/** Has `name` all words of `text`, whatever their case? */
export function hasWords(name, text) {
  const lower = name.toLowerCase();
  return text.toLowerCase().split(/\s+/).every((word) => lower.includes(word));
}

/** The fields that show a vehicle's states over time, as far as its channels are known. */
export function stateFields(vehicle, channels) {
  const upper = vehicle.toUpperCase();
  const wanted = [`HELM_STATE_${upper}:state`, `HELM_STATE_${upper}:task`,
    `HELM_DECISION_${upper}:mode`, `HELM_DECISION_${upper}:aims[].name`,
    'COMMS_MEDIA:media[].medium'];
  return wanted.filter((field) => channels.includes(field.slice(0, field.indexOf(':'))));
}

export class DataPanel {
  constructor(page, root) {
    this.page = page;
    this.plots = [];       // Each a list of fields.
    this.target = 0;       // The chart that fields are added to; beyond the last: a new one.
    this.charts = [];
    this.channel = null;
    this.channels = [];
    this.window = element('select', {id: 'data-window', onchange: () => this.#askSeriesAgain()},
      kWindows_s.map((seconds) => element('option', {value: seconds, selected: seconds === 120},
        seconds === 86400 ? 'whole mission' : age(seconds))));
    this.into = element('select', {id: 'data-into', onchange: () => {
      this.target = Number(this.into.value);
    }});
    this.states = element('button', {type: 'button', id: 'data-states', hidden: true,
      onclick: () => this.#addStates()});
    this.plotPlace = element('div', {id: 'plots', class: 'plots'});
    this.search = element('input', {type: 'search', id: 'data-search', autocomplete: 'off',
      placeholder: 'nav x_m', 'aria-label': 'Search channels and fields', maxlength: 100,
      oninput: () => this.#searchAgain()});
    const found = element('ul', {class: 'fields', 'aria-label': 'Fields found'});
    this.found = new KeyedList(found, (field) => this.#field(field));
    this.foundNote = element('p', {class: 'dim', role: 'status'});
    this.note = element('p', {class: 'dim', role: 'status'});
    const body = element('tbody');
    this.rows = new KeyedList(body, (name) => this.#row(name));
    this.table = element('table', {id: 'channels', class: 'channels'}, element('thead', {},
      element('tr', {}, ['Channel', 'Rate', 'Last'].map(
        (label) => element('th', {scope: 'col'}, label)))), body);
    this.title = element('h3', {id: 'message-title'});
    this.about = element('p', {class: 'dim'});
    const values = element('tbody');
    this.values = new KeyedList(values, (path) => this.#value(path));
    this.message = element('section', {id: 'message', hidden: true}, this.title, this.about,
      element('table', {class: 'message'}, values));
    root.replaceChildren(
      element('section', {}, element('h3', {}, 'Charts of any field'),
        element('p', {class: 'buttons'}, element('label', {class: 'dim'}, 'The last ', this.window),
          element('label', {class: 'dim'}, 'Add to ', this.into), this.states), this.plotPlace),
      element('section', {}, element('h3', {}, 'Channels'), this.search, this.note,
        element('div', {id: 'fields'}, found, this.foundNote),
        element('div', {class: 'channel-scroll'}, this.table)), this.message);
    const at = () => (page.isRecorded ? `@${page.source.t}` : null);
    this.list = new Poller(page.isRecorded ? 300 : 1000, () => this.#askChannels(), at);
    this.last = new Poller(page.isRecorded ? 300 : 500, () => this.#askMessage(), at);
    this.series = new Poller(page.isRecorded ? 400 : 700, () => this.#askSeries(), at);
    this.finder = new Poller(400, () => this.#askFields(), () => this.search.value.trim());
    this.#offerTargets();
  }

  show(visible) {
    this.visible = visible;
    for (const poller of [this.list, this.last, this.series, this.finder]) {
      if (visible) poller.start();
      else poller.stop();
    }
  }

  reset() {
    this.rows.clear();
    this.channel = null;
    this.message.hidden = true;
    this.list.renew();
  }

  restyle() {
    for (const chart of this.charts) chart.restyle();
  }

  select(name) {
    this.states.hidden = !name;
    setText(this.states, name ? `States of ${clip(name, 30)}` : '');
  }

  /** Shows these charts, each a list of fields. */
  setPlots(plots) {
    this.plots = plots.map((fields) => [...fields]);
    this.target = this.plots.length;
    this.#remake();
  }

  add(field) {
    const fields = this.plots[this.target];
    if (fields?.includes(field)) return;
    if (!fields || fields.length === kMaxFields) {
      if (this.plots.length === kMaxCharts) {
        setText(this.note, `No more than ${kMaxCharts} charts: remove one.`);
        return;
      }
      this.plots.push([field]);
      this.target = this.plots.length - 1;
    } else {
      fields.push(field);
    }
    this.#changed();
  }

  #addStates() {
    const fields = stateFields(this.page.selected ?? '', this.channels.map(({name}) => name));
    this.target = this.plots.length;
    for (const field of fields) this.add(field);
    if (fields.length === 0) setText(this.note, 'No channel shows states of this vehicle yet.');
  }

  #remove(place, field) {
    this.plots[place] = this.plots[place].filter((one) => one !== field);
    this.plots = this.plots.filter((fields) => fields.length > 0);
    this.target = Math.min(this.target, this.plots.length);
    this.#changed();
  }

  #changed() {
    this.#remake();
    this.page.keeper.changed();
  }

  #remake() {
    for (const chart of this.charts) chart.destroy();
    this.charts = this.plots.map((fields, place) => (
      new FieldChart(fields, {remove: (field) => this.#remove(place, field)})));
    this.plotPlace.replaceChildren(...this.charts.map(({root}) => root));
    this.#offerTargets();
    this.#askSeriesAgain();
  }

  #offerTargets() {
    const names = [...this.plots.map((_, i) => `chart ${i + 1}`), 'a new chart'];
    this.into.replaceChildren(...names.map((text, i) => (
      element('option', {value: i, selected: i === this.target}, text))));
    this.into.value = String(this.target);
  }

  #askSeriesAgain() {
    this.series.renew();
  }

  #searchAgain() {
    this.#showChannels();
    this.finder.renew();
  }

  async #askChannels() {
    try {
      const answer = await this.page.requests.get('/api/channels', this.page.query());
      this.channels = Array.isArray(answer.channels) ? answer.channels : [];
      this.#showChannels();
    } catch (error) {
      const {status, message} = failureOf(error);
      if (status === 404) setText(this.note, clip(message));
      throw error;
    }
  }

  #showChannels() {
    const text = this.search.value.trim();
    // With the name of a field beside it a channel's own words still find it.
    const shown = this.channels.filter(({name, type}) => text === ''
      || text.split(/\s+/).some((word) => hasWords(`${name} ${type}`, word)));
    const t = this.page.isRecorded ? this.page.source.t : this.page.frame?.t;
    this.rows.sync(shown.slice(0, kMaxRows).map((channel) => ({channel, t})),
      ({channel}) => channel.name);
    setText(this.note, this.channels.length === 0 ? 'No message yet.'
      : `${shown.length} of ${this.channels.length} channels`
        + `${shown.length > kMaxRows ? `, ${kMaxRows} of them shown` : ''}.`);
  }

  #row(name) {
    const type = element('small', {class: 'dim'});
    const [rate, last] = [element('td', {class: 'number'}), element('td', {class: 'number'})];
    const root = element('tr', {'aria-selected': String(name === this.channel)},
      element('th', {scope: 'row'}, element('button', {type: 'button', class: 'plain',
        'data-channel': name, onclick: () => this.#open(name)}, clip(name, 60)), type), rate, last);
    return {
      root,
      update: ({channel, t}) => {
        setText(type, ` ${clip(channel.type, 40)}`);
        setText(rate, quantity(channel.rate_hz, channel.rate_hz < 10 ? 1 : 0, 'Hz'));
        setText(last, Number.isFinite(t) ? age(Math.max(0, t - channel.t)) : '–');
        setAttribute(rate, 'title', `${channel.count} messages`);
        setAttribute(root, 'aria-selected', String(name === this.channel));
      },
    };
  }

  #open(name) {
    this.channel = name === this.channel ? null : name;
    this.message.hidden = this.channel === null;
    this.values.clear();
    setText(this.title, clip(this.channel ?? '', 80));
    setText(this.about, '');
    this.#showChannels();
    this.last.renew();
    if (this.channel !== null) this.message.scrollIntoView({block: 'nearest'});
  }

  async #askMessage() {
    const {channel} = this;
    if (channel === null) return;
    let answer;
    try {
      answer = await this.page.requests.get('/api/message', {channel, ...this.page.query()});
    } catch (error) {
      const {status, message} = failureOf(error);
      if (status === 404 && channel === this.channel) {
        this.values.clear();
        setText(this.about, clip(message));
      }
      throw error;
    }
    if (channel !== this.channel) return;
    const fields = Array.isArray(answer.fields) ? answer.fields : [];
    setText(this.about, `${clip(answer.type, 80)}, ${answer.bytes} bytes, at ${missionTime(answer.t)}`
      + `${answer.left_out > 0 ? `; ${answer.left_out} more values` : ''}`);
    this.values.sync(fields, ({path}) => path);
  }

  #value(path) {
    const text = element('td');
    const add = element('button', {type: 'button', class: 'small', title: 'Add to the chart',
      'aria-label': `Chart of ${clip(path, 80)}`, onclick: () => this.add(`${this.channel}:${path}`)}, '+');
    const root = element('tr', {}, element('th', {scope: 'row'}, clip(path, 80)), text,
      element('td', {}, add));
    return {root, update: (field) => setText(text, clip(field.text, 200))};
  }

  async #askFields() {
    const text = this.search.value.trim();
    if (text === '') {
      this.found.clear();
      setText(this.foundNote, '');
      return;
    }
    const answer = await this.page.requests.get('/api/fields', {text, ...this.page.query()});
    if (text !== this.search.value.trim()) return;
    const fields = Array.isArray(answer.fields) ? answer.fields : [];
    this.found.sync(fields.slice(0, kMaxFound), String);
    setText(this.foundNote, fields.length === 0 ? 'no field has these words'
      : answer.more || fields.length > kMaxFound ? 'and more: add a word' : '');
  }

  #field(field) {
    const root = element('li', {}, element('button', {type: 'button', class: 'plain',
      'data-field': clip(field, 300), onclick: () => this.add(field)}, `+ ${clip(field, 100)}`));
    return {root, update: () => {}};
  }

  async #askSeries() {
    if (this.plots.length === 0) return;
    const {plots, charts} = this;
    const window = this.window.value;
    const query = this.page.query();
    const answers = await Promise.all(plots.map((fields) => Promise.all(fields.map(
      (field) => this.#oneSeries(field, window, query)))));
    if (plots !== this.plots || charts !== this.charts) return;
    const now_s = this.page.isRecorded ? this.page.source.t : this.page.frame?.t ?? 0;
    charts.forEach((chart, i) => {
      // A field may have been added meanwhile.
      if (answers[i].length === chart.fields.length) chart.update(answers[i], now_s, Number(window));
    });
  }

  async #oneSeries(field, window, query) {
    try {
      const answer = await this.page.requests.get('/api/series', {field, window, ...query});
      return Array.isArray(answer.t) && Array.isArray(answer.value) ? answer : null;
    } catch (error) {
      const {status, message} = failureOf(error);
      if (status === 404 || status === 400) {
        return {t: [], value: [], number: true, error: message};
      }
      throw error;
    }
  }
}
