// The debugger of the playground: steps in both directions, breakpoints with counts, watches, and images of values.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { findings, imageOf, linkTo, within } from './playground.js';

const axe = createRequire(new URL('../../site/package.json', import.meta.url)).resolve('axe-core/axe.min.js');

const MARCH = `struct Hit {
    float t;
    vec3 color;
};

float map(vec3 p) {
    return length(p) - 1.0;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    Hit hit = Hit(0.0, vec3(0.2, 0.4, 0.6));
    for (int i = 0; i < 32; i++) {
        float d = map(vec3(uv - 0.5, hit.t - 3.0));
        if (d < 0.001) break;
        hit.t += d;
    }
    float root = sqrt(uv.x - 0.75);
    if (uv.x < 0.25) {
        hit.color.r = 1.0;
    }
    fragColor = vec4(hit.color * uv.x, root);
}
`;

const panel = (page) => page.locator('#debug');
/** Waits until the panel says where the pixel is. */
const says = (page, words) => panel(page).locator('.status', { hasText: words }).waitFor();
/** Waits until the debugger has answered. */
const answered = (page) => page.locator('#debug:not([aria-busy=true])').waitFor();
const step = async (page, name) => {
  await panel(page).getByRole('toolbar').getByRole('button', { name, exact: true }).click();
  await answered(page);
};
const press = async (page, key) => {
  await page.keyboard.press(key);
  await answered(page);
};
const row = (page, name, table = 'Locals') => panel(page).getByRole('table', { name: table }).locator('tr').filter({ has: page.locator('td:first-child', { hasText: new RegExp(`^(?:[▸▾] )?${name}$`) }) });
const value = (page, name) => row(page, name).locator('.value').textContent();
/** The number of the highlighted line. */
const current = (page) => page.evaluate(() => {
  const lines = [.../** @type {any} */ (document.querySelector('#code')).shadowRoot.querySelectorAll('.cm-editor:not([hidden]) .cm-line')];
  return lines.findIndex((line) => line.classList.contains('current-step')) + 1;
});

/** Opens a shader and the debugger of the pixel in the middle. */
async function debug(browser, address, code, run, options = {}) {
  await within(browser, address, { fragment: linkTo(code), ...options }, async (page) => {
    await findings(page, {});
    await imageOf(page);
    await page.locator('#debug-pixel').click();
    await says(page, 'At the start');
    await run(page);
  });
}

async function stepping(browser, address) {
  await debug(browser, address, MARCH, async (page) => {
    await says(page, 'mainImage, line 11');
    assert.equal(await current(page), 11);
    await step(page, 'Over');
    await says(page, 'mainImage, line 12');
    assert.match(await value(page, 'uv'), /^vec2\(0\.50\d*, 0\.50\d*\)$/);
    // Keys step too: over to the loop, into the call and out of it.
    for (const line of [13, 13, 14]) {
      await press(page, 'F10');
      assert.equal(await current(page), line);
    }
    await press(page, 'F11');
    await says(page, 'map, line 7');
    assert.match(await panel(page).locator('.stack').innerText(), /map, line 7\s+mainImage, line 14/);
    await panel(page).locator('.stack button', { hasText: 'mainImage' }).click();
    await row(page, 'uv').waitFor();
    await press(page, 'Shift+F11');
    await says(page, 'mainImage, line 14');
    await press(page, 'F10');
    await says(page, 'mainImage, line 15');
    const first = await value(page, 'd');
    await press(page, 'Control+F10');
    while (await current(page) !== 15) await step(page, 'Over');
    await row(page, 'd').locator('.mark').waitFor();
    assert.notEqual(await value(page, 'd'), first);
    // Back where it was, the value is the same, bit for bit.
    do await press(page, 'Shift+F10'); while (await current(page) !== 15);
    assert.equal(await value(page, 'd'), first);
    await step(page, 'Reverse');
    await says(page, 'At the start');
  });
}

