// What a file of an image states of itself, before a browser is given it: its size in pixels, and
// whether all of it is there. A browser draws half of a cut PNG without an error.

/** What is wrong with a file, in words for the user. */
export class ImageError extends Error {}

const kMaxPixels = 64e6;
const kCut = 'it is cut: its end is missing; copy it again';

const isText = (view, at, text) => [...text].every(
  (letter, i) => at + i < view.byteLength && view.getUint8(at + i) === letter.charCodeAt(0));

// Portable Network Graphics (W3C, third edition), 5.
function readPng(view) {
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  for (let at = 8; at + 12 <= view.byteLength; at += 12 + view.getUint32(at)) {
    if (at + 12 + view.getUint32(at) > view.byteLength) break;
    if (isText(view, at + 4, 'IEND')) return {width, height};
  }
  throw new ImageError(kCut);
}

// ITU-T T.81, B.1: segments from the start to the first scan, which has the size before it.
function readJpeg(view) {
  let size = null;
  for (let at = 2; at + 9 < view.byteLength;) {
    if (view.getUint8(at) !== 0xff) break;
    const marker = view.getUint8(at + 1);
    const isFrame = marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
    if (isFrame) size = {height: view.getUint16(at + 5), width: view.getUint16(at + 7)};
    if (marker === 0xda) break;
    at += 2 + view.getUint16(at + 2);
  }
  // Some writers put zeros behind the end.
  let end = view.byteLength;
  while (end > 2 && view.getUint8(end - 1) === 0) --end;
  if (!size || view.getUint16(end - 2) !== 0xffd9) throw new ImageError(kCut);
  return size;
}

// RFC 9649.
function readWebp(view) {
  if (view.getUint32(4, true) + 8 > view.byteLength) throw new ImageError(kCut);
  if (isText(view, 12, 'VP8X')) {
    const three = (at) => view.getUint16(at, true) + (view.getUint8(at + 2) << 16) + 1;
    return {width: three(24), height: three(27)};
  }
  if (isText(view, 12, 'VP8L')) {
    const bits = view.getUint32(21, true);
    return {width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1};
  }
  return {width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff};
}

/**
 * Returns {width, height} of a PNG, JPEG or WebP. Throws an ImageError for what is none, is cut, or
 * has more than `maxPixels`.
 * @param {ArrayBuffer} buffer
 */
export function imageSize(buffer, maxPixels = kMaxPixels) {
  const view = new DataView(buffer);
  let size = null;
  try {
    if (isText(view, 0, '\x89PNG\r\n\x1a\n')) size = readPng(view);
    else if (isText(view, 0, '\xff\xd8\xff')) size = readJpeg(view);
    else if (isText(view, 0, 'RIFF') && isText(view, 8, 'WEBP')) size = readWebp(view);
  } catch (error) {
    throw error instanceof ImageError ? error : new ImageError(kCut);
  }
  if (!size) {
    throw new ImageError('not an image that the browser can read: PNG, JPEG and WebP are');
  }
  if (!(size.width > 0 && size.height > 0) || size.width * size.height > maxPixels) {
    throw new ImageError(`${size.width} x ${size.height} pixels are too many, `
        + `${maxPixels / 1e6} million are the most: make it smaller`);
  }
  return size;
}

/** Returns the decoded image. Throws an ImageError. */
export async function decodeImage(blob, maxPixels = kMaxPixels) {
  imageSize(await blob.arrayBuffer(), maxPixels);
  try {
    return await createImageBitmap(blob);
  } catch {
    throw new ImageError('not an image that the browser can read: it is damaged; save it again');
  }
}
