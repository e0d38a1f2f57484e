// The causes of fates as the server has them: /api/setup sends the table (lib/comms/routing/cause.h), with
// texts and colours. There is no list of causes on this side.
//
//   setCauses(setup.causes);
//   causeWords('out_of_range');    // "out of range"

import {parseColor, readable, isLightTheme} from './colors.js';
import {words} from './text.js';

const kUnknownColor = 0x999999;

let table = new Map();

/** Takes the table; what is no cause is left out. */
export function setCauses(causes) {
  table = new Map((Array.isArray(causes) ? causes : [])
    .filter((row) => typeof row?.key === 'string' && typeof row.text === 'string')
    .map((row) => [row.key, row]));
}

/** "out of range"; of an unknown cause its own name. */
export function causeWords(cause) {
  return table.get(cause)?.text ?? words(cause);
}

/** Returns #rrggbb, readable on the theme's ground; grey where the cause is unknown. */
export function causeColor(cause, onLight = isLightTheme()) {
  return readable(parseColor(table.get(cause)?.color) ?? kUnknownColor, onLight);
}

/** "whole", "damaged", "stopped" or "pending"; an unknown cause has stopped it. */
function outcomeOf(cause) {
  return table.get(cause)?.outcome ?? 'stopped';
}

/** A sign for what became of a transmission: without colour the same as with it. */
export function fateSign(cause) {
  return {whole: '✓', damaged: '≈', pending: '…'}[outcomeOf(cause)] ?? '✗';
}

/** Is this a fate that kept something from its receiver? */
export function isBlocked(cause) {
  return !['whole', 'damaged'].includes(outcomeOf(cause));
}
