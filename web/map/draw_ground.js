// What lies under everything else: the sea floor with its contours, the grid, the op area.

import {context2d} from '../page/dom.js';
import {drawBackgrounds} from './background.js';
import {floorContours, depthRange, isFloor} from './contours.js';
import {gridStep, isNumber, metresText} from './geometry.js';
import {kFont} from './draw_theme.js';

const kShades = 48;
// Of a contour on the screen, to carry its depth, and between two of them.
const kLeastForLabel = 180;
const kBetweenLabels = 520;
// So near to the edge of the layer's picture they would be cut or lie under the grid's numbers.
const kNoLabels = 140;

/** The floor of a setup, made ready once: contours and a picture of the depths. */
export class FloorPicture {
  contours;
  #floor;
  #range;
  /** @type {HTMLCanvasElement | null} */
  #picture = null;
  #light = null;

  constructor(floor) {
    this.#floor = isFloor(floor) ? floor : null;
    this.#range = this.#floor && depthRange(this.#floor);
    this.contours = floorContours(floor);
  }

  draw(ctx, camera, theme) {
    if (!this.#range) return;
    if (!this.#picture || this.#light !== theme.light) this.#paint(theme);
    const {x0, y0, nx, ny, step_m: step} = this.#floor;
    const [left, right] = [camera.sx(x0 - step / 2), camera.sx(x0 + (nx - 0.5) * step)];
    const [top, bottom] = [camera.sy(y0 + (ny - 0.5) * step), camera.sy(y0 - step / 2)];
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(this.#picture, left, top, right - left, bottom - top);
  }

  // Shallow is light on the dark theme's ground, deep is dark on the light one's.
  #paint(theme) {
    const {nx, ny, depth_m: depth} = this.#floor;
    const {least, greatest} = this.#range;
    const [shallow, deep] = [theme.shallow, theme.deep].map(rgbOf);
    const image = new ImageData(nx, ny);
    for (let j = 0; j < ny; ++j) {
      for (let i = 0; i < nx; ++i) {
        const value = depth[j * nx + i];
        if (!isNumber(value)) continue;
        const part = greatest > least ? (value - least) / (greatest - least) : 0.5;
        const shade = Math.round(part * kShades) / kShades;
        const at = 4 * ((ny - 1 - j) * nx + i);
        for (let c = 0; c < 3; ++c) {
          image.data[at + c] = shallow[c] + (deep[c] - shallow[c]) * shade;
        }
        image.data[at + 3] = 255;
      }
    }
    const picture = document.createElement('canvas');
    picture.width = nx;
    picture.height = ny;
    this.#picture = picture;
    context2d(picture).putImageData(image, 0, 0);
    this.#light = theme.light;
  }
}

function rgbOf(color) {
  const probe = context2d(document.createElement('canvas'));
  probe.fillStyle = color;
  probe.fillRect(0, 0, 1, 1);
  return probe.getImageData(0, 0, 1, 1).data;
}

export function drawGround(ctx, camera, theme,
                           {floor, area, surveys, obstacles, backgrounds, layers}) {
  ctx.fillStyle = theme.water;
  ctx.fillRect(0, 0, camera.width, camera.height);
  if (layers.contours && floor) {
    floor.draw(ctx, camera, theme);
    drawContours(ctx, camera, theme, floor.contours);
  }
  if (layers.background) drawBackgrounds(ctx, camera, theme, backgrounds);
  if (layers.grid) drawGrid(ctx, camera, theme);
  if (!layers.area) return;
  drawArea(ctx, camera, theme, area);
  drawSurveys(ctx, camera, theme, surveys);
  drawObstacles(ctx, camera, theme, obstacles);
}

function drawGrid(ctx, camera, theme) {
  const step = gridStep(camera.metresPerPixel, 90);
  const fine = step / 5;
  const lines = (spacing, keep) => {
    ctx.beginPath();
    for (let k = Math.ceil(camera.left / spacing); k * spacing <= camera.right; ++k) {
      const at = Math.round(camera.sx(k * spacing)) + 0.5;
      if (!keep(k)) continue;
      ctx.moveTo(at, 0);
      ctx.lineTo(at, camera.height);
    }
    for (let k = Math.ceil(camera.bottom / spacing); k * spacing <= camera.top; ++k) {
      const at = Math.round(camera.sy(k * spacing)) + 0.5;
      if (!keep(k)) continue;
      ctx.moveTo(0, at);
      ctx.lineTo(camera.width, at);
    }
    ctx.stroke();
  };
  ctx.lineWidth = 1;
  ctx.setLineDash([]);
  ctx.strokeStyle = theme.grid;
  lines(fine, (k) => k % 5 !== 0);
  ctx.strokeStyle = theme.gridMajor;
  lines(step, (k) => k !== 0);
  ctx.strokeStyle = theme.axis;
  lines(step, (k) => k === 0);
}

/** The grid's x along the upper edge, its y along the left one. */
export function drawGridNumbers(ctx, camera, theme) {
  const step = gridStep(camera.metresPerPixel, 90);
  ctx.font = `12px ${kFont}`;
  ctx.fillStyle = theme.muted;
  ctx.textBaseline = 'top';
  ctx.textAlign = 'center';
  for (let k = Math.ceil(camera.left / step); k * step <= camera.right; ++k) {
    const sx = camera.sx(k * step);
    if (sx > 60 && sx < camera.width - 70) ctx.fillText(metresText(k * step, step), sx, 5);
  }
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  for (let k = Math.ceil(camera.bottom / step); k * step <= camera.top; ++k) {
    const sy = camera.sy(k * step);
    if (sy > 30 && sy < camera.height - 70) ctx.fillText(metresText(k * step, step), 5, sy);
  }
}

function drawContours(ctx, camera, theme, contours) {
  const [left, right, bottom, top] = [camera.left, camera.right, camera.bottom, camera.top];
  const labels = [];
  ctx.strokeStyle = theme.contour;
  ctx.lineWidth = 1.2;
  ctx.setLineDash([]);
  ctx.beginPath();
  for (const {level, lines} of contours) {
    for (const line of lines) {
      let sinceLabel = kBetweenLabels - kLeastForLabel;
      let [px, py] = [camera.sx(line[0]), camera.sy(line[1])];
      let pen = false;
      for (let i = 2; i < line.length; i += 2) {
        const [x, y] = [line[i], line[i + 1]];
        const [sx, sy] = [camera.sx(x), camera.sy(y)];
        const step = Math.hypot(sx - px, sy - py);
        const seen = Math.max(x, line[i - 2]) >= left && Math.min(x, line[i - 2]) <= right &&
            Math.max(y, line[i - 1]) >= bottom && Math.min(y, line[i - 1]) <= top;
        if (seen && step > 0.7) {
          if (!pen) ctx.moveTo(px, py);
          ctx.lineTo(sx, sy);
          sinceLabel += step;
          if (sinceLabel > kBetweenLabels && sx > kNoLabels && sy > kNoLabels &&
              sx < camera.width - kNoLabels && sy < camera.height - kNoLabels) {
            labels.push({level, x: (px + sx) / 2, y: (py + sy) / 2,
              angle: Math.atan2(sy - py, sx - px)});
            sinceLabel = 0;
          }
        }
        pen = seen && step > 0.7;
        if (step > 0.7 || !seen) [px, py] = [sx, sy];
      }
    }
  }
  ctx.stroke();
  drawContourLabels(ctx, theme, labels.slice(0, 120));
}

function drawContourLabels(ctx, theme, labels) {
  const taken = [];
  ctx.font = `12px ${kFont}`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineWidth = 3;
  ctx.lineJoin = 'round';
  for (const {level, x, y, angle} of labels) {
    if (taken.some((other) => Math.hypot(other.x - x, other.y - y) < 70)) continue;
    taken.push({x, y});
    ctx.save();
    ctx.translate(x, y);
    ctx.rotate(Math.abs(angle) > Math.PI / 2 ? angle + Math.PI : angle);
    ctx.strokeStyle = theme.plate;
    ctx.strokeText(`${level} m`, 0, 0);
    ctx.fillStyle = theme.contourText;
    ctx.fillText(`${level} m`, 0, 0);
    ctx.restore();
  }
}

function drawArea(ctx, camera, theme, area) {
  if (!Array.isArray(area) || area.length < 2) return;
  ctx.beginPath();
  camera.addLine(ctx, area, area.length > 2);
  ctx.lineWidth = 2;
  ctx.strokeStyle = theme.area;
  ctx.setLineDash([10, 4, 2, 4]);
  ctx.stroke();
  ctx.setLineDash([]);
}

/** Filled, with their names beside them where there is room. */
function drawObstacles(ctx, camera, theme, obstacles) {
  ctx.setLineDash([]);
  ctx.font = `12px ${kFont}`;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  for (const {id, polygon} of obstacles) {
    if (polygon.length < 3) continue;
    ctx.beginPath();
    polygon.forEach(([x, y], i) => (
      i === 0 ? ctx.moveTo(camera.sx(x), camera.sy(y)) : ctx.lineTo(camera.sx(x), camera.sy(y))));
    ctx.closePath();
    ctx.globalAlpha = 0.45;
    ctx.fillStyle = theme.muted;
    ctx.fill();
    ctx.globalAlpha = 1;
    ctx.strokeStyle = theme.muted;
    ctx.lineWidth = 1.5;
    ctx.stroke();
    const right = Math.max(...polygon.map(([x]) => camera.sx(x)));
    const ys = polygon.map(([, y]) => camera.sy(y));
    ctx.fillStyle = theme.muted;
    ctx.fillText(id, right + 5, (Math.min(...ys) + Math.max(...ys)) / 2);
  }
}

function drawSurveys(ctx, camera, theme, surveys) {
  ctx.lineWidth = 1.2;
  ctx.strokeStyle = theme.area;
  ctx.globalAlpha = 0.7;
  ctx.setLineDash([5, 5]);
  ctx.beginPath();
  for (const polygon of surveys) camera.addLine(ctx, polygon, true);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}
