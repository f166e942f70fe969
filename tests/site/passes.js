// The passes of a shader in the playground: tabs, one server and one image for all, and links with all of them.
import assert from 'node:assert/strict';
import zlib from 'node:zlib';
import { drawn, findings, linkTo, text, within } from './playground.js';

const image = (color) => `void mainImage(out vec4 c, in vec2 p) {\n    c = ${color};\n}\n`;

/** A link to several files. */
const folder = (files) => linkTo(JSON.stringify(files));

/** The files in the link that the page copies. */
async function shared(page) {
  const before = await page.evaluate(() => location.hash);
  await page.locator('#share').click();
  await page.waitForFunction((old) => location.hash !== old && location.hash.startsWith('#code='), before);
  const data = (await page.evaluate(() => location.hash)).slice('#code='.length);
  return JSON.parse(zlib.inflateRawSync(Buffer.from(data, 'base64url')).toString());
}

const tab = (page, name) => page.getByRole('tab', { name, exact: true });
const isSelected = (page, name) => page.locator('[role=tab][aria-selected=true]', { hasText: name }).waitFor();
const shown = (page) => page.locator('#code .cm-editor:not([hidden]) .cm-content');

/** Adds a pass from the menu. */
async function add(page, name) {
  await page.locator('#add summary').click();
  await page.locator('#add').getByRole('button', { name, exact: true }).click();
  await isSelected(page, name);
}

/** Replaces the text that is shown. */
async function write(page, code) {
  await shown(page).click();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(code);
}

/** Names of Common are known in the others, and its changes matter to them. */
async function common(browser, address) {
  await within(browser, address, { fragment: linkTo(image('tint(p)')), reducedMotion: 'reduce' }, async (page) => {
    await findings(page, { has: ['undeclared-name'], count: 1 });
    await add(page, 'Common');
    await write(page, 'vec4 tint(vec2 p) {\n    return vec4(0.0, 1.0, 0.0, 1.0);\n}\n');
    await findings(page, { lacks: ['undeclared-name'] });
    await drawn(page, [0, 255, 0, 255]);
    await write(page, 'vec4 tint(vec3 p) {\n    return vec4(p, 1.0);\n}\n');
    await findings(page, { has: ['vector-size'] });
    // The finding is in the other pass. It leads there.
    await isSelected(page, 'Common');
    await page.locator('#list li', { hasText: 'vector-size' }).locator('.place', { hasText: 'Image · Line 2' }).click();
    await isSelected(page, 'Image');
    assert.equal(await text(page), image('tint(p)'));
    assert.deepEqual(await page.locator('#code .cm-editor').evaluateAll((all) => all.map((editor) => editor.clientHeight > 0)), [true, false]);
    const name = await page.evaluate(() => document.querySelector('#code').getAttribute('aria-labelledby'));
    assert.equal(await page.locator(`#${name}`).innerText(), 'Image');
    await tab(page, 'Common').click();
    await page.locator('#remove', { hasText: 'Remove Common' }).click();
    await findings(page, { has: ['undeclared-name'], count: 1 });
    assert.equal(await page.getByRole('tab').count(), 1);
  });
}

/** Buffers are drawn, and channels read what somebody says. */
async function buffers(browser, address) {
  const files = {
    'common.glsl': 'const float FULL = 1.0;\n',
    'buffer_a.glsl': image('vec4(FULL, 0.0, 0.0, 1.0)'),
    'buffer_b.glsl': image('vec4(0.0, 0.0, FULL, 1.0)'),
    'image.glsl': image('texture(iChannel1, p / iResolution.xy)'),
    'channels.toml': '[image]\n1 = "buffer_a,nearest"\n',
  };
  await within(browser, address, { fragment: folder(files), reducedMotion: 'reduce' }, async (page) => {
    await findings(page, { count: 0 });
    assert.deepEqual(await page.getByRole('tab').allInnerTexts(), ['Common', 'Buffer A', 'Buffer B', 'Image']);
    await isSelected(page, 'Image');
    await drawn(page, [255, 0, 0, 255]);
    await page.locator('#channels summary').click();
    const channel = page.getByLabel('iChannel1');
    assert.equal(await channel.inputValue(), 'buffer_a');
    await channel.selectOption('Buffer B');
    await drawn(page, [0, 0, 255, 255]);
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#channels summary').evaluate((summary) => summary === document.activeElement));
    assert.deepEqual(await shared(page), { ...files, 'channels.toml': '[image]\n1 = "buffer_b,nearest"\n' });
    // What read a pass that is gone reads what the code decides on.
    await tab(page, 'Buffer B').click();
    await page.locator('#remove').click();
    const rest = await shared(page);
    assert.deepEqual(Object.keys(rest), ['common.glsl', 'buffer_a.glsl', 'image.glsl']);
  });
}

