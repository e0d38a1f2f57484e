// The page of a campaign's report: numbers, commands, lines, marks and the order of trials.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {cellText, countText, plainValue, replayCommand, shellWord, valueText}
  from '../../../web/campaign/report_numbers.js';
import {caseNotes, kAll, kMaxLines, Report} from '../../../web/campaign/report_data.js';
import {curveMarks, histogramMarks, rangeOf, scaleOf, spread, trialMarks, worstFirst}
  from '../../../web/campaign/report_points.js';
import {cells, headings} from '../../../web/campaign/report_table.js';

const kMetric = {name: 'closest_m', unit: 'm', text: ''};

/** The data of a campaign of `ranges` and two policies with `num` trials of each case. */
function dataOf(ranges, num, outcomes, values) {
  const cases = ranges.flatMap((range) => ['A', 'B'].map((policy) => ({
    id: `${range}${policy}`, values: [range], policy, outcomes: [num, 0, 0, 0], expected: num,
    missing: 0, stopped: false, undecidable: [], share: [1, 0.9, 1, false],
    texts: [`${num}`, '100.00 %'], confidence: 0.95, bound: '',
    metrics: [{mean: [5, 4, 6, false], texts: ['5']}]})));
  const rows = cases.length * num;
  const zeros = Array(rows).fill(0);
  return {
    file: 'a.toml', mission: 'b.toml', dir: '/tmp/a', repetitions: num, confidence: 0.95,
    outcomes: [rows, 0, 0, 0], expected: rows, missing: 0, beyond_stop: 0, stop_metric: '',
    keys: ['comms_range'], axes: [[0]], sampled: ['x'],
    outcome_columns: ['trials', 'passed'], metric_columns: ['mean'],
    metrics: [kMetric], cases,
    trials: {of_case: cases.map(() => num), repetition: zeros.map((_, i) => i % num + 1),
      outcome: outcomes ?? '0'.repeat(rows), why: {texts: [''], of: zeros},
      samples: [{numbers: zeros.map((_, i) => i / 10)}], metrics: [values ?? zeros]},
  };
}
/** Fails where a table of the page has not one heading for each cell of a row. */
function assertFits(report, quantity) {
  assert.equal(headings(report, quantity).length, cells(report, 0, quantity).length);
}
const all = (report) => report.axes.map(() => kAll);

test('a number has five digits, as C writes it', () => {
  for (const [value, text] of [[0, '0'], [-0, '0'], [12.5, '12.5'], [99999.6, '1e+05'],
    [12345, '12345'], [123456, '1.2346e+05'], [0.0001, '0.0001'], [0.00001234, '1.234e-05'],
    [1e300, '1e+300'], [-3.14159265, '-3.1416'], [100, '100'], [NaN, '-'], [null, '-'],
    [Infinity, '-']]) assert.equal(cellText(value), text);
});

test('a value has its unit, and a share is in percent', () => {
  assert.equal(valueText(0.25, {isShare: true}), '25 %');
  assert.equal(valueText(3, kMetric), '3 m');
  assert.equal(valueText(NaN, kMetric), '-');
  assert.equal(countText(1234567), '1,234,567');
});

test('a value of TOML loses its own quotes only', () => {
  assert.equal(plainValue('"nolimit"'), 'nolimit');
  assert.equal(plainValue('250'), '250');
  assert.equal(plainValue('"'), '"');
  assert.equal(plainValue('["previous"]'), '["previous"]');
});

test('a folder is one word of the command whatever it is called', () => {
  assert.equal(replayCommand('/tmp/a', 'db15fbaed0-7'),
    'shoal campaign replay /tmp/a db15fbaed0-7 --view');
  assert.equal(shellWord('/tmp/my runs'), "'/tmp/my runs'");
  assert.equal(shellWord("a'; rm -rf ~; '"), "'a'\\''; rm -rf ~; '\\'''");
  assert.equal(shellWord('$(reboot)'), "'$(reboot)'");
  assert.equal(shellWord('a\nb\\'), "$'a\\x0ab\\\\'");
  assert.equal(shellWord('--out'), "'--out'");
  assert.equal(shellWord(''), "''");
});

test('each column of a table has its heading', () => {
  const report = new Report(dataOf(['50'], 2));
  const [share, metric] = report.quantities;
  assertFits(report, share);
  assertFits(report, metric);
  assert.deepEqual(headings(report, share), ['trials', 'passed', 'notes']);
  assert.deepEqual(cells(report, 0, share).slice(0, 2), ['2', '100.00 %']);
  assert.deepEqual(headings(report, metric), ['mean']);
});

test('lines over an axis are those of the policies', () => {
  const report = new Report(dataOf(['50', '100'], 2));
  const {lines, num} = report.linesOf(report.axes[0], all(report));
  assert.deepEqual(lines, [{title: 'policy=A', cases: [0, 2]}, {title: 'policy=B', cases: [1, 3]}]);
  assert.equal(num, 2);
  const over = report.linesOf(report.axes[1], [1, kAll]);
  assert.deepEqual(over.lines, [{title: 'comms_range=100', cases: [2, 3]}]);
});

test('lines over what is sampled pool the first axis', () => {
  const report = new Report(dataOf(['50', '100'], 2));
  const {lines, pooled} = report.linesOf(null, all(report));
  assert.equal(pooled.name, 'comms_range');
  assert.deepEqual(lines.map(({cases}) => cases), [[0, 2], [1, 3]]);
});

test('no more lines than can be distinguished, and the number of all', () => {
  const report = new Report(dataOf(Array.from({length: 20}, (_, i) => String(i)), 1));
  const {lines, num} = report.linesOf(report.axes[1], all(report));
  assert.equal(lines.length, kMaxLines);
  assert.equal(num, 20);
});