/** Structs open, colours have swatches, and a value is followed back to its write. */
async function values(browser, address) {
  await debug(browser, address, MARCH, async (page) => {
    await step(page, 'Continue');
    await says(page, 'line 23');
    await row(page, 'hit').getByRole('button', { name: 'Parts of hit' }).click();
    await row(page, 'color').locator('.swatch').waitFor();
    assert.equal(await value(page, 'color'), 'vec3(0.2, 0.4, 0.6)');
    await row(page, 'hit').getByRole('button', { name: 'Back to where hit was written' }).click();
    await says(page, 'line 16');
    const field = panel(page).getByRole('textbox', { name: 'Expression to watch' });
    await field.fill('map(vec3(uv, 0.0)) * 2.0');
    await field.press('Enter');
    const watched = panel(page).getByRole('table', { name: 'Watch' });
    await watched.locator('.value', { hasText: /^-\d/ }).waitFor();
    await field.fill('nothing + 1.0');
    await field.press('Enter');
    await watched.locator('.invalid', { hasText: 'nothing' }).waitFor();
    // The four pixels of the quad are threads.
    const quad = panel(page).getByRole('group', { name: 'Pixels of the quad' }).getByRole('button');
    assert.equal(await quad.count(), 4);
    const [, x, y] = /pixel (\d+), (\d+)/.exec(await panel(page).locator('h2').textContent());
    const other = `${Number(x) ^ 1},${y}`;
    await quad.filter({ hasText: other }).click();
    await panel(page).locator('h2', { hasText: other.replace(',', ', ') }).waitFor();
  });
}

async function breakpoints(browser, address) {
  await debug(browser, address, MARCH, async (page) => {
    // In the gutter of line 20, which a quarter of the pixels reach.
    const line = await page.locator('#code .cm-line', { hasText: 'hit.color.r' }).boundingBox();
    const gutter = await page.locator('#code .cm-breakpoints').boundingBox();
    await page.mouse.click(gutter.x + 8, line.y + 8);
    const hits = panel(page).locator('.hits', { hasText: /^hit by [\d,]+ of [\d,]+ pixels/ });
    await hits.waitFor();
    const [reached, all] = (await hits.textContent()).match(/\d[\d,]*/g).map((number) => Number(number.replaceAll(',', '')));
    assert.ok(Math.abs(reached / all - 0.25) < 0.01, `${reached} of ${all}`);
    // The pixel in the middle does not reach it, one on the left does.
    await step(page, 'Continue');
    await says(page, 'line 23');
    const box = await page.locator('#image').boundingBox();
    await page.mouse.click(box.x + box.width * 0.1, box.y + box.height / 2);
    await answered(page);
    await step(page, 'Reverse');
    await says(page, 'Breakpoint. mainImage, line 20');
    assert.equal(await current(page), 20);
    // Keys set one at the cursor; a condition changes what it counts.
    await page.locator('#code .cm-line', { hasText: 'float d =' }).click();
    await page.keyboard.press('F9');
    const condition = panel(page).getByRole('textbox', { name: 'Condition of line 14' });
    await condition.fill('i == 2');
    await condition.press('Tab');
    await answered(page);
    await step(page, 'Reverse');
    await says(page, 'Breakpoint. mainImage, line 14');
    assert.equal(await value(page, 'i'), '2');
    // A root that is not a number.
    await panel(page).getByRole('checkbox', { name: 'NaN' }).check();
    await step(page, 'Continue');
    await says(page, '`sqrt(uv.x - 0.75)` is NaN');
  });
}

