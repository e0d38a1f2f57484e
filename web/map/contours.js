// Depth contours of the sea floor: marching squares over the grid of /api/setup.

import {isNumber, roundStep} from './geometry.js';

// A grid with more nodes is not drawn: it came damaged.
const kMaxNodes = 4e6;

/** True where `floor` is a grid that can be drawn. */
export function isFloor(floor) {
  return floor != null && Number.isInteger(floor.nx) && Number.isInteger(floor.ny) &&
      floor.nx >= 2 && floor.ny >= 2 && floor.nx * floor.ny <= kMaxNodes && floor.step_m > 0 &&
      isNumber(floor.step_m) && isNumber(floor.x0) && isNumber(floor.y0) &&
      Array.isArray(floor.depth_m) && floor.depth_m.length === floor.nx * floor.ny;
}

/** Returns {least, greatest} of the depths that are known, or null. */
export function depthRange(floor) {
  let least = Infinity;
  let greatest = -Infinity;
  for (const depth of floor.depth_m) {
    if (!isNumber(depth)) continue;
    if (depth < least) least = depth;
    if (depth > greatest) greatest = depth;
  }
  return least <= greatest ? {least, greatest} : null;
}

/** Returns round depths inside the range, at most about `count`; none where the floor is flat. */
export function contourLevels(least, greatest, count = 10) {
  const span = greatest - least;
  if (!(span > 0.02) || !isNumber(span)) return [];
  const step = roundStep(span / count);
  const levels = [];
  for (let k = Math.ceil(least / step); k * step <= greatest; ++k) {
    if (k * step > least) levels.push(Number((k * step).toPrecision(12)));
  }
  return levels;
}

// Which edges of a cell a contour joins, by the corners that are deep: bit 0 South-West, 1
// South-East, 2 North-East, 3 North-West. Edges: 0 South, 1 East, 2 North, 3 West. The two saddles
// (5, 10) are listed as they are where the cell's middle is shallow.
const kJoins = [
  [], [[3, 0]], [[0, 1]], [[3, 1]], [[1, 2]], [[3, 0], [1, 2]], [[0, 2]], [[3, 2]],
  [[2, 3]], [[2, 0]], [[0, 1], [2, 3]], [[2, 1]], [[1, 3]], [[1, 0]], [[0, 3]], [],
];
const kJoinsDeepMiddle = {5: [[3, 2], [1, 0]], 10: [[0, 3], [2, 1]]};

/**
 * Returns the lines along which the floor is `level` deep, each a flat array [x, y, x, y, ...] in
 * metres; a closed line ends where it began. Cells with an unknown corner have none.
 */
export function contourLines(floor, level) {
  const {nx, ny, depth_m: depth} = floor;
  const isDeep = (k) => depth[k] >= level;
  // A point lies on the edge East of a node (2 k) or North of it (2 k + 1).
  const neighbours = new Map();
  const join = (a, b) => {
    for (const [one, other] of [[a, b], [b, a]]) {
      const list = neighbours.get(one);
      if (list) list.push(other);
      else neighbours.set(one, [other]);
    }
  };
  for (let j = 0; j + 1 < ny; ++j) {
    for (let i = 0; i + 1 < nx; ++i) {
      const sw = j * nx + i;
      const [se, nw, ne] = [sw + 1, sw + nx, sw + nx + 1];
      const sum = depth[sw] + depth[se] + depth[nw] + depth[ne];
      if (!isNumber(sum) || [sw, se, nw, ne].some((k) => depth[k] === null)) continue;
      const kind = (isDeep(sw) ? 1 : 0) | (isDeep(se) ? 2 : 0) | (isDeep(ne) ? 4 : 0) |
          (isDeep(nw) ? 8 : 0);
      const edges = [2 * sw, 2 * se + 1, 2 * nw, 2 * sw + 1];
      const joins = (sum / 4 >= level && kJoinsDeepMiddle[kind]) || kJoins[kind];
      for (const [a, b] of joins) join(edges[a], edges[b]);
    }
  }
  const pointOf = (edge) => {
    const a = edge >> 1;
    const b = edge & 1 ? a + nx : a + 1;
    const fraction = depth[a] === depth[b] ? 0.5 : (level - depth[a]) / (depth[b] - depth[a]);
    const i = a % nx;
    const j = (a - i) / nx;
    return [floor.x0 + floor.step_m * (edge & 1 ? i : i + fraction),
      floor.y0 + floor.step_m * (edge & 1 ? j + fraction : j)];
  };
  return walkLines(neighbours).map((edges) => edges.flatMap(pointOf));
}

// Takes the graph apart into lines: first those with ends, then the closed ones.
function walkLines(neighbours) {
  const take = (a, b) => {
    for (const [one, other] of [[a, b], [b, a]]) {
      const list = neighbours.get(one);
      list.splice(list.indexOf(other), 1);
    }
  };
  const walk = (start) => {
    const line = [start];
    for (let at = start; neighbours.get(at).length > 0;) {
      const next = neighbours.get(at)[0];
      take(at, next);
      line.push(next);
      at = next;
    }
    return line;
  };
  const lines = [];
  for (const ends of [true, false]) {
    for (const [edge, list] of neighbours) {
      if (list.length > 0 && (!ends || list.length === 1)) lines.push(walk(edge));
    }
  }
  return lines;
}

/** Returns [{level, lines}] for the floor of a setup, or [] where it has none or is flat. */
export function floorContours(floor, count = 10) {
  if (!isFloor(floor)) return [];
  const range = depthRange(floor);
  if (!range) return [];
  return contourLevels(range.least, range.greatest, count)
      .map((level) => ({level, lines: contourLines(floor, level)}));
}