test('an axis is of numbers only where each value is another one', () => {
  const places = (ranges) => new Report(dataOf(ranges, 1)).axes[0];
  assert.deepEqual(places(['50', '1e2']).places, [50, 100]);
  assert.equal(places(['50', '"none"']).isNumeric, false);
  assert.equal(places(['1', '1.0']).isNumeric, false);
  assert.deepEqual(scaleOf(places(['50', '"none"'])).ticks,
    [{at: 0, text: '50'}, {at: 1, text: 'none'}]);
});

test('a point of a curve without an interval stays', () => {
  const data = dataOf(['50', '100'], 1);
  data.cases[0].metrics[0].mean = [5, null, null, false];
  data.cases[1].metrics[0].mean = [null, null, null, false];
  const report = new Report(data);
  const {lines} = report.linesOf(report.axes[0], all(report));
  const marks = curveMarks(report, report.quantities[1], report.axes[0], lines);
  assert.equal(marks.length, 3);
  assert.deepEqual([marks[0].low, marks[0].high, marks[0].number], [5, 5, 0]);
});

test('each trial is a mark or counted as one without a value', () => {
  const report = new Report(dataOf(['50'], 3, '000000', [1, null, 2, 3, 1e300, 4]));
  const {lines} = report.linesOf(null, all(report));
  const {marks, without} = trialMarks(report, report.quantities[1], report.xChoices[2], lines);
  assert.deepEqual(without, [1, 4]);
  assert.deepEqual(marks.map(({row, x, y}) => [row, x, y]),
    [[0, 0, 1], [2, 0.2, 2], [3, 0.3, 3], [5, 0.5, 4]]);
  const shares = trialMarks(report, report.quantities[0], report.xChoices[2], lines);
  assert.equal(shares.marks.length, 6, 'an outcome always is');
});

test('trials of a swept value stay nearer to it than to the next', () => {
  const report = new Report(dataOf(['50', '60', '100'], 50));
  const {lines} = report.linesOf(report.axes[0], all(report));
  const {marks} = trialMarks(report, report.quantities[1], report.xChoices[0], lines);
  for (const {x, row} of marks) {
    assert.ok(Math.abs(x - Number(report.cases[report.caseOfRow[row]].values[0])) < 5, x);
  }
});

test('every value is in one bin, with its trial', () => {
  const values = Array.from({length: 200}, (_, i) => i % 7);
  const report = new Report(dataOf(['50'], 100, undefined, values));
  const {lines} = report.linesOf(report.axes[0], all(report));
  const {marks, most} = histogramMarks(report, report.quantities[1], lines);
  assert.equal(marks.length, 10);
  assert.equal(marks.reduce((sum, mark) => sum + mark.counts[0] + mark.counts[1], 0), 200);
  assert.deepEqual(marks.flatMap(({rows}) => rows).sort((a, b) => a - b),
    values.map((_, i) => i));
  for (const mark of marks) {
    for (const row of mark.rows) {
      assert.ok(mark.begin <= values[row] && values[row] <= mark.end + 1e-9);
    }
  }
  assert.equal(most, Math.max(...marks.flatMap(({counts}) => counts)));
});

test('equal values, and none, are a histogram too', () => {
  const report = new Report(dataOf(['50'], 2, undefined, [3, 3, 3, 3]));
  const {lines} = report.linesOf(report.axes[0], all(report));
  const {marks, range} = histogramMarks(report, report.quantities[1], lines);
  assert.ok(range[0] < 3 && range[1] > 3);
  assert.equal(marks.reduce((sum, mark) => sum + mark.rows.length, 0), 4);
  const empty = new Report(dataOf(['50'], 2, undefined, [null, null, null, null]));
  assert.deepEqual(histogramMarks(empty, empty.quantities[1], lines).marks, []);
});

test('errors, timeouts and fails come first, then what is far from the median', () => {
  const report = new Report(dataOf(['50'], 4, '00012300', [1, 2, 3, 40, null, null, 100, 4]));
  assert.deepEqual(worstFirst(report, [0, 1, 2, 3, 4, 5, 6, 7], report.quantities[1]),
    [4, 5, 3, 6, 0, 1, 2, 7]);
});

test('the spread of points is the same each time and covers its lane', () => {
  const other = Array.from({length: 1000}, (_, i) => spread(i, 1));
  const all_spread = Array.from({length: 1000}, (_, i) => spread(i));
  assert.deepEqual(all_spread, Array.from({length: 1000}, (_, i) => spread(i)));
  assert.ok(Math.min(...all_spread) < -0.45 && Math.max(...all_spread) > 0.45);
  assert.ok(all_spread.every((value) => value >= -0.5 && value < 0.5));
  const product = other.reduce((sum, value, i) => sum + value * all_spread[i], 0) / 1000;
  assert.ok(Math.abs(product) < 0.01, 'the other direction is independent');
});

test('a range holds all its values, and one value is in its middle', () => {
  assert.deepEqual(rangeOf([0, 100], 0.05), [-5, 105]);
  assert.deepEqual(rangeOf([7]), [6.5, 7.5]);
  assert.deepEqual(rangeOf([]), [0, 1]);
});

test('notes state the bound of what was not seen, and what is missing', () => {
  const data = dataOf(['50'], 4);
  Object.assign(data.cases[0], {bound: '53 %', missing: 2, expected: 6});
  assert.deepEqual(caseNotes(new Report(data), 0),
    ['0 of 4 did not pass: below 53 % at 95 %, one-sided', '2 of 6 missing']);
});
