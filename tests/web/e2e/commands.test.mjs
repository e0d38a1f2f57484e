// Commands from the page: what becomes of them, and that no other client can give any.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let viewer;
let page;

before(async () => {
  stage.run('missions/berta.toml', '--warp', '10');
  viewer = await stage.view('--allow-commands');
  page = await stage.page(viewer.url);
  await until('alpha under way', async () => (await vehicle('alpha'))?.helm?.state === 'DRIVE');
});
after(() => stage.end());

const vehicle = (name) => page.evaluate((wanted) =>
  globalThis.shoalViewer.world?.at(performance.now()).vehicles.find((each) => each.name === wanted),
name);
const isListed = (text) => until(`"${text}" in the list of commands`, async () =>
  (await page.textContent('#commands')).includes(text));

test('a command turns a vehicle round', async () => {
  await page.click('[data-tab=commands]');
  await page.selectOption('#command-target', 'alpha');
  await page.click('[data-command=return]');
  await isListed('return to alpha');
  await until('the command was taken', async () =>
    /return to alpha[\s\S]*taken/.test(await page.textContent('#commands')));
  // Home is (150, 0): its course over ground comes to point there.
  await until('alpha on its way home', async () => {
    const alpha = await vehicle('alpha');
    if (alpha.helm.kind !== 'return') return false;
    const bearing = (Math.atan2(150 - alpha.x, -alpha.y) * 180) / Math.PI;
    const off = Math.abs(((alpha.heading - bearing + 540) % 360) - 180);
    return off < 20 || Math.hypot(150 - alpha.x, alpha.y) < 15;
  });
});

test('a rule changes, and the map knows', async () => {
  await page.fill('#rule-comms_range', '120');
  await page.click('[data-rule=comms_range]');
  await until('the new range', () => page.evaluate(
    () => globalThis.shoalViewer.source.frame.rules?.comms_range_m === 120));
});

test('the clock pauses, goes on and changes its pace', async () => {
  await page.click('[data-clock=pause]');
  await until('the clock shows paused', async () => /paused/i.test(await page.textContent('#clock')));
  await page.click('[data-clock=resume]');
  await until('the clock runs', async () => !/paused/i.test(await page.textContent('#clock')));
});

test('all vehicles stop at once', async () => {
  await page.click('[data-command=all_stop_all]');
  await until('both have stopped', async () =>
    (await vehicle('alpha')).helm.all_stop !== 'clear'
      && (await vehicle('bravo')).helm.all_stop !== 'clear');
});

test('without the token nothing can be commanded', async () => {
  const url = new URL(viewer.url);
  const post = (headers, body = { target: 'all', words: ['deploy'] }) =>
    fetch(new URL('/api/command', url), {
      method: 'POST', headers: { 'Content-Type': 'application/json', ...headers },
      body: JSON.stringify(body),
    });
  const token = url.searchParams.get('token');
  assert.equal((await post({})).status, 403);
  assert.equal((await post({ 'X-Shoal-Token': 'f'.repeat(32) })).status, 403);
  assert.equal((await post({ 'X-Shoal-Token': token }, { target: 'zulu', words: ['deploy'] })).status, 400);
  const stopped = await vehicle('alpha');
  assert.notEqual(stopped.helm.all_stop, 'clear');
  const reader = await stage.page(url.origin);
  await until('the page of a reader', () => reader.evaluate(
    () => globalThis.shoalViewer?.source?.frame));
  assert.equal(await reader.locator('[data-command=return]').count(), 0);
});

test('a page of another site cannot command', async () => {
  const url = new URL(viewer.url);
  const evil = await stage.page('about:blank');
  const outcome = await evil.evaluate(async (target) => {
    try {
      await fetch(target, { method: 'POST', mode: 'no-cors', body: '{"target":"all","words":["deploy"]}' });
      return 'sent';
    } catch { return 'failed'; }
  }, `${url.origin}/api/command?token=${url.searchParams.get('token')}`);
  assert.ok(['sent', 'failed'].includes(outcome)); // Sent or not, it has no effect:
  await page.waitForTimeout(1000);
  assert.notEqual((await vehicle('bravo')).helm.all_stop, 'clear');
});
