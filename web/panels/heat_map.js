// The links of many vehicles as a heat map: a row for each sender, a column for each receiver, what
// was delivered as colour. Names stand fixed along two edges; a cell is read with the pointer or the
// arrow keys.

import {element, setText} from '../page/dom.js';

const kNames_px = 92;
const kHead_px = 64;
const kLeastCell_px = 3;
const kMaxCell_px = 16;
const kName_px = 11;
const kMax_px = 8192;  // Of a canvas.

// From nothing delivered to all: Okabe and Ito's vermillion, grey, sky blue.
const kStops = [[213, 94, 0], [120, 120, 120], [86, 180, 233]];

/** Returns [r, g, b] of a share from 0 to 1. */
export function heatColor(share) {
  const at = Math.min(1, Math.max(0, share)) * (kStops.length - 1);
  const i = Math.min(kStops.length - 2, Math.floor(at));
  return kStops[i].map((part, c) => Math.round(part + (kStops[i + 1][c] - part) * (at - i)));
}

/** How large the cells of `count` vehicles are: as large as lets all be seen, if not too small. */
export function heatCell(width_px, count) {
  const each = Math.floor((width_px - kNames_px) / Math.max(1, count));
  return Math.min(kMaxCell_px, Math.max(kLeastCell_px, each), Math.floor(kMax_px / Math.max(1, count)));
}

export class HeatMap {
  /** @param words  (from, to) -> what a cell states @param onLink  (from, to) was chosen */
  constructor(words, onLink) {
    this.words = words;
    this.onLink = onLink;
    this.canvas = element('canvas', {id: 'heat', tabindex: '0', role: 'img',
      'aria-label': 'Links as a heat map: arrow keys move, Enter opens a link'});
    this.left = element('canvas', {class: 'heat-left', 'aria-hidden': 'true'});
    this.top = element('canvas', {class: 'heat-top', 'aria-hidden': 'true'});
    this.corner = element('span', {class: 'heat-corner dim'}, 'from ↓ to →');
    this.read = element('output', {id: 'heat-read', 'aria-live': 'polite'});
    this.root = element('div', {class: 'heat', hidden: true},
      this.corner, this.top, this.left, this.canvas);
    const at = (event) => {
      const box = this.canvas.getBoundingClientRect();
      return [Math.floor((event.clientY - box.top) / this.cell),
        Math.floor((event.clientX - box.left) / this.cell)];
    };
    this.canvas.addEventListener('pointermove', (event) => this.#point(...at(event)));
    this.canvas.addEventListener('click', (event) => {
      this.#point(...at(event));
      this.#open();
    });
    this.canvas.addEventListener('keydown', (event) => this.#key(event));
    this.place = [0, 0];
    this.cell = 1;
    /** @type {string[]} */
    this.names = [];
  }

  /** @param shares  Map of "from>to" to a share, null: nothing offered */
  show(names, shares, width_px) {
    this.names = names;
    this.cell = heatCell(width_px, names.length);
    const size = this.cell * names.length;
    for (const [canvas, width, height] of [[this.canvas, size, size], [this.left, kNames_px, size],
      [this.top, size, kHead_px]]) {
      if (canvas.width !== width) canvas.width = width;
      if (canvas.height !== height) canvas.height = height;
    }
    this.#paint(shares);
    this.#paintNames();
    this.#point(...this.place);
  }

  #paint(shares) {
    const {names, cell} = this;
    const ctx = this.canvas.getContext('2d');
    ctx.clearRect(0, 0, this.canvas.width, this.canvas.height);
    const gap = cell > 5 ? 1 : 0;
    names.forEach((from, row) => {
      names.forEach((to, column) => {
        const share = shares.get(`${from}>${to}`);
        if (share === undefined || share === null) return;
        ctx.fillStyle = `rgb(${heatColor(share).join()})`;
        ctx.fillRect(column * cell, row * cell, cell - gap, cell - gap);
      });
    });
  }

  #paintNames() {
    const {names, cell} = this;
    const style = getComputedStyle(document.documentElement);
    const every = Math.ceil((kName_px + 2) / cell);
    const [left, top] = [this.left, this.top].map((canvas) => canvas.getContext('2d'));
    for (const ctx of [left, top]) {
      ctx.clearRect(0, 0, ctx.canvas.width, ctx.canvas.height);
      ctx.font = `${kName_px}px system-ui, sans-serif`;
      ctx.fillStyle = style.getPropertyValue('--text-dim') || '#888';
      ctx.textBaseline = 'middle';
    }
    left.textAlign = 'right';
    for (let i = 0; i < names.length; i += every) {
      left.fillText(names[i], kNames_px - 4, (i + 0.5) * cell, kNames_px - 6);
      top.save();
      top.translate((i + 0.5) * cell, kHead_px - 3);
      top.rotate(-Math.PI / 2);
      top.fillText(names[i], 0, 0, kHead_px - 4);
      top.restore();
    }
  }

  #point(row, column) {
    const {names} = this;
    if (!names?.[row] || !names[column]) return;
    this.place = [row, column];
    setText(this.read, row === column ? `${names[row]} itself` : this.words(names[row], names[column]));
  }

  #open() {
    const [row, column] = this.place;
    if (row !== column) this.onLink(this.names[row], this.names[column]);
  }

  #key(event) {
    const steps = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]};
    if (event.key === 'Enter') this.#open();
    else if (Object.hasOwn(steps, event.key)) {
      const [down, right] = steps[event.key];
      this.#point(this.place[0] + down, this.place[1] + right);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }
}
