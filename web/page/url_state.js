// The view as the address keeps it, behind the "#": whoever opens the address sees the same.
//
//   #x=12&y=-150&mpp=0.5&follow=alpha&select=alpha&layers=trails,names&tab=comms&t=93.5&theme=light

import {readPlots, writePlots} from '../charts/field_series.js';
import {kPulseStyles} from '../map/draw_signals.js';

const kMaxName = 64;
const kMaxPosition_m = 1e7;

export const kTabs = ['vehicle', 'comms', 'data', 'status', 'events', 'plan', 'commands'];
export const kThemes = ['dark', 'light'];

/**
 * Reads the part behind "#". What is missing or makes no sense is null.
 * @param layerNames  the layers that there are
 */
export function readHash(hash, layerNames) {
  const query = new URLSearchParams(String(hash ?? '').replace(/^#/, '').slice(0, 4000));
  const number = (key, low, high) => {
    const text = query.get(key);
    if (text === null || text.trim() === '') return null;
    const value = Number(text);
    return Number.isFinite(value) && value >= low && value <= high ? value : null;
  };
  const name = (key) => {
    const text = query.get(key);
    return text !== null && text !== '' && text.length <= kMaxName ? text : null;
  };
  const oneOf = (key, values) => (values.includes(query.get(key)) ? query.get(key) : null);
  const layers = query.get('layers');
  const listed = layers === null ? [] : layers.split(',');
  return {
    x: number('x', -kMaxPosition_m, kMaxPosition_m),
    y: number('y', -kMaxPosition_m, kMaxPosition_m),
    metresPerPixel: number('mpp', 1e-4, 1e5),
    follow: name('follow'),
    select: name('select'),
    from: name('from'),
    to: name('to'),
    layers: layers === null ? null
        : Object.fromEntries(layerNames.map((layer) => [layer, listed.includes(layer)])),
    tab: oneOf('tab', kTabs),
    plots: query.has('plots') ? readPlots(query.get('plots')) : null,
    t: number('t', -1e12, 1e12),
    theme: oneOf('theme', kThemes),
    pulses: oneOf('pulses', kPulseStyles.map(([style]) => style)),
  };
}

/** Writes what readHash reads; null is left out. The result begins with "#". */
export function writeHash(state) {
  const query = new URLSearchParams();
  const put = (key, value) => {
    if (value !== null && value !== undefined) query.set(key, String(value));
  };
  const rounded = (value, digits) => (
    Number.isFinite(value) ? Number(value.toFixed(digits)) : null);
  put('x', rounded(state.x, 1));
  put('y', rounded(state.y, 1));
  put('mpp', Number.isFinite(state.metresPerPixel)
    ? Number(state.metresPerPixel.toPrecision(4)) : null);
  put('follow', state.follow);
  put('select', state.select);
  put('from', state.from);
  put('to', state.to);
  if (state.layers) {
    put('layers', Object.keys(state.layers).filter((layer) => state.layers[layer]).join(','));
  }
  put('tab', state.tab);
  put('plots', writePlots(state.plots ?? []));
  put('t', rounded(state.t, 2));
  put('theme', state.theme);
  put('pulses', state.pulses);
  return `#${query.toString().replaceAll('%2C', ',')}`;
}
