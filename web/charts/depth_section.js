// The depth of a vehicle along its track, with the sea floor below.

const isNumber = Number.isFinite;
/** A vehicle that moves less than this is where it was. */
const kLeast_m = 0.5;

/**
 * The depth of the floor at a place, between the points of its grid.
 * @param floor  of /api/setup: {x0, y0, step_m, nx, ny, depth_m}, or null
 * @returns {number | null}  null outside of the grid, and where a point is not known
 */
export function floorDepthAt(floor, x, y) {
  if (!floor || !Array.isArray(floor.depth_m) || !(floor.step_m > 0)) return null;
  const column = (x - floor.x0) / floor.step_m;
  const row = (y - floor.y0) / floor.step_m;
  const [i, j] = [Math.floor(column), Math.floor(row)];
  if (!(i >= 0 && j >= 0 && i < floor.nx - 1 && j < floor.ny - 1)) return null;
  const at = (di, dj) => floor.depth_m[(j + dj) * floor.nx + i + di];
  const [u, v] = [column - i, row - j];
  const depth = (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v;
  return isNumber(depth) ? depth : null;
}

/** Where a trail {t, x, y, count} was at `t`; null before its begin. */
export function placeOnTrail(trail, t) {
  if (!trail || trail.count === 0 || t < trail.t[0]) return null;
  let [low, high] = [0, trail.count - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (trail.t[middle] <= t) low = middle;
    else high = middle - 1;
  }
  const next = Math.min(low + 1, trail.count - 1);
  const span_s = trail.t[next] - trail.t[low];
  const fraction = span_s > 0 ? Math.min(1, (t - trail.t[low]) / span_s) : 0;
  const mix = (values) => values[low] + (values[next] - values[low]) * fraction;
  return {x: mix(trail.x), y: mix(trail.y)};
}

/**
 * The section along the way that a vehicle went.
 * @param answer  of /api/vehicle
 * @param trail  of World.trail(), or null
 * @param floor  of /api/setup
 * @returns {{way_m: number[], depth: (number | null)[], desired: (number | null)[],
 *            floor: (number | null)[]}}
 */
export function depthSection(answer, trail, floor) {
  /** @type {ReturnType<typeof depthSection>} */
  const section = {way_m: [], depth: [], desired: [], floor: []};
  const times = Array.isArray(answer?.t) ? answer.t : [];
  /** @type {{x: number, y: number} | null} */
  let last = null;
  let way_m = 0;
  times.forEach((t, i) => {
    const place = placeOnTrail(trail, t);
    const depth = answer.depth?.[i];
    if (!place || !isNumber(depth)) return;
    const step_m = last === null ? 0 : Math.hypot(place.x - last.x, place.y - last.y);
    if (last !== null && step_m < kLeast_m) return;
    way_m += step_m;
    last = place;
    const altitude = answer.altitude?.[i];
    const desired = answer.desired_depth?.[i];
    section.way_m.push(way_m);
    section.depth.push(depth);
    section.desired.push(isNumber(desired) && desired >= 0 ? desired : null);
    section.floor.push(isNumber(altitude) ? depth + altitude : floorDepthAt(floor, place.x, place.y));
  });
  return section;
}

/** Is there anything to see: a floor, or a depth? */
export const isWorthShowing = (section) => section.way_m.length > 1
  && (section.floor.some(isNumber) || section.depth.some((depth) => Math.abs(depth) > 0.1));
