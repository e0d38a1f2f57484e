// The backgrounds that the mission names: their files and tiles, asked of the viewer.

import {failureOf} from '../net/requests.js';

const kMaxNamed = 20;

const isWhole = (value) => Number.isInteger(value) && value >= 0;

/** Tiles of a background of the mission, as tiles.js takes them; null: not known. */
function servedTiles(requests, number, tiles) {
  const {min_zoom: least, max_zoom: most, left, right, top, bottom} = tiles ?? {};
  if (![least, most, left, right, top, bottom].every(isWhole) || most > 24 || least > most) return null;
  return {
    zooms: {least, most},
    extent: {z: least, left, right: right + 1, top, bottom: bottom + 1},
    tile: async (z, x, y) => {
      const blob = await requests.bytes('/api/tile', {number, z, x, y});
      return blob.size > 0 ? blob : null;  // None: the file does not have it.
    },
  };
}

/**
 * Puts the backgrounds of the mission under it; returns texts for the user.
 * @param named  of /api/setup
 * @param map  MapView
 * @param {() => boolean} isWanted  false: another mission is shown by now
 */
export async function addNamed(named, requests, map, isWanted) {
  const words = [];
  for (const [number, background] of named.slice(0, kMaxNamed).entries()) {
    const name = background.file.split('/').filter(Boolean).pop() ?? background.file;
    try {
      if (typeof background.problem === 'string') throw new Error(background.problem);
      const tiles = servedTiles(requests, number, background.tiles);
      if (tiles) {
        words.push(map.addTiles(name, tiles));
        continue;
      }
      const files = [new File([await requests.bytes('/api/background', {number})], name)];
      if (background.has_world) {
        const world = await requests.bytes('/api/background', {number, world: 1});
        files.push(new File([world], name.replace(/\.[^.]*$/, '.wld')));
      }
      if (!isWanted()) return [];
      words.push(...await map.addBackgrounds(files));
    } catch (error) {
      const {message} = failureOf(error);
      words.push(message.includes(name) ? message : `${name}: ${message}`);
    }
  }
  return words.filter(Boolean);
}

/**
 * Tiles of a server that the viewer was allowed to name: --allow-tiles.
 * @param {string} url  with {z}, {x} and {y}
 */
export function outsideTiles(url) {
  const host = new URL(url.replace(/[{}]/g, '')).host;
  return {
    host,
    zooms: {least: 0, most: 19},
    extent: null,
    tile: async (z, x, y) => {
      const address = url.replaceAll('{z}', z).replaceAll('{x}', x).replaceAll('{y}', y);
      let response = null;
      try {
        response = await fetch(address, {credentials: 'omit', referrerPolicy: 'no-referrer',
          signal: AbortSignal.timeout(20_000)});
      } catch {
        throw new Error(`${host} does not answer, or lets no other pages read its tiles (CORS)`);
      }
      if (response.status === 404 || response.status === 204) return null;
      if (!response.ok) throw new Error(`${host} answers with status ${response.status}`);
      return response.blob();
    },
  };
}
