// Ten pages at once, all live.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let pages;

before(async () => {
  stage.run('missions/berta.toml', '--warp', '5');
  const viewer = await stage.view();
  pages = await Promise.all(Array.from({ length: 10 }, () => stage.page(viewer.url)));
});
after(() => stage.end());

test('ten pages at once stay live', async () => {
  const frames = () => Promise.all(pages.map((page) => page.evaluate(
    () => globalThis.shoalViewer?.frames ?? 0)));
  for (let round = 0; round < 3; round += 1) {
    const begin = await frames();
    await until('ten more frames on each page', async () =>
      (await frames()).every((count, i) => count >= begin[i] + 10));
  }
  const asks = await Promise.all(pages.map((page) => page.evaluate(
    async () => (await fetch('api/setup')).status)));
  assert.deepEqual(asks, pages.map(() => 200));
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
