// The vehicles: hull by type, colour, heading; marks of those that are stale, stopped or selected;
// and apart from the truth where the broker believes them to be.

import {context2d} from '../page/dom.js';
import {vehicleColor} from '../page/colors.js';
import {isNumber} from './geometry.js';
import {kFont} from './draw_theme.js';

/** No vehicle is drawn shorter. */
export const kLeastLength = 18;
// A line ahead shows where a vehicle will be after so long.
const kAhead_s = 10;
// Nearer to the truth than this, the reported position is not shown beside it.
const kApart = 7;

// Hulls, one long, bow toward +x, centred; broader than the real ones, to be clear when small.
const kHulls = {
  kayak: 'M.5 0C.3 .17-.25 .2-.5 0C-.25-.2.3-.17.5 0Z',
  mokai: 'M.5 0C.35 .2 .1 .24-.2 .24L-.46 .18L-.46-.18L-.2-.24C.1-.24 .35-.2 .5 0Z',
  ship: 'M.5 0L.22 .2L-.5 .2L-.5-.2L.22-.2Z M-.08 .1L-.36 .1L-.36-.1L-.08-.1Z',
  auv: 'M.5 0C.5 .1.4 .15.26 .15L-.28 .13L-.34 .27L-.46 .27L-.46 .05L-.5 0L-.46-.05L-.46-.27' +
      'L-.34-.27L-.28-.13L.26-.15C.4-.15.5-.1.5 0Z',
  glider: 'M.5 0C.47 .08.4 .1.3 .1L.08 .1L-.2 .46L-.3 .46L-.14 .1L-.36 .09L-.44 .2L-.5 .2L-.47 0' +
      'L-.5-.2L-.44-.2L-.36-.09L-.14-.1L-.3-.46L-.2-.46L.08-.1L.3-.1C.4-.1.47-.08.5 0Z',
  dart: 'M.5 0L-.45 .34L-.25 0L-.45-.34Z',
};
const kHullOfType = {
  kayak: 'kayak', heron: 'mokai', mokai: 'mokai', ship: 'ship', usv: 'mokai', longship: 'ship',
  auv: 'auv', uuv: 'auv', glider: 'glider', slocum: 'glider',
};

/** Returns which hull a type is drawn with: kayak, mokai, ship, auv, glider or dart. */
export function hullOf(type) {
  const key = String(type ?? '').toLowerCase();
  return Object.hasOwn(kHullOfType, key) ? kHullOfType[key] : 'dart';
}

const hulls = new Map();

function hullPath(type) {
  const name = hullOf(type);
  let path = hulls.get(name);
  if (!path) hulls.set(name, path = new Path2D(kHulls[name]));
  return path;
}

/** Returns how long a vehicle is drawn, in pixels. */
export function drawnLength(vehicle, camera) {
  const length = vehicle.length_m / camera.metresPerPixel;
  return isNumber(length) ? Math.min(4000, Math.max(kLeastLength, length)) : kLeastLength;
}

let hatching = null;

function hatch(ctx) {
  if (hatching) return hatching;
  const tile = document.createElement('canvas');
  tile.width = tile.height = 6;
  const pen = context2d(tile);
  pen.fillStyle = '#8d99a3';
  pen.fillRect(0, 0, 6, 6);
  pen.strokeStyle = '#2a333a';
  pen.lineWidth = 1.6;
  for (const shift of [-6, 0, 6]) {
    pen.moveTo(shift - 1, 7);
    pen.lineTo(shift + 7, -1);
  }
  pen.stroke();
  return hatching = ctx.createPattern(tile, 'repeat');
}

/** True in an all-stop; a parked vehicle is at rest. */
export const isStopped = (vehicle) => vehicle.helm?.state === 'ALL-STOP';

/** Draws where vehicles believe to be: the ellipse that holds them with 95 %, and the way there. */
export function drawBelieved(ctx, camera, theme, vehicles) {
  for (const vehicle of vehicles) {
    const {navigation} = vehicle;
    if (!isNumber(navigation?.x) || !isNumber(navigation?.y)) continue;
    const [bx, by] = [camera.sx(navigation.x), camera.sy(navigation.y)];
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    ctx.lineWidth = 1.2;
    ctx.globalAlpha = 0.8;
    ctx.beginPath();
    camera.addSegment(ctx, vehicle.x, vehicle.y, navigation.x, navigation.y);
    ctx.stroke();
    if (isNumber(navigation.major) && isNumber(navigation.minor) && camera.sees(bx, by)) {
      ctx.beginPath();
      const scale = camera.metresPerPixel;
      ctx.ellipse(bx, by, navigation.major / scale, navigation.minor / scale,
        ((navigation.direction ?? 0) - 90) * Math.PI / 180, 0, 2 * Math.PI);
      ctx.stroke();
    }
  }
  ctx.globalAlpha = 1;
}

