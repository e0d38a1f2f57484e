// What tests/bench/viewer runs.
import { Stage, root, until } from './e2e/support.mjs';

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const pairs = Number(process.argv[2] ?? 3);
const mission = `${root}/tests/bench/fleet50.toml`;

/** Reads a stream as fast as it comes. */
function follow(url) {
  const abort = new AbortController();
  const client = { bytes: 0, stop: () => abort.abort() };
  (async () => {
    const answer = await fetch(new URL('api/stream', url), { signal: abort.signal });
    for await (const chunk of answer.body) {
      client.bytes += chunk.length;
    }
  })().catch(() => {});
  return client;
}

async function factor(withViewer) {
  const stage = new Stage();
  try {
    const run = stage.run(mission, '--warp', 'max', '--set', 'mission.duration_s=60');
    let client;
    if (withViewer) client = follow((await stage.view()).url);
    await run.over;
    client?.stop();
    const speeds = /([\d.]+) s of mission in ([\d.]+) s/.exec(run.output);
    if (!speeds) throw new Error(`the mission did not run: ${run.output}`);
    if (withViewer) console.log(`      ${Math.round(client.bytes / 1000)} kB of frames`);
    return Number(speeds[1]) / Number(speeds[2]);
  } finally {
    await stage.end();
  }
}

async function framesPerSecond() {
  const stage = new Stage();
  try {
    stage.run(mission, '--warp', '1', '--set', 'mission.duration_s=120');
    const viewer = await stage.view();
    const page = await stage.page(viewer.url);
    await until('vehicles on the page', () => page.evaluate(
      () => globalThis.shoalViewer?.world?.at(performance.now()).vehicles.length === 50));
    await page.waitForTimeout(20_000); // Trails grow.
    return await page.evaluate(() => new Promise((done) => {
      const begin = performance.now();
      let frames = 0;
      const count = () => {
        frames += 1;
        const passed = performance.now() - begin;
        if (passed < 10_000) requestAnimationFrame(count);
        else done((frames * 1000) / passed);
      };
      requestAnimationFrame(count);
    }));
  } finally {
    await stage.end();
  }
}

const without = [];
const beside = [];
for (let i = 0; i < pairs; i += 1) {
  without.push(await factor(false));
  console.log(`without viewer: ${without.at(-1).toFixed(3)} x real time`);
  beside.push(await factor(true));
  console.log(`with viewer:    ${beside.at(-1).toFixed(3)} x real time`);
}
const ratio = median(beside) / median(without);
console.log(`median with / without: ${median(beside).toFixed(3)} / ${median(without).toFixed(3)} = ${ratio.toFixed(3)}`
  + ' (promised: more than 0.90)');
const fps = await framesPerSecond();
console.log(`page: ${fps.toFixed(1)} frames per second (promised: 30)`);