/** A value over the screen. That it is what `run --show` draws is tested with the module. */
async function images(browser, address) {
  await debug(browser, address, MARCH, async (page) => {
    await step(page, 'Continue');
    await says(page, 'line 23');
    await row(page, 'uv').locator('.value').click();
    await page.locator('img.drawn[alt="Values of uv at line 23"]').waitFor();
    await says(page, /in ([\d,]+) of \1 pixels/);
    const same = await page.evaluate(async () => {
      const image = /** @type {HTMLImageElement} */ (document.querySelector('img.drawn'));
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.naturalWidth, height: image.naturalHeight });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      return { size: [canvas.width, canvas.height], bytes: [...data.filter((_, at) => at % 4 < 3)].slice(0, 3000) };
    });
    // Red is x, green is y from below: the first row is the upper one.
    const [width, height] = same.size;
    // It lies where the canvas does, above the buttons of the player.
    const box = await page.locator('img.drawn').boundingBox();
    assert.ok(Math.abs(box.width / box.height - width / height) < 0.02, `${box.width}x${box.height}`);
    for (const at of [0, 100, 500]) {
      const expected = Math.round(255 * (at + 0.5) / width);
      assert.ok(Math.abs(same.bytes[at * 3] - expected) <= 1, `${same.bytes[at * 3]} ${expected}`);
      assert.ok(same.bytes[at * 3 + 1] >= 254);
    }
    await panel(page).getByRole('button', { name: 'Hide the image' }).click();
    await page.locator('img.drawn').waitFor({ state: 'hidden' });
  });
}

/** A change is debugged at the same pixel; an error is named. */
async function editing(browser, address) {
  await debug(browser, address, MARCH, async (page) => {
    await step(page, 'Continue');
    await says(page, 'line 23');
    await page.locator('#code .cm-line', { hasText: 'vec2 uv' }).click();
    await page.keyboard.press('Home');
    await page.keyboard.insertText('float extra = 0.25;\n    ');
    await says(page, 'line 24');
    await row(page, 'extra').waitFor();
    await page.keyboard.insertText('wrong; ');
    await says(page, 'the shader has errors');
    await panel(page).getByRole('button', { name: 'Close', exact: true }).click();
    assert.equal(await current(page), 0);
    assert.ok(await panel(page).isHidden());
  });
}

async function passes(browser, address) {
  const files = {
    'common.glsl': 'float twice(float x) {\n    return 2.0 * x;\n}\n',
    'buffer_a.glsl': 'void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(twice(0.125));\n}\n',
    'image.glsl': 'void mainImage(out vec4 c, in vec2 p) {\n    c = texelFetch(iChannel0, ivec2(p), 0);\n}\n',
    'channels.toml': '[image]\n0 = "buffer_a"\n',
  };
  await debug(browser, address, JSON.stringify(files), async (page) => {
    await says(page, 'mainImage, Image, line 2');
    await page.getByRole('tab', { name: 'Buffer A', exact: true }).click();
    await page.locator('.picker').focus();
    await page.keyboard.press('ArrowLeft');
    await says(page, 'mainImage, Buffer A, line 2');
    await step(page, 'In');
    await says(page, 'twice, Common, line 2');
    await page.locator('[role=tab][aria-selected=true]', { hasText: 'Common' }).waitFor();
    assert.equal(await value(page, 'x'), '0.125');
    assert.equal(await current(page), 2);
  });
}

