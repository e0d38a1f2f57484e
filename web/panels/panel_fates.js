// The running list of fates, with filters; the newest first.

import {causeWords} from '../page/causes.js';
import {element, KeyedList, setText} from '../page/dom.js';
import {fateRow} from './panel_link.js';
import {Poller} from '../net/poller.js';
import {clip} from '../page/text.js';

const kShown = 200;

/** Puts newer fates before those that are there; at most `limit`, each id once, newest first. */
export function mergeFates(older, newer, limit) {
  const seen = new Set();
  const merged = [];
  for (const fate of [...newer, ...older].sort((a, b) => b.id - a.id)) {
    if (seen.has(fate.id)) continue;
    seen.add(fate.id);
    merged.push(fate);
    if (merged.length === limit) break;
  }
  return merged;
}

/** A <select> with an empty choice for all, whose other choices can grow. */
class Choice {
  constructor(id, label, all, onchange) {
    this.select = element('select', {id, onchange}, element('option', {value: ''}, all));
    this.root = element('label', {}, `${label} `, this.select);
    this.known = new Set();
  }

  get value() {
    return this.select.value;
  }

  offer(values, shown = (value) => value) {
    for (const value of values) {
      if (typeof value !== 'string' || this.known.has(value) || this.known.size >= 500) continue;
      this.known.add(value);
      this.select.append(element('option', {value}, shown(value)));
    }
  }

  clear() {
    this.known.clear();
    while (this.select.length > 1) this.select.remove(1);
  }
}

export class FatesPanel {
  constructor(page, parent) {
    this.page = page;
    this.kept = [];
    this.round = 0;
    const again = () => this.again();
    this.vehicle = new Choice('fates-vehicle', 'Vehicle', 'all', again);
    this.kind = new Choice('fates-kind', 'Kind', 'all', again);
    this.cause = new Choice('fates-cause', 'Cause', 'all', again);
    this.blocked = element('input', {type: 'checkbox', id: 'fates-blocked', onchange: again});
    this.hold = element('button', {type: 'button', id: 'fates-pause', 'aria-pressed': 'false',
      onclick: () => this.#toggleHold()}, 'Pause list');
    this.note = element('p', {class: 'dim'});
    this.list = element('ol', {id: 'fates', class: 'fates', tabindex: '0',
      'aria-label': 'Fates, the newest first'});
    this.rows = new KeyedList(this.list, () => fateRow());
    parent.append(element('section', {class: 'fates-part'},
      element('h3', {}, 'Fates: what became of each transmission'),
      element('div', {class: 'filters'}, this.vehicle.root, this.kind.root, this.cause.root,
        element('label', {}, this.blocked, ' blocked only'), page.isRecorded ? null : this.hold),
      this.note, this.list));
    this.poller = new Poller(page.isRecorded ? 300 : 500, () => this.#ask(), () => (
      page.isRecorded ? `${this.#filterKey()}@${page.source.t}` : null));
  }

  show(visible) {
    if (visible) this.poller.start();
    else this.poller.stop();
  }

  /** Another mission. */
  reset() {
    for (const choice of [this.vehicle, this.kind, this.cause]) choice.clear();
    this.again();
  }

  /** Drops what is shown and asks again. */
  again() {
    this.round += 1;  // What is still on its way is not wanted any more.
    this.kept = [];
    this.poller.renew();
  }

  #filterKey() {
    return [this.vehicle.value, this.kind.value, this.cause.value, this.blocked.checked].join(' ');
  }

  #toggleHold() {
    this.held = !this.held;
    this.hold.setAttribute('aria-pressed', String(this.held));
    setText(this.hold, this.held ? 'Go on' : 'Pause list');
    if (!this.held) this.again();
  }

  async #ask() {
    if (this.held) return;
    const {round} = this;
    const live = !this.page.isRecorded;
    // More than fit came since the last time: only the newest of them matter.
    const after = live && this.kept.length > 0 && !this.isBehind ? this.kept[0].id : null;
    const answer = await this.page.requests.get('/api/fates', {
      vehicle: this.vehicle.value, kind: this.kind.value, cause: this.cause.value,
      blocked: this.blocked.checked ? 1 : null, after, limit: kShown, ...this.page.query(),
    });
    if (round !== this.round || this.held) return;
    const fates = (Array.isArray(answer.fates) ? answer.fates : []).filter(({id}) =>
      Number.isFinite(id));
    this.isBehind = after !== null && fates.length >= kShown;
    this.kept = mergeFates(after === null ? [] : this.kept, fates, kShown);
    this.rows.sync(this.kept, (fate) => String(fate.id));
    this.vehicle.offer(this.page.names());
    this.kind.offer(answer.kinds ?? []);
    this.cause.offer(answer.causes ?? [], (cause) => clip(causeWords(cause), 40));
    setText(this.note, this.#noteOn(answer));
  }

  #noteOn(answer) {
    if (this.kept.length === 0) return 'No such fate so far.';
    const forgotten = answer.forgotten > 0 ? `; ${answer.forgotten} older ones are not kept` : '';
    return this.kept.length === kShown ? `The last ${kShown}${forgotten}.` : '';
  }
}
