// The trials that stand behind a point, a bar or a row, each with the command that replays it.

import {element, setText} from '../page/dom.js';
import {clipped, countOf, countText, replayCommand, valueText} from './report_numbers.js';
import {kOutcomes} from './report_data.js';
import {worstFirst} from './report_points.js';

const kMaxListed = 100;
const kLongestWhy = 600;
const kSigns = ['✓', '✗', '⚠', '◷'];

/** Copies a text; returns whether the browser did. */
async function copy(text, node) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // A browser without that leave may still copy what is selected.
    globalThis.getSelection()?.selectAllChildren(node);
    return document.execCommand('copy');
  }
}

export class TrialList {
  constructor(root, report) {
    this.root = root;
    this.report = report;
    this.head = element('h2', {}, 'Trials');
    this.about = element('p', {class: 'dim'},
      'Click a point, a bar or a row of the table to list its trials.');
    this.list = element('ol');
    this.more = element('p', {class: 'dim'});
    root.append(this.head, this.about, this.list, this.more);
  }

  /** Lists trials, the worst first. */
  show(title, rows, quantity) {
    const sorted = worstFirst(this.report, rows, quantity);
    const counts = kOutcomes.map((name, outcome) =>
      `${countText(rows.filter((row) => this.report.outcome(row) === outcome).length)} ${name}`);
    setText(this.head, title);
    setText(this.about, `${countOf(rows.length, 'trial')}: ${counts.join(', ')}. A click on a ` +
      'command copies it.');
    this.list.replaceChildren(
      ...sorted.slice(0, kMaxListed).map((row) => this.#item(row, quantity)));
    const rest = sorted.length - kMaxListed;
    setText(this.more, rest > 0 ?
      `and ${countText(rest)} more: results.csv of the folder has all` : '');
    this.root.scrollTop = 0;
  }

  #item(row, quantity) {
    const {report} = this;
    const outcome = kOutcomes[report.outcome(row)];
    const facts = [report.caseText(report.caseOfRow[row]),
      ...report.samples(row).map(({name, text}) => `${name}=${text}`)];
    const command = replayCommand(report.data.dir, report.trialName(row));
    const code = element('code', {}, command);
    const state = element('span', {class: 'copied', role: 'status'});
    const button = element('button', {type: 'button', class: 'command', title: 'Copy',
      onclick: async () => setText(state, await copy(command, code) ? 'copied' : 'selected')},
    code);
    const values = report.quantities
      .filter((each) => !each.isShare && (quantity.isShare || each === quantity))
      .map((each) => `${each.name} ${valueText(report.value(row, each) ?? NaN, each)}`);
    return element('li', {'data-outcome': outcome},
      element('p', {}, element('b', {class: 'outcome'}, `${kSigns[report.outcome(row)]} ${outcome}`),
        ` ${report.trialName(row)} `, state),
      element('p', {class: 'dim'}, clipped(facts.join(', '), kLongestWhy)),
      values.length > 0 ? element('p', {}, clipped(values.join(', '), kLongestWhy)) : null,
      report.why(row) ?
        element('p', {class: 'why'}, clipped(report.why(row), kLongestWhy)) : null,
      button);
  }
}