/** A link opens the debugger at its pixel, and the debugger writes such a link. */
async function links(browser, address) {
  const files = {
    'buffer_a.glsl': 'uniform float bright;\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(p + 0.5, iTime, float(iFrame));\n}\n',
    'image.glsl': 'void mainImage(out vec4 c, in vec2 p) {\n    c = texelFetch(iChannel0, ivec2(p), 0) + iMouse;\n}\n',
    'channels.toml': '[image]\n0 = "buffer_a"\n',
  };
  const words = '&debug&pixel=7,170&size=1920x1080&time=1.5&frame=75&pass=buffer_a&mouse=3,4';
  const fragment = `${linkTo(JSON.stringify(files))}${words}`;
  await within(browser, address, { fragment }, async (page) => {
    await says(page, 'mainImage, Buffer A, line 3');
    await panel(page).locator('h2', { hasText: 'pixel 7, 170 at 1.5 s' }).waitFor();
    await step(page, 'Over');
    assert.equal(await value(page, 'p'), 'vec2(7.5, 170.5)');
    assert.equal(await value(page, 'c'), 'vec4(8.0, 171.0, 1.5, 75.0)');
    // The image has that size, and is not larger than its place.
    const [width, height] = await page.locator('#image').evaluate((image) => [image.clientWidth, image.clientHeight]);
    const cross = await page.locator('.picker .cross').evaluate((mark) => [parseFloat(mark.style.left), parseFloat(mark.style.top)]);
    assert.ok(cross[0] > 0 && cross[0] < width / 20 && cross[1] > height / 2 && cross[1] < height, `${cross}`);
    await page.locator('#share').click();
    await page.waitForFunction((old) => location.hash !== old, fragment);
    const hash = await page.evaluate(() => location.hash);
    assert.equal(hash.slice(hash.indexOf('&')), words);
    // Without the debugger there is only the code.
    await panel(page).getByRole('button', { name: 'Close', exact: true }).click();
    await page.locator('#share').click();
    await page.waitForFunction(() => !location.hash.includes('&'));
  });
  // Words that make no sense are ignored: the pixel in the middle.
  const wrong = `${linkTo(MARCH)}&debug&pixel=1,x&size=0x9&time=-1&frame=1.5&pass=../x&mouse=1&u.x=<b>&other=1`;
  await within(browser, address, { fragment: wrong }, async (page) => {
    await says(page, 'At the start');
    await step(page, 'Over');
    assert.match(await value(page, 'uv'), /^vec2\(0\.50\d*, 0\.50\d*\)$/);
  });
  // A shader with errors shows them; another one does not open the debugger for it.
  await within(browser, address, { fragment: `${linkTo('float f() { return 1; }\n')}&debug` }, async (page) => {
    await findings(page, { has: ['int-float-mix'] });
    assert.ok(await panel(page).isHidden());
  });
}

async function looks(browser, address) {
  for (const width of [1280, 390]) {
    for (const colorScheme of ['light', 'dark']) {
      const options = { viewport: { width, height: 780 }, colorScheme };
      await debug(browser, address, MARCH, async (page) => {
        await page.locator('#code .cm-line', { hasText: 'float d =' }).click();
        await page.keyboard.press('F9');
        await panel(page).locator('.hits', { hasText: 'hit by' }).waitFor();
        await step(page, 'Continue');
        await says(page, 'Breakpoint');
        await row(page, 'hit').getByRole('button', { name: 'Parts of hit' }).click();
        await row(page, 'color').waitFor();
        const field = panel(page).getByRole('textbox', { name: 'Expression to watch' });
        await field.fill('uv * 2.0');
        await field.press('Enter');
        await panel(page).getByRole('table', { name: 'Watch' }).locator('.value').waitFor();
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${wide} pixels wide`);
        if (process.env.SCREENSHOTS) await page.screenshot({ path: `${process.env.SCREENSHOTS}/debug-${width}-${colorScheme}.png` });
        await page.evaluate(fs.readFileSync(axe, 'utf8'));
        const { violations } = await page.evaluate(() => /** @type {any} */ (globalThis).axe.run({ runOnly: ['wcag2a', 'wcag2aa'], iframes: false }));
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html} ${nodes[0].failureSummary}`), []);
      }, options);
    }
  }
}

export const debugTests = [
  { name: 'the playground debugs a pixel in both directions', run: stepping },
  { name: 'the debugger shows structs, colours, watches and the quad', run: values },
  { name: 'the debugger counts what breakpoints hit, and stops at them', run: breakpoints },
  { name: 'the debugger shows a value over the screen', run: images },
  { name: 'the debugger continues after edits', run: editing },
  { name: 'the debugger steps through passes', run: passes },
  { name: 'links open the debugger at a pixel', run: links },
  { name: 'the debugger fits wide and narrow windows, light and dark', run: looks },
];
