// The list of vehicles and, of the chosen one, what it does, its charts and what it knows.

import {TimeChart} from '../charts/charts.js';
import {depthSection, isWorthShowing} from '../charts/depth_section.js';
import {DecisionTable} from './decision.js';
import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {guidanceFacts} from './guidance.js';
import {modemWords} from './modem.js';
import {SwarmTables} from './panel_swarm.js';
import {Poller} from '../net/poller.js';
import {age, clip, heading, quantity, words} from '../page/text.js';
import {groupRow, ListChoice, rowsOf} from './vehicle_list.js';

// Of the list's rows.
const kVehicleKey = 'vehicle ';
const kGroupKey = 'group ';
const kWindows_s = [60, 120, 600, 3600];

/** Why a vehicle does not move, in words; "" where nothing holds it. */
export function allStopWords(helm) {
  if (!helm || typeof helm.all_stop !== 'string') return '';
  if (helm.all_stop === 'all_stop command') return 'by command';
  return helm.all_stop === 'clear' || helm.all_stop === '' ? '' : helm.all_stop;
}

/** What a newcomer should notice about a vehicle: [{sign, text, grave}]. */
export function alarmsOf(vehicle) {
  const alarms = [];
  const stop = allStopWords(vehicle.helm);
  if (vehicle.helm?.state === 'ALL-STOP') {
    alarms.push({sign: '⊗', text: `all-stop: ${stop}`, grave: true});
  } else if (stop !== '') {
    alarms.push({sign: '‖', text: stop, grave: false});
  }
  if (vehicle.stale) alarms.push({sign: '◷', text: 'stale report', grave: false});
  if (vehicle.outside) alarms.push({sign: '*', text: 'not of the mission file', grave: false});
  return alarms;
}

/** Seconds since the report of a vehicle, or null. */
export function reportAge(vehicle, t) {
  return vehicle.report && Number.isFinite(vehicle.report.t) ? t - vehicle.report.t : null;
}

/** What it does: the mode that it reports, or the state of its helm. */
export function modeOf(vehicle) {
  if (vehicle.mode) return vehicle.mode;
  return vehicle.helm ? `${vehicle.helm.state} ${vehicle.helm.task}`.trim() : '';
}

/** The same for a narrow place: driving vehicles by their task alone. */
export const shortMode = (vehicle) => modeOf(vehicle).replace(/^DRIVE[ :](?=.)/, '');

