// Files for channels.
import assert from 'node:assert/strict';
import { frames, pixels } from '../browser.js';
import { shader } from '../cases.js';
import { desk, drop, noticed, openTab, picture, show } from './show.js';

const READER = 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U / iResolution.xy); }';
const png = async (page, name) => ({ name, type: 'image/png', base64: await picture(page) });

async function missing(context) {
  const { page } = await show(context, 'missing', READER, '#size=32x32&paused', '--no-stand-ins');
  assert.match(await page.textContent('#notices'), /iChannel0 has no texture: drop a file here/);
  await openTab(page, 'Controls');
  assert.match(await page.textContent('#channels'), /Image iChannel0texture \(missing\)/);
  await drop(page, '#picture', { name: 'notes.txt', type: 'text/plain', base64: btoa('hello') });
  await noticed(page, 'notes.txt is not an image');
  await drop(page, '#picture', { name: 'bad.png', type: 'image/png', base64: btoa('hello') });
  await noticed(page, 'Cannot read bad.png as a texture');
  await drop(page, '#picture', await png(page, 'four.png'));
  await page.waitForFunction(() => document.querySelector('#channels').textContent.includes('four.png'));
  assert.ok(!(await page.textContent('#notices')).includes('drop a file'), 'nothing is missing any more');
  assert.notEqual(Math.max(...(await pixels(page)).filter((_, i) => i % 4 === 0)), 0);
}

/** A channel that an export leaves empty is also empty on ShaderToy. */
async function leftEmpty(context) {
  const toy = shader({ type: 'image', name: 'Image', outputs: [], inputs: [], code: READER });
  const { page } = await show(context, 'left_empty', toy, '#size=32x32&paused');
  assert.equal(await page.textContent('#notices'), '');
  await drop(page, '#picture', await png(page, 'four.png'));
  await noticed(page, 'four.png loaded into iChannel0');
}

async function onARow(context) {
  const input = (channel) => ({ id: `x${channel}`, type: 'texture', channel, sampler: { filter: 'nearest', wrap: 'clamp', vflip: 'true' } });
  const toy = shader({
    type: 'image', name: 'Image', outputs: [], inputs: [input(0), input(1)],
    code: 'void mainImage(out vec4 O, vec2 U) { O = texture(iChannel0, U) + texture(iChannel1, U / iResolution.xy); }',
  });
  const { page } = await show(context, 'rows', toy, '#size=32x32&paused');
  await openTab(page, 'Controls');
  const rows = page.locator('.channel');
  const count = await rows.count();
  assert.equal(count, 2);
  await drop(page, '.channel:last-of-type', await png(page, 'second.png'));
  await page.waitForFunction(() => [...document.querySelectorAll('.channel')].at(-1).textContent.includes('second.png'));
  assert.ok(!(await rows.first().textContent()).includes('second.png'), 'only the row of the channel is renamed');
  assert.ok(await page.evaluate(() => globalThis.shaderport.player.inputs[0][1].isLoaded));
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), rows.first().locator('button').click()]);
  await chooser.setFiles({ name: 'first.png', mimeType: 'image/png', buffer: Buffer.from(await picture(page), 'base64') });
  await page.waitForFunction(() => document.querySelector('.channel').textContent.includes('first.png'));
}

async function dismissed(context) {
  const { page } = await show(context, 'dismissed', READER, '#size=32x32&paused', '--no-stand-ins');
  await page.click('.notice [aria-label=Dismiss]');
  assert.equal(await page.textContent('#notices'), '');
  await page.evaluate(() => globalThis.shaderport.player.setSound(false));
  await frames(page);
  assert.equal(await page.textContent('#notices'), '', 'the notice does not reappear');
}

async function standIn(context) {
  const { page } = await show(context, 'stand_in', READER, '#size=32x32&paused');
  assert.equal(await page.textContent('#notices'), '', 'a channel with a stand-in is not missing');
  await openTab(page, 'Controls');
  assert.match(await page.textContent('.channel'), /stand-in for/);
}

async function unread(context) {
  const { page } = await show(context, 'unread', 'void mainImage(out vec4 O, vec2 U) { O = vec4(1.0); }', '#size=32x32&paused');
  assert.equal(await page.textContent('#notices'), '');
  assert.equal(await page.locator('.channel').count(), 0, 'unused channels are not listed');
}

export const mediaTests = [
  { name: 'page: missing files are reported on the canvas', run: missing, context: desk },
  { name: 'page: empty channels of an export are not missing', run: leftEmpty, context: desk },
  { name: 'page: a file dropped on a row fills its channel', run: onARow, context: desk },
  { name: 'page: a dismissed notice does not reappear', run: dismissed, context: desk },
  { name: 'page: a stand-in is labelled', run: standIn, context: desk },
  { name: 'page: no notice if nothing is missing', run: unread, context: desk },
];
