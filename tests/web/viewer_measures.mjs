// Measures what the page must hold, with playbacks that are live to it: frames per second of many
// vehicles, and memory over an hour of mission time.
//
//   SHOAL_BINARY_DIR=build SHOAL_CHROMIUM=chromium node tests/web/viewer_measures.mjs frames 100
//   ... memory 3600 30        an hour of berta, 30 times as fast
//
// Each line names the load average, since other programs take from what is measured.
import { readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { Stage, root, until } from './e2e/support.mjs';

const [what, ...numbers] = process.argv.slice(2);
const load = () => loadavg().map((each) => each.toFixed(1)).join(' ');
const stage = new Stage();

/** A playback of a mission, its text changed by `change`, `speed` times as fast; and its page. */
async function playback(mission, speed, change) {
  const file = join(stage.folder, 'mission.toml');
  const log = join(stage.folder, 'mission.lcm');
  writeFileSync(file, change(readFileSync(mission, 'utf8')));
  const sim = stage.start('shoal', 'sim', file, '--quiet', '--log', log);
  if (await sim.over > 1) throw new Error(sim.output);
  const play = stage.start('shoal', 'play', log, '--speed', String(speed), '--quiet', '--port', '28930');
  const viewer = await stage.view('--http', '0', '--port', '28930');
  return { viewer, play, page: await stage.page(viewer.url) };
}

/** Frames that the browser has drawn per second, over `seconds`. */
const framesOver = (page, seconds) => page.evaluate((span_ms) => new Promise((done) => {
  const begin = performance.now();
  let drawn = 0;
  const count = () => {
    drawn += 1;
    const passed = performance.now() - begin;
    if (passed < span_ms) requestAnimationFrame(count);
    else done((drawn * 1000) / passed);
  };
  requestAnimationFrame(count);
}), seconds * 1000);

async function frames(count) {
  const mission = `${root}/tests/bench/${count > 100 ? 'fleet1000' : 'fleet50'}.toml`;
  const { page } = await playback(mission, 1, (text) => text.replace(/^count = .*$/m, `count = ${count}`)
    .replace(/^duration_s = .*$/m, 'duration_s = 90').replace(/\[\[expect\]\][^]*/, ''));
  await until('vehicles on the page', () => page.evaluate((wanted) =>
    globalThis.shoalViewer?.world?.at(performance.now()).vehicles.length === wanted, count), 300_000);
  await page.waitForTimeout(10_000); // Trails grow.
  for (let i = 0; i < 3; ++i) {
    const rate = await framesOver(page, 8);
    console.log(`${count} vehicles: ${rate.toFixed(1)} frames per second, load ${load()}`);
  }
}

async function memory(duration_s, speed) {
  const { page, viewer } = await playback(`${root}/missions/berta.toml`, speed, (text) =>
    text.replace(/^duration_s = .*$/m, `duration_s = ${duration_s}`));
  const session = await page.context().newCDPSession(page);
  const heap = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize / 1e6;
  };
  const resident = () => Number(/VmRSS:\s+(\d+)/.exec(
    readFileSync(`/proc/${viewer.pid}/status`, 'utf8'))[1]) / 1e3;
  const time = () => page.evaluate(() => globalThis.shoalViewer?.source?.frame?.t ?? 0);
  for (let next = 0; next <= duration_s; next += duration_s / 12) {
    await until(`second ${next}`, async () => await time() >= Math.min(next, duration_s - 5), 600_000);
    console.log(`${Math.round(await time())} s: page ${(await heap()).toFixed(1)} MB, `
      + `viewer ${resident().toFixed(0)} MB, load ${load()}`);
  }
}

try {
  if (what === 'frames') await frames(Number(numbers[0] ?? 100));
  else await memory(Number(numbers[0] ?? 3600), Number(numbers[1] ?? 30));
} finally {
  await stage.end();
}
