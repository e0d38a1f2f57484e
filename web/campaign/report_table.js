// The table of the cases: the numbers of the text report.

import {element} from '../page/dom.js';
import {countOf} from './report_numbers.js';
import {caseNotes} from './report_data.js';

const kMaxRows = 500;

/** Columns come from lib/tools/report/report_columns.cc, but for the notes. */
export function headings(report, quantity) {
  const {data} = report;
  return quantity.isShare ? [...data.outcome_columns, 'notes'] : data.metric_columns;
}

export function cells(report, number, quantity) {
  const each = report.cases[number];
  if (!quantity.isShare) return each.metrics[quantity.metric].texts;
  return [...each.texts, caseNotes(report, number).join('; ')];
}

/** Makes the table again. `onPick(number)` is called with the case of a row. */
export function showTable(root, report, quantity, numbers, onPick) {
  const names = report.axes.map((axis) => axis.name || 'case');
  const rows = numbers.slice(0, kMaxRows).map((number) => {
    const labels = report.axes.map((axis) => axis.labels[axis.stepOf[number]]);
    return element('tr', {onclick: () => onPick(number)},
      labels.map((label, i) => element('th', {scope: 'row'}, i > 0 ? label :
        element('button', {type: 'button', class: 'link', title: 'List the trials'}, label))),
      cells(report, number, quantity).map((text) => element('td', {}, String(text))));
  });
  const rest = numbers.length - kMaxRows;
  const unit = quantity.isShare || !quantity.unit ? '' : ` [${quantity.unit}]`;
  root.replaceChildren(
    element('h2', {}, `Cases: ${quantity.name}${unit}`),
    element('div', {class: 'wide', tabindex: '0', role: 'region', 'aria-label': 'Table of cases'},
      element('table', {},
        element('thead', {}, element('tr', {}, [...names, ...headings(report, quantity)]
          .map((text) => element('th', {scope: 'col'}, text)))),
        element('tbody', {}, rows))),
    element('p', {class: 'dim'}, rest > 0 ?
      `${countOf(rest, 'case')} more: choose values above, or see \`report --all\`` : ''));
}
