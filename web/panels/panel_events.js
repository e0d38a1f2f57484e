// What happened: a list, each a place to go to.

import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {isGrave} from '../net/source.js';
import {clip, missionTime, words} from '../page/text.js';

const kSigns = {
  collision: '✸', aground: '⏚', all_stop: '⊗', cleared: '▷', first_contact: '⇄', lost_contact: '⇎',
  contact_again: '⇄', waypoint: '⚑', deployed: '▶', parked: '‖', task: '≔', message: '✉',
  message_lost: '✗', surfaced: '⇧', fix: '⌖', role: '⚓', replanned: '✎', mission: '◆', met: '✓', missed: '✗',
};

export const eventSign = (event) => kSigns[event.kind] ?? '•';

/** What a user can choose to see: [name, label, kinds]; without kinds all. */
export const kEventGroups = [
  ['all', 'all events', null],
  ['grave', 'trouble', ['collision', 'aground', 'all_stop', 'cleared', 'missed']],
  ['course', 'deployed, tasks, waypoints, surfaced',
    ['deployed', 'parked', 'task', 'replanned', 'waypoint', 'surfaced', 'fix']],
  ['messages', 'messages', ['message', 'message_lost']],
  ['contacts', 'contacts by comms', ['first_contact', 'lost_contact', 'contact_again']],
  ['encounters', 'encounters', ['role', 'collision']],
  ['mission', 'the mission: its events, its verdict', ['mission', 'met', 'missed']],
];

/** Returns the events of a group, of a vehicle ("" of all), whose text has the words. */
export function chosenEvents(events, {group, vehicle, text}) {
  const kinds = kEventGroups.find(([name]) => name === group)?.[2] ?? null;
  const wanted = String(text ?? '').trim().toLowerCase();
  return events.filter((event) => (!kinds || kinds.includes(event.kind))
      && (!vehicle || event.vehicles.includes(vehicle))
      && (wanted === '' || `${words(event.kind)} ${event.text}`.toLowerCase().includes(wanted)));
}

export class EventsPanel {
  constructor(page, root) {
    this.page = page;
    this.events = [];
    const changed = () => this.#show();
    this.group = element('select', {id: 'events-group', 'aria-label': 'Kinds of events',
      onchange: changed}, kEventGroups.map(([name, label]) =>
      element('option', {value: name}, label)));
    this.vehicle = element('select', {id: 'events-vehicle', 'aria-label': 'Vehicle',
      onchange: changed});
    this.text = element('input', {type: 'search', id: 'events-text', placeholder: 'search',
      'aria-label': 'Words in the text', oninput: changed});
    this.note = element('p', {class: 'dim'});
    this.list = element('ol', {id: 'events', class: 'events'});
    this.rows = new KeyedList(this.list, () => this.#row());
    root.replaceChildren(element('section', {}, element('h3', {}, 'What happened'),
      element('p', {class: 'dim'}, page.isRecorded ? 'Click an event to go to its time.'
        : 'Click an event to centre the map on its vehicle.'),
      element('div', {class: 'filters'}, this.group, this.vehicle, this.text), this.note,
      this.list));
  }

  show() {}

  reset() {
    this.update([]);
  }

  update(events) {
    this.events = events;
    this.#show();
  }

  /** Marks the events that are over at `t`, and brings the last of them into sight. */
  mark(t) {
    let last = null;
    for (const {root, event} of this.rows.rows.values()) {
      const past = event().t <= t;
      setAttribute(root, 'data-future', past ? null : 'true');
      if (past && (last === null || event().t >= last.event().t)) last = {root, event};
    }
    if (this.last !== last?.root) {
      this.last?.removeAttribute('aria-current');
      last?.root.setAttribute('aria-current', 'true');
      // Not under a pointer that is about to click.
      if (this.page.isRecorded && !this.list.matches(':hover')) {
        last?.root.scrollIntoView({block: 'nearest'});
      }
      this.last = last?.root;
    }
  }

  #show() {
    this.#offerVehicles();
    const shown = chosenEvents(this.events,
      {group: this.group.value, vehicle: this.vehicle.value, text: this.text.value});
    this.page.timeline?.setEvents(shown);
    const newestFirst = this.page.isRecorded ? shown : [...shown].reverse();
    this.rows.sync(newestFirst.slice(0, 1000), (event) => String(event.id));
    setText(this.note, shown.length === 0 ? 'Nothing yet.'
      : `${shown.length} events${shown.length > 1000 ? ', 1000 of them shown' : ''}.`);
  }

  #offerVehicles() {
    const names = [...new Set(this.events.flatMap(({vehicles}) => vehicles))]
      .filter((name) => typeof name === 'string').sort().slice(0, 1000);
    if (this.offered === names.join('\n')) return;
    this.offered = names.join('\n');
    const chosen = this.vehicle.value;
    this.vehicle.replaceChildren(element('option', {value: ''}, 'all vehicles'),
      ...names.map((name) => element('option', {value: name}, clip(name, 64))));
    this.vehicle.value = names.includes(chosen) ? chosen : '';
  }

  #row() {
    let event = null;
    const sign = element('b', {class: 'sign', 'aria-hidden': 'true'});
    const time = element('time');
    const kind = element('strong');
    const text = element('span');
    const root = element('li', {}, element('button', {type: 'button',
      onclick: () => this.page.goToEvent(event)}, sign, time, element('span', {}, kind, text)));
    return {
      root,
      event: () => event,
      update: (item) => {
        if (event === item) return;
        event = item;
        root.dataset.kind = clip(item.kind, 40);
        setAttribute(root, 'data-grave', isGrave(item) ? 'true' : null);
        setText(sign, eventSign(item));
        setText(time, missionTime(item.t));
        const name = words(clip(item.kind, 40));
        setText(kind, String(item.text).includes(name) ? '' : name);
        setText(text, ` ${clip(item.text)}`);
      },
    };
  }
}
