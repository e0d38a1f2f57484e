// Plane geometry, headings and the mission's latitude and longitude. Nothing here draws.

const kDegrees = 180 / Math.PI;
const kRadians = Math.PI / 180;

export const isNumber = Number.isFinite;

/** Returns `value` where it is a finite number, `otherwise` where it is not. */
/** @param {any} value @param {any} [otherwise] */
export function finite(value, otherwise = 0) {
  return isNumber(value) ? value : otherwise;
}

export function clamp(value, low, high) {
  return Math.min(high, Math.max(low, value));
}

export function mix(a, b, fraction) {
  return a + (b - a) * fraction;
}

/** Returns the same direction in [0, 360). */
export function wrapDegrees(angle) {
  const wrapped = angle - 360 * Math.floor(angle / 360);
  return wrapped >= 360 ? 0 : wrapped;
}

/** Turns from `a` toward `b` the short way; in [0, 360). */
export function mixDegrees(a, b, fraction) {
  const turn = wrapDegrees(b - a + 180) - 180;
  return wrapDegrees(a + turn * fraction);
}

/** Returns degrees clockwise from North, in [0, 360). */
export function bearingDegrees(dx, dy) {
  return wrapDegrees(Math.atan2(dx, dy) * kDegrees);
}

/** Returns the least of 1, 2, 5, 10, 20, 50, ... that is not less than `least` > 0. */
export function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  for (const factor of [1, 2, 5]) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/** Returns metres between grid lines that stand at least `leastPixels` apart. */
export function gridStep(metresPerPixel, leastPixels = 80) {
  return roundStep(metresPerPixel * leastPixels);
}

/** Returns the greatest round length that fits into `mostPixels`. */
export function scaleBarMetres(metresPerPixel, mostPixels = 180) {
  const most = metresPerPixel * mostPixels;
  const power = 10 ** Math.floor(Math.log10(most * (1 + 1e-9)));
  const factor = [5, 2, 1].find((f) => f * power <= most * (1 + 1e-9)) ?? 1;
  return factor * power;
}

/** "250 m", "2.5 km"; `step` is the difference that has to be seen. */
export function metresText(metres, step = 1) {
  if (Math.abs(metres) >= 10000 || step >= 1000) {
    return `${Number((metres / 1000).toFixed(step >= 1000 ? 0 : step >= 100 ? 1 : 2))} km`;
  }
  const digits = step >= 1 ? 0 : Math.min(3, Math.ceil(-Math.log10(step) - 1e-9));
  return `${metres.toFixed(digits)} m`;
}

/**
 * Cuts a segment to the box (Liang and Barsky 1984). Returns [x0, y0, x1, y1], or null where none
 * of it lies inside or a coordinate is not finite.
 */
export function clipSegment(x0, y0, x1, y1, left, top, right, bottom) {
  const dx = x1 - x0;
  const dy = y1 - y0;
  if (!isNumber(dx) || !isNumber(dy)) return null;
  let enter = 0;
  let leave = 1;
  const sides = [[-dx, x0 - left], [dx, right - x0], [-dy, y0 - top], [dy, bottom - y0]];
  for (const [slope, room] of sides) {
    if (slope === 0) {
      if (room < 0) return null;
    } else if (slope < 0) {
      enter = Math.max(enter, room / slope);
    } else {
      leave = Math.min(leave, room / slope);
    }
  }
  if (enter > leave) return null;
  return [x0 + enter * dx, y0 + enter * dy, x0 + leave * dx, y0 + leave * dy];
}

/** True where some of the circle's line (not its inside) lies in the box. */
export function circleTouchesBox(x, y, radius, left, top, right, bottom) {
  const near = Math.hypot(x - clamp(x, left, right), y - clamp(y, top, bottom));
  const far = Math.hypot(Math.max(x - left, right - x), Math.max(y - top, bottom - y));
  return near <= radius && radius <= far;
}

/**
 * A comms pulse is a triangle: a point at `from`, `width` wide at `to`. Returns its corners
 * [x0, y0, x1, y1, x2, y2] in the units of the input, or null where it has no direction.
 */
