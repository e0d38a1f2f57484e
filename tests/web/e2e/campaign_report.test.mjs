// The page of a campaign's report, opened from a file.
import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { root, Stage, until } from './support.mjs';

const stage = new Stage();
// A name and reasons that would run as script if they were ever taken for markup.
const hostile = '<img src=x onerror=globalThis.isBroken=1>';
const folder = join(stage.folder, `it's ${hostile}`);
const quoted = `'${folder.replaceAll("'", "'\\''")}'`;
let page;

const shoal = async (...args) => {
  const child = stage.start('shoal', 'campaign', ...args);
  return { code: await child.over, output: child.output };
};

before(async () => {
  const file = join(stage.folder, 'ranges.toml');
  writeFileSync(file, `[campaign]
mission = "${root}/missions/berta.toml"
repetitions = 12

[sweep]
"comms.comms_range" = [50, 100, 200]

[sample]
"vehicle.alpha.start.x_m" = {uniform = [100, 300]}

[policy.fast]
[policy.slow]
"vehicle.alpha.task.cross.speed_mps" = 1

[metrics]
closest_m = {kind = "closest_approach", vehicle = "alpha", to = "bravo"}
`);
  const run = await shoal('run', file, '--out', folder, '--keep', 'none', '--quiet');
  assert.equal(run.code, 0, run.output);
  // As a folder from elsewhere may have it.
  const shards = join(folder, 'shards');
  for (const name of readdirSync(shards)) {
    const text = readFileSync(join(shards, name), 'utf8')
      .replaceAll('"why":"', `"why":"${hostile}</script><script>globalThis.isBroken=1</script>`);
    writeFileSync(join(shards, name), text);
  }
  const report = await shoal('report', folder, '--html');
  assert.equal(report.code, 0, report.output);
  page = await stage.page(pathToFileURL(join(folder, 'report.html')).href,
    { width: 1400, height: 900 });
  await until('the page', () => page.evaluate(() => Boolean(globalThis.shoalReport)));
});
after(() => stage.end());

const chart = (name) => page.locator(`[data-chart=${name}]`);

/** Returns how many pixels of a chart's canvas are drawn. */
const drawnPixels = (name) => chart(name).locator('canvas').evaluate((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.filter((value, i) => i % 4 === 3 && value > 0).length;
});

/** Clicks the first mark of a chart that a function of globalThis.shoalChoosers chooses. */
async function clickMark(name, chooser) {
  await chart(name).scrollIntoViewIfNeeded();
  const at = await page.evaluate(([which, how]) => {
    const { charts, report } = globalThis.shoalReport;
    return charts[which].placeOf(charts[which].view.marks.find(
      (mark) => globalThis.shoalChoosers[how](mark, report)));
  }, [name, chooser]);
  await chart(name).locator('.u-over').click({ position: at });
}

