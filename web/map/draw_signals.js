// Comms pulses and acoustic rings.

import {causeColor} from '../page/causes.js';
import {kindColor} from '../page/colors.js';
import {circleTouchesBox, pulseTriangle} from './geometry.js';

// More pulses than this are drawn paler, the more the paler: else they would hide each other.
const kCrowd = 60;
// Edges cost more time than what they enclose: at most this many messages have one, the newest.
const kMaxEdges = 30;

export function drawPulses(ctx, camera, theme, pulses) {
  const crowding = Math.min(1, Math.sqrt(kCrowd / Math.max(1, pulses.length)));
  let withoutEdge = pulses.reduce((sum, pulse) => sum + (pulse.kind !== 'report'), -kMaxEdges);
  ctx.lineJoin = 'bevel';
  ctx.lineWidth = 1.6;
  for (const pulse of pulses) {
    const edge = pulse.kind !== 'report' && withoutEdge-- <= 0;
    ctx.beginPath();
    if (!addTriangle(ctx, camera, pulse)) continue;
    const opacity = pulse.opacity * crowding;
    ctx.fillStyle = kindColor(pulse.kind, theme.light);
    ctx.globalAlpha = opacity;
    // Each is filled alone: a convex shape is filled far faster than a path of many.
    ctx.fill();
    // A message's edge is broken; a report has none.
    if (!edge) continue;
    ctx.strokeStyle = ctx.fillStyle;
    ctx.globalAlpha = Math.min(1, 2 * opacity);
    ctx.setLineDash([7, 4]);
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

// Returns false where nothing of the pulse can be seen.
function addTriangle(ctx, camera, pulse) {
  const corners = pulseTriangle(pulse);
  if (!corners) return false;
  const [x0, y0] = [camera.sx(corners[0]), camera.sy(corners[1])];
  const [x1, y1] = [camera.sx(corners[2]), camera.sy(corners[3])];
  const [x2, y2] = [camera.sx(corners[4]), camera.sy(corners[5])];
  const {width, height} = camera;
  if (Math.max(x0, x1, x2) < 0 || Math.min(x0, x1, x2) > width || Math.max(y0, y1, y2) < 0 ||
      Math.min(y0, y1, y2) > height) {
    return false;
  }
  // Far beyond the picture a fill would cost as much as it is long.
  if (Math.max(Math.abs(x0), Math.abs(y0), Math.abs(x1), Math.abs(y1)) > 1e5) return false;
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  ctx.lineTo(x2, y2);
  ctx.closePath();
  return true;
}

/** Adds a circle (pixels) to the path where some of it can be seen. */
export function addCircle(ctx, camera, sx, sy, radius) {
  if (!(radius > 0.5) || radius > 2e5) return;
  if (!circleTouchesBox(sx, sy, radius, 0, 0, camera.width, camera.height)) return;
  ctx.moveTo(sx + radius, sy);
  ctx.arc(sx, sy, radius, 0, 2 * Math.PI);
}

/** `places` gives the vehicles by name, for the flashes. */
export function drawRings(ctx, camera, theme, rings, places) {
  for (const ring of rings) {
    const [sx, sy] = [camera.sx(ring.x), camera.sy(ring.y)];
    if (ring.opacity > 0) {
      ctx.strokeStyle = kindColor(ring.kind, theme.light);
      ctx.globalAlpha = ring.opacity;
      ctx.lineWidth = 2.5;
      ctx.beginPath();
      addCircle(ctx, camera, sx, sy, ring.outer_m / camera.metresPerPixel);
      ctx.stroke();
      ctx.lineWidth = 1;
      ctx.globalAlpha = 0.6 * ring.opacity;
      ctx.beginPath();
      addCircle(ctx, camera, sx, sy, ring.inner_m / camera.metresPerPixel);
      ctx.stroke();
    }
    for (const flash of ring.flashes) drawFlash(ctx, camera, theme, flash, places.get(flash.name));
  }
  ctx.globalAlpha = 1;
}

// What was delivered flashes as a whole ring, what was lost as a broken one with a cross.
function drawFlash(ctx, camera, theme, flash, vehicle) {
  if (!vehicle || vehicle.x === null) return;
  const [sx, sy] = [camera.sx(vehicle.x), camera.sy(vehicle.y)];
  if (!camera.sees(sx, sy)) return;
  const delivered = flash.cause === 'delivered';
  const radius = 13 + 9 * (1 - flash.opacity);
  ctx.strokeStyle = causeColor(flash.cause, theme.light);
  ctx.globalAlpha = flash.opacity;
  ctx.lineWidth = 3;
  ctx.setLineDash(delivered ? [] : [5, 4]);
  ctx.beginPath();
  ctx.arc(sx, sy, radius, 0, 2 * Math.PI);
  ctx.stroke();
  ctx.setLineDash([]);
  if (delivered) return;
  const arm = 5;
  ctx.beginPath();
  ctx.moveTo(sx + radius - arm, sy - radius - arm);
  ctx.lineTo(sx + radius + arm, sy - radius + arm);
  ctx.moveTo(sx + radius - arm, sy - radius + arm);
  ctx.lineTo(sx + radius + arm, sy - radius - arm);
  ctx.stroke();
}
