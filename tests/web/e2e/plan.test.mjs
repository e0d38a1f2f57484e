// The plan of a mission of behaviors on the map, before it begins and after; one colour per vehicle.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
const pages = {};

async function open(name, file) {
  const log = join(stage.folder, `${name}.lcm`);
  const made = stage.start('shoal', 'sim', file, '--log', log, '--quiet');
  await made.over;
  const viewer = await stage.view('--http', '0', '--log', log, '--mission', file);
  const page = await stage.page(viewer.url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  // Nothing but the plan and what it is drawn on.
  await page.evaluate(() => {
    for (const layer of ['trails', 'reported', 'pulses', 'rings', 'grid', 'names']) {
      globalThis.shoalViewer.setLayer(layer, false);
    }
  });
  return page;
}

before(async () => {
  const file = join(stage.folder, 'behaviors.toml');
  writeFileSync(file, `[mission]
duration_s = 120

[[vehicle]]
name = "alpha"
start = {x_m = 0, y_m = 0}
domain = {speed = [0, 4, 41]}
helm_options = {deploy_at_start = true}
variables = {CIRCLE = "false"}

[[vehicle.behavior]]
name = "fence"
kind = "op_region"
core_poly = [[-100, -300], [400, -300], [400, 200], [-100, 200]]

[[vehicle.behavior]]
name = "out"
kind = "waypoint"
points = [[40, 0], [80, -40]]
speed = 3
condition = ["CIRCLE = false"]
endflag = ["CIRCLE = true"]

[[vehicle.behavior]]
name = "circle"
kind = "loiter"
polygon = [[200, -100], [250, -150], [200, -200], [150, -150]]
speed = 2
condition = ["CIRCLE = true"]
`);
  pages.loiters = await open('loiters', file);
  pages.gateway = await open('gateway', 'missions/search_gateway.toml');
});
after(() => stage.end());

/** The colour of the map where a place of the mission is, [r, g, b], the brightest nearby. */
const colorAt = (page, x, y) => page.evaluate(([px, py]) => {
  const canvas = document.getElementById('map');
  const { cx, cy, metresPerPixel } = globalThis.shoalViewer.map.view;
  const sx = Math.round((px - cx) / metresPerPixel + canvas.clientWidth / 2);
  const sy = Math.round(canvas.clientHeight / 2 - (py - cy) / metresPerPixel);
  const { data } = canvas.getContext('2d').getImageData(sx - 3, sy - 3, 7, 7);
  let best = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    const color = [...data.slice(i, i + 3)];
    if (Math.max(...color) > Math.max(...best)) best = color;
  }
  return best;
}, [x, y]);
const seek = async (page, t) => {
  await page.evaluate((at) => globalThis.shoalViewer.source.seek(at), t);
  await until(`the frame at ${t} s`, () => page.evaluate((at) =>
    Math.abs(globalThis.shoalViewer.source.frame.t - at) < 0.3, t));
  await page.waitForTimeout(600);
};
const plans = (page) => page.evaluate(() => globalThis.shoalViewer.setup.vehicles
  .flatMap((vehicle) => vehicle.behaviors.map((part) => ({ vehicle: vehicle.name, ...part }))));

test('a recording opens with the plan of its behaviors, which brightens once they are active', async () => {
  const page = pages.loiters;
  const loiter = (await plans(page)).find(({ kind }) => kind === 'loiter');
  assert.ok(loiter, 'the loiters are in the setup');
  const [x, y] = loiter.points[0];
  await seek(page, 0);
  const earlier = await colorAt(page, x, y);
  await page.evaluate(() => globalThis.shoalViewer.setLayer('tasks', false));
  await page.waitForTimeout(400);
  const without = await colorAt(page, x, y);
  assert.ok(Math.max(...earlier) > Math.max(...without) + 25, `at 0 s: ${earlier}, ${without}`);
  await page.evaluate(() => globalThis.shoalViewer.setLayer('tasks', true));
  await seek(page, 90);
  const active = await colorAt(page, x, y);
  assert.ok(Math.max(...active) > Math.max(...earlier) + 40, `active: ${active}, earlier: ${earlier}`);
});

test('the table of why it steers so has room at 1280 pixels', async () => {
  const page = pages.loiters;
  await seek(page, 30);
  await page.evaluate(() => globalThis.shoalViewer.select('alpha'));
  await until('the table', () => page.locator('#decision').isVisible());
  const cut = await page.locator('#decision').evaluate((section) => {
    const { right } = document.getElementById('side').getBoundingClientRect();
    return [...section.querySelectorAll('th, td')].filter((cell) =>
      cell.getBoundingClientRect().right > right - 4 || cell.scrollWidth > cell.clientWidth + 1)
      .map((cell) => cell.textContent);
  });
  assert.deepEqual(cut, []);
});

test('the first view shows what is planned, not the shore station nine kilometres away', async () => {
  const scale = await pages.gateway.evaluate(() => globalThis.shoalViewer.map.view.metresPerPixel);
  assert.ok(scale < 4, `${scale} m per pixel`);
  await pages.gateway.keyboard.press('+');
  await pages.gateway.keyboard.press('f');
  assert.equal(await pages.gateway.evaluate(() => globalThis.shoalViewer.map.view.metresPerPixel),
    scale);
});

test('each vehicle has a colour of its own, the same in the list and on the map', async () => {
  const page = pages.gateway;
  await page.bringToFront();
  const dots = await until('the list', () => page.locator('#vehicles .dot').evaluateAll((found) =>
    found.length > 5 && found.map((dot) => getComputedStyle(dot).backgroundColor)));
  assert.equal(new Set(dots).size, dots.length);
  await page.locator('#vehicles button', { hasText: 'craft_4' }).click();
  const title = await page.locator('#vehicle-title .dot').evaluate((dot) => dot.style.background);
  const row = await page.locator('tr', { hasText: 'craft_4' }).locator('.dot')
    .evaluate((dot) => dot.style.background);
  assert.equal(title, row);
  const line = page.locator('#vehicle .chart .swatch').first();
  await until('the chart', () => line.isVisible());
  assert.equal(await line.evaluate((swatch) => swatch.style.borderColor), row);
});

test('a buoy and a station show no missing helm', async () => {
  const { list, map } = await pages.gateway.evaluate(() => ({
    list: document.getElementById('vehicles').textContent,
    map: globalThis.shoalViewer.frame.vehicles.map(({ mode }) => mode) }));
  assert.doesNotMatch(list, /NOHELM/);
  assert.ok(map.every((mode) => !mode.startsWith('NOHELM')));
});

test('of many pulses those of the chosen vehicle stand out, and Layers has the choice', async () => {
  const page = pages.gateway;
  await page.locator('#layers summary').click();
  await page.locator('#pulse-style').selectOption('lines');
  assert.match(await until('the address', async () => {
    const url = page.url();
    return /pulses=lines/.test(url) && url;
  }), /pulses=lines/);
  await page.reload();
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  assert.equal(await page.evaluate(() => globalThis.shoalViewer.map.view.pulseStyle), 'lines');
});

test('nothing went wrong, and no other host was asked', () => {
  assert.deepEqual(stage.errors, []);
  assert.deepEqual(stage.outside, []);
});
