// Puts the page together: asks for the mission, then lets source, map and panels know of one
// another.

import {tidyEvents, tidySetup, withoutMissingHelms} from './net/answers.js';
import {setCauses} from './page/causes.js';
import {setVehicles, vehicleColor} from './page/colors.js';
import {Commands} from './panels/commands.js';
import {byId, setText} from './page/dom.js';
import {BackgroundDesk} from './page/background_desk.js';
import {fillHelp} from './page/help.js';
import {listenToKeys, showPressed} from './page/keys.js';
import {MapFilm} from './map/map_film.js';
import {MapView} from './map/map_view.js';
import {CommsPanel} from './panels/panel_comms.js';
import {DataPanel} from './panels/panel_data.js';
import {PlanPanel} from './plan/panel_plan.js';
import {EventsPanel} from './panels/panel_events.js';
import {StatusPanel} from './panels/panel_status.js';
import {VehiclePanel} from './panels/panel_vehicle.js';
import {recordingInPage} from './net/page_recording.js';
import {failureOf, openStream, Requests} from './net/requests.js';
import {LiveSource, RecordedSource} from './net/source.js';
import {Tabs} from './page/tabs.js';
import {fileName, missionTime, quantity} from './page/text.js';
import {Timeline} from './page/timeline.js';
import {TopBar} from './page/top_bar.js';
import {ViewKeeper} from './page/view_keeper.js';
import {World} from './map/world.js';
import {tidyVerdict, VerdictBox} from './panels/verdict.js';

const kPanelEvery_ms = 200;
const kRetry_ms = 1000;
const kNearEvent_s = 10;
// Of the session: the mission that was followed has ended, and its recording is shown.
const kEndedKey = 'shoal-ended';
const kVerdictTries = 8;

const pause = (ms) => new Promise((done) => { setTimeout(done, ms); });

