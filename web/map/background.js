// What lies under the mission: coast lines and areas (GeoJSON), a chart (GeoTIFF; PNG, JPEG or WebP
// with its world file), raster tiles (MBTiles, or a folder of them). Nothing of it leaves the page.
//
// Files may hold anything: sizes and counts are bounded, texts are never markup, and an image is
// drawn as pixels alone.

import {failureOf} from '../net/requests.js';
import {bearingDegrees, isNumber} from './geometry.js';
import {readGeoTiff} from './geotiff.js';
import {drawGroundImage, groundImage, placeInBox} from './ground_image.js';
import {decodeImage} from './image_file.js';
import {readMbtiles, tilesOfFiles} from './mbtiles.js';
import {TileLayer} from './tiles.js';

const kMaxBytes = 64e6;
const kMaxPoints = 1_000_000;
const kMaxShapes = 100_000;
const kMaxDepth = 8;
const kMaxTiles_bytes = 512e6;  // Of an MBTiles file.
const kMaxBackgrounds = 20;
// Beside the mission by more than this, and by more than five times its extent: named to the user.
const kFar_m = 20_000;
const kFarExtents = 5;
// Of a line, on the screen: what is nearer than this to the last point is left out.
const kLeastStep_px = 1;

/** Yields the geometries of a GeoJSON object; what is none, and what is nested too deep, is left out. */
function* geometriesOf(object, depth = 0) {
  if (typeof object !== 'object' || object === null || depth > kMaxDepth) return;
  if (object.type === 'FeatureCollection' && Array.isArray(object.features)) {
    for (const feature of object.features) yield* geometriesOf(feature, depth + 1);
  } else if (object.type === 'Feature') {
    yield* geometriesOf(object.geometry, depth + 1);
  } else if (object.type === 'GeometryCollection' && Array.isArray(object.geometries)) {
    for (const geometry of object.geometries) yield* geometriesOf(geometry, depth + 1);
  } else if (Array.isArray(object.coordinates)) {
    yield object;
  }
}

const kListsOf = {
  Point: (c) => [[c]], MultiPoint: (c) => c.map((point) => [point]), LineString: (c) => [c],
  MultiLineString: (c) => c, Polygon: (c) => c, MultiPolygon: (c) => c.flat(1),
};
const isArea = (type) => type === 'Polygon' || type === 'MultiPolygon';

/**
 * Reads GeoJSON, longitude before latitude (RFC 7946), with a LocalFrame. Returns `shapes`, each
 * with its x, y, isArea and box, and `num_left_out`.
 */
export function shapesOf(json, frame) {
  const shapes = [];
  let [points, left_out] = [0, 0];
  for (const {type, coordinates} of geometriesOf(json)) {
    const lists = Object.hasOwn(kListsOf, type) ? kListsOf[type](coordinates) : [];
    for (const list of lists) {
      if (!Array.isArray(list)) continue;
      if (shapes.length === kMaxShapes || points + list.length > kMaxPoints) {
        left_out += 1;
        continue;
      }
      points += list.length;
      const places = list.map((at) => (
        Array.isArray(at) && isNumber(at[0]) && isNumber(at[1]) ? frame.toLocal(at[1], at[0]) : null))
        .filter(Boolean);
      if (places.length === 0) continue;
      shapes.push(shapeOf(places, isArea(type)));
    }
  }
  return {shapes, num_left_out: left_out};
}

function shapeOf(places, area) {
  const x = Float64Array.from(places, (place) => place.x);
  const y = Float64Array.from(places, (place) => place.y);
  const box = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  for (let i = 0; i < x.length; ++i) {
    box.left = Math.min(box.left, x[i]);
    box.right = Math.max(box.right, x[i]);
    box.bottom = Math.min(box.bottom, y[i]);
    box.top = Math.max(box.top, y[i]);
  }
  return {x, y, isArea: area, box};
}

/**
 * Reads a world file: six numbers, of which the rotation must be 0. Degrees where all lies within
 * them, else metres from the mission's origin. Returns left, right, bottom and top in metres, or
 * null.
 */
export function cornersOf(text, width, height, frame) {
  const numbers = String(text).trim().split(/\s+/).slice(0, 7).map(Number);
  if (numbers.length !== 6 || !numbers.every(Number.isFinite)) return null;
  const [dx, turn, turn2, dy, x, y] = numbers;
  if (turn !== 0 || turn2 !== 0 || !(dx > 0) || !(dy < 0)) return null;
  // x and y are of the middle of the upper left pixel.
  const [left, top] = [x - dx / 2, y - dy / 2];
  const box = {left, top, right: left + dx * width, bottom: top + dy * height};
  const isGeo = Math.abs(box.left) <= 180 && Math.abs(box.right) <= 180
      && Math.abs(box.top) <= 90 && Math.abs(box.bottom) <= 90 && dx < 0.1;
  if (!isGeo) return box;
  const [upper, lower] = [frame.toLocal(box.top, box.left), frame.toLocal(box.bottom, box.right)];
  return upper && lower ? {left: upper.x, top: upper.y, right: lower.x, bottom: lower.y} : null;
}

