// What the vehicles are to do and are at (waypoints, legs, loiters, regions, where they steer for),
// and how far they send and receive.

import {vehicleColor} from '../page/colors.js';
import {finite, isNumber} from './geometry.js';
import {kFont} from './draw_theme.js';
import {addCircle} from './draw_signals.js';

// Opacity of what is not active: planned, or done.
const kDimmed = 0.36;
const kDimmedChosen = 0.55;
/** A decision older than this is of a vehicle that decides no longer. */
const kOldDecision_s = 3;

/**
 * Returns the names of the tasks and behaviors that a vehicle is at: the task of its helm, and all
 * that took part in its last decision.
 */
export function activeNames(vehicle, t) {
  const names = new Set();
  const {helm, decision} = vehicle;
  if (helm?.task && helm.state !== 'PARK') names.add(helm.task);
  if (decision && Math.abs(t - decision.t) <= kOldDecision_s && Array.isArray(decision.aims)) {
    for (const {name} of decision.aims) names.add(name);
  }
  return names;
}

/** Changes when what drawTasks draws has changed. */
export function tasksKey(vehicles, selected, t) {
  let key = `${selected}`;
  for (const vehicle of vehicles) {
    key += `|${[...activeNames(vehicle, t)].join()}:${vehicle.helm?.waypoint}`;
  }
  return key;
}

/**
 * Draws the plan: waypoints, legs, loiters, regions and stations of all tasks and behaviors, dimmed
 * before and after they are active; the leg that is being sailed broader.
 * `planOf`: name to [{name, points, closed, radius_m, marked, area}], all points being finite.
 */
export function drawTasks(ctx, camera, theme, vehicles, planOf, selected, t) {
  for (const isActive of [false, true]) {
    for (const vehicle of vehicles) {
      const plan = planOf.get(vehicle.name) ?? [];
      if (plan.length === 0) continue;
      const active = activeNames(vehicle, t);
      const chosen = vehicle.name === selected;
      const color = vehicleColor(vehicle.name, vehicle.color, theme.light);
      ctx.strokeStyle = color;
      ctx.fillStyle = color;
      for (const part of plan) {
        if (active.has(part.name) === isActive) {
          drawPart(ctx, camera, part, vehicle.helm, {isActive, chosen});
        }
      }
    }
  }
  ctx.globalAlpha = 1;
}

