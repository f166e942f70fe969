// The code editor while the shader plays, and its error messages.
import assert from 'node:assert/strict';
import { pixels } from '../browser.js';
import { shader } from '../cases.js';
import { desk, MOVING, openTab, show } from './show.js';

const PLAIN = 'void mainImage(out vec4 O, vec2 U) {\n  O = vec4(1.0, 0.0, 0.0, 1.0);\n}';
const red = async (page) => (await pixels(page)).slice(0, 3);
/** Waits until the first pixel has a colour. */
const becomes = (page, color) => page.waitForFunction((expected) => {
  const { gl } = globalThis.shaderport.player;
  const pixel = new Uint8Array(4);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  return expected.every((value, i) => value === pixel[i]);
}, color);
const area = '.editor:not([hidden]) textarea';

/** Puts the cursor after a part of the code. */
const behind = (page, words) => page.evaluate(([selector, text]) => {
  const node = document.querySelector(selector);
  const at = node.value.indexOf(text) + text.length;
  node.focus();
  node.setSelectionRange(at, at);
}, [area, words]);

async function edited(context) {
  const { page } = await show(context, 'edited', PLAIN, '#size=16x16&paused');
  await openTab(page, 'Code');
  assert.equal(await page.inputValue(area), PLAIN);
  await behind(page, 'vec4(1.0, ');
  await page.keyboard.type('1.0 + ');
  // The code is compiled while typing.
  await becomes(page, [255, 255, 0]);
  await behind(page, 'O = vec4');
  await page.keyboard.type('x');
  await page.waitForSelector('.problems article');
  assert.deepEqual(await red(page), [255, 255, 0], 'the last valid program keeps running');
  assert.equal(await page.textContent('.numbers .bad'), '2');
  assert.match(await page.textContent('.rows .bad'), /vec4x/);
  assert.ok(!(await page.isVisible('#errors')), 'nothing covers the image');
  await page.keyboard.press('Control+z');
  await page.waitForSelector('.problems article', { state: 'detached' });
  await page.click('#code button:text-is("Reset")');
  await page.waitForFunction((s) => document.querySelector(s).value.includes('vec4(1.0, 0.0'), area);
  await becomes(page, [255, 0, 0]);
}

async function keysOfTheEditor(context) {
  const { page } = await show(context, 'editor_keys', PLAIN, '#size=16x16&paused');
  await openTab(page, 'Code');
  await behind(page, '1.0);');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Tab');
  await page.keyboard.type('// r f s');
  assert.match(await page.inputValue(area), /1\.0\);\n {4}\/\/ r f s\n\}/, 'a new line is indented like the previous one');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Image', 'the focus can leave the editor');
  const shown = await page.$$eval('.rows .comment', (all) => all.map((n) => n.textContent));
  assert.deepEqual(shown, ['// r f s']);
}

async function passes(context) {
  const toy = shader(
    { type: 'image', name: 'Image', inputs: [], outputs: [], code: 'void mainImage(out vec4 O, vec2 U) {\r\n  O = vec4(f(), 0.0, 0.0, 1.0);\r\n}' },
    { type: 'common', name: 'Common', inputs: [], outputs: [], code: '#define N 0.5 // Tunable: n (0.0~1.0)\r\nfloat f() { return N; }' },
  );
  const { page } = await show(context, 'passes', toy, '#size=16x16&paused');
  await openTab(page, 'Code');
  assert.deepEqual((await page.$$eval('.passes button', (all) => all.map((b) => b.textContent))).sort(), ['Common', 'Image']);
  await page.click('.passes button:text-is("Common")');
  await behind(page, 'return ');
  await page.keyboard.type('0.5 + ');
  await becomes(page, [255, 0, 0]);
  await openTab(page, 'Controls');
  await page.fill('input[name=N]', '0');
  // Sliders find their numbers in the edited text.
  await becomes(page, [128, 0, 0]);
  await openTab(page, 'Code');
  assert.match(await page.inputValue(area), /N 0\.0 \/\/.*\n.*0\.5 \+ N/);
}