const kImage = /\.(png|jpe?g|webp)$/i;
const kTiff = /\.tiff?$/i;
const kWorld = /\.(pgw|jgw|wld|pngw|jpgw|wpw)$/i;
const kTiles = /\.mbtiles$/i;
const stem = (name) => name.replace(/\.[^.]*$/, '').toLowerCase();

const kWinds = ['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west',
  'north-west'];

/** Returns "312 km north-east of the mission" where `box` lies far from it; else "". */
export function farWords(box, mission) {
  if (!box || !mission) return '';
  const dx = Math.max(0, box.left - mission.right) - Math.max(0, mission.left - box.right);
  const dy = Math.max(0, box.bottom - mission.top) - Math.max(0, mission.bottom - box.top);
  const extent = Math.max(mission.right - mission.left, mission.top - mission.bottom);
  const away = Math.hypot(dx, dy);
  if (!(away > Math.max(kFar_m, kFarExtents * extent))) return '';
  const wind = kWinds[Math.round(bearingDegrees(dx, dy) / 45) % 8];
  return `${Math.round(away / 1000)} km ${wind} of the mission`;
}

function boxAround(boxes) {
  return {left: Math.min(...boxes.map((box) => box.left)),
    right: Math.max(...boxes.map((box) => box.right)),
    bottom: Math.min(...boxes.map((box) => box.bottom)),
    top: Math.max(...boxes.map((box) => box.top))};
}

/**
 * @typedef {object} Background  one of what lies under the mission
 * @property {string} name
 * @property {any[]} [shapes]
 * @property {any} [ground]   an image with its cells: ground_image.js
 * @property {TileLayer} [layer]
 */

export class Backgrounds {
  /** @type {Background[]} */
  all = [];
  version = 0;   // Changes with what is drawn.
  /** @type {((words: string) => void) | null} Is given texts that come later. */
  onProblem = null;

  clear() {
    for (const {layer, ground} of this.all) {
      layer?.close();
      ground?.image.close?.();
    }
    this.all = [];
    this.version += 1;
  }

  /**
   * Takes files. An image that does not state its place goes to `view`, which has left, right,
   * bottom and top. Returns texts for the user, one for each file that needs one.
   * @param {any} mission  the box of the mission; null: not known
   */
  async take(files, frame, view, mission = null) {
    const words = [];
    const inFolder = (file) => /[\\/]/.test(file.path ?? file.webkitRelativePath ?? '');
    const tiles = tilesOfFiles(files.filter(inFolder));
    if (tiles) words.push(this.addTiles(folderOf(files), tiles, frame, mission));
    const worlds = new Map();
    for (const file of files) if (kWorld.test(file.name)) worlds.set(stem(file.name), file);
    for (const file of files) {
      if (kWorld.test(file.name) || (tiles && inFolder(file))) continue;
      const most = kTiles.test(file.name) ? kMaxTiles_bytes : kMaxBytes;
      if (this.all.length >= kMaxBackgrounds) {
        words.push(`${file.name}: there are ${kMaxBackgrounds} backgrounds already; remove some`);
      } else if (file.size > most) {
        words.push(`${file.name}: larger than ${most / 1e6} MB; make it smaller`);
      } else {
        try {
          words.push(await this.#takeOne(file, worlds.get(stem(file.name)), {frame, view, mission}));
        } catch (error) {
          words.push(`${file.name}: ${failureOf(error).message}`);
        }
      }
    }
    this.version += 1;
    return words.filter(Boolean);
  }

  /**
   * Puts tiles under the rest; returns a text for the user, or "".
   * @param {any} mission  as of take()
   */
  addTiles(name, source, frame, mission = null) {
    const layer = new TileLayer(source, frame, () => {
      this.version += 1;
      if (layer.problem !== '' && !layer.isProblemTold) {
        layer.isProblemTold = true;
        this.onProblem?.(`${name}: some tiles are missing: ${layer.problem}`);
      }
    });
    this.all.push({name, layer});
    this.version += 1;
    return this.#far(name, layer.box, mission);
  }

  #takeOne(file, world, where) {
    if (kImage.test(file.name)) return this.#takeImage(file, world, where);
    if (kTiff.test(file.name)) return this.#takeTiff(file, where);
    if (kTiles.test(file.name)) return this.#takeTiles(file, where);
    return this.#takeShapes(file, where);
  }

