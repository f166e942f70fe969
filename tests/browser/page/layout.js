// Layout: the panel next to the canvas or below it, the bar, and pages without either.
import assert from 'node:assert/strict';
import { colors, frames, pixels } from '../browser.js';
import { desk, MOVING, openTab, phone, playing, show, time } from './show.js';

const box = (page, selector) => page.locator(selector).boundingBox();

/** The intersection area of two boxes. */
function overlap(a, b) {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return Math.max(0, width) * Math.max(0, height);
}

async function beside(context) {
  const { page } = await show(context, 'beside', MOVING, '#paused');
  const whole = await box(page, 'canvas');
  assert.equal(whole.width, 1000);
  assert.equal(overlap(whole, await box(page, '#bar')), 0, 'the bar is below the canvas');
  await openTab(page, 'Controls');
  const small = await box(page, 'canvas');
  assert.equal(overlap(small, await box(page, '#panel')), 0, 'the panel is next to the canvas');
  await page.waitForFunction((w) => globalThis.shaderport.player.canvas.width === w, Math.round(small.width));
  assert.ok(colors(await pixels(page)) > 10, 'a paused shader is redrawn');
  const panel = await box(page, '#panel');
  await page.mouse.move(panel.x, 300);
  await page.mouse.down();
  await page.mouse.move(panel.x - 100, 300, { steps: 3 });
  await page.mouse.up();
  assert.ok(Math.abs((await box(page, '#panel')).width - panel.width - 100) < 3, 'the edge can be dragged');
  await page.focus('#grip');
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await box(page, '#panel')).width - panel.width - 60) < 3, 'the edge can be moved with keys');
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#panel')));
  assert.equal((await box(page, 'canvas')).width, 1000);
}

/** Drags the sheet by its handle, with touch events of the DevTools protocol. */
async function dragSheet(page, by) {
  const grip = await box(page, '#grip');
  const client = await page.context().newCDPSession(page);
  const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  const send = (type, at) => client.send('Input.dispatchTouchEvent', { type, touchPoints: at === null ? [] : [{ x, y: at }] });
  await send('touchStart', y);
  for (let i = 1; i <= 4; i++) await send('touchMove', y + (by * i) / 4);
  await send('touchEnd', null);
  await frames(page);
}

async function sheet(context) {
  const { page } = await show(context, 'sheet', MOVING, '#paused');
  await page.tap('#more');
  const open = await box(page, '#panel');
  assert.ok(Math.abs(open.height - 422) < 3 && open.width === 390, 'half the height');
  assert.equal(overlap(open, await box(page, 'canvas')), 0, 'the canvas keeps the other half');
  assert.ok((await box(page, '#panel header')).height < 125, 'the header leaves room for the content');
  await dragSheet(page, -300);
  assert.ok((await box(page, '#panel')).height > 700, 'dragging up enlarges the sheet');
  await dragSheet(page, 330);
  assert.ok(Math.abs((await box(page, '#panel')).height - 422) < 3);
  await dragSheet(page, 300);
  assert.ok(!(await page.isVisible('#panel')), 'dragging down closes the sheet');
  assert.equal((await box(page, 'canvas')).width, 390);
}

const isIdle = (page) => page.evaluate(() => document.querySelector('#stage').classList.contains('idle'));

async function idleBar(context) {
  await context.clock.install();
  const { page } = await show(context, 'idle', MOVING, '#scale=0.25');
  await page.mouse.move(300, 200);
  await page.clock.pauseAt(Date.now() + 3600e3);
  await page.mouse.move(305, 200);
  assert.ok(!(await isIdle(page)));
  await page.clock.fastForward(2000);
  assert.ok(!(await isIdle(page)), 'the bar stays at first');
  await page.clock.fastForward(1000);
  await page.waitForFunction(() => document.querySelector('#stage').classList.contains('idle'));
  await page.waitForFunction(() => getComputedStyle(document.querySelector('#bar')).opacity === '0');
  await page.mouse.move(310, 200);
  assert.ok(!(await isIdle(page)), 'the bar comes back');
  await page.click('#play');
  await page.mouse.move(310, 200);
  await page.clock.fastForward(5000);
  assert.ok(!(await isIdle(page)), 'the bar stays while paused');
}

async function fullScreen(context) {
  await context.clock.install();
  const { page } = await show(context, 'full', MOVING, '#paused');
  await page.click('#full');
  await page.waitForFunction(() => document.fullscreenElement?.id === 'stage');
  const height = await page.evaluate(() => innerHeight);
  await page.waitForFunction((h) => document.querySelector('canvas').clientHeight === h, height);
  await page.mouse.move(300, 100);
  await page.clock.fastForward(3000);
  await page.waitForFunction(() => document.querySelector('#stage').classList.contains('idle'));
  // The clock is stopped, so that the bar does not hide meanwhile.
  await page.clock.pauseAt(Date.now() + 3600e3);
  await page.mouse.move(310, 100);
  assert.ok(!(await isIdle(page)), 'moving the pointer shows the bar');
  await page.hover('#play', { force: true });
  await page.clock.fastForward(3000);
  assert.ok(await isIdle(page), 'the bar hides even below a resting pointer');
  await page.keyboard.press('c');
  await page.waitForFunction(() => !document.fullscreenElement, null, { polling: 50 });
  assert.ok(await page.isVisible('#code'), 'the code is shown next to the canvas');
}

