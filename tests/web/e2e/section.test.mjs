// The depth of an underwater vehicle along its track.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const log = join(stage.folder, 'sonar.lcm');
  await stage.start('shoal', 'sim', 'missions/sonar.toml', '--log', log, '--quiet').over;
  const viewer = await stage.view('--log', log, '--mission', 'missions/sonar.toml', '--http', '0');
  page = await stage.page(viewer.url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await page.locator('[data-vehicle]').first().click();
});
after(() => stage.end());

const chart = () => page.locator('figure[aria-label="Depth along the track"]');

test('the section shows depth and floor along the way', async () => {
  await page.evaluate(() => globalThis.shoalViewer.source.seek(300));
  await page.selectOption('#window', { index: 2 });
  await until('its values', async () =>
    /floor \d+\.\d m/.test(await chart().textContent()) && await chart().locator('canvas').count() === 1);
  await chart().scrollIntoViewIfNeeded();
  const box = await chart().locator('.u-over').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await until('the way under the pointer', async () => /at \d+ m/.test(await chart().textContent()));
  if (process.env.SHOAL_SCREENSHOTS) {
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_section.png` });
  }
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