export function pulseTriangle(pulse) {
  const [x0, y0] = pulse.from ?? [];
  const [x1, y1] = pulse.to ?? [];
  const length = Math.hypot(x1 - x0, y1 - y0);
  const half = finite(pulse.width, 5) / 2;
  if (!(length > 0) || !isNumber(length)) return null;
  const across = half / length;
  const nx = -(y1 - y0) * across;
  const ny = (x1 - x0) * across;
  return [x0, y0, x1 + nx, y1 + ny, x1 - nx, y1 - ny];
}

// WGS84.
const kEquator_m = 6378137;
const kFlattening = 1 / 298.257223563;
const kE2 = kFlattening * (2 - kFlattening);
// As lib/base/geodesy: beyond this distance from the origin a plane is no map.
const kReach_m = 1.5e6;

function toEarth(latDeg, lonDeg) {
  const sinLat = Math.sin(latDeg * kRadians);
  const cosLat = Math.cos(latDeg * kRadians);
  const normal_m = kEquator_m / Math.sqrt(1 - kE2 * sinLat * sinLat);
  return [normal_m * cosLat * Math.cos(lonDeg * kRadians),
    normal_m * cosLat * Math.sin(lonDeg * kRadians), normal_m * (1 - kE2) * sinLat];
}

/**
 * Between metres from the mission's origin (x East, y North) and degrees, on the plane that touches
 * the WGS84 ellipsoid there: the same as lib/base/geodesy/local_frame.h, to well under a millimetre.
 */
export class LocalFrame {
  #origin;
  #east;
  #north;
  #up;

  constructor(origin) {
    const lat = clamp(finite(origin?.lat_deg), -90, 90);
    const lon = finite(origin?.lon_deg);
    const [sinLat, cosLat] = [Math.sin(lat * kRadians), Math.cos(lat * kRadians)];
    const [sinLon, cosLon] = [Math.sin(lon * kRadians), Math.cos(lon * kRadians)];
    this.#origin = toEarth(lat, lon);
    this.#east = [-sinLon, cosLon, 0];
    this.#north = [-sinLat * cosLon, -sinLat * sinLon, cosLat];
    this.#up = [cosLat * cosLon, cosLat * sinLon, sinLat];
  }

  /** Returns {lat, lon} in degrees, the point below (x, y); null for both where out of reach. */
  toGeo(x, y) {
    if (!(Math.hypot(x, y) <= kReach_m)) return {lat: null, lon: null};
    const [ex, ey, ez] = this.#origin.map(
        (o, i) => o + x * this.#east[i] + y * this.#north[i]);
    const p = Math.hypot(ex, ey);
    let lat = Math.atan2(ez, p * (1 - kE2));
    for (let round = 0; round < 8; ++round) {
      const sinLat = Math.sin(lat);
      const normal_m = kEquator_m / Math.sqrt(1 - kE2 * sinLat * sinLat);
      lat = Math.atan2(ez + kE2 * normal_m * sinLat, p);
    }
    return {lat: lat * kDegrees, lon: Math.atan2(ey, ex) * kDegrees};
  }

  /** Returns {x, y}, or null where the point is none of the Earth's or out of reach. */
  toLocal(lat, lon) {
    if (!(Math.abs(lat) <= 90) || !(Math.abs(lon) <= 360)) return null;
    const earth = toEarth(lat, lon).map((e, i) => e - this.#origin[i]);
    const cosLat = Math.cos(lat * kRadians);
    const normal = [cosLat * Math.cos(lon * kRadians), cosLat * Math.sin(lon * kRadians),
      Math.sin(lat * kRadians)];
    const along = (axis, v) => axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    const upright = along(this.#up, normal);
    if (!(upright >= 0.9)) return null;
    const lift = along(this.#up, earth) / upright;
    const x = along(this.#east, earth) - along(this.#east, normal) * lift;
    const y = along(this.#north, earth) - along(this.#north, normal) * lift;
    return Math.hypot(x, y) <= kReach_m ? {x, y} : null;
  }
}
