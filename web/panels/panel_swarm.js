// From which vehicles a vehicle receives, and what it knows of its swarm.

import {element, KeyedList, setText} from '../page/dom.js';
import {age, clip, missionTime, quantity} from '../page/text.js';

/** What a vehicle knows of one of its swarm, in words. */
export function contactWords(contact) {
  const notes = [];
  if (contact.target) notes.push('target');
  if (contact.silent) notes.push('silent');
  if (!contact.received) notes.push('never received itself');
  for (const way of contact.recovered ?? []) notes.push(`recovered: ${way}`);
  return notes.join(', ');
}

/** Both as tables. */
export class SwarmTables {
  constructor(onVehicle) {
    this.note = element('p', {class: 'dim'});
    this.received = element('tbody');
    this.receivedList = new KeyedList(this.received, (name) => receivedRow(name, onVehicle));
    this.sent = element('p', {class: 'dim'});
    this.contacts = element('tbody');
    this.contactList = new KeyedList(this.contacts, (name) => contactRow(name));
    this.swarm = element('section', {id: 'swarm', hidden: true},
      element('h4', {}, 'What it knows of its swarm'), this.sent,
      element('table', {class: 'plain'}, element('thead', {}, element('tr', {},
        ['Vehicle', 'Age', 'x, y (m), depth', 'Notes'].map((label) =>
          element('th', {scope: 'col'}, label)))), this.contacts));
    this.root = element('div', {}, element('h4', {}, 'It receives from'), this.note,
      element('table', {id: 'receives', class: 'plain'}, this.received), this.swarm);
  }

  clear() {
    this.receivedList.clear();
    this.contactList.clear();
    this.swarm.hidden = true;
    setText(this.note, '');
  }

  /** @param answer  of /api/vehicle */
  update({t, receives_from: links, swarm}) {
    const now = Array.isArray(t) && t.length > 0 ? t[t.length - 1] : null;
    const received = Array.isArray(links) ? links : [];
    setText(this.note, received.length === 0 ? 'No vehicle, now.' : '');
    this.receivedList.sync(received.map((item) => ({...item, now})), ({name}) => name);
    this.swarm.hidden = !swarm;
    if (!swarm) return;
    setText(this.sent, `As of ${missionTime(swarm.t)}; it has sent ${swarm.num_sent} messages itself.`);
    this.contactList.sync(swarm.contacts ?? [], ({name}) => name);
  }
}

function receivedRow(name, onVehicle) {
  const when = element('td');
  const root = element('tr', {}, element('th', {scope: 'row'}, element('button',
    {type: 'button', class: 'link', onclick: () => onVehicle(name)}, name)), when);
  return {
    root,
    update: ({last_received_s: last, now}) => setText(when, last === null || now === null
      ? 'never' : `${age(now - last)} ago`),
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
