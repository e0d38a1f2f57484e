// Reads GeoTIFF images of 8 bits a sample: grey, palette, RGB or RGBA, in strips or tiles; without
// compression, deflate or LZW. Where they lie: WGS 84 degrees, Web Mercator, or, without a
// coordinate system, metres from the mission's origin.
//
// TIFF 6.0 (Adobe 1992); OGC GeoTIFF 1.1.

const kMaxPixels = 64e6;
const kMaxParts = 100_000;
const kSizes = [0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8];
const kTag = {width: 256, height: 257, bits: 258, compression: 259, photometric: 262,
  offsets: 273, samples: 277, rows: 278, counts: 279, planar: 284, predictor: 317, palette: 320,
  tileWidth: 322, tileHeight: 323, tileOffsets: 324, tileCounts: 325, scale: 33550, tie: 33922,
  keys: 34735};
const kModelType = 1024;
const kProjected = 3072;
const kGeographic = 2;
const kWebMercator = 3857;
const kEarth_m = 6378137;

class TiffError extends Error {}

function readTags(view) {
  const order = view.getUint16(0);
  const little = order === 0x4949;
  if ((!little && order !== 0x4d4d) || view.getUint16(2, little) !== 42) {
    throw new TiffError('no TIFF of the usual kind (BigTIFF is not read)');
  }
  const read = {1: 'getUint8', 3: 'getUint16', 4: 'getUint32', 11: 'getFloat32', 12: 'getFloat64'};
  const tags = new Map();
  const start = view.getUint32(4, little);
  const count = view.getUint16(start, little);
  for (let i = 0; i < count; ++i) {
    const at = start + 2 + 12 * i;
    const [tag, type] = [view.getUint16(at, little), view.getUint16(at + 2, little)];
    const number = view.getUint32(at + 4, little);
    if (!Object.hasOwn(read, type) || number > kMaxParts) continue;
    const size = kSizes[type];
    const from = number * size > 4 ? view.getUint32(at + 8, little) : at + 8;
    tags.set(tag, Array.from({length: number}, (_, k) => view[read[type]](from + k * size, little)));
  }
  return tags;
}

// No more than `size` bytes, whatever the file would come to.
async function inflated(bytes, size) {
  const out = new Uint8Array(size);
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  for (let written = 0; written < size;) {
    const {done, value} = await reader.read();
    if (done) return out;
    out.set(value.subarray(0, size - written), written);
    written += value.length;
  }
  reader.cancel().catch(() => {});
  return out;
}

/** Undoes TIFF's LZW; `size` bounds what comes out. */
export function unpackLzw(bytes, size) {
  const [kClear, kEnd] = [256, 257];
  const out = new Uint8Array(size);
  let [written, bits, held, width, at] = [0, 0, 0, 9, 0];
  let table = [];
  let last = null;
  const reset = () => {
    table = Array.from({length: 258}, (_, i) => (i < 256 ? Uint8Array.of(i) : new Uint8Array(0)));
    width = 9;
    last = null;
  };
  reset();
  while (written < size) {
    while (bits < width && at < bytes.length) {
      held = ((held << 8) | bytes[at++]) & 0xffffff;
      bits += 8;
    }
    if (bits < width) break;
    const code = (held >> (bits - width)) & ((1 << width) - 1);
    bits -= width;
    if (code === kEnd) break;
    if (code === kClear) {
      reset();
      continue;
    }
    if (code > table.length || (code === table.length && !last)) break;
    const entry = code < table.length ? table[code] : Uint8Array.of(...last, last[0]);
    out.set(entry.subarray(0, size - written), written);
    written += entry.length;
    if (last && table.length < 4096) {
      const next = new Uint8Array(last.length + 1);
      next.set(last);
      next[last.length] = entry[0];
      table.push(next);
    }
    last = entry;
    if (table.length >= (1 << width) - 1 && width < 12) width += 1;
  }
  return out;
}

async function unpacked(bytes, compression, size) {
  if (compression === 1) return bytes;
  if (compression === 5) return unpackLzw(bytes, size);
  if (compression === 8 || compression === 32946) return inflated(bytes, size);
  throw new TiffError(`compression ${compression} is not read: none, deflate and LZW are`);
}

function undoPredictor(bytes, width, rows, samples) {
  for (let row = 0; row < rows; ++row) {
    const start = row * width * samples;
    for (let i = samples; i < width * samples; ++i) {
      bytes[start + i] = (bytes[start + i] + bytes[start + i - samples]) & 255;
    }
  }
}

/** Writes one sample's colour to `out` at `to`. */
function painter({photometric, samples, palette}) {
  if (photometric === 3 && palette?.length === 768) {
    return (bytes, at, out, to) => {
      for (let c = 0; c < 3; ++c) out[to + c] = palette[c * 256 + bytes[at]] >> 8;
      out[to + 3] = 255;
    };
  }
  if (samples >= 3 && photometric === 2) {
    return (bytes, at, out, to) => {
      for (let c = 0; c < 3; ++c) out[to + c] = bytes[at + c];
      out[to + 3] = samples >= 4 ? bytes[at + 3] : 255;
    };
  }
  if (photometric === 0 || photometric === 1) {
    return (bytes, at, out, to) => {
      const grey = photometric === 0 ? 255 - bytes[at] : bytes[at];
      out.fill(grey, to, to + 3);
      out[to + 3] = 255;
    };
  }
  throw new TiffError('colours are not read: grey, palette, RGB and RGBA are');
}

