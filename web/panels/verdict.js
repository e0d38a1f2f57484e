// The verdict on a mission that has ended: PASS or FAIL, every expectation with its number and its
// margin.

import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {clip, quantity} from '../page/text.js';

/** A number with digits enough to distinguish it from zero. */
function measured(value, unit) {
  const size = Math.abs(value);
  const digits = Number.isInteger(value) ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : 4;
  return quantity(value, digits, unit || undefined);
}

/** "margin 2.25 m", "missed by 1 s"; "" where there is no number. */
export function marginWords({passed, margin, unit}) {
  if (!Number.isFinite(margin)) return '';
  return margin >= 0 || passed ? `margin ${measured(Math.abs(margin), clip(unit ?? '', 20))}`
    : `missed by ${measured(-margin, clip(unit ?? '', 20))}`;
}

/** "ended: FAIL: 1 of 2 expectations missed". */
export function resultWords({result, why}) {
  return `ended: ${clip(result, 20)}${why ? `: ${clip(why, 200)}` : ''}`;
}

/** A verdict in a shape that the page can rely on; null for what is none. */
export function tidyVerdict(answer) {
  const verdict = answer?.verdict;
  if (typeof verdict?.result !== 'string') return null;
  const lines = Array.isArray(verdict.expectations) ? verdict.expectations : [];
  return {...verdict, expectations: lines.filter((line) => typeof line?.text === 'string')};
}

export class VerdictBox {
  /** @param root  a <details> */
  constructor(root) {
    this.root = root;
    this.title = element('strong');
    this.list = element('ol');
    this.rows = new KeyedList(this.list, () => expectationRow());
    this.none = element('p', {class: 'dim'}, 'The mission has no [[expect]].');
    root.replaceChildren(element('summary', {}, this.title), this.list, this.none);
    root.hidden = true;
  }

  get isOpen() { return this.root.open && !this.root.hidden; }

  close() { this.root.open = false; }

  /** @param verdict  of tidyVerdict; null: not known @param open  what it is about is to be seen */
  show(verdict, open) {
    this.root.hidden = verdict === null;
    if (verdict === null) return;
    setText(this.title, resultWords(verdict));
    setAttribute(this.root, 'data-result', clip(verdict.result, 20));
    const missedFirst = verdict.expectations.map((line, i) => ({...line, key: String(i)}))
      .sort((a, b) => Number(Boolean(a.passed)) - Number(Boolean(b.passed)));
    this.rows.sync(missedFirst.slice(0, 500), ({key}) => key);
    this.none.hidden = missedFirst.length > 0;
    this.root.open = open;
  }
}

function expectationRow() {
  const sign = element('b', {class: 'sign'});
  const text = element('span');
  const numbers = element('span', {class: 'dim'});
  const margin = element('strong');
  const root = element('li', {}, sign, element('div', {}, text, ' ', margin, ' ', numbers));
  return {
    root,
    update: (line) => {
      setText(sign, line.passed ? '✓' : '✗');
      setAttribute(root, 'data-passed', String(Boolean(line.passed)));
      setText(text, `${clip(line.text, 300)}:`);
      setText(margin, marginWords(line));
      setText(numbers, clip(line.numbers ?? '', 500));
      setAttribute(root, 'title', clip(line.where ?? '', 200) || null);
    },
  };
}
