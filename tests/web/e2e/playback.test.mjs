// A recording that `shoal play` publishes, seen and moved from the page.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Stage, until } from './support.mjs';

const stage = new Stage();
let page;
let player;

before(async () => {
  const log = join(stage.folder, 'berta.lcm.zst');
  const sim = stage.start('shoal', 'sim', 'missions/berta.toml', '--log', log, '--quiet');
  assert.equal(await sim.over, 0, sim.output);
  player = stage.start('shoal', 'play', log, '--from', '580', '--loop', '--quiet');
  await until('the playback', () => /LCM ports/.test(player.output));
  const viewer = await stage.view('--allow-commands');
  page = await stage.page(viewer.url);
  await page.click('[data-tab=commands]');
});
after(() => stage.end());

const time = () => page.evaluate(() => globalThis.shoalViewer.source.frame?.t ?? null);
const clock = () => page.textContent('#clock');
const seek = async (seconds) => {
  await page.fill('#seek input', String(seconds));
  await page.click('#seek button');
};

test('the page is marked as that of a playback', async () => {
  await until('the title', async () => /playback of berta/.test(await page.title()));
});

test('it begins again at the end of the recording', async () => {
  await page.click('[data-clock="warp 10"]');
  const latest = await until('the end to be near', async () => {
    const t = await time();
    return t > 585 ? t : null;
  });
  await until('the begin again', async () => {
    const t = await time();
    return t >= 580 && t < latest;
  });
});

test('it pauses, moves and goes on', async () => {
  await page.click('[data-clock=pause]');
  await until('a pause', async () => /paused/i.test(await clock()));
  await seek(100);
  await until('the place', async () => Math.abs((await time()) - 100) < 0.2);
  await until('a pause there too', async () => /paused/i.test(await clock()));
  await page.click('[data-clock=resume]');
  await until('it goes on', async () => {
    const t = await time();
    return t > 101 && t < 500;
  });
  assert.deepEqual(stage.errors, []);
});
