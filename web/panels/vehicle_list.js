// Which vehicles the list shows, and in which order: search, sort, groups.

import {element, setAttribute, setText} from '../page/dom.js';
import {clip} from '../page/text.js';

// A list of few needs no search.
const kFew = 12;
/** More rows than this are not shown at once: what is sought is found by its name. */
export const kMaxRows = 400;

const kOrder = new Intl.Collator('en', {numeric: true, sensitivity: 'base'});

/** What a list can be sorted by: name to (vehicle, t) -> text or number; null goes last. */
export const kSortKeys = {
  name: (vehicle) => vehicle.name,
  mode: (vehicle) => vehicle.mode || vehicle.helm?.task || null,
  speed: (vehicle) => vehicle.nav?.speed ?? null,
  depth: (vehicle) => vehicle.nav?.depth ?? null,
  report: (vehicle, t) => (Number.isFinite(vehicle.report?.t) ? t - vehicle.report.t : null),
};

function compared(a, b) {
  if (a === null || b === null) return Number(a === null) - Number(b === null);
  return typeof a === 'number' && typeof b === 'number' ? a - b : kOrder.compare(a, b);
}

/**
 * Returns the rows of the list: {vehicle} and, where there are groups, {group, count, isOpen} before
 * its vehicles; at most kMaxRows of vehicles, and `left_out`, how many more there are. `closed` is
 * a Set of groups.
 */
export function rowsOf(vehicles, t, {text, sort, isDown, closed}) {
  const wanted = String(text ?? '').trim().toLowerCase();
  let chosen = vehicles.filter(({name, type, group, mode}) => wanted === ''
      || [name, type, group, mode].some((word) => String(word ?? '').toLowerCase().includes(wanted)));
  const keyOf = Object.hasOwn(kSortKeys, sort ?? '') ? kSortKeys[sort] : null;
  if (keyOf) {
    chosen = chosen.map((vehicle) => ({vehicle, key: keyOf(vehicle, t)}))
      .sort((a, b) => (a.key === null || b.key === null ? compared(a.key, b.key)
        : (isDown ? -1 : 1) * compared(a.key, b.key)))
      .map(({vehicle}) => vehicle);
  }
  const groups = new Map();
  for (const vehicle of chosen) {
    const group = vehicle.group || '';
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push(vehicle);
  }
  const rows = [];
  let [shown, hidden] = [0, 0];
  const add = (list) => {
    for (const vehicle of list) {
      if (shown < kMaxRows) rows.push({vehicle});
      shown += 1;
    }
  };
  const hasGroups = new Set(vehicles.map(({group}) => group || '')).size > 1;
  if (!hasGroups) {
    add(chosen);
  } else {
    for (const [group, members] of groups) {
      const isOpen = !closed.has(group);
      rows.push({group, count: members.length, isOpen});
      if (isOpen) add(members);
      else hidden += members.length;
    }
  }
  return {rows, left_out: Math.max(0, shown - kMaxRows), num_found: chosen.length, hidden};
}

/** The choice of a user: a field to search in, and the heads of the columns. */
export class ListChoice {
  constructor(onChange) {
    this.onChange = onChange;
    this.sort = null;
    this.isDown = false;
    this.closed = new Set();
    this.search = element('input', {type: 'search', id: 'vehicle-search', oninput: onChange,
      placeholder: 'search: name, type, group, mode', 'aria-label': 'Search vehicles'});
    this.note = element('span', {class: 'dim'});
    this.root = element('div', {class: 'filters', hidden: true}, this.search, this.note);
    this.heads = new Map();
  }

  get text() { return this.search.value; }

  /** Makes the head of a column that sorts by `key`. */
  head(key, label, unit) {
    const head = element('th', {scope: 'col'}, element('button', {type: 'button', class: 'link',
      'data-sort': key, title: `Sort by ${label.toLowerCase()}`, onclick: () => this.#sortBy(key)},
    label, unit ? element('small', {}, ` ${unit}`) : null));
    this.heads.set(key, head);
    return head;
  }

  /** Another click turns the order round, a third one goes back to that of the mission. */
  #sortBy(key) {
    if (this.sort !== key) [this.sort, this.isDown] = [key, false];
    else if (!this.isDown) this.isDown = true;
    else this.sort = null;
    for (const [name, head] of this.heads) {
      setAttribute(head, 'aria-sort', name !== this.sort ? null
        : this.isDown ? 'descending' : 'ascending');
    }
    this.onChange();
  }

  toggleGroup(group) {
    if (!this.closed.delete(group)) this.closed.add(group);
    this.onChange();
  }

  /** @param found  of rowsOf */
  show(found, num_vehicles) {
    this.root.hidden = num_vehicles <= kFew && this.text === '';
    const {num_found: count, left_out: more} = found;
    setText(this.note, more > 0 ? `${count} found, ${more} not shown`
      : this.text === '' ? `${num_vehicles}` : `${count} of ${num_vehicles}`);
  }
}

/** The row of a group, which opens and closes it. */
export function groupRow(group, onToggle) {
  const label = element('span');
  const button = element('button', {type: 'button', 'data-group': group,
    onclick: () => onToggle(group)}, label);
  return {
    root: element('tr', {class: 'group'}, element('th', {scope: 'rowgroup', colspan: '5'}, button)),
    update: ({count, isOpen}) => {
      setText(label, `${isOpen ? '▾' : '▸'} ${clip(group, 60) || 'no group'} (${count})`);
      setAttribute(button, 'aria-expanded', String(isOpen));
    },
  };
}
