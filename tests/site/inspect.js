// What the playground shows behind the image: traced pixels, heat maps, values and differences.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { findings, imageOf, linkTo, text, within } from './playground.js';

const axe = createRequire(new URL('../../site/package.json', import.meta.url)).resolve('axe-core/axe.min.js');

/** A march, and a square root that is not a number on the left. */
const MARCH = `float map(vec3 p) {
    return length(p) - 1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    float t = 0.0;
    for (int i = 0; i < 32; i++) {
        float d = map(vec3(uv - 0.5, t - 3.0));
        if (d < 0.001) break;
        t += d;
    }
    float root = sqrt(uv.x - 0.25);
    fragColor = vec4(uv.x, root, t / 8.0, 1.0);
}
`;

const panel = (page) => page.locator('#pixel');
/** Waits for the panel to say something. */
const says = (page, words) => panel(page).filter({ hasText: words }).waitFor();
/** The values at the ends of lines. */
const marks = (page) => page.evaluate(() => Object.fromEntries(
  [.../** @type {any} */ (document.querySelector('#code')).shadowRoot.querySelectorAll('.cm-editor:not([hidden]) .cm-line')]
    .map((line, at) => [at + 1, line.querySelector('.trace')?.textContent]).filter(([, values]) => values)));

/** The pixel that the panel names. */
const pixel = async (page) => {
  const [, x, y] = /Pixel (\d+), (\d+)/.exec(await panel(page).locator('h2').textContent());
  return [Number(x), Number(y)];
};

/** Opens a shader and the panel of the pixel in the middle. */
async function inspect(browser, address, code, run, options = {}) {
  await within(browser, address, { fragment: linkTo(code), ...options }, async (page) => {
    await findings(page, {});
    const frame = await imageOf(page);
    await page.locator('#pick').click();
    await says(page, 'Step');
    await run(page, frame);
  });
}

async function tracing(browser, address) {
  await inspect(browser, address, MARCH, async (page, frame) => {
    assert.equal(await frame.evaluate(() => /** @type {any} */ (window).shaderport.player.isPlaying), false);
    const size = await frame.evaluate(() => {
      const { canvas } = /** @type {any} */ (window).shaderport.player;
      return [canvas.width, canvas.height];
    });
    const [x, y] = await pixel(page);
    assert.deepEqual([x, y], size.map((side) => Math.floor(side / 2)));
    // The colour is that of the image.
    const drawn = await frame.evaluate(([left, below]) => {
      const { player } = /** @type {any} */ (window).shaderport;
      player.poke();
      const bytes = new Uint8Array(4);
      player.gl.readPixels(left, below, 1, 1, player.gl.RGBA, player.gl.UNSIGNED_BYTE, bytes);
      return [...bytes];
    }, [x, y]);
    const color = (await panel(page).locator('.color code').getAttribute('title')).split(' ').map(Number);
    assert.ok(color.every((lane, at) => Math.abs(Math.min(1, lane) * 255 - drawn[at]) <= 1.5), `${color} ${drawn}`);
    const values = await marks(page);
    assert.match(values[6], /^uv 0\.50\d* 0\.50\d*$/);
    assert.match(values[8], /^i \d+$/);
    assert.match(values[9], /^d /);
    assert.match(values[2], /^map\(\) returns /);
    await says(page, 'loop in mainImage()');
    // Keys move the pixel: the page traces anew.
    await page.locator('.picker').focus();
    await page.keyboard.press('Shift+ArrowLeft');
    await page.waitForFunction((old) => document.querySelector('#pixel h2').textContent.startsWith(`Pixel ${old - 10},`), x);
    // Of many keys, the last one counts.
    for (let i = 0; i < 40; i++) await page.keyboard.press('ArrowRight');
    await page.waitForFunction((old) => document.querySelector('#pixel h2').textContent.startsWith(`Pixel ${old + 30},`), x);
    await panel(page).getByRole('button', { name: 'Close' }).click();
    await panel(page).waitFor({ state: 'hidden' });
    assert.deepEqual(await marks(page), {});
    await frame.waitForFunction(() => /** @type {any} */ (window).shaderport.player.isPlaying);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'pick');
  });
}

async function stepping(browser, address) {
  await inspect(browser, address, MARCH, async (page) => {
    const label = () => panel(page).locator('label').textContent();
    const button = (name) => panel(page).getByRole('button', { name, exact: true });
    assert.match(await label(), /line 14, fragColor/);
    // The first line that ran is that of the parameter.
    await panel(page).locator('#step').focus();
    await page.keyboard.press('Home');
    assert.match(await label(), /^Step 1 of \d+: line 5, fragCoord/);
    assert.deepEqual(Object.keys(await marks(page)), ['5']);
    await button('›').click();
    assert.match(await label(), /^Step 2 of \d+: line 6, uv/);
    // To the loop, and to its next iteration.
    while (!/line 9, d /.test(await label())) await button('›').click();
    const first = await label();
    await button('»').click();
    const second = await label();
    assert.match(second, /line 9, d /);
    assert.notEqual(second, first);
    await button('«').click();
    assert.equal(await label(), first);
    const names = await panel(page).locator('tbody tr td:first-child').allTextContents();
    assert.deepEqual(names, ['fragCoord', 'uv', 't', 'i', 'd']);
  });
}

