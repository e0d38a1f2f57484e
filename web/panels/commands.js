// Orders to vehicles, to the broker and to the mission's clock, and what became of them.

import {failureOf} from '../net/requests.js';
import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {clip, missionTime, quantity} from '../page/text.js';

const kOrders = [
  {name: 'deploy', label: 'Deploy', title: 'start the list of tasks, or go on with it'},
  {name: 'return', label: 'Return', title: 'go home and stay there'},
  {name: 'station_keep', label: 'Station keep', title: 'stay here'},
  {name: 'park', label: 'Park', title: 'end all tasks'},
  {name: 'all_stop', label: 'All-stop', title: 'stop the actuators, until Resume'},
  {name: 'resume', label: 'Resume', title: 'go on after an all-stop'},
];
const kWarps = ['1', '2', '5', '10', '20', '50', 'max'];
const kSigns = {sent: '…', taken: '✓', refused: '✗'};
const kMarkStays_ms = 4000;
const kMaxUnsent = 20;

/** The words of an order to go to a place. */
export const gotoWords = ({x, y}) => ['goto', x.toFixed(1), y.toFixed(1)];

/** A command's state and reason in words. */
export function commandWords({state, reason}) {
  const why = reason ? `: ${clip(reason, 300)}` : '';
  return `${kSigns[state] ?? '?'} ${state}${why}`;
}

export class Commands {
  /** @param onAim  gets the name that a click on the map would send there, or null */
  constructor(page, root, onAim) {
    this.page = page;
    this.onAim = onAim;
    this.aimed = null;
    this.mark = null;
    /** @type {any[]} */
    this.unsent = [];
    this.refusals = 0;
    this.allowed = Boolean(page.setup.commands);
    root.replaceChildren();
    if (!this.allowed) {
      root.append(explanation(page));
      return;
    }
    this.target = element('select', {id: 'command-target', onchange: () => {
      this.#showFactors();
      this.#offerTasks();
      if (!this.target.value.startsWith('group:')) page.select(this.target.value);
    }});
    this.list = element('ol', {id: 'command-list', class: 'commands', 'aria-live': 'polite'});
    this.rows = new KeyedList(this.list, () => commandRow());
    root.append(element('div', {id: 'commands'}, this.#forOne(), this.#forAll(), this.#named(),
      this.#clock(), this.#rules(), element('section', {class: 'sent'}, element('h3', {}, 'Sent'), this.list)));
    this.setVehicles();
  }

  /** Begins with the vehicles of this mission: orders of another are forgotten. */
  setVehicles() {
    if (!this.allowed) return;
    this.unsent = [];
    this.mark = null;
    const kept = this.target.value;
    const {vehicles} = this.page.setup;
    const groups = new Set(vehicles.map(({group}) => group).filter((group) => group));
    this.target.replaceChildren(...vehicles.map(({name}) => element('option', {value: name}, name)),
      ...[...groups].map((group) =>
        element('option', {value: `group:${group}`}, `group ${clip(group, 40)}`)));
    if (kept) this.target.value = kept;
    this.#offerTasks();
  }

  select(name) {
    if (!this.allowed || !name) return;
    this.target.value = name;  // None, where it is not of the mission file: no order goes astray.
    this.#offerTasks();
    this.#showFactors();
  }

  /** Shows what became of the commands. */
  frame(frame) {
    this.last = frame;
    if (!this.allowed) return;
    const all = [...frame.commands, ...this.unsent].sort((a, b) => a.t - b.t || a.id - b.id);
    this.rows?.sync(all.reverse().slice(0, 20), ({id}) => String(id));
    const {clock, rules} = frame;
    setText(this.clockState, clock.state === 'paused' ? 'Paused.'
      : `${clock.state}, ${quantity(clock.factor, 2)} × real time. ${clip(clock.note ?? '', 200)}`);
    for (const {rule, of_vehicle: ofVehicle, now} of this.ruleFields) {
      if (!ofVehicle) setText(now, `now ${clip(rules?.shown?.[rule] ?? '–', 40)}`);
    }
    this.#showFactors();
    this.#ageMark(frame.commands);
  }

  async send(target, words) {
    if (!this.allowed) return null;
    try {
      return await this.page.requests.post('/api/command', {target, words});
    } catch (error) {
      const order = [target, ...words].join(' ');
      this.refusals += 1;
      this.unsent.push({id: -this.refusals, t: this.last?.t ?? 0, text: order, state: 'refused',
        reason: failureOf(error).message});
      this.unsent.splice(0, this.unsent.length - kMaxUnsent);
      if (this.last) this.frame(this.last);
      return null;
    }
  }

  allStop() {
    return this.send('all', ['all_stop']);
  }

  togglePause() {
    return this.send('clock', [this.last?.clock?.state === 'paused' ? 'resume' : 'pause']);
  }

  /** The next click on the map sends the chosen vehicle there; null: not any more. */
  aim(name) {
    if (!this.allowed) return;
    this.aimed = name;
    this.aimButton.setAttribute('aria-pressed', String(name !== null));
    this.onAim(name);
  }

  /** @returns whether the click was an order */
  place({x, y}) {
    if (this.aimed === null || !Number.isFinite(x) || !Number.isFinite(y)) return false;
    const name = this.aimed;
    this.aim(null);
    const mark = {x, y, label: name, id: null, until_ms: Infinity};
    this.mark = mark;
    this.send(name, gotoWords({x, y})).then((answer) => {
      mark.id = answer?.id ?? null;
      if (!answer) mark.until_ms = performance.now() + kMarkStays_ms;
    });
    return true;
  }

  #ageMark(records) {
    const mark = this.mark;
    if (!mark) return;
    const record = records.find(({id}) => id === mark.id);
    if (record && record.state !== 'sent' && mark.until_ms === Infinity) {
      mark.until_ms = performance.now() + kMarkStays_ms;
    }
    if (performance.now() > mark.until_ms) this.mark = null;
  }

  #button(name, label, title, onclick, extra = {}) {
    return element('button', {type: 'button', 'data-command': name, title, onclick, ...extra},
      label);
  }

