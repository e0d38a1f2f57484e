// What lies over the map: scale bar, North arrow, the measured distance, a mark, and in a picture
// the title.

import {bearingDegrees, isNumber, metresText, scaleBarMetres} from './geometry.js';
import {kFont} from './draw_theme.js';

export function drawScaleBar(ctx, camera, theme) {
  const length_m = scaleBarMetres(camera.metresPerPixel);
  const length = length_m / camera.metresPerPixel;
  const [left, base] = [16, camera.height - 18];
  ctx.fillStyle = theme.plate;
  ctx.fillRect(left - 8, base - 24, length + 16, 34);
  ctx.fillStyle = theme.text;
  ctx.fillRect(left, base, length, 4);
  ctx.fillStyle = theme.water;
  ctx.fillRect(left + length / 2, base + 1, length / 2 - 1, 2);
  ctx.fillStyle = theme.text;
  ctx.font = `12px ${kFont}`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'alphabetic';
  ctx.fillText(metresText(length_m, Math.min(1, length_m)), left + length / 2, base - 7);
}

export function drawNorth(ctx, camera, theme) {
  const [x, y] = [camera.width - 24, 30];
  ctx.beginPath();
  ctx.moveTo(x, y - 18);
  ctx.lineTo(x + 6, y + 2);
  ctx.lineTo(x, y - 3);
  ctx.lineTo(x - 6, y + 2);
  ctx.closePath();
  ctx.fillStyle = theme.text;
  ctx.fill();
  ctx.font = `bold 11px ${kFont}`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'top';
  ctx.fillText('N', x, y + 4);
}

/** `ends` is [{x, y}, {x, y}] in metres. */
export function drawMeasure(ctx, camera, theme, ends) {
  const [a, b] = ends;
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const distance_m = Math.hypot(dx, dy);
  if (!isNumber(distance_m)) return;
  ctx.strokeStyle = theme.accent;
  ctx.lineWidth = 1.8;
  ctx.setLineDash([8, 4]);
  ctx.beginPath();
  camera.addSegment(ctx, a.x, a.y, b.x, b.y);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.beginPath();
  for (const end of ends) {
    const [sx, sy] = [camera.sx(end.x), camera.sy(end.y)];
    ctx.moveTo(sx + 4, sy);
    ctx.arc(sx, sy, 4, 0, 2 * Math.PI);
  }
  ctx.stroke();
  const bearing = `${bearingDegrees(dx, dy).toFixed(1).padStart(5, '0')}\u00b0`;
  const digits = camera.metresPerPixel < 0.5 ? 2 : 1;
  drawNote(ctx, theme, `${distance_m.toFixed(digits)} m  ${bearing}`, camera.sx((a.x + b.x) / 2),
           camera.sy((a.y + b.y) / 2));
}

/** A place that the user has chosen: {x, y, label}. */
export function drawMark(ctx, camera, theme, mark) {
  const [sx, sy] = [camera.sx(mark.x), camera.sy(mark.y)];
  if (!camera.sees(sx, sy)) return;
  ctx.strokeStyle = theme.accent;
  ctx.lineWidth = 2;
  ctx.beginPath();
  for (const [i, j] of [[0, -1], [1, 0], [0, 1], [-1, 0]]) {
    ctx.moveTo(sx + 5 * i, sy + 5 * j);
    ctx.lineTo(sx + 15 * i, sy + 15 * j);
  }
  ctx.moveTo(sx + 10, sy);
  ctx.arc(sx, sy, 10, 0, 2 * Math.PI);
  ctx.stroke();
  if (mark.label) drawNote(ctx, theme, String(mark.label).slice(0, 60), sx, sy - 26);
}

function drawNote(ctx, theme, text, x, y) {
  ctx.font = `bold 13px ${kFont}`;
  const width = ctx.measureText(text).width + 14;
  ctx.fillStyle = theme.plate;
  ctx.fillRect(x - width / 2, y - 12, width, 24);
  ctx.strokeStyle = theme.accent;
  ctx.lineWidth = 1;
  ctx.strokeRect(x - width / 2, y - 12, width, 24);
  ctx.fillStyle = theme.text;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.fillText(text, x, y);
}

/** Draws the name of the mission and the time into the upper left corner of a picture. */
export function drawTitle(ctx, camera, theme, mission, t) {
  const title = String(mission || 'mission').slice(0, 60);
  const time = isNumber(t) ? `t = ${t.toFixed(1)} s` : '';
  ctx.font = `bold 16px ${kFont}`;
  const width = Math.max(ctx.measureText(title).width, 90) + 24;
  ctx.fillStyle = theme.plate;
  ctx.fillRect(10, 22, width, 44);
  ctx.fillStyle = theme.text;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.fillText(title, 22, 36);
  ctx.font = `13px ${kFont}`;
  ctx.fillText(time, 22, 55);
}
