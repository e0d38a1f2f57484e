// A recorded mission with several media: its link matrix shows each apart.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();

/** A page with the Comms panel of the end of a mission that is simulated now. */
async function commsPage(mission, name) {
  const log = join(stage.folder, name);
  const sim = stage.start('shoal', 'sim', mission, '--log', log);
  assert.equal(await sim.over, 0, sim.output);
  const view = stage.start('shoal', 'view', log);
  const url = await until('the address', () => /viewer: (http\S+)/.exec(view.output)?.[1]);
  const page = await stage.page(url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await page.locator('#timeline input[type=range]').evaluate((slider) => {
    slider.value = slider.max;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await page.click('[data-tab=comms]');
  await until('the matrix', async () => await page.locator('#matrix [data-cell]').count() > 1);
  return page;
}

const cell = (page, key) => page.getAttribute(`[data-cell="${key}"]`, 'aria-label');
let page;

before(async () => { page = await commsPage('missions/search_gateway.toml', 'gateway.lcm'); });
after(() => stage.end());

test('the matrix shows all media, or one', async () => {
  // Without a mission file beside the log they stand in the order in which they were used.
  assert.deepEqual(await page.locator('#matrix-medium option').allTextContents(),
    ['all', 'vhf', 'acoustic']);
  await until('craft to craft', async () => /receives/.test(await cell(page, 'craft_1>craft_2')));

  await page.selectOption('#matrix-medium', 'acoustic');
  await until('nothing from craft to craft by sound', async () =>
    /nothing was sent/.test(await cell(page, 'craft_1>craft_2')));
  assert.doesNotMatch(await cell(page, 'auv_1>buoy'), /nothing was sent/);

  await page.selectOption('#matrix-medium', 'vhf');
  await until('craft to craft by radio', async () =>
    /receives/.test(await cell(page, 'craft_1>craft_2')));
});

test('fates name the medium and the numbers that decided', async () => {
  await page.selectOption('#fates-cause', 'submerged');
  await until('depth and limit', async () =>
    /antenna submerged, depth \d+\.\d\d m of 0\.50 m, over vhf/.test(await page.textContent('#fates')));
});

test('a mission without media has no choice of one', async () => {
  const plain = await commsPage('missions/berta.toml', 'berta.lcm');
  await until('a link', async () => /deliver now/.test(await plain.textContent('#panels, body')));
  assert.equal(await plain.locator('#matrix-medium').isVisible(), false);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
