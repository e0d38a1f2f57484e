// The links: a table with a row for each sender and a column for each receiver.

import {element, setAttribute, setText} from '../page/dom.js';
import {age, ratio} from '../page/text.js';
import {HeatMap} from './heat_map.js';

const kNames_px = 110;     // For the column of names.
const kFull_px = 70;       // A cell with room for ratio and age; a smaller one has one sign.
const kLeastCell_px = 14;
const kMaxCell_px = 36;
const kGap_px = 1;
// Of more vehicles the matrix is a heat map: ten thousand cells of text show nothing.
const kMostCells = 60;
const kNarrow_px = 388;    // The panel's width where it is not known yet.

/**
 * How large the cells of `count` vehicles are that are seen at once in `width_px`.
 * @returns {{compact: boolean, cell_px: number}}  compact: one sign and no numbers
 */
export function cellSize(width_px, count) {
  const each_px = ((width_px > 0 ? width_px : kNarrow_px) - kNames_px) / Math.max(1, count);
  const cell_px = Math.floor(Math.min(kMaxCell_px, Math.max(kLeastCell_px, each_px - kGap_px)));
  return {compact: count > 3 && each_px < kFull_px, cell_px};
}

/** What one cell shows. `link` is of /api/links, or null where no fate is known. */
export function cellWords(link, t) {
  if (!link) {
    const words = 'nothing was sent';
    return {state: 'unknown', sign: '·', ratio: '', received: '', words, title: words};
  }
  const received = link.last_received_s === null ? 'never received'
    : `received ${age(t - link.last_received_s)} ago`;
  const share = ratio(link.delivered, link.offered);
  const words = link.receives ? 'receives' : 'does not receive';
  return {
    state: link.receives ? 'receives' : 'deaf',
    sign: link.receives ? '✓' : '✗',
    ratio: share,
        received: link.last_received_s === null ? 'never' : age(t - link.last_received_s),
    words,
    title: `${words}; ${link.delivered} of ${link.offered} `
        + `delivered (${share}), ${received}; last: ${link.text}`,
  };
}

/**
 * The media that the matrix can be asked for one by one: none where the mission has fewer than two.
 * @param links  answer of /api/links
 */
export function mediaToChoose(links) {
  const media = (Array.isArray(links?.media) ? links.media : [])
    .filter((name) => typeof name === 'string' && name !== '').slice(0, 32);
  return media.length > 1 ? media : [];
}

export class LinkMatrix {
  /** @param onMedium  another medium was chosen: see `medium` */
  constructor(parent, onLink, onMedium = () => {}) {
    this.onLink = onLink;
    this.shownMedia = '';
    this.select = element('select', {id: 'matrix-medium', onchange: onMedium});
    this.choice = element('label', {class: 'filters', hidden: true}, 'Medium ', this.select);
    this.table = element('table', {id: 'matrix', class: 'matrix'});
    this.count = element('p', {class: 'dim'});
    this.scroll = element('div', {class: 'matrix-scroll', tabindex: '0',
      'aria-label': 'Link matrix'}, this.table);
    this.heat = new HeatMap((from, to) => this.#words(from, to), onLink);
    this.scroll.append(this.heat.root);
    parent.append(this.choice, this.count, this.heat.read, this.scroll);
    new ResizeObserver(() => this.#fit()).observe(this.scroll);
    this.cells = new Map();
    /** @type {string | null} */
    this.shownNames = '';
  }

  /** The medium whose links are shown; empty: all. */
  get medium() {
    return this.select.value;
  }

  /** Another mission: all media, until an answer names them. */
  reset() {
    this.#offer([]);
  }

  #offer(media) {
    const joined = media.join('\n');
    if (joined === this.shownMedia) return;
    this.shownMedia = joined;
    const {medium} = this;
    this.select.replaceChildren(element('option', {value: ''}, 'all'),
      ...media.map((value) => element('option', {value}, value)));
    this.select.value = media.includes(medium) ? medium : '';
    this.choice.hidden = media.length === 0;
  }

  /** @param links  answer of /api/links @param {?{from: string, to: string}} chosen */
  update(links, chosen) {
    this.#offer(mediaToChoose(links));
    const names = Array.isArray(links.names) ? links.names : [];
    const joined = names.join('\n');
    this.links = links;
    const byKey = new Map((links.links ?? []).map((link) => [`${link.from}>${link.to}`, link]));
    this.byKey = byKey;
    const isHeat = names.length > kMostCells;
    this.table.hidden = isHeat;
    this.heat.root.hidden = this.heat.read.hidden = !isHeat;
    let receiving = 0;
    if (isHeat) {
      this.#clear();
      for (const link of byKey.values()) if (link.receives) ++receiving;
      this.heat.show(names, new Map([...byKey].map(([key, {delivered, offered}]) => (
        [key, offered > 0 ? delivered / offered : null]))), this.scroll.clientWidth || kNarrow_px);
    } else {
      if (joined !== this.shownNames) this.#build(names);
      this.shownNames = joined;
      for (const [key, cell] of this.cells) {
        const link = byKey.get(key) ?? null;
        if (link?.receives) ++receiving;
        this.#show(cell, cellWords(link, links.t));
      }
    }
    const all = names.length * (names.length - 1);
    setText(this.count, all === 0 ? 'One vehicle: no link.'
      : `${receiving} of ${all} links deliver now. Rows send, columns receive.`);
    this.choose(chosen);
  }

  #words(from, to) {
    return `${from} to ${to}: ${cellWords(this.byKey?.get(`${from}>${to}`) ?? null,
      this.links?.t).title}`;
  }

