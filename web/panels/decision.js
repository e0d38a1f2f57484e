// Why a vehicle with behaviors steers as it does: its aims, what each wanted and what it gave up.

import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {age, clip, quantity, words} from '../page/text.js';

/** A decision older than this no longer counts: the task alone steers, or the vehicle is parked. */
const kOld_s = 3;

const isPoint = (value) => Number.isFinite(value) && value >= 0;

/** A choice in words: "74°, 2.0 m/s"; a value below 0 stands for any. */
export function choiceWords({course, speed, depth}) {
  const parts = [];
  if (isPoint(course)) parts.push(`${quantity(course, 0)}°`);
  if (isPoint(speed)) parts.push(quantity(speed, 1, 'm/s'));
  if (isPoint(depth)) parts.push(quantity(depth, 1, 'm deep'));
  return parts.join(', ') || 'any';
}

/** Its part toward a contact: "give-way:stern toward ben (rule 15/16), 48.2 m, CPA 3.1 m, 0.4 s old". */
export function roleWords(aim) {
  if (!aim.contact) return '';
  const rule = aim.rule ? ` (rule ${clip(aim.rule, 20)})` : '';
  const parts = [`${clip(words(aim.role), 40)} toward ${clip(aim.contact, 40)}${rule}`];
  if (isPoint(aim.range)) parts.push(quantity(aim.range, 1, 'm'));
  if (isPoint(aim.cpa)) parts.push(`CPA ${quantity(aim.cpa, 1, 'm')}`);
  if (isPoint(aim.age)) parts.push(`known ${age(aim.age)} ago`);
  return parts.join(', ');
}

/** What it gave up: "18.9 of 100"; "–" where it has no preference now. */
export function lossWords(aim) {
  return aim.weight > 0 ? quantity(aim.loss, 1) : '–';
}

/** The decision as a table, hidden where there is none that counts. */
export class DecisionTable {
  constructor(onVehicle) {
    this.summary = element('p', {class: 'dim'});
    const body = element('tbody');
    this.list = new KeyedList(body, (name) => aimRow(name, onVehicle));
    this.root = element('section', {id: 'decision', hidden: true},
      element('h4', {}, 'Why it steers so'), this.summary,
      element('table', {class: 'plain'}, element('thead', {}, element('tr', {},
        ['Behavior', 'Weight', 'Wants', 'Loses', 'Part'].map((label) =>
          element('th', {scope: 'col'}, label)))), body));
  }

  update(decision, t) {
    const counts = Boolean(decision) && Math.abs(t - decision.t) <= kOld_s;
    this.root.hidden = !counts;
    if (!counts) return;
    const chosen = decision.all_stop === 'clear' ? `Chosen: ${choiceWords(decision)}`
      : `Stands still: ${clip(decision.all_stop, 80)}`;
    setText(this.summary, decision.mode ? `${chosen}; mode ${clip(decision.mode, 80)}` : chosen);
    this.list.sync(decision.aims ?? [], ({name}) => name);
  }
}

function aimRow(name, onVehicle) {
  const cells = Array.from({length: 4}, () => element('td'));
  const [weight, wants, loss, part] = cells;
  const root = element('tr', {}, element('th', {scope: 'row'}, clip(name, 40)), cells);
  part.addEventListener('click', () => {
    if (part.dataset.contact) onVehicle(part.dataset.contact);
  });
  return {
    root,
    update: (aim) => {
      setText(weight, aim.weight > 0 ? quantity(aim.weight, 0) : '–');
      setText(wants, aim.weight > 0 ? choiceWords(aim) : '–');
      setText(loss, lossWords(aim));
      setText(part, roleWords(aim) || clip(aim.state, 80));
      setAttribute(part, 'data-contact', aim.contact || null);
      setAttribute(root, 'title', `${clip(aim.kind, 40)}: ${clip(aim.state, 80)}`);
    },
  };
}
