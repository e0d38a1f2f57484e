// From results to what charts draw: marks with their places and the trials that they stand for.

import {canBeDrawn, cellText, clipped, countOf, numberOf, plainValue, valueText}
  from './report_numbers.js';
import {kOutcomes} from './report_data.js';

/**
 * A number in [-0.5, 0.5) that depends on `number` and `direction` alone: it spreads points that
 * would lie on others. The hash is the finalizer of MurmurHash3 (Appleby 2011).
 */
export function spread(number, direction = 0) {
  let bits = Math.imul(2 * number + direction + 1, 0x9e3779b1);
  bits = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 32 - 0.5;
}

/** The range of values with some air. */
export function rangeOf(values, air = 0.06) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) return [0, 1];
  const margin = high > low ? air * (high - low) : Math.max(0.5, 0.01 * Math.abs(low));
  return [low - margin, high + margin];
}

/** How an axis of the campaign lies along x: its range, the least gap, and marks that are texts. */
export function scaleOf(axis) {
  const sorted = [...axis.places].sort((a, b) => a - b);
  let gap = sorted.length > 1 ? Infinity : 1;
  for (let i = 1; i < sorted.length; ++i) gap = Math.min(gap, sorted[i] - sorted[i - 1]);
  const low = sorted[0];
  const high = sorted[sorted.length - 1];
  const margin = Math.max(0.5 * gap, 0.04 * (high - low));
  return {range: [low - margin, high + margin], gap, label: axis.name,
    ticks: axis.isNumeric ? null :
      axis.places.map((at, i) => ({at, text: clipped(axis.labels[i], 16)}))};
}

/** The estimates of the cases of each line, with their intervals. */
export function curveMarks(report, quantity, axis, lines) {
  const marks = [];
  lines.forEach((line, i) => {
    for (const number of line.cases) {
      const {value, low, high, isRepeated} = report.estimate(number, quantity);
      if (!canBeDrawn(value)) continue;
      const hasEnds = canBeDrawn(low) && canBeDrawn(high);
      const interval = hasEnds ?
        `, ${valueText(low, quantity)} to ${valueText(high, quantity)}${isRepeated ? ' *' : ''}` : '';
      marks.push({x: axis.places[axis.stepOf[number]], y: value, line: i,
        low: hasEnds ? low : value, high: hasEnds ? high : value, number,
        text: `${report.caseText(number)}: ${valueText(value, quantity)}${interval}`});
    }
  });
  return marks.sort((a, b) => a.x - b.x);
}

/** Where trials lie along x: a function of the row, its line and how many lines there are. */
function placeAlong(report, choice, scale) {
  if (choice.kind === 'repetition') return (row) => report.data.trials.repetition[row];
  if (choice.kind === 'sample') {
    const {numbers, of} = report.data.trials.samples[choice.sample];
    return numbers ? (row) => numbers[row] : (row) => of[row] + 0.6 * spread(row);
  }
  // A lane for each line around the value.
  const {places, stepOf} = choice.axis;
  return (row, line, num) => places[stepOf[report.caseOfRow[row]]] +
    scale.gap * 0.7 * ((line + 0.5 + 0.7 * spread(row)) / num - 0.5);
}

/** How x lies for trials. */
function scaleOfTrials(report, choice) {
  if (choice.kind === 'axis') return scaleOf(choice.axis);
  if (choice.kind === 'repetition') {
    return {range: rangeOf(report.data.trials.repetition, 0.02), label: 'repetition', ticks: null};
  }
  const {numbers, texts} = report.data.trials.samples[choice.sample];
  if (numbers) return {range: rangeOf(numbers, 0.02), label: choice.name, ticks: null};
  const order = texts.map((text, at) => ({at, text: clipped(plainValue(text), 16),
    number: numberOf(text)}));
  return {range: [-0.5, texts.length - 0.5], label: choice.name, ticks: order};
}

/**
 * One mark for each trial that can be drawn. Of a share the mark is at the trial's outcome.
 * @returns `marks`, `scale`: of x, `without`: rows that have no value
 */
export function trialMarks(report, quantity, choice, lines) {
  const scale = scaleOfTrials(report, choice);
  const place = placeAlong(report, choice, scale);
  const marks = [];
  const without = [];
  lines.forEach((line, i) => {
    for (const number of line.cases) {
      const end = report.firstRow[number] + report.data.trials.of_case[number];
      for (let row = report.firstRow[number]; row < end; ++row) {
        const y = quantity.isShare ? 3 - report.outcome(row) + 0.6 * spread(row, 1) :
          report.value(row, quantity);
        if (y === null || !canBeDrawn(y)) without.push(row);
        else marks.push({x: place(row, i, lines.length), y, line: i, row});
      }
    }
  });
  return {marks, scale, without};
}

/** The marks of the y axis of outcomes. */
export const kOutcomeTicks = kOutcomes.map((text, i) => ({at: 3 - i, text}));

/**
 * Counts in bins of equal width, the same for all lines; as many bins as the square root of the
 * values of the largest line, 5 to 60.
 * @returns `marks`: one for each bin, with the counts by line and the rows; `most`: the largest
 *     count; `range`: of the values
 */
export function histogramMarks(report, quantity, lines) {
  const values = lines.map((line) => line.cases.flatMap((number) => report.rowsOf(number))
    .map((row) => ({row, value: report.value(row, quantity)}))
    .filter(({value}) => value !== null && canBeDrawn(value)));
  const largest = Math.max(0, ...values.map((of) => of.length));
  if (largest === 0) return {marks: [], most: 0, range: undefined};
  const all = values.flatMap((of) => of.map(({value}) => value));
  let [low, high] = rangeOf(all, 0);
  if (!(high > low)) [low, high] = rangeOf(all);
  const num = Math.min(60, Math.max(5, Math.floor(Math.sqrt(largest))));
  const edge = (i) => low + (high - low) * i / num;
  const marks = Array.from({length: num}, (_, i) => ({begin: edge(i), end: edge(i + 1),
    x: edge(i + 0.5), y: 0, text: '', counts: lines.map(() => 0), rows: /** @type {any[]} */ ([])}));
  values.forEach((of, line) => {
    for (const {row, value} of of) {
      const bin = Math.min(num - 1, Math.max(0, Math.floor((value - low) / (high - low) * num)));
      ++marks[bin].counts[line];
      marks[bin].rows.push(row);
    }
  });
  for (const mark of marks) {
    mark.y = Math.max(...mark.counts);
    const unit = quantity.unit ? ` ${quantity.unit}` : '';
    mark.text = `${cellText(mark.begin)} to ${cellText(mark.end)}${unit}: ` +
      `${countOf(mark.rows.length, 'trial')}`;
  }
  return {marks, most: Math.max(...marks.map((mark) => mark.y)), range: [low, high]};
}

/**
 * Trials in the order in which a reader wants to see them: errors, timeouts, fails, passes; of
 * these the farthest from the median of the values first.
 */
export function worstFirst(report, rows, quantity) {
  const ranks = [3, 2, 0, 1]; // Of kOutcomes.
  const sorted = rows.map((row) => report.value(row, quantity))
    .filter((value) => value !== null).sort((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  const median = (sorted[Math.floor(middle)] + sorted[Math.ceil(middle)]) / 2;
  const distance = (row) => {
    const value = report.value(row, quantity);
    return value === null || value === median ? 0 : Math.abs(value - median);
  };
  return rows.map((row) => ({row, rank: ranks[report.outcome(row)], distance: distance(row)}))
    .sort((a, b) => a.rank - b.rank || b.distance - a.distance || a.row - b.row)
    .map(({row}) => row);
}
