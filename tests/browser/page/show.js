// Shared by the tests of the page.
import { randomUUID } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { folder, open, port, put } from '../browser.js';

export const MOVING = `#define SPEED 1.0 // Tunable: how fast it moves (0.3~4.0)
#define STRIPES 4 // Tunable: stripes (1~9)
void mainImage(out vec4 O, vec2 U) {
  vec2 p = U / iResolution.xy;
  O = vec4(fract(p * float(STRIPES) + iTime * SPEED), 0.2, 1.0);
  if (distance(U, iMouse.xy) < 8.0 && iMouse.z > 0.0) O = vec4(1.0);
}
`;

export const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };
export const desk = { viewport: { width: 1000, height: 600 } };

/** Opens a page for the code; resolves to it. */
export async function show(context, name, code, hash = '', ...args) {
  const text = typeof code === 'string' ? code : JSON.stringify(code);
  const file = put(`${name}.${typeof code === 'string' ? 'glsl' : 'json'}`, text);
  const opened = await open(context, await port(file, name, ...args), hash);
  await opened.page.evaluate(() => {
    const notices = document.querySelector('#notices');
    globalThis.noticed = [];
    new MutationObserver(() => globalThis.noticed.push(notices.textContent)).observe(notices, { childList: true, subtree: true });
  });
  await opened.page.evaluate(() => globalThis.shaderport.ready);
  return opened;
}

export const time = (page) => page.evaluate(() => globalThis.shaderport.player.clock.time);
export const playing = (page) => page.evaluate(() => globalThis.shaderport.player.isPlaying);

/** Waits until the page shows a notice that contains some words; notices may be gone before one looks. */
export const noticed = (page, words) =>
  page.waitForFunction((w) => globalThis.noticed.some((text) => text.includes(w)), words);

/** Opens the panel at one of its tabs. */
export async function openTab(page, name) {
  if (!(await page.isVisible('#panel'))) await page.click('#more');
  await page.click(`#tabs button:text-is("${name}")`);
}

/** The content of a download. */
export async function saved(download) {
  const file = path.join(folder(), `${randomUUID()}.download`);
  await download.saveAs(file);
  return fs.readFileSync(file);
}

/** An image with four colours, as a PNG that the browser encodes. */
export function picture(page) {
  return page.evaluate(() => {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 2;
    const to = canvas.getContext('2d');
    ['#f00', '#0f0', '#00f', '#fff'].forEach((color, i) => {
      to.fillStyle = color;
      to.fillRect(i % 2, i >> 1, 1, 1);
    });
    return canvas.toDataURL().split(',')[1];
  });
}

/** Drops a file on an element. */
export function drop(page, selector, { name, type, base64 }) {
  return page.evaluate((file) => {
    const bytes = Uint8Array.from(atob(file.base64), (c) => c.charCodeAt(0));
    const files = new DataTransfer();
    files.items.add(new File([bytes], file.name, { type: file.type }));
    const event = new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true });
    document.querySelector(file.selector).dispatchEvent(event);
  }, { selector, name, type, base64 });
}
