// The line above the map: mission, time, state of the clock, connection; and the layers' menu.

import {byId, element, setAttribute, setText} from './dom.js';
import {kPulseStyles} from '../map/draw_signals.js';
import {clip, missionTime, quantity} from './text.js';

const kStates = {
  waiting: '… waiting for a mission', gathering: '… starting', running: '● running',
  paused: '❚❚ paused', ended: '■ ended', lost: '⚠ launcher gone',
  silent: '⚠ launcher silent', recorded: '● recorded',
  planned: '✎ does not run yet',
};

/** The layers in the order of their keys 1 to 9, 0; those behind have none. */
export const kLayers = [
  ['trails', 'Trails: where vehicles were'],
  ['reported', 'Reported positions, with their age'],
  ['tasks', 'Waypoints and legs'],
  ['ranges', 'Comms range circles'],
  ['pulses', 'Comms pulses'],
  ['rings', 'Acoustic packets as rings'],
  ['contours', 'Depth contours of the floor'],
  ['area', 'Areas: of operations, surveyed, covered'],
  ['grid', 'Grid'],
  ['names', 'Names, modes, depths'],
  ['drawings', 'Drawings of programs'],
  ['background', 'Background: charts, tiles, coasts'],
];

const kNumKeys = 10;

/** State and speed of the mission's clock, in words. */
export function clockWords(clock) {
  const state = kStates[clock?.state] ?? clip(clock?.state ?? '–', 40);
  if (clock?.state !== 'running') return state;
  const factor = Number.isFinite(clock.factor) ? ` ${quantity(clock.factor, 2)} × real time` : '';
  const wanted = clock.warp === 0 ? ' (of max)'
    : Number.isFinite(clock.warp) && clock.warp !== 1 ? ` (of ${clock.warp} ×)` : '';
  return state + factor + wanted;
}

/** The text across the map, or "". */
export function bannerWords(clock, connection, reason) {
  if (connection === 'lost' && clock?.state === 'ended') {
    return 'The mission has ended, and so has its viewer; this is the last that was seen.';
  }
  if (connection === 'lost') {
    return `Connection lost (${clip(reason, 200)}). Trying again; the page goes on by itself.`;
  }
  switch (clock?.state) {
    case 'waiting':
      return 'No mission is running. Start one: shoal run missions/berta.toml';
    case 'gathering': {
      const awaited = Array.isArray(clock.awaited) ? clock.awaited : [];
      const more = awaited.length > 5 ? ` and ${awaited.length - 5} more` : '';
      return awaited.length === 0 ? 'The mission starts.'
        : `The mission starts; awaited: ${clip(awaited.slice(0, 5).join(', '), 200)}${more}.`;
    }
    case 'paused': return 'Paused.';
    case 'ended': return '';  // The verdict is shown.
    case 'silent': return 'The launcher has been silent for three seconds: is it stopped?';
    case 'lost': return 'The launcher has gone without an end; this is the last that was seen.';
    default: return '';
  }
}

const kConnections = {connecting: '… connecting', live: '● live', lost: '⚠ connection lost'};

export class TopBar {
  constructor(onLayer, onPulseStyle, onFiles) {
    const find = byId;
    this.mission = find('mission');
    this.clock = find('clock-time');
    this.state = find('clock-state');
    this.connection = find('connection');
    this.banner = find('banner');
    this.layers = /** @type {HTMLDetailsElement} */ (find('layers'));
    this.boxes = new Map();
    const rows = kLayers.map(([name, label], i) => {
      const box = element('input', {type: 'checkbox', 'data-layer': name,
        onchange: () => onLayer(name, box.checked)});
      this.boxes.set(name, box);
      const key = i < kNumKeys ? element('kbd', {}, String((i + 1) % kNumKeys)) : null;
      return element('label', {}, box, key, ` ${label}`);
    });
    this.pulseStyle = element('select', {id: 'pulse-style', 'aria-label': 'How pulses are drawn',
      onchange: () => onPulseStyle(this.pulseStyle.value)},
    kPulseStyles.map(([style, label]) => element('option', {value: style}, label)));
    const place = kLayers.findIndex(([name]) => name === 'pulses') + 1;
    rows.splice(place, 0, element('div', {class: 'choice'}, this.pulseStyle));
    this.file = element('input', {type: 'file', id: 'background-file', multiple: true,
      accept: '.geojson,.json,.tif,.tiff,.png,.jpg,.jpeg,.webp,.pgw,.jgw,.wld,.mbtiles',
      'aria-label': 'Add a background',
      onchange: () => onFiles(this.file.files)});
    this.remove = element('button', {type: 'button', id: 'background-remove', hidden: true,
      onclick: () => onFiles(null)}, 'Remove');
    this.folder = element('input', {type: 'file', id: 'background-folder', webkitdirectory: true,
      'aria-label': 'Add a folder of tiles', title: 'A folder of tiles: zoom/column/row.png',
      onchange: () => onFiles(this.folder.files)});
    rows.push(element('div', {class: 'choice'}, this.file, this.remove),
      element('label', {class: 'choice'}, 'Folder of tiles ', this.folder));
    this.layers.querySelector('fieldset')?.replaceChildren(...rows);
    document.addEventListener('pointerdown', (event) => {
      if (!this.layers.contains(/** @type {Node} */ (event.target))) this.layers.open = false;
    });
  }

