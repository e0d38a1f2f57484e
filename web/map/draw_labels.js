// The vehicles' labels: name, and under it mode and depth. Where they would overlap they are put
// elsewhere, shortened to the name, or left out; those of the selected and the hovered vehicle
// never.

import {kFont} from './draw_theme.js';
import {drawnLength, isStopped} from './draw_vehicles.js';

const kNameFont = `bold 13px ${kFont}`;
const kLineFont = `12px ${kFont}`;
const kLineHeight = 16;
const kPad = 4;
const kPlace_ms = 120;
// A label that finds no room beside its vehicle stands so far from it, on a leader line.
const kLeader = 34;
const kFarSides = 8;
const kMostWithLeaders = 60;
// A telephone's map, and how many vehicles have more than their names on it.
const kNarrow_px = 480;
const kFewOnNarrow = 3;
// Of more vehicles than this in the picture the others have no label until one comes nearer.
const kMostLabels = 200;
// What a label keeps clear of is no larger than this on the screen; on more there is room anyway.
const kLargestKept = 170;

function overlaps(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
      b.y < a.y + a.height;
}

/**
 * Finds a place for each label. Items: {x, y, radius, sizes: [{width, height}, ...], must, first,
 * side}, the longest form first; `side` is the one it had (kept where possible): 0 to 3 beside the
 * vehicle, 4 and more apart from it, on a leader line. Returns, per item, {form, side, x, y} (upper
 * left) or null for those left out. Labels keep clear of the other vehicles, and where they can of
 * `kept`, boxes of what lies on the map; an item that `must` be shown gets its longest form whatever
 * it covers, one that is `first` chooses before the others.
 */
export function placeLabels(items, width = Infinity, height = Infinity, kept = []) {
  const hulls = items.map(({x, y, radius}) => {
    const half = radius * 0.7;
    return {x: x - half, y: y - half, width: 2 * half, height: 2 * half};
  });
  const mayLead = items.length <= kMostWithLeaders;
  const taken = [];
  const covers = [];
  const placed = new Array(items.length).fill(null);
  const order = items.map((_, i) => i)
      .sort((a, b) => rankOf(items[b]) - rankOf(items[a]) || a - b).slice(0, kMostLabels);
  const find = (i, form) => {
    const item = items[i];
    const sides = [...kSides.slice(0, mayLead ? kSides.length : 4)]
        .sort((a, b) => Number(b === item.side) - Number(a === item.side));
    let covering = null;
    for (const side of sides) {
      const box = boxAt(item, item.sizes[form], side);
      if (box.x < 0 || box.y < 0 || box.x + box.width > width || box.y + box.height > height) {
        continue;
      }
      if (taken.some((other, k) => k !== i && overlaps(box, other))) continue;
      if (hulls.some((hull, k) => (k !== i || side >= 4) && overlaps(box, hull))) continue;
      if (!kept.some((other) => overlaps(box, other))) return {form, side, box};
      if (side < 4) covering ??= {form, side, box, covers: true};
    }
    return covering;
  };
  const place = (i, found) => {
    if (!found) return;
    taken[i] = found.box;
    covers[i] = Boolean(found.covers);
    placed[i] = {form: found.form, side: found.side, x: found.box.x, y: found.box.y};
  };
  // Every name goes before the second line of any but the most important.
  for (const i of order) {
    const {sizes, side = 0, must} = items[i];
    let found = null;
    for (let form = rankOf(items[i]) > 0 ? 0 : sizes.length - 1; form < sizes.length; ++form) {
      found ??= find(i, form);
    }
    if (!found && must) found = {form: 0, side, box: boxAt(items[i], sizes[0], side)};
    place(i, found);
  }
  for (const i of order) {
    for (let form = 0; placed[i] && form < placed[i].form; ++form) {
      const found = find(i, form);
      // More lines are not worth what they would cover.
      if (!found?.covers || covers[i]) place(i, found);
    }
  }
  return placed;
}

