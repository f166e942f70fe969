// The editor under test, and what the steps of its tests do in it.
import { spawn } from 'node:child_process';
import path from 'node:path';
import { frames } from '../browser/browser.js';

/** The folder with the packages of the extension, and whether that for browsers is tested. */
export const [packages, kind] = process.argv.slice(2);
const work = path.join(packages, kind);
export const settings = path.join(work, 'user/User/settings.json');
export const shaders = path.join(work, 'shaders');
export const program = process.env.CODE_SERVER;

/** Command line arguments of the editor. */
export function args(...more) {
  const folders = ['--user-data-dir', path.join(work, 'user'), '--extensions-dir', path.join(work, 'extensions')];
  return [...folders, '--config', path.join(work, 'none.yaml'), ...more];
}

/** Starts the editor on a free port; resolves to its address once it listens. */
export async function start() {
  const options = ['--auth', 'none', '--bind-addr', '127.0.0.1:0', '--disable-telemetry', '--disable-update-check'];
  const server = spawn(program, args(...options, shaders), { stdio: ['ignore', 'pipe', 'pipe'], detached: true });
  let log = '';
  const address = await new Promise((resolve, reject) => {
    for (const stream of [server.stdout, server.stderr]) {
      stream.on('data', (data) => {
        log += data;
        const found = /listening on (http:\/\/127\.0\.0\.1:\d+)/.exec(log);
        if (found) resolve(found[1]);
      });
    }
    server.on('exit', () => reject(new Error(`the editor does not start: ${log}`)));
  });
  return { server, address: `${address}/?folder=${encodeURIComponent(shaders)}` };
}

export async function picture(page, name) {
  if (!process.env.SCREENSHOTS) return;
  await page.screenshot({ path: path.join(process.env.SCREENSHOTS, `${kind}-${name}.png`), animations: 'disabled' });
}

/** Opens a file and waits for a line with the text, because the tab appears before its content. */
export async function openFile(page, name, text) {
  await page.locator('.explorer-folders-view .monaco-list-row', { hasText: name }).dblclick();
  await page.locator('.tab.active', { hasText: name }).waitFor();
  await page.locator('.view-line', { hasText: text }).first().waitFor();
}

/** Chooses an item of the open list by clicking: the focus may still move, so Enter is unreliable. */
export async function choose(page, title, timeout = 0) {
  await page.locator('.quick-input-list .monaco-list-row', { hasText: title }).first().click({ timeout });
}

/** Runs a command by name. If the list loses focus and closes, it is opened again. */
export async function runCommand(page, title) {
  await until(page, `the command ${title}`, async (timeout) => {
    await page.keyboard.press('F1');
    await page.locator('.quick-input-widget input[type=text]').fill(`>${title}`, { timeout });
    await choose(page, title, timeout);
    return true;
  });
}

/** What is not there yet. */
let missing = '';
process.on('exit', () => {
  if (missing) console.log(`not there: ${missing}`);
});

/**
 * Repeats until the promise resolves. An attempt that hangs is aborted after a timeout that grows with
 * each attempt.
 * @param {(timeout: number) => Promise<any>} ask
 */
export async function until(page, what, ask) {
  missing = what;
  for (let timeout = 2000; ; timeout *= 1.5) {
    const answer = await ask(timeout).catch(() => null);
    if (answer) {
      missing = '';
      return answer;
    }
    await frames(page, 12).catch(() => null);
  }
}

/** The frame of the preview page whose shader contains a text. */
export function player(page, text) {
  const holds = (wanted) => {
    const player = globalThis.shaderport?.player;
    const isShown = globalThis.frameElement?.className === '';
    return Boolean(player && isShown && player.clock.time > 0.3 && player.project.files.some((f) => f.text.includes(wanted)));
  };
  return until(page, `a page with ${text}`, async () => {
    for (const frame of page.frames()) {
      if (await frame.evaluate(holds, text).catch(() => false)) return frame;
    }
    return null;
  });
}

export const time = (frame) => frame.evaluate(() => globalThis.shaderport.player.clock.time);

/** A word in the first line of the editor that contains a text. */
export function word(page, line, text) {
  return page.locator('.view-line', { hasText: line }).first().getByText(text, { exact: true }).first();
}
