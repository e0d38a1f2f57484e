// The page of a campaign's report.

import {byId, element, setText} from '../page/dom.js';
import {caseNotes, kAll, kOutcomes, Report} from './report_data.js';
import {clipped, countOf, countText, valueText} from './report_numbers.js';
import {curveMarks, histogramMarks, kOutcomeTicks, rangeOf, scaleOf, trialMarks}
  from './report_points.js';
import {drawSample} from './report_drawing.js';
import {lineColors, ReportChart} from './report_chart.js';
import {TrialList} from './report_trials.js';
import {showTable} from './report_table.js';


class ReportPage {
  constructor(report) {
    this.report = report;
    this.choice = {quantity: 0, x: 0, filters: report.axes.map(() => kAll)};
    this.trials = new TrialList(byId('trials'), report);
    const parent = byId('charts');
    this.charts = {
      curve: new ReportChart(parent, 'curve', ([mark]) => this.#listCase(mark.number)),
      trials: new ReportChart(parent, 'trials', (marks) => this.#list(
        marks.length === 1 ? this.report.trialName(marks[0].row) : 'Trials at this point',
        marks.map((mark) => mark.row))),
      bins: new ReportChart(parent, 'bins', ([mark]) =>
        this.#list(`${this.#quantity().name} ${mark.text.split(':')[0]}`, mark.rows)),
    };
    this.#head();
    this.#makeChoices();
    byId('report').hidden = false;
    this.show();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.show());
  }

  #quantity() { return this.report.quantities[this.choice.quantity]; }

