// Raster tiles under the mission: named in its file, dropped onto the page, and of a server that
// --allow-tiles names; and never from anywhere else.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
after(() => stage.end());

// A PNG of 2 x 2 pixels, all red.
const red = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEElEQVR4nGP4z8AARAwQCgAf7gP9i18U'
  + '1AAAAABJRU5ErkJggg==', 'base64');
const kOrigin = { lat: 43, lon: -70 };

/** Column and row of the tile around the mission's origin. */
function tileAt(zoom) {
  const count = 2 ** zoom;
  const sine = Math.sin(kOrigin.lat * Math.PI / 180);
  return { x: Math.floor((kOrigin.lon + 180) / 360 * count),
    y: Math.floor((0.5 - Math.log((1 + sine) / (1 - sine)) / (4 * Math.PI)) * count) };
}

const folder = join(stage.folder, 'mission');
mkdirSync(folder, { recursive: true });

function mission(name, backgrounds) {
  const path = join(folder, name);
  writeFileSync(path, `[mission]
duration_s = 5
origin = {lat_deg = ${kOrigin.lat}, lon_deg = ${kOrigin.lon}}
backgrounds = ${JSON.stringify(backgrounds)}

[[vehicle]]
name = "alpha"

[[vehicle.task]]
kind = "waypoints"
points = [[60, -50]]
`);
  return path;
}

/** An MBTiles file with nine red tiles around the origin. */
function mbtiles(name, zoom = 15) {
  const path = join(folder, name);
  const { x, y } = tileAt(zoom);
  const rows = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) =>
    `(${zoom}, ${x + dx}, ${2 ** zoom - 1 - (y + dy)}, x'${red.toString('hex')}')`));
  const made = spawnSync('python3', ['-c',
    'import sqlite3, sys\nd = sqlite3.connect(sys.argv[1])\nd.executescript(sys.argv[2])\nd.close()',
    path, `CREATE TABLE metadata (name TEXT, value TEXT);
      CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB);
      INSERT INTO tiles VALUES ${rows.join(', ')};`], { encoding: 'utf8' });
  assert.equal(made.status, 0, made.stderr);
  return path;
}

