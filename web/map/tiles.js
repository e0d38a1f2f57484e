// Draws web tiles under the mission: the zoom that fits the map's scale, those that can be seen, and
// while one is on its way the part of a coarser one.

import {drawGroundImage, groundImage} from './ground_image.js';
import {decodeImage} from './image_file.js';
import {tileCorner, tilePlace} from './projection.js';

const kEquator_m = 40_075_016.7;
const kTile_px = 256;
const kMaxTilePixels = 4e6;
const kMaxHeld = 300;
const kMaxDrawn = 120;   // Tiles of one picture; more: a coarser zoom.
const kAtOnce = 6;       // Requests.

/** Tiles of one source: {zooms: {least, most}, tile(z, x, y) -> Promise<Blob | null>}. */
export class TileLayer {
  #source;
  #frame;
  #onChange;
  #held = new Map();   // By z/x/y: 'waiting', null (there is none) or a ground image.
  #queue = [];
  #running = 0;
  /** Why tiles are missing, the first time; empty: none is. */
  problem = '';
  isProblemTold = false;

  /** @param frame  LocalFrame of the mission @param onChange  a tile has come, or will not */
  constructor(source, frame, onChange) {
    this.#source = source;
    this.#frame = frame;
    this.#onChange = onChange;
  }

  /** Returns the box in metres of what the source states to hold; null: it states nothing. */
  get box() {
    const {extent} = this.#source;
    if (!extent) return null;
    const corners = [[extent.left, extent.top], [extent.right, extent.bottom]].map(([x, y]) => {
      const [lon, lat] = tileCorner(x, y, extent.z);
      return this.#frame.toLocal(lat, lon);
    });
    if (!corners.every(Boolean)) return null;
    const [upper, lower] = corners;
    return {left: upper.x, top: upper.y, right: lower.x, bottom: lower.y};
  }

  draw(ctx, camera) {
    const seen = this.#seen(camera);
    this.#queue = [];
    for (const {z, x, y} of seen) {
      const own = this.#take(z, x, y);
      if (own) {
        drawGroundImage(ctx, camera, own);
      } else {
        const coarse = this.#coarser(z, x, y);
        if (coarse) drawGroundImage(ctx, camera, coarse);
      }
    }
    this.#forgetOld();
  }

  // The tiles of the picture, in the zoom whose pixels are the map's, or the next coarser one.
  #seen(camera) {
    const {least, most} = this.#source.zooms;
    const middle = this.#frame.toGeo(camera.cx, camera.cy);
    if (middle.lat === null) return [];
    const perPixel = kEquator_m * Math.cos(middle.lat * Math.PI / 180) / kTile_px;
    let z = Math.round(Math.log2(perPixel / camera.metresPerPixel));
    z = Math.max(least, Math.min(most, z));
    for (; z >= Math.max(0, least - 1); --z) {
      const box = this.#columnsAndRows(camera, z);
      if (!box) return [];
      const count = (box.right - box.left + 1) * (box.bottom - box.top + 1);
      if (count > kMaxDrawn && z > least) continue;
      if (count > kMaxDrawn) return [];
      const all = [];
      for (let y = box.top; y <= box.bottom; ++y) {
        for (let x = box.left; x <= box.right; ++x) all.push({z, x, y});
      }
      return all;
    }
    return [];
  }

  #columnsAndRows(camera, z) {
    const box = {left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity};
    for (const x of [camera.left, camera.cx, camera.right]) {
      for (const y of [camera.bottom, camera.cy, camera.top]) {
        const {lat, lon} = this.#frame.toGeo(x, y);
        if (lat === null) return null;
        const place = tilePlace(lon, lat, z);
        box.left = Math.min(box.left, Math.floor(place.x));
        box.right = Math.max(box.right, Math.floor(place.x));
        box.top = Math.min(box.top, Math.floor(place.y));
        box.bottom = Math.max(box.bottom, Math.floor(place.y));
      }
    }
    const last = 2 ** z - 1;
    return {left: Math.max(0, box.left), right: Math.min(last, box.right),
      top: Math.max(0, box.top), bottom: Math.min(last, box.bottom)};
  }

  /** Returns the ground image where it has come; else asks for it. */
  #take(z, x, y) {
    const key = `${z}/${x}/${y}`;
    const held = this.#held.get(key);
    if (held === undefined) {
      this.#queue.push({z, x, y, key});
      this.#askNext();
      return null;
    }
    this.#held.delete(key);  // Behind the others: the first one is the longest unused.
    this.#held.set(key, held);
    return held === 'waiting' ? null : held;
  }

  #coarser(z, x, y) {
    for (let up = 1; z - up >= this.#source.zooms.least && up <= 6; ++up) {
      const held = this.#held.get(`${z - up}/${x >> up}/${y >> up}`);
      if (held && held !== 'waiting') return held.partOf?.(up, x, y) ?? null;
    }
    return null;
  }

  #askNext() {
    while (this.#running < kAtOnce && this.#queue.length > 0) {
      const wanted = this.#queue.shift();
      this.#held.set(wanted.key, 'waiting');
      ++this.#running;
      this.#ask(wanted).catch((error) => {
        this.#held.set(wanted.key, null);
        if (this.problem === '') this.problem = error.message;
      }).finally(() => {
        --this.#running;
        this.#onChange();
        this.#askNext();
      });
    }
  }

  async #ask({z, x, y, key}) {
    const blob = await this.#source.tile(z, x, y);
    if (!blob) {
      this.#held.set(key, null);
      return;
    }
    const image = await decodeImage(blob, kMaxTilePixels);
    this.#held.set(key, this.#onGround(image, z, x, y));
  }

  #onGround(image, z, x, y) {
    const place = (u, v) => {
      const [lon, lat] = tileCorner(x + u / image.width, y + v / image.height, z);
      return this.#frame.toLocal(lat, lon);
    };
    const ground = groundImage(image, place);
    if (!ground) return null;
    // The part of this tile that stands for one of a finer zoom: the cells that it covers.
    return {...ground, partOf: (up, fineX, fineY) => {
      const share = 2 ** up;
      const [u, v] = [(fineX % share) / share * image.width, (fineY % share) / share * image.height];
      const [w, h] = [image.width / share, image.height / share];
      const corners = [[u, v], [u + w, v], [u, v + h]].map(([a, b]) => place(a, b));
      if (!corners.every(Boolean)) return null;
      const [ul, ur, ll] = corners;
      const box = {left: Math.min(ul.x, ll.x), right: Math.max(ur.x, ll.x),
        top: Math.max(ul.y, ur.y), bottom: Math.min(ll.y, ur.y)};
      return {image, box, cells: [{u, v, w, h, ul, ur, ll}]};
    }};
  }

  #forgetOld() {
    for (const [key, held] of this.#held) {
      if (this.#held.size <= kMaxHeld) break;
      if (held === 'waiting') continue;
      held?.image.close?.();
      this.#held.delete(key);
    }
  }

  /** Lets go of the images. */
  close() {
    for (const held of this.#held.values()) if (held && held !== 'waiting') held.image.close?.();
    this.#held.clear();
    this.#queue = [];
  }
}