  #clear() {
    this.cells.clear();
    this.shownNames = null;
    if (this.table.firstChild) this.table.replaceChildren();
  }

  choose(chosen) {
    const key = chosen ? `${chosen.from}>${chosen.to}` : null;
    if (this.chosen === key) return;
    this.cells.get(this.chosen)?.button.classList.remove('chosen');
    this.cells.get(key)?.button.classList.add('chosen');
    this.chosen = key;
  }

  /** Makes the cells as large as the panel's new width permits. */
  #fit() {
    if (!this.links || !(this.scroll.clientWidth > 0)) return;
    if ((this.links.names?.length ?? 0) > kMostCells) {
      this.update(this.links, null);
      return;
    }
    const {compact, cell_px} = cellSize(this.scroll.clientWidth, this.links.names?.length ?? 0);
    this.table.style.setProperty('--cell', `${cell_px}px`);
    if (compact === this.compact) return;
    const {chosen} = this;
    this.shownNames = null;
    const [from, to] = chosen?.split('>') ?? [];
    this.update(this.links, chosen ? {from, to} : null);
  }

  #build(names) {
    this.cells.clear();
    this.chosen = null;
    const {compact, cell_px} = cellSize(this.scroll.clientWidth, names.length);
    this.compact = compact;
    this.table.classList.toggle('compact', compact);
    this.table.style.setProperty('--cell', `${cell_px}px`);
    const head = element('tr', {}, element('th', {class: 'corner'}, compact ? '' : 'from ↓ to →'),
      names.map((name) => element('th', {scope: 'col', title: name}, element('span', {}, name))));
    const rows = names.map((from) => element('tr', {},
      element('th', {scope: 'row', title: from}, from),
      names.map((to) => element('td', {}, from === to ? null : this.#cell(from, to, compact)))));
    this.table.replaceChildren(element('thead', {}, head), element('tbody', {}, rows));
  }

  #cell(from, to, compact) {
    const sign = element('b', {'aria-hidden': 'true'});
    const share = compact ? null : element('span');
    const received = compact ? null : element('small');
    const cell = {sign, share, received, from, to};
    // Thousands of tooltips that change every second would cost too much: a small cell gets its own
    // when the pointer is on it.
    const explain = () => setAttribute(cell.button, 'title', cell.title ?? null);
    cell.button = element('button', {type: 'button', 'data-cell': `${from}>${to}`,
      onclick: () => this.onLink(from, to), onpointerenter: explain, onfocus: explain},
    sign, share ? ' ' : null, share, received);
    this.cells.set(`${from}>${to}`, cell);
    return cell.button;
  }

  #show(cell, shown) {
    setText(cell.sign, shown.sign);
    if (cell.share) {
      setText(cell.share, shown.ratio);
      setText(cell.received, shown.received);
    }
    setAttribute(cell.button, 'data-receives', shown.state);
    cell.title = `${cell.from} to ${cell.to}: ${shown.title}`;
    const isOpen = cell.button.matches(':hover, :focus');
    if (!this.compact || isOpen) setAttribute(cell.button, 'title', cell.title);
    setAttribute(cell.button, 'aria-label', `${cell.from} to ${cell.to}: `
        + `${shown.words} ${shown.ratio}`);
  }
}
