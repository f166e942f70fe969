// The package in an editor, in a browser without a window: what it says of a broken shader, and the
// preview, which follows what is typed.
//
//   node editor.js FOLDER    FOLDER holds shaderlint.vsix, and gets whatever the editor writes
import { chromium } from 'playwright-core';
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const work = process.argv[2];
const program = process.env.CODE_SERVER;
/** Minutes that all of it may take. Each step waits for what it needs, however slow the machine is. */
const MINUTES = Number(process.env.MINUTES ?? 60);

/** What is waited for. */
let waiting = '';

const BROKEN = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float wave = sin(uv.x * 20.0 + iTime) * 0.5 + "a";
    fragColor = vec4(vec3(wave), 1);
    colour = 2.0;
}
`;
const WAVES = `// Waves in two colours.
#define SPEED 2.0 // how fast (0~4)

vec3 paint(vec2 uv, float phase) {
    float wave = 0.5 + 0.5 * sin(20.0 * length(uv) - SPEED * iTime + phase);
    return mix(vec3(0.1, 0.2, 0.5), vec3(1.0, 0.7, 0.2), wave);
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    fragColor = vec4(paint(uv, 0.0), 1.0);
}
`;
const GLOW = `void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv=fragCoord/iResolution.xy;
    float glow = 0.0;
    for (int i = 0; i < 40; i++) {
        if (float(i) > uv.x * 40.0 * (0.5 + 0.5 * sin(6.0 * uv.y))) break;
        glow += 0.02;
    }
    float level = 1;
    fragColor = vec4(vec3(glow * level), 1.0);
}
`;
const PAGE = `// A shader inside of a script.
export const fragment = /* glsl */ \`#version 300 es
precision highp float;
out vec4 color;
void main() {
    color = vec3(1.0);
}
\`;
`;
// What names a program belongs to the machine that the program runs on, which is not the browser's.
const MACHINE_SETTINGS = {
  // The editor takes PATH from the user's shell.
  'shaderlint.path': process.env.SHADERLINT,
};
const SETTINGS = {
  'workbench.startupEditor': 'none',
  'workbench.tips.enabled': false,
  'security.workspace.trust.enabled': false,
  'telemetry.telemetryLevel': 'off',
  'extensions.autoCheckUpdates': false,
  'chat.disableAIFeatures': true,
  'workbench.secondarySideBar.defaultVisibility': 'hidden',
  'editor.minimap.enabled': false,
  '[glsl]': { 'editor.formatOnSave': true },
};

/** What the editor is told on the command line. */
function args(...more) {
  const folders = ['--user-data-dir', path.join(work, 'user'), '--extensions-dir', path.join(work, 'extensions')];
  return [...folders, '--config', path.join(work, 'none.yaml'), ...more];
}

function prepare() {
  const shaders = path.join(work, 'shaders');
  fs.mkdirSync(shaders, { recursive: true });
  fs.writeFileSync(path.join(shaders, 'broken.glsl'), BROKEN);
  fs.writeFileSync(path.join(shaders, 'waves.glsl'), WAVES);
  fs.writeFileSync(path.join(shaders, 'glow.glsl'), GLOW);
  fs.writeFileSync(path.join(shaders, 'scene.js'), PAGE);
  for (const [folder, settings] of [['User', SETTINGS], ['Machine', MACHINE_SETTINGS]]) {
    fs.mkdirSync(path.join(work, 'user', folder), { recursive: true });
    fs.writeFileSync(path.join(work, 'user', folder, 'settings.json'), JSON.stringify(settings));
  }
  execFileSync(program, args('--install-extension', path.join(work, 'shaderlint.vsix')), { stdio: 'pipe' });
  return shaders;
}

