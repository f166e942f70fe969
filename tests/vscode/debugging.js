// Tests the debugger of the extension: F5, steps in both directions, breakpoints, values, images, and editing
// while a pixel is debugged.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { openFile, picture, player, runCommand, shaders, until, word } from './workbench.js';

const MARCH = `struct Hit {
    float way;
    vec3 at;
};

float field(vec3 p) {
    float ball = 0.5 * (length(p) - 1.0);
    return ball;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 ray = normalize(vec3(uv, 1.5));
    Hit hit = Hit(0.0, vec3(0.0, 0.0, -3.0));
    for (int i = 0; i < 24; i++) {
        float d = field(hit.at);
        if (d < 0.001) break;
        hit.way += d;
        hit.at += ray * d;
    }
    vec3 tint = vec3(0.9, 0.6, 0.3);
    vec3 sky = vec3(0.1, 0.2, 0.4);
    vec3 color = hit.way < 5.0 ? tint * (0.5 + 0.5 * hit.at.y) : sky;
    fragColor = vec4(color, 1.0);
}
`;

/** The files that the steps open. */
export const DEBUGGED = { 'march.glsl': MARCH };

const toolbar = (page, title) => page.locator('.debug-toolbar .action-label:not(.disabled)', { hasText: title })
  .or(page.locator(`.debug-toolbar [aria-label^="${title}"]:not(.disabled)`)).first();

/** The function and the line of the selected frame, such as `mainImage 12`. */
const place = (page) => page.locator('.debug-call-stack .stack-frame').first().evaluate((row) => {
  const text = (name) => row.querySelector(name)?.textContent ?? '';
  return `${text('.label')} ${/^\d+/.exec(text('.line-number'))?.[0] ?? ''}`;
}, { timeout: 1000 });
const stopped = (page, expected) => until(page, `a stop at ${expected}`, async () => {
  const isPlace = await place(page) === expected;
  return isPlace && await toolbar(page, 'Continue').isVisible();
});

/** Presses a key, and waits for the stop after it. */
async function press(page, key, expected) {
  await page.keyboard.press(key);
  await stopped(page, expected);
}

async function click(page, title, expected) {
  await toolbar(page, title).click();
  await stopped(page, expected);
}

/** The text of a variable in the view. */
const variable = (page, name) => page.locator('.debug-variables .monaco-list-row', { has: page.locator('.name', { hasText: new RegExp(`^${name}:?`) }) }).first();
const shows = (page, name, value) => variable(page, name).locator('.value', { hasText: value }).waitFor();

/** Clicks an item of the menu of a row. */
async function menu(page, row, title) {
  await until(page, `the menu with ${title}`, async (timeout) => {
    await page.keyboard.press('Escape');
    await row.click({ button: 'right', timeout });
    await page.locator('.monaco-menu .action-label', { hasText: title }).first().click({ timeout });
    return true;
  });
}

/** The frame of a view that has an element. */
const view = (page, selector) => until(page, `a view with ${selector}`, async () => {
  for (const frame of page.frames()) {
    if (await frame.locator(selector).first().isVisible().catch(() => false)) return frame;
  }
  return null;
});

/** Ends the session, and shows the files again. */
async function stop(page) {
  await page.keyboard.press('Shift+F5');
  await page.locator('.debug-toolbar').waitFor({ state: 'hidden' });
  await runCommand(page, 'View: Show Explorer');
}

/** From F5, without a launch.json, to the end. */
async function debugged(page) {
  await runCommand(page, 'View: Close All Editors');
  await openFile(page, 'march.glsl', 'struct Hit');
  await page.locator('.view-line', { hasText: 'vec2 uv' }).click();
  const before = Date.now();
  await page.keyboard.press('F5');
  await page.locator('.debug-top-stack-frame-line, .debug-top-stack-frame-column').first().waitFor();
  console.log(`from F5 to the first stop: ${Date.now() - before} ms`);
  await stopped(page, 'mainImage 12');
  await shows(page, 'fragCoord', 'vec2(160.5, 90.5)');
  await picture(page, 'debug-1-entry');

  await press(page, 'F10', 'mainImage 13');
  await press(page, 'F10', 'mainImage 14');
  await press(page, 'F10', 'mainImage 15');
  await shows(page, 'ray', 'vec3(');
  await picture(page, 'debug-2-steps');

  // A breakpoint by a click beside the line, where no costs are now.
  await until(page, 'a gutter without costs', async () => await page.evaluate(() => {
    const all = [...globalThis.document.querySelectorAll('.glyph-margin-widgets > *')];
    return all.every((node) => !globalThis.getComputedStyle(node).backgroundImage.includes('svg'));
  }));
  const line = await page.locator('.view-line', { hasText: 'hit.way += d;' }).boundingBox();
  const arrow = await page.locator('.glyph-margin-widgets .codicon-debug-stackframe').first().boundingBox();
  await page.mouse.move(arrow.x + arrow.width / 2, line.y + line.height / 2);
  await page.mouse.click(arrow.x + arrow.width / 2, line.y + line.height / 2);
  await page.locator('.glyph-margin-widgets .codicon-debug-breakpoint').first().waitFor();
  await press(page, 'F5', 'mainImage 18');
  await press(page, 'F5', 'mainImage 18');
  await shows(page, 'i', '1');
  await picture(page, 'debug-3-breakpoint');
  await click(page, 'Step Back', 'mainImage 17');
  await click(page, 'Reverse', 'mainImage 18');
  await shows(page, 'i', '0');
  await picture(page, 'debug-4-back');
}

