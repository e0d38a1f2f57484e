// Which part of the plane a picture shows. Screen coordinates are CSS pixels from the upper left.

import {clamp, clipSegment, isNumber} from './geometry.js';

const kLeastScale = 0.005;
const kMaxScale = 5000;
// The height of the lower edge that belongs to the scale bar and the pointer's place.
const kScaleBar = 44;
// No mission goes farther from its origin (docs/missions/mission_file.md).
const kReach_m = 2e6;

export class Camera {
  cx = 0;
  cy = 0;
  metresPerPixel = 1;

  constructor(width, height, cx = 0, cy = 0, metresPerPixel = 1) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.set(cx, cy, metresPerPixel);
  }

  /**
   * What is not finite stays as it is; the rest is kept in bounds.
   * @param {number | undefined} cx @param {number | undefined} cy @param {number} [metresPerPixel]
   */
  set(cx, cy, metresPerPixel) {
    if (isNumber(cx)) this.cx = clamp(cx, -kReach_m, kReach_m);
    if (isNumber(cy)) this.cy = clamp(cy, -kReach_m, kReach_m);
    if (metresPerPixel !== undefined && isNumber(metresPerPixel) && metresPerPixel > 0) {
      this.metresPerPixel = clamp(metresPerPixel, kLeastScale, kMaxScale);
    }
  }

  /** Returns the same view with `margin` pixels more on each side. */
  widened(margin) {
    return new Camera(this.width + 2 * margin, this.height + 2 * margin, this.cx, this.cy,
                      this.metresPerPixel);
  }

  sx(x) { return (x - this.cx) / this.metresPerPixel + this.width / 2; }
  sy(y) { return this.height / 2 - (y - this.cy) / this.metresPerPixel; }
  x(sx) { return (sx - this.width / 2) * this.metresPerPixel + this.cx; }
  y(sy) { return (this.height / 2 - sy) * this.metresPerPixel + this.cy; }

  get left() { return this.x(0); }
  get right() { return this.x(this.width); }
  get bottom() { return this.y(this.height); }
  get top() { return this.y(0); }

  /** True where a screen point lies in the picture or at most `margin` pixels beside it. */
  sees(sx, sy, margin = 40) {
    return sx >= -margin && sy >= -margin && sx <= this.width + margin &&
        sy <= this.height + margin;
  }

  /** Scales by `factor` > 1 (nearer), so that the place under (sx, sy) stays there. */
  zoom(factor, sx = this.width / 2, sy = this.height / 2) {
    if (!isNumber(factor) || factor <= 0) return;
    const [x, y] = [this.x(sx), this.y(sy)];
    this.set(undefined, undefined, this.metresPerPixel / factor);
    this.set(this.cx + x - this.x(sx), this.cy + y - this.y(sy));
  }

  /** Shows the box with a margin of a twelfth on each side, clear of the scale bar. */
  fit(left, bottom, right, top) {
    const room = 1 - 2 / 12;
    const height = Math.max(1, this.height - kScaleBar);
    const scale = Math.max((right - left) / (this.width * room), (top - bottom) / (height * room),
                           0.1);
    this.set((left + right) / 2, (bottom + top) / 2 - kScaleBar / 2 * scale, scale);
  }

  /** Adds the part of a segment (metres) that can be seen to the path. */
  addSegment(path, x0, y0, x1, y1) {
    const cut = clipSegment(this.sx(x0), this.sy(y0), this.sx(x1), this.sy(y1), -60, -60,
                            this.width + 60, this.height + 60);
    if (!cut) return;
    path.moveTo(cut[0], cut[1]);
    path.lineTo(cut[2], cut[3]);
  }

  /** Adds a line through [[x, y], ...] to the path. */
  addLine(path, points, closed = false) {
    for (let i = 1; i < points.length + (closed ? 1 : 0); ++i) {
      const [a, b] = [points[i - 1], points[i % points.length]];
      this.addSegment(path, a?.[0], a?.[1], b?.[0], b?.[1]);
    }
  }
}
