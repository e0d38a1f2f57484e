// A recorded mission as one file, opened from the disk without a viewer.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root, Stage, until } from './support.mjs';

const stage = new Stage();
const file = join(stage.folder, 'berta.html');
let page;
let written = '';

before(async () => {
  const log = join(stage.folder, 'berta.lcm');
  const sim = stage.start('shoal', 'sim', 'missions/berta.toml', '--log', log, '--quiet',
    '--set', 'mission.duration_s=1800');
  await sim.over;
  const view = stage.start('shoal', 'view', log, '--mission', 'missions/berta.toml', '--export', file);
  assert.equal(await view.over, 0, view.output);
  written = view.output;
  page = await stage.page(pathToFileURL(file).href);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

const time = () => page.evaluate(() => globalThis.shoalViewer.source.frame.t);
const alpha = () => page.evaluate(() =>
  globalThis.shoalViewer.source.frame.vehicles.find((each) => each.name === 'alpha').nav);
const scrub = async (t) => {
  await page.locator('#timeline input[type=range]').evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  }, t);
  await until(`the frame at ${t} s`, async () => Math.abs(await time() - t) < 0.2);
};

test('thirty minutes of berta are smaller than 3 MB, and the size is shown', () => {
  const bytes = readFileSync(file).length;
  assert.ok(bytes < 3e6, `${bytes} bytes`);
  assert.match(written, /berta\.html: 1?\.?\d+ [kM]B, \d+ frames 1 s apart, \d+ fates/);
});

test('a log that is named as the page stays as it is', async () => {
  const log = join(stage.folder, 'berta.lcm');
  const bytes = readFileSync(log).length;
  const view = stage.start('shoal', 'view', log, '--mission', 'missions/berta.toml', '--export', log);
  assert.equal(await view.over, 2);
  assert.match(view.output, /a page ends in \.html/);
  assert.equal(readFileSync(log).length, bytes);
});

test('it scrubs, and moves between its frames', async () => {
  await scrub(300);
  const late = await alpha();
  assert.ok(late.x > 200, `on its way to the East: ${late.x}`);
  await scrub(140);
  const early = await alpha();
  assert.ok(Math.hypot(early.x, early.y + 150) < 60, 'in the West');
  await scrub(300);
  assert.deepEqual(await alpha(), late);
  await scrub(300.5);
  const between = await alpha();
  await scrub(301);
  const after301 = await alpha();
  assert.ok(Math.abs(between.x - (late.x + after301.x) / 2) < 0.2, 'half way');
});

test('its channels have messages and charts', async () => {
  await scrub(300);
  await page.click('[data-tab=data]');
  await page.fill('#data-search', 'nav_alpha x_m');
  await page.click('[data-field="NAV_ALPHA:x_m"]');
  await until('the chart', async () => await page.locator('#plots canvas').count() > 0);
  const {value, t} = await page.evaluate(() => globalThis.shoalViewer.requests.get('/api/series',
    { field: 'NAV_ALPHA:x_m', t: 300, window: 200 }));
  assert.ok(value.length > 20 && t.every((each) => each >= 100 && each <= 300));
  assert.ok(Math.abs(value.at(-1) - (await alpha()).x) < 30);
});

test('it plays', async () => {
  await scrub(50);
  await page.keyboard.press('Space');
  await until('two seconds later', async () => await time() > 52);
  await page.keyboard.press('Space');
});

test('a vehicle has its facts and charts', async () => {
  await scrub(300);
  await page.click('[data-tab=vehicle]');
  await page.click('[data-vehicle=alpha]');
  await until('its task', async () => /loiter|transit|east/i.test(await page.textContent('.facts')));
  await until('a drawn chart', () => page.evaluate(() =>
    document.querySelectorAll('#vehicle canvas').length >= 3));
  await until('values', async () => /\d m\/s/.test(await page.textContent('#vehicle .charts')));
});