async function bare(context) {
  const embedded = await show(context, 'bare', MOVING, '#embed&paused');
  assert.deepEqual(await embedded.page.$$eval('#bar > *', (all) => all.filter((e) => e.checkVisibility()).map((e) => e.id)), ['play', 'restart', 'scrub', 'time', 'full']);
  assert.deepEqual(await box(embedded.page, 'canvas'), { x: 0, y: 0, width: 1000, height: 600 });
  assert.ok(!(await playing(embedded.page)));
  await embedded.page.click('#play');
  assert.ok(await playing(embedded.page));
  await embedded.page.keyboard.press('c');
  assert.ok(!(await embedded.page.isVisible('#panel')), 'there is no panel either');
  const off = await show(context, 'bare', MOVING, '#bar=off');
  assert.ok(!(await off.page.isVisible('#bar')));
  assert.ok(await playing(off.page), 'it plays automatically');
}

async function calm(context) {
  const { page } = await show(context, 'calm', MOVING, '');
  await frames(page);
  assert.ok(!(await playing(page)));
  assert.equal(await time(page), 0);
  assert.ok(colors(await pixels(page)) > 10, 'the first frame is drawn');
  await page.click('#begin');
  assert.ok(await playing(page));
  assert.ok(!(await page.isVisible('#begin')));
}

/** The contrast of two colours as defined by WCAG. */
function contrasts(page, selectors) {
  return page.evaluate((all) => {
    const parse = (color) => {
      const to = document.createElement('canvas').getContext('2d');
      to.fillStyle = color;
      to.fillRect(0, 0, 1, 1);
      return [...to.getImageData(0, 0, 1, 1).data];
    };
    const light = (c) => c.slice(0, 3).map((v) => v / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
    const back = (node) => {
      for (let at = node; at; at = at.parentElement) {
        const color = parse(getComputedStyle(at).backgroundColor);
        if (color[3] > 200) return color;
      }
      return [0, 0, 0, 255];
    };
    return all.flatMap((selector) => [...document.querySelectorAll(selector)].filter((n) => n.checkVisibility() && n.textContent.trim() && !n.disabled).map((node) => {
      const [a, b] = [light(parse(getComputedStyle(node).color)), light(back(node))];
      return [selector, node.textContent.slice(0, 20), (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)];
    }));
  }, selectors);
}

async function readable(context) {
  const code = MOVING.replace('float(STRIPES)', 'flot(STRIPES)').replace('void main', '/* a */ void main');
  const { page } = await show(context, 'readable', code, '#paused');
  const parts = ['button', 'small', 'p', 'h1', 'h2', '.excerpt span', '#bar output', '.control span', '.rows span', '.numbers div', 'dt', 'dd', '.field span', 'b'];
  const seen = await contrasts(page, parts);
  for (const tab of ['Controls', 'Code', 'Export']) {
    await openTab(page, tab);
    seen.push(...(await contrasts(page, parts)));
  }
  await page.click('#help');
  seen.push(...(await contrasts(page, ['dt', 'dd', 'dialog h2'])));
  assert.ok(seen.length > 60);
  assert.deepEqual(seen.filter(([, , contrast]) => contrast < 4.5), []);
}

/** An ISF shader with a control of each kind. */
const EVERY_KIND = `/*{ "INPUTS": [
  {"NAME": "speed", "TYPE": "float", "DEFAULT": 1, "MAX": 4},
  {"NAME": "steps", "TYPE": "long", "VALUES": [3, 6], "LABELS": ["three", "six"], "DEFAULT": 6},
  {"NAME": "soft", "TYPE": "bool", "DEFAULT": true},
  {"NAME": "ink", "TYPE": "color", "DEFAULT": [1, 0.5, 0.2, 1]},
  {"NAME": "center", "TYPE": "point2D", "DEFAULT": [0.5, 0.5]},
  {"NAME": "flash", "TYPE": "event"},
  {"NAME": "inputImage", "TYPE": "image"}
] }*/
void main() {
  vec2 p = isf_FragNormCoord - center;
  gl_FragColor = ink * speed * float(steps) * length(p) * (soft ? 1.0 : 2.0) + (flash ? 1.0 : 0.0) + IMG_NORM_PIXEL(inputImage, p);
}
`;

/** Calls a function for each state of the page. */
async function eachState(page, look) {
  await look('closed');
  for (const tab of ['Controls', 'About', 'Code', 'Export']) {
    await openTab(page, tab);
    await look(tab);
  }
  await page.click('#help');
  await look('help');
  await page.click('dialog button');
}

async function fingers(context) {
  for (const code of [EVERY_KIND, MOVING.replace('float(STRIPES)', 'flot(STRIPES)')]) {
    const { page } = await show(context, 'fingers', code, '#paused');
    const small = [];
    let count = 0;
    await eachState(page, async (state) => {
      const sizes = await page.evaluate(() => [...document.querySelectorAll('button, select, input:not([type=checkbox]), label, [role=separator]')].filter((n) => n.checkVisibility()).map((n) => {
        const { width, height } = n.getBoundingClientRect();
        return [n.id || n.getAttribute('aria-label') || n.textContent, width, height];
      }));
      count += sizes.length;
      small.push(...sizes.filter(([, w, h]) => w < 40 || h < 40).map((s) => [state, ...s]));
      const hidden = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.equal(hidden, 0, `${state} fits the width of the phone`);
    });
    assert.ok(count > 60, `${count}`);
    assert.deepEqual(small, []);
  }
}

/** Elements exposed to screen readers whose roles require a name. */
async function names(context) {
  const { page } = await show(context, 'names', EVERY_KIND, '#paused');
  const client = await context.newCDPSession(page);
  const roles = new Map();
  await eachState(page, async (state) => {
    const { nodes } = await client.send('Accessibility.getFullAXTree');
    for (const { ignored, role, name } of nodes) {
      if (ignored || !/^(button|slider|spinbutton|checkbox|combobox|tab|tablist|tabpanel|textbox|separator|dialog|navigation|complementary|progressbar|ColorWell)$/.test(role?.value)) continue;
      assert.ok(name?.value, `${state}: a ${role.value} without a name`);
      roles.set(role.value, (roles.get(role.value) ?? 0) + 1);
    }
  });
  for (const role of ['button', 'slider', 'spinbutton', 'checkbox', 'combobox', 'tab', 'textbox', 'separator', 'dialog']) assert.ok(roles.has(role), role);
}

/** Keyboard operation: Tab enters, arrows move, Escape leaves. */
async function keysAlone(context) {
  const { page } = await show(context, 'keys-alone', EVERY_KIND, '#paused');
  const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute('aria-label') || document.activeElement.textContent);
  const walk = async () => {
    const seen = [];
    for (let i = 0; i < 60; i++) {
      await page.keyboard.press('Tab');
      const at = await focused();
      if (seen.includes(at)) break;
      seen.push(at);
    }
    return seen;
  };
  const closed = await walk();
  for (const id of ['canvas', 'play', 'restart', 'scrub', 'scale', 'shot', 'record', 'full', 'more']) assert.ok(closed.includes(id), id);
  await page.focus('#more');
  await page.keyboard.press('Enter');
  const open = await walk();
  for (const name of ['grip', 'help', 'close', 'Controls', 'speed', 'speed, number', 'steps', 'u.soft', 'ink', 'center.x', 'center.y, number', 'flash', 'File for Image inputImage']) assert.ok(open.includes(name), `${name} of ${open}`);
  await page.focus('#tabs [aria-selected=true]');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'Code');
  await page.focus('.editor textarea');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'Image', 'Escape leaves the editor');
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#panel')));
  assert.equal(await focused(), 'more', 'a second Escape closes the panel and restores the focus');
  await page.keyboard.press('Enter');
  await page.click('#close');
  assert.equal(await focused(), 'more');
}