  setup(setup) {
    this.showIndexing(setup.indexing);
    setText(this.mission, clip(setup.mission || 'shoal', 60));
    const file = setup.file ? `${setup.file}, seed ${setup.seed}` : '';
    setAttribute(this.mission, 'title', clip(`${file} shoal ${setup.version ?? ''}`.trim()));
    document.title = `${clip(setup.mission || 'shoal', 60)} – shoal viewer`;
    this.note(Array.isArray(setup.notes) ? setup.notes.slice(0, 10) : []);
    this.planned = setup.mode === 'planned';
    this.recorded = setup.mode === 'recorded' || this.planned;
    this.length_s = setup.mode === 'recorded' ? setup.end_s : setup.duration_s;
  }

  /** Closes the menu of layers; its button has the focus then. */
  closeLayers() {
    this.layers.open = false;
    this.layers.querySelector('summary')?.focus();
  }

  /** @param names  of the files that lie under the mission */
  showBackgrounds(names) {
    this.remove.hidden = names.length === 0;
    setAttribute(this.remove, 'title', clip(names.join(', '), 300));
    if (names.length === 0) this.file.value = '';
  }

  /** Shows texts beside the map, until they are closed. */
  note(texts) {
    const notes = byId('notes');
    notes.hidden = texts.length === 0;
    const close = element('button', {type: 'button', class: 'close',
      'aria-label': 'Close the notes', onclick: () => { notes.hidden = true; }}, '✕');
    notes.replaceChildren(...texts.map((text) => element('li', {}, clip(text, 500))), close);
  }

  showPulseStyle(style) {
    this.pulseStyle.value = style;
  }

  showLayers(layers) {
    for (const [name, box] of this.boxes) box.checked = Boolean(layers[name]);
  }

  /** The result of the mission that has ended: PASS or FAIL; null: not known. */
  showResult(result) {
    this.result = result;
  }

  /** How much of a long log has been read, 0 to 1; its begin is shown meanwhile. */
  showIndexing(share) {
    const bar = /** @type {HTMLProgressElement} */ (document.getElementById('indexing'));
    bar.hidden = !Number.isFinite(share);
    if (!bar.hidden) bar.value = share;
  }

  /** @param recorded  its playing and speed, or null */
  frame(t, clock, recorded) {
    const of = this.length_s > 0 ? ` / ${missionTime(this.length_s, 0)}` : '';
    setText(this.clock, missionTime(t) + of);
    const ended = this.result && (recorded || clock?.state === 'ended')
      ? `■ ended: ${clip(this.result, 20)}` : '';
    const text = this.planned ? kStates.planned : recorded
      ? `${ended && `${ended}; `}recorded, ${recorded.playing ? `▶ ${recorded.speed} ×` : '❚❚ paused'}` : ended || clockWords(clock);
    setText(this.state, text);
    setAttribute(this.state, 'data-state', clip(clock?.state ?? '', 20));
  }

  showConnection(connection, reason, clock) {
    setText(this.connection, this.recorded && connection === 'live' ? '● connected'
      : kConnections[connection]);
    setAttribute(this.connection, 'data-state', connection);
    const text = bannerWords(clock, connection, reason);
    setText(this.banner, text);
    this.banner.hidden = text === '';
    const isTrouble = connection === 'lost' && clock?.state !== 'ended';
    setAttribute(this.banner, 'data-state', isTrouble ? 'lost' : null);
  }
}
