// Comms pulses and acoustic rings.

import {causeColor} from '../page/causes.js';
import {kindColor} from '../page/colors.js';
import {circleTouchesBox, pulseTriangle} from './geometry.js';

/** How pulses are drawn, the first unless a user chooses another. */
export const kPulseStyles = [
  ['auto', 'as beams, many as lines, thinned'],
  ['beams', 'all as beams'],
  ['lines', 'all as lines'],
  ['chosen', 'those of the chosen vehicle or link alone'],
];

// More beams than this lie over one another and over all else.
const kMaxBeams = 12;
// More lines than this in the picture are thinned.
const kMaxLines = 90;
// A line is this much fainter than its beam; the more of them, the fainter.
const kLine = 1.4;
const kLeastLine = 0.5;

function hashOf(text) {
  let hash = 2166136261;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 16777619) >>> 0;
  return hash;
}

/**
 * Chooses what is drawn of `pulses`: {beams, lines, chosen}; chosen are those of the chosen vehicle
 * or link, as lines that stand out, where they are too many for beams. Of too many lines the same
 * links remain from picture to picture.
 * @param isSeen  (pulse) -> some of it lies in the picture
 */
export function choosePulses(pulses, style, isChosen, isSeen = () => true) {
  const own = pulses.filter(isChosen);
  const ownAsBeams = own.length <= kMaxBeams;
  const isFew = pulses.length <= kMaxBeams;
  if (style === 'beams' || (style === 'auto' && isFew)) {
    return {beams: pulses, lines: [], chosen: []};
  }
  const [beams, chosen] = ownAsBeams ? [own, []] : [[], own];
  if (style === 'chosen') return {beams, lines: [], chosen};
  let lines = pulses.filter((pulse) => !isChosen(pulse));
  if (style !== 'lines' && lines.length > kMaxLines) {
    lines = lines.filter(isSeen);
    if (lines.length > kMaxLines) {
      lines = lines.map((pulse) => ({pulse, rank: hashOf(String(pulse.label || pulse.id))}))
        .sort((a, b) => a.rank - b.rank).slice(0, kMaxLines).map(({pulse}) => pulse);
    }
  }
  return {beams, lines, chosen};
}

/** Draws pulses in a style; all of those for which `isChosen` is true. */
export function drawPulses(ctx, camera, theme, pulses, {style, isChosen}) {
  const {beams, lines, chosen} = choosePulses(pulses, style, isChosen,
      (pulse) => isInPicture(camera, pulse));
  const crowding = Math.max(kLeastLine, Math.min(1, Math.sqrt(30 / Math.max(1, lines.length))));
  drawLines(ctx, camera, theme, lines, kLine * crowding, 1);
  drawBeams(ctx, camera, theme, beams);
  drawLines(ctx, camera, theme, chosen, 3, 2);
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

function isInPicture(camera, {from, to}) {
  const [x0, x1] = [camera.sx(from[0]), camera.sx(to[0])];
  const [y0, y1] = [camera.sy(from[1]), camera.sy(to[1])];
  return Math.max(x0, x1) >= 0 && Math.min(x0, x1) <= camera.width && Math.max(y0, y1) >= 0
      && Math.min(y0, y1) <= camera.height;
}

// Thin lines, the fainter the older; messages are broken.
function drawLines(ctx, camera, theme, pulses, strength, width) {
  ctx.lineWidth = width;
  for (const pulse of pulses) {
    ctx.strokeStyle = kindColor(pulse.kind, theme.light);
    ctx.globalAlpha = Math.min(1, strength * pulse.opacity);
    ctx.setLineDash(pulse.kind === 'report' ? [] : [7, 4]);
    ctx.beginPath();
    camera.addSegment(ctx, pulse.from[0], pulse.from[1], pulse.to[0], pulse.to[1]);
    ctx.stroke();
  }
}

function drawBeams(ctx, camera, theme, pulses) {
  // Of many, each is paler: else they would hide each other.
  const crowding = Math.min(1, Math.sqrt(kMaxBeams / Math.max(1, pulses.length)));
  ctx.lineJoin = 'bevel';
  ctx.lineWidth = 1.6;
  for (const pulse of pulses) {
    ctx.beginPath();
    if (!addTriangle(ctx, camera, pulse)) continue;
    const opacity = pulse.opacity * crowding;
    ctx.fillStyle = kindColor(pulse.kind, theme.light);
    ctx.globalAlpha = opacity;
    // Each is filled alone: a convex shape is filled far faster than a path of many.
    ctx.fill();
    // A message's edge is broken; a report has none.
    if (pulse.kind === 'report') continue;
    ctx.strokeStyle = ctx.fillStyle;
    ctx.globalAlpha = Math.min(1, 2 * opacity);
    ctx.setLineDash([7, 4]);
    ctx.stroke();
  }
  ctx.setLineDash([]);
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