/** Draws the reported positions that stand apart from the truth, with their age. */
export function drawReported(ctx, camera, theme, vehicles, t) {
  for (const vehicle of vehicles) {
    const {report} = vehicle;
    if (!vehicle.truth || !isNumber(report?.x) || !isNumber(report?.y)) continue;
    const [rx, ry] = [camera.sx(report.x), camera.sy(report.y)];
    const apart = Math.hypot(camera.sx(vehicle.x) - rx, camera.sy(vehicle.y) - ry);
    if (!(apart > kApart)) continue;
    ctx.strokeStyle = vehicleColor(vehicle.name, vehicle.color, theme.light);
    ctx.lineWidth = 1.3;
    ctx.globalAlpha = 0.85;
    ctx.setLineDash([4, 3]);
    ctx.beginPath();
    camera.addSegment(ctx, vehicle.x, vehicle.y, report.x, report.y);
    ctx.stroke();
    ctx.setLineDash([]);
    if (!camera.sees(rx, ry)) continue;
    ctx.beginPath();
    ctx.arc(rx, ry, 4.5, 0, 2 * Math.PI);
    ctx.stroke();
    if (apart < 26 || !isNumber(report.t)) continue;
    ctx.globalAlpha = 1;
    ctx.font = `12px ${kFont}`;
    ctx.textAlign = 'right';
    ctx.textBaseline = 'middle';
    ctx.fillStyle = theme.muted;
    ctx.fillText(`${Math.max(0, t - report.t).toFixed(1)} s`, rx - 8, ry);
  }
  ctx.globalAlpha = 1;
}

export function drawVehicles(ctx, camera, theme, vehicles, {selected, hovered}, ratio) {
  drawCourses(ctx, camera, theme, vehicles);
  for (const vehicle of vehicles) {
    if (vehicle.x === null) continue;
    const [sx, sy] = [camera.sx(vehicle.x), camera.sy(vehicle.y)];
    const length = drawnLength(vehicle, camera);
    if (!camera.sees(sx, sy, length)) continue;
    const radius = Math.max(15, 0.62 * length);
    if (isStopped(vehicle)) drawOctagon(ctx, theme, sx, sy, radius);
    drawHull(ctx, theme, vehicle, sx, sy, length, ratio);
    if (vehicle.name === selected) drawBrackets(ctx, theme, sx, sy, radius + 5, 2.4);
    else if (vehicle.name === hovered) drawBrackets(ctx, theme, sx, sy, radius + 5, 1.2);
  }
}

function drawHull(ctx, theme, vehicle, sx, sy, length, ratio) {
  const path = hullPath(vehicle.type);
  // A heading that is not known is drawn as North, the hull without its inside.
  const angle = ((vehicle.heading ?? 0) - 90) * Math.PI / 180;
  const [c, s] = [Math.cos(angle) * length, Math.sin(angle) * length];
  ctx.setTransform(ratio * c, ratio * s, -ratio * s, ratio * c, ratio * sx, ratio * sy);
  ctx.lineJoin = 'round';
  ctx.strokeStyle = theme.light ? '#ffffff' : theme.outline;
  ctx.lineWidth = 4.4 / length;
  ctx.stroke(path);
  const color =
      vehicle.stale ? theme.stale : vehicleColor(vehicle.name, vehicle.color, theme.light);
  if (vehicle.heading !== null) {
    ctx.fillStyle = vehicle.stale ? hatch(ctx) : color;
    if (!vehicle.truth) ctx.globalAlpha = 0.55;
    ctx.fill(path, 'evenodd');
    ctx.globalAlpha = 1;
  }
  ctx.strokeStyle = vehicle.truth ? (theme.light ? theme.outline : '#ffffff') : color;
  ctx.lineWidth = 1.3 / length;
  ctx.stroke(path);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
}

// Course over ground where it is known, else heading.
function drawCourses(ctx, camera, theme, vehicles) {
  ctx.lineWidth = 1.4;
  ctx.setLineDash([]);
  ctx.globalAlpha = 0.85;
  for (const vehicle of vehicles) {
    const speed = vehicle.nav?.sog ?? vehicle.speed;
    const course = vehicle.nav?.course ?? vehicle.heading;
    if (vehicle.x === null || !isNumber(course) || !(Math.abs(speed) > 0.05)) continue;
    const ahead_m = Math.min(speed * kAhead_s, 1e4);
    const angle = course * Math.PI / 180;
    ctx.strokeStyle = vehicle.stale ? theme.stale :
        vehicleColor(vehicle.name, vehicle.color, theme.light);
    ctx.beginPath();
    camera.addSegment(ctx, vehicle.x, vehicle.y, vehicle.x + ahead_m * Math.sin(angle),
                      vehicle.y + ahead_m * Math.cos(angle));
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

function drawOctagon(ctx, theme, sx, sy, radius) {
  ctx.beginPath();
  for (let i = 0; i < 8; ++i) {
    const angle = Math.PI / 8 + i * Math.PI / 4;
    ctx.lineTo(sx + radius * Math.cos(angle), sy + radius * Math.sin(angle));
  }
  ctx.closePath();
  ctx.globalAlpha = 0.28;
  ctx.fillStyle = theme.danger;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.strokeStyle = theme.danger;
  ctx.lineWidth = 2.5;
  ctx.stroke();
}

// Four corners around the vehicle.
function drawBrackets(ctx, theme, sx, sy, radius, width) {
  const arm = radius * 0.45;
  ctx.strokeStyle = theme.accent;
  ctx.lineWidth = width;
  ctx.beginPath();
  for (const [i, j] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
    ctx.moveTo(sx + i * radius, sy + j * (radius - arm));
    ctx.lineTo(sx + i * radius, sy + j * radius);
    ctx.lineTo(sx + i * (radius - arm), sy + j * radius);
  }
  ctx.stroke();
}
