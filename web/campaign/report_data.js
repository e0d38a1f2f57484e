// The results of a campaign as the page has them: cases, their axes, and the trials.

import {canBeDrawn, countText, numberOf, plainValue} from './report_numbers.js';

export const kOutcomes = ['pass', 'fail', 'error', 'timeout'];
export const kMaxLines = 8; // More colours and shapes cannot be distinguished.
export const kAll = -1; // A filter that lets every step through.

/** One axis of the campaign, or the policy: the value of each case is one of its steps. */
function makeAxis(name, texts) {
  const steps = [...new Set(texts)];
  const numbers = steps.map(numberOf);
  const isNumeric = numbers.every(canBeDrawn) && new Set(numbers).size === numbers.length &&
    steps.length > 1;
  return {
    name,
    labels: steps.map(plainValue),
    isNumeric,
    places: isNumeric ? numbers : steps.map((_, i) => i),
    stepOf: texts.map((text) => steps.indexOf(text)),
  };
}

/** Keys that vary together are one axis, which is a number where it has one key. */
function axesOf(data) {
  const axes = data.axes.map((keys) => makeAxis(keys.map((key) => data.keys[key]).join(', '),
    data.cases.map((each) => keys.map((key) => each.values[key] ?? '').join(', '))));
  if (data.cases.some((each) => each.policy !== '')) {
    axes.push(makeAxis('policy', data.cases.map((each) => each.policy)));
  }
  if (axes.length === 0) axes.push(makeAxis('', data.cases.map(() => 'all')));
  return axes;
}

/** Everything that the page shows; `data` is what lib/tools/report/page_data.h writes. */
export class Report {
  constructor(data) {
    this.data = data;
    this.cases = data.cases;
    this.axes = axesOf(data);
    this.quantities = [{name: 'share passed', unit: '%', text: '', isShare: true},
      ...data.metrics.map((metric, i) => ({...metric, isShare: false, metric: i}))];
    this.numRows = data.trials.repetition.length;
    this.caseOfRow = new Uint32Array(this.numRows);
    this.firstRow = [];
    let row = 0;
    data.trials.of_case.forEach((num, i) => {
      this.firstRow.push(row);
      this.caseOfRow.fill(i, row, row + num);
      row += num;
    });
    this.xChoices = [
      ...this.axes.map((axis) => ({kind: 'axis', name: axis.name || 'all trials', axis})),
      ...data.sampled.map((name, sample) => ({kind: 'sample', name, sample})),
      {kind: 'repetition', name: 'repetition'}];
  }

  outcome(row) { return Number(this.data.trials.outcome[row]); }
  why(row) { return this.data.trials.why.texts[this.data.trials.why.of[row]]; }
  trialName(row) {
    return `${this.cases[this.caseOfRow[row]].id}-${this.data.trials.repetition[row]}`;
  }

  /** A trial's value of a quantity; null: it has none. A share's is 1 for a pass, else 0. */
  value(row, quantity) {
    if (quantity.isShare) return this.outcome(row) === 0 ? 1 : 0;
    return this.data.trials.metrics[quantity.metric][row];
  }

  /** A case's estimate of a quantity: value, low and high end, null where there is none. */
  estimate(number, quantity) {
    const each = this.cases[number];
    const [value, low, high, isRepeated] =
      quantity.isShare ? each.share : each.metrics[quantity.metric].mean;
    return {value, low, high, isRepeated};
  }

  /** The rows of a case. */
  rowsOf(number) {
    const first = this.firstRow[number];
    return Array.from({length: this.data.trials.of_case[number]}, (_, i) => first + i);
  }

  /** The names and texts of what was drawn for a trial. */
  samples(row) {
    return this.data.sampled.map((name, i) => {
      const column = this.data.trials.samples[i];
      return {name, text: column.numbers ? String(column.numbers[row]) :
        plainValue(column.texts[column.of[row]])};
    });
  }

  /** The numbers of the cases that all filters let through; a filter is a step of its axis. */
  casesOf(filters) {
    return this.cases.map((_, i) => i).filter((i) => this.axes.every((axis, at) =>
      filters[at] === kAll || axis.stepOf[i] === filters[at]));
  }

  /** "comms.comms_range=50, policy=A" of a case, without some axes; "all trials" of none. */
  caseText(number, without = []) {
    const parts = this.axes
      .filter((axis) => axis.name !== '' && axis.labels.length > 1 && !without.includes(axis))
      .map((axis) => `${axis.name}=${axis.labels[axis.stepOf[number]]}`);
    return parts.join(', ') || 'all trials';
  }

  /**
   * Lines over an axis, or over something else (null): one for each value of the other axes.
   * @returns `lines`: [{title, cases}], `num`: of all lines, of which kMaxLines are in `lines`
   */
  linesOf(x, filters) {
    // Over what belongs to a trial the first axis is pooled, so that lines are of policies.
    const pooled = x ?? (this.axes.length > 1 ? this.axes[0] : null);
    const others = this.axes.filter((axis) => axis !== pooled);
    const lines = new Map();
    for (const number of this.casesOf(filters)) {
      const key = others.map((axis) => axis.stepOf[number]).join(' ');
      if (!lines.has(key)) {
        lines.set(key, {title: this.caseText(number, [pooled]), cases: []});
      }
      lines.get(key).cases.push(number);
    }
    return {lines: [...lines.values()].slice(0, kMaxLines), num: lines.size, pooled};
  }
}

/** What a reader should know of a case beside its numbers, as the text report has it. */
export function caseNotes(report, number) {
  const each = report.cases[number];
  const num = each.outcomes.reduce((sum, count) => sum + count, 0);
  const notes = [];
  if (each.bound) {
    notes.push(`0 of ${countText(num)} ${each.outcomes[0] === num ? 'did not pass' : 'passed'}: ` +
      `below ${each.bound} at ${Number((100 * each.confidence).toPrecision(6))} %, one-sided`);
  }
  if (each.missing > 0) {
    notes.push(`${countText(each.missing)} of ${countText(each.expected)} missing`);
  }
  if (each.stopped) notes.push(`stopped by its rule after ${countText(each.expected)}`);
  if (each.undecidable.length > 0) {
    notes.push(`not decided at the looks ${each.undecidable.join(', ')}: trials have no value of ` +
      `${report.data.stop_metric}`);
  }
  return notes;
}
