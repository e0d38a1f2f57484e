// A recorded mission in the page: the time line.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;

before(async () => {
  const folder = join(stage.folder, 'recording');
  const run = stage.run('missions/berta.toml', '--warp', 'max', '--record', folder);
  assert.equal(await run.over, 0, run.output);
  const view = stage.start('shoal', 'view', folder);
  const url = await until('the address', () => /viewer: (http\S+)/.exec(view.output)?.[1]);
  page = await stage.page(url);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

const time = () => page.evaluate(() => globalThis.shoalViewer.source.frame.t);
const scrub = async (t) => {
  await page.locator('#timeline input[type=range]').evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  }, t);
  await until(`the frame at ${t} s`, async () => Math.abs(await time() - t) < 0.2);
};
const alpha = () => page.evaluate(() =>
  globalThis.shoalViewer.source.frame.vehicles.find((each) => each.name === 'alpha'));

test('a log scrubs, to and fro', async () => {
  await scrub(300);
  const late = await alpha();
  assert.ok(late.nav.x > 200, `on its way to the East: ${late.nav.x}`);
  await scrub(140);
  const early = await alpha();
  assert.ok(Math.hypot(early.nav.x, early.nav.y + 150) < 60, 'in the West');
  await scrub(300);
  assert.deepEqual((await alpha()).nav, late.nav);
  if (process.env.SHOAL_SCREENSHOTS) {
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await page.keyboard.press('n');
    await page.waitForTimeout(1000);
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_recorded.png` });
  }
});

test('it plays, and stops', async () => {
  await scrub(50);
  await page.keyboard.press('Space');
  await until('two seconds later', async () => await time() > 52);
  await page.keyboard.press('Space');
  await until('it stands still', async () => {
    const at = await time();
    await page.waitForTimeout(400);
    return await time() === at;
  });
});

test('both clocks show the same time while it plays', async () => {
  await scrub(50);
  await page.selectOption('#speed', '64');
  await page.keyboard.press('Space');
  const apart = await page.evaluate(() => new Promise((done) => {
    const text = (id) => document.getElementById(id).textContent.split(' / ')[0];
    const pairs = [];
    const look = () => {
      if (text('clock-time') !== text('timeline-time')) pairs.push([text('clock-time'), text('timeline-time')]);
      if (globalThis.shoalViewer.source.t < 120) requestAnimationFrame(look);
      else done(pairs);
    };
    requestAnimationFrame(look);
  }));
  await page.keyboard.press('Space');
  await page.selectOption('#speed', '1');
  assert.deepEqual(apart, []);
});

test('it jumps to the next event', async () => {
  await scrub(1);
  await page.keyboard.press(']');
  await until('a later time', async () => await time() > 2);
  await page.click('[data-tab=events]');
  await until('lost contact in the list', async () =>
    /lost/i.test(await page.textContent('#events')));
});

test('an event is shown where it happened', async () => {
  await page.click('[data-tab=events]');
  await page.locator('#events :text("lost")').first().click();
  await until('the map at the vehicle', () => page.evaluate(() => {
    const { map, source, selected } = globalThis.shoalViewer;
    const found = source.frame.vehicles.find((each) => each.name === selected);
    return found && Math.hypot(map.view.cx - found.nav.x, map.view.cy - found.nav.y) < 5;
  }));
});

test('events have what happened, chosen by kind and vehicle, and so have the marks', async () => {
  await page.click('[data-tab=events]');
  const kinds = () => page.locator('#events li').evaluateAll((found) =>
    [...new Set(found.map((row) => row.dataset.kind))].sort());
  const marks = () => page.locator('#timeline .marks button').count();
  for (const kind of ['deployed', 'task', 'waypoint', 'mission', 'first_contact']) {
    assert.ok((await kinds()).includes(kind), `${kind} of ${await kinds()}`);
  }
  const all = await marks();
  await page.selectOption('#events-group', 'mission');
  assert.deepEqual(await kinds(), ['met', 'mission'], 'its events, and the verdict of the run');
  assert.ok(await marks() < all);
  await page.selectOption('#events-group', 'course');
  await page.selectOption('#events-vehicle', 'bravo');
  const texts = await page.locator('#events li').allTextContents();
  assert.ok(texts.length > 0 && texts.every((text) => text.includes('bravo')), texts.join('|'));
  await page.fill('#events-text', 'task');
  await until('the search', async () => (await kinds()).join() === 'task');
  const row = page.locator('#events li button').first();
  await row.click();
  await until('its time', async () => await time() > 0);
  await page.fill('#events-text', '');
  await page.selectOption('#events-group', 'all');
  await page.selectOption('#events-vehicle', '');
});

test('on a phone time line and tabs are within the screen, and nothing of the table is cut', async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const part of ['#timeline-position', '#timeline-time', '#tab-commands', '#tools > button:last-child']) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box && box.x >= 0 && box.x + box.width <= 390 && box.y + box.height <= 844,
      `${part}: ${JSON.stringify(box)}`);
  }
  await page.setViewportSize({ width: 1280, height: 720 });
});

test('the matrix is that of the moment', async () => {
  await page.click('[data-tab=comms]');
  await scrub(120);
  await until('the reason of the silence', async () =>
    /out of range, 3\d\d\.\d m of 250\.0 m/.test(await page.textContent('#fates')));
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
