// What keys and the buttons above the map do.

import {byId, setAttribute} from './dom.js';
import {actionOf} from './help.js';
import {kLayers} from './top_bar.js';

const kPan_px = 80;
const kZoom = 1.25;
const kWidths = ['', 'wide', 'none'];

function choose(page, direction) {
  const names = page.names();
  if (names.length === 0) return;
  const place = names.indexOf(page.selected);
  const first = direction > 0 ? 0 : names.length - 1;
  page.select(place < 0 ? names[first] : names[(place + direction + names.length) % names.length]);
}

const followable = (page) => page.selected ?? page.names()[0] ?? null;

function follow(page, on) {
  page.map.follow(on ? followable(page) : null);
  page.keeper.changed();
}

function toggleWidth() {
  const side = document.body.dataset.side ?? '';
  document.body.dataset.side = kWidths[(kWidths.indexOf(side) + 1) % kWidths.length];
}

function measure(page) {
  page.map.measure(!page.map.measuring);
}

/** @returns {HTMLDialogElement} */
const helpSheet = () => /** @type {HTMLDialogElement} */ (document.getElementById('help'));

function escape(page) {
  const help = helpSheet();
  if (help.open) help.close();
  else if (page.panels?.plan.isDrawing) page.panels.plan.cancel();
  else if (page.top.layers.open) page.top.closeLayers();
  else if (page.verdict.isOpen) page.verdict.close();
  else if (page.commands?.aimed) page.commands.aim(null);
  else if (page.map.measuring) measure(page);
  else if (page.link && page.tabs.current === 'comms') page.openLink(null, null);
  else if (page.selected) page.select(null);
  else byId('notes').hidden = true;
}

function showHelp() {
  const help = helpSheet();
  if (help.open) help.close();
  else help.showModal();
}

function sendHere(page) {
  const {commands} = page;
  if (!commands.allowed) {
    page.tabs.show('commands');
    return;
  }
  commands.aim(commands.aimed === null ? commands.target.value || null : null);
}

const kActions = {
  planDone: (page) => page.panels.plan.finish(),
  planRemove: (page) => page.panels.plan.removeChosen(),
  panLeft: (page) => page.map.pan(-kPan_px, 0),
  panRight: (page) => page.map.pan(kPan_px, 0),
  panUp: (page) => page.map.pan(0, -kPan_px),
  panDown: (page) => page.map.pan(0, kPan_px),
  zoomIn: (page) => page.map.zoom(kZoom),
  zoomOut: (page) => page.map.zoom(1 / kZoom),
  fit: (page) => page.map.fit(),
  centre: (page) => page.selected && page.map.centre(page.selected),
  follow: (page) => follow(page, page.map.view.follow !== followable(page)),
  unfollow: (page) => follow(page, false),
  measure,
  png: (page) => page.savePng(),
  film: (page) => page.toggleFilm(),
  nextVehicle: (page) => choose(page, 1),
  previousVehicle: (page) => choose(page, -1),
  theme: (page) => page.setTheme(document.documentElement.className === 'light' ? 'dark' : 'light'),
  width: toggleWidth,
  help: showHelp,
  escape,
  play: (page) => {
    if (page.isRecorded) page.source.toggle();
    else if (page.commands.allowed) page.commands.togglePause();
  },
  stepBack: (page) => page.isRecorded && page.source.step(-1),
  stepOn: (page) => page.isRecorded && page.source.step(1),
  slower: (page) => page.isRecorded && page.source.faster(-1),
  faster: (page) => page.isRecorded && page.source.faster(1),
  previousEvent: (page) => page.jump(-1, false),
  nextEvent: (page) => page.jump(1, false),
  previousGrave: (page) => page.jump(-1, true),
  nextGrave: (page) => page.jump(1, true),
  sendHere,
  allStop: (page) => page.commands.allStop(),
};
kLayers.forEach(([name], i) => {
  kActions[`layer${i}`] = (page) => page.setLayer(name, !page.map.view.layers[name]);
});

function act(page, action) {
  if (!page.setup && action !== 'help' && action !== 'escape' && action !== 'theme') return;
  kActions[action](page);
  showPressed(page);
}

/** Shows which of the buttons above the map are on. */
export function showPressed(page) {
  const set = (name, on) => setAttribute(document.querySelector(`[data-action=${name}]`),
    'aria-pressed', String(on));
  set('measure', page.map.measuring);
  set('film', page.film.isRunning);
  set('follow', page.map.view.follow !== null);
}

/** Lets keys, and buttons with data-action, act on `page`. */
export function listenToKeys(page) {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented) return;
    const action = actionOf(event);
    const help = helpSheet();
    if (action === null || (help.open && action !== 'help' && action !== 'escape')) return;
    event.preventDefault();
    act(page, action);
  });
  // A button that was clicked would take the space bar for itself, and give its order twice.
  document.addEventListener('click', (event) => {
    if (event.detail === 0 || !(event.target instanceof Element)) return;
    const button = event.target.closest('button, summary');
    if (button instanceof HTMLElement) button.blur();
  });
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (
    document.querySelectorAll('[data-action]'))) {
    button.addEventListener('click', () => act(page, button.dataset.action));
  }
}
