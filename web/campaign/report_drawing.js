// How marks are drawn on the canvas of a chart. Lines differ in colour, dash and shape; outcomes in
// shape.

const kDashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [14, 4], [1, 4], [8, 3, 3, 3]];
const kCurveStep_px = 7; // Between the points of lines that share a place.
const kMaxShapes = 5000; // Of more trials a pass is a small square: paths of shapes are slow.

/** Adds a shape to the path: circle, square, diamond, triangles, cross, plus, hexagon. */
function addShape(path, shape, x, y, r) {
  const polygon = (num, turn) => {
    for (let i = 0; i < num; ++i) {
      const angle = turn + 2 * Math.PI * i / num;
      path[i === 0 ? 'moveTo' : 'lineTo'](x + r * Math.cos(angle), y + r * Math.sin(angle));
    }
    path.closePath();
  };
  const up = -Math.PI / 2;
  if (shape === 1) polygon(4, up / 2);
  else if (shape === 2) polygon(3, up);
  else if (shape === 3) polygon(4, up);
  else if (shape === 4) polygon(3, -up);
  else if (shape === 5) polygon(5, up);
  else if (shape === 6) polygon(6, 0);
  else if (shape === 7) polygon(8, up);
  else {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  }
}

function addCross(path, x, y, r) {
  path.moveTo(x - r, y - r);
  path.lineTo(x + r, y + r);
  path.moveTo(x - r, y + r);
  path.lineTo(x + r, y - r);
}

/** How far right of its place a point of a line is drawn, so that intervals do not cover others. */
export const curveShift_px = (line, num) => (line - (num - 1) / 2) * kCurveStep_px;

/** Lines with intervals. `at` maps values to pixels of the canvas, `ratio` is theirs to CSS's. */
export function drawCurves(ctx, {marks, lines, isJoined}, at, colors, ratio) {
  lines.forEach((_, line) => {
    const shift = curveShift_px(line, lines.length) * ratio;
    const points = marks.filter((mark) => mark.line === line).map((mark) => ({
      x: at.x(mark.x) + shift, y: at.y(mark.y), low: at.y(mark.low), high: at.y(mark.high)}));
    ctx.strokeStyle = ctx.fillStyle = colors[line];
    ctx.lineWidth = 2 * ratio;
    if (isJoined) {
      ctx.setLineDash(kDashes[line].map((part) => part * ratio));
      ctx.beginPath();
      points.forEach(({x, y}, i) => ctx[i === 0 ? 'moveTo' : 'lineTo'](x, y));
      ctx.stroke();
      ctx.setLineDash([]);
    }
    ctx.lineWidth = 1.5 * ratio;
    ctx.beginPath();
    for (const {x, low, high} of points) {
      if (low === high) continue;
      ctx.moveTo(x, low);
      ctx.lineTo(x, high);
      for (const end of [low, high]) {
        ctx.moveTo(x - 4 * ratio, end);
        ctx.lineTo(x + 4 * ratio, end);
      }
    }
    ctx.stroke();
    ctx.beginPath();
    for (const {x, y} of points) addShape(ctx, line, x, y, 5 * ratio);
    ctx.fill();
  });
}

/** Points; what did not pass is a cross (fail) or an empty square, and drawn above the passes. */
export function drawTrials(ctx, {marks, lines, outcomeOf}, at, colors, ratio) {
  const isCrowd = marks.length > kMaxShapes;
  const r = (isCrowd ? 1.4 : marks.length > 600 ? 2.4 : 3.4) * ratio;
  const rest = new Map(lines.map((_, line) => [line, {passes: new Path2D(), others: []}]));
  ctx.globalAlpha = marks.length > 600 ? 0.5 : 0.75;
  let lastLine = -1;
  for (const mark of marks) {
    const {passes, others} = rest.get(mark.line);
    if (outcomeOf(mark.row) !== 0) {
      others.push(mark);
    } else if (isCrowd) {
      if (mark.line !== lastLine) ctx.fillStyle = colors[mark.line];
      lastLine = mark.line;
      ctx.fillRect(at.x(mark.x) - r, at.y(mark.y) - r, 2 * r, 2 * r);
    } else {
      addShape(passes, mark.line, at.x(mark.x), at.y(mark.y), r);
    }
  }
  for (const [line, {passes}] of rest) {
    ctx.fillStyle = colors[line];
    ctx.fill(passes);
  }
  ctx.globalAlpha = 1;
  ctx.lineWidth = 1.6 * ratio;
  for (const [line, {others}] of rest) {
    ctx.strokeStyle = colors[line];
    for (const mark of others) {
      const x = at.x(mark.x);
      const y = at.y(mark.y);
      ctx.beginPath();
      if (outcomeOf(mark.row) === 1) addCross(ctx, x, y, r * 1.3);
      else ctx.rect(x - r, y - r, 2 * r, 2 * r);
      ctx.stroke();
    }
  }
}

/** Outlines of the counts of each line. */
export function drawBins(ctx, {marks, lines}, at, colors, ratio) {
  const ground = at.y(0);
  lines.forEach((_, line) => {
    const outline = new Path2D();
    outline.moveTo(at.x(marks[0].begin), ground);
    for (const mark of marks) {
      const y = at.y(mark.counts[line]);
      outline.lineTo(at.x(mark.begin), y);
      outline.lineTo(at.x(mark.end), y);
    }
    outline.lineTo(at.x(marks[marks.length - 1].end), ground);
    ctx.fillStyle = ctx.strokeStyle = colors[line];
    ctx.globalAlpha = 0.18;
    ctx.fill(outline);
    ctx.globalAlpha = 1;
    ctx.lineWidth = 2 * ratio;
    ctx.setLineDash(kDashes[line].map((part) => part * ratio));
    ctx.stroke(outline);
    ctx.setLineDash([]);
  });
}

/** A line of the legend, on a small canvas. */
export function drawSample(canvas, line, color) {
  const ratio = globalThis.devicePixelRatio || 1;
  canvas.width = 44 * ratio;
  canvas.height = 14 * ratio;
  const ctx = canvas.getContext('2d');
  ctx.strokeStyle = ctx.fillStyle = color;
  ctx.lineWidth = 2 * ratio;
  ctx.setLineDash(kDashes[line].map((part) => part * ratio));
  ctx.beginPath();
  ctx.moveTo(0, 7 * ratio);
  ctx.lineTo(44 * ratio, 7 * ratio);
  ctx.stroke();
  ctx.beginPath();
  addShape(ctx, line, 22 * ratio, 7 * ratio, 5 * ratio);
  ctx.fill();
}
