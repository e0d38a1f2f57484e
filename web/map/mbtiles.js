// Raster tiles that a user has dropped: an MBTiles file (a database; MBTiles 1.3) or the files of a
// folder zoom/column/row.png.

import {SqliteError, SqlitePages} from './sqlite_pages.js';

const kMaxTiles = 500_000;
const kMaxZoom = 24;
const kTileName = /(?:^|\/)(\d{1,2})\/(\d{1,8})\/(\d{1,8})\.(?:png|jpe?g|webp)$/i;
export const kMaxTile_bytes = 4_000_000;

const keyOf = (z, x, y) => `${z}/${x}/${y}`;
const isTile = (z, x, y) => Number.isInteger(z) && Number.isInteger(x) && Number.isInteger(y)
    && z >= 0 && z <= kMaxZoom && x >= 0 && y >= 0 && x < 2 ** z && y < 2 ** z;

/** Tiles by zoom, column and row from the North; `tile` returns bytes (a Blob) or null. */
export class HeldTiles {
  #tiles = new Map();
  zooms = {least: Infinity, most: -Infinity};
  /**
   * Of the tiles of the lowest zoom, in columns and rows.
   * @type {{z: number, left: number, right: number, top: number, bottom: number} | null}
   */
  extent = null;

  add(z, x, y, blobOf) {
    if (!isTile(z, x, y) || this.#tiles.size >= kMaxTiles) return;
    this.#tiles.set(keyOf(z, x, y), blobOf);
    this.zooms.least = Math.min(this.zooms.least, z);
    this.zooms.most = Math.max(this.zooms.most, z);
    if (!this.extent || z < this.extent.z) {
      this.extent = {z, left: x, right: x + 1, top: y, bottom: y + 1};
    } else if (z === this.extent.z) {
      this.extent.left = Math.min(this.extent.left, x);
      this.extent.right = Math.max(this.extent.right, x + 1);
      this.extent.top = Math.min(this.extent.top, y);
      this.extent.bottom = Math.max(this.extent.bottom, y + 1);
    }
  }

  get count() { return this.#tiles.size; }

  async tile(z, x, y) {
    return this.#tiles.get(keyOf(z, x, y))?.() ?? null;
  }
}

const blobOf = (bytes) => () => (
  bytes instanceof Uint8Array && bytes.length <= kMaxTile_bytes ? new Blob([bytes.slice()]) : null);

/** Returns HeldTiles of an MBTiles file. Throws an SqliteError. @param {ArrayBuffer} buffer */
export function readMbtiles(buffer) {
  const file = new SqlitePages(buffer);
  const metadata = file.find('metadata');
  if (metadata?.type === 'table') {
    for (const record of file.rows(metadata.root)) {
      if (record.value(0) === 'format' && ['pbf', 'mvt'].includes(String(record.value(1)))) {
        throw new SqliteError('it holds vector tiles: raster tiles (PNG, JPEG, WebP) are read');
      }
    }
  }
  const held = new HeldTiles();
  const tiles = file.find('tiles');
  // MBTiles count rows from the South.
  const add = (z, x, row, bytes) => held.add(z, x, 2 ** z - 1 - row, bytes);
  if (tiles?.type === 'table') {
    const [z, x, y, data] = columnsOf(tiles, ['zoom_level', 'tile_column', 'tile_row', 'tile_data']);
    for (const record of file.rows(tiles.root)) {
      add(record.value(z), record.value(x), record.value(y), () => blobOf(record.value(data))());
    }
  } else {
    addShared(file, add);
  }
  if (held.count === 0) throw new SqliteError('it holds no tiles of zoom 0 to 24');
  return held;
}

// A view over two tables, by which equal tiles are there once.
function addShared(file, add) {
  const [map, images] = [file.find('map'), file.find('images')];
  if (map?.type !== 'table' || images?.type !== 'table') {
    throw new SqliteError('it holds neither a table tiles nor map and images');
  }
  const [z, x, y, id] = columnsOf(map, ['zoom_level', 'tile_column', 'tile_row', 'tile_id']);
  const [data, imageId] = columnsOf(images, ['tile_data', 'tile_id']);
  const records = new Map();
  for (const record of file.rows(images.root)) records.set(record.value(imageId), record);
  for (const record of file.rows(map.root)) {
    const image = records.get(record.value(id));
    if (image) {
      add(record.value(z), record.value(x), record.value(y), () => blobOf(image.value(data))());
    }
  }
}

function columnsOf(table, names) {
  const places = names.map((name) => table.columns.indexOf(name));
  if (places.includes(-1)) {
    throw new SqliteError(`its tables are not those of MBTiles: ${names.join(', ')} are wanted`);
  }
  return places;
}

/** Returns HeldTiles of files with paths such as "charts/12/1234/1500.png"; null: none is a tile. */
export function tilesOfFiles(files) {
  const held = new HeldTiles();
  for (const file of files) {
    const match = kTileName.exec(file.path ?? file.webkitRelativePath ?? '');
    if (!match || file.size > kMaxTile_bytes) continue;
    const [z, x, y] = match.slice(1, 4).map(Number);
    held.add(z, x, y, () => file);
  }
  return held.count > 0 ? held : null;
}
