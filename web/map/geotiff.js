// Reads GeoTIFF images of 8 bits a sample: grey, palette, RGB or RGBA, in strips or tiles; without
// compression, deflate or LZW. Where they lie: WGS 84 degrees, UTM, Web Mercator, or, without a
// coordinate system, metres from the mission's origin.
//
// TIFF 6.0 (Adobe 1992); OGC GeoTIFF 1.1.

import {projectionOf} from './projection.js';

const kMaxPixels = 64e6;
const kMaxParts = 100_000;
const kSizes = [0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8];
const kTag = {width: 256, height: 257, bits: 258, compression: 259, photometric: 262,
  offsets: 273, samples: 277, rows: 278, counts: 279, planar: 284, predictor: 317, palette: 320,
  tileWidth: 322, tileHeight: 323, tileOffsets: 324, tileCounts: 325, scale: 33550, tie: 33922,
  matrix: 34264, keys: 34735};
const kModelType = 1024;
const kRasterType = 1025;
const kProjected = 3072;
const kLinearUnit = 3076;
const kGeographic = 2;
const kPixelIsPoint = 2;
const kMetre = 9001;
const kCut = 'it is cut: its end is missing; copy it again';

class TiffError extends Error {}

function readTags(view) {
  const order = view.getUint16(0);
  const little = order === 0x4949;
  if ((!little && order !== 0x4d4d) || view.getUint16(2, little) !== 42) {
    throw new TiffError('no TIFF of the usual kind; BigTIFF is not read: convert it '
        + '(gdal_translate -co BIGTIFF=NO IN.tif OUT.tif)');
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
    const {done, value} = await reader.read().catch(() => {
      throw new TiffError('a part of it is damaged, or cut; copy it again');
    });
    if (done) throw new TiffError('a part of it is damaged, or cut; copy it again');
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
  if (compression === 1) {
    if (bytes.length < size) throw new TiffError(kCut);
    return bytes;
  }
  if (compression === 5) return unpackLzw(bytes, size);
  if (compression === 8 || compression === 32946) return inflated(bytes, size);
  throw new TiffError(`compression ${compression} is not read: convert it `
      + '(gdal_translate -co COMPRESS=DEFLATE IN.tif OUT.tif)');
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
  throw new TiffError('its colours are not read: convert it to RGB '
      + '(gdal_translate -expand rgb IN.tif OUT.tif)');
}

/** Returns the value of a key of the GeoKeyDirectory; 0: it is not there. */
function geoKey(tags, wanted) {
  const keys = tags.get(kTag.keys) ?? [];
  for (let i = 4; i + 3 < keys.length; i += 4) if (keys[i] === wanted) return keys[i + 3];
  return 0;
}

/** Returns what makes model coordinates [e, n] of a pixel's upper left corner, or null. */
function modelOf(tags) {
  const [scale, tie, matrix] = [tags.get(kTag.scale), tags.get(kTag.tie), tags.get(kTag.matrix)];
  const half = geoKey(tags, kRasterType) === kPixelIsPoint ? 0.5 : 0;
  if (scale?.length >= 2 && tie?.length >= 6 && scale[0] > 0 && scale[1] > 0) {
    const [i, j, , x, y] = tie;
    return (u, v) => [x + (u - half - i) * scale[0], y - (v - half - j) * scale[1]];
  }
  if (matrix?.length === 16) {
    const [a, b, , d, e, f, , h] = matrix;
    return (u, v) => [a * (u - half) + b * (v - half) + d, e * (u - half) + f * (v - half) + h];
  }
  return null;
}

/** Returns what makes metres {x, y} of a pixel's corner; null where the file does not state it. */
function placeOf(tags, frame) {
  const model = modelOf(tags);
  if (!model) return null;
  const [type, epsg] = [geoKey(tags, kModelType), geoKey(tags, kProjected)];
  if (type === 0 && epsg === 0) {
    return (u, v) => {
      const [x, y] = model(u, v);
      return Number.isFinite(x) && Number.isFinite(y) ? {x, y} : null;
    };
  }
  const unit = geoKey(tags, kLinearUnit);
  const toGeo = type === kGeographic ? (e, north) => [e, north]
    : unit === 0 || unit === kMetre ? projectionOf(epsg) : null;
  if (!toGeo) {
    throw new TiffError(`its projection${epsg > 0 ? ` EPSG:${epsg}` : ''} is not read: convert it to `
        + 'WGS 84 degrees (gdalwarp -t_srs EPSG:4326 IN.tif OUT.tif), UTM or Web Mercator');
  }
  return (u, v) => {
    const [e, north] = model(u, v);
    const [lon, lat] = toGeo(e, north);
    return frame.toLocal(lat, lon);
  };
}

function boxOf(place, width, height) {
  const corners = [[0, 0], [width, 0], [0, height], [width, height]].map(([u, v]) => place(u, v));
  if (!corners.every(Boolean)) {
    throw new TiffError('it lies more than 1,500 km from the mission: is its place, or the '
        + 'mission\'s origin, wrong?');
  }
  const [xs, ys] = [corners.map(({x}) => x), corners.map(({y}) => y)];
  return {left: Math.min(...xs), top: Math.max(...ys), right: Math.max(...xs),
    bottom: Math.min(...ys)};
}

/**
 * Reads a GeoTIFF. Returns its width, height and rgba (Uint8ClampedArray); place(u, v), the metres
 * {x, y} of a pixel's upper left corner; and box, around the corners. The last two are null where
 * the file does not state where it lies. Throws an error with a text for the user.
 */
export async function readGeoTiff(buffer, frame) {
  let tags = null;
  try {
    tags = readTags(new DataView(buffer));
  } catch (error) {
    throw error instanceof TiffError ? error : new TiffError(kCut);
  }
  const one = (name, otherwise) => tags.get(kTag[name])?.[0] ?? otherwise;
  const [width, height, samples] = [one('width', 0), one('height', 0), one('samples', 1)];
  if (!(width > 0 && height > 0) || width * height > kMaxPixels || samples > 8) {
    throw new TiffError('its size is not read: 64 million pixels are the most; make it smaller');
  }
  if (!(tags.get(kTag.bits) ?? [1]).every((bits) => bits === 8) || one('planar', 1) !== 1) {
    throw new TiffError('only 8 bits a sample, sample by sample, are read: convert it '
        + '(gdal_translate -ot Byte -scale -co INTERLEAVE=PIXEL IN.tif OUT.tif)');
  }
  const isTiled = tags.has(kTag.tileOffsets);
  const partWidth = isTiled ? one('tileWidth', 0) : width;
  const partHeight = isTiled ? one('tileHeight', 0) : Math.min(height, one('rows', height));
  const offsets = tags.get(isTiled ? kTag.tileOffsets : kTag.offsets) ?? [];
  const counts = tags.get(isTiled ? kTag.tileCounts : kTag.counts) ?? [];
  // A tile may stand out of the image, not by more than itself.
  if (!(partWidth > 0 && partHeight > 0)
      || partWidth * partHeight > 2 * (width + 1024) * (height + 1024)) {
    throw new TiffError(kCut);
  }
  const paint = painter({photometric: one('photometric', 1), samples, palette: tags.get(kTag.palette)});
  const rgba = new Uint8ClampedArray(width * height * 4);
  const across = Math.ceil(width / partWidth);
  const numParts = across * Math.ceil(height / partHeight);
  if (offsets.length < numParts || counts.length < numParts) throw new TiffError(kCut);
  const place = placeOf(tags, frame);
  const box = place ? boxOf(place, width, height) : null;
  for (let part = 0; part < numParts; ++part) {
    const [left, top] = [(part % across) * partWidth, Math.floor(part / across) * partHeight];
    const rows = isTiled ? partHeight : Math.min(partHeight, height - top);
    if (offsets[part] + counts[part] > buffer.byteLength) throw new TiffError(kCut);
    const raw = new Uint8Array(buffer, offsets[part], counts[part]).slice();
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
  return {width, height, rgba, place, box};
}