const commands = () => page.locator('#trials .command').allTextContents();
const shoot = async (name) => {
  if (!process.env.SHOAL_SCREENSHOTS) return;
  mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
  await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/${name}.png` });
};

test('it shows the counts and draws', async () => {
  assert.match(await page.textContent('#counts'), /^72 of 72 trials: \d+ pass\d+ fail0 error/);
  for (const name of ['curve', 'trials']) assert.ok(await drawnPixels(name) > 2000, name);
  assert.equal(await chart('bins').isVisible(), false, 'a share has no histogram');
  await page.selectOption('#quantity', { label: 'closest_m [m]' });
  for (const name of ['curve', 'trials', 'bins']) assert.ok(await drawnPixels(name) > 2000, name);
});

test('a click on a point of a curve lists the trials of its case', async () => {
  await page.evaluate(() => {
    globalThis.shoalChoosers = {
      slowAt100: (mark, report) => report.caseText(mark.number) ===
        'comms.comms_range=100, policy=slow',
      seventh: (mark, report) => report.data.trials.repetition[mark.row] === 7,
    };
  });
  await clickMark('curve', 'slowAt100');
  assert.match(await page.textContent('#trials h2'), /comms_range=100, policy=slow/);
  const shown = await commands();
  assert.equal(shown.length, 12);
  const id = await page.evaluate(() => globalThis.shoalReport.report.cases.find(
    (each) => each.values[0] === '100' && each.policy === 'slow').id);
  for (const command of shown) {
    assert.ok(command.startsWith(`shoal campaign replay ${quoted} ${id}-`), command);
    assert.ok(command.endsWith(' --view'), command);
  }
  await shoot('campaign_report_case');
});

test('a click on a trial lists it, and its command replays it', async () => {
  await page.selectOption('#over', { label: 'vehicle.alpha.start.x_m' });
  assert.equal(await chart('curve').isVisible(), false);
  await clickMark('trials', 'seventh');
  const [command] = await commands();
  const trial = /([0-9a-f]{10}-7) --view$/.exec(command)?.[1];
  assert.ok(trial, command);
  assert.match(await page.textContent('#trials li'), /vehicle.alpha.start.x_m=\d/);
  const shownValue = Number(/closest_m ([\d.]+) m/.exec(await page.textContent('#trials li'))[1]);
  const recording = join(stage.folder, 'replay');
  const replayed = await shoal('replay', folder, trial, '--out', recording);
  const row = readFileSync(join(folder, 'shards', readdirSync(join(folder, 'shards'))[0]), 'utf8')
    .split('\n').filter(Boolean).map(JSON.parse)
    .find((each) => `${each.case}-${each.repetition}` === trial);
  assert.ok(Math.abs(row.metrics.closest_m - shownValue) < 0.01, `${shownValue}`);
  assert.equal(replayed.code, row.outcome === 'pass' ? 0 : 1, replayed.output);
  assert.ok(readdirSync(recording).length > 0, 'there is a recording');
});

test('a click copies the command', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const [command] = await commands();
  await page.locator('#trials .command').first().click();
  await until('the sign', async () => await page.textContent('#trials .copied') === 'copied');
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), command);
});

test('the keys reach a point too', async () => {
  await page.selectOption('#over', { label: 'comms.comms_range' });
  await chart('curve').locator('.chart-place').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('#trials h2'), /comms_range=50/);
  await page.locator('#cases tbody button').nth(5).focus();
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('#trials h2'), /comms_range=200, policy=slow/);
});

test('a bar lists the trials in it', async () => {
  const box = await chart('bins').locator('.u-over').boundingBox();
  await chart('bins').locator('.u-over').click({ position: { x: 4, y: box.height - 4 } });
  const expected = await page.evaluate(() =>
    globalThis.shoalReport.charts.bins.view.marks[0].rows.length);
  assert.ok(expected > 0);
  assert.equal((await commands()).length, expected);
});

test('a filter leaves the cases of its value', async () => {
  await page.selectOption('#filter-1', { label: 'slow' });
  assert.equal(await page.locator('#cases tbody tr').count(), 3);
  await page.selectOption('#filter-1', { label: 'all' });
  assert.equal(await page.locator('#cases tbody tr').count(), 6);
});

test('the table has the numbers of the text report', async () => {
  await page.selectOption('#quantity', { label: 'share passed' });
  const { output } = await shoal('report', folder);
  const text = output.slice(output.indexOf('Outcomes'), output.indexOf('expect_1'));
  const rows = await page.locator('#cases tbody tr').evaluateAll((each) =>
    each.map((row) => [...row.cells].slice(2, 9).map((cell) => cell.textContent)));
  for (const row of rows) {
    const pattern = row.map((cell) => cell.replace(/[.*]/g, '\\$&')).join('\\s+');
    assert.match(text, new RegExp(pattern));
  }
});

test('it is dark where the browser is', async () => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await page.emulateMedia({ colorScheme: 'dark' });
  assert.notEqual(await ground(), light);
  await shoot('campaign_report_dark');
});

test('without script it is the text report', async () => {
  const context = await stage.browser.newContext({ javaScriptEnabled: false });
  const plain = await context.newPage();
  await plain.goto(page.url());
  assert.match(await plain.locator('noscript pre').innerText(), /72 of 72 trials/);
  assert.equal(await plain.locator('#report').isVisible(), false);
});

test('nothing that results hold ran, no host was asked, and nothing went wrong', async () => {
  await page.selectOption('#quantity', { label: 'closest_m [m]' });
  await page.locator('#cases tbody tr').first().click();
  assert.match(await page.textContent('#trials .why'), /<script>globalThis.isBroken=1/);
  assert.equal(await page.evaluate(() => globalThis.isBroken), undefined);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
