// What a user puts under the mission: coast lines and a chart; and that files do nothing else.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

// A PNG of 2 x 2 pixels, all red.
const red = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEElEQVR4nGP4z8AARAwQCgAf7gP9i18U'
  + '1AAAAABJRU5ErkJggg==', 'base64');

before(async () => {
  const log = join(stage.folder, 'alpha.lcm');
  await stage.start('shoal', 'sim', 'missions/alpha.toml', '--quiet', '--log', log).over;
  const viewer = await stage.view('--http', '0', '--log', log, '--mission', 'missions/alpha.toml');
  page = await stage.page(viewer.url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

const pixel = (x, y) => page.evaluate(([px, py]) => {
  const canvas = document.getElementById('map');
  const { cx, cy, metresPerPixel } = globalThis.shoalViewer.map.view;
  return [...canvas.getContext('2d').getImageData(
    Math.round((px - cx) / metresPerPixel + canvas.clientWidth / 2),
    Math.round(canvas.clientHeight / 2 - (py - cy) / metresPerPixel), 1, 1).data.slice(0, 3)];
}, [x, y]);
const put = async (...files) => {
  if (!await page.locator('#background-file').isVisible()) await page.click('#layers summary');
  await page.setInputFiles('#background-file', files.map(([name, content]) => {
    const path = join(stage.folder, name);
    writeFileSync(path, content);
    return path;
  }));
};

test('an area of GeoJSON lies under the mission, and is a layer', async () => {
  const { origin } = await page.evaluate(() => globalThis.shoalViewer.setup);
  const corner = (east, north) => [origin.lon_deg + east / 81000, origin.lat_deg + north / 111000];
  const earlier = await pixel(20, -100);
  await put(['island.geojson', JSON.stringify({ type: 'Feature', properties: {},
    geometry: { type: 'Polygon', coordinates: [[corner(0, -150), corner(45, -150), corner(45, -60),
      corner(0, -60), corner(0, -150)]] } })]);
  await until('the island', async () => (await pixel(20, -100))[0] > earlier[0] + 20);
  await page.click('[data-layer=background]');
  await until('the water', async () => (await pixel(20, -100))[0] <= earlier[0] + 5);
  await page.click('[data-layer=background]');
});

test('a chart lies where its world file puts it', async () => {
  await put(['chart.png', red], ['chart.pgw', '20\n0\n0\n-20\n10\n-80\n']);
  await until('the chart', async () => {
    const [r, g, b] = await pixel(22, -95);
    return r > 120 && g < 120 && b < 120;
  });
  await page.click('#background-remove');
  await until('the water', async () => (await pixel(22, -95))[0] < 60);
});

test('files that are none are named, and nothing of them runs', async () => {
  await put(['<img src=x onerror=alert(1)>.geojson'.replaceAll('/', ''), '<script>alert(1)</script>']);
  await until('the note', async () =>
    /neither GeoJSON nor an image/.test(await page.textContent('#notes')));
  assert.equal(await page.locator('#notes img').count(), 0);
  await put(['x.png', '<svg xmlns="http://www.w3.org/2000/svg" onload="alert(1)"/>']);
  await until('the note', async () =>
    /not an image that the browser can read/.test(await page.textContent('#notes')));
  await page.keyboard.press('Escape');
});

test('a mission names its backgrounds, and a recording holds them', async () => {
  const folder = join(stage.folder, 'named');
  mkdirSync(join(folder, 'charts'), { recursive: true });
  writeFileSync(join(folder, 'charts/bay.png'), red);
  writeFileSync(join(folder, 'charts/bay.pgw'), '20\n0\n0\n-20\n10\n-80\n');
  writeFileSync(join(folder, 'named.toml'), `[mission]
duration_s = 5
origin = {lat_deg = 43, lon_deg = -70}
backgrounds = ["charts/bay.png", "missing.geojson"]

[[vehicle]]
name = "alpha"
start = {x_m = 0, y_m = 0}

[[vehicle.task]]
kind = "waypoints"
points = [[60, -150]]
`);
  const recording = join(stage.folder, 'recorded');
  const run = stage.run(join(folder, 'named.toml'), '--warp', 'max', '--record', recording);
  assert.equal(await run.over, 0, run.output);
  const viewer = await stage.view('--http', '0', '--log', recording);
  const named = await stage.page(viewer.url);
  await until('the chart', () => named.evaluate(() => {
    const canvas = document.getElementById('map');
    const { cx, cy, metresPerPixel } = globalThis.shoalViewer.map.view;
    const [r, g] = canvas.getContext('2d').getImageData(
      Math.round((22 - cx) / metresPerPixel + canvas.clientWidth / 2),
      Math.round(canvas.clientHeight / 2 - (-95 - cy) / metresPerPixel), 1, 1).data;
    return r > 120 && g < 120;
  }));
  assert.match(await named.textContent('#notes'), /there is no missing\.geojson in .*: put it there/);
  stage.errors = stage.errors.filter((text) => !/404/.test(text));
});

test('the security policy allows no inline style or script', async () => {
  const policy = (await page.request.get(new URL('/', page.url()).href)).headers()['content-security-policy'];
  assert.match(policy, /default-src 'self'/);
  assert.doesNotMatch(policy, /unsafe/);
});

test('nothing went wrong, and no other host was asked', () => {
  assert.deepEqual(stage.errors, []);
  assert.deepEqual(stage.outside, []);
});
