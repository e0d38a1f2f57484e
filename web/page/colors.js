// The colours of the map and of the panels. The palette is that of Okabe and Ito (2008), which
// colour-blind people can distinguish; every colour is made light enough for the dark theme, or
// dark enough for the light one.

import {namedColors} from './color_names.js';

export const palette = {
  orange: '#e69f00',
  skyBlue: '#56b4e9',
  green: '#009e73',
  yellow: '#f0e442',
  blue: '#0072b2',
  vermillion: '#d55e00',
  purple: '#cc79a7',
  grey: '#999999',
};

const kVehicleColors = ['orange', 'skyBlue', 'green', 'yellow', 'vermillion', 'purple', 'blue'];

// Relative luminance (WCAG 2): at least this on the dark ground, at most that on the light one.
// Both keep a contrast of 3 and more.
const kLeastOnDark = 0.2;
const kMaxOnLight = 0.28;

/** True where the page has the light theme: class `light` on <html>. */
export function isLightTheme() {
  return globalThis.document?.documentElement?.classList?.contains('light') ?? false;
}

/** Returns 0xrrggbb of a CSS or MOOS name, #rgb, #rrggbb or hex:rr,gg,bb; null for others. */
export function parseColor(text) {
  if (typeof text !== 'string' || text.length > 64) return null;
  const plain = text.toLowerCase().replace(/[\s_]/g, '').replace('grey', 'gray');
  if (namedColors.has(plain)) return namedColors.get(plain);
  const hex = /^(?:#|hex:?)([0-9a-f]{1,2}),?([0-9a-f]{1,2}),?([0-9a-f]{1,2})$/.exec(plain);
  if (!hex || new Set(hex.slice(1).map((part) => part.length)).size !== 1) return null;
  const parts = hex.slice(1).map((part) => part.length === 1 ? part + part : part);
  return parseInt(parts.join(''), 16);
}

function partsOf(rgb) {
  return [(rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255].map((part) => part / 255);
}

/** Returns the relative luminance of 0xrrggbb, 0 to 1 (WCAG 2). */
export function luminance(rgb) {
  const [r, g, b] = partsOf(rgb).map(
      (part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function mixed(rgb, target, amount) {
  const parts = partsOf(rgb).map(
      (part) => Math.round(255 * (part + (target - part) * amount)));
  return (parts[0] << 16) | (parts[1] << 8) | parts[2];
}

/** Mixes with white or black, as little as it takes to be seen on the theme's ground. */
export function readable(rgb, onLight = isLightTheme()) {
  let color = rgb;
  for (let amount = 0; amount <= 1; amount += 0.04) {
    color = mixed(rgb, onLight ? 0 : 1, amount);
    const light = luminance(color);
    if (onLight ? light <= kMaxOnLight : light >= kLeastOnDark) break;
  }
  return `#${color.toString(16).padStart(6, '0')}`;
}

const cache = new Map();

function cached(key, make) {
  let value = cache.get(key);
  if (value === undefined) {
    if (cache.size > 2000) cache.clear();
    value = make();
    cache.set(key, value);
  }
  return value;
}

// Squared distance in RGB, each 0 to 1, below which two colours are taken for one.
const kAlike = 0.13;
// This many of the row are tried before colours may be alike.
const kRow = 100;
const kMaxChosen = 2000;
const kGoldenRatio = 0.6180339887498949;

/** Returns 0xrrggbb no. `index` of a row in which neighbours differ: the palette, then other hues. */
function rowColor(index) {
  if (index < kVehicleColors.length) return parseColor(palette[kVehicleColors[index]]);
  const hue = 6 * ((kGoldenRatio * index) % 1);
  const value = [0.95, 0.75, 0.6][index % 3];
  const part = (offset) => {
    const k = (offset + hue) % 6;
    return Math.round(255 * value * (1 - 0.75 * Math.max(0, Math.min(k, 4 - k, 1))));
  };
  return (part(5) << 16) | (part(3) << 8) | part(1);
}

function areAlike(a, b) {
  const [one, other] = [partsOf(a), partsOf(b)];
  return one.reduce((sum, part, i) => sum + (part - other[i]) ** 2, 0) < kAlike;
}

/**
 * Chooses a colour for each: the one that the viewer has chosen for it (`shown_color`, the same as
 * in plots); then its own, where no other has one like it; then one of the row.
 * @param vehicles  [{name, color, shown_color}] @returns Map of name to 0xrrggbb
 */
export function chosenColors(vehicles) {
  const chosen = new Map();
  for (const {name, shown_color: shown} of vehicles) {
    const rgb = parseColor(shown);
    if (rgb !== null) chosen.set(name, rgb);
  }
  for (const {name, color} of vehicles) {
    if (!chosen.has(name)) chosen.set(name, freeColor(color, [...chosen.values()]));
  }
  return chosen;
}

function freeColor(color, taken) {
  const isFree = (rgb) => !taken.some((other) => areAlike(rgb, other));
  const own = parseColor(color);
  if (own !== null && isFree(own)) return own;
  for (let index = 0; index < kRow; ++index) if (isFree(rowColor(index))) return rowColor(index);
  return rowColor(kRow + taken.length);
}

let chosenOfMission = new Map();

/** Sets the vehicles of the mission; each has its colour from now on. */
export function setVehicles(vehicles) {
  chosenOfMission = chosenColors(Array.isArray(vehicles) ? vehicles : []);
  cache.clear();
}

function paletteColor(key, onLight) {
  return cached(`p ${key} ${onLight}`, () => readable(parseColor(palette[key]), onLight));
}

/**
 * Returns #rrggbb: the colour chosen for a vehicle of the mission, made readable. One that came
 * later gets its own, or another where a vehicle has one like it, and keeps it.
 */
export function vehicleColor(name, color, onLight = isLightTheme()) {
  return cached(`v ${name} ${onLight}`, () => {
    let rgb = chosenOfMission.get(name);
    if (rgb === undefined) {
      rgb = freeColor(color, [...chosenOfMission.values()]);
      if (chosenOfMission.size < kMaxChosen) chosenOfMission.set(name, rgb);
    }
    return readable(rgb, onLight);
  });
}

const kKindColors = {report: 'orange', message: 'skyBlue', ack: 'green', packet: 'purple'};

/** Returns the colour of report, message, ack or packet; grey for others. */
export function kindColor(kind, onLight = isLightTheme()) {
  return paletteColor(Object.hasOwn(kKindColors, kind) ? kKindColors[kind] : 'grey', onLight);
}
