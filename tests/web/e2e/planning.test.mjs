// Planning on the map: before a mission, on a recording, and while it runs; what is written, and what
// never is.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { root, Stage, until } from './support.mjs';

const stage = new Stage();
const bin = join(process.env.SHOAL_BINARY_DIR, 'bin');
const folder = join(stage.folder, 'plans');
const file = join(folder, 'bay.toml');
let page;

before(async () => {
  mkdirSync(folder);
  copyFileSync(join(root, 'missions/alpha.toml'), file);
  const viewer = await stage.view('--http', '0', '--plan', file, '--allow-commands');
  page = await stage.page(viewer.url);
  await until('the vehicle at its start', () => page.evaluate(
    () => globalThis.shoalViewer?.map.shown.vehicles[0]?.x === 0));
});
after(() => stage.end());

/** A place of the mission, in pixels of the page. */
const screen = (on, x, y) => on.evaluate(([px, py]) => {
  const canvas = document.getElementById('map');
  const { cx, cy, metresPerPixel } = globalThis.shoalViewer.map.view;
  const box = canvas.getBoundingClientRect();
  return { x: box.left + (px - cx) / metresPerPixel + canvas.clientWidth / 2,
    y: box.top + canvas.clientHeight / 2 - (py - cy) / metresPerPixel };
}, [x, y]);
const drag = async (on, [fromX, fromY], [toX, toY]) => {
  const from = await screen(on, fromX, fromY);
  const to = await screen(on, toX, toY);
  await on.mouse.move(from.x, from.y);
  await on.mouse.down();
  await on.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 3 });
  await on.mouse.move(to.x, to.y, { steps: 3 });
  await on.mouse.up();
};
const click = async (on, x, y) => {
  const at = await screen(on, x, y);
  await on.mouse.click(at.x, at.y);
};
const plan = (on) => on.evaluate(() => {
  const { plan: now, original } = globalThis.shoalViewer.panels.plan.editor;
  return now && { text: now.text, errors: now.errors, first: original.text, handles: now.handles };
});
const openPlan = async (on) => {
  await on.click('[data-tab=plan]');
  await on.click('#plan-begin');
  await until('the plan', () => plan(on));
};
const handle = async (on, kind) => (await plan(on)).handles.find((each) => each.kind === kind);

test('a mission that does not run yet is shown as it will begin', async () => {
  assert.match(await page.textContent('#clock'), /does not run yet/);
  assert.equal(await page.locator('#timeline').isHidden(), true);
});