async function open(file, ...args) {
  const viewer = await stage.view('--http', '0', '--plan', file, ...args);
  const page = await stage.page(viewer.url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  return page;
}
const isRed = (page, x = 12, y = -33) => page.evaluate(([px, py]) => {
  const canvas = document.getElementById('map');
  const { cx, cy, metresPerPixel } = globalThis.shoalViewer.map.view;
  const [r, g] = canvas.getContext('2d').getImageData(
    Math.round((px - cx) / metresPerPixel + canvas.clientWidth / 2),
    Math.round(canvas.clientHeight / 2 - (py - cy) / metresPerPixel), 1, 1).data;
  return r > 120 && g < 120;
}, [x, y]);

test('tiles of a database and of a folder that the mission names lie under it', async () => {
  mbtiles('bay.mbtiles');
  const page = await open(mission('database.toml', ['bay.mbtiles']));
  await until('the tiles', () => isRed(page));
  await page.click('#layers summary');
  await page.click('[data-layer=background]');
  await until('the water', async () => !await isRed(page));
  const { x, y } = tileAt(14);
  for (const dx of [-1, 0, 1]) {
    mkdirSync(join(folder, `map/14/${x + dx}`), { recursive: true });
    for (const dy of [-1, 0, 1]) writeFileSync(join(folder, `map/14/${x + dx}/${y + dy}.png`), red);
  }
  const other = await open(mission('folder.toml', ['map/']));
  await until('the tiles', () => isRed(other));
});

test('a database that is dropped is read in the page', async () => {
  const page = await open(mission('plain.toml', []));
  assert.equal(await isRed(page), false);
  await page.click('#layers summary');
  await page.setInputFiles('#background-file', mbtiles('dropped.mbtiles', 14));
  await until('the tiles', () => isRed(page));
  await page.click('#background-remove');
  await until('the water', async () => !await isRed(page));
  await page.setInputFiles('#background-folder', join(folder, 'map'));
  await until('the tiles of a folder', () => isRed(page));
});

test('hostile and cut files are named with the reason, and harm nothing', async () => {
  const whole = readFileSync(join(folder, 'bay.mbtiles'));
  writeFileSync(join(folder, 'cut.mbtiles'), whole.subarray(0, 5000));
  writeFileSync(join(folder, 'text.mbtiles'), '<script>alert(1)</script>'.repeat(100));
  const page = await open(mission('bad.toml', ['cut.mbtiles', 'text.mbtiles', 'gone.mbtiles', 'none/']));
  await until('the notes', async () => /gone\.mbtiles/.test(await page.textContent('#notes')));
  const notes = await page.textContent('#notes');
  for (const name of ['cut.mbtiles', 'text.mbtiles', 'gone.mbtiles', 'none']) assert.match(notes, new RegExp(name));
  for (const query of ['number=0&z=15&x=0&y=99999999', 'number=0&z=99&x=0&y=0', 'number=9&z=1&x=0&y=0',
    'number=0&z=1&x=0&y=..%2F..%2Fetc%2Fpasswd']) {
    const answer = await page.request.get(new URL(`/api/tile?${query}`, page.url()).href);
    assert.ok([400, 404].includes(answer.status()), query);
  }
  await page.click('#layers summary');
  await page.setInputFiles('#background-file', [join(folder, 'cut.mbtiles'), join(folder, 'text.mbtiles')]);
  await until('the notes', async () => /damaged|cut/.test(await page.textContent('#notes')));
  writeFileSync(join(folder, 'cut.png'), red.subarray(0, 60));
  await page.setInputFiles('#background-file', join(folder, 'cut.png'));
  await until('the note', async () => /cut\.png: it is cut: its end is missing/.test(await page.textContent('#notes')));
  stage.errors = stage.errors.filter((text) => !/404|400/.test(text));
});

test('a chart that lies far from the mission is named', async () => {
  const page = await open(mission('far.toml', []));
  writeFileSync(join(folder, 'far.png'), red);
  writeFileSync(join(folder, 'far.pgw'), '0.001\n0\n0\n-0.001\n-65\n43\n');
  await page.click('#layers summary');
  await page.setInputFiles('#background-file', [join(folder, 'far.png'), join(folder, 'far.pgw')]);
  await until('the note', async () =>
    /far\.png: it lies 40\d km east of the mission/.test(await page.textContent('#notes')));
});

test('tiles from outside come from the server that --allow-tiles names alone', async () => {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    response.writeHead(200, { 'Content-Type': 'image/png', 'Access-Control-Allow-Origin': '*' });
    response.end(red);
  });
  await new Promise((done) => { server.listen(0, '127.0.0.1', done); });
  const { port } = server.address();
  const file = mission('outside.toml', []);
  const page = await open(file, '--allow-tiles', `http://127.0.0.1:${port}/{z}/{x}/{y}.png`);
  await until('the tiles', () => isRed(page));
  assert.ok(asked.length > 0 && asked.every((url) => /^\/\d+\/\d+\/\d+\.png$/.test(url)), asked[0]);
  const policy = (await page.request.get(new URL('/', page.url()).href)).headers()['content-security-policy'];
  assert.match(policy, new RegExp(`connect-src 'self' http://127\\.0\\.0\\.1:${port}$`));
  assert.doesNotMatch(policy, /unsafe/);
  const number = asked.length;
  assert.deepEqual([...new Set(stage.outside.map((url) => new URL(url).host))], [`127.0.0.1:${port}`]);
  stage.outside = [];
  const without = await open(file);
  await without.waitForTimeout(1000);
  assert.equal(asked.length, number, 'without the option nothing is asked');
  assert.equal(await isRed(without), false);
  server.close();
});

test('nothing went wrong, and no other host was asked', () => {
  assert.deepEqual(stage.errors, []);
  assert.deepEqual(stage.outside, []);
});
