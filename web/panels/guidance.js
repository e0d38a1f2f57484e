// How the task of an underwater vehicle comes to its course and depth, as rows of the facts.

import {clip, quantity, words} from '../page/text.js';

/** Guidance older than this no longer counts: no task steers. */
const kOld_s = 3;

/** A layer in words: "sonar 0.52 m/s × 1.00". */
export const layerWords = ({name, speed, weight}) => (
  `${clip(words(name), 30)} ${quantity(speed, 2, 'm/s')} × ${quantity(weight, 2)}`);

/** The rows [label, text] of a vehicle at time `t`; none where nothing counts. */
export function guidanceFacts({guidance}, t) {
  if (!guidance || Math.abs(t - guidance.t) > kOld_s) return [];
  const facts = [['Guidance', `pitch ${quantity(guidance.pitch, 1)}°, crab angle by ALOS `
    + `${quantity(guidance.crab, 1)}°`]];
  if (guidance.layers?.length) facts.push(['Layers', guidance.layers.map(layerWords).join(', ')]);
  return facts;
}
