// Tests the extension in an editor in a headless browser: diagnostics of a broken shader, and the
// preview, which follows edits.
//
//   node editor.js FOLDER program    with the package for this platform, which is in FOLDER; the editor
//                                    writes its files there
//   node editor.js FOLDER web        with the package for browsers
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { after, test } from 'node:test';
import { launch } from '../browser/browser.js';
import { DEBUGGED, debugging } from './debugging.js';
import { FILES, views } from './views.js';
import { args, choose, kind, openFile, packages, picture, player, program, runCommand, settings, shaders, start, time, until, word } from './workbench.js';

const isWeb = kind === 'web';
/** Time limit in minutes. Each step waits for its own condition, however slow the machine is. */
const MINUTES = Number(process.env.MINUTES ?? 60);

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
// A file that is not open, and one that includes it.
const TINT = 'vec3 tint(float x) {\n    return vec3(x, 0.5, 1.0 - x);\n}\n';
const TINTED = `#include "tint.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(tint(fragCoord.x / iResolution.x), 1.0);
}
`;
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

function prepare() {
  fs.mkdirSync(shaders, { recursive: true });
  fs.writeFileSync(path.join(shaders, 'broken.glsl'), BROKEN);
  fs.writeFileSync(path.join(shaders, 'waves.glsl'), WAVES);
  fs.writeFileSync(path.join(shaders, 'glow.glsl'), GLOW);
  fs.writeFileSync(path.join(shaders, 'scene.js'), PAGE);
  for (const [name, text] of Object.entries({ ...FILES, ...DEBUGGED })) fs.writeFileSync(path.join(shaders, name), text);
  fs.writeFileSync(path.join(shaders, 'tint.glsl'), TINT);
  fs.writeFileSync(path.join(shaders, 'useit.glsl'), TINTED);
  fs.mkdirSync(path.dirname(settings), { recursive: true });
  fs.writeFileSync(settings, JSON.stringify(SETTINGS));
  const isWanted = (name) => name.endsWith('.vsix') && name.includes('-web-') === isWeb;
  const [extension] = fs.readdirSync(packages).filter(isWanted);
  execFileSync(program, args('--install-extension', path.join(packages, extension)), { stdio: 'pipe' });
}

/**
 * Opens the editor and a broken shader. Window and extension host have fixed timeouts for each other;
 * if they expire, the window is reloaded.
 */
async function connect(page, address) {
  await until(page, 'an editor with the extension', async (timeout) => {
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

/** Diagnostics of a broken shader. */
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

  // A change is shown, and the time continues.
  const before = await time(first);
  await page.locator('.view-line', { hasText: 'Waves in two' }).click();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('// The end.');
  const second = await player(page, '// The end.');
  assert((await time(second)) >= before, 'the time went back');

  // A broken text keeps the image and shows the error.
  await page.keyboard.type(' \n}');
  const words = await until(page, 'an error message', async () => {
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
  await page.keyboard.type('// Fixed.');

  // A slider changes the number in the code.
  const third = await player(page, '// Fixed.');
  await third.evaluate(() => globalThis.shaderport.player.setTunable('SPEED', 3));
  await third.evaluate(() => globalThis.dispatchEvent(new Event('input')));
  await third.locator('#more').click();
  await picture(page, 'preview-numbers');
  const shell = third.parentFrame();
  await shell.locator('#write button').click();
  await page.locator('.view-line', { hasText: 'SPEED' }).filter({ hasText: '3.0' }).waitFor();
  const fourth = await player(page, 'SPEED 3.0');
  assert(await fourth.locator('#panel').isVisible(), 'the panel was open');

  // The code lens above the number asks for another value.
  await page.locator('.codelens-decoration a', { hasText: '0 … 4' }).click();
  const box = page.locator('.quick-input-widget input[type=text]');
  await box.fill('9');
  await page.locator('.quick-input-message', { hasText: 'Must be between 0 and 4' }).waitFor();
  await box.fill('1');
  await page.keyboard.press('Enter');
  await player(page, 'SPEED 1.0');
}

/** Responses of the server while editing. */
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

  await until(page, 'a hover with an image', async (timeout) => {
    await word(page, 'light +=', 'light').hover({ timeout });
    await page.locator('.monaco-hover img').first().waitFor({ timeout });
    return true;
  });
  await picture(page, 'hover');

  await page.locator('.view-line', { hasText: 'level = 1.0;' }).click();
  await page.keyboard.press('End');
  await page.keyboard.type('\nfloat s=smooths');
  // Fast typing may not open the list.
  await until(page, 'a completion', async (timeout) => {
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

/** A shader that was never valid. */
async function hopeless(page) {
  await openFile(page, 'broken.glsl', 'colour');
  await runCommand(page, 'Shaderlint: Open Preview');
  await page.locator('.tab.active', { hasText: 'Preview broken.glsl' }).waitFor();
  await until(page, 'the error message in the preview', async () => {
    for (const frame of page.frames()) {
      // Either the view or the page in it shows the message.
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
  await until(page, 'the cost map', async () => {
    for (const frame of page.frames()) {
      if (await frame.evaluate(() => document.querySelector('img[src^="data:image/png"]')?.naturalWidth > 0)) return true;
    }
    return false;
  });
  await picture(page, 'cost-map');
}

/** A file that is included and not open. */
async function included(page) {
  await openFile(page, 'useit.glsl', 'tint.glsl');
  await until(page, 'the definition in another file', async (timeout) => {
    await word(page, 'fragColor = vec4', 'tint').click({ timeout });
    await page.keyboard.press('F12');
    await page.locator('.tab.active', { hasText: 'tint.glsl' }).waitFor({ timeout });
    return true;
  });
  await picture(page, 'included');
}

/** In the browser there is no command that needs the program. */
async function commands(page) {
  await page.keyboard.press('F1');
  await page.locator('.quick-input-widget input[type=text]').fill('>Shaderlint: ');
  const rows = page.locator('.quick-input-list .monaco-list-row');
  await rows.filter({ hasText: 'Restart Language Server' }).waitFor();
  assert.equal(await rows.filter({ hasText: 'Cost Map' }).count(), 0);
  await picture(page, 'commands');
  await page.keyboard.press('Escape');
}

prepare();
const { server, address } = await start();
const { browser, kill } = await launch();
const page = await browser.newPage({ viewport: { width: 1400, height: 860 } });
page.setDefaultTimeout(0);

/** Each step begins with the state that the one before it left. */
const STEPS = {
  'the editor starts with the extension': () => connect(page, address),
  'a broken shader has diagnostics': findings,
  'the preview follows edits and writes numbers': preview,
  'fixes, renames, formats, hovers and completions': editing,
  'a definition in a file that is not open': included,
  ...(isWeb ? { 'no command needs the program': commands } : { 'the cost map is drawn': costMap, ...views, ...debugging }),
  'a shader that was never valid has a message in its preview': hopeless,
};

test(`extension, ${kind}`, { timeout: MINUTES * 60_000 }, async (t) => {
  let skip = '';
  for (const [name, step] of Object.entries(STEPS)) {
    await t.test(name, { skip }, async () => {
      try {
        await step(page);
      } catch (error) {
        skip = 'an earlier step failed';
        await picture(page, 'failed').catch(() => {});
        throw error;
      }
    });
  }
});

after(async () => {
  await kill();
  // A graceful shutdown would wait half a minute for the browser to reconnect.
  process.kill(-server.pid, 'SIGKILL');
});