function rankOf({must, first}) {
  return must ? 2 : first ? 1 : 0;
}

const kSides = Array.from({length: 4 + kFarSides}, (_, side) => side);

// Sides: right, left, below, above, then around at a distance.
function boxAt({x, y, radius}, {width, height}, side) {
  if (side >= 4) {
    const angle = (side - 4) * 2 * Math.PI / kFarSides - Math.PI / 4;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const away = radius + kLeader;
    // The box touches the circle with the edge or corner that is turned to the vehicle.
    return {x: x + c * away + (c < -0.1 ? -width : c > 0.1 ? 0 : -width / 2),
      y: y + s * away + (s < -0.1 ? -height : s > 0.1 ? 0 : -height / 2), width, height};
  }
  const gap = radius + 2;
  const left = side === 0 ? x + gap : side === 1 ? x - gap - width : x - width / 2;
  const top = side === 2 ? y + gap : side === 3 ? y - gap - height : y - height / 2;
  return {x: left, y: top, width, height};
}

function shortened(text, most) {
  return text.length > most ? `${text.slice(0, most - 1)}\u2026` : text;
}

/** Returns the lines of a vehicle's label: {text, bold, color: which of the theme's}. */
export function labelLines(vehicle, t) {
  /** @type {{text: string, bold?: boolean, color?: string}[]} */
  const lines = [{text: shortened(String(vehicle.name), 20), bold: true}];
  const reason = vehicle.helm?.all_stop;
  const why = reason && reason !== 'clear' ? reason : '';
  if (isStopped(vehicle)) {
    lines.push({text: shortened(`ALL-STOP${why && `: ${why}`}`, 36), color: 'danger'});
  } else if (why) {
    lines.push({text: shortened(why, 36)});
  } else {
    const mode = vehicle.mode || vehicle.helm?.state || '';
    const depth = vehicle.depth !== null && Math.abs(vehicle.depth) >= 0.05 ?
        `${vehicle.depth.toFixed(1)} m` : '';
    const line = [shortened(String(mode), 26), depth].filter(Boolean).join(' \u00b7 ');
    if (line) lines.push({text: line});
  }
  if (vehicle.stale) {
    const age_s = t - (vehicle.report?.t ?? vehicle.nav?.t ?? NaN);
    lines.push({text: Number.isFinite(age_s) ? `stale ${age_s.toFixed(0)} s` : 'stale',
      color: 'warning'});
  }
  return lines;
}

// The boxes on the screen of what is small there.
function keptBoxes(camera, outlines) {
  const boxes = [];
  for (const points of outlines) {
    const xs = points.map(([x]) => camera.sx(x));
    const ys = points.map(([, y]) => camera.sy(y));
    const box = {x: Math.min(...xs), y: Math.min(...ys)};
    box.width = Math.max(...xs) - box.x;
    box.height = Math.max(...ys) - box.y;
    const isSmall = Math.max(box.width, box.height) <= kLargestKept;
    if (isSmall && camera.sees(box.x, box.y, kLargestKept)) boxes.push(box);
  }
  // Scale bar and North.
  boxes.push({x: 0, y: camera.height - 46, width: 190, height: 46},
             {x: camera.width - 50, y: 0, width: 50, height: 60});
  return boxes.slice(-200);
}

// From the vehicle to the nearest point of the label.
function drawLeader(ctx, theme, item, {x, y, width, height}) {
  const toX = Math.min(Math.max(item.x, x), x + width);
  const toY = Math.min(Math.max(item.y, y), y + height);
  ctx.strokeStyle = theme.muted;
  ctx.lineWidth = 1;
  ctx.setLineDash([]);
  ctx.beginPath();
  ctx.moveTo(item.x, item.y);
  ctx.lineTo(toX, toY);
  ctx.stroke();
}

/** Draws the labels and remembers where they were, so that they do not jump about. */
export class LabelLayer {
  #widths = new Map();
  #places = new Map();  // name -> {form, side, dx, dy}; form -1: left out
  #placed_ms = -Infinity;
  #key = '';

