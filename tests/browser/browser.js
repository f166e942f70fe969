// Chromium without a window, drawing by software, and pages in it whose complaints are kept.
import { chromium } from 'playwright-core';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const top = fileURLToPath(new URL('../..', import.meta.url));
export const work = fs.mkdtempSync(path.join(os.tmpdir(), 'shaderport-'));

const ARGS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
  '--disable-gpu-watchdog', '--disable-background-timer-throttling', '--disable-renderer-backgrounding',
  '--disable-backgrounding-occluded-windows', '--mute-audio', '--disable-gpu-process-crash-limit',
  '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader',
  '--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream',
];

/** Starts a browser, which can be ended even while it draws. */
export async function launch() {
  const executablePath = process.env.CHROMIUM || '/usr/bin/chromium';
  const server = await chromium.launchServer({ executablePath, args: ARGS });
  const browser = await chromium.connect(server.wsEndpoint());
  return { browser, kill: () => server.kill() };
}

/** Runs the converter; gives what it says and its exit code. */
export function shaderport(...args) {
  const program = process.env.SHADERPORT || path.join(top, 'target/release/shaderport');
  try {
    execFileSync(program, args, { cwd: work, stdio: ['ignore', 'pipe', 'pipe'] });
    return 0;
  } catch (error) {
    if (error.status === 1) return 1;
    throw new Error(`shaderport ${args.join(' ')}: ${error.stderr ?? error.message}`);
  }
}

/** Writes a file to be ported; gives its path. */
export function put(name, text) {
  const file = path.join(work, name);
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, text);
  return file;
}

/** Ports an input to a page; gives the page's address. */
export function port(input, name, ...args) {
  const out = path.join(work, `${name}.html`);
  shaderport(input, '-o', out, '--force', ...args);
  return `file://${out}`;
}

/** Whether a message of the console is an error or warning that the page itself is the cause of. */
export function complains(message) {
  // The tests read pixels more often than a page would.
  const isOurs = message.text().includes('GPU stall due to ReadPixels');
  return ['error', 'warning'].includes(message.type()) && !isOurs;
}

/**
 * Opens a page. `complaints` collects errors and warnings of its console, errors that nobody caught,
 * and requests of any kind.
 */
export async function open(context, address, hash = '') {
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (m) => {
    if (complains(m)) complaints.push(m.text());
  });
  page.on('pageerror', (e) => complaints.push(`uncaught: ${e.message}`));
  page.on('dialog', (d) => {
    complaints.push(`dialog: ${d.message()}`);
    void d.dismiss();
  });
  page.on('request', (r) => {
    if (/^https?:/.test(r.url()) && !r.url().startsWith('http://page.test/')) complaints.push(`request: ${r.url()}`);
  });
  await page.goto(address + hash);
  return { page, complaints };
}

/** The pixels of the canvas. */
export function pixels(page) {
  return page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const gl = canvas.getContext('webgl2');
    const bytes = new Uint8Array(canvas.width * canvas.height * 4);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return Array.from(bytes);
  });
}

/** The pixels of the canvas after frame `n`. */
export async function frame(page, n) {
  await page.evaluate((number) => globalThis.shaderport.renderFrame(number), n);
  return pixels(page);
}

/** How many different colours there are. */
export function colors(bytes) {
  const seen = new Set();
  for (let i = 0; i < bytes.length; i += 4) seen.add((bytes[i] << 16) | (bytes[i + 1] << 8) | bytes[i + 2]);
  return seen.size;
}

/** How many bytes differ. */
export function differences(a, b) {
  let count = a.length === b.length ? 0 : Math.abs(a.length - b.length);
  for (let i = 0; i < Math.min(a.length, b.length); i++) if (a[i] !== b[i]) count++;
  return count;
}