  /** The tasks of the vehicle that is chosen here, as its list has them. */
  #offerTasks() {
    const vehicle = this.page.setup.vehicles.find(({name}) => name === this.target.value);
    const names = [...new Set((vehicle?.tasks ?? []).map(({name}) => name))];
    this.task.replaceChildren(...names.map((name) => element('option', {value: name}, clip(name, 60))));
    this.taskForm.hidden = names.length === 0;
  }

  /** Orders with a word of their own: a speed, a task by its name. */
  #withWords() {
    this.speed = element('input', {id: 'command-speed', type: 'number', min: 0.1, step: 'any',
      required: true, placeholder: '1.5'});
    this.task = element('select', {id: 'command-task'});
    const form = (id, title, send, ...children) => element('form', {id, title, onsubmit: (event) => {
      event.preventDefault();
      send();
    }}, ...children);
    this.taskForm = form('task-form', 'jump to a task of its list',
      () => this.send(this.target.value, ['task', this.task.value]),
      element('label', {for: 'command-task'}, 'Task'), this.task,
      element('button', {type: 'submit', 'data-command': 'task'}, 'Go to it'));
    return element('div', {class: 'rules'}, form('speed-form', 'go at this speed until the next task',
      () => this.send(this.target.value, ['speed', this.speed.value]),
      element('label', {for: 'command-speed'}, 'Speed'), this.speed, element('span', {}, 'm/s'),
      element('button', {type: 'submit', 'data-command': 'speed'}, 'Set')), this.taskForm);
  }

  #forOne() {
    const buttons = kOrders.map(({name, label, title}) => this.#button(name, label, title,
      () => this.send(this.target.value, [name])));
    this.aimButton = this.#button('goto', 'Send here … (g)', 'then click on the map',
      () => this.aim(this.aimed === null ? this.target.value || null : null), {'aria-pressed': 'false'});
    return element('section', {}, element('label', {class: 'row'}, element('h3', {}, 'Vehicle'),
      this.target),
      element('div', {class: 'buttons'}, buttons, this.aimButton), this.#withWords());
  }

  #forAll() {
    const buttons = kOrders.filter(({name}) => name !== 'all_stop').map(({name, label, title}) =>
      this.#button(`${name}_all`, `${label} all`, title, () => this.send('all', [name])));
    return element('section', {}, element('h3', {}, 'All vehicles'),
      this.#button('all_stop_all', 'ALL-STOP ALL (X)', 'stop the actuators of all vehicles',
        () => this.allStop(), {class: 'danger'}),
      element('div', {class: 'buttons'}, buttons));
  }

  /** A button for each [[order]] of the mission. */
  #named() {
    const buttons = (this.page.setup.orders ?? []).map((name) => this.#button(name, clip(name, 40),
      'an [[order]] of the mission', () => this.send(name, [])));
    return element('section', {hidden: buttons.length === 0}, element('h3', {}, 'Orders of the mission'),
      element('div', {class: 'buttons'}, buttons));
  }

  /** One field for each rule that can change: the server sends their table. */
  #rules() {
    this.ruleFields = this.page.setup.rules.map((row) => this.#ruleField(row));
    const forms = (ofVehicle) => this.ruleFields
      .filter((field) => field.of_vehicle === ofVehicle).map(({form}) => form);
    this.factorsOf = element('h4');
    return element('section', {class: 'rules'}, element('h3', {}, 'Communication rules'),
      this.#button('nolimit', 'Comms range: no limit', 'every vehicle receives every other',
        () => this.send('comms_range', ['nolimit'])),
      ...forms(false), this.factorsOf, ...forms(true));
  }

  #ruleField(row) {
    const id = `rule-${row.rule}`;
    const now = element('span', {class: 'dim now'});
    const input = row.takes_value ? element('input', {id, type: 'text', required: true,
      autocomplete: 'off', placeholder: clip(row.example, 40), title: clip(row.values, 200)}) : null;
    const form = element('form', {title: clip(row.about, 200), onsubmit: (event) => {
      event.preventDefault();
      this.send(row.rule, [...(row.of_vehicle ? [this.target.value] : []),
        ...(input ? [input.value.trim()] : [])]);
    }}, element('label', {for: id}, clip(row.label, 40)), ...(input ? [input] : []),
    element('span', {}, clip(row.unit, 20)),
    element('button', {type: 'submit', 'data-rule': row.rule}, input ? 'Set' : 'Ask'), now);
    return {rule: row.rule, of_vehicle: Boolean(row.of_vehicle), takesValue: Boolean(input), form,
      now};
  }

  #showFactors() {
    const name = this.target.value;
    const factors = this.last?.rules?.factors?.[name];
    setText(this.factorsOf, name ? `Of ${name}` : '');
    for (const {rule, of_vehicle: ofVehicle, takesValue, now} of this.ruleFields) {
      if (ofVehicle && takesValue) setText(now, `now ${quantity(factors?.[rule] ?? 1, 2)}`);
    }
  }

  #clockButton(order, label, title) {
    return element('button', {type: 'button', 'data-clock': order, title,
      onclick: () => this.send('clock', order.split(' '))}, label);
  }

  #clock() {
    this.clockState = element('p', {class: 'dim'});
    const warps = kWarps.map((warp) => (warp === 'max'
      ? this.#clockButton('warp max', 'max', 'as fast as the machine can')
      : this.#clockButton(`warp ${warp}`, `× ${warp}`, `${warp} mission seconds per second`)));
    return element('section', {}, element('h3', {}, 'Mission clock'), this.clockState,
      element('div', {class: 'buttons'},
        this.#clockButton('pause', '❚❚ Pause', 'hold the mission'),
        this.#clockButton('resume', '▶ Resume', 'go on')),
      element('div', {class: 'buttons tight', 'aria-label': 'Warp'}, warps), this.#seek());
  }

  /** Of a playback alone: a mission cannot be moved in time, and refuses it. */
  #seek() {
    const seconds = element('input', {type: 'number', min: 0, step: 'any', 'aria-label':
      'Seconds since the begin of the recording'});
    return element('form', {class: 'buttons', id: 'seek', title: 'of a playback (shoal play)',
      onsubmit: (event) => {
        event.preventDefault();
        if (seconds.value !== '') this.send('clock', ['seek', seconds.value]);
      }}, element('label', {}, 'Playback: go to ', seconds, ' s '),
    element('button', {type: 'submit'}, 'Go'));
  }
}

function explanation(page) {
  const live = 'This page may only look. To let it send commands, start the viewer with '
      + '--allow-commands (shoal run FILE --view --allow-commands, or shoal-viewer '
      + '--allow-commands) and open the address that it prints, with its token.';
  const recorded = 'This is a recorded mission: nothing is there to be commanded.';
  return element('p', {id: 'no-commands', class: 'hint'}, page.isRecorded ? recorded : live);
}

function commandRow() {
  const time = element('time');
  const text = element('span');
  const state = element('b');
  const root = element('li', {}, time, text, state);
  return {
    root,
    update: (record) => {
      setText(time, missionTime(record.t));
      setText(text, clip(record.text, 200));
      setText(state, commandWords(record));
      setAttribute(root, 'data-state', record.state);
    },
  };
}
