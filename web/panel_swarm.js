// Whom a vehicle hears, and what it knows of its swarm.

import {element, KeyedList, setText} from './dom.js';
import {age, clip, missionTime, quantity} from './text.js';

/** What a vehicle knows of one of its swarm, in words. */
export function contactWords(contact) {
  const notes = [];
  if (contact.target) notes.push('target');
  if (contact.silent) notes.push('silent');
  if (!contact.heard) notes.push('never heard itself');
  for (const way of contact.recovered ?? []) notes.push(`recovered: ${way}`);
  return notes.join(', ');
}

/** Both as tables. */
export class SwarmTables {
  constructor(onVehicle) {
    this.hears = element('p', {class: 'dim'});
    this.heard = element('tbody');
    this.heardList = new KeyedList(this.heard, (name) => heardRow(name, onVehicle));
    this.said = element('p', {class: 'dim'});
    this.contacts = element('tbody');
    this.contactList = new KeyedList(this.contacts, (name) => contactRow(name));
    this.swarm = element('section', {id: 'swarm', hidden: true},
      element('h4', {}, 'What it knows of its swarm'), this.said,
      element('table', {class: 'plain'}, element('thead', {}, element('tr', {},
        ['Vehicle', 'Age', 'x, y (m), depth', 'Notes'].map((label) =>
          element('th', {scope: 'col'}, label)))), this.contacts));
    this.root = element('div', {}, element('h4', {}, 'Whom it hears'), this.hears,
      element('table', {id: 'hears', class: 'plain'}, this.heard), this.swarm);
  }

  clear() {
    this.heardList.clear();
    this.contactList.clear();
    this.swarm.hidden = true;
    setText(this.hears, '');
  }

  /** @param answer  of /api/vehicle */
  update({t, hears, swarm}) {
    const now = Array.isArray(t) && t.length > 0 ? t[t.length - 1] : null;
    const heard = Array.isArray(hears) ? hears : [];
    setText(this.hears, heard.length === 0 ? 'Nobody, now.' : '');
    this.heardList.sync(heard.map((item) => ({...item, now})), ({name}) => name);
    this.swarm.hidden = !swarm;
    if (!swarm) return;
    setText(this.said, `As of ${missionTime(swarm.t)}; it has said ${swarm.said} messages itself.`);
    this.contactList.sync(swarm.contacts ?? [], ({name}) => name);
  }
}

function heardRow(name, onVehicle) {
  const when = element('td');
  const root = element('tr', {}, element('th', {scope: 'row'}, element('button',
    {type: 'button', class: 'link', onclick: () => onVehicle(name)}, name)), when);
  return {
    root,
    update: ({last_heard_s: heard, now}) => setText(when, heard === null || now === null
      ? 'never' : `${age(now - heard)} ago`),
  };
}

function contactRow(name) {
  const cells = Array.from({length: 3}, () => element('td'));
  return {
    root: element('tr', {}, element('th', {scope: 'row'}, name), cells),
    update: (contact) => {
      const [x, y, depth] = contact.position ?? [];
      setText(cells[0], contact.known ? age(contact.age_s) : 'unknown');
      setText(cells[1], contact.known
        ? `${quantity(x, 0)}, ${quantity(y, 0)}, ${quantity(depth, 0)} m deep` : '–');
      setText(cells[2], clip(contactWords(contact), 120));
    },
  };
}
