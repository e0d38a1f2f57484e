// A part of the map that changes rarely, kept as a picture somewhat larger than the canvas. While
// the view moves the picture is moved and scaled; it is drawn again when its content changed, now
// and then while it does not fit the view, and when the view has come to rest.

import {context2d} from '../page/dom.js';

const kMargin = 96;
const kRest_ms = 140;
// While the view moves the picture is drawn again at this interval, on a slow machine once in this
// many frames; meanwhile its edge may be seen.
const kMoving_ms = 250;
const kMovingFrames = 8;

/** How the view moves: what all layers of a map have in common. */
export class Motion {
  rest_ms = Infinity;   // Since the view was changed.
  frame_ms = 16;        // Between two frames, smoothed.
  #frame_ms = -Infinity;
  #moved_ms = -Infinity;
  #drawn = false;

  moved() { this.#moved_ms = performance.now(); }

  /** Begins a frame. */
  frame(nowMs) {
    const gap_ms = nowMs - this.#frame_ms;
    if (gap_ms > 0 && gap_ms < 1000) this.frame_ms += 0.2 * (gap_ms - this.frame_ms);
    this.#frame_ms = nowMs;
    this.rest_ms = performance.now() - this.#moved_ms;
    this.#drawn = false;
  }

  /** True where a layer that does not fit the view may be drawn again: one a frame. */
  mayDraw(age_ms) {
    if (this.rest_ms > kRest_ms) return true;
    if (this.#drawn || age_ms < Math.max(kMoving_ms, kMovingFrames * this.frame_ms)) return false;
    return this.#drawn = true;
  }
}

export class MapLayer {
  #canvas = document.createElement('canvas');
  #context;
  /** @type {(import('./map_camera.js').Camera & {ratio?: number}) | null} */
  #camera = null;
  /** @type {string | null} */
  #key = null;
  #drawn_ms = -Infinity;

  constructor({opaque = false} = {}) {
    this.#context = context2d(this.#canvas, {alpha: !opaque});
  }

  /** Milliseconds since the picture was drawn. */
  age(nowMs) { return nowMs - this.#drawn_ms; }

  /**
   * Puts the layer on `target`, whose transform is that of CSS pixels. `draw(context, camera)`
   * draws it again; `key` changes with its content.
   */
  show(target, camera, ratio, key, nowMs, motion, draw) {
    if (this.#mustDraw(camera, ratio, key, this.age(nowMs), motion)) {
      this.#draw(camera.widened(kMargin), ratio, draw);
      this.#key = key;
      this.#drawn_ms = nowMs;
    }
    const own = this.#camera ?? camera;
    const scale = own.metresPerPixel / camera.metresPerPixel;
    // Whole device pixels keep thin lines sharp.
    const left = Math.round(camera.sx(own.x(0)) * ratio) / ratio;
    const top = Math.round(camera.sy(own.y(0)) * ratio) / ratio;
    target.imageSmoothingEnabled = false;  // Only a picture on the move is scaled.
    target.drawImage(this.#canvas, left, top, this.#canvas.width / ratio * scale,
                     this.#canvas.height / ratio * scale);
  }

  #mustDraw(camera, ratio, key, age_ms, motion) {
    const own = this.#camera;
    if (!own || key !== this.#key || own.ratio !== ratio) return true;
    const covers = own.left <= camera.left && own.right >= camera.right &&
        own.bottom <= camera.bottom && own.top >= camera.top;
    if (covers && own.metresPerPixel === camera.metresPerPixel) return false;
    return motion.mayDraw(age_ms);
  }

  #draw(camera, ratio, draw) {
    const [width, height] = [Math.ceil(camera.width * ratio), Math.ceil(camera.height * ratio)];
    if (this.#canvas.width !== width || this.#canvas.height !== height) {
      this.#canvas.width = width;
      this.#canvas.height = height;
    }
    this.#context.setTransform(1, 0, 0, 1, 0, 0);
    this.#context.clearRect(0, 0, width, height);
    this.#context.setTransform(ratio, 0, 0, ratio, 0, 0);
    draw(this.#context, camera);
    camera.ratio = ratio;
    this.#camera = camera;
  }
}
