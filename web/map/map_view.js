// The map: draws a world onto a canvas, and takes what the user does with it.
//
//   const map = new MapView(canvas, {onVehicle: (name) => ..., onPlace: (place) => ...});
//   map.setWorld(world, setup);
//   requestAnimationFrame(function show(now) { map.draw(now); requestAnimationFrame(show); });

import {context2d} from '../page/dom.js';
import {drawTitle} from './draw_overlay.js';
import {kPulseStyles} from './draw_signals.js';
import {readTheme} from './draw_theme.js';
import {drawnLength} from './draw_vehicles.js';
import {LocalFrame, isNumber} from './geometry.js';
import {Camera} from './map_camera.js';
import {MapInput} from './map_input.js';
import {MapPainter} from './map_painter.js';
import {placesToFit} from './map_places.js';

const kLayers = {
  trails: true, reported: true, tasks: true, ranges: false, pulses: true, rings: true,
  contours: true, area: true, grid: true, names: true, drawings: true, background: true,
};
const kHit = 16;
const kMaxPixels = 16e6;

export class MapView {
  #canvas;
  #ctx;
  #events;
  #camera;
  #ratio = 1;
  /** @type {any} */
  #theme = null;
  #frame = new LocalFrame(null);
  /** @type {import('./world.js').World | null} */
  #world = null;
  /** @type {any} Of /api/setup. */
  #setup = null;
  #layers = {...kLayers};
  /** @type {string | null} */
  #follow = null;
  /** @type {string | null} */
  #selected = null;
  /** @type {any} */
  #link = null;
  #pulseStyle = kPulseStyles[0][0];
  /** @type {string | null} */
  #hovered = null;
  /** @type {any} */
  #mark = null;
  #measuring = false;
  /** @type {any[]} Of the measured distance. */
  #ends = [];
  /** @type {string | false} How far the user is with it. */
  #open = false;
  /** @type {{t: number, vehicles: any[]}} */
  #shown = {t: 0, vehicles: []};
  #wantFit = true;    // Until a view was asked for, the whole mission is shown.
  /** @type {any} The view after the last fit(). */
  #fitted = null;
  #painter = new MapPainter();
  /** @type {import('../plan/plan_layer.js').PlanLayer | null} */
  #planLayer = null;
  /** @type {any[]} */
  #missionEvents = [];
  #isPlanned = false;  // Another plan than the mission's is drawn.
  /** Title and time are drawn, as in a picture that is saved. */
  titled = false;

