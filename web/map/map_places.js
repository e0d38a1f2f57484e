// What the whole mission takes in.

import {isNumber} from './geometry.js';

const kLeastExtent_m = 60;
// A vehicle that went no farther than this from where it began has stayed there, and drifts.
const kMoved_m = 25;

// Drawings of programs count up to so far beside the rest.
const kDrawn_m = 1000;
const kDrawnExtents = 5;
const kReach_m = 1e6;

const listOf = (value) => (Array.isArray(value) ? value : []);

class Box {
  left = Infinity;
  right = -Infinity;
  bottom = Infinity;
  top = -Infinity;

  add(x, y, radius = 0) {
    if (!isNumber(x) || !isNumber(y) || !isNumber(radius)) return;
    this.left = Math.min(this.left, x - radius);
    this.right = Math.max(this.right, x + radius);
    this.bottom = Math.min(this.bottom, y - radius);
    this.top = Math.max(this.top, y + radius);
  }

  addPoints(points, radius) {
    for (const point of listOf(points)) if (Array.isArray(point)) this.add(point[0], point[1], radius);
  }

  get isEmpty() { return !(this.left <= this.right); }
  get extent_m() { return Math.max(this.right - this.left, this.top - this.bottom); }

  /** True where (x, y) lies at most `margin` beside it. */
  isNear(x, y, margin) {
    return x >= this.left - margin && x <= this.right + margin && y >= this.bottom - margin
        && y <= this.top + margin;
  }
}

function hasPlan(vehicle) {
  return [...listOf(vehicle?.tasks), ...listOf(vehicle?.behaviors)].some((part) =>
    listOf(part?.points).length > 0 || listOf(part?.area).length > 0);
}

// A drawing may lie anywhere, by a mistake of its program too: one that is far beside all else does
// not make that small.
function addDrawings(box, drawings) {
  const margin = box.isEmpty ? kReach_m : Math.max(kDrawn_m, kDrawnExtents * box.extent_m);
  for (const {points, radius} of drawings) {
    const own = new Box();
    own.addPoints(points, Math.max(0, radius || 0));
    const isNear = box.isEmpty ? own.extent_m <= kReach_m
      : box.isNear(own.left, own.bottom, margin) && box.isNear(own.right, own.top, margin);
    if (own.isEmpty || !isNear) continue;
    box.add(own.left, own.bottom);
    box.add(own.right, own.top);
  }
}

/**
 * Returns {left, right, bottom, top} around what is planned and what has moved, or null. A vehicle
 * without a plan that stays where it began counts only where it lies no farther beside the others
 * than they reach: a shore station some kilometres away does not make all else small.
 * @param setup  of the mission
 * @param vehicles  of the frame
 * @param {(name: string) => any} trailOf  returns x, y and count: where a vehicle was; or null
 * @param drawings  of programs, as tidyDrawings (draw_drawings.js) returns them
 */
export function placesToFit(setup, vehicles, trailOf = () => null, drawings = []) {
  const box = new Box();
  box.addPoints(setup?.op_area);
  for (const obstacle of listOf(setup?.obstacles)) box.addPoints(obstacle?.polygon);
  const still = [];
  const known = new Map(listOf(setup?.vehicles).map((vehicle) => [vehicle?.name, vehicle]));
  const shown = new Map(vehicles.map((vehicle) => [vehicle.name, vehicle]));
  for (const name of new Set([...known.keys(), ...shown.keys()])) {
    const [vehicle, now, trail] = [known.get(name), shown.get(name), trailOf(name)];
    const own = new Box();
    own.addPoints([vehicle?.start]);
    own.add(now?.x, now?.y);
    for (let i = 0; i < (trail?.count ?? 0); ++i) own.add(trail.x[i], trail.y[i]);
    if (!hasPlan(vehicle) && !(own.extent_m > kMoved_m)) {
      if (!own.isEmpty) still.push(own);
      continue;
    }
    for (const part of [...listOf(vehicle?.tasks), ...listOf(vehicle?.behaviors)]) {
      box.addPoints(part?.points, Math.max(0, part?.radius_m ?? 0));
      box.addPoints(part?.area);
    }
    box.add(own.left, own.bottom);
    box.add(own.right, own.top);
  }
  const margin = box.isEmpty ? Infinity : Math.max(kLeastExtent_m, box.extent_m);
  const near = still.filter(({left, bottom}) => box.isEmpty || box.isNear(left, bottom, margin));
  for (const own of near) {
    box.add(own.left, own.bottom);
    box.add(own.right, own.top);
  }
  addDrawings(box, drawings);
  if (box.isEmpty) return null;
  const missing_m = Math.max(0, kLeastExtent_m - box.extent_m);
  const {left, right, bottom, top} = box;
  return {left: left - missing_m / 2, right: right + missing_m / 2, bottom, top};
}