/** A link has all passes, and what is opened from it is the same. */
async function links(browser, address) {
  const files = { 'common.glsl': '#define ONE 1.0\n// é 漢\n', 'sound.glsl': 'vec2 mainSound(in int samp, float time) {\n    return vec2(sin(time));\n}\n', 'image.glsl': image('vec4(ONE)') };
  let fragment = folder(files);
  await within(browser, address, { fragment }, async (page) => {
    await findings(page, { count: 0 });
    await tab(page, 'Sound').click();
    assert.equal(await text(page), files['sound.glsl']);
    assert.equal(await page.locator('#channels').isVisible(), false);
    await page.locator('#code .cm-line', { hasText: 'return' }).click();
    await page.keyboard.press('End');
    await page.keyboard.type(' // x');
    const changed = { ...files, 'sound.glsl': files['sound.glsl'].replace('(time));', '(time)); // x') };
    assert.deepEqual(await shared(page), changed);
    fragment = await page.evaluate(() => location.hash);
  });
  await within(browser, address, { fragment }, async (page) => {
    await findings(page, { count: 0 });
    await tab(page, 'Sound').click();
    assert.equal(await text(page), files['sound.glsl'].replace('(time));', '(time)); // x'));
  });
  // A file whose name matters is not a pass.
  const html = '<script type="x-shader/x-fragment">\nprecision highp float;\nvoid main() {\n    gl_FragColor = vec4(1);\n    gl_FragColor = vec3(1.0);\n}\n</script>\n';
  await within(browser, address, { fragment: folder({ 'page.html': html }) }, async (page) => {
    await findings(page, { has: ['vector-size'] });
    assert.deepEqual(await page.getByRole('tab').allInnerTexts(), ['page.html']);
    assert.equal(await page.locator('#add').isVisible(), false);
  });
  // An export is JSON too.
  const code = image('vec4(p.x * 2, 0.0, 0.0, 1.0)');
  const json = JSON.stringify([{ ver: '0.1', info: { id: 'x', name: 'x' }, renderpass: [{ inputs: [], outputs: [{ id: 37, channel: 0 }], code, name: 'Image', type: 'image' }] }]);
  await within(browser, address, { fragment: linkTo(json) }, async (page) => {
    await findings(page, { has: ['int-float-mix'] });
    assert.deepEqual(await page.getByRole('tab').allInnerTexts(), ['shader.json']);
  });
}

/** Opens a link when the first image is ready to be drawn, and lets it go on when the link is open. */
function openBeforeImage(hash) {
  let isFirst = true;
  window.Worker = class extends Worker {
    set onmessage(handler) {
      super.onmessage = (event) => {
        if (!isFirst || !('errors' in event.data)) return handler.call(this, event);
        isFirst = false;
        new MutationObserver((_, observer) => {
          observer.disconnect();
          handler.call(this, event);
        }).observe(document.querySelector('#passes'), { childList: true, subtree: true });
        location.hash = hash;
        return undefined;
      };
    }
  };
}

/** What is still being drawn of a shader does not appear in the next one. */
async function replacing(browser, address) {
  const init = [openBeforeImage, linkTo(image('vec3(1.0)'))];
  await within(browser, address, { fragment: linkTo(image('vec4(1.0)')), init }, async (page) => {
    await findings(page, { has: ['vector-size'] });
    await page.locator('#image.stale').waitFor();
    assert.equal(await page.locator('#image iframe').count(), 0);
  });
}

/** A name of Common is renamed where it is used. */
async function renaming(browser, address) {
  const files = { 'common.glsl': 'vec4 tint() {\n    return vec4(1.0);\n}\n', 'image.glsl': image('tint()') };
  await within(browser, address, { fragment: folder(files) }, async (page) => {
    await findings(page, { count: 0 });
    await page.locator('#code .cm-editor:not([hidden]) .cm-line', { hasText: 'tint' }).click({ position: { x: 100, y: 8 } });
    await page.keyboard.press('F2');
    await page.locator('#code .cm-lsp-rename-panel input').fill('shade');
    await page.keyboard.press('Enter');
    await page.locator('#code .cm-editor:not([hidden]) .cm-line', { hasText: 'shade()' }).waitFor();
    await tab(page, 'Common').click();
    assert.equal(await text(page), files['common.glsl'].replace('tint', 'shade'));
    await findings(page, { count: 0 });
  });
}

/** Everything about tabs works without a mouse. */
async function keyboard(browser, address) {
  await within(browser, address, { fragment: linkTo(image('vec4(1.0)')) }, async (page) => {
    await findings(page, { count: 0 });
    const focused = () => page.evaluate(() => document.activeElement.textContent);
    await tab(page, 'shader.glsl').focus();
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'Add pass');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'Common');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await isSelected(page, 'Buffer A');
    await page.locator('#code .cm-editor.cm-focused:not([hidden])', { hasText: 'iResolution' }).waitFor();
    await tab(page, 'Buffer A').focus();
    await page.keyboard.press('ArrowRight');
    await isSelected(page, 'Image');
    assert.equal(await focused(), 'Image');
    await page.keyboard.press('Delete');
    await page.keyboard.press('Home');
    await isSelected(page, 'Buffer A');
    await page.keyboard.press('Delete');
    await isSelected(page, 'Image');
    assert.equal(await focused(), 'Image');
    assert.equal(await page.getByRole('tab').count(), 1);
  });
}

export const passTests = [
  { name: 'passes of the playground see the names of Common', run: common },
  { name: 'passes of the playground are drawn, and channels read them', run: buffers },
  { name: 'passes of the playground are in links', run: links },
  { name: 'passes of the playground are renamed together', run: renaming },
  { name: 'passes of the playground work without a mouse', run: keyboard },
  { name: 'the playground never shows the image of the previous shader', run: replacing },
];