class Page {
  constructor(requests) {
    this.requests = requests;
    // Made by begin(), with the first setup.
    /** @type {any} By name: each has show(), some reset() and restyle(). */
    this.panels = {};
    /** @type {any} */
    this.commands = null;
    /** @type {any} */
    this.world = null;
    /** @type {any} */
    this.setup = null;
    /** @type {any} LiveSource or, with isRecorded, RecordedSource. */
    this.source = null;
    this.frame = null;
    this.wanted = null;  // {name, t}: a vehicle to centre on when its frame has come.
    this.selected = null;
    this.link = null;
    this.frames = 0;
    this.panels_ms = -Infinity;
    this.numEvents = null;
    this.connection = ['connecting', ''];
    this.top = new TopBar((name, on) => this.setLayer(name, on),
        (style) => this.setPulseStyle(style), (files) => this.backgrounds.put(files));
    this.tabs = new Tabs(byId('side'), () => this.#showPanels());
    this.map = new MapView(byId('map'), {
      onVehicle: (name) => this.#clickVehicle(name),
      onPlace: (place) => this.commands?.place(place),
      onPointer: (place) => this.#showPointer(place),
      onView: () => this.keeper?.changed(),
    });
    this.backgrounds = new BackgroundDesk(this, byId('stage'));
    this.film = new MapFilm(byId('map'), (film) => {
      this.map.titled = false;
      this.#download(film, 'webm');
    });
    this.verdict = new VerdictBox(byId('verdict'));
    this.keeper = new ViewKeeper(this);
    fillHelp(byId('help'));
    listenToKeys(this);
  }

  /** Begins with the mission that `setup` describes. */
  begin(setup) {
    this.setup = setup;
    setCauses(setup.causes);
    setVehicles(setup.vehicles);
    // Before a mission there is one moment, which is asked for like those of a recording.
    this.isPlanned = setup.mode === 'planned';
    this.isRecorded = setup.mode === 'recorded' || this.isPlanned;
    const listener = {
      onFrame: (frame) => this.#takeFrame(frame),
      onSetup: (other) => this.#turnTo(other),
      onReconnected: () => this.#askTrails(),
      onConnection: (...connection) => {
        this.connection = connection;
        this.top.showConnection(...connection, this.frame?.clock);
      },
      onPlay: () => this.keeper.changed(),
      onIndexing: (share) => this.top.showIndexing(share),
    };
    this.source = this.isRecorded ? new RecordedSource(setup, this.requests, listener)
      : new LiveSource(setup, this.requests, listener, openStream);
    if (this.isRecorded && !this.isPlanned) this.timeline = new Timeline(byId('timeline'), this.source);
    this.panels = {
      vehicle: new VehiclePanel(this, byId('panel-vehicle')),
      comms: new CommsPanel(this, byId('panel-comms')),
      data: new DataPanel(this, byId('panel-data')),
      status: new StatusPanel(this, byId('panel-status')),
      events: new EventsPanel(this, byId('panel-events')),
      plan: new PlanPanel(this, byId('panel-plan')),
    };
    this.commands = new Commands(this, byId('panel-commands'), (name) => this.#showAim(name));
    const hasEnded = this.isRecorded && sessionStorage.getItem(kEndedKey) !== null;
    sessionStorage.removeItem(kEndedKey);
    this.#showMission();
    this.keeper.restore();
    if (hasEnded) this.source.seek(setup.end_s);
    if (this.isRecorded && !this.isPlanned) this.#askVerdict(hasEnded, 1);
    this.source.start();
    requestAnimationFrame(() => this.#draw());
  }

  /** What to add to a question: the time, where it is a recorded mission. */
  query() {
    return this.source.query();
  }

  names() {
    return (this.frame?.vehicles ?? this.setup.vehicles).map(({name}) => name);
  }

  color({name, color}) {
    return vehicleColor(name, color);
  }

  select(name) {
    if (this.selected === name) return;
    this.selected = name;
    this.map.select(name);
    this.panels.vehicle.select(name);
    this.panels.data.select(name);
    this.commands.select(name);
    if (this.frame) this.panels.vehicle.frame(this.frame);
    this.keeper.changed();
  }

  openLink(from, to) {
    this.link = from === null ? null : {from, to};
    this.panels.comms.openLink(this.link);
    this.map.setLink(this.link);
    this.keeper.changed();
  }

  goToEvent(event) {
    const [name] = event.vehicles ?? [];
    if (this.isRecorded) this.source.seek(event.t);
    if (!this.names().includes(name)) return;
    this.select(name);
    if (this.isRecorded) this.wanted = {name, t: this.source.t};
    else this.map.centre(name);
  }

  jump(direction, onlyGrave) {
    const event = this.timeline?.jump(direction, onlyGrave);
    if (event) this.select(event.vehicles?.[0] ?? this.selected);
  }

  setLayer(name, on) {
    this.map.view = {layers: {[name]: on}};
    this.top.showLayers(this.map.view.layers);
    this.keeper.changed();
  }

  setPulseStyle(pulseStyle) {
    this.map.view = {pulseStyle};
    this.top.showPulseStyle(pulseStyle);
    this.keeper.changed();
  }

  setTheme(theme) {
    document.documentElement.className = theme;
    for (const panel of Object.values(this.panels)) panel.restyle?.();
    this.keeper.changed();
  }

  async savePng() {
    this.#download(await this.map.toPng(), 'png');
  }

  /** Begins a film of the map, of a recording that plays; or ends and saves it. */
  toggleFilm() {
    if (this.film.isRunning) {
      this.film.stop();
      return;
    }
    this.map.titled = this.film.start();
    if (this.map.titled && this.isRecorded && !this.source.playing) this.source.play();
  }

  #download(blob, ending) {
    const time = missionTime(this.frame?.t ?? 0).replaceAll(':', '-');
    this.download(blob, `${fileName(this.setup.mission)}_${time}.${ending}`);
  }

  /** Saves bytes as a file of the user's. */
  download(blob, name) {
    const url = URL.createObjectURL(blob);
    const link = document.createElement('a');
    link.href = url;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  }

  #clickVehicle(name) {
    const vehicle = this.frame?.vehicles.find((one) => one.name === name);
    if (vehicle?.nav && this.commands.place(vehicle.nav)) return;
    this.select(name);
    if (name && this.tabs.current !== 'commands') this.tabs.show('vehicle');
  }

  // Only the frame at an event's time knows where its vehicle was.
  #centreWanted(frame) {
    const {name, t} = /** @type {{name: string, t: number}} */ (this.wanted);
    const {got_t, playing} = this.source;
    const isElsewhere = Math.abs(this.source.t - t) > kNearEvent_s;
    if (!isElsewhere && (playing ? got_t < t : got_t !== t)) return;
    this.wanted = null;
    if (isElsewhere) return;
    const vehicle = frame.vehicles.find((one) => one.name === name);
    const place = vehicle?.nav ?? vehicle?.report;
    if (place) this.map.view = {cx: place.x, cy: place.y};
  }

