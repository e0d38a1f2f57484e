// What users' programs draw on the map: points, polygons, lines, circles, texts.

import {parseColor, readable} from '../page/colors.js';
import {addCircle} from './draw_signals.js';
import {kFont} from './draw_theme.js';
import {clamp, finite, isNumber} from './geometry.js';

const kMaxDrawings = 500;
const kMaxText = 60;
const kPoint_px = 7;
const kLine_px = 1.6;
const kYellow = 0xffff00;
const kFar_px = 30000;

/** Drawings of a frame in a shape that can be drawn, whatever came. */
export function tidyDrawings(list) {
  if (!Array.isArray(list)) return [];
  return list.slice(0, kMaxDrawings).filter((each) => Array.isArray(each?.points)).map((each) => ({
    kind: String(each.kind),
    label: String(each.kind === 'text' ? each.text ?? '' : each.label ?? '').slice(0, kMaxText),
    color: each.color,
    size: clamp(finite(each.size), 0, 100),
    fill: clamp(finite(each.fill), 0, 1),
    radius: Math.max(0, finite(each.radius)),
    points: each.points.filter((point) => isNumber(point?.[0]) && isNumber(point?.[1])),
  })).filter(({points}) => points.length > 0);
}

/** Where a drawing's label stands: at a point, or the middle of what the others take in. */
export function labelPlace({kind, points}) {
  if (kind === 'seglist') return points[0];
  const [x, y] = [0, 1].map((axis) => points.map((point) => point[axis]));
  const middle = (values) => (
    values.reduce((least, value) => Math.min(least, value), Infinity)
    + values.reduce((most, value) => Math.max(most, value), -Infinity)) / 2;
  return [middle(x), middle(y)];
}

function addShape(ctx, camera, {kind, points, radius}) {
  ctx.beginPath();
  if (kind === 'circle') {
    const [x, y] = points[0];
    addCircle(ctx, camera, camera.sx(x), camera.sy(y), radius / camera.metresPerPixel);
  } else {
    camera.addLine(ctx, points, kind === 'polygon');
  }
}

// Canvas draws no coordinates that are far beyond it; addLine would cut the outline into pieces.
function fillShape(ctx, camera, drawing) {
  if (drawing.kind === 'circle') {
    ctx.fill();
    return;
  }
  ctx.beginPath();
  for (const [x, y] of drawing.points) {
    ctx.lineTo(clamp(camera.sx(x), -kFar_px, kFar_px), clamp(camera.sy(y), -kFar_px, kFar_px));
  }
  ctx.fill();
  addShape(ctx, camera, drawing);
}

function drawPoint(ctx, camera, {points: [[x, y]], size}) {
  const half = (size || kPoint_px) / 2;
  ctx.beginPath();
  ctx.arc(camera.sx(x), camera.sy(y), half, 0, 2 * Math.PI);
  ctx.fill();
}

function drawLabel(ctx, camera, theme, drawing) {
  if (drawing.label === '') return;
  const [x, y] = labelPlace(drawing);
  const [sx, sy] = [camera.sx(x), camera.sy(y)];
  if (sx < -200 || sy < -20 || sx > camera.width + 200 || sy > camera.height + 20) return;
  const isPoint = drawing.kind === 'point';
  ctx.textAlign = isPoint ? 'left' : 'center';
  const left = isPoint ? sx + (drawing.size || kPoint_px) / 2 + 3 : sx;
  ctx.lineWidth = 3;
  ctx.strokeStyle = theme.water;
  ctx.strokeText(drawing.label, left, sy);
  ctx.fillText(drawing.label, left, sy);
}

/** @param drawings  of tidyDrawings */
export function drawDrawings(ctx, camera, theme, drawings) {
  ctx.save();
  ctx.font = `12px ${kFont}`;
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  for (const drawing of drawings) {
    const color = readable(parseColor(drawing.color) ?? kYellow, theme.light);
    ctx.fillStyle = color;
    ctx.strokeStyle = color;
    if (drawing.kind === 'point') {
      drawPoint(ctx, camera, drawing);
    } else if (drawing.kind !== 'text') {
      addShape(ctx, camera, drawing);
      if (drawing.fill > 0 && drawing.kind !== 'seglist') {
        ctx.globalAlpha = drawing.fill;
        fillShape(ctx, camera, drawing);
        ctx.globalAlpha = 1;
      }
      ctx.lineWidth = drawing.size || kLine_px;
      ctx.stroke();
    }
    drawLabel(ctx, camera, theme, drawing);
  }
  ctx.restore();
}