test('links and fates are those of the moment', async () => {
  await page.click('[data-tab=comms]');
  await scrub(120);
  await until('the reason of the silence', async () =>
    /out of range, 3\d\d\.\d m of 250\.0 m/.test(await page.textContent('#fates')));
  await page.locator('#matrix [data-cell]').first().click();
  await until('the history of the link', async () =>
    /report: \d+ of \d+ delivered/.test(await page.textContent('#panel-comms')));
});

test('events can be gone to', async () => {
  await page.click('[data-tab=events]');
  const from = await time();
  await page.locator('#events :text("again")').first().click();
  await until('another time', async () => Math.abs(await time() - from) > 2);
});

test('it shows that it is a copy, and takes no commands', async () => {
  assert.match(await page.textContent('#notes'), /a page of its own/);
  assert.equal(await page.locator('[data-command=return]').count(), 0);
});

test('a span of it is filmed', async () => {
  await scrub(100);
  await page.selectOption('#speed', '8');
  await page.keyboard.press('Shift+P');
  await until('ten seconds of the mission', async () => await time() > 110);
  const saved = page.waitForEvent('download');
  assert.equal(await page.getAttribute('[data-action=film]', 'aria-pressed'), 'true');
  await page.click('[data-action=film]');
  const film = await saved;
  assert.match(film.suggestedFilename(), /^berta_01-\d\d\.\d\.webm$/);
  const bytes = readFileSync(await film.path());
  // EBML, as all WebM begins.
  assert.deepEqual([...bytes.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]);
  assert.ok(bytes.length > 5000, `${bytes.length} bytes`);
  await page.keyboard.press('Space');
  await page.selectOption('#speed', '1');
});

test('it opens on a phone', async () => {
  const phone = await stage.page(pathToFileURL(file).href, { width: 390, height: 844 });
  await until('the first frame', () => phone.evaluate(() => globalThis.shoalViewer?.source?.frame));
  if (process.env.SHOAL_SCREENSHOTS) {
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_export.png` });
    await phone.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_export_phone.png` });
  }
  await phone.click('[data-vehicle=alpha]');
  await until('its facts', async () => /PARK/.test(await phone.textContent('.facts')));
});

test('a hostile mission runs nothing', async () => {
  const mission = join(stage.folder, 'hostile.toml');
  const evil = '</script><img src=x onerror=globalThis.evil=1>';
  writeFileSync(mission, readFileSync(join(root, 'missions/berta.toml'), 'utf8')
    .replace(/^description = .*$/m, `description = "${evil}"`)
    .replace(/name = "loiter_west"/, `name = "${evil}"`).replaceAll('"loiter_west"', `"${evil}"`));
  const log = join(stage.folder, 'hostile.lcm');
  const bin = join(process.env.SHOAL_BINARY_DIR, 'bin', 'shoal');
  try {
    execFileSync(bin, ['sim', mission, '--log', log, '--quiet'], { stdio: 'pipe' });
  } catch (error) {
    // Its expectations may fail; a mission that does not load would be another test.
    assert.ok(error.status === 1, String(error.stderr));
  }
  const html = join(stage.folder, 'hostile.html');
  execFileSync(bin, ['view', log, '--mission', mission, '--export', html], { stdio: 'pipe' });
  const other = await stage.page(pathToFileURL(html).href);
  await until('the first frame', () => other.evaluate(() => globalThis.shoalViewer?.source?.frame));
  await other.keyboard.press('n');
  await until('the hostile name as text', async () =>
    (await other.textContent('body')).includes('onerror='));
  assert.equal(await other.evaluate(() => globalThis.evil), undefined);
  // What does get in does not run either.
  await other.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'globalThis.evil = 1';
    document.body.append(script);
  });
  assert.equal(await other.evaluate(() => globalThis.evil), undefined);
  stage.errors = stage.errors.filter((text) => !/Content Security Policy/.test(text));
});

test('no address was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