function drawPart(ctx, camera, part, helm, {isActive, chosen}) {
  const dim = chosen ? kDimmedChosen : kDimmed;
  const opacity = isActive ? 0.9 : dim;
  const {points} = part;
  ctx.lineWidth = isActive || chosen ? 1.6 : 1.2;
  if (part.area.length > 2) {
    ctx.globalAlpha = isActive ? 0.8 : dim;
    ctx.setLineDash([9, 4]);
    ctx.beginPath();
    camera.addLine(ctx, part.area, true);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  if (points.length === 0) return;
  ctx.globalAlpha = opacity;
  ctx.beginPath();
  camera.addLine(ctx, points, Boolean(part.closed));
  ctx.stroke();
  if (isActive && helm?.task === part.name) {
    drawLeg(ctx, camera, part, points, helm.waypoint, chosen);
  }
  ctx.globalAlpha = opacity;
  if (part.marked !== false) drawPoints(ctx, camera, points, chosen);
  if (part.radius_m > 0) {
    ctx.globalAlpha = opacity;
    ctx.setLineDash([4, 4]);
    ctx.beginPath();
    for (const [x, y] of points.slice(0, 200)) {
      addCircle(ctx, camera, camera.sx(x), camera.sy(y), part.radius_m / camera.metresPerPixel);
    }
    ctx.stroke();
    ctx.setLineDash([]);
  }
}

function drawLeg(ctx, camera, task, points, waypoint, chosen) {
  const to = points[waypoint];
  const from = points[waypoint - 1] ?? (task.closed ? points.at(-1) : null);
  if (!to || !from) return;
  ctx.globalAlpha = chosen ? 1 : 0.75;
  ctx.lineWidth = chosen ? 3.2 : 2.4;
  ctx.beginPath();
  camera.addSegment(ctx, from[0], from[1], to[0], to[1]);
  ctx.stroke();
}

function drawPoints(ctx, camera, points, chosen) {
  // One alone has no leg that leads to it.
  const size = points.length === 1 ? 5 : chosen ? 3.5 : 2.5;
  ctx.beginPath();
  points.slice(0, 2000).forEach((point) => {
    const [sx, sy] = [camera.sx(point[0]), camera.sy(point[1])];
    if (!camera.sees(sx, sy)) return;
    ctx.moveTo(sx + size, sy);
    ctx.arc(sx, sy, size, 0, 2 * Math.PI);
  });
  ctx.fill();
  if (!chosen || points.length < 2) return;
  ctx.font = `12px ${kFont}`;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'bottom';
  points.slice(0, 60).forEach((point, i) => {
    const [sx, sy] = [camera.sx(point[0]), camera.sy(point[1])];
    if (camera.sees(sx, sy, 0)) ctx.fillText(String(i + 1), sx + 6, sy - 4);
  });
}

/** Draws where each vehicle steers for: a dashed line to a cross in a ring. */
export function drawTargets(ctx, camera, theme, vehicles, selected) {
  for (const vehicle of vehicles) {
    const to = vehicle.helm?.to;
    if (vehicle.x === null || !Array.isArray(to) || !isNumber(to[0]) || !isNumber(to[1])) continue;
    const chosen = vehicle.name === selected;
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    ctx.globalAlpha = chosen ? 1 : 0.6;
    ctx.lineWidth = chosen ? 1.6 : 1;
    ctx.setLineDash([3, 5]);
    ctx.beginPath();
    camera.addSegment(ctx, vehicle.x, vehicle.y, to[0], to[1]);
    ctx.stroke();
    ctx.setLineDash([]);
    const [sx, sy] = [camera.sx(to[0]), camera.sy(to[1])];
    if (!camera.sees(sx, sy)) continue;
    const size = chosen ? 6 : 4;
    ctx.beginPath();
    ctx.moveTo(sx + size, sy);
    ctx.arc(sx, sy, size, 0, 2 * Math.PI);
    ctx.moveTo(sx - size - 3, sy);
    ctx.lineTo(sx + size + 3, sy);
    ctx.moveTo(sx, sy - size - 3);
    ctx.lineTo(sx, sy + size + 3);
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

/** Returns {sends_m, receives_m, critical_m} of a vehicle; null for what has no limit. */
export function rangesOf(rules, name) {
  const factor = rules?.factors?.[name];
  const range_m = finite(rules?.comms_range_m, -1);
  const limit_m = (scale) => range_m < 0 ? null : range_m * finite(scale, 1);
  const critical_m = finite(rules?.critical_range_m, 0);
  return {sends_m: limit_m(factor?.stealth), receives_m: limit_m(factor?.earange),
    critical_m: critical_m > 0 ? critical_m : null};
}

/** Draws how far each sends; of the selected also how far it receives (dashed). */
export function drawRanges(ctx, camera, theme, vehicles, rules, selected) {
  if (!rules) return;
  for (const vehicle of vehicles) {
    if (vehicle.x === null) continue;
    const [sx, sy] = [camera.sx(vehicle.x), camera.sy(vehicle.y)];
    const chosen = vehicle.name === selected;
    const {sends_m, receives_m, critical_m} = rangesOf(rules, vehicle.name);
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    const circle = (radius_m, opacity, width, dash) => {
      if (radius_m === null) return;
      ctx.globalAlpha = opacity;
      ctx.lineWidth = width;
      ctx.setLineDash(dash);
      ctx.beginPath();
      addCircle(ctx, camera, sx, sy, radius_m / camera.metresPerPixel);
      ctx.stroke();
    };
    circle(sends_m, chosen ? 0.95 : 0.42, chosen ? 2 : 1.1, []);
    circle(critical_m, chosen ? 0.7 : 0.3, 0.8, []);
    if (!chosen) continue;
    circle(receives_m, 0.9, 1.6, [9, 6]);
    nameCircle(ctx, camera, theme, sx, sy, sends_m, `sends within ${text(sends_m)}`, -1);
    nameCircle(ctx, camera, theme, sx, sy, receives_m, `receives within ${text(receives_m)}`, 1);
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

function text(radius_m) {
  return radius_m === null ? '' : `${Number(radius_m.toFixed(1))} m`;
}

// Above the circle's highest point (side -1), below its lowest (side 1).
function nameCircle(ctx, camera, theme, sx, sy, radius_m, words, side) {
  if (radius_m === null) return;
  const at = sy + side * (radius_m / camera.metresPerPixel + 9);
  if (!camera.sees(sx, at, 0)) return;
  ctx.globalAlpha = 1;
  ctx.font = `12px ${kFont}`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  ctx.lineWidth = 3;
  ctx.setLineDash([]);
  const color = ctx.strokeStyle;
  ctx.strokeStyle = theme.plate;
  ctx.strokeText(words, sx, at);
  ctx.fillStyle = theme.text;
  ctx.fillText(words, sx, at);
  ctx.strokeStyle = color;
}
