// Trails, paler with age, and the swaths that sensors have covered along them. What is older than the picture of the layer is drawn into it, what came
// since is drawn each time.

import {vehicleColor} from '../page/colors.js';

// Seconds of age, and how opaque what is younger than that is.
const kFades = [[30, 0.95], [60, 0.8], [120, 0.66], [240, 0.52], [480, 0.4], [Infinity, 0.28]];
const kWidth = 1.8;
const kSwath = 0.2;

/** Draws all trails from their beginning to `t`. */
export function drawTrails(ctx, camera, theme, world, vehicles, t) {
  prepare(ctx);
  for (const vehicle of vehicles) {
    const trail = world.trail(vehicle.name, t);
    if (!trail || trail.count < 2) continue;
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    let end = trail.count - 1;
    for (const [age_s, opacity] of kFades) {
      const begin = firstAfter(trail, t - age_s, end);
      if (begin < end) {
        ctx.globalAlpha = opacity;
        ctx.beginPath();
        addPart(ctx, camera, trail, begin, end);
        ctx.stroke();
      }
      end = begin;
      if (end === 0) break;
    }
  }
  ctx.globalAlpha = 1;
}

/** Draws what came after `since`, and on to where the vehicles are now. */
export function drawTrailEnds(ctx, camera, theme, world, vehicles, since, t) {
  prepare(ctx);
  ctx.globalAlpha = kFades[0][1];
  for (const vehicle of vehicles) {
    const trail = world.trail(vehicle.name, t);
    if (!trail || trail.count === 0 || vehicle.x === null) continue;
    const begin = firstAfter(trail, since, trail.count - 1);
    const last = trail.count - 1;
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    ctx.beginPath();
    if (begin < last) addPart(ctx, camera, trail, begin, last);
    if (couldSail(trail, last, vehicle, t)) {
      camera.addSegment(ctx, trail.x[last], trail.y[last], vehicle.x, vehicle.y);
    }
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

function prepare(ctx) {
  ctx.lineWidth = kWidth;
  ctx.lineJoin = 'bevel';
  ctx.lineCap = 'butt';
  ctx.setLineDash([]);
}

// False where the vehicle has been put elsewhere since the trail's last point.
function couldSail(trail, last, {x, y}, t) {
  return Math.hypot(trail.x[last] - x, trail.y[last] - y) <= 20 + 40 * (t - trail.t[last]);
}

// Index of the last point in [0, end] that is not later than `t`; 0 where all are.
function firstAfter(trail, t, end) {
  let low = 0;
  let high = end;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (trail.t[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * Draws what vehicles have passed within reach of their sensors until `t`, each pass as broad as
 * its sensor sees. `coverage` is [{width_m, vehicles: [name, ...]}].
 */
export function drawSwaths(ctx, camera, theme, world, coverage, vehicles, t) {
  ctx.globalAlpha = kSwath;
  ctx.lineJoin = 'round';
  ctx.lineCap = 'round';
  ctx.setLineDash([]);
  for (const {width_m: width, vehicles: names} of coverage) {
    const margin = width / camera.metresPerPixel / 2;
    ctx.lineWidth = 2 * margin;
    for (const vehicle of vehicles) {
      if (!names.has(vehicle.name)) continue;
      const trail = world.trail(vehicle.name, t);
      if (!trail || trail.count < 2) continue;
      ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
      ctx.beginPath();
      addPart(ctx, camera, trail, 0, trail.count - 1, margin);
      ctx.stroke();
    }
  }
  ctx.lineCap = 'butt';
  ctx.globalAlpha = 1;
}

// Adds points begin..end; left out are those out of sight and those that the line through others
// misses by less than half a pixel (Reumann and Witkam 1974): it is the corners that cost time.
function addPart(ctx, camera, trail, begin, end, margin = 0) {
  const {width, height, metresPerPixel, cx, cy} = camera;
  const scale = 1 / metresPerPixel;
  const offsetX = width / 2 - cx * scale;
  const offsetY = height / 2 + cy * scale;
  // The line goes from the anchor in the direction (ux, uy), so far to (lx, ly), `along` pixels.
  let ax = trail.x[begin] * scale + offsetX;
  let ay = offsetY - trail.y[begin] * scale;
  let [lx, ly, ux, uy, along] = [ax, ay, 0, 0, 0];
  let pen = false;
  const rim = 20 + margin;
  const lineTo = (x, y) => {
    const seen = !((x < -rim && ax < -rim) || (y < -rim && ay < -rim) ||
        (x > width + rim && ax > width + rim) || (y > height + rim && ay > height + rim));
    if (seen) {
      if (!pen) ctx.moveTo(ax, ay);
      ctx.lineTo(x, y);
    }
    pen = seen;
    ax = x;
    ay = y;
  };
  for (let i = begin + 1; i <= end; ++i) {
    const x = trail.x[i] * scale + offsetX;
    const y = offsetY - trail.y[i] * scale;
    const [dx, dy] = [x - ax, y - ay];
    const ahead = dx * ux + dy * uy;
    if (along > 0 && Math.abs(dx * uy - dy * ux) < 0.5 && ahead >= along) {
      along = ahead;
    } else {
      if (along > 0) lineTo(lx, ly);
      const [nx, ny] = [x - ax, y - ay];
      const length = Math.hypot(nx, ny);
      if (length < 1.2 && i < end) {
        along = 0;
        continue;
      }
      ux = length > 0 ? nx / length : 0;
      uy = length > 0 ? ny / length : 0;
      along = length;
    }
    lx = x;
    ly = y;
  }
  lineTo(lx, ly);
}
