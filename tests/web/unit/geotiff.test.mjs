import assert from 'node:assert/strict';
import {test} from 'node:test';
import {deflateSync} from 'node:zlib';

import {LocalFrame} from '../../../web/map/geometry.js';
import {readGeoTiff, unpackLzw} from '../../../web/map/geotiff.js';

const frame = new LocalFrame({lat_deg: 43, lon_deg: -70});

/** A little-endian TIFF of one strip. `tags`: [tag, type, values]. */
function tiff(tags, strip) {
  const sizes = {3: 2, 4: 4, 12: 8};
  const all = [...tags, [273, 4, [0]], [279, 4, [strip.length]]].sort((a, b) => a[0] - b[0]);
  let extra = 8 + 2 + 12 * all.length + 4;
  const places = all.map(([, type, values]) => {
    const size = sizes[type] * values.length;
    if (size <= 4) return null;
    extra += size;
    return extra - size;
  });
  const buffer = new ArrayBuffer(extra + strip.length);
  const view = new DataView(buffer);
  view.setUint16(0, 0x4949);
  view.setUint16(2, 42, true);
  view.setUint32(4, 8, true);
  view.setUint16(8, all.length, true);
  all.forEach(([tag, type, values], i) => {
    const at = 10 + 12 * i;
    view.setUint16(at, tag, true);
    view.setUint16(at + 2, type, true);
    view.setUint32(at + 4, values.length, true);
    if (places[i] !== null) view.setUint32(at + 8, places[i], true);
    (tag === 273 ? [extra] : values).forEach((value, k) => {
      const to = (places[i] ?? at + 8) + k * sizes[type];
      if (type === 3) view.setUint16(to, value, true);
      else if (type === 4) view.setUint32(to, value, true);
      else view.setFloat64(to, value, true);
    });
  });
  new Uint8Array(buffer).set(strip, extra);
  return buffer;
}

const rgb = (compression, more = []) => [[256, 3, [2]], [257, 3, [1]], [258, 3, [8, 8, 8]],
  [259, 3, [compression]], [262, 3, [2]], [277, 3, [3]], [278, 3, [1]],
  [33550, 12, [10, 20, 0]], [33922, 12, [0, 0, 0, -10, 50, 0]], ...more];
const pixels = Uint8Array.of(255, 0, 0, 0, 0, 255);

test('colours and corners are those of the file', async () => {
  const image = await readGeoTiff(tiff(rgb(1), pixels), frame);
  assert.deepEqual([image.width, image.height], [2, 1]);
  assert.deepEqual([...image.rgba], [255, 0, 0, 255, 0, 0, 255, 255]);
  assert.deepEqual(image.box, {left: -10, top: 50, right: 10, bottom: 30});
  const packed = await readGeoTiff(tiff(rgb(8), deflateSync(pixels)), frame);
  assert.deepEqual(packed.rgba, image.rgba);
  // Clear, six literals, end: nine bits each.
  const codes = [256, 255, 0, 0, 0, 0, 255, 257];
  const bits = codes.map((code) => code.toString(2).padStart(9, '0')).join('');
  const lzw = Uint8Array.from(bits.match(/.{1,8}/g), (byte) => parseInt(byte.padEnd(8, '0'), 2));
  assert.deepEqual((await readGeoTiff(tiff(rgb(5), lzw), frame)).rgba, image.rgba);
});

test('degrees and Web Mercator lie where they are', async () => {
  const geographic = [34735, 3, [1, 1, 0, 1, 1024, 0, 1, 2]];
  const tags = rgb(1).filter(([tag]) => tag < 30000);
  const degrees = await readGeoTiff(tiff([...tags, [33550, 12, [0.001, 0.001, 0]],
    [33922, 12, [0, 0, 0, -70, 43, 0]], geographic], pixels), frame);
  assert.ok(Math.abs(degrees.box.left) < 0.01 && Math.abs(degrees.box.top) < 0.01);
  assert.ok(Math.abs(degrees.box.right - 163) < 1);
  const mercator = [34735, 3, [1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 3857]];
  const web = await readGeoTiff(tiff([...tags, [33550, 12, [100, 100, 0]],
    [33922, 12, [0, 0, 0, -70 * Math.PI / 180 * 6378137, 5311971.846945471, 0]], mercator], pixels),
    frame);
  assert.ok(Math.abs(web.box.left) < 0.5 && Math.abs(web.box.top) < 0.5, JSON.stringify(web.box));
  assert.ok(Math.abs(web.box.right - 200 * Math.cos(43 * Math.PI / 180)) < 2);
});

test('what cannot be read is an error with its reason, never a freeze', async () => {
  const fails = (buffer, reason) => assert.rejects(readGeoTiff(buffer, frame), reason);
  await fails(new ArrayBuffer(0), /cut/);
  await fails(new TextEncoder().encode('<svg onload=alert(1)>').buffer, /no TIFF/);
  await fails(tiff(rgb(1), pixels).slice(0, 40), /cut|size/);
  await fails(tiff(rgb(7), pixels), /compression 7/);
  await fails(tiff(rgb(1).map((tag) => (tag[0] === 256 ? [256, 4, [4e9]] : tag)), pixels), /size/);
  await fails(tiff(rgb(1).map((tag) => (tag[0] === 258 ? [258, 3, [16, 16, 16]] : tag)), pixels), /8 bits/);
  await fails(tiff([...rgb(1), [34735, 3, [1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 2154]]], pixels),
    /projection EPSG:2154 is not read: .*gdalwarp/);
  await fails(tiff(rgb(1), pixels).slice(0, -1), /cut/);
  await fails(tiff(rgb(8), deflateSync(pixels).subarray(0, 6)), /damaged|cut/);
  assert.deepEqual([...unpackLzw(Uint8Array.of(255, 255, 255, 255), 4)], [0, 0, 0, 0]);
  for (let seed = 1; seed < 300; ++seed) {
    const bytes = new Uint8Array(tiff(rgb(5), pixels));
    for (let i = 0; i < 5; ++i) bytes[(seed * 7919 * (i + 1)) % bytes.length] ^= (seed * 31 + i) & 255;
    await readGeoTiff(bytes.buffer, frame).catch((error) => assert.ok(error instanceof Error));
  }
});