/** Where the image lies, in metres: {left, top, right, bottom}; null where that is not known. */
function boxOf(tags, width, height, frame) {
  const [scale, tie] = [tags.get(kTag.scale), tags.get(kTag.tie)];
  if (!(scale?.length >= 2 && tie?.length >= 6) || !(scale[0] > 0 && scale[1] > 0)) return null;
  const keys = tags.get(kTag.keys) ?? [];
  const keyOf = (wanted) => {
    for (let i = 4; i + 3 < keys.length; i += 4) if (keys[i] === wanted) return keys[i + 3];
    return 0;
  };
  const [i, j, , x, y] = tie;
  const box = {left: x - i * scale[0], top: y + j * scale[1]};
  box.right = box.left + width * scale[0];
  box.bottom = box.top - height * scale[1];
  const local = (toGeo) => {
    const [upper, lower] = [[box.left, box.top], [box.right, box.bottom]].map(([e, n]) => {
      const [lon, lat] = toGeo(e, n);
      return frame.toLocal(lat, lon);
    });
    return upper && lower ? {left: upper.x, top: upper.y, right: lower.x, bottom: lower.y} : null;
  };
  const model = keyOf(kModelType);
  if (model === kGeographic) return local((e, n) => [e, n]);
  if (keyOf(kProjected) === kWebMercator) {
    return local((e, n) => [e / kEarth_m * 180 / Math.PI,
      Math.atan(Math.sinh(n / kEarth_m)) * 180 / Math.PI]);
  }
  if (model !== 0) throw new TiffError('its projection is not read: WGS 84 degrees and Web Mercator are');
  return box;
}

/**
 * Reads a GeoTIFF. Returns its width, height, rgba (Uint8ClampedArray) and box, which is null where
 * the file does not state its place. Throws an error with a text for the user.
 */
export async function readGeoTiff(buffer, frame) {
  let tags = null;
  try {
    tags = readTags(new DataView(buffer));
  } catch (error) {
    throw error instanceof TiffError ? error : new TiffError('the file is cut');
  }
  const one = (name, otherwise) => tags.get(kTag[name])?.[0] ?? otherwise;
  const [width, height, samples] = [one('width', 0), one('height', 0), one('samples', 1)];
  if (!(width > 0 && height > 0) || width * height > kMaxPixels || samples > 8) {
    throw new TiffError('its size is not read: 64 million pixels at most');
  }
  if (!(tags.get(kTag.bits) ?? [1]).every((bits) => bits === 8) || one('planar', 1) !== 1) {
    throw new TiffError('only 8 bits a sample, sample by sample, are read');
  }
  const isTiled = tags.has(kTag.tileOffsets);
  const partWidth = isTiled ? one('tileWidth', 0) : width;
  const partHeight = isTiled ? one('tileHeight', 0) : Math.min(height, one('rows', height));
  const offsets = tags.get(isTiled ? kTag.tileOffsets : kTag.offsets) ?? [];
  const counts = tags.get(isTiled ? kTag.tileCounts : kTag.counts) ?? [];
  // A tile may stand out of the image, not by more than itself.
  if (!(partWidth > 0 && partHeight > 0)
      || partWidth * partHeight > 2 * (width + 1024) * (height + 1024)) {
    throw new TiffError('the file is cut');
  }
  const paint = painter({photometric: one('photometric', 1), samples, palette: tags.get(kTag.palette)});
  const rgba = new Uint8ClampedArray(width * height * 4);
  const across = Math.ceil(width / partWidth);
  const numParts = Math.min(offsets.length, across * Math.ceil(height / partHeight));
  for (let part = 0; part < numParts; ++part) {
    const [left, top] = [(part % across) * partWidth, Math.floor(part / across) * partHeight];
    const rows = isTiled ? partHeight : Math.min(partHeight, height - top);
    if (top >= height || offsets[part] + (counts[part] ?? 0) > buffer.byteLength) break;
    const raw = new Uint8Array(buffer, offsets[part], counts[part] ?? 0).slice();
    const bytes = await unpacked(raw, one('compression', 1), partWidth * rows * samples);
    if (one('predictor', 1) === 2) undoPredictor(bytes, partWidth, rows, samples);
    for (let row = 0; row < rows && top + row < height; ++row) {
      for (let column = 0; column < partWidth && left + column < width; ++column) {
        const at = (row * partWidth + column) * samples;
        if (at + samples > bytes.length) break;
        paint(bytes, at, rgba, ((top + row) * width + left + column) * 4);
      }
    }
  }
  return {width, height, rgba, box: boxOf(tags, width, height, frame)};
}
