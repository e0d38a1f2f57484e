// The places of a plan on the map: they can be dragged, added and drawn again.
//
//   none --press on a point--> dragging --release--> an edit
//   none --tool--> drawing --clicks, then Enter or a second click on the last--> an edit

import {kFont} from '../map/draw_theme.js';

const kHit_px = 11;
const kFingerHit_px = 18;
const kPoint_px = 6;
const kMiddle_px = 4;
const kNear_px = 3;

/** How many points a tool draws: [least, most]. */
export const kTools = {
  waypoints: {least: 1, most: 500, closed: false},
  loiter: {least: 1, most: 2, closed: false},
  station_keep: {least: 1, most: 1, closed: false},
  survey: {least: 3, most: 200, closed: true},
  obstacle: {least: 3, most: 200, closed: true},
  area: {least: 3, most: 200, closed: true},
};

const rounded = ([x, y]) => [Math.round(x * 10) / 10, Math.round(y * 10) / 10];

export class PlanLayer {
  /** @type {import('./plan_editor.js').Plan | null} */
  #plan = null;
  /** @type {{handle: number, point: number} | null} */
  chosen = null;
  /** @type {{handle: number, point: number, insert: boolean, at: [number, number], pressed: [number, number]} | null} */
  #drag = null;
  #tool = '';
  /** @type {[number, number][]} Of the tool. */
  #drawn = [];
  /** @type {[number, number] | null} */
  #pointer = null;
  #events;

  /** @param events  onEdit(edit), onDrawn(tool, points), onChosen(handle, point), onTool(tool) */
  constructor(events) {
    this.#events = events;
  }

