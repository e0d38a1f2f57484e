// What the tests in a browser share: missions and viewers of their own, and a browser that records
// which hosts its pages asked.
import { chromium } from 'playwright-core';
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const bin = join(process.env.SHOAL_BINARY_DIR, 'bin');
export const root = resolve(new URL('.', import.meta.url).pathname, "../../..");

/** Waits until `look()` gives something true, and returns that; throws after `patience_ms`. */
export async function until(what, look, patience_ms = 60_000) {
  const end = Date.now() + patience_ms;
  let last;
  for (;;) {
    try {
      const value = await look();
      if (value) return value;
    } catch (error) {
      last = error;
    }
    if (Date.now() > end) throw new Error(`waited in vain for ${what}${last ? `: ${last}` : ''}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

/** A place of its own for one test file: programs that it starts, and a browser. */
export class Stage {
  constructor() {
    this.folder = mkdtempSync(join(tmpdir(), 'shoal-web-'));
    this.children = [];
    this.outside = []; // What pages asked of other hosts.
    this.errors = []; // What pages reported of themselves.
  }

  /** Starts a program; `output` holds its output so far. */
  start(program, ...args) {
    const child = spawn(join(bin, program), args, {
      cwd: root,
      env: { ...process.env, SHOAL_RUN_DIR: this.folder },
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    child.output = '';
    child.stdout.on('data', (data) => { child.output += data; });
    child.stderr.on('data', (data) => { child.output += data; });
    child.over = new Promise((done) => child.on('close', (code) => done(code)));
    this.children.push(child);
    return child;
  }

  run(mission, ...args) {
    return this.start('shoal', 'run', mission, '--quiet', ...args);
  }

  /** Starts a viewer and returns it with its `url`. */
  async view(...args) {
    const viewer = this.start('shoal-viewer', ...args);
    viewer.url = await until('the address of the viewer', () => {
      if (viewer.exitCode !== null) throw new Error(`the viewer has ended: ${viewer.output}`);
      return /viewer: (http\S+)/.exec(viewer.output)?.[1];
    });
    return viewer;
  }

  async page(url, size = { width: 1280, height: 720 }) {
    this.launch ??= chromium.launch({
      executablePath: process.env.SHOAL_CHROMIUM,
      args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-dev-shm-usage',
        '--no-first-run', '--disable-background-networking', '--disable-component-update',
        '--disable-sync'],
    });
    this.browser = await this.launch;
    const context = await this.browser.newContext({ viewport: size, acceptDownloads: true });
    const page = await context.newPage();
    // A page from the disk has no host of its own, and asks for nothing but itself.
    const own = url && url.startsWith('http') ? new URL(url).host : null;
    page.on('request', (request) => {
      const asked = new URL(request.url());
      const isPage = request.isNavigationRequest() && asked.protocol === 'file:';
      if (!isPage && asked.host !== own && !['data:', 'blob:'].includes(asked.protocol)) {
        this.outside.push(request.url());
      }
    });
    page.on('pageerror', (error) => this.errors.push(String(error)));
    page.on('console', (message) => {
      if (message.type() === 'error') this.errors.push(message.text());
    });
    if (url) await page.goto(url);
    return page;
  }

  async end() {
    await this.browser?.close();
    for (const child of this.children) {
      if (child.exitCode !== null || child.signalCode !== null) continue;
      child.kill('SIGINT');
      const killer = setTimeout(() => child.kill('SIGKILL'), 10_000);
      await child.over;
      clearTimeout(killer);
    }
    rmSync(this.folder, { recursive: true, force: true });
  }
}