async function long(context) {
  const lines = Array.from({ length: 5000 }, (_, i) => `float unused${i}() { return float(${i}); } // a line`);
  const code = `${lines.join('\n')}\n${PLAIN}`;
  assert.ok(code.length > 200000);
  const { page } = await show(context, 'long', code, '#size=16x16&paused');
  await openTab(page, 'Code');
  await behind(page, 'O = ');
  await page.evaluate(() => {
    globalThis.painted = 0;
    new MutationObserver((all) => { globalThis.painted += all.reduce((sum, m) => sum + m.addedNodes.length, 0); })
      .observe(document.querySelector('.editor:not([hidden])'), { childList: true, subtree: true });
  });
  await page.keyboard.type('1.0 * ');
  await page.waitForFunction(() => document.querySelector('.rows').textContent.includes('O = 1.0 * vec4'));
  const painted = await page.evaluate(() => globalThis.painted);
  assert.ok(painted > 0 && painted < 6 * 1000, `six letters created ${painted} nodes`);
  assert.ok((await page.locator('.rows > div').count()) < 100, 'only visible lines are rendered');
  assert.match(await page.textContent('.rows'), /O = 1\.0 \* vec4/);
}

async function errors(context) {
  const toy = shader(
    { type: 'image', name: 'Image', inputs: [], outputs: [], code: '\nvoid mainImage(out vec4 O, vec2 U) {\n  O = vec4(smothstep(0.0, 1.0, U.x));\n}' },
    { type: 'common', name: 'Common', inputs: [], outputs: [], code: '// one\n// two\nfloat f() { return nothing; }' },
  );
  const { page } = await show(context, 'errors', toy, '#paused');
  const places = await page.evaluate(() => globalThis.shaderport.errors.map((e) => `${e.pass} ${e.line}`));
  assert.deepEqual([...new Set(places)].sort(), ['Common 3', 'Image 3']);
  assert.equal(new Set(places.map(String)).size, 2);
  const text = await page.textContent('#errors');
  assert.match(text, /2 errors/);
  assert.match(text, /Image, line 3: .*smothstep.*\[undeclared-name\]/, 'the checker\'s message');
  assert.match(text, /3 │ {3}O = vec4\(smothstep\(0\.0, 1\.0, U\.x\)\);\n {2}│ {12}\^{9}/, 'the line with carets');
  assert.match(text, /help: did you mean smoothstep/);
  await page.click('#errors [aria-label=Close]');
  assert.ok(!(await page.isVisible('#errors')));
  await page.click('#wrong');
  assert.ok(await page.isVisible('#errors'));
  await page.click('#errors button:text-is("Edit")');
  assert.ok(!(await page.isVisible('#errors')));
  await page.click('.problems button:text-is("Common, line 3")');
  const line = await page.evaluate((s) => {
    const node = document.querySelector(s);
    return node.value.slice(0, node.selectionStart).split('\n').length;
  }, area);
  assert.equal(line, 3, 'clicking an error shows its line');
}

async function browserAlone(context) {
  const { page } = await show(context, 'browser_alone', MOVING, '#size=16x16&paused');
  await page.evaluate(() => {
    const { player } = globalThis.shaderport;
    const index = player.project.files.findIndex((f) => !f.hidden);
    return player.setCode(index, 'void mainImage(out vec4 O, vec2 U) {\n  O = vec4(lost);\n}\n#if\n#endif');
  });
  const text = await page.textContent('#errors');
  assert.match(text, /Image, line 2: 'lost' : undeclared identifier/);
  assert.match(text, /2 │ {3}O = vec4\(lost\);\n {2}│ {12}\^{4}/, 'browser errors have carets, too');
}

export const codeTests = [
  { name: 'page: code is compiled while typing', run: edited, context: desk },
  { name: 'page: the editor indents lines, and Escape leaves it', run: keysOfTheEditor, context: desk },
  { name: 'page: passes are shown with their sliders', run: passes, context: desk },
  { name: 'page: long code stays responsive', run: long, context: desk },
  { name: 'page: errors have pass, line and help', run: errors, context: desk },
  { name: 'page: errors found only by the browser are shown', run: browserAlone, context: desk },
];