export class VehiclePanel {
  constructor(page, root) {
    this.page = page;
    this.root = root;
    const body = element('tbody');
    this.list = new KeyedList(body, (key) => (key.startsWith(kGroupKey)
      ? groupRow(key.slice(kGroupKey.length), (group) => this.choice.toggleGroup(group))
      : this.#row(key.slice(kVehicleKey.length))));
    this.choice = new ListChoice(() => page.frame && this.#showList(page.frame));
    this.facts = element('dl', {class: 'facts'});
    this.factList = new KeyedList(this.facts, (label) => factRow(label));
    this.titleText = element('span');
    this.titleDot = element('i', {class: 'dot'});
    this.title = element('h3', {id: 'vehicle-title'}, this.titleDot, this.titleText);
    this.alarm = element('p', {id: 'all-stop', class: 'alarm', role: 'status'});
    this.window = element('select', {id: 'window', onchange: () => this.poller.renew()},
      kWindows_s.map((seconds) => element('option', {value: seconds, selected: seconds === 120},
        age(seconds))));
    this.charts = element('div', {class: 'charts'});
    this.decision = new DecisionTable((name) => page.select(name));
    this.swarm = new SwarmTables((name) => page.select(name));
    this.detail = element('section', {id: 'vehicle', hidden: true}, this.title, this.alarm,
      this.facts, this.decision.root, element('label', {class: 'dim'}, 'Charts of the last ', this.window),
      this.charts, this.swarm.root);
    this.hint = element('p', {class: 'hint'},
      'Click a vehicle on the map or in the list, or press ', element('kbd', {}, 'n'), '.');
    root.replaceChildren(
      element('section', {}, element('h3', {}, 'Vehicles'), this.choice.root,
        element('div', {class: 'list-scroll'},
          element('table', {id: 'vehicles', class: 'vehicles'}, element('thead', {}, element('tr', {},
            [['name', 'Name'], ['mode', 'Mode'], ['speed', 'Speed', 'm/s'], ['depth', 'Depth', 'm'],
              ['report', 'Report', 'age']].map((column) => this.choice.head(...column)))), body))),
      this.hint, this.detail);
    /** @type {?Object<string, TimeChart>} */
    this.chart = null;
    this.poller = new Poller(page.isRecorded ? 300 : 500, () => this.#ask(), () => (
      page.isRecorded ? `${page.selected} ${this.window.value}@${page.source.t}` : null));
  }

  show(visible) {
    this.visible = visible;
    if (visible && this.page.selected) this.poller.start();
    else this.poller.stop();
  }

  select(name) {
    this.detail.hidden = !name;
    this.hint.hidden = Boolean(name);
    this.swarm.clear();
    this.factList.clear();
    this.root.classList.toggle('chosen', Boolean(name));
    setText(this.titleText, name ?? '');
    setText(this.alarm, '');
    const chosen = `${kVehicleKey}${name}`;
    for (const [key, row] of this.list.rows) {
      if (!key.startsWith(kVehicleKey)) continue;
      setAttribute(row.root, 'aria-selected', String(key === chosen));
      if (key === chosen) row.root.scrollIntoView({block: 'nearest'});
    }
    this.show(this.visible);
    this.poller.renew();
  }

  /** Shows `frame`; called some times per second while the panel is seen. */
  frame(frame) {
    this.#showList(frame);
    const chosen = frame.vehicles.find(({name}) => name === this.page.selected);
    if (chosen) this.#showFacts(chosen, frame);
  }

  #showList({vehicles, t}) {
    const found = rowsOf(vehicles, t, this.choice);
    this.list.sync(found.rows.map((row) => ({...row, t})), ({vehicle, group}) => (
      vehicle ? `${kVehicleKey}${vehicle.name}` : `${kGroupKey}${group}`));
    this.choice.show(found, vehicles.length);
  }

  reset() {
    this.list.clear();
    this.select(this.page.selected);
  }

  restyle() {
    this.#colorCharts();
    for (const chart of Object.values(this.chart ?? {})) chart.restyle();
  }

  #row(name) {
    const swatch = element('i', {class: 'dot'});
    const cells = Array.from({length: 4}, () => element('td'));
    const mark = element('b', {class: 'mark'});
    const choose = element('button', {type: 'button', 'data-vehicle': name,
      onclick: () => this.page.select(name)}, swatch, element('span', {}, name), ' ', mark);
    const selected = String(name === this.page.selected);
    const root = element('tr', {'aria-selected': selected},
      element('th', {scope: 'row'}, choose), cells);
    const [mode, speed, depth, report] = cells;
    report.classList.add('report');
    return {
      root,
      update: ({vehicle, t}) => {
        swatch.style.background = this.page.color(vehicle);
        const alarms = alarmsOf(vehicle);
        setText(mark, alarms.map(({sign}) => sign).join(''));
        setAttribute(choose, 'title', [name, ...alarms.map(({text}) => text)].join('; '));
        setAttribute(root, 'data-grave', alarms.some(({grave}) => grave) ? 'true' : null);
        setAttribute(root, 'data-stale', vehicle.stale ? 'true' : null);
        setText(mode, clip(shortMode(vehicle), 40) || '–');
        setAttribute(mode, 'title', clip(modeOf(vehicle)) || null);
        setText(speed, quantity(vehicle.nav?.speed, 1));
        setText(depth, quantity(vehicle.nav?.depth, 1));
        const old_s = reportAge(vehicle, t);
        setText(report, vehicle.stale ? `stale ${age(old_s)}` : age(old_s));
      },
    };
  }

