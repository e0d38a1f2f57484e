// Channels, their messages, and charts of any field, of a recorded and of a running mission.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const log = join(stage.folder, 'berta.lcm');
  await stage.start('shoal', 'sim', 'missions/berta.toml', '--log', log, '--quiet').over;
  const viewer = await stage.view('--log', log, '--mission', 'missions/berta.toml', '--http', '0');
  page = await stage.page(`${viewer.url}#t=200&select=alpha`);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await page.click('[data-tab=data]');
});
after(() => stage.end());

const seek = (t) => page.evaluate((time) => globalThis.shoalViewer.source.seek(time), t);
const shot = async (name) => {
  if (!process.env.SHOAL_SCREENSHOTS) return;
  mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
  await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/${name}.png` });
};

test('all channels are listed with their types and rates', async () => {
  await until('NAV_ALPHA', async () => /NAV_ALPHA nav_t10 Hz/.test(await page.textContent('#channels')));
  assert.match(await page.textContent('#channels'), /HELM_STATE_BRAVO helm_state_t/);
});

test('a channel shows its last message, which goes with the time', async () => {
  await page.click('[data-channel=NAV_ALPHA]');
  const x = async () => Number(/^x_m(-?[\d.]+)/m.exec(
    (await page.locator('#message tr').allTextContents()).join('\n'))?.[1]);
  await until('x of 200 s', async () => Math.abs(await x() - 66) < 3);
  await seek(300);
  await until('x of 300 s', async () => await x() > 200);
  await seek(200);
});

test('a value of the message becomes a chart', async () => {
  await page.getByRole('button', { name: 'Chart of x_m' }).click();
  await until('a drawn chart', () => page.locator('#plots canvas').count());
  await until('its value', async () => /NAV_ALPHA:x_m 66\.\d+ m/.test(await page.textContent('#plots')));
});

test('a field found by search comes into the same chart, from another vehicle', async () => {
  await page.fill('#data-search', 'nav_bravo x_m');
  await page.click('[data-field="NAV_BRAVO:x_m"]');
  await until('both in one chart', async () =>
    await page.locator('.field-chart').count() === 1
      && /NAV_ALPHA:x_m.*NAV_BRAVO:x_m 3\d\d\.\d+ m/.test(await page.textContent('.field-chart')));
  await page.fill('#data-search', 'no such field');
  await until('that there is none', async () =>
    /no field has these words/.test(await page.textContent('#fields')));
  await page.fill('#data-search', '');
});

test('states of the chosen vehicle are spans of time', async () => {
  await page.click('#data-states');
  await page.selectOption('#data-window', '86400');
  await until('its tasks', async () => {
    const text = await page.textContent('#plots .strips >> nth=1');
    return /loiter_west/.test(text) && /cross/.test(text);
  });
  await shot('viewer_data');
});

test('the address keeps the charts', async () => {
  // The states came last.
  await until('all charts in the address', async () =>
    page.url().includes('NAV_BRAVO') && /HELM_STATE/.test(decodeURIComponent(page.url())));
  await page.reload();
  await until('two charts again', async () => await page.locator('.field-chart').count() === 2);
  await until('with values', async () => /NAV_BRAVO:x_m 3\d\d/.test(await page.textContent('#plots')));
});

test('a field is removed, and with its last one the chart', async () => {
  await page.getByRole('button', { name: 'Remove NAV_ALPHA:x_m' }).click();
  await page.getByRole('button', { name: 'Remove NAV_BRAVO:x_m' }).click();
  await until('one chart', async () => await page.locator('.field-chart').count() === 1);
});

test('a field that is not there is named, with one that is', async () => {
  const other = await stage.page(`${page.url().split('#')[0]}#tab=data&t=50&plots=NAV_ALPHA%253Ax_n`);
  await until('the reason', async () =>
    /no field 'x_n' \(did you mean 'x_m'\?\)/.test(await other.textContent('#plots')));
  stage.errors = stage.errors.filter((text) => !/404/.test(text));
});

test('a hostile address draws nothing and runs nothing', async () => {
  const other = await stage.page(`${page.url().split('#')[0]}#tab=data&plots=`
    + encodeURIComponent('A%3A<img src=x onerror=globalThis.evil=1>;%;__proto__%3Ax'));
  await until('that there are no values', async () =>
    /the log has no channel/.test(await other.textContent('#plots')));
  assert.equal(await other.evaluate(() => globalThis.evil), undefined);
  stage.errors = stage.errors.filter((text) => !/404|400/.test(text));
});

test('live, channels come while the panel asks, and series grow', async () => {
  stage.run('missions/berta.toml', '--warp', '10');
  const viewer = await stage.view('--http', '0');
  const live = await stage.page(`${viewer.url}#tab=data&plots=NAV_ALPHA%253Ax_m`);
  await until('a rate', async () => /NAV_ALPHA nav_t\d+(\.\d)? Hz/.test(await live.textContent('#channels')));
  await live.click('[data-channel=NAV_ALPHA]');
  await until('a message', async () => /nav_t, \d+ bytes/.test(await live.textContent('#message')));
  await until('a chart that grows', async () =>
    /NAV_ALPHA:x_m -?\d+\.\d+ m/.test(await live.textContent('#plots')));
  const clock = () => live.evaluate(() => globalThis.shoalViewer.frame.t);
  const at = await clock();
  await until('more time', async () => await clock() > at + 5);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors.filter((text) => !/404/.test(text)), []);
});
