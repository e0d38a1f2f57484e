// The keys of the page: one table for what they do and for the sheet that shows them.

import {element} from './dom.js';

/** key: as KeyboardEvent has it; shown: as the sheet writes them. */
export const kKeys = [
  {group: 'Map', shown: '← ↑ ↓ →', text: 'move the map', actions: {
    ArrowLeft: 'panLeft', ArrowRight: 'panRight', ArrowUp: 'panUp', ArrowDown: 'panDown'}},
  {group: 'Map', shown: '+  −', text: 'zoom', actions: {
    '+': 'zoomIn', '=': 'zoomIn', '-': 'zoomOut', '_': 'zoomOut'}},
  {group: 'Map', shown: 'f', text: 'fit: show everything', actions: {f: 'fit'}},
  {group: 'Map', shown: 'c', text: 'centre on the chosen vehicle', actions: {c: 'centre'}},
  {group: 'Map', shown: 'v  V', text: 'follow the chosen vehicle, stop following',
    actions: {v: 'follow', V: 'unfollow'}},
  {group: 'Map', shown: 'm', text: 'measure a distance: click twice', actions: {m: 'measure'}},
  {group: 'Map', shown: '1 … 9, 0', text: 'layers on and off (see Layers)', actions: {
    1: 'layer0', 2: 'layer1', 3: 'layer2', 4: 'layer3', 5: 'layer4', 6: 'layer5', 7: 'layer6',
    8: 'layer7', 9: 'layer8', 0: 'layer9'}},
  {group: 'Map', shown: 'p', text: 'save the map as a PNG', actions: {p: 'png'}},
  {group: 'Map', shown: 'P', text: 'film the map: begin, end', actions: {P: 'film'}},
  {group: 'Page', shown: 'n  N', text: 'next, previous vehicle',
    actions: {n: 'nextVehicle', N: 'previousVehicle'}},
  {group: 'Page', shown: 't', text: 'dark or light', actions: {t: 'theme'}},
  {group: 'Page', shown: 'w', text: 'side panel: normal, wide, none', actions: {w: 'width'}},
  {group: 'Page', shown: '?  F1', text: 'this sheet', actions: {'?': 'help', F1: 'help'}},
  {group: 'Page', shown: 'Esc', text: 'close, cancel, choose no vehicle',
    actions: {Escape: 'escape'}},
  {group: 'Planning', shown: 'Enter', text: 'end what is being drawn', actions: {Enter: 'planDone'}},
  {group: 'Planning', shown: 'Del', text: 'take the chosen point out',
    actions: {Delete: 'planRemove', Backspace: 'planRemove'}},
  {group: 'Recorded missions', shown: 'space', text: 'play, pause', actions: {' ': 'play'}},
  {group: 'Recorded missions', shown: ',  .', text: 'one step back, on',
    actions: {',': 'stepBack', '.': 'stepOn'}},
  {group: 'Recorded missions', shown: '<  >', text: 'slower, faster',
    actions: {'<': 'slower', '>': 'faster'}},
  {group: 'Recorded missions', shown: '[  ]', text: 'previous, next event',
    actions: {'[': 'previousEvent', ']': 'nextEvent'}},
  {group: 'Recorded missions', shown: '{  }', text: 'previous, next collision, grounding, all-stop or expectation missed',
    actions: {'{': 'previousGrave', '}': 'nextGrave'}},
  {group: 'Commands, where allowed', shown: 'space', text: 'pause or resume the mission',
    actions: {}},
  {group: 'Commands, where allowed', shown: 'g', text: 'send the chosen vehicle to a place',
    actions: {g: 'sendHere'}},
  {group: 'Commands, where allowed', shown: 'X', text: 'all-stop for all vehicles',
    actions: {X: 'allStop'}},
];

const kActions = new Map(kKeys.flatMap(({actions}) => Object.entries(actions)));
const kMovesInLists = /^(Arrow|Home|End|Page)/;

/**
 * Returns what a pressed key asks for, or null: nothing while a user types in a field, and no
 * key that the element which has the focus uses itself.
 */
export function actionOf({key, ctrlKey, metaKey, altKey, target}) {
  if (ctrlKey || metaKey || altKey) return null;
  const action = kActions.get(key) ?? null;
  if (action === 'escape' || key === 'F1') return action;
  const tag = target?.tagName ?? '';
  const type = target?.type ?? '';
  if (tag === 'TEXTAREA' || target?.isContentEditable) return null;
  if (tag === 'SELECT' && (key.length === 1 || kMovesInLists.test(key))) return null;
  if (tag === 'INPUT') {
    const typed = type !== 'range' && type !== 'checkbox';
    if (typed) return null;
    if (type === 'range' && kMovesInLists.test(key)) return null;
    if (type === 'checkbox' && key === ' ') return null;
  }
  if ((tag === 'BUTTON' || tag === 'SUMMARY') && (key === ' ' || key === 'Enter')) return null;
  if (target?.role === 'tab' && kMovesInLists.test(key)) return null;
  return action;
}

/** Fills the sheet of keys, a <dialog>. */
export function fillHelp(dialog) {
  const groups = new Map();
  for (const key of kKeys) groups.set(key.group, [...(groups.get(key.group) ?? []), key]);
  const tables = [...groups].map(([group, keys]) => element('section', {},
    element('h3', {}, group),
    element('table', {}, element('tbody', {}, keys.map(({shown, text}) => element('tr', {},
      element('td', {}, shown.split(/ {2}/).map((key) => element('kbd', {}, key))),
      element('td', {}, text)))))));
  const signs = [
    ['solid hull', 'where a vehicle is (the truth of the simulation)'],
    ['hollow, dashed line', 'where its last report puts it, with the age of the report'],
    ['widening beam', 'on its way from its sender to its receiver: a report (orange) or a '
      + 'message (blue, broken edge)'],
    ['growing ring (6)', 'a packet in transit, acknowledgements green; flashes on arrival'],
    ['circle (4)', 'how far it sends: comms range × its stealth; broken: how far it receives'],
    ['octagon', 'all-stop'],
    ['grey, “stale”', 'no report for longer than the broker accepts'],
    ['✓  ✗  ≈', 'delivered, kept back or lost, damaged'],
  ];
  const close = element('button', {type: 'button', class: 'close', 'aria-label': 'Close',
    onclick: () => dialog.close()}, '✕');
  dialog.replaceChildren(
    element('header', {}, element('h2', {id: 'help-title'}, 'Keys and signs'), close),
    element('div', {class: 'help-groups'}, tables, element('section', {class: 'signs'},
      element('h3', {}, 'What the map shows'),
      element('table', {}, element('tbody', {}, signs.map(([sign, text]) =>
        element('tr', {}, element('td', {}, sign), element('td', {}, text))))))));
}
