// Where things are: the panel beside the picture or below it, the bar, and pages without either.
import assert from 'node:assert/strict';
import { colors, frames, pixels } from '../browser.js';
import { desk, MOVING, openTab, phone, playing, show, time } from './show.js';

const box = (page, selector) => page.locator(selector).boundingBox();

/** How much of two boxes is the same place. */
function overlap(a, b) {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return Math.max(0, width) * Math.max(0, height);
}

async function beside(context) {
  const { page, complaints } = await show(context, 'beside', MOVING, '#paused');
  const whole = await box(page, 'canvas');
  assert.equal(whole.width, 1000);
  assert.equal(overlap(whole, await box(page, '#bar')), 0, 'the bar lies below the picture');
  await openTab(page, 'Controls');
  const small = await box(page, 'canvas');
  assert.equal(overlap(small, await box(page, '#panel')), 0, 'the panel lies beside the picture');
  await page.waitForFunction((w) => globalThis.shaderport.player.canvas.width === w, Math.round(small.width));
  assert.ok(colors(await pixels(page)) > 10, 'what is paused is drawn again');
  const panel = await box(page, '#panel');
  await page.mouse.move(panel.x, 300);
  await page.mouse.down();
  await page.mouse.move(panel.x - 100, 300, { steps: 3 });
  await page.mouse.up();
  assert.ok(Math.abs((await box(page, '#panel')).width - panel.width - 100) < 3, 'its edge can be dragged');
  await page.focus('#grip');
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await box(page, '#panel')).width - panel.width - 60) < 3, 'and moved by keys');
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#panel')));
  assert.equal((await box(page, 'canvas')).width, 1000);
  assert.deepEqual(complaints, []);
}

/** Drags the sheet by its grip, with a finger as the browser's own protocol has it. */
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
  const { page, complaints } = await show(context, 'sheet', MOVING, '#paused');
  await page.tap('#more');
  const open = await box(page, '#panel');
  assert.ok(Math.abs(open.height - 422) < 3 && open.width === 390, 'half the height');
  assert.equal(overlap(open, await box(page, 'canvas')), 0, 'the picture keeps the other half');
  assert.ok((await box(page, '#panel header')).height < 125, 'its head leaves room for what it holds');
  await dragSheet(page, -300);
  assert.ok((await box(page, '#panel')).height > 700, 'dragged up it is tall');
  await dragSheet(page, 330);
  assert.ok(Math.abs((await box(page, '#panel')).height - 422) < 3);
  await dragSheet(page, 300);
  assert.ok(!(await page.isVisible('#panel')), 'dragged down it is closed');
  assert.equal((await box(page, 'canvas')).width, 390);
  assert.deepEqual(complaints, []);
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
  assert.ok(!(await isIdle(page)), 'it waits');
  await page.clock.fastForward(1000);
  await page.waitForFunction(() => document.querySelector('#stage').classList.contains('idle'));
  await page.waitForFunction(() => getComputedStyle(document.querySelector('#bar')).opacity === '0');
  await page.mouse.move(310, 200);
  assert.ok(!(await isIdle(page)), 'it comes back');
  await page.click('#play');
  await page.mouse.move(310, 200);
  await page.clock.fastForward(5000);
  assert.ok(!(await isIdle(page)), 'it stays while the shader stands');
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
  // Time stands, so that it does not go by itself meanwhile.
  await page.clock.pauseAt(Date.now() + 3600e3);
  await page.mouse.move(310, 100);
  assert.ok(!(await isIdle(page)), 'the pointer brings the bar');
  await page.hover('#play', { force: true });
  await page.clock.fastForward(3000);
  assert.ok(await isIdle(page), 'it goes even from under a pointer that rests');
  await page.keyboard.press('c');
  await page.waitForFunction(() => !document.fullscreenElement, null, { polling: 50 });
  assert.ok(await page.isVisible('#code'), 'the code is shown beside the picture');
}

async function bare(context) {
  const embedded = await show(context, 'bare', MOVING, '#embed&paused');
  assert.ok(!(await embedded.page.isVisible('#bar')));
  assert.deepEqual(await box(embedded.page, 'canvas'), { x: 0, y: 0, width: 1000, height: 600 });
  assert.ok(!(await playing(embedded.page)));
  await embedded.page.click('#begin');
  assert.ok(await playing(embedded.page));
  assert.ok(!(await embedded.page.isVisible('#begin')));
  await embedded.page.keyboard.press('c');
  assert.ok(!(await embedded.page.isVisible('#panel')), 'no panel either');
  const off = await show(context, 'bare', MOVING, '#bar=off');
  assert.ok(!(await off.page.isVisible('#bar')));
  assert.ok(await playing(off.page), 'it plays by itself');
  assert.deepEqual([...embedded.complaints, ...off.complaints], []);
}

async function calm(context) {
  const { page, complaints } = await show(context, 'calm', MOVING, '');
  await frames(page);
  assert.ok(!(await playing(page)));
  assert.equal(await time(page), 0);
  assert.ok(colors(await pixels(page)) > 10, 'the first frame is there');
  await page.click('#begin');
  assert.ok(await playing(page));
  assert.ok(!(await page.isVisible('#begin')));
  assert.deepEqual(complaints, []);
}

/** How far two colours lie apart, as WCAG has it. */
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

/** Calls for what the page shows in each of its states. */
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
      assert.equal(hidden, 0, `${state} is as wide as the telephone`);
    });
    assert.ok(count > 60, `${count}`);
    assert.deepEqual(small, []);
  }
}

/** What a screen reader is told of, in the roles that have to have a name. */
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

/** Everything without a pointer: in by the Tab key, through by arrows, out by Escape. */
async function keysAlone(context) {
  const { page, complaints } = await show(context, 'keys-alone', EVERY_KIND, '#paused');
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
  for (const name of ['grip', 'help', 'close', 'Controls', 'speed', 'speed, number', 'steps', 'u.soft', 'ink', 'center.x', 'center.y, number', 'flash', 'file for Image inputImage']) assert.ok(open.includes(name), `${name} of ${open}`);
  await page.focus('#tabs [aria-selected=true]');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'Code');
  await page.focus('.editor textarea');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'Image', 'Escape leaves the code');
  await page.keyboard.press('Escape');
  assert.ok(!(await page.isVisible('#panel')));
  assert.equal(await focused(), 'more', 'and then the panel, for where it was opened');
  await page.keyboard.press('Enter');
  await page.click('#close');
  assert.equal(await focused(), 'more');
  assert.deepEqual(complaints, []);
}

/** The bar of a narrow picture holds what is needed, whole. */
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
  { name: 'page: targets for fingers', run: fingers, context: phone },
  { name: 'page: names for screen readers', run: names, context: desk },
  { name: 'page: reached by keys alone', run: keysAlone, context: desk },
  { name: 'page: the bar of a narrow picture', run: narrowBar, context: desk },
  { name: 'page: the panel lies beside the picture', run: beside, context: desk },
  { name: 'page: the panel is a sheet on a phone', run: sheet, context: phone },
  { name: 'page: the bar goes when nobody uses it', run: idleBar, context: desk },
  { name: 'page: full screen', run: fullScreen, context: desk },
  { name: 'page: embedded, or without its bar', run: bare, context: desk },
  { name: 'page: reduced motion starts with a button', run: calm, context: { ...desk, reducedMotion: 'reduce' } },
  { name: 'page: readable in the light', run: readable, context: { ...desk, colorScheme: 'light' } },
  { name: 'page: readable in the dark', run: readable, context: { ...desk, colorScheme: 'dark' } },
];
