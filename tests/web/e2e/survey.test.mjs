// A survey in the page: the area, the lanes, and what was covered.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const folder = join(stage.folder, 'recording');
  const run = stage.run('missions/survey.toml', '--warp', 'max', '--record', folder,
    '--set', 'mission.duration_s=500');
  assert.equal(await run.over, 1, run.output); // Too short to cover everything.
  const view = stage.start('shoal', 'view', folder);
  const url = await until('the address', () => /viewer: (http\S+)/.exec(view.output)?.[1]);
  page = await stage.page(url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

/** Shows the mission as it was at `t`, with these layers only. */
const show = async (t, shown) => {
  await page.evaluate((wanted) => {
    const { map } = globalThis.shoalViewer;
    const layers = Object.fromEntries(
      Object.keys(map.view.layers).map((name) => [name, wanted.includes(name)]));
    map.view = { cx: 150, cy: 110, metresPerPixel: 0.6, layers };
  }, shown);
  await page.locator('#timeline input[type=range]').evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  }, t);
  await until(`the frame at ${t} s`, () => page.evaluate((wanted) =>
    Math.abs(globalThis.shoalViewer.source.frame.t - wanted) < 0.2, t));
  await page.waitForTimeout(1500);
};

/** Returns the colour of the map at a place. */
const colorAt = (x, y) => page.evaluate(([east, north]) => {
  const { map } = globalThis.shoalViewer;
  const canvas = document.querySelector('#map');
  const { cx, cy, metresPerPixel } = map.view;
  const ratio = canvas.width / canvas.clientWidth;
  const sx = (east - cx) / metresPerPixel + canvas.clientWidth / 2;
  const sy = canvas.clientHeight / 2 - (north - cy) / metresPerPixel;
  return [...canvas.getContext('2d').getImageData(sx * ratio, sy * ratio, 1, 1).data].join();
}, [x, y]);

test('what was covered grows along the trails, and is a layer', async () => {
  const early = [150, 112]; // In alpha's first lane; it is there 90 s after it was deployed.
  const late = [150, 128]; // In its second one, which it passes there after 280 s.
  await show(200, ['area']);
  const [covered, open] = [await colorAt(...early), await colorAt(...late)];
  assert.notEqual(covered, open);
  await show(450, ['area']);
  assert.equal(await colorAt(...late), covered);
  await show(450, []);
  assert.equal(await colorAt(...late), await colorAt(...early));
  assert.equal(await colorAt(...late), open);
});

test('areas and lanes come with the setup', async () => {
  const { coverage, tasks } = await page.evaluate(() => {
    const { setup } = globalThis.shoalViewer;
    return { coverage: setup.coverage, tasks: setup.vehicles[0].tasks };
  });
  assert.deepEqual(coverage[0].vehicles, ['alpha', 'bravo']);
  assert.equal(coverage[0].width_m, 20);
  assert.equal(tasks[0].area.length, 6);
  assert.equal(tasks[0].marked, false);
  assert.ok(tasks[0].points.length > 14);
  if (process.env.SHOAL_SCREENSHOTS) {
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await show(450, ['area', 'tasks', 'trails', 'names', 'grid']);
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_survey.png` });
  }
});
