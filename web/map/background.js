// What a user drops onto the page to lie under the mission: coast lines and areas (GeoJSON), a chart
// (GeoTIFF; PNG, JPEG or WebP with its world file). Nothing of it leaves the page.
//
// Files may hold anything: sizes and counts are bounded, texts are never markup, and an image is
// drawn as pixels alone.

import {isNumber} from './geometry.js';
import {readGeoTiff} from './geotiff.js';

const kMaxBytes = 64e6;
const kMaxPoints = 1_000_000;
const kMaxShapes = 100_000;
const kMaxDepth = 8;
const kMaxPixels = 64e6;
const kMaxBackgrounds = 20;
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
  const box = {left: x - dx / 2, top: y - dy / 2};
  box.right = box.left + dx * width;
  box.bottom = box.top + dy * height;
  const isGeo = Math.abs(box.left) <= 180 && Math.abs(box.right) <= 180
      && Math.abs(box.top) <= 90 && Math.abs(box.bottom) <= 90 && dx < 0.1;
  if (!isGeo) return box;
  const [upper, lower] = [frame.toLocal(box.top, box.left), frame.toLocal(box.bottom, box.right)];
  return upper && lower ? {left: upper.x, top: upper.y, right: lower.x, bottom: lower.y} : null;
}

const kImage = /\.(png|jpe?g|webp)$/i;
const kTiff = /\.tiff?$/i;
const kWorld = /\.(pgw|jgw|wld|pngw|jpgw|wpw)$/i;
const stem = (name) => name.replace(/\.[^.]*$/, '').toLowerCase();

export class Backgrounds {
  all = [];      // {name, shapes} or {name, image, box}
  version = 0;   // Changes with what is drawn.

  clear() {
    this.all = [];
    this.version += 1;
  }

  /**
   * Takes files. An image without a world file goes to `view`, which has left, right, bottom and
   * top. Returns texts for the user, one for each file that needs one.
   */
  async take(files, frame, view) {
    const words = [];
    const worlds = new Map();
    for (const file of files) if (kWorld.test(file.name)) worlds.set(stem(file.name), file);
    for (const file of files) {
      if (kWorld.test(file.name)) continue;
      if (this.all.length >= kMaxBackgrounds) {
        words.push(`${file.name}: there are ${kMaxBackgrounds} backgrounds already`);
      } else if (file.size > kMaxBytes) {
        words.push(`${file.name}: larger than ${kMaxBytes / 1e6} MB`);
      } else {
        words.push(await (kImage.test(file.name)
          ? this.#takeImage(file, worlds.get(stem(file.name)), frame, view)
          : kTiff.test(file.name) ? this.#takeTiff(file, frame, view)
            : this.#takeShapes(file, frame)));
      }
    }
    this.version += 1;
    return words.filter(Boolean);
  }

  async #takeShapes(file, frame) {
    let json = null;
    try {
      json = JSON.parse(await file.text());
    } catch {
      return `${file.name}: neither GeoJSON nor an image (GeoTIFF, PNG, JPEG, WebP)`;
    }
    const {shapes, num_left_out: more} = shapesOf(json, frame);
    if (shapes.length === 0) {
      return `${file.name}: no coast line or area of it is within 2,000 km of the mission's origin`;
    }
    this.all.push({name: file.name, shapes});
    return more > 0 ? `${file.name}: ${more} of its shapes are left out, it has too many points` : '';
  }

  async #takeTiff(file, frame, view) {
    try {
      const {width, height, rgba, box} = await readGeoTiff(await file.arrayBuffer(), frame);
      const image = await createImageBitmap(new ImageData(rgba, width, height));
      this.all.push({name: file.name, image, box: box ?? fitted(image, view)});
      return box ? '' : `${file.name}: it does not state where it lies, and is put into the view`;
    } catch (error) {
      return `${file.name}: ${error.message}`;
    }
  }

  async #takeImage(file, world, frame, view) {
    let image = null;
    try {
      image = await createImageBitmap(file);
    } catch {
      return `${file.name}: not an image that the browser can read`;
    }
    if (image.width * image.height > kMaxPixels) {
      image.close();
      return `${file.name}: more than ${kMaxPixels / 1e6} million pixels`;
    }
    const box = world && world.size < 10_000
      ? cornersOf(await world.text(), image.width, image.height, frame) : null;
    this.all.push({name: file.name, image, box: box ?? fitted(image, view)});
    if (world && !box) {
      return `${file.name}: its world file has no six numbers without rotation; it is put into the view`;
    }
    return box ? '' : `${file.name}: it has no world file, and is put into the view`;
  }
}

// As large as fits into the view, its sides in proportion.
function fitted(image, {left, right, bottom, top}) {
  const scale = Math.min((right - left) / image.width, (top - bottom) / image.height);
  const [x, y] = [(left + right) / 2, (bottom + top) / 2];
  const [half, tall] = [scale * image.width / 2, scale * image.height / 2];
  return {left: x - half, right: x + half, bottom: y - tall, top: y + tall};
}

/** Draws images first, then areas and lines. */
export function drawBackgrounds(ctx, camera, theme, backgrounds) {
  ctx.setLineDash([]);
  for (const {image, box} of backgrounds) {
    if (!image) continue;
    const [x, y] = [camera.sx(box.left), camera.sy(box.top)];
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(image, x, y, camera.sx(box.right) - x, camera.sy(box.bottom) - y);
  }
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
