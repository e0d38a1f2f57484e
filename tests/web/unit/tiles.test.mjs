import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {farWords} from '../../../web/map/background.js';
import {imageSize} from '../../../web/map/image_file.js';
import {readMbtiles, tilesOfFiles} from '../../../web/map/mbtiles.js';
import {SqlitePages} from '../../../web/map/sqlite_pages.js';

const folder = mkdtempSync(join(tmpdir(), 'shoal-tiles-'));
after(() => rmSync(folder, {recursive: true}));

/** A database by the SQLite of Python: what other programs write. */
function database(name, sql) {
  const path = join(folder, name);
  const made = spawnSync('python3', ['-c',
    'import sqlite3, sys\nd = sqlite3.connect(sys.argv[1])\nd.executescript(sys.argv[2])\nd.close()',
    path, sql], {encoding: 'utf8'});
  assert.equal(made.status, 0, made.stderr);
  const bytes = readFileSync(path);
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
}

const kTables = `CREATE TABLE metadata (name TEXT, value TEXT);
  CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB);`;
// Tiles of many sizes: within a page, and beyond it; enough for pages of pages.
const many = (count) => `WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n
  WHERE i + 1 < ${count}) INSERT INTO tiles SELECT 12, i, 1, randomblob(1 + (i * 37) % 20000) FROM n;`;

test('an MBTiles file of another program is read, tile by tile', async () => {
  const held = readMbtiles(database('many.mbtiles', `${kTables}${many(700)}
    INSERT INTO tiles VALUES (3, 1, 0, x'4142'), (40, 0, 0, x'00'), (3, 9, 0, x'00');`));
  assert.equal(held.count, 701);
  assert.deepEqual(held.zooms, {least: 3, most: 12});
  assert.deepEqual(held.extent, {z: 3, left: 1, right: 2, top: 7, bottom: 8});
  assert.equal(await (await held.tile(3, 1, 7)).text(), 'AB');
  for (const i of [0, 1, 300, 540, 699]) {
    assert.equal((await held.tile(12, i, 4094)).size, 1 + (i * 37) % 20000, `tile ${i}`);
  }
  assert.equal(await held.tile(12, 700, 4094), null);
});

test('equal tiles that are there once are found', async () => {
  const held = readMbtiles(database('shared.mbtiles', `
    CREATE TABLE map (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_id TEXT);
    CREATE TABLE images (tile_data BLOB, tile_id TEXT);
    INSERT INTO images VALUES (x'43', 'sea'); INSERT INTO map VALUES (1, 0, 0, 'sea'), (1, 1, 0, 'sea');
    CREATE VIEW tiles AS SELECT zoom_level, tile_column, tile_row, tile_data FROM map
      JOIN images USING (tile_id);`));
  assert.equal(held.count, 2);
  assert.equal(await (await held.tile(1, 1, 1)).text(), 'C');
});

test('what is no MBTiles, cut or hostile is an error with its reason', () => {
  const fails = (buffer, reason) => assert.throws(() => readMbtiles(buffer), reason);
  fails(new ArrayBuffer(0), /not an SQLite database/);
  fails(new ArrayBuffer(4096), /not an SQLite database/);
  fails(database('other.mbtiles', 'CREATE TABLE x (y);'), /neither a table tiles/);
  fails(database('empty.mbtiles', kTables), /no tiles/);
  fails(database('vector.mbtiles', `${kTables} INSERT INTO metadata VALUES ('format', 'pbf');`),
    /vector tiles/);
  fails(database('columns.mbtiles', 'CREATE TABLE tiles (a, b); INSERT INTO tiles VALUES (1, 2);'),
    /zoom_level/);
  const whole = database('cut.mbtiles', `${kTables}${many(60)}`);
  for (let size = 600; size < whole.byteLength; size += 9000) {
    try {
      readMbtiles(whole.slice(0, size));
    } catch (error) {
      assert.match(error.message, /damaged|cut|no tiles|neither/);
    }
  }
  // A page whose child is itself, and bytes at random: an end in any case.
  for (let seed = 1; seed < 400; ++seed) {
    const bytes = new Uint8Array(whole.slice(0));
    for (let i = 0; i < 8; ++i) bytes[100 + (seed * 7919 * (i + 1)) % 12000] = (seed * 31 + i) & 255;
    try {
      const file = new SqlitePages(bytes.buffer);
      let rows = 0;
      for (const record of file.rows(file.find('tiles')?.root ?? 1)) {
        record.value(3);
        if (++rows > 100_000) assert.fail('it does not end');
      }
    } catch (error) {
      assert.ok(!(error instanceof assert.AssertionError), error.message);
      assert.equal(error.constructor.name === 'TypeError', false, error.stack);
    }
  }
});

test('the files of a folder are tiles by their names', async () => {
  const file = (path, size = 10) => ({path, size, name: path.split('/').pop()});
  const held = tilesOfFiles([file('charts/4/5/6.png'), file('charts/4/5/7.JPG'), file('charts/readme.md'),
    file('charts/4/5/16.png'), file('charts/99/5/6.png'), file('charts/4/5/8.png', 1e9),
    file('charts/4/../5/6.png')]);
  assert.equal(held.count, 2);
  assert.equal((await held.tile(4, 5, 7)).path, 'charts/4/5/7.JPG');
  assert.equal(tilesOfFiles([file('a/b.png')]), null);
});

test('a cut image, and one of too many pixels, is known by its bytes', () => {
  const png = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEElEQVR4nGP4z8AARAwQCgAf7gP9i18U'
    + '1AAAAABJRU5ErkJggg==', 'base64');
  const buffer = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  assert.deepEqual(imageSize(buffer(png)), {width: 2, height: 2});
  for (let size = 8; size < png.length; ++size) {
    assert.throws(() => imageSize(buffer(png.subarray(0, size))), /it is cut/, String(size));
  }
  const huge = Buffer.from(png);
  huge.writeUInt32BE(100_000, 16);
  huge.writeUInt32BE(100_000, 20);
  assert.throws(() => imageSize(buffer(huge)), /100000 x 100000 pixels are too many/);
  const jpeg = Uint8Array.of(0xff, 0xd8, 0xff, 0xc0, 0, 11, 8, 0, 3, 0, 5, 1, 1, 0x11, 0, 0xff, 0xda, 0,
    2, 1, 2, 0xff, 0xd9);
  assert.deepEqual(imageSize(jpeg.buffer), {width: 5, height: 3});
  assert.throws(() => imageSize(jpeg.slice(0, 20).buffer), /it is cut/);
  assert.throws(() => imageSize(new TextEncoder().encode('<svg onload="x"/>').buffer), /not an image/);
});

test('what lies far from the mission is named with distance and direction', () => {
  const mission = {left: -100, right: 100, bottom: -100, top: 100};
  const at = (x, y) => ({left: x - 50, right: x + 50, bottom: y - 50, top: y + 50});
  assert.equal(farWords(at(0, 0), mission), '');
  assert.equal(farWords(at(15_000, 0), mission), '', 'a chart may begin beside it');
  assert.equal(farWords(at(40_150, 0), mission), '40 km east of the mission');
  assert.equal(farWords(at(-300_000, 300_000), mission), '424 km north-west of the mission');
  assert.equal(farWords(at(0, -99_000), {left: -20_000, right: 20_000, bottom: 0, top: 1}), '');
  assert.equal(farWords(null, mission), '');
});