/** Iterations, calls, and where a value was written. */
async function moves(page) {
  await press(page, 'F9', 'mainImage 18');
  await click(page, 'Next Iteration', 'mainImage 15');
  await press(page, 'F11', 'mainImage 16');
  await press(page, 'F11', 'field 7');
  await picture(page, 'debug-5-call');
  await press(page, 'Shift+F11', 'mainImage 16');
  await click(page, 'Step Back In', 'field 8');
  await press(page, 'Shift+F11', 'mainImage 16');
  await menu(page, variable(page, 'hit'), 'Go to Where It Was Written');
  await stopped(page, 'mainImage 19');
  await picture(page, 'debug-6-written');
}

/** Watches, and a value over the screen whose click chooses a pixel. */
async function values(page) {
  // The empty view takes a double click.
  await page.locator('.debug-watch').dblclick();
  await page.locator('.debug-watch input, .debug-watch textarea').first().waitFor();
  await page.keyboard.type('length(hit.at)');
  await page.keyboard.press('Enter');
  const watch = page.locator('.debug-watch .monaco-list-row', { hasText: 'length(hit.at)' });
  await watch.locator('.value', { hasText: /\d\.\d/ }).waitFor();
  await picture(page, 'debug-7-watch');
  await menu(page, variable(page, 'ray'), 'Show Value over the Screen');
  const frame = await view(page, 'img');
  await frame.locator('.expression', { hasText: 'ray' }).waitFor();
  await menu(page, watch, 'Show Value over the Screen');
  await frame.locator('section').nth(1).locator('img').waitFor();
  await picture(page, 'debug-8-images');
  const image = frame.locator('img').first();
  const box = await image.boundingBox();
  // A legend may be below the 180 rows.
  const height = await image.evaluate((node) => node.naturalHeight);
  await image.click({ position: { x: box.width * (40.5 / 320), y: box.height * (159.5 / height) } });
  await shows(page, 'fragCoord', 'vec2(40.5, 20.5)');
  await frame.locator('p', { hasText: 'pixel 40, 20' }).first().waitFor();
  await picture(page, 'debug-9-pixel');
  await runCommand(page, 'Shaderlint: Choose Pixel');
  await page.locator('.quick-input-widget input[type=text]').fill('160, 91, 2.5');
  await page.keyboard.press('Enter');
  await shows(page, 'fragCoord', 'vec2(160.5, 91.5)');
}

/** An edited program is read again at the same place, and the session ends. */
async function edited(page) {
  await page.locator('.view-line', { hasText: 'vec3 tint' }).click();
  await runCommand(page, 'Debug: Run to Cursor');
  await stopped(page, 'mainImage 21');
  await press(page, 'F10', 'mainImage 22');
  await press(page, 'F10', 'mainImage 23');
  await shows(page, 'tint', 'vec3(0.9, 0.6, 0.3)');
  await picture(page, 'debug-10-colors');
  await word(page, 'vec3 tint', '0.6').dblclick();
  await page.keyboard.press('End');
  for (let i = 0; i < ', 0.3);'.length; i++) await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Backspace');
  await page.keyboard.type('1');
  await page.keyboard.press('Control+KeyS');
  await shows(page, 'tint', 'vec3(0.9, 0.1, 0.3)');
  assert.equal(await place(page), 'mainImage 23');
  await picture(page, 'debug-11-edited');
  await stop(page);
  await until(page, 'no view of values', async () => await page.locator('.tab', { hasText: 'Values over' }).count() === 0);
  fs.writeFileSync(path.join(shaders, 'march.glsl'), MARCH);
}

/** A pixel of the preview. */
async function fromPreview(page) {
  await openFile(page, 'march.glsl', 'struct Hit');
  await runCommand(page, 'Shaderlint: Open Preview');
  const frame = await player(page, 'struct Hit');
  const canvas = frame.locator('canvas').first();
  const box = await canvas.boundingBox();
  // The debug console makes it smaller.
  const y = await frame.evaluate(() => globalThis.shaderport.player.canvas.height);
  await canvas.click({ modifiers: ['Alt'], position: { x: box.width / 2, y: box.height / 4 } });
  await stopped(page, 'mainImage 12');
  const text = await variable(page, 'fragCoord').locator('.value').textContent();
  const row = Number(/, ([\d.]+)\)/.exec(text)?.[1]);
  assert(Math.abs(row - 0.75 * y) < 3, `row ${row} of ${y}`);
  await picture(page, 'debug-12-preview');
  await stop(page);
}

/** The steps, in their order. */
export const debugging = {
  'F5 stops at the entry, and breakpoints stop': debugged,
  'steps over iterations, into calls and back to writes': moves,
  'watches and images of values': values,
  'an edited program stays at its place': edited,
  'a pixel of the preview is debugged': fromPreview,
};
