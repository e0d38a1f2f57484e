// An image that lies on the ground: cut into cells, of which each is drawn as a parallelogram, so
// that an image of degrees or of a projection lies where it belongs, to half a pixel of its own.

const kMaxCells = 32;    // A side.
const kTolerance_px = 0.5;

/**
 * Returns {image, box, cells}, or null where a corner lies out of the plane's reach.
 * @param image  with width and height
 * @param {(u: number, v: number) => {x: number, y: number} | null} place  metres of a pixel's
 *     upper left corner
 */
export function groundImage(image, place) {
  for (let count = 1; ; count *= 2) {
    const mesh = meshOf(image, place, count);
    if (!mesh) return null;
    if (mesh.off_px <= kTolerance_px || count >= kMaxCells) {
      return {image, box: mesh.box, cells: mesh.cells};
    }
  }
}

function meshOf(image, place, count) {
  const box = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
  const points = [];
  for (let row = 0; row <= count; ++row) {
    for (let column = 0; column <= count; ++column) {
      const at = place(image.width * column / count, image.height * row / count);
      if (!at) return null;
      box.left = Math.min(box.left, at.x);
      box.right = Math.max(box.right, at.x);
      box.bottom = Math.min(box.bottom, at.y);
      box.top = Math.max(box.top, at.y);
      points.push(at);
    }
  }
  const cells = [];
  let off = 0;
  const [w, h] = [image.width / count, image.height / count];
  for (let row = 0; row < count; ++row) {
    for (let column = 0; column < count; ++column) {
      const first = row * (count + 1) + column;
      const [ul, ur, ll, lr] = [points[first], points[first + 1], points[first + count + 1],
        points[first + count + 2]];
      cells.push({u: column * w, v: row * h, w, h, ul, ur, ll});
      // Beside the corner that a parallelogram would have; what it is in the middle is a quarter.
      const beside = Math.hypot(ur.x + ll.x - ul.x - lr.x, ur.y + ll.y - ul.y - lr.y) / 4;
      const pixel = Math.max(Math.hypot(ur.x - ul.x, ur.y - ul.y) / w, 1e-9);
      off = Math.max(off, beside / pixel);
      const middle = place((column + 0.5) * w, (row + 0.5) * h);
      if (middle) {
        off = Math.max(off, Math.hypot(middle.x - (ur.x + ll.x) / 2,
          middle.y - (ur.y + ll.y) / 2) / pixel);
      }
    }
  }
  return {box, cells, off_px: off};
}

/** Draws what a camera sees of it. */
export function drawGroundImage(ctx, camera, {image, box, cells}) {
  if (box.right < camera.left || box.left > camera.right || box.top < camera.bottom
      || box.bottom > camera.top) return;
  ctx.imageSmoothingEnabled = true;
  for (const {u, v, w, h, ul, ur, ll} of cells) {
    const [x, y] = [camera.sx(ul.x), camera.sy(ul.y)];
    // A pixel more than the cell, so that no seam is seen between two.
    const [wide, tall] = [Math.min(w + 1, image.width - u), Math.min(h + 1, image.height - v)];
    ctx.save();
    ctx.transform((camera.sx(ur.x) - x) / w, (camera.sy(ur.y) - y) / w,
      (camera.sx(ll.x) - x) / h, (camera.sy(ll.y) - y) / h, x, y);
    ctx.drawImage(image, u, v, wide, tall, 0, 0, wide, tall);
    ctx.restore();
  }
}

/** The place of an image that fills {left, top, right, bottom}. */
export const placeInBox = (image, {left, top, right, bottom}) => (u, v) => ({
  x: left + (right - left) * u / image.width, y: top + (bottom - top) * v / image.height});
