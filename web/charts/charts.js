// Charts over mission time, which change in place.

import uPlot from '../vendor/uPlot.esm.js';
import {element, setText} from '../page/dom.js';
import {missionTime, quantity} from '../page/text.js';

const kHeight_px = 116;
const kMorePoints = 20000;  // No answers of the viewer in one chart have more.

/**
 * Makes columns that uPlot can draw of an answer that may be anything: as long as `t`, numbers or
 * null, times growing.
 * @returns [t, ...columns]
 */
export function cleanColumns(t, columns) {
  const clean = [[], ...columns.map(() => [])];
  let last = -Infinity;
  const times = Array.isArray(t) ? t : [];
  for (let i = 0; i < Math.min(times.length, kMorePoints); ++i) {
    if (!Number.isFinite(times[i]) || times[i] <= last) continue;
    last = times[i];
    clean[0].push(last);
    columns.forEach((column, place) => {
      const value = Array.isArray(column) ? column[i] : null;
      clean[place + 1].push(Number.isFinite(value) ? value : null);
    });
  }
  return clean;
}

/**
 * Where the line of a series of headings is drawn: strokes of indices that follow one another,
 * broken where a value is missing and where the heading passes North, so that no stroke crosses
 * the chart.
 */
export function headingStrokes(headings) {
  const strokes = [];
  let last = null;
  headings.forEach((heading, i) => {
    if (heading !== null) {
      if (last === null || Math.abs(heading - last) > 180) strokes.push([]);
      strokes[strokes.length - 1].push(i);
    }
    last = heading;
  });
  return strokes;
}

function headingPaths(plot, series) {
  const stroke = new Path2D();
  for (const indices of headingStrokes(plot.data[series])) {
    indices.forEach((index, i) => {
      const x = plot.valToPos(plot.data[0][index], 'x', true);
      const y = plot.valToPos(plot.data[series][index], 'y', true);
      if (i === 0) stroke.moveTo(x - 1, y);
      stroke.lineTo(x, y);
    });
  }
  return {stroke, fill: null, clip: null, band: null, gaps: null, flags: 0};
}

/** The range of an axis: all values with some air, and never less than `span`. */
export function axisRange(low, high, span, floor = -Infinity) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, span];
  const width = Math.max((high - low) * 1.15, span);
  const middle = (low + high) / 2;
  const begin = Math.max(floor, middle - width / 2);
  return [begin, begin + width];
}

const themeColor = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim() || '#888';

/** One chart with a line that names its series and their values. */
export class TimeChart {
  /**
   * @param options  title, unit, digits, span: the least that the axis covers, inverted: values
   *                 grow downward, isHeading, floor: the axis never begins below,
   *                 series: [{label, color: a custom property of the page, dash, own: its colour
   *                 is what setOwnColor was given}], bars,
   *                 gaps: false draws lines over missing values, metres: the axis is a distance
   */
  constructor(parent, options) {
    this.options = options;
    this.data = [[], ...options.series.map(() => [])];
    this.values = options.series.map(() => element('b'));
    this.swatches = options.series.map((series) => element('i', {
      class: series.dash ? 'swatch dashed' : 'swatch',
      style: `border-color: var(${series.color})`}));
    const names = options.series.map((series, i) => element('span', {class: 'chart-series'},
      this.swatches[i], `${series.label} `, this.values[i]));
    this.when = element('span', {class: 'chart-when'});
    this.place = element('div', {class: 'chart-place'});
    this.root = element('figure', {class: 'chart', 'aria-label': options.title},
      element('figcaption', {}, element('strong', {}, options.title), ...names, this.when),
      this.place);
    parent.append(this.root);
    this.observer = new ResizeObserver(() => this.#fit());
    this.observer.observe(this.place);
  }

  /** @param columns  one array for each series, as long as `t` */
  setData(t, columns) {
    this.data = cleanColumns(t, columns);
    if (!this.plot) this.#make();
    else this.plot.setData(this.data);
    this.#showValues();
  }

  /** Sets the colour of the series that are `own`, "#rrggbb". */
  setOwnColor(color) {
    if (color === this.ownColor) return;
    this.ownColor = color;
    this.options.series.forEach(({own}, i) => {
      if (own) this.swatches[i].style.borderColor = color;
    });
    if (this.plot) this.restyle();
  }

  /** Takes the colours of the page again. */
  restyle() {
    this.plot?.destroy();
    this.plot = null;
    this.#make();
  }

  destroy() {
    this.observer.disconnect();
    this.plot?.destroy();
    this.root.remove();
  }

  #make() {
    const width = this.place.clientWidth;
    if (width < 40) return;
    const {series, span, inverted, floor, bars, isHeading, metres} = this.options;
    const paths = isHeading ? headingPaths : bars ? uPlot.paths.stepped({align: 1}) : undefined;
    const degrees = isHeading ? {incrs: [5, 10, 30, 90, 180],
      values: (_, ticks) => ticks.map((tick) => `${tick}°`)} : {};
    const line = themeColor('--line');
    const axis = {stroke: themeColor('--text-dim'), font: '12px system-ui, sans-serif',
      grid: {stroke: line, width: 1}, ticks: {stroke: line, width: 1}};
    this.plot = new uPlot({
      width, height: kHeight_px, legend: {show: false}, padding: [6, 18, 0, 0],
      cursor: {...(metres ? {} : {sync: {key: 'time'}}), drag: {x: false, y: false}, y: false},
      scales: {
        x: {time: false},
        y: {dir: inverted ? -1 : 1, range: (_, low, high) => axisRange(low, high, span, floor)},
      },
      axes: [
        {...axis, size: 24, space: 60, values: (_, ticks) => ticks.map((x) => (
          metres ? quantity(x, 0, 'm') : missionTime(x, 0)))},
        {...axis, size: 46, space: 24, ...degrees},
      ],
      series: [{}, ...series.map(({label, color, dash, own}) => ({
        label, stroke: own && this.ownColor ? this.ownColor : themeColor(color), width: 2,
        dash: dash ? [6, 4] : undefined,
        spanGaps: this.options.gaps === false,
        points: {show: false},
        paths,
      }))],
      hooks: {setCursor: [() => this.#showValues()]},
    }, this.data, this.place);
  }

  #fit() {
    const width = this.place.clientWidth;
    if (width < 40) return;
    if (!this.plot) this.#make();
    else if (this.plot.width !== width) this.plot.setSize({width, height: kHeight_px});
  }

  /** The values under the cursor, or the last ones. */
  #showValues() {
    const pointed = this.plot?.cursor.idx;
    const isPointed = Number.isInteger(pointed);
    const {digits, unit, metres} = this.options;
    this.values.forEach((value, i) => {
      const column = this.data[i + 1];
      const index = isPointed ? pointed : column.length - 1;
      setText(value, quantity(column[index], digits, unit));
    });
    const at = isPointed ? this.data[0][pointed] : null;
    setText(this.when, !isPointed ? '' : metres ? `at ${quantity(at, 0, 'm')}`
      : `at ${missionTime(at, 1)}`);
  }
}
