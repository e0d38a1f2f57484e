// What remains of `shoal run --view` when the mission has ended: the verdict, and the recording.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
after(() => stage.end());

const state = (page) => page.evaluate(() => globalThis.shoalViewer?.frame?.clock?.state);
const address = (run) => until('the address in the output of shoal run',
  () => /viewer: (http\S+)/.exec(run.output)?.[1]);

/** A mission of 20 s with one expectation that is met and one that is missed. */
function shortMission() {
  const file = join(stage.folder, 'short.toml');
  writeFileSync(file, `[mission]
duration_s = 20

[[vehicle]]
name = "alpha"
start = {x_m = 0, y_m = 0}
helm_options = {deploy_at_start = true}

[[vehicle.task]]
name = "go"
kind = "waypoints"
points = [[200, 0]]

[[expect]]
kind = "arrival"
vehicle = "alpha"
point = [200, 0]
within_m = 5

[[expect]]
kind = "track"
vehicle = "alpha"
max_m = 50
`);
  return file;
}

test('at warp max the mission waits for its page, and the page shows how it ended', async () => {
  const run = stage.start('shoal', 'run', shortMission(), '--warp', 'max', '--view', '--view-http',
    '0');
  const url = await address(run);
  await until('the reason for the wait', () => /--warp max/.test(run.output));
  assert.equal(run.exitCode, null);
  assert.doesNotMatch(run.output, /PASS|FAIL/, 'it has not begun');
  const page = await stage.page(url);
  await until('the verdict', () => page.locator('#verdict summary').isVisible());
  assert.match(await page.textContent('#verdict summary'), /^ended: FAIL: 1 of 2 expectations missed$/);
  const lines = await page.locator('#verdict li').allTextContents();
  assert.equal(lines.length, 2);
  assert.match(lines[0], /^✗alpha within 5 m of \(200, 0\) by 20 s:/, 'the missed one is first');
  assert.match(lines[1], /✓alpha at most 50 m off its track: margin \d+(\.\d+)? m/);
  assert.equal(await page.locator('#banner').isVisible(), false, 'no connection is lost');
  await until('the result', async () => await page.textContent('#clock-state') === '■ ended: FAIL');
  await page.waitForTimeout(3000);
  assert.equal(await page.locator('#banner').isVisible(), false, 'nor later');
  assert.equal(run.exitCode, null, 'it stays until Ctrl-C');
  const place = await page.evaluate(() =>
    globalThis.shoalViewer.world.at(performance.now()).vehicles[0].x);
  assert.ok(place > 10, `what was seen is still there: ${place}`);
  run.kill('SIGINT');
  assert.equal(await run.over, 1, 'the exit code is that of the mission');
  await until('why the viewer is gone', async () =>
    /^The mission has ended/.test(await page.textContent('#banner')));
  assert.equal(await page.getAttribute('#banner', 'data-state'), null, 'not in red');
});

test('with a recording the page goes on with it', async () => {
  const folder = join(stage.folder, 'recording');
  const run = stage.start('shoal', 'run', shortMission(), '--warp', 'max', '--view', '--view-http',
    '0', '--record', folder);
  const page = await stage.page(await address(run));
  await until('the recording', async () => await state(page) === 'recorded');
  await until('the verdict', () => page.locator('#verdict li').first().isVisible());
  assert.match(await page.textContent('#clock'), /00:20\.0 \/ 00:20/, 'it is at its end');
  await page.locator('#timeline-position').fill('5');
  await until('the frame at 5 s', () =>
    page.evaluate(() => Math.abs(globalThis.shoalViewer.source.frame.t - 5) < 0.2));
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#verdict li').first().isVisible(), false, 'Esc closes it');
  run.kill('SIGINT');
  assert.equal(await run.over, 1);
  assert.match(run.output, /verdict\.txt/);
});

test('nothing went wrong, and no other host was asked', () => {
  const own = stage.errors.filter((text) => !/ERR_CONNECTION_REFUSED|net::ERR/.test(text));
  assert.deepEqual(own, []);
  assert.deepEqual(stage.outside, []);
});
