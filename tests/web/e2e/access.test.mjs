// For those who see little or use no mouse: axe-core's rules, and the keyboard alone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
const axe = readFileSync(new URL('../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
let page;

before(async () => {
  const log = join(stage.folder, 'berta.lcm');
  await stage.start('shoal', 'sim', 'missions/berta.toml', '--log', log, '--quiet').over;
  const viewer = await stage.view('--log', log, '--mission', 'missions/berta.toml', '--http', '0');
  page = await stage.page(`${viewer.url}#t=200`);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

/** What axe-core finds that is serious or worse, as lines. */
async function findings() {
  // Its own world: the page's security policy lets no other script run.
  const session = await page.context().newCDPSession(page);
  const { frameTree } = await session.send('Page.getFrameTree');
  const { executionContextId: contextId } = await session.send('Page.createIsolatedWorld',
    { frameId: frameTree.frame.id });
  await session.send('Runtime.evaluate', { expression: axe, contextId });
  const { result } = await session.send('Runtime.evaluate', {
    contextId, awaitPromise: true, returnByValue: true,
    expression: `axe.run(document).then(({violations}) => violations
      .filter(({impact}) => impact === 'serious' || impact === 'critical')
      .flatMap(({id, nodes}) => nodes.map((node) => id + ': ' + node.html.slice(0, 160)
        + ' ' + (node.any[0]?.message ?? ''))))`,
  });
  await session.detach();
  return result.value;
}

for (const theme of ['dark', 'light']) {
  for (const tab of ['vehicle', 'comms', 'data', 'status', 'events', 'commands']) {
    test(`the tab ${tab}, ${theme}, has no serious finding`, async () => {
      await page.click(`[data-tab=${tab}]`);
      await page.evaluate((name) => globalThis.shoalViewer.setTheme(name), theme);
      await page.evaluate(() => globalThis.shoalViewer.select('alpha'));
      await page.waitForTimeout(300);
      assert.deepEqual(await findings(), []);
    });
  }
}

test('the help has no serious finding', async () => {
  await page.keyboard.press('?');
  assert.deepEqual(await findings(), []);
  await page.keyboard.press('Escape');
});

test('with the keyboard alone a vehicle is chosen, a field is charted and the time moved', async () => {
  const focused = () => page.evaluate(() => document.activeElement?.id
    || document.activeElement?.textContent);
  await page.evaluate(() => {
    document.activeElement?.blur();
    globalThis.shoalViewer.select(null);
  });
  await page.keyboard.press('n');
  assert.equal(await page.evaluate(() => globalThis.shoalViewer.selected), 'alpha');
  for (let i = 0; i < 30 && !/^tab-/.test(await focused()); ++i) await page.keyboard.press('Tab');
  assert.match(await focused(), /^tab-/);
  while (await focused() !== 'tab-data') await page.keyboard.press('ArrowLeft');
  for (let i = 0; i < 10 && await focused() !== 'data-search'; ++i) await page.keyboard.press('Tab');
  assert.equal(await focused(), 'data-search');
  await page.keyboard.type('nav_alpha speed');
  // Of all words: what was typed first has an answer of its own.
  await until('the fields of a speed', () => page.evaluate(() => {
    const names = [...document.querySelectorAll('[data-field]')].map((each) => each.dataset.field);
    return names.includes('NAV_ALPHA:speed_mps') && names.every((name) => name.includes('speed'));
  }));
  for (let i = 0; i < 10 && !/speed_mps/.test(await focused()); ++i) await page.keyboard.press('Tab');
  assert.match(await focused(), /speed_mps/);
  await page.keyboard.press('Enter');
  await until('its chart', async () => /speed_mps \d\.\d\d m\/s/.test(await page.textContent('#plots')));
  const t = await page.evaluate(() => globalThis.shoalViewer.source.t);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('.');
  await until('a step later', async () =>
    await page.evaluate(() => globalThis.shoalViewer.source.t) > t);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
