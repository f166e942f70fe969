// The playground in a browser: findings as one types, fixes, links, examples, and its policy.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import zlib from 'node:zlib';
import { close, watch } from './watch.js';

const axe = createRequire(new URL('../../site/package.json', import.meta.url)).resolve('axe-core/axe.min.js');

/**
 * Opens the playground in a window of its own, and fails if anything is loaded from elsewhere or complains.
 * `allowed` is another address that may be loaded; `init` runs before the scripts of the page.
 * @param {{ fragment?: string, allowed?: string, mayComplain?: boolean, init?: [Function, unknown], [option: string]: unknown }} options
 */
export async function within(browser, address, { fragment = '', allowed = address, mayComplain = false, init, ...options }, run) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  context.setDefaultTimeout(0);
  const page = await context.newPage();
  if (!mayComplain) watch(page, address, allowed);
  try {
    if (init) await page.addInitScript(...init);
    await page.goto(`${address}playground/${fragment}`);
    await run(page);
  } finally {
    await close(context);
  }
}

export const linkTo = (text) => `#code=${zlib.deflateRawSync(text).toString('base64url')}`;

/**
 * Waits until the list has the findings of some rules, none of others, and this many.
 * @param {{ has?: string[], lacks?: string[], count?: number }} wanted
 */
export const findings = (page, wanted) => page.waitForFunction(({ has = [], lacks = [], count }) => {
  const rules = [...document.querySelectorAll('#list .finding small')].map((name) => name.textContent);
  const isShown = document.querySelector('#summary')?.textContent !== 'Loading…';
  const fits = has.every((rule) => rules.includes(rule)) && !lacks.some((rule) => rules.includes(rule));
  return isShown && fits && (count === undefined || rules.length === count);
}, wanted);

/** The text in the editor. The lines of a short one are all in the page. */
export const text = (page) => page.evaluate(() =>
  [.../** @type {any} */ (document.querySelector('#code')).shadowRoot.querySelectorAll('.cm-editor:not([hidden]) .cm-line')].map((line) => line.textContent).join('\n'));

const FAULTY = 'void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p.x * 2, 0.0, 0.0, 1.0);\n}\n';

async function typing(browser, address) {
  await within(browser, address, {}, async (page) => {
    // A warning needs a run of the shader, an error does not.
    await findings(page, { has: ['nan-pixels'] });
    await page.locator('#code .cm-line', { hasText: 'fragColor = vec4' }).click();
    await page.keyboard.press('End');
    await page.keyboard.type(' fragColor += 1;');
    await findings(page, { has: ['int-float-mix'] });
    for (let i = 0; i < 3; i++) await page.keyboard.press('Backspace');
    await page.keyboard.type(' 1.0;');
    await findings(page, { has: ['nan-pixels'], lacks: ['int-float-mix'] });
  });
}

async function fixing(browser, address) {
  // Nothing is found in a run of its fixed form either.
  const faulty = FAULTY.replace('p.x', 'p.x / iResolution.x');
  await within(browser, address, { fragment: linkTo(faulty) }, async (page) => {
    const fix = page.locator('#list .fixes button', { hasText: '2.0' });
    await fix.click();
    await findings(page, { count: 0 });
    assert.equal(await text(page), faulty.replace('* 2,', '* 2.0,'));
  });
  await within(browser, address, { fragment: linkTo(faulty) }, async (page) => {
    await findings(page, { has: ['int-float-mix'] });
    await page.locator('#fix').click();
    await findings(page, { count: 0 });
    assert.equal(await text(page), faulty.replace('* 2,', '* 2.0,'));
  });
}

async function formatting(browser, address) {
  const code = 'float f(float x){return x;}\n';
  await within(browser, address, { fragment: linkTo(code) }, async (page) => {
    await page.waitForFunction(() => document.querySelector('#summary')?.textContent !== 'Loading…');
    await page.locator('#format').click();
    await page.waitForFunction(() =>
      /** @type {any} */ (document.querySelector('#code')).shadowRoot.querySelector('.cm-line').textContent === 'float f(float x) { return x; }');
  });
}

async function hovering(browser, address) {
  await within(browser, address, { fragment: linkTo(FAULTY) }, async (page) => {
    await findings(page, { has: ['int-float-mix'] });
    const isIn = { x: 70, y: 8 };
    await page.locator('#code .cm-line').first().hover({ position: isIn });
    await page.locator('#code .cm-lsp-hover-tooltip', { hasText: 'mainImage' }).waitFor();
  });
}

async function linking(browser, address) {
  const code = 'void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0); // é 漢\n}\n';
  await within(browser, address, { fragment: linkTo(code) }, async (page) => {
    await page.waitForFunction(() => document.querySelector('#summary')?.textContent !== 'Loading…');
    assert.equal(await text(page), code);
    await page.locator('#share').click();
    await page.waitForFunction((old) => location.hash !== old && location.hash.startsWith('#code='), linkTo('x'));
    const data = (await page.evaluate(() => location.hash)).slice('#code='.length);
    assert.equal(zlib.inflateRawSync(Buffer.from(data, 'base64url')).toString(), code);
  });
  for (const fragment of ['#code=AAAA', linkTo('x'.repeat(2 << 20))]) {
    await within(browser, address, { fragment }, async (page) => {
      await page.locator('#notice', { hasText: 'cannot be opened' }).waitFor();
    });
  }
}

