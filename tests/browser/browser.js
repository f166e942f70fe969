// Headless Chromium with software rendering, and pages in it whose complaints are collected.
import { chromium } from 'playwright-core';
import assert from 'node:assert/strict';
import { AsyncLocalStorage } from 'node:async_hooks';
import { execFile } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

export const top = fileURLToPath(new URL('../..', import.meta.url));
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'shaderport-'));
process.on('exit', () => fs.rmSync(work, { recursive: true, force: true }));

/** @typedef {{folder: string, complaints: string[]}} Surroundings */

/** State of the running test: its folder, and the complaints of its pages. */
const surroundings = /** @type {AsyncLocalStorage<Surroundings>} */ (new AsyncLocalStorage());

/** The folder of the running test. */
export const folder = () => surroundings.getStore()?.folder ?? work;

/** Runs a test in its own folder. Complaints of its pages make it fail, and are told with its error. */
export async function alone(run, mayComplain = false) {
  const all = [];
  try {
    await surroundings.run({ folder: fs.mkdtempSync(path.join(work, 'test-')), complaints: all }, run);
  } catch (error) {
    error.stack = [error.stack, ...all].join('\n');
    throw error;
  }
  if (!mayComplain) assert.deepEqual(all, []);
}

/** Drops the complaints of the running test so far, which are explained. */
export function excuse() {
  const told = surroundings.getStore();
  if (told) told.complaints.length = 0;
}

const ARGS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
  '--disable-gpu-watchdog', '--disable-background-timer-throttling', '--disable-renderer-backgrounding',
  '--disable-backgrounding-occluded-windows', '--mute-audio', '--disable-gpu-process-crash-limit',
  '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader',
  '--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream',
];

/** Starts a browser that can be killed even while it draws. */
export async function launch() {
  const executablePath = process.env.CHROMIUM || '/usr/bin/chromium';
  const server = await chromium.launchServer({ executablePath, args: ARGS, timeout: 0 });
  const browser = await chromium.connect(server.wsEndpoint());
  return { browser, kill: () => server.kill() };
}

/** The path of a program; an environment variable with its name overrides it. */
export const program = (name) => process.env[name.toUpperCase()] || path.join(top, 'target/release', name);

/** Runs a program in the folder of the test; resolves to its exit code, which may be 1, and its output. */
export async function run(command, ...args) {
  const options = { cwd: folder(), maxBuffer: 1 << 30 };
  try {
    return { code: 0, ...(await promisify(execFile)(command, args, options)) };
  } catch (error) {
    if (error.code === 1) return { code: 1, stdout: error.stdout, stderr: error.stderr };
    throw new Error(`${path.basename(command)} ${args.join(' ')}: ${error.stderr || error.message}`);
  }
}

/** Runs the converter; resolves to its exit code and messages. */
export const shaderport = (...args) => run(program('shaderport'), ...args);

/** Writes an input file; returns its path. */
export function put(name, text) {
  const file = path.join(folder(), name);
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, text);
  return file;
}

/** Converts an input to a page; resolves to the page's address. */
export async function port(input, name, ...args) {
  const out = path.join(folder(), `${name}.html`);
  await shaderport(input, '-o', out, '--force', ...args);
  return `file://${out}`;
}

/** Whether a console message is an error or warning that the page itself causes. */
function complains(message) {
  // The tests read pixels more often than a page would.
  const isOurs = message.text().includes('GPU stall due to ReadPixels');
  return ['error', 'warning'].includes(message.type()) && !isOurs;
}

/** The complaints of the pages of the running test. */
export const complaints = () => surroundings.getStore()?.complaints ?? [];

/** Errors and warnings of a page's console and uncaught errors are complaints; returns a function for others. */
export function listen(page) {
  const all = complaints();
  const add = (words) => all.push(words);
  page.on('console', (m) => {
    if (complains(m)) add(m.text());
  });
  page.on('pageerror', (e) => add(`uncaught: ${e.message}`));
  return add;
}

/**
 * Opens a page. Errors and warnings of its console, uncaught errors, dialogs, and requests of any kind are
 * complaints, which make the test fail.
 */
export async function open(context, address, hash = '') {
  const page = await context.newPage();
  const add = listen(page);
  page.on('dialog', (d) => {
    add(`dialog: ${d.message()}`);
    void d.dismiss();
  });
  page.on('request', (r) => {
    if (/^https?:/.test(r.url()) && !r.url().startsWith('http://page.test/')) add(`request: ${r.url()}`);
  });
  await page.goto(address + hash);
  return { page };
}

/** The bytes that a page returns as base64, which is much faster than returning an array. */
export const bytesOf = (base64) => Array.from(Buffer.from(base64, 'base64'));

/** The pixels of the canvas. */
export async function pixels(page) {
  return bytesOf(await page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const gl = canvas.getContext('webgl2');
    const bytes = new Uint8Array(canvas.width * canvas.height * 4);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes.toBase64();
  }));
}

/** The pixels of the canvas after frame `n`. */
export async function frame(page, n) {
  await page.evaluate((number) => globalThis.shaderport.renderFrame(number), n);
  return pixels(page);
}

/** The number of different colours. */
export function colors(bytes) {
  const seen = new Set();
  for (let i = 0; i < bytes.length; i += 4) seen.add((bytes[i] << 16) | (bytes[i + 1] << 8) | bytes[i + 2]);
  return seen.size;
}

/** The number of different bytes. */
export function differences(a, b) {
  let count = a.length === b.length ? 0 : Math.abs(a.length - b.length);
  for (let i = 0; i < Math.min(a.length, b.length); i++) if (a[i] !== b[i]) count++;
  return count;
}

/** Waits for some frames of the page, so that pending changes are visible. */
export function frames(page, count = 3) {
  return page.evaluate(async (n) => {
    for (let i = 0; i < n; i++) await new Promise((resolve) => { requestAnimationFrame(resolve); });
  }, count);
}

/** Waits until the canvas shows exactly these bytes, or other bytes if `isSame` is false. */
export async function becomes(page, bytes, isSame = true) {
  await page.waitForFunction(([expected, same]) => {
    const canvas = document.querySelector('canvas');
    const gl = canvas.getContext('webgl2');
    const drawn = new Uint8Array(canvas.width * canvas.height * 4);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, drawn);
    return same === expected.every((value, i) => value === drawn[i]);
  }, [bytes, isSame]);
}