  #head() {
    const {data} = this.report;
    const counts = kOutcomes.map((name, i) => element('span', {'data-outcome': data.outcomes[i] > 0 ? name : null},
      `${countText(data.outcomes[i])} ${name}`));
    const num = data.outcomes.reduce((sum, count) => sum + count, 0);
    setText(byId('file'), data.file);
    byId('counts').append(`${countText(num)} of ${countOf(data.expected, 'trial')}: `, ...counts,
      element('span', {'data-outcome': data.missing > 0 ? 'error' : null},
        `${countText(data.missing)} missing`));
    const stop = data.stop_metric === '' ? '' :
      '; those with a star hold at all looks together (repeated)';
    const beyond = data.beyond_stop > 0 ? ` ${countOf(data.beyond_stop, 'trial')} beyond the look ` +
      'at which their case stopped: not on this page.' : '';
    setText(byId('about'), `${countOf(data.cases.length, 'case')} of ` +
      `${countOf(data.repetitions, 'repetition')} of ${data.mission}. Intervals have a ` +
      `confidence of ${Number((100 * data.confidence).toPrecision(6))} %${stop}.${beyond}`);
  }

  #makeChoices() {
    const select = (label, texts, id, first, set) => element('label', {}, `${label} `,
      element('select', {id, onchange: (event) => {
        set(Number(event.target.value));
        this.show();
      }}, texts.map((text, i) => element('option', {value: i + first}, clipped(text, 60)))));
    const {report, choice} = this;
    const axes = report.axes.map((axis, i) => axis.labels.length < 2 ? null :
      select(axis.name, ['all', ...axis.labels], `filter-${i}`, kAll,
        (step) => { choice.filters[i] = step; }));
    byId('choices').append(
      select('Show', report.quantities.map(({name, unit, isShare}) =>
        unit && !isShare ? `${name} [${unit}]` : name), 'quantity', 0,
      (number) => { choice.quantity = number; }),
      select('over', report.xChoices.map(({name}) => name), 'over', 0,
        (number) => { choice.x = number; }),
      ...axes.filter((each) => each));
    byId('choices').addEventListener('submit', (event) => event.preventDefault());
  }

  show() {
    const {report, choice, charts} = this;
    const quantity = this.#quantity();
    const x = report.xChoices[choice.x];
    const {lines, num, pooled} = report.linesOf(x.axis ?? null, choice.filters);
    const label = quantity.unit && !quantity.isShare ? `${quantity.name} [${quantity.unit}]` :
      quantity.name;
    this.#legend(lines, num, quantity);
    charts.curve.show(x.kind === 'axis' ? this.#curveView(quantity, x.axis, lines, label) : null);
    charts.trials.show(this.#trialsView(quantity, x, lines, label));
    charts.bins.show(quantity.isShare ? null : this.#binsView(quantity, lines, label, pooled));
    showTable(byId('cases'), report, quantity, report.casesOf(choice.filters),
      (number) => this.#listCase(number));
  }

  #legend(lines, num, quantity) {
    const colors = lineColors();
    const items = lines.map((line, i) => {
      const canvas = element('canvas', {'aria-hidden': 'true'});
      drawSample(canvas, i, colors[i]);
      return element('span', {class: 'line'}, canvas, ` ${line.title}`);
    });
    byId('legend').replaceChildren(
      ...(quantity.text ? [element('p', {class: 'dim'}, quantity.text)] : []),
      ...(lines.length > 1 ? items : []),
      ...(num > lines.length ? [element('span', {class: 'dim'},
        `${lines.length} of ${num} lines are drawn: choose values above to see others`)] : []));
  }

  #curveView(quantity, axis, lines, label) {
    const marks = curveMarks(this.report, quantity, axis, lines);
    const percent = Number((100 * this.report.data.confidence).toPrecision(6));
    return {kind: 'curve', marks, lines, isJoined: axis.name !== 'policy' && axis.name !== '',
      title: quantity.isShare ? 'Share passed' : `Mean of ${quantity.name}`,
      note: `with intervals at ${percent} %`, x: scaleOf(axis), textOf: (mark) => mark.text,
      y: {range: quantity.isShare ? [-0.03, 1.03] :
        rangeOf(marks.flatMap(({low, high}) => [low, high])), label, isShare: quantity.isShare}};
  }

  #trialsView(quantity, x, lines, label) {
    const {report} = this;
    const {marks, scale, without} = trialMarks(report, quantity, x, lines);
    return {kind: 'trials', marks, lines, title: 'Trials', x: scale,
      note: without.length === 0 ? '✗ fail, □ error or timeout' :
        `${countOf(without.length, 'trial')} without a value not drawn; ✗ fail, □ error or timeout`,
      outcomeOf: (row) => report.outcome(row),
      textOf: ({row}) => this.#trialText(row, quantity),
      y: quantity.isShare ? {range: [-0.5, 3.5], label: 'outcome', ticks: kOutcomeTicks} :
        {range: rangeOf(marks.map(({y}) => y)), label}};
  }

  #trialText(row, quantity) {
    const value = quantity.isShare ? '' :
      `, ${quantity.name} ${valueText(this.report.value(row, quantity), quantity)}`;
    return `${this.report.trialName(row)}, ${this.report.caseText(this.report.caseOfRow[row])}: ` +
      `${kOutcomes[this.report.outcome(row)]}${value}`;
  }

  #binsView(quantity, lines, label, pooled) {
    const {marks, most, range} = histogramMarks(this.report, quantity, lines);
    const isPooled = pooled && pooled.labels.length > 1 &&
      this.choice.filters[this.report.axes.indexOf(pooled)] === kAll;
    return {kind: 'bins', marks, lines, title: `Values of ${quantity.name}`,
      note: isPooled ? `all values of ${pooled.name} together` : '',
      textOf: (mark) => mark.text + (lines.length < 2 ? '' :
        ` (${lines.map(({title}, i) => `${mark.counts[i]} ${title}`).join('; ')})`),
      x: {range: range ?? [0, 1], label},
      y: {range: [0, Math.max(1, most) * 1.08], label: 'trials', isCount: true}};
  }

  #listCase(number) {
    const notes = caseNotes(this.report, number);
    this.#list(this.report.caseText(number) + (notes.length > 0 ? ` (${notes.join('; ')})` : ''),
      this.report.rowsOf(number));
  }

  #list(title, rows) { this.trials.show(title, rows, this.#quantity()); }
}

globalThis.shoalReport = new ReportPage(new Report(JSON.parse(byId('data').textContent ?? '')));
