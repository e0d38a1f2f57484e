// Puts the map together from its layers: sea floor, pulses, tasks, trails, vehicles, labels.

import {drawDrawings, tidyDrawings} from './draw_drawings.js';
import {Backgrounds} from './background.js';
import {FloorPicture, drawGridNumbers, drawGround} from './draw_ground.js';
import {LabelLayer} from './draw_labels.js';
import {drawMark, drawMeasure, drawNorth, drawScaleBar} from './draw_overlay.js';
import {drawPulses, drawRings} from './draw_signals.js';
import {drawRanges, drawTargets, drawTasks, tasksKey} from './draw_tasks.js';
import {drawSwaths, drawTrailEnds, drawTrails} from './draw_trails.js';
import {drawBelieved, drawReported, drawVehicles} from './draw_vehicles.js';
import {isNumber} from './geometry.js';
import {MapLayer, Motion} from './map_layer.js';
import {placesOf, PresentPlan} from './present_plan.js';
import {acousticKinds} from './world.js';

// The picture of the trails is drawn again so often, for their fading.
const kTrails_ms = 3000;
const kSwaths_ms = 1000;
// Many vehicles turn to another waypoint at any time.
const kTasks_ms = 300;
// On a slow machine once in this many frames.
const kPulses_ms = 200;
const kPulsesFrames = 6;
const kFewPulses = 40;

function arrayOr(value) {
  return Array.isArray(value) ? value : [];
}

/** Returns what the setup has to be covered: [{width_m, vehicles: Set}]. */
export function coverageOf(setup) {
  return arrayOr(setup?.coverage)
      .filter((each) => isNumber(each?.width_m) && each.width_m > 0)
      .map((each) => ({width_m: each.width_m, vehicles: new Set(arrayOr(each.vehicles))}));
}

/** Returns the polygons that are surveyed or to be covered, each once. */
export function surveysOf(setup) {
  const polygons = new Map();
  const add = (polygon) => {
    const places = placesOf(polygon);
    if (places.length > 2) polygons.set(JSON.stringify(places), places);
  };
  for (const vehicle of arrayOr(setup?.vehicles)) {
    for (const task of arrayOr(vehicle?.tasks)) add(task?.area);
  }
  for (const each of arrayOr(setup?.coverage)) arrayOr(each?.areas).forEach(add);
  return [...polygons.values()];
}

export class MapPainter {
  motion = new Motion();
  /** What a user has put under the mission. */
  backgrounds = new Backgrounds();
  /** @type {any} */
  #world = null;
  #area = [];
  #surveys = [];
  /** @type {any[]} */
  #obstacles = [];
  /** @type {any[]} */
  #coverage = [];
  /** @type {FloorPicture | null} */
  #floor = null;
  #plan = new PresentPlan(null);
  /** @type {any[]} */
  #kept = [];
  #version = 0;   // Of the setup and the choice of layers.
  #ground = new MapLayer({opaque: true});
  #pulses = new MapLayer();
  #pulsesKey = 0;
  #tasks = new MapLayer();
  #tasksKey = '';
  #tasksFor = null;
  #swaths = new MapLayer();
  #swathStamp = {version: -1, until: Infinity, count: 0};
  #trails = new MapLayer();
  #trailStamp = {version: -1, until: Infinity, count: 0};
  #labels = new LabelLayer();
  #drawings = [];
  #drawingsFor = null;