test('a waypoint is dragged, and the change is the TOML that it is', async () => {
  await openPlan(page);
  const [[x, y]] = (await handle(page, 'waypoints')).points;
  await drag(page, [x, y], [x + 30, y - 20]);
  await until('the point elsewhere', async () => {
    const [[nowX, nowY]] = (await handle(page, 'waypoints')).points;
    return Math.abs(nowX - x - 30) < 2 && Math.abs(nowY - y + 20) < 2;
  });
  assert.match(await page.textContent('#plan-changes'), /−.*points = \[\[[\s\S]*\+.*points = \[\[/);
  assert.equal(await page.locator('#plan-problems [data-state=bad]').count(), 0);
  const drawn = await page.evaluate(() => globalThis.shoalViewer.panels.plan.editor.plan.setup
    .vehicles[0].tasks[0].points[0]);
  assert.ok(Math.abs(drawn[0] - x - 30) < 2, 'the map draws the changed plan');
});

test('points are added between two, taken out, and typed', async () => {
  const { points } = await handle(page, 'waypoints');
  const [[ax, ay], [bx, by]] = points;
  await drag(page, [(ax + bx) / 2, (ay + by) / 2], [(ax + bx) / 2 + 15, (ay + by) / 2]);
  await until('one point more', async () =>
    (await handle(page, 'waypoints')).points.length === points.length + 1);
  await click(page, ...(await handle(page, 'waypoints')).points[1]);
  await page.keyboard.press('Delete');
  await until('as many as before', async () =>
    (await handle(page, 'waypoints')).points.length === points.length);
  await page.fill('[data-point="1"][data-axis=x]', '77.5');
  await page.keyboard.press('Tab');
  await until('the typed number', async () => (await handle(page, 'waypoints')).points[1][0] === 77.5);
});

test('a survey, an obstacle and a region are drawn, and a start is dragged', async () => {
  const draw = async (tool, corners) => {
    await page.click(`#plan-tool-${tool}`);
    for (const corner of corners) await click(page, ...corner);
    await page.keyboard.press('Enter');
  };
  await draw('survey', [[15, -60], [45, -60], [45, -110]]);
  await until('the survey', () => handle(page, 'survey'));
  await draw('obstacle', [[30, -30], [45, -30], [45, -45]]);
  await until('the obstacle', () => handle(page, 'obstacle'));
  await draw('area', [[5, -25], [170, -25], [170, -155], [5, -155]]);
  await until('the region', () => handle(page, 'op_area'));
  await page.click('#plan-tool-survey');
  await click(page, 20, -80);
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => globalThis.shoalViewer.panels.plan.layer.tool), '');
  const [[x, y]] = (await handle(page, 'start')).points;
  await drag(page, [x, y], [x + 25, y - 10]);
  await until('the start elsewhere', async () =>
    Math.abs((await handle(page, 'start')).points[0][0] - x - 25) < 2);
  const { text, errors } = await plan(page);
  assert.deepEqual(errors, []);
  assert.match(text, /\[\[vehicle\.task\]\]\nname = "planned_survey"\nkind = "survey"\npolygon = /);
  assert.match(text, /\[\[obstacle\]\]\nid = "planned_1"\npolygon = /);
  assert.match(text, /^# One vessel/, 'comments stay');
});

test('an error is the one of shoal check, and goes with the mistake', async () => {
  const { text } = await plan(page);
  const wrong = text.replace('duration_s = 600', 'duration = 600');
  await page.click('#panel-plan summary');
  await page.fill('#plan-text', wrong);
  await until('the error', async () => /unknown key 'duration'/.test(await page.textContent('#plan-problems')));
  const path = join(folder, 'wrong.toml');
  writeFileSync(path, wrong);
  const check = spawnSync(join(bin, 'shoal'), ['check', path], { encoding: 'utf8' });
  const expected = `${check.stdout}${check.stderr}`.split('\n').filter((line) => line.includes(': unknown key'));
  assert.equal(expected.length, 1);
  const shown = (await plan(page)).errors.find((line) => line.includes('unknown key'));
  assert.equal(shown.replace(file, ''), expected[0].replace(path, ''));
  assert.ok(await page.isDisabled('#plan-run'), 'what is no mission is not run');
  await page.click('#plan-undo');
  await until('no error', async () => (await plan(page)).errors.length === 0);
});

test('a plan is downloaded, and written beside the mission file, never over it', async () => {
  const first = readFileSync(file, 'utf8');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#plan-download')]);
  assert.equal(download.suggestedFilename(), 'bay_plan.toml');
  assert.equal(readFileSync(await download.path(), 'utf8'), (await plan(page)).text);
  writeFileSync(join(folder, 'bay_plan1.toml'), 'mine');
  await page.click('#plan-write');
  await until('the file', async () => /Written: .*bay_plan2\.toml/.test(await page.textContent('#plan-outcome')));
  assert.equal(readFileSync(join(folder, 'bay_plan2.toml'), 'utf8'), (await plan(page)).text);
  assert.equal(readFileSync(join(folder, 'bay_plan1.toml'), 'utf8'), 'mine');
  assert.equal(readFileSync(file, 'utf8'), first);
});

test('it runs, and its own viewer shows it', async () => {
  await page.click('#plan-run');
  const url = await until('the address', () => page.getAttribute('#plan-open', 'href'));
  assert.ok(readdirSync(folder).includes('bay_plan3.toml'));
  const running = await stage.page(url);
  await until('the mission', () => running.evaluate(() => {
    const { setup, source } = globalThis.shoalViewer ?? {};
    return setup?.mission === 'bay_plan3' && source?.frame?.clock.state === 'running';
  }));
  assert.equal(await running.evaluate(() => globalThis.shoalViewer.setup.obstacles.length), 1);
});

test('a recording is planned again, by those who may only look too', async () => {
  const log = join(stage.folder, 'rec');
  const short = join(folder, 'short.toml');
  writeFileSync(short, readFileSync(file, 'utf8').replace('duration_s = 600', 'duration_s = 5')
    .replace(/\[\[expect\]\][^]*/, ''));
  const run = stage.run(short, '--warp', 'max', '--record', log);
  assert.equal(await run.over, 0, run.output);
  const viewer = await stage.view('--http', '0', '--log', log);
  const recorded = await stage.page(viewer.url);
  await until('a frame', () => recorded.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await openPlan(recorded);
  const [[x, y]] = (await handle(recorded, 'waypoints')).points;
  await drag(recorded, [x, y], [x + 10, y]);
  await until('the change', async () => (await plan(recorded)).text !== (await plan(recorded)).first);
  assert.equal(await recorded.locator('#plan-write').isHidden(), true);
  const refused = await recorded.request.post(new URL('/api/plan/write', viewer.url).href,
    { data: { text: (await plan(recorded)).text } });
  assert.equal(refused.status(), 403);
  await recorded.click('#plan-close');
  assert.equal(await recorded.locator('#plan-body').isHidden(), true);
});

test('a mission that is paused takes the change as updates of its tasks', async () => {
  const run = stage.start('shoal', 'run', 'missions/alpha.toml', '--quiet', '--port', '28840', '--warp', '5');
  const viewer = await stage.view('--http', '0', '--port', '28840', '--allow-commands');
  const live = await stage.page(viewer.url);
  await until('alpha under way', () => live.evaluate(
    () => globalThis.shoalViewer?.source?.frame?.vehicles[0]?.helm?.state === 'DRIVE'));
  await live.click('[data-tab=commands]');
  await live.click('[data-clock=pause]');
  await until('the pause', async () => /paused/i.test(await live.textContent('#clock')));
  await openPlan(live);
  const { points } = await handle(live, 'waypoints');
  const [x, y] = points.at(-1);
  await drag(live, [x, y], [x + 20, y - 15]);
  await until('the change', async () => (await plan(live)).text !== (await plan(live)).first);
  await live.click('#plan-send');
  await until('one order', async () => /1 sent/.test(await live.textContent('#plan-outcome')));
  await live.click('[data-tab=commands]');
  await live.click('[data-clock=resume]');
  await until('it was taken', async () => /move[\s\S]*taken/.test(await live.textContent('#commands')));
  await live.click('[data-tab=events]');
  await until('the event', async () => /move: /.test(await live.textContent('#events')));
  run.kill('SIGINT');
  await run.over;
});

test('speed, a task by its name and park are buttons', async () => {
  const run = stage.start('shoal', 'run', 'missions/berta.toml', '--quiet', '--port', '28860', '--warp', '5');
  const viewer = await stage.view('--http', '0', '--port', '28860', '--allow-commands');
  const live = await stage.page(viewer.url);
  const helm = () => live.evaluate(() => globalThis.shoalViewer?.source?.frame?.vehicles
    .find(({ name }) => name === 'alpha')?.helm);
  await until('alpha under way', async () => (await helm())?.state === 'DRIVE');
  await live.click('[data-tab=commands]');
  await live.selectOption('#command-target', 'alpha');
  await live.selectOption('#command-task', 'cross');
  await live.click('[data-command=task]');
  await until('the task', async () => (await helm()).task === 'cross');
  await live.fill('#command-speed', '0.7');
  await live.click('[data-command=speed]');
  await until('the speed', () => live.evaluate(() => globalThis.shoalViewer.source.frame.vehicles
    .find(({ name }) => name === 'alpha').desired.speed === 0.7));
  await live.click('[data-command=park]');
  await until('parked', async () => (await helm()).state === 'PARK');
  run.kill('SIGINT');
  await run.over;
});

test('nothing went wrong, and no other host was asked', () => {
  assert.deepEqual(stage.errors.filter((text) => !/403/.test(text)), []);
  assert.deepEqual(stage.outside.filter((url) => !url.startsWith('http://127.0.0.1')), []);
});