/** Starts the editor at a port that the system chooses; gives its address when it listens. */
async function start(shaders) {
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

async function picture(page, name) {
  if (!process.env.SCREENSHOTS) return;
  await page.waitForTimeout(1000);
  await page.screenshot({ path: path.join(process.env.SCREENSHOTS, `${name}.png`) });
}

/** Opens a file, of which a line holds a text: the tab is there before the text is. */
async function openFile(page, name, text) {
  await page.locator('.explorer-folders-view .monaco-list-row', { hasText: name }).dblclick();
  await page.locator('.tab.active', { hasText: name }).waitFor();
  await page.locator('.view-line', { hasText: text }).first().waitFor();
}

/** Chooses from the list that is open. Enter would take what has the focus, which may still move. */
async function choose(page, title, timeout = 0) {
  await page.locator('.quick-input-list .monaco-list-row', { hasText: title }).first().click({ timeout });
}

/** Runs a command by its name. What takes the focus late closes the list, which is opened again then. */
async function runCommand(page, title) {
  await until(`the command ${title}`, async (timeout) => {
    await page.keyboard.press('F1');
    await page.locator('.quick-input-widget input[type=text]').fill(`>${title}`, { timeout });
    await choose(page, title, timeout);
    return true;
  });
}

/**
 * Asks again and again until the answer is there. A try that waits for what does not come is ended after
 * some milliseconds, of which it has more each time.
 * @param {(timeout: number) => Promise<any>} ask
 */
async function until(what, ask) {
  waiting = what;
  for (let timeout = 2000; ; timeout *= 1.5) {
    const answer = await ask(timeout).catch(() => null);
    if (answer) return answer;
    await new Promise((resolve) => {
      setTimeout(resolve, 200);
    });
  }
}

/** The frame of the page that plays: the one whose shader holds a text. */
function player(page, text) {
  const holds = (wanted) => {
    const player = globalThis.shaderport?.player;
    const isShown = globalThis.frameElement?.className === '';
    return Boolean(player && isShown && player.clock.time > 0.3 && player.project.files.some((f) => f.text.includes(wanted)));
  };
  return until(`a page with ${text}`, async () => {
    for (const frame of page.frames()) {
      if (await frame.evaluate(holds, text).catch(() => false)) return frame;
    }
    return null;
  });
}

const time = (frame) => frame.evaluate(() => globalThis.shaderport.player.clock.time);

/**
 * Opens the editor and a broken shader. Window and extensions give each other up after times of their own,
 * which nothing can lengthen: such a window is loaded anew.
 */
async function connect(page, address) {
  await until('an editor with the extension', async (timeout) => {
    page.setDefaultTimeout(30 * timeout);
    try {
      await page.goto(address);
      await openFile(page, 'broken.glsl', 'colour');
      await page.locator('.squiggly-error').first().waitFor();
    } finally {
      page.setDefaultTimeout(0);
    }
    return true;
  });
}

/** What a broken shader looks like. */
async function findings(page) {
  await openFile(page, 'broken.glsl', 'colour');
  await page.locator('.squiggly-error').first().waitFor();
  await page.keyboard.press('Control+Shift+KeyM');
  const rows = page.locator('.markers-panel .monaco-list-row');
  await rows.filter({ hasText: 'colour' }).first().waitFor();
  await picture(page, 'problems');
  await openFile(page, 'scene.js', 'inside of');
  await page.locator('.squiggly-error').first().waitFor();
  await picture(page, 'script');
}

async function preview(page) {
  await openFile(page, 'waves.glsl', 'Waves');
  await runCommand(page, 'Shaderlint: Open Preview');
  const first = await player(page, 'SPEED 2.0');
  await picture(page, 'preview');

  // A change is shown, and time goes on from where it was.
  const before = await time(first);
  await page.locator('.view-line', { hasText: 'Waves in two' }).click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('// The end.');
  const second = await player(page, '// The end.');
  assert((await time(second)) >= before, 'the time went back');

  // A broken text leaves the picture, and says why.
  await page.keyboard.type(' \n}');
  const words = await until('words of trouble', async () => {
    for (const frame of page.frames()) {
      const said = await frame.evaluate(() => document.querySelector('#trouble.error:not([hidden])')?.textContent);
      if (said) return said;
    }
    return null;
  });
  assert((await time(second)) >= before);
  console.log(`the preview says: ${words}`);
  await picture(page, 'preview-trouble');
  await page.keyboard.press('Backspace');
  await page.keyboard.type('// Mended.');

  // A slider is written into the code.
  const third = await player(page, '// Mended.');
  await third.evaluate(() => globalThis.shaderport.player.setTunable('SPEED', 3));
  await third.evaluate(() => globalThis.dispatchEvent(new Event('input')));
  await third.locator('#more').click();
  await picture(page, 'preview-numbers');
  const shell = third.parentFrame();
  await shell.locator('#write button').click();
  await page.locator('.view-line', { hasText: 'SPEED' }).filter({ hasText: '3.0' }).waitFor();
  const fourth = await player(page, 'SPEED 3.0');
  assert(await fourth.locator('#panel').isVisible(), 'the panel was open');

  // The line above the number asks for another one.
  await page.locator('.codelens-decoration a', { hasText: '0 … 4' }).click();
  const box = page.locator('.quick-input-widget input[type=text]');
  await box.fill('9');
  await page.locator('.quick-input-message', { hasText: 'Must be between 0 and 4' }).waitFor();
  await box.fill('1');
  await page.keyboard.press('Enter');
  await player(page, 'SPEED 1.0');
}

/** A word in the first line of the editor that holds a text. */
function word(page, line, text) {
  return page.locator('.view-line', { hasText: line }).first().getByText(text, { exact: true }).first();
}

/** What the server answers while somebody writes. */
async function editing(page) {
  await openFile(page, 'glow.glsl', 'glow');
  await page.locator('.squiggly-error').first().waitFor();
  await word(page, 'level = 1;', '1').click();
  await page.keyboard.press('Control+Period');
  await page.locator('.action-widget .monaco-list-row').first().waitFor();
  await picture(page, 'quick-fix');
  await page.keyboard.press('Enter');
  await page.locator('.view-line', { hasText: 'level = 1.0;' }).waitFor();

  await word(page, 'float glow', 'glow').click();
  await page.keyboard.press('F2');
  await page.locator('.rename-box input').fill('light');
  await picture(page, 'rename');
  await page.keyboard.press('Enter');
  await page.locator('.view-line', { hasText: 'light * level' }).waitFor();

  await runCommand(page, 'Format Document');
  await page.locator('.view-line', { hasText: 'uv = fragCoord / iResolution' }).waitFor();
  await picture(page, 'formatted');

  await until('a hover with a picture', async (timeout) => {
    await word(page, 'light +=', 'light').hover({ timeout });
    await page.locator('.monaco-hover img').first().waitFor({ timeout });
    return true;
  });
  await picture(page, 'hover');

  await page.locator('.view-line', { hasText: 'level = 1.0;' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type('\nfloat s=smooths');
  // What is typed fast may not open the list.
  await until('a completion', async (timeout) => {
    await page.keyboard.press('Escape');
    await page.keyboard.press('Control+Space');
    await page.locator('.suggest-widget .monaco-list-row', { hasText: 'smoothstep' }).first().waitFor({ timeout });
    return true;
  });
  await picture(page, 'completion');
  await page.keyboard.press('Escape');
  for (let i = 0; i < 'smooths'.length; i++) await page.keyboard.press('Backspace');
  await page.keyboard.type('light;');
  await page.keyboard.press('Control+KeyS');
  await page.locator('.view-line', { hasText: 's = light;' }).waitFor();
  await picture(page, 'saved');
}

/** A shader that has never been right. */
async function hopeless(page) {
  await openFile(page, 'broken.glsl', 'colour');
  await runCommand(page, 'Shaderlint: Open Preview');
  await page.locator('.tab.active', { hasText: 'Preview broken.glsl' }).waitFor();
  await until('why there is no picture', async () => {
    for (const frame of page.frames()) {
      // The view says it, or the page in it.
      const words = await frame.evaluate(() => ['trouble', 'errors'].map((id) => document.getElementById(id)?.innerText).join());
      if (words.includes('has no strings')) return true;
    }
    return false;
  });
  await picture(page, 'hopeless');
}

async function costMap(page) {
  await runCommand(page, 'Shaderlint: Show Cost Map');
  await choose(page, 'Operations per pixel');
  await until('the cost map', async () => {
    for (const frame of page.frames()) {
      if (await frame.evaluate(() => document.querySelector('img[src^="data:image/png"]')?.naturalWidth > 0)) return true;
    }
    return false;
  });
  await picture(page, 'cost-map');
}

const { server, address } = await start(prepare());
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  timeout: 0,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
const page = await browser.newPage({ viewport: { width: 1400, height: 860 } });
page.setDefaultTimeout(0);
let current = 'start';
const limit = setTimeout(() => {
  console.error(`more than ${MINUTES} minutes: ${current} is not done${waiting && `, nor has come ${waiting}`}`);
  // What is waited for fails then, and says where.
  void picture(page, 'failed').finally(() => browser.close());
}, MINUTES * 60_000);
try {
  await connect(page, address);
  for (const step of [findings, preview, editing, costMap, hopeless]) {
    current = step.name;
    await step(page);
    console.log(`${step.name}: ok`);
  }
} catch (error) {
  await picture(page, 'failed').catch(() => {});
  throw error;
} finally {
  clearTimeout(limit);
  await browser.close();
  // Asked to end, it would wait half a minute for a browser to come back.
  process.kill(-server.pid, 'SIGKILL');
}
console.log('5 passed, 0 failed');
