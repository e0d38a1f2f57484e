// A recorded mission of 100 vessels in the page: names, colours, and the space that there is.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const log = join(stage.folder, 'mission.lcm');
  const sim = stage.start('shoal', 'sim', 'tests/bench/fleet50.toml', '--set', 'fleet.1.count=100',
    '--set', 'mission.duration_s=5', '--log', log);
  assert.equal(await sim.over, 0, sim.output);
  const view = stage.start('shoal', 'view', log);
  const url = await until('the address', () => /viewer: (http\S+)/.exec(view.output)?.[1]);
  page = await stage.page(url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await until('the list', async () => await page.locator('#vehicles tbody tr').count() === 100);
});
after(() => stage.end());

const shot = async (name) => {
  if (!process.env.SHOAL_SCREENSHOTS) return;
  mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
  await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/${name}.png` });
};

test('every name can be read', async () => {
  await shot('many_vehicles');
  const cut = await page.evaluate(() => [...document.querySelectorAll('#vehicles tbody th')]
    .filter((head) => [head, ...head.querySelectorAll('*')]
      .some((part) => part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0))
    .map((head) => head.textContent));
  assert.deepEqual(cut, []);
  assert.equal(await page.getAttribute('[data-vehicle=boat_42]', 'title'), 'boat_42');
});

test('the list has the panel to itself until a vehicle is chosen', async () => {
  const height = () => page.locator('.list-scroll').evaluate((list) => list.clientHeight);
  assert.ok(await height() > 450, `${await height()} of 720 px`);
  await page.click('[data-vehicle=boat_42]');
  await until('room for the vehicle', async () => await height() < 300);
  await page.keyboard.press('Escape');
  await until('the whole panel again', async () => await height() > 450);
});

test('vehicles that all have the default colour have colours that differ', async () => {
  const colors = await page.evaluate(() => new Set([...document.querySelectorAll('#vehicles .dot')]
    .map((dot) => dot.style.background)).size);
  assert.ok(colors > 90, `${colors} colours for 100 vehicles`);
});

test('the matrix uses the width of the panel', async () => {
  await page.click('[data-tab=comms]');
  await until('the matrix', async () => await page.locator('#matrix [data-cell]').count() > 9000);
  const cell = () => page.locator('#matrix [data-cell]').first().evaluate((button) => button.clientWidth);
  const narrow = await cell();
  await page.setViewportSize({ width: 3000, height: 720 });
  await page.keyboard.press('w');
  await until('larger cells', async () => await cell() > narrow);
  await shot('many_links');
  const { inner, outer } = await page.locator('.matrix-scroll').evaluate((scroll) => (
    { inner: scroll.firstElementChild.offsetWidth, outer: scroll.clientWidth }));
  assert.ok(inner <= outer && inner > 0.8 * outer, `${inner} of ${outer} px`);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
