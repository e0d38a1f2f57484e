// What a user's program draws: recorded, and seen on the map.
import assert from 'node:assert/strict';
import { chmodSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { root, Stage, until } from './support.mjs';

const kMission = (program) => `
[mission]
duration_s = 60
[[vehicle]]
name = "alpha"
start = {x_m = 0, y_m = 0, heading_deg = 90}
[[participant]]
name = "artist"
command = ["${program}"]
`;
const kProgram = `#!/usr/bin/env python3
import sys
sys.path.insert(0, "${root}/python")
import shoal
me = shoal.Participant()
evil = "<img src=x onerror=evil=1>"

def think(utime):
    if utime % 1_000_000 != 0:
        return
    t = utime / 1e6
    art = dict(utime=utime, owner="artist")
    me.publish("VIEW_POLYGON", shoal.types.view_polygon_t(**art, label="search box", color="orange",
        fill=0.3, x_m=[-50, 50, 50, -50], y_m=[20, 20, 80, 80]))
    me.publish("VIEW_SEGLIST", shoal.types.view_seglist_t(**art, label="way", color="cyan",
        width_px=3, x_m=[-50, 0, 50], y_m=[-20, -60, -20]))
    me.publish("VIEW_CIRCLE", shoal.types.view_circle_t(**art, label="keep out", color="red",
        x_m=80, y_m=-40, radius_m=25, fill=0.2))
    me.publish("VIEW_TEXT", shoal.types.view_text_t(**art, color="white", x_m=-80, y_m=0, text=evil))
    if t <= 20:
        me.publish("VIEW_POINT", shoal.types.view_point_t(**art, label="mine", color="#ff00ff",
            x_m=0, y_m=50, size_px=10, life_s=5))

me.run(think)
`;

const stage = new Stage();
let page;

before(async () => {
  const [mission, program] = [join(stage.folder, 'art.toml'), join(stage.folder, 'artist.py')];
  writeFileSync(program, kProgram);
  chmodSync(program, 0o755);
  writeFileSync(mission, kMission(program));
  const folder = join(stage.folder, 'recording');
  const run = stage.run(mission, '--warp', 'max', '--record', folder);
  assert.equal(await run.over, 0, run.output);
  const viewer = await stage.view('--log', folder, '--http', '0');
  page = await stage.page(`${viewer.url}#t=10`);
  await until('the first frame', () => page.evaluate(() => globalThis.shoalViewer?.source?.frame));
});
after(() => stage.end());

const drawings = () => page.evaluate(() => globalThis.shoalViewer.source.frame.drawings
  .map(({ kind, label }) => `${kind} ${label}`));
const seek = async (t) => {
  await page.evaluate((time) => globalThis.shoalViewer.source.seek(time), t);
  await until(`the frame at ${t} s`, () => page.evaluate(
    (time) => globalThis.shoalViewer.source.frame.t === time, t));
};
const picture = () => page.evaluate(() => document.getElementById('map').toDataURL());

test('a frame has what was drawn, each kind', async () => {
  await seek(12);
  assert.deepEqual(await drawings(),
    ['point mine', 'polygon search box', 'seglist way', 'circle keep out', 'text ']);
});

test('a drawing goes at the end of its life, and is there again before', async () => {
  await seek(40);
  assert.ok(!(await drawings()).includes('point mine'));
  await seek(24);
  assert.ok((await drawings()).includes('point mine'));
});

test('the map shows them, unless their layer is off', async () => {
  const shown = await picture();
  if (process.env.SHOAL_SCREENSHOTS) {
    mkdirSync(process.env.SHOAL_SCREENSHOTS, { recursive: true });
    await page.screenshot({ path: `${process.env.SHOAL_SCREENSHOTS}/viewer_drawings.png` });
  }
  await page.click('#layers summary');
  await page.uncheck('[data-layer=drawings]');
  await page.keyboard.press('Escape');
  await until('another picture', async () => await picture() !== shown);
  await page.click('#layers summary');
  await page.check('[data-layer=drawings]');
  await page.keyboard.press('Escape');
});

test('a hostile text is drawn and runs nothing', async () => {
  assert.equal(await page.evaluate(() => globalThis.evil), undefined);
});

test('no other host was asked, and nothing went wrong', () => {
  assert.deepEqual(stage.outside, []);
  assert.deepEqual(stage.errors, []);
});