  async #takeTiles(file, {frame, mission}) {
    return this.addTiles(file.name, readMbtiles(await file.arrayBuffer()), frame, mission);
  }

  #far(name, box, mission) {
    const words = farWords(box, mission);
    return words === '' ? ''
      : `${name}: it lies ${words}: is its place, or the mission's origin, wrong?`;
  }

  async #takeShapes(file, {frame, mission}) {
    let json = null;
    try {
      json = JSON.parse(await file.text());
    } catch {
      return `${file.name}: neither GeoJSON nor an image (GeoTIFF, PNG, JPEG, WebP) nor MBTiles`;
    }
    const {shapes, num_left_out: more} = shapesOf(json, frame);
    if (shapes.length === 0) {
      return `${file.name}: no coast line or area of it is within 1,500 km of the mission's origin; `
          + 'GeoJSON has longitude before latitude';
    }
    this.all.push({name: file.name, shapes});
    if (more > 0) {
      return `${file.name}: ${more} of its shapes are left out, it has more than a million points; `
          + 'cut it to the mission\'s area';
    }
    return this.#far(file.name, boxAround(nearestShapes(shapes, mission)), mission);
  }

  async #takeTiff(file, {frame, view, mission}) {
    const {width, height, rgba, place, box} = await readGeoTiff(await file.arrayBuffer(), frame);
    const image = await createImageBitmap(new ImageData(rgba, width, height));
    this.#lay(file.name, image, place, view);
    return box ? this.#far(file.name, box, mission)
      : `${file.name}: it does not state where it lies, and is put into the view`;
  }

  async #takeImage(file, world, {frame, view, mission}) {
    const image = await decodeImage(file);
    const box = world && world.size < 10_000
      ? cornersOf(await world.text(), image.width, image.height, frame) : null;
    this.#lay(file.name, image, box ? placeInBox(image, box) : null, view);
    if (world && !box) {
      return `${file.name}: its world file ${world.name} has no six numbers without rotation; it is `
          + 'put into the view';
    }
    return box ? this.#far(file.name, box, mission)
      : `${file.name}: it has no world file (${stem(file.name)}.pgw), and is put into the view`;
  }

  #lay(name, image, place, view) {
    const ground = groundImage(image, place ?? placeInBox(image, fitted(image, view)));
    if (!ground) {
      throw new Error('it reaches more than 1,500 km from the mission\'s origin; cut it to the '
          + 'mission\'s area');
    }
    this.all.push({name, ground});
  }
}

const folderOf = (files) => (
  String(files[0]?.path ?? files[0]?.webkitRelativePath ?? '').split('/').find(Boolean) ?? 'tiles');

// Of a coast, the shape that comes nearest shows whether all of it lies elsewhere.
function nearestShapes(shapes, mission) {
  if (!mission) return [shapes[0].box];
  const away = ({box}) => Math.hypot(
    Math.max(0, box.left - mission.right, mission.left - box.right),
    Math.max(0, box.bottom - mission.top, mission.bottom - box.top));
  return [shapes.reduce((nearest, shape) => (away(shape) < away(nearest) ? shape : nearest)).box];
}

// As large as fits into the view, its sides in proportion.
function fitted(image, {left, right, bottom, top}) {
  const scale = Math.min((right - left) / image.width, (top - bottom) / image.height);
  const [x, y] = [(left + right) / 2, (bottom + top) / 2];
  const [half, tall] = [scale * image.width / 2, scale * image.height / 2];
  return {left: x - half, right: x + half, bottom: y - tall, top: y + tall};
}

/** Draws tiles first, then images, then areas and lines. */
export function drawBackgrounds(ctx, camera, theme, backgrounds) {
  ctx.setLineDash([]);
  for (const {layer} of backgrounds) layer?.draw(ctx, camera);
  for (const {ground} of backgrounds) if (ground) drawGroundImage(ctx, camera, ground);
  ctx.lineWidth = 1.2;
  for (const {shapes} of backgrounds) {
    for (const shape of shapes ?? []) drawShape(ctx, camera, theme, shape);
  }
  ctx.globalAlpha = 1;
}

function drawShape(ctx, camera, theme, {x, y, isArea: area, box}) {
  if (box.right < camera.left || box.left > camera.right || box.top < camera.bottom
      || box.bottom > camera.top) return;
  ctx.beginPath();
  let [lastX, lastY] = [Infinity, Infinity];
  for (let i = 0; i < x.length; ++i) {
    const [sx, sy] = [camera.sx(x[i]), camera.sy(y[i])];
    const isLast = i === x.length - 1;
    if (!isLast && Math.abs(sx - lastX) < kLeastStep_px && Math.abs(sy - lastY) < kLeastStep_px) continue;
    if (i === 0) ctx.moveTo(sx, sy);
    else ctx.lineTo(sx, sy);
    [lastX, lastY] = [sx, sy];
  }
  if (x.length === 1) ctx.rect(camera.sx(x[0]) - 2, camera.sy(y[0]) - 2, 4, 4);
  ctx.strokeStyle = theme.area;
  if (area) {
    ctx.closePath();
    ctx.globalAlpha = 0.22;
    ctx.fillStyle = theme.area;
    ctx.fill();
  }
  ctx.globalAlpha = 0.8;
  ctx.stroke();
}