/** What a shader says is shown as text. */
async function escaping(browser, address) {
  const code = '// <img src=x onerror=alert(1)>\n#define X <b>\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0) + unknown_name;\n}\n#error <i>no</i>\n';
  await within(browser, address, { fragment: linkTo(code) }, async (page) => {
    await findings(page, { has: ['error-directive'] });
    assert.equal(await page.locator('#list i, #list img').count(), 0);
  });
}

async function examples(browser, address) {
  await within(browser, address, {}, async (page) => {
    await findings(page, { has: ['nan-pixels'] });
    await page.locator('#examples').click();
    await page.getByRole('button', { name: 'cast_is_reserved.glsl' }).click();
    await findings(page, { has: ['reserved-word'] });
  });
}

async function looks(browser, address) {
  for (const width of [1280, 390]) {
    for (const colorScheme of ['light', 'dark']) {
      await within(browser, address, { viewport: { width, height: 780 }, colorScheme }, async (page) => {
        await findings(page, { has: ['nan-pixels'] });
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${wide} pixels wide`);
        // With the image, so that the page looks as it does to a visitor.
        await imageOf(page);
        if (process.env.SCREENSHOTS) await page.screenshot({ path: `${process.env.SCREENSHOTS}/playground-${width}-${colorScheme}.png` });
        // The policy of the page forbids other scripts, but not those of the browser's driver.
        await page.evaluate(fs.readFileSync(axe, 'utf8'));
        const { violations } = await page.evaluate(() => /** @type {any} */ (globalThis).axe.run({ runOnly: ['wcag2a', 'wcag2aa'], iframes: false }));
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html} ${nodes[0].failureSummary}`), []);
      });
    }
  }
}

/** The frame that shows the image of the shader. One that is replaced at the same time is none. */
export const imageOf = async (page) => {
  for (;;) {
    const element = await page.locator('#image iframe:not(.next)').elementHandle();
    const frame = await element.contentFrame();
    if (frame) return frame;
  }
};

/** The colour in the middle of the image, as the shader writes it. */
const middle = (frame) => frame.evaluate(() => {
  const { player } = /** @type {any} */ (window).shaderport;
  const { gl } = player;
  player.poke();
  const pixel = new Uint8Array(4);
  gl.readPixels(gl.drawingBufferWidth / 2, gl.drawingBufferHeight / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  return [...pixel];
});

/** Waits until the image has this colour in its middle. Typing may replace it several times. */
export async function drawn(page, color) {
  for (;;) {
    const frame = await imageOf(page);
    // A frame may be replaced while it is asked.
    const found = await middle(frame).catch(() => null);
    if (String(found) === String(color)) return;
  }
}

async function drawing(browser, address) {
  const code = (color) => `void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(${color}, 1.0);\n}\n`;
  await within(browser, address, { fragment: linkTo(code('1.0, 0.0, 0.0')), reducedMotion: 'reduce' }, async (page) => {
    await drawn(page, [255, 0, 0, 255]);
    assert.equal(await (await imageOf(page)).evaluate(() => window.origin), 'null');
    await page.locator('#code .cm-line', { hasText: '1.0, 0.0, 0.0' }).click();
    await page.keyboard.press('End');
    await page.keyboard.type(' c = c.bgra;');
    await drawn(page, [0, 0, 255, 255]);
  });
  await within(browser, address, { fragment: linkTo(FAULTY) }, async (page) => {
    await page.locator('#image.stale').waitFor();
    await page.locator('#list .fixes button', { hasText: '2.0' }).click();
    await drawn(page, [255, 0, 0, 255]);
  });
}

/** A frame that takes long is drawn only when somebody wants it. */
async function asking(browser, address) {
  const code = `void mainImage(out vec4 c, in vec2 p) {
    float sum = 0.0;
    for (int i = 0; i < 4000; i++) sum += sin(float(i) + p.x);
    c = vec4(sum * 0.0, 1.0, 0.0, 1.0);
}
`;
  await within(browser, address, { fragment: linkTo(code), reducedMotion: 'reduce' }, async (page) => {
    const question = page.locator('#image .question');
    await question.getByText('billion operations').waitFor();
    assert.equal(await page.locator('#image iframe').count(), 0);
    await question.getByRole('button', { name: /^Draw 1/ }).click();
    await drawn(page, [0, 255, 0, 255]);
    const frame = await imageOf(page);
    const [width, shown] = await frame.evaluate(() => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas'));
      return [canvas.width, canvas.clientWidth];
    });
    assert.ok(width < shown / 2, `${width} of ${shown} pixels`);
  });
}

export const playgroundTests = [
  { name: 'the playground finds mistakes as one types', run: typing },
  { name: 'the playground applies fixes', run: fixing },
  { name: 'the playground formats', run: formatting },
  { name: 'the playground explains names under the pointer', run: hovering },
  { name: 'links to the playground contain the shader', run: linking },
  { name: 'the playground shows texts of shaders as text', run: escaping },
  { name: 'the playground has examples', run: examples },
  { name: 'the playground draws the shader in its own frame', run: drawing },
  { name: 'the playground asks before it draws slow shaders', run: asking },
  { name: 'the playground fits wide and narrow windows, light and dark', run: looks },
];
