// The viewer is killed and started again: its pages find it.
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let viewer;
let page;

before(async () => {
  stage.run('missions/berta.toml', '--warp', '5');
  viewer = await stage.view();
  page = await stage.page(viewer.url);
});
after(() => stage.end());

const frames = () => page.evaluate(() => globalThis.shoalViewer?.frames ?? 0);

test('a page reconnects after the viewer was restarted', async () => {
  await until('frames', async () => await frames() > 5);
  viewer.kill('SIGKILL');
  await viewer.over;
  await until('the page shows that it has lost the viewer', async () =>
    /lost|reconnect/i.test(await page.textContent('#connection')));
  await stage.view('--http', new URL(viewer.url).port);
  const shown = await frames();
  await until('frames again', async () => await frames() > shown + 5);
  await until('the page shows that it is live', async () =>
    /live/i.test(await page.textContent('#connection')));
});