  #showFacts(vehicle, frame) {
    const {nav, report, helm} = vehicle;
    this.titleDot.style.background = this.page.color(vehicle);
    const alarms = alarmsOf(vehicle);
    setText(this.alarm, alarms.map(({sign, text}) => `${sign} ${clip(text, 200)}`).join('   '));
    setAttribute(this.alarm, 'data-grave', alarms.some(({grave}) => grave) ? 'true' : null);
    const factors = frame.rules?.factors?.[vehicle.name];
    const facts = [
      ['State', helm ? helm.state : '–'],
      ['Task', helm?.task ? `${helm.task} (${words(helm.kind)})` : 'none'],
      ['Waypoint', helm?.to ? `no. ${helm.waypoint + 1}, ${quantity(helm.distance, 1, 'm')} to go, `
        + `${quantity(helm.cross_track, 1, 'm')} off the leg` : 'none'],
      ['Position', nav ? `x ${quantity(nav.x, 1)}, y ${quantity(nav.y, 1)} m` : '–'],
      ...(vehicle.navigation ? [['Believed', navigationWords(vehicle.navigation, nav)]] : []),
      ['Depth', quantity(nav?.depth, 1, 'm') + (Number.isFinite(nav?.altitude)
        ? `, ${quantity(nav.altitude, 1, 'm')} above the floor` : '')],
      ['Heading', `${heading(nav?.heading)}, over ground ${heading(nav?.course)}`],
      ['Speed', `${quantity(nav?.speed, 2, 'm/s')}, over ground ${quantity(nav?.sog, 2, 'm/s')}`],
      ['Last report', report ? `no. ${report.index}, ${age(frame.t - report.t)} old`
        + `${vehicle.stale ? ', STALE' : ''}` : 'none'],
      ['Kind', [vehicle.type, vehicle.group && `group ${vehicle.group}`,
        factors && `stealth ${factors.stealth}, earange ${factors.earange}`]
        .filter(Boolean).join(', ')],
      ...guidanceFacts(vehicle, frame.t),
      ...(vehicle.modem ? [['Modem', modemWords(vehicle.modem, frame.t)]] : []),
    ];
    this.factList.sync(facts, ([label]) => label);
    this.decision.update(vehicle.decision, frame.t);
  }

  async #ask() {
    const name = this.page.selected;
    if (!name) return;
    const answer = await this.page.requests.get('/api/vehicle',
      {name, window: this.window.value, ...this.page.query()});
    if (name !== this.page.selected) return;
    this.chart ??= this.#makeCharts();
    this.#colorCharts();
    const {t} = answer;
    this.chart.heading.setData(t, [answer.heading, answer.desired_heading]);
    this.chart.speed.setData(t, [answer.speed, answer.desired_speed]);
    this.chart.depth.setData(t, [answer.depth, answer.desired_depth]);
    const section = depthSection(answer, this.page.world.trail(name, this.#now()),
      this.page.setup.floor);
    this.chart.section.root.hidden = !isWorthShowing(section);
    this.chart.section.setData(section.way_m, [section.depth, section.desired, section.floor]);
    this.swarm.update(answer);
  }

  /** The time that the map shows. */
  #now() {
    return this.page.isRecorded ? this.page.source.t : this.page.frame?.t ?? 0;
  }

  // What the vehicle does has its colour, as on the map.
  #colorCharts() {
    const known = this.page.frame?.vehicles.find(({name}) => name === this.page.selected);
    if (!known) return;
    for (const chart of Object.values(this.chart ?? {})) {
      chart.setOwnColor(this.page.color(known));
    }
  }

  #makeCharts() {
    const series = [{label: 'is', color: '--chart-1', own: true},
      {label: 'desired', color: '--chart-2', dash: true}];
    const chart = (options) => new TimeChart(this.charts, {...options, series});
    return {
      heading: chart({title: 'Heading', unit: '°', digits: 1, span: 20, isHeading: true}),
      speed: chart({title: 'Speed', unit: 'm/s', digits: 2, span: 1}),
      depth: chart({title: 'Depth', unit: 'm', digits: 1, span: 2, inverted: true}),
      section: new TimeChart(this.charts, {title: 'Depth along the track', unit: 'm', digits: 1,
        span: 2, inverted: true, metres: true, series: [...series,
          {label: 'floor', color: '--chart-6'}]}),
    };
  }
}

/** Where it believes to be, how well it knows, and how far off it is. */
function navigationWords({x, y, major, minor, lock, fix}, nav) {
  const error = nav ? `, ${quantity(Math.hypot(x - nav.x, y - nav.y), 1, 'm')} off` : '';
  return `x ${quantity(x, 1)}, y ${quantity(y, 1)} m, 95 % within `
    + `${quantity(major, 1)} × ${quantity(minor, 1, 'm')}${error}; `
    + `bottom lock ${lock ? 'yes' : 'no'}, GPS ${fix ? 'fix' : 'none'}`;
}

function factRow(label) {
  const value = element('dd');
  const root = element('div', {}, element('dt', {}, label), value);
  return {root, update: ([, text]) => setText(value, clip(text, 200))};
}
