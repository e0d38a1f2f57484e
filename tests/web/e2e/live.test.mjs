// A running mission in the page: what a user sees at the first look.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const run = stage.run('missions/berta.toml', '--warp', '10', '--view');
  const url = await until('the address in the output of shoal run',
    () => /viewer: (http\S+)/.exec(run.output)?.[1]);
  page = await stage.page(url);
});
after(() => stage.end());

const position = (name) => page.evaluate((wanted) => {
  const { world } = globalThis.shoalViewer;
  const found = world?.at(performance.now()).vehicles.find((each) => each.name === wanted);
  return found && { x: found.x, y: found.y };
}, name);

test('the page shows the mission and its vehicles', async () => {
  await until('both vehicles', async () => await position('alpha') && await position('bravo'));
  assert.match(await page.title(), /berta/);
  assert.match(await page.textContent('#clock'), /\d/);
});

test('vehicles move on the map', async () => {
  const start = await until('alpha', () => position('alpha'));
  await until('alpha 20 m from there', async () => {
    const now = await position('alpha');
    return Math.hypot(now.x - start.x, now.y - start.y) > 20;
  });
  const pixels = () => page.locator('#map').screenshot();
  const first = await pixels();
  await until('another picture', async () => !(await pixels()).equals(first));
});

test('a pulse appears', async () => {
  await until('a pulse', () => page.evaluate(() => {
    const { world } = globalThis.shoalViewer;
    return world.pulses(world.at(performance.now()).t).length > 0;
  }));
});

test('a blocked link shows its reason with the numbers', async () => {
  await page.click('[data-tab=comms]');
  await until('a link in the matrix', () => page.locator('[data-cell="alpha>bravo"]').count());
  await until('a fate out of range', async () =>
    /alpha to bravo: out of range, 2\d\d\.\d m of 250\.0 m/.test(await page.textContent('#fates')));
  await page.click('[data-cell="alpha>bravo"]');
  await until('the causes of the link', async () =>
    /out of range/.test(await page.textContent('#link')));
  await until('the same in the matrix', () =>
    page.locator('[data-cell="alpha>bravo"][data-receives=deaf]').count());
  if (process.env.SHOAL_SCREENSHOTS) {
    await page.keyboard.press('4'); // The ranges.
    await page.waitForTimeout(300);
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_comms.png` });
  }
});

test('the status panel has the pages of the processes', async () => {
  await page.click('[data-tab=status]');
  await until('the page of a helm', async () =>
    /helm_alpha/.test(await page.textContent('#status')));
});

test('a key opens the help', async () => {
  await page.keyboard.press('?');
  await page.waitForSelector('#help', { state: 'visible' });
  await page.keyboard.press('Escape');
  await page.waitForSelector('#help', { state: 'hidden' });
});

test('Esc closes the menu of layers, also from one of its boxes', async () => {
  const isOpen = () => page.evaluate(() => document.querySelector('#layers').open);
  for (const focused of ['#layers summary', '[data-layer=grid]']) {
    await page.click('#layers summary');
    await until('the open menu', isOpen);
    await page.focus(focused);
    await page.keyboard.press('Escape');
    await until('the closed menu', async () => !await isOpen());
  }
});

test('the address keeps the view', async () => {
  await page.keyboard.press('+');
  const scale = () => page.evaluate(() => globalThis.shoalViewer.map.view.metresPerPixel);
  const atFirst = await scale();
  await until('the scale in the address', async () => page.url().includes('#'));
  await page.waitForTimeout(500);
  await page.reload();
  await until('the same scale', async () => Math.abs(await scale() / atFirst - 1) < 0.02);
});

test('a key saves the map as a picture', async () => {
  const saved = page.waitForEvent('download');
  await page.keyboard.press('p');
  assert.match((await saved).suggestedFilename(), /berta.*\.png$/);
});

test('commands are refused by default, and none can be given', async () => {
  assert.equal(await page.locator('[data-command=return]').count(), 0);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