  setWorld(world, setup) {
    this.#world = world;
    this.#area = placesOf(setup?.op_area);
    this.#surveys = surveysOf(setup);
    this.#obstacles = arrayOr(setup?.obstacles).map(({id, polygon}) => (
      {id: String(id), polygon: placesOf(polygon)}));
    this.#coverage = coverageOf(setup);
    this.#floor = setup?.floor ? new FloorPicture(setup.floor) : null;
    this.#plan = new PresentPlan(setup);
    // What is to be seen beside a label: obstacles and loiters.
    this.#kept = [...this.#obstacles.map(({polygon}) => polygon),
      ...[...this.#plan.at(-Infinity).values()].flat().filter(({closed}) => closed).map(({points}) => points)]
        .filter((points) => points.length > 2 && points.length < 1000).slice(0, 500);
    this.#trailStamp.version = -1;
    this.#swathStamp.version = -1;
    this.changed();
  }

  /** Takes the mission's events: updates move the plan. */
  setEvents(events) { this.#plan.setEvents(events); }

  /** To be called when other layers are to be seen. */
  changed() { ++this.#version; }

  /**
   * `view` is {camera, ratio, theme, layers, pulseStyle, selected, link, hovered, mark, ends}; `shown` comes from
   * World.at. The transform of `ctx` is that of CSS pixels.
   */
  paint(ctx, view, shown, nowMs) {
    const {camera, theme, layers} = view;
    const {t, vehicles} = shown;
    this.motion.frame(nowMs);
    ctx.fillStyle = theme.water;
    ctx.fillRect(0, 0, camera.width, camera.height);
    this.#show(this.#ground, ctx, view, String(this.backgrounds.version), nowMs, (to, wide) =>
      drawGround(to, wide, theme,
                 {floor: this.#floor, area: this.#area, surveys: this.#surveys,
                  obstacles: this.#obstacles, backgrounds: this.backgrounds.all, layers}));
    if (this.#world) {
      if (layers.area && this.#coverage.length > 0) this.#paintSwaths(ctx, view, shown, nowMs);
      if (layers.pulses) this.#paintPulses(ctx, view, t, nowMs);
      if (layers.tasks) this.#paintTasks(ctx, view, shown, nowMs);
      if (layers.trails) this.#paintTrails(ctx, view, shown, nowMs);
      if (layers.drawings) {
        drawDrawings(ctx, camera, theme, this.drawingsOf(this.#world.frame));
      }
      if (layers.ranges) {
        drawRanges(ctx, camera, theme, vehicles, this.#world.rules, view.selected);
      }
      if (layers.rings) {
        const places = new Map(vehicles.map((vehicle) => [vehicle.name, vehicle]));
        drawRings(ctx, camera, theme, this.#world.rings(t), places);
      }
      if (layers.tasks) drawTargets(ctx, camera, theme, vehicles, view.selected);
      if (layers.reported) drawReported(ctx, camera, theme, vehicles, t);
      drawBelieved(ctx, camera, theme, vehicles);
      drawVehicles(ctx, camera, theme, vehicles, view, view.ratio);
      if (layers.names) {
        this.#labels.draw(ctx, camera, theme, vehicles, t, view, nowMs, this.#kept);
      }
    }
    if (layers.grid) drawGridNumbers(ctx, camera, theme);
    if (view.mark) drawMark(ctx, camera, theme, view.mark);
    if (view.ends.length === 2) drawMeasure(ctx, camera, theme, view.ends);
    drawScaleBar(ctx, camera, theme);
    drawNorth(ctx, camera, theme);
  }

  /** The drawings of programs in a frame. */
  drawingsOf(frame) {
    if (this.#drawingsFor !== frame) {
      this.#drawingsFor = frame;
      this.#drawings = tidyDrawings(frame?.drawings);
    }
    return this.#drawings;
  }

  #show(layer, ctx, {camera, ratio, theme}, key, nowMs, draw) {
    layer.show(ctx, camera, ratio, `${this.#version} ${theme.light} ${key}`, nowMs, this.motion,
               draw);
  }

  // Few pulses fade smoothly; many are a picture that is drawn again some times in a second.
  #paintPulses(ctx, view, t, nowMs) {
    // Rings show the same, and how it travels.
    const asRings = view.layers.rings ? acousticKinds(this.#world.rules) : [];
    const pulses = this.#world.pulses(t).filter(({kind}) => !asRings.includes(kind));
    const {pulseStyle: style} = view;
    const choice = {style, isChosen: this.#chosenPulse(view)};
    if (pulses.length <= kFewPulses) {
      drawPulses(ctx, view.camera, view.theme, pulses, choice);
      return;
    }
    const wait_ms = Math.max(kPulses_ms, kPulsesFrames * this.motion.frame_ms);
    if (this.#pulses.age(nowMs) > wait_ms) ++this.#pulsesKey;
    const key = `${this.#pulsesKey} ${style} ${view.selected} ${view.link?.from} ${view.link?.to}`;
    this.#show(this.#pulses, ctx, view, key, nowMs, (to, wide) =>
      drawPulses(to, wide, view.theme, pulses, choice));
  }

  // A pulse has its sender and its receiver in its label: ALPHA2BRAVO, ALPHA2BRAVO_MSG.
  #chosenPulse({selected, link}) {
    const upper = (name) => String(name).toUpperCase();
    const labels = link ? [`${upper(link.from)}2${upper(link.to)}`] : [];
    const own = selected ? upper(selected) : null;
    return ({label}) => {
      const plain = String(label ?? '').replace(/_MSG$/, '');
      return labels.includes(plain)
          || (own !== null && (plain.startsWith(`${own}2`) || plain.endsWith(`2${own}`)));
    };
  }

  #paintTasks(ctx, view, {t, vehicles}, nowMs) {
    const {selected} = view;
    if (this.#tasks.age(nowMs) > kTasks_ms || this.#tasksFor !== selected) {
      this.#tasksKey = tasksKey(vehicles, selected, t);
      this.#tasksFor = selected;
    }
    const plan = this.#plan.at(t);
    this.#show(this.#tasks, ctx, view, `${this.#plan.version} ${this.#tasksKey}`, nowMs, (to, wide) =>
      drawTasks(to, wide, view.theme, vehicles, plan, selected, t));
  }

  // A picture of trails is drawn again where they were changed, where time has gone back, and when
  // it is too old.
  #renew(stamp, layer, most_ms, t, nowMs) {
    const version = this.#world.trailsVersion;
    if (stamp.version === version && t >= stamp.until && layer.age(nowMs) <= most_ms) return;
    stamp.version = version;
    stamp.until = t;
    ++stamp.count;
  }

  #paintSwaths(ctx, view, {t, vehicles}, nowMs) {
    this.#renew(this.#swathStamp, this.#swaths, kSwaths_ms, t, nowMs);
    this.#show(this.#swaths, ctx, view, this.#swathStamp.count, nowMs, (to, wide) =>
      drawSwaths(to, wide, view.theme, this.#world, this.#coverage, vehicles, t));
  }

  #paintTrails(ctx, view, {t, vehicles}, nowMs) {
    const [world, stamp] = [this.#world, this.#trailStamp];
    this.#renew(stamp, this.#trails, kTrails_ms, t, nowMs);
    this.#show(this.#trails, ctx, view, stamp.count, nowMs, (to, wide) => {
      stamp.until = t;
      drawTrails(to, wide, view.theme, world, vehicles, t);
    });
    drawTrailEnds(ctx, view.camera, view.theme, world, vehicles, stamp.until, t);
  }
}