  #takeFrame(come) {
    const frame = {...come, vehicles: withoutMissingHelms(come.vehicles, this.setup)};
    this.frame = frame;
    this.frames += 1;
    this.world.addFrame(frame, performance.now());
    if (this.wanted) this.#centreWanted(frame);
    if (this.frames === 1) this.keeper.firstFrame();
    this.top.showConnection(...this.connection, frame.clock);
    if (frame.clock.state === 'ended' && !this.ended) this.#askVerdict(true, kVerdictTries);
    this.ended = frame.clock.state === 'ended';
    if (frame.num_events !== this.numEvents && !this.isRecorded) {
      this.numEvents = frame.num_events;
      this.#askEvents();
    }
  }

  /** The viewer was started again, or turned to another mission. */
  #turnTo(setup) {
    if (setup.mode !== this.setup.mode || setup.mode === 'recorded'
        || setup.commands !== this.setup.commands) {
      if (this.setup.mode === 'live' && setup.mode === 'recorded') {
        sessionStorage.setItem(kEndedKey, '1');
      }
      location.reload();
      return;
    }
    this.setup = setup;
    setCauses(setup.causes);
    setVehicles(setup.vehicles);
    this.frame = null;
    this.numEvents = null;
    this.ended = false;
    this.verdict.show(null, false);
    this.top.showResult(null);
    this.openLink(null, null);
    this.#showMission();
    for (const panel of Object.values(this.panels)) panel.reset();
    this.commands.setVehicles();
    if (!setup.vehicles.some(({name}) => name === this.selected)) this.select(null);
    this.map.fit();
  }

  #showMission() {
    this.world = new World(this.setup);
    this.map.setWorld(this.world, this.setup);
    this.top.setup(this.setup);
    this.#askTrails();
    this.#askEvents();
    this.backgrounds.ask();
  }

  async #askTrails() {
    const world = this.world;
    try {
      world.addTrails(await this.requests.get('/api/trails'));
    } catch {
      await pause(kRetry_ms);
      if (world === this.world && this.connection[0] === 'live') this.#askTrails();
    }
  }

  // The launcher leaves the verdict a moment after the clock has ended.
  async #askVerdict(open, tries) {
    const world = this.world;
    for (let i = 0; i < tries && world === this.world; ++i) {
      try {
        const verdict = tidyVerdict(await this.requests.get('/api/verdict'));
        if (world !== this.world) return;
        if (verdict) {
          this.verdict.show(verdict, open);
          this.top.showResult(verdict.result);
          return;
        }
      } catch {
        // Another try.
      }
      await pause(kRetry_ms);
    }
  }

  async #askEvents() {
    const asked = this.numEvents;
    try {
      const known = tidyEvents(await this.requests.get('/api/events'));
      this.panels.events.update(known);
      this.map.setEvents(known);
    } catch {
      await pause(kRetry_ms);
      if (asked === this.numEvents) this.#askEvents();
    }
  }

  #showPanels() {
    for (const [name, panel] of Object.entries(this.panels)) {
      panel.show(name === this.tabs.current);
    }
    this.panels_ms = -Infinity;
    this.keeper?.changed();
  }

  #showPointer(place) {
    setText(byId('pointer'), !place ? ''
      : `x ${quantity(place.x, 1)}  y ${quantity(place.y, 1)} m   `
        + `${quantity(place.lat, 6)}°  ${quantity(place.lon, 6)}°`);
  }

  #showAim(name) {
    byId('aim').hidden = name === null;
    setText(byId('aim'), name === null ? '' : `Click where ${name} is to go. Esc: not at all.`);
    byId('stage').classList.toggle('aiming', name !== null);
  }

  #draw() {
    requestAnimationFrame(() => this.#draw());
    const now_ms = performance.now();
    if (this.isRecorded) {
      this.source.tick();
      this.world.setTime(this.source.t);
      this.timeline?.update();
      if (this.film.isRunning && this.source.t >= this.setup.end_s) this.film.stop();
    }
    this.map.setMark(this.commands.mark);
    this.map.draw(now_ms);
    if (this.frame) {
      // Recorded, the time line moves on while a frame is asked for: one time for both clocks.
      const t = this.isRecorded ? this.source.t : this.frame.t;
      this.top.frame(t, this.frame.clock, this.isRecorded ? this.source : null);
      if (now_ms - this.panels_ms > kPanelEvery_ms) {
        this.panels_ms = now_ms;
        if (this.tabs.current === 'vehicle') this.panels.vehicle.frame(this.frame);
        if (this.tabs.current === 'events') this.panels.events.mark(this.frame.t);
        this.commands.frame(this.frame);
        showPressed(this);
      }
      this.keeper.tick();
    }
  }
}

async function start() {
  const requests = await recordingInPage()
    ?? new Requests(new URLSearchParams(location.search).get('token') ?? '');
  const page = new Page(requests);
  Object.assign(window, {shoalViewer: page});  // For those who look from the console, and tests.
  for (;;) {
    try {
      page.begin(tidySetup(await requests.get('/api/setup')));
      return;
    } catch (error) {
      const {status, message} = failureOf(error);
      if (status === undefined) throw error;
      page.top.showConnection('lost', message, null);
      await pause(kRetry_ms);
    }
  }
}

start();
