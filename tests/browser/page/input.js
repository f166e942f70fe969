// Touch and keyboard input.
import assert from 'node:assert/strict';
import { frames, pixels } from '../browser.js';
import { desk, MOVING, phone, playing, show, time } from './show.js';

const mouse = (page) => page.evaluate(() => globalThis.shaderport.player.mouse.value());

async function fingers(context) {
  const { page } = await show(context, 'fingers', MOVING, '#paused');
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([id, x, y]) => ({ id, x, y })) });
  const height = await page.evaluate(() => document.querySelector('canvas').clientHeight);
  await touch('touchStart', [1, 100, 200]);
  await touch('touchMove', [1, 120, 210]);
  await touch('touchStart', [1, 120, 210], [2, 300, 50]);
  await touch('touchMove', [1, 120, 210], [2, 310, 60]);
  await frames(page);
  assert.deepEqual((await mouse(page)).slice(0, 3), [120, height - 210, 100], 'the second finger is ignored');
  await touch('touchMove', [1, 121, 210]);
  await page.waitForFunction(() => globalThis.shaderport.player.mouse.value()[0] === 121);
  assert.ok((await mouse(page))[2] > 0, 'lifting it does not end the first one');
  await touch('touchEnd');
  await page.waitForFunction(() => globalThis.shaderport.player.mouse.value()[2] < 0);
}

async function lostCapture(context) {
  const { page } = await show(context, 'capture_lost', MOVING, '#paused');
  await page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    canvas.addEventListener('gotpointercapture', () => (canvas.dataset.held = 'yes'));
  });
  await page.mouse.move(200, 200);
  await page.mouse.down();
  assert.ok((await mouse(page))[2] > 0);
  // If it is released before the browser has granted the capture, no lostpointercapture event fires.
  await page.mouse.move(201, 201);
  await page.waitForSelector('canvas[data-held]');
  await page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    for (let id = 0; id < 10; id++) if (canvas.hasPointerCapture(id)) canvas.releasePointerCapture(id);
  });
  await page.mouse.move(220, 210);
  await page.waitForFunction(() => globalThis.shaderport.player.mouse.value()[2] < 0);
  await page.mouse.up();
}

async function shortcuts(context) {
  const { page } = await show(context, 'shortcuts', MOVING, '#size=64x36&t=2&paused');
  await page.click('canvas');
  await page.keyboard.press(' ');
  assert.ok(await playing(page), 'space toggles playback, also with the focus on the canvas');
  await page.keyboard.press(' ');
  assert.ok(!(await playing(page)));
  await page.evaluate(() => globalThis.shaderport.seek(2));
  const before = await pixels(page);
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await time(page)) - 2 - 1 / 60) < 1e-9, 'one frame forward');
  assert.notDeepEqual(await pixels(page), before);
  await page.keyboard.press('ArrowLeft');
  assert.ok(Math.abs((await time(page)) - 2) < 1e-9, 'one frame back');
  await page.keyboard.press(' ');
  await page.keyboard.press('ArrowRight');
  assert.ok((await time(page)) >= 7, 'five seconds forward');
  await page.evaluate(() => globalThis.shaderport.seek(1e6));
  await page.keyboard.press('r');
  assert.ok((await time(page)) < 1e6, 'restart');
  const [shot] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  assert.match(shot.suggestedFilename(), /^shortcuts-[\d.]+s\.png$/);
  await page.keyboard.press('?');
  assert.match(await page.textContent('#keys'), /space.*Play or pause.*Full screen/);
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#keys')));
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement !== null);
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement === null);
}

async function keysOfTheShader(context) {
  const code = 'void mainImage(out vec4 O, vec2 U) { O = vec4(texelFetch(iChannel0, ivec2(32, 0), 0).x); }';
  const { page } = await show(context, 'own_keys', code, '#size=32x18&paused', '--channel', '0=keyboard');
  assert.match(await page.textContent('#notices'), /use space/);
  await page.focus('canvas');
  await page.keyboard.down(' ');
  assert.equal((await pixels(page))[0], 255, 'the key goes to the shader');
  assert.ok(!(await playing(page)));
  await page.keyboard.up(' ');
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press(' ');
  assert.ok(await playing(page), 'elsewhere it goes to the page');
  await page.keyboard.press('?');
  assert.match(await page.textContent('#keys'), /reads the keyboard/);
}

export const inputTests = [
  { name: 'page: a second finger is not the mouse', run: fingers, context: phone },
  { name: 'page: a lost pointer is released', run: lostCapture, context: desk },
  { name: 'page: shortcuts control the player', run: shortcuts, context: desk },
  { name: 'page: keys go to a shader that reads them', run: keysOfTheShader, context: desk },
];
