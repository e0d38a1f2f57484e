// What the whole mission takes in.

import {isNumber} from './geometry.js';

const kLeastExtent_m = 60;

/** Returns {left, right, bottom, top} around vehicles, starts, tasks and op area, or null. */
export function placesToFit(setup, vehicles) {
  const box = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  const add = (x, y, radius = 0) => {
    if (!isNumber(x) || !isNumber(y) || !isNumber(radius)) return;
    box.left = Math.min(box.left, x - radius);
    box.right = Math.max(box.right, x + radius);
    box.bottom = Math.min(box.bottom, y - radius);
    box.top = Math.max(box.top, y + radius);
  };
  const addPoints = (points, radius) => {
    if (!Array.isArray(points)) return;
    for (const point of points) if (Array.isArray(point)) add(point[0], point[1], radius);
  };
  for (const vehicle of vehicles) add(vehicle.x, vehicle.y);
  for (const vehicle of Array.isArray(setup?.vehicles) ? setup.vehicles : []) {
    addPoints([vehicle?.start]);
    for (const task of Array.isArray(vehicle?.tasks) ? vehicle.tasks : []) {
      addPoints(task?.points, Math.max(0, task?.radius_m ?? 0));
      addPoints(task?.area);
    }
  }
  addPoints(setup?.op_area);
  for (const obstacle of Array.isArray(setup?.obstacles) ? setup.obstacles : []) {
    addPoints(obstacle?.polygon);
  }
  if (!(box.left <= box.right)) return null;
  const extent_m = Math.max(box.right - box.left, box.top - box.bottom);
  const missing_m = Math.max(0, kLeastExtent_m - extent_m);
  box.left -= missing_m / 2;
  box.right += missing_m / 2;
  return box;
}
