// Collisions, groundings, all-stops, waypoints, contacts: a list, each a place to go to.

import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {isGrave} from '../net/source.js';
import {clip, missionTime, words} from '../page/text.js';

const kSigns = {
  collision: '✸', aground: '⏚', all_stop: '⊗', cleared: '▷', first_contact: '⇄', lost_contact: '⇎',
  contact_again: '⇄', waypoint: '⚑',
};

export const eventSign = (event) => kSigns[event.kind] ?? '•';

export class EventsPanel {
  constructor(page, root) {
    this.page = page;
    this.events = [];
    this.onlyGrave = element('input', {type: 'checkbox', id: 'events-grave',
      onchange: () => this.#show()});
    this.note = element('p', {class: 'dim'});
    this.list = element('ol', {id: 'events', class: 'events'});
    this.rows = new KeyedList(this.list, () => this.#row());
    root.replaceChildren(element('section', {}, element('h3', {}, 'What happened'),
      element('p', {class: 'dim'}, page.isRecorded ? 'Click an event to go to its time.'
        : 'Click an event to centre the map on its vehicle.'),
      element('label', {}, this.onlyGrave, ' only collisions, groundings and all-stops'), this.note,
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
      this.last = last?.root;
    }
  }

  #show() {
    const shown = this.events.filter((event) => !this.onlyGrave.checked || isGrave(event));
    const newestFirst = this.page.isRecorded ? shown : [...shown].reverse();
    this.rows.sync(newestFirst.slice(0, 1000), (event) => String(event.id));
    setText(this.note, shown.length === 0 ? 'Nothing yet.'
      : `${shown.length} events${shown.length > 1000 ? ', 1000 of them shown' : ''}.`);
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
