// A chart of marks that can be picked with the pointer or the keys.

import uPlot from '../vendor/uPlot.esm.js';
import {element, setText} from '../page/dom.js';
import {cellText, clipped} from './report_numbers.js';
import {curveShift_px, drawBins, drawCurves, drawTrials} from './report_drawing.js';

const kHeight_px = 290;
const kReach_px = 24; // How far from a mark a click still picks it.
const kOverlap_px = 4; // Trials this near to the picked one are picked with it.
const kCounts = Array.from({length: 27}, (_, i) => [1, 2, 5][i % 3] * 10 ** Math.floor(i / 3));
const kDrawings = {curve: drawCurves, trials: drawTrials, bins: drawBins};

const themeColor = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim() || '#888';

/** The colours of the lines on the ground of now. */
export const lineColors = () => Array.from({length: 8}, (_, i) => themeColor(`--line-${i + 1}`));

export class ReportChart {
  /** @param onPick  is called with the marks that were picked, the nearest first */
  constructor(parent, name, onPick) {
    this.onPick = onPick;
    this.title = element('strong');
    this.note = element('span', {class: 'dim'});
    this.pointed = element('output', {class: 'pointed'});
    this.place = element('div', {class: 'chart-place', tabindex: '0', role: 'application',
      onkeydown: (event) => this.#key(event)});
    this.root = element('figure', {class: 'chart', 'data-chart': name},
      element('figcaption', {}, this.title, ' ', this.note), this.place, this.pointed);
    this.ring = element('div', {class: 'ring', hidden: true});
    parent.append(this.root);
    new ResizeObserver(() => this.#fit()).observe(this.place);
  }

  /**
   * Draws, or hides where `view` is null.
   * @param view  kind: curve, trials or bins; title, note; marks: {x, y, line}; lines;
   *              x, y: {range, label, ticks: [{at, text}] or null, isShare, isCount};
   *              textOf(mark); more for its drawing
   */
  show(view) {
    this.view = view;
    this.root.hidden = view === null;
    this.current = -1;
    this.order = null;
    this.plot?.destroy();
    this.plot = null;
    if (!view) return;
    setText(this.title, view.title);
    setText(this.note, view.note ?? '');
    setText(this.pointed, view.marks.length > 0 ? '\u00a0' : 'No trial has a value to draw.');
    this.place.setAttribute('aria-label',
      `${view.title}. Left and right go from point to point, Enter lists the trials.`);
    this.place.hidden = view.marks.length === 0;
    this.#make();
  }

  /** Where a mark is, in CSS pixels from the corner of the plot. */
  placeOf(mark) {
    const shift = this.view.kind === 'curve' ? curveShift_px(mark.line, this.view.lines.length) : 0;
    return {x: this.plot.valToPos(mark.x, 'x') + shift, y: this.plot.valToPos(mark.y, 'y')};
  }

  #make() {
    const width = this.place.clientWidth;
    if (width < 80 || this.view.marks.length === 0) return;
    const {x, y} = this.view;
    const line = themeColor('--line');
    const axis = ({label, ticks, isShare, isCount}, size, space_px) => ({
      stroke: themeColor('--text-dim'), font: '12px system-ui, sans-serif', size, label,
      labelSize: 20, labelFont: '13px system-ui, sans-serif', labelGap: 0,
      grid: {stroke: line, width: 1}, ticks: {stroke: line, width: 1},
      ...(isCount ? {incrs: kCounts} : {}),
      ...(ticks ? this.#textTicks(ticks, space_px) : {
        values: (_, splits) => splits.map((split) => isShare ? `${cellText(100 * split)} %` :
          cellText(split))}),
    });
    this.plot = new uPlot({
      width, height: kHeight_px, legend: {show: false}, padding: [10, 16, 0, 0],
      cursor: {show: false},
      scales: {x: {time: false, range: () => x.range}, y: {range: () => y.range}},
      axes: [{...axis(x, 30, 110)}, {...axis(y, 62, 24)}],
      series: [{}, {show: true, paths: () => null, points: {show: false}}],
      hooks: {draw: [(plot) => this.#draw(plot)]},
    }, [x.range, [null, null]], this.place);
    const over = this.plot.over;
    over.append(this.ring);
    this.ring.hidden = true;
    over.addEventListener('mousemove', (event) => this.#point(this.#nearest(event)));
    over.addEventListener('mouseleave', () => this.#point(-1));
    over.addEventListener('click', (event) => this.#pick(this.#nearest(event)));
  }

  /** Marks of texts: of many along x every n-th, so that they do not cover each other. */
  #textTicks(ticks, space_px) {
    const room = Math.max(1, Math.floor(this.place.clientWidth / space_px));
    const step = Math.ceil(ticks.length / room);
    const shown = [...ticks].sort((a, b) => a.at - b.at).filter((_, i) => i % step === 0);
    return {splits: () => shown.map(({at}) => at),
      values: () => shown.map(({text}) => clipped(text, 16))};
  }

  #draw({ctx, bbox, scales}) {
    const along = ({min, max}, begin, length) => (value) =>
      begin + (value - min) / (max - min) * length;
    const at = {x: along(scales.x, bbox.left, bbox.width),
      y: along(scales.y, bbox.top + bbox.height, -bbox.height)};
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    kDrawings[this.view.kind](ctx, this.view, at, lineColors(), uPlot.pxRatio);
    ctx.restore();
  }

  #fit() {
    const width = this.place.clientWidth;
    if (!this.view || width < 80) return;
    if (!this.plot) this.#make();
    else if (this.plot.width !== width) this.show(this.view);
  }

  /** The mark that the pointer means, by its number; -1: none. */
  #nearest({offsetX, offsetY}) {
    const {kind, marks} = this.view;
    if (kind === 'bins') {
      const value = this.plot.posToVal(offsetX, 'x');
      return marks.findIndex(({begin, end}) => begin <= value && value <= end);
    }
    let best = -1;
    let least = kReach_px;
    marks.forEach((mark, i) => {
      const {x, y} = this.placeOf(mark);
      const distance = Math.hypot(x - offsetX, y - offsetY);
      if (distance < least) {
        least = distance;
        best = i;
      }
    });
    return best;
  }

  #point(number) {
    this.current = number;
    const mark = this.view.marks[number];
    this.ring.hidden = !mark;
    setText(this.pointed, mark ? this.view.textOf(mark) : '\u00a0');
    if (!mark) return;
    const {x, y} = this.placeOf(mark);
    this.ring.style.left = `${x}px`;
    this.ring.style.top = `${y}px`;
  }

  #pick(number) {
    const {kind, marks} = this.view;
    const mark = marks[number];
    if (!mark) return;
    this.#point(number);
    if (kind !== 'trials') {
      this.onPick([mark]);
      return;
    }
    const at = this.placeOf(mark);
    this.onPick([mark, ...marks.filter((other) => {
      const place = this.placeOf(other);
      return other !== mark && Math.hypot(place.x - at.x, place.y - at.y) <= kOverlap_px;
    })]);
  }

  #key(event) {
    const {marks} = this.view;
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (step) {
      this.order ??= marks.map((_, i) => i).sort((a, b) => marks[a].x - marks[b].x ||
        marks[a].y - marks[b].y);
      const place = this.order.indexOf(this.current);
      const next = place < 0 ? (step > 0 ? 0 : marks.length - 1) : place + step;
      this.#point(this.order[Math.min(marks.length - 1, Math.max(0, next))]);
    } else if (event.key === 'Enter' || event.key === ' ') {
      this.#pick(this.current);
    } else {
      return;
    }
    event.preventDefault();
  }
}