/** The bar of a narrow page shows the necessary buttons completely. */
async function narrowBar(context) {
  const { page } = await show(context, 'narrow-bar', MOVING, '#paused');
  for (const width of [340, 420, 500, 1000]) {
    await page.setViewportSize({ width: width + 360, height: 500 });
    if (!(await page.isVisible('#panel'))) await openTab(page, 'Controls');
    const stage = await box(page, '#stage');
    for (const id of ['#play', '#scrub', '#full', '#more']) {
      const { x, width: w } = await box(page, id);
      assert.ok(x >= stage.x && x + w <= stage.x + stage.width, `${id} at ${width}`);
    }
    assert.ok((await box(page, '#scrub')).width >= 40);
  }
}

export const layoutTests = [
  { name: 'page: touch targets are large enough', run: fingers, context: phone },
  { name: 'page: controls have names for screen readers', run: names, context: desk },
  { name: 'page: everything works with the keyboard', run: keysAlone, context: desk },
  { name: 'page: the bar fits a narrow page', run: narrowBar, context: desk },
  { name: 'page: the panel is next to the canvas', run: beside, context: desk },
  { name: 'page: the panel is a sheet on a phone', run: sheet, context: phone },
  { name: 'page: the bar hides when idle', run: idleBar, context: desk },
  { name: 'page: the canvas fills the screen', run: fullScreen, context: desk },
  { name: 'page: embedded pages show a small bar or none', run: bare, context: desk },
  { name: 'page: reduced motion starts with a button', run: calm, context: { ...desk, reducedMotion: 'reduce' } },
  { name: 'page: text is readable in light mode', run: readable, context: { ...desk, colorScheme: 'light' } },
  { name: 'page: text is readable in dark mode', run: readable, context: { ...desk, colorScheme: 'dark' } },
];