  get isOpen() { return this.#plan !== null; }
  get tool() { return this.#tool; }
  get numDrawn() { return this.#drawn.length; }

  show(plan) {
    this.#plan = plan;
    this.#drag = null;
    if (!plan) this.setTool('');
    const point = this.chosen ? plan?.handles[this.chosen.handle]?.points[this.chosen.point] : null;
    if (!point) this.chosen = null;
  }

  /** Begins to draw with a tool of kTools; "": none. */
  setTool(tool) {
    this.#tool = Object.hasOwn(kTools, tool) ? tool : '';
    this.#drawn = [];
    this.#events.onTool(this.#tool);
  }

  /** Ends what is being drawn: an edit, where it has enough points. */
  finish() {
    const tool = this.#tool;
    const points = this.#drawn;
    if (tool === '' || points.length < kTools[tool].least) return false;
    this.setTool('');
    this.#events.onDrawn(tool, points);
    return true;
  }

  /** @returns {boolean} whether there was something to give up */
  cancel() {
    if (this.#drag) {
      this.#drag = null;
      return true;
    }
    if (this.#tool === '') return false;
    this.setTool('');
    return true;
  }

  choose(handle, point) {
    this.chosen = {handle, point};
    this.#events.onChosen(handle, point);
  }

  /** A pointer went down. @returns {boolean} whether it is taken */
  press(camera, sx, sy, isFinger = false) {
    if (!this.#plan) return false;
    const at = /** @type {[number, number]} */ ([camera.x(sx), camera.y(sy)]);
    if (this.#tool !== '') {
      this.#pointer = at;
      return true;
    }
    const hit = this.#pointAt(camera, sx, sy, isFinger ? kFingerHit_px : kHit_px);
    if (!hit) return false;
    this.#drag = {...hit, at, pressed: [sx, sy]};
    if (!hit.insert) this.choose(hit.handle, hit.point);
    return true;
  }

  dragged(camera, sx, sy) {
    const at = /** @type {[number, number]} */ ([camera.x(sx), camera.y(sy)]);
    this.#pointer = at;
    if (this.#drag) this.#drag.at = at;
  }

  hover(camera, sx, sy) {
    this.#pointer = [camera.x(sx), camera.y(sy)];
  }

  released(camera, sx, sy, moved) {
    const at = rounded([camera.x(sx), camera.y(sy)]);
    if (this.#tool !== '') {
      this.#addDrawn(camera, sx, sy, at);
      return;
    }
    const drag = this.#drag;
    this.#drag = null;
    if (!drag || (!moved && !drag.insert)) return;
    if (drag.insert) {
      this.#events.onEdit({do: 'insert', handle: drag.handle, point: drag.point, points: [at]});
    } else {
      this.#events.onEdit({do: 'move', handle: drag.handle, point: drag.point, points: [at]});
    }
  }

  /** Takes the chosen point out. */
  removeChosen() {
    if (!this.chosen) return false;
    this.#events.onEdit({do: 'remove', ...this.chosen});
    return true;
  }

  #addDrawn(camera, sx, sy, at) {
    const last = this.#drawn.at(-1);
    const isAgain = last && Math.hypot(camera.sx(last[0]) - sx, camera.sy(last[1]) - sy) <= kNear_px;
    if (isAgain && this.finish()) return;
    if (isAgain) return;
    this.#drawn.push(at);
    if (this.#drawn.length >= kTools[this.#tool].most) this.finish();
    else this.#events.onTool(this.#tool);
  }

  /**
   * Returns the point, or the middle of a leg, that is under a place of the screen.
   * @returns {{handle: number, point: number, insert: boolean} | null}
   */
  #pointAt(camera, sx, sy, reach) {
    /** @type {any} */
    let best = null;
    let least = reach;
    this.#each((handle, number, points) => {
      points.forEach(([x, y], point) => {
        const away = Math.hypot(camera.sx(x) - sx, camera.sy(y) - sy);
        if (away > least) return;
        best = {handle: number, point, insert: false};
        least = away;
      });
    });
    if (best) return best;
    this.#each((handle, number, points) => {
      for (const {point, x, y} of middlesOf(handle, points)) {
        const away = Math.hypot(camera.sx(x) - sx, camera.sy(y) - sy);
        if (away > least) continue;
        best = {handle: number, point, insert: true};
        least = away;
      }
    });
    return best;
  }

  /** Calls with each handle, its number and its points as they are shown. */
  #each(call) {
    this.#plan?.handles.forEach((handle, number) => {
      const drag = this.#drag?.handle === number ? this.#drag : null;
      let points = handle.points;
      if (drag) {
        points = drag.insert ? points.toSpliced(drag.point, 0, drag.at)
          : points.with(drag.point, drag.at);
      }
      call(handle, number, points);
    });
  }

  draw(ctx, camera, theme) {
    if (!this.#plan) return;
    ctx.save();
    ctx.font = `12px ${kFont}`;
    ctx.textBaseline = 'middle';
    ctx.lineJoin = 'round';
    this.#each((handle, number, points) => this.#drawHandle(ctx, camera, theme, handle, number, points));
    this.#drawTool(ctx, camera, theme);
    ctx.restore();
  }

  #drawHandle(ctx, camera, theme, handle, number, points) {
    const isChosen = this.chosen?.handle === number;
    ctx.strokeStyle = isChosen ? theme.warn : theme.text;
    ctx.lineWidth = isChosen ? 2 : 1.2;
    ctx.setLineDash([6, 4]);
    ctx.beginPath();
    camera.addLine(ctx, points, handle.shape === 'polygon');
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.fillStyle = theme.plate;
    for (const {x, y} of middlesOf(handle, points)) {
      const [sx, sy] = [camera.sx(x), camera.sy(y)];
      if (!camera.sees(sx, sy)) continue;
      ctx.beginPath();
      ctx.arc(sx, sy, kMiddle_px, 0, 2 * Math.PI);
      ctx.fill();
      ctx.stroke();
    }
    points.forEach(([x, y], point) => {
      const [sx, sy] = [camera.sx(x), camera.sy(y)];
      if (!camera.sees(sx, sy)) return;
      ctx.fillStyle = isChosen && this.chosen?.point === point ? theme.warn : theme.plate;
      ctx.beginPath();
      if (handle.kind === 'start') ctx.rect(sx - kPoint_px, sy - kPoint_px, 2 * kPoint_px, 2 * kPoint_px);
      else ctx.arc(sx, sy, kPoint_px, 0, 2 * Math.PI);
      ctx.fill();
      ctx.stroke();
      if (!isChosen) return;
      ctx.fillStyle = theme.text;
      ctx.fillText(handle.shape === 'point' ? handle.name || handle.kind : String(point + 1),
        sx + kPoint_px + 4, sy - kPoint_px);
    });
  }

  #drawTool(ctx, camera, theme) {
    if (this.#tool === '' || this.#drawn.length === 0) return;
    const points = this.#pointer ? [...this.#drawn, this.#pointer] : this.#drawn;
    ctx.strokeStyle = theme.warn;
    ctx.fillStyle = theme.warn;
    ctx.lineWidth = 2;
    ctx.beginPath();
    camera.addLine(ctx, points, kTools[this.#tool].closed);
    if (this.#tool === 'loiter' && points.length > 1) {
      const [[x, y], [rimX, rimY]] = points;
      const radius = Math.hypot(rimX - x, rimY - y) / camera.metresPerPixel;
      ctx.moveTo(camera.sx(x) + radius, camera.sy(y));
      ctx.arc(camera.sx(x), camera.sy(y), radius, 0, 2 * Math.PI);
    }
    ctx.stroke();
    for (const [x, y] of this.#drawn) {
      ctx.beginPath();
      ctx.arc(camera.sx(x), camera.sy(y), kPoint_px - 1, 0, 2 * Math.PI);
      ctx.fill();
    }
  }
}

/** The middles of the legs, where a point can be added before the point of that number. */
function middlesOf({shape}, points) {
  if (shape === 'point') return [];
  const count = shape === 'polygon' ? points.length : points.length - 1;
  return Array.from({length: Math.max(0, count)}, (_, i) => {
    const [[ax, ay], [bx, by]] = [points[i], points[(i + 1) % points.length]];
    return {point: i + 1, x: (ax + bx) / 2, y: (ay + by) / 2};
  });
}