  /**
   * `events`, all optional: onVehicle(name) and onPlace({x, y, lat, lon}) of a click;
   * onPointer(place), null when the mouse has left the map; onView(view) when the view was changed.
   */
  constructor(canvas, events = {}) {
    this.#canvas = canvas;
    this.#ctx = context2d(canvas, {alpha: false});
    this.#events = events;
    this.#camera = new Camera(canvas.clientWidth, canvas.clientHeight);
    this.#resize();
    new MapInput(canvas, {
      pan: (dx, dy) => this.#drag(dx, dy),
      zoom: (factor, sx, sy) => this.zoom(factor, {sx, sy}),
      click: (sx, sy) => this.#click(sx, sy),
      hover: (sx, sy) => this.#hover(sx, sy),
      leave: () => {
        this.#setHovered(null);
        this.#events.onPointer?.(null);
      },
      press: (sx, sy) => this.#press(sx, sy),
      dragged: (sx, sy) => {
        if (this.#measuring) this.#moveEnd(sx, sy);
        else this.#planLayer?.dragged(this.#camera, sx, sy);
      },
      released: (sx, sy, moved) => this.#release(sx, sy, moved),
    });
    new MutationObserver(() => this.#theme = null)
        .observe(document.documentElement, {attributeFilter: ['class', 'style']});
  }

  setWorld(world, setup) {
    this.#world = world;
    this.#setup = setup ?? world?.setup ?? null;
    this.#frame = new LocalFrame(this.#setup?.origin);
    this.#painter.setWorld(world, this.#setup);
    this.#missionEvents = [];
    this.#isPlanned = false;
    this.#shown = {t: 0, vehicles: []};
  }

  /** Puts what can be moved of a plan above all else. */
  setPlanLayer(layer) { this.#planLayer = layer; }

  /** Draws another plan than that of the mission: of a setup with vehicles; null: the mission's. */
  setPlan(setup) {
    const {vehicles, obstacles, op_area} = setup ?? this.#setup ?? {};
    this.#painter.setWorld(this.#world, {...this.#setup, vehicles, obstacles, op_area});
    this.#isPlanned = setup !== null;
    this.#painter.setEvents(this.#isPlanned ? [] : this.#missionEvents);
  }

  /** {cx, cy, metresPerPixel, follow, layers, pulseStyle}; setting takes what it is given of these. */
  get view() {
    const {cx, cy, metresPerPixel} = this.#camera;
    return {cx, cy, metresPerPixel, follow: this.#follow, layers: {...this.#layers},
      pulseStyle: this.#pulseStyle};
  }

  /** @param {any} view  as of the getter; what it lacks stays */
  set view(view) {
    if (view?.layers) {
      for (const name of Object.keys(kLayers)) {
        if (name in view.layers) this.#layers[name] = Boolean(view.layers[name]);
      }
      this.#painter.changed();
    }
    if (kPulseStyles.some(([style]) => style === view?.pulseStyle)) {
      this.#pulseStyle = view.pulseStyle;
      this.#painter.changed();
    }
    if (view && 'follow' in view) this.#follow = view.follow || null;
    if (isNumber(view?.cx) || isNumber(view?.cy) || isNumber(view?.metresPerPixel)) {
      this.#camera.set(view.cx, view.cy, view.metresPerPixel);
      this.#wantFit = false;
    }
    this.#tellView();
  }

  get selected() { return this.#selected; }
  get measuring() { return this.#measuring; }
  /** Vehicles as they were last drawn: those of World.at. */
  get shown() { return this.#shown; }

  /** Takes the mission's events: updates move the plan. */
  setEvents(events) {
    this.#missionEvents = events;
    if (!this.#isPlanned) this.#painter.setEvents(events);
  }

  select(name) { this.#selected = name || null; }

  /** The link whose pulses stand out, {from, to}, or null. */
  setLink(link) { this.#link = link; }

  /** Shows a place that the user has chosen, {x, y, label}, or none (null). */
  setMark(mark) { this.#mark = isNumber(mark?.x) && isNumber(mark?.y) ? mark : null; }

  /** Puts files under the mission; returns texts for the user. */
  async addBackgrounds(files) {
    const {left, right, bottom, top} = this.#camera;
    return this.#painter.backgrounds.take([...files], this.#frame, {left, right, bottom, top},
      this.#missionBox());
  }

  /** Puts tiles under the mission (tiles.js has the source); returns a text for the user, or "". */
  addTiles(name, source) {
    return this.#painter.backgrounds.addTiles(name, source, this.#frame, this.#missionBox());
  }

  /** Is given texts about backgrounds that come later: tiles that cannot be had. */
  set onBackgroundProblem(listener) { this.#painter.backgrounds.onProblem = listener; }

  #missionBox() {
    return placesToFit(this.#setup, [], () => null);
  }

  removeBackgrounds() { this.#painter.backgrounds.clear(); }
  get backgrounds() { return this.#painter.backgrounds.all.map(({name}) => name); }

  /** Shows the whole mission. */
  fit() {
    this.#follow = null;
    const drawings = this.#layers.drawings ? this.#painter.drawingsOf(this.#world?.frame) : [];
    const box = placesToFit(this.#setup, this.#shown.vehicles,
        (name) => this.#world?.trail(name, Infinity), drawings);
    if (box) this.#camera.fit(box.left, box.bottom, box.right, box.top);
    this.#fitted = {...this.view, trails: this.#world?.trailsVersion};
    this.#tellView();
  }

  /** Returns false where the vehicle is not on the map. */
  centre(name) {
    const vehicle = this.#shown.vehicles.find((v) => v.name === name);
    if (!vehicle || vehicle.x === null) return false;
    this.#camera.set(vehicle.x, vehicle.y);
    this.#wantFit = false;
    this.#tellView();
    return true;
  }

  /** Keeps the vehicle in the middle until null is given or the map is dragged. */
  follow(name) {
    this.#follow = name || null;
    this.#wantFit = false;
    this.#tellView();
  }

  /** Zooms in by `factor` > 1; `at`, {sx, sy} (pixels) or {x, y} (metres), stays, or the middle. */
  zoom(factor, at) {
    const camera = this.#camera;
    const sx = at?.sx ?? (isNumber(at?.x) ? camera.sx(at.x) : undefined);
    const sy = at?.sy ?? (isNumber(at?.y) ? camera.sy(at.y) : undefined);
    if (this.#follow) camera.zoom(factor);
    else camera.zoom(factor, sx, sy);
    this.#wantFit = false;
    this.#tellView();
  }

  /** Moves the view by pixels: right, down. */
  pan(dx, dy) { this.#drag(-dx, -dy); }

  /** While on, two clicks or a drag measure; off takes the measured line away. */
  measure(on) {
    this.#measuring = Boolean(on);
    this.#ends = [];
    this.#open = false;
    this.#canvas.style.cursor = this.#measuring ? 'crosshair' : '';
  }

  draw(nowMs) {
    this.#resize();
    if (this.#world) this.#shown = this.#world.at(nowMs);
    if (this.#wantFit && this.#world?.frame) {
      this.fit();
      this.#wantFit = false;
    } else if (this.#wasFittedWithoutTrails()) {
      this.fit();
    }
    const followed = this.#follow && this.#shown.vehicles.find((v) => v.name === this.#follow);
    if (followed && followed.x !== null) this.#camera.set(followed.x, followed.y);
    this.#ctx.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    this.#paint(this.#ctx, nowMs);
    this.#planLayer?.draw(this.#ctx, this.#camera, this.#theme);
    if (this.titled) this.#paintTitle(this.#ctx);
  }

  #paintTitle(ctx) {
    drawTitle(ctx, this.#camera, this.#theme, this.#setup?.mission, this.#shown.t);
  }

  // Trails came since, and the user has left the view as it was.
  #wasFittedWithoutTrails() {
    const fitted = this.#fitted;
    if (!fitted || fitted.trails !== 0 || this.#world?.trailsVersion !== 1) return false;
    const {cx, cy, metresPerPixel, follow} = this.view;
    return cx === fitted.cx && cy === fitted.cy && metresPerPixel === fitted.metresPerPixel
        && follow === null;
  }

  /** Returns a PNG of what the map shows, with scale bar, title and time. */
  toPng() {
    const picture = document.createElement('canvas');
    picture.width = this.#canvas.width;
    picture.height = this.#canvas.height;
    const ctx = context2d(picture, {alpha: false});
    ctx.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    this.#paint(ctx, performance.now());
    this.#paintTitle(ctx);
    return new Promise((resolve, reject) => {
      picture.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error('the browser made no PNG'));
      }, 'image/png');
    });
  }

  #paint(ctx, nowMs) {
    this.#theme ??= readTheme();
    this.#painter.paint(ctx, {
      camera: this.#camera, ratio: this.#ratio, theme: this.#theme, layers: this.#layers,
      pulseStyle: this.#pulseStyle, link: this.#link, selected: this.#selected, hovered: this.#hovered, mark: this.#mark, ends: this.#ends,
    }, this.#shown, nowMs);
  }

  #resize() {
    const {clientWidth: width, clientHeight: height} = this.#canvas;
    const asked = globalThis.devicePixelRatio || 1;
    const ratio = Math.min(asked, Math.sqrt(kMaxPixels / Math.max(1, width * height)));
    const [w, h] = [width, height].map((pixels) => Math.max(1, Math.round(pixels * ratio)));
    if (w !== this.#canvas.width || h !== this.#canvas.height) {
      this.#canvas.width = w;
      this.#canvas.height = h;
    }
    this.#ratio = ratio;
    this.#camera.width = Math.max(1, width);
    this.#camera.height = Math.max(1, height);
  }

  #placeAt(sx, sy) {
    const [x, y] = [this.#camera.x(sx), this.#camera.y(sy)];
    return {x, y, ...this.#frame.toGeo(x, y)};
  }

  // The nearest vehicle under a point of the screen, or null.
  #vehicleAt(sx, sy) {
    let [best, least] = [null, Infinity];
    for (const vehicle of this.#shown.vehicles) {
      if (vehicle.x === null) continue;
      const away = Math.hypot(this.#camera.sx(vehicle.x) - sx, this.#camera.sy(vehicle.y) - sy);
      if (away <= Math.max(kHit, drawnLength(vehicle, this.#camera) / 2) && away < least) {
        [best, least] = [vehicle.name, away];
      }
    }
    return best;
  }

  #setHovered(name) {
    this.#hovered = name;
    if (!this.#measuring) this.#canvas.style.cursor = name ? 'pointer' : '';
  }

  #hover(sx, sy) {
    this.#planLayer?.hover(this.#camera, sx, sy);
    this.#setHovered(this.#vehicleAt(sx, sy));
    if (this.#measuring && this.#ends.length === 2 && this.#open) this.#moveEnd(sx, sy);
    this.#events.onPointer?.(this.#placeAt(sx, sy));
  }

  #click(sx, sy) {
    const name = this.#vehicleAt(sx, sy);
    if (name) this.#events.onVehicle?.(name);
    else this.#events.onPlace?.(this.#placeAt(sx, sy));
  }

  // A measured line is open from the first click or press until the second click or the release.
  #press(sx, sy) {
    if (!this.#measuring) return this.#planLayer?.press(this.#camera, sx, sy) ?? false;
    if (!this.#open) {
      this.#ends = [this.#placeAt(sx, sy), this.#placeAt(sx, sy)];
      this.#open = 'pressed';
    } else {
      this.#moveEnd(sx, sy);
      this.#open = 'closing';
    }
    return true;
  }

  #moveEnd(sx, sy) {
    if (this.#ends.length === 2 && this.#open) this.#ends[1] = this.#placeAt(sx, sy);
  }

  #release(sx, sy, moved) {
    if (!this.#measuring) {
      this.#planLayer?.released(this.#camera, sx, sy, moved);
      return;
    }
    this.#moveEnd(sx, sy);
    this.#open = this.#open === 'pressed' && !moved ? 'clicked' : false;
  }

  #drag(dx, dy) {
    if (!isNumber(dx) || !isNumber(dy)) return;
    const camera = this.#camera;
    this.#follow = null;
    this.#wantFit = false;
    camera.set(camera.cx - dx * camera.metresPerPixel, camera.cy + dy * camera.metresPerPixel);
    this.#tellView();
  }

  #tellView() {
    this.#painter.motion.moved();
    this.#events.onView?.(this.view);
  }
}