  /** @param kept  lists of [x, y], metres: what labels keep clear of where they can */
  draw(ctx, camera, theme, vehicles, t, {selected, hovered}, nowMs, kept = []) {
    const items = [];
    for (const vehicle of vehicles) {
      if (vehicle.x === null) continue;
      const [x, y] = [camera.sx(vehicle.x), camera.sy(vehicle.y)];
      if (!camera.sees(x, y, 20)) continue;
      const radius = Math.min(60, Math.max(13, 0.5 * drawnLength(vehicle, camera)));
      items.push({key: vehicle.name, vehicle, x, y, radius,
        must: vehicle.name === selected || vehicle.name === hovered,
        first: isStopped(vehicle) || Boolean(vehicle.stale)});
    }
    const key = `${camera.metresPerPixel} ${selected} ${hovered} ${items.length}`;
    if (key !== this.#key || nowMs - this.#placed_ms > kPlace_ms) {
      this.#place(ctx, camera, items, t, keptBoxes(camera, kept));
      this.#key = key;
      this.#placed_ms = nowMs;
    }
    ctx.textAlign = 'left';
    ctx.textBaseline = 'middle';
    for (const item of items) {
      const place = this.#places.get(item.key);
      if (place && place.form >= 0) this.#drawOne(ctx, theme, item, place, t);
    }
  }

  #place(ctx, camera, items, t, kept) {
    const narrow = camera.width < kNarrow_px && items.length > kFewOnNarrow;
    for (const item of items) {
      const lines = labelLines(item.vehicle, t);
      // A small map is for the vehicles: the names alone, but for those that matter most.
      const short = narrow && rankOf(item) === 0;
      const forms = short ? [lines.slice(0, 1)]
          : lines.length > 1 ? [lines, lines.slice(0, 1)] : [lines];
      item.sizes = forms.map((form) => this.#size(ctx, form));
      item.lines = forms.map((form) => form.length);
      item.side = this.#places.get(item.key)?.side;
    }
    const placed = placeLabels(items, camera.width, camera.height, kept);
    this.#places.clear();
    items.forEach((item, i) => {
      const found = placed[i];
      if (found) {
        this.#places.set(item.key, {form: found.form, side: found.side, dx: found.x - item.x,
          dy: found.y - item.y, lines: item.lines[found.form], ...item.sizes[found.form]});
      }
    });
  }

  #size(ctx, lines) {
    let width = 0;
    for (const line of lines) width = Math.max(width, this.#widthOf(ctx, line));
    return {width: Math.ceil(width) + 2 * kPad, height: lines.length * kLineHeight + 3};
  }

  // Digits are equally wide, so that a changing depth needs no new measurement.
  #widthOf(ctx, {text, bold}) {
    const key = (bold ? 'b' : ' ') + text.replace(/\d/g, '0');
    let width = this.#widths.get(key);
    if (width === undefined) {
      if (this.#widths.size > 2000) this.#widths.clear();
      ctx.font = bold ? kNameFont : kLineFont;
      this.#widths.set(key, width = ctx.measureText(key.slice(1)).width);
    }
    return width;
  }

  #drawOne(ctx, theme, item, place, t) {
    const x = Math.round(item.x + place.dx);
    const y = Math.round(item.y + place.dy);
    if (place.side >= 4) drawLeader(ctx, theme, item, {...place, x, y});
    ctx.fillStyle = theme.plate;
    ctx.fillRect(x, y, place.width, place.height);
    let lines = labelLines(item.vehicle, t);
    lines = lines.slice(0, place.lines);
    lines.forEach((line, i) => {
      ctx.font = line.bold ? kNameFont : kLineFont;
      ctx.fillStyle = theme[line.color ?? (line.bold ? 'text' : 'muted')];
      ctx.fillText(line.text, x + kPad, y + 2 + (i + 0.5) * kLineHeight);
    });
  }
}