/** Where a value that is no number comes from, and that an edit is traced again. */
async function origins(browser, address) {
  await inspect(browser, address, MARCH, async (page) => {
    const box = await page.locator('#image').boundingBox();
    await page.mouse.click(box.x + box.width * 0.1, box.y + box.height / 2);
    await says(page, 'sqrt(uv.x - 0.25) is NaN');
    const cause = panel(page).locator('.causes li', { hasText: 'is NaN' });
    await cause.getByRole('button', { name: 'Line 13' }).click();
    assert.match(await panel(page).locator('label').textContent(), /line 13, root NaN/);
    await page.locator('#code .cm-line', { hasText: 'float root' }).click();
    await page.keyboard.press('End');
    await page.keyboard.insertText(' root = 0.5;');
    await page.waitForFunction(() => document.querySelectorAll('#pixel tbody tr.invalid').length === 0);
    await page.keyboard.insertText(' root = 1;');
    await says(page, 'The pixel cannot be traced: shader.glsl: the shader has errors.');
    assert.deepEqual(await marks(page), {});
  });
}

/** Code that passes share is shown in its own tab. */
async function passes(browser, address) {
  const files = {
    'common.glsl': 'float twice(float x) {\n    return 2.0 * x;\n}\n',
    'buffer_a.glsl': 'void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(twice(0.125));\n}\n',
    'image.glsl': 'void mainImage(out vec4 c, in vec2 p) {\n    c = texelFetch(iChannel0, ivec2(p), 0);\n}\n',
    'channels.toml': '[image]\n0 = "buffer_a"\n',
  };
  await inspect(browser, address, JSON.stringify(files), async (page) => {
    assert.match(await panel(page).locator('.color code').textContent(), /^0\.25 0\.25 0\.25 /);
    const tab = (name) => page.getByRole('tab', { name, exact: true });
    await tab('Buffer A').click();
    await page.locator('.picker').focus();
    await page.keyboard.press('ArrowLeft');
    await says(page, 'line 2, c 0.25');
    await panel(page).getByRole('button', { name: '‹', exact: true }).click();
    await page.locator('[role=tab][aria-selected=true]', { hasText: 'Common' }).waitFor();
    assert.equal((await marks(page))[2], 'twice() returns 0.25');
  });
}

async function views(browser, address) {
  await within(browser, address, { fragment: linkTo(MARCH) }, async (page) => {
    await findings(page, {});
    await imageOf(page);
    const drawn = page.locator('canvas.drawn');
    for (const [view, label] of [['steps', 'Heat map: loop iterations'], ['nan', 'Heat map: not finite']]) {
      await page.locator('#view').selectOption(view);
      await page.locator(`canvas.drawn[aria-label="${label}"]:not([hidden])`).waitFor();
    }
    await page.locator('#code .cm-line', { hasText: 'float d' }).click({ position: { x: 80, y: 8 } });
    await page.keyboard.press('Home');
    for (const _ of 'float ') await page.keyboard.press('ArrowRight');
    await page.locator('#view').selectOption('variable');
    await page.waitForFunction(() => document.querySelector('canvas.drawn:not([hidden])')?.getAttribute('aria-label') === 'Values of d on line 9');
    await page.locator('#view').selectOption('');
    await drawn.waitFor({ state: 'hidden' });
  });
}

async function comparing(browser, address) {
  await within(browser, address, { fragment: linkTo(MARCH) }, async (page) => {
    await findings(page, {});
    await imageOf(page);
    const status = (words) => page.locator('#status', { hasText: words }).waitFor();
    await page.locator('#compare').click();
    await page.locator('#code .cm-line', { hasText: 'float t =' }).click();
    await page.keyboard.press('End');
    await page.keyboard.insertText(' // No change.');
    await page.locator('#compare').click();
    await status('Same image in 8 frames, bit for bit.');
    await page.locator('#code .cm-line', { hasText: 'float t =' }).click();
    await page.keyboard.press('Home');
    await page.keyboard.insertText('uv.x += 0.1; ');
    await page.locator('#compare').click();
    await status('Differs: at ');
    await page.locator('canvas.drawn[aria-label="Where the versions differ"]:not([hidden])').waitFor();
    assert.match(await text(page), /uv\.x \+= 0\.1/);
  });
}

async function looks(browser, address) {
  for (const width of [1280, 390]) {
    for (const colorScheme of ['light', 'dark']) {
      const options = { viewport: { width, height: 780 }, colorScheme };
      await inspect(browser, address, MARCH, async (page) => {
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${wide} pixels wide`);
        if (process.env.SCREENSHOTS) await page.screenshot({ path: `${process.env.SCREENSHOTS}/inspect-${width}-${colorScheme}.png` });
        await page.evaluate(fs.readFileSync(axe, 'utf8'));
        const { violations } = await page.evaluate(() => /** @type {any} */ (globalThis).axe.run({ runOnly: ['wcag2a', 'wcag2aa'], iframes: false }));
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html} ${nodes[0].failureSummary}`), []);
      }, options);
    }
  }
}

export const inspectTests = [
  { name: 'the playground traces a pixel', run: tracing },
  { name: 'the playground steps through a pixel', run: stepping },
  { name: 'the playground shows where a NaN comes from, and traces edits', run: origins },
  { name: 'the playground traces pixels through passes', run: passes },
  { name: 'the playground draws heat maps and values of variables', run: views },
  { name: 'the playground compares versions', run: comparing },
  { name: 'the inspector fits wide and narrow windows, light and dark', run: looks },
];
