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
  assert.ok(await height() > 420, `${await height()} of 720 px`);
  await page.click('[data-vehicle=boat_42]');
  await until('room for the vehicle', async () => await height() < 300);
  await page.keyboard.press('Escape');
  await until('the whole panel again', async () => await height() > 420);
});

test('vehicles that all have the default colour have colours that differ', async () => {
  const colors = await page.evaluate(() => new Set([...document.querySelectorAll('#vehicles .dot')]
    .map((dot) => dot.style.background)).size);
  assert.ok(colors > 90, `${colors} colours for 100 vehicles`);
});

test('a vehicle is found by its name, and the list is sorted by a column', async () => {
  const rows = () => page.locator('#vehicles tbody [data-vehicle]').evaluateAll((found) =>
    found.map((button) => button.dataset.vehicle));
  await page.fill('#vehicle-search', 'boat_4');
  await until('those that have it', async () => (await rows()).length === 10);
  await page.fill('#vehicle-search', '');
  await page.click('[data-sort=name]');
  await page.click('[data-sort=name]');
  await until('the last name first', async () => (await rows())[0] === 'boat_100');
  assert.equal(await page.getAttribute('#vehicles th:first-child', 'aria-sort'), 'descending');
  await page.click('[data-sort=name]');
  await until('the order of the mission', async () => (await rows())[0] !== 'boat_100');
});

test('the matrix of a hundred is a heat map with fixed names, read with pointer and keys', async () => {
  await page.click('[data-tab=comms]');
  await page.evaluate(() => globalThis.shoalViewer.source.seek(4));
  await until('the heat map', () => page.locator('#heat').isVisible());
  await until('coloured cells', () => page.locator('#heat').evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return data.filter((value, i) => i % 4 === 3 && value > 0).length > 9000;
  }));
  const size = () => page.locator('#heat').evaluate((canvas) => canvas.width);
  const narrow = await size();
  await shot('many_links_narrow');
  await page.setViewportSize({ width: 1900, height: 900 });
  await page.keyboard.press('w');
  await until('larger cells', async () => await size() > narrow);
  await shot('many_links');
  await page.locator('#heat').hover({ position: { x: 30, y: 400 } });
  assert.match(await page.textContent('#heat-read'), /^boat_\d+ to boat_\d+: /);
  const earlier = await page.textContent('#heat-read');
  await page.locator('#heat').focus();
  await page.keyboard.press('ArrowDown');
  assert.notEqual(await page.textContent('#heat-read'), earlier);
  await page.keyboard.press('Enter');
  await until('the link', () => page.locator('#link').isVisible());
  const top = () => page.locator('.heat-top').evaluate((names) => names.getBoundingClientRect().top);
  const first = await top();
  await page.locator('.matrix-scroll').evaluate((scroll) => scroll.scrollTo(0, 300));
  assert.ok(Math.abs(await top() - first) < 2 || await top() > 0, 'the names stay');
  await page.keyboard.press('Escape');
});

test('a thousand vehicles are drawn', async () => {
  const fps = await page.evaluate(async () => {
    const page_ = globalThis.shoalViewer;
    const one = page_.frame.vehicles[0];
    const vehicles = Array.from({ length: 1000 }, (_, i) => ({ ...one, name: `many_${i}`,
      nav: { ...one.nav, x: (i % 40) * 30, y: Math.floor(i / 40) * 30 } }));
    page_.tabs.show('vehicle');
    page_.source.stop();
    let frames = 0;
    const start = performance.now();
    await new Promise((done) => {
      const look = () => {
        page_.source.listener.onFrame({ ...page_.frame, t: page_.frame.t + frames / 100, vehicles });
        frames += 1;
        if (performance.now() - start < 4000) requestAnimationFrame(look);
        else done();
      };
      requestAnimationFrame(look);
    });
    return frames / 4;
  });
  await shot('thousand_vehicles');
  console.log(`# ${fps.toFixed(1)} frames per second`);
  assert.ok(await page.locator('#vehicles tbody tr').count() > 100);
  // Other work of the machine takes its share: 10 is what it is made for.
  assert.ok(fps > 2, `${fps} frames per second`);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
