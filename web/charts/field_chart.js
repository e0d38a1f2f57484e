// One chart of the channels' panel: lines of its numeric fields, and strips of its texts.

import {element, setText} from '../page/dom.js';
import {clip, missionTime, quantity} from '../page/text.js';
import {TimeChart} from './charts.js';
import {commonUnit, hueOf, joinSeries, spansOf} from './field_series.js';

const kColors = ['--chart-1', '--chart-2', '--chart-3', '--chart-4', '--chart-5', '--chart-6',
  '--chart-7', '--chart-8'];
const kMaxSpans = 300;

const shortName = (field) => clip(field, 60);

export class FieldChart {
  /** @param {{remove: (field: string) => void}} actions */
  constructor(fields, actions) {
    this.fields = fields;
    this.chips = element('ul', {class: 'chips'}, fields.map((field, i) => {
      const value = element('b');
      return element('li', {}, element('i', {class: 'swatch',
        style: `border-color: var(${kColors[i]})`}), element('span', {}, shortName(field)), ' ', value,
      element('button', {type: 'button', class: 'small', 'aria-label': `Remove ${clip(field, 100)}`,
        title: 'Remove', onclick: () => actions.remove(field)}, '✕'));
    }));
    this.values = [...this.chips.querySelectorAll('b')];
    this.lines = element('div', {class: 'lines'});
    this.strips = element('div', {class: 'strips'});
    this.root = element('div', {class: 'field-chart', role: 'group',
      'aria-label': `Chart of ${clip(fields.join(', '), 200)}`}, this.chips, this.lines, this.strips);
    this.chart = null;
    this.numeric = '';
  }

  /**
   * Shows answers of /api/series, one for each field; null where there is none.
   * @param now_s  the end of the axis
   */
  update(answers, now_s, window_s) {
    const begin_s = Math.max(0, now_s - window_s);
    const isLine = (answer) => answer !== null && answer.number && answer.t.length > 0;
    const places = answers.map((_, i) => i).filter((i) => isLine(answers[i]));
    answers.forEach((answer, i) => {
      const last = answer?.value?.[answer.value.length - 1];
      setText(this.values[i], answer?.error ? clip(answer.error, 120)
        : answer === null || answer.t.length === 0 ? 'no values'
        : answer.number ? quantity(last, 2, commonUnit([this.fields[i]])) : clip(last, 60));
    });
    this.#showLines(answers, places);
    const texts = answers.map((answer, i) => ({answer, i}))
      .filter(({answer}) => answer !== null && !answer.number && answer.t.length > 0);
    this.strips.replaceChildren(...texts.map(({answer, i}) => (
      this.#strip(this.fields[i], spansOf(answer, now_s), begin_s, now_s))));
  }

  restyle() {
    this.chart?.restyle();
  }

  destroy() {
    this.chart?.destroy();
    this.root.remove();
  }

  #showLines(answers, places) {
    if (places.join() !== this.numeric) {
      this.chart?.destroy();
      this.chart = null;
      this.numeric = places.join();
    }
    if (places.length === 0) return;
    this.chart ??= new TimeChart(this.lines, {
      title: '', unit: commonUnit(places.map((i) => this.fields[i])), digits: 2, span: 0.01, gaps: false,
      series: places.map((i) => ({label: shortName(this.fields[i]), color: kColors[i]})),
    });
    const {t, columns} = joinSeries(places.map((i) => answers[i]));
    this.chart.setData(t, columns);
  }

  #strip(field, spans, begin_s, end_s) {
    const percent = (t) => (100 * (t - begin_s)) / Math.max(1e-9, end_s - begin_s);
    const shown = spans.filter((span) => span.end_s >= begin_s).slice(-kMaxSpans);
    return element('div', {class: 'strip'}, element('span', {class: 'dim'}, shortName(field)),
      element('ol', {}, shown.map((span) => {
        const left = Math.max(0, percent(span.begin_s));
        const text = span.text === '' ? '–' : span.text;
        return element('li', {'data-hue': hueOf(span.text, kColors.length),
          style: `left: ${left}%; width: ${Math.max(0.3, percent(span.end_s) - left)}%`,
          title: `${clip(text, 200)}: ${missionTime(span.begin_s)} to ${missionTime(span.end_s)}`},
        clip(text, 60));
      })));
  }
}
