// The site in a browser: on wide and narrow windows, light and dark, with the keyboard, and its search.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import zlib from 'node:zlib';
import { close, watch } from './watch.js';

const axe = createRequire(new URL('../../site/package.json', import.meta.url)).resolve('axe-core/axe.min.js');

/** A page of each kind. */
const KINDS = {
  home: '',
  documentation: 'docs/porting/',
  comparison: 'docs/comparison/',
  rule: 'rules/sqrt-negative/',
  error: 'errors/faulty-macro/',
  host: 'hosts/shadertoy/',
  rules: 'rules/',
};

const WINDOWS = [1280, 390].flatMap((width) => ['light', 'dark'].map((colorScheme) => (
  { width, colorScheme: /** @type {'light' | 'dark'} */ (colorScheme) })));

/** Opens a page and waits until its components run. */
async function open(context, address, to) {
  const page = await context.newPage();
  const add = watch(page, address);
  page.on('response', (response) => {
    if (response.status() >= 400) add(`${response.status()}: ${response.url()}`);
  });
  await page.goto(address + to);
  await page.waitForFunction(() => /** @type {any} */ (document.querySelector('#app')).__vue_app__);
  return page;
}

/** Runs a test in a window of its own. */
async function within(browser, options, run) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  context.setDefaultTimeout(0);
  // The playground has tests of its own, and may not be built.
  await context.route('**/playground/**', (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>playground</title>' }));
  try {
    await run(context);
  } finally {
    await close(context);
  }
}

/** The problems that axe finds, contrast among them. */
async function inaccessible(page) {
  await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate(() => /** @type {any} */ (globalThis).axe.run({
    runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'],
    // The theme's search button shows its keys, which are not part of its name.
    rules: { 'label-content-name-mismatch': { enabled: false } },
  }));
  return violations.flatMap(({ id, nodes }) => nodes.slice(0, 3).map(({ html, failureSummary }) => `${id}: ${html}\n${failureSummary}`));
}

/** No errors, no sideways scrolling, and readable. */
function looks(kind, to, windows) {
  return async (browser, address) => {
    for (const { width, colorScheme } of windows) {
      await within(browser, { viewport: { width, height: 900 }, colorScheme, reducedMotion: 'reduce' }, async (context) => {
        const page = await open(context, address, to);
        const what = `${to} at ${width} pixels, ${colorScheme}`;
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${what} is ${wide} pixels wide`);
        assert.equal(await page.evaluate(() => document.documentElement.classList.contains('dark')), colorScheme === 'dark', what);
        const found = await inaccessible(page);
        assert.equal(found.length, 0, `${what}:\n${found.join('\n')}`);
        if (process.env.SCREENSHOTS) {
          fs.mkdirSync(process.env.SCREENSHOTS, { recursive: true });
          await page.screenshot({ path: path.join(process.env.SCREENSHOTS, `${kind}-${width}-${colorScheme}.png`) });
        }
      });
    }
  };
}

/** Types into the search; the results are links. */
async function search(page, words) {
  await page.keyboard.press('Control+k');
  await page.fill('.VPLocalSearchBox input', words);
  return page.locator('.VPLocalSearchBox .result');
}

async function searches(browser, address) {
  for (const width of [1280, 390]) {
    await within(browser, { viewport: { width, height: 900 } }, async (context) => {
      const page = await open(context, address, '');
      const results = await search(page, 'sqrt-negative');
      await results.first().waitFor();
      assert.match(await results.first().getAttribute('href'), /^\/rules\/sqrt-negative\//);
      await page.keyboard.press('Enter');
      await page.waitForURL('**/rules/sqrt-negative/*');
      await page.waitForSelector('h1:has-text("sqrt-negative")');
      // A message that somebody pastes.
      const pasted = await search(page, 'the definition of macro ends with');
      await pasted.and(page.locator('[href^="/errors/faulty-macro/"]')).first().waitFor();
    });
  }
}

async function tries(browser, address) {
  await within(browser, {}, async (context) => {
    const page = await open(context, address, 'rules/sqrt-negative/');
    const example = page.locator('.example.bad').first();
    const code = await example.locator('pre').innerText();
    await example.locator('.try').click();
    await page.waitForURL('**/playground/#code=*');
    const data = new URL(page.url()).hash.slice('#code='.length);
    assert.equal(zlib.inflateRawSync(Buffer.from(data, 'base64url')).toString().trimEnd(), code.trimEnd());
    // The menu opens the playground too, instead of looking for a page of the documentation.
    await page.goto(`${address}rules/`);
    await page.click('.VPNavBar >> text=Playground');
    await page.waitForURL('**/playground/');
    assert.equal(await page.title(), 'playground');
  });
}

async function filters(browser, address) {
  await within(browser, {}, async (context) => {
    const page = await open(context, address, 'rules/sqrt-negative/');
    await page.click('.facts >> text=numeric');
    await page.waitForURL('**/rules/?group=numeric');
    const rules = page.locator('.rule-list li');
    const count = () => page.locator('.rule-count span').innerText();
    await page.waitForFunction(() => !/^(\d+) of \1 /.test(document.querySelector('.rule-count span')?.textContent ?? '0 of 0 '));
    assert.match(await count(), new RegExp(`^${await rules.count()} of \\d+ rules$`));
    assert.equal(await page.getByLabel('Group').inputValue(), 'numeric');
    await page.getByLabel('Name or summary').fill('sqrt negative');
    await page.waitForFunction(() => document.querySelectorAll('.rule-list li').length === 1);
    assert.equal(await rules.locator('a').first().innerText(), 'sqrt-negative');
    await page.click('text=Show all');
    await page.waitForFunction(() => /^(\d+) of \1 /.test(document.querySelector('.rule-count span').textContent));
    await page.waitForURL('**/rules/');
  });
}

async function keyboard(browser, address) {
  await within(browser, {}, async (context) => {
    const page = await open(context, address, 'rules/sqrt-negative/');
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.textContent.trim()), 'Skip to content');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement.id === 'VPContent');
    // Long output can be scrolled: it has the focus at some point.
    const isInBlock = () => page.evaluate(() => document.activeElement.matches('.terminal'));
    for (let count = 0; count < 300 && !await isInBlock(); count++) await page.keyboard.press('Tab');
    assert.ok(await isInBlock(), 'Tab does not reach the output');
  });
}

async function narrow(browser, address) {
  await within(browser, { viewport: { width: 390, height: 844 } }, async (context) => {
    const page = await open(context, address, 'docs/comparison/');
    await page.click('.VPNavBarHamburger');
    await page.click('.VPNavScreen >> text=Errors');
    await page.waitForURL('**/errors/');
    await page.click('.rule-list a');
    await page.waitForSelector('.facts .error');
    await page.click('.VPLocalNav .menu');
    await page.click('.VPSidebar >> text=sampler-restriction');
    await page.waitForURL('**/errors/sampler-restriction/');
  });
}

async function withoutScripts(browser, address) {
  await within(browser, { javaScriptEnabled: false }, async (context) => {
    const page = await context.newPage();
    await page.goto(`${address}rules/sqrt-negative/`);
    assert.match(await page.innerText('main'), /argument of `sqrt` may be negative/);
    await page.goto(`${address}rules/`);
    assert.ok(await page.locator('.rule-list li').count() > 100);
  });
}

async function missing(browser, address) {
  await within(browser, {}, async (context) => {
    const page = await context.newPage();
    const response = await page.goto(`${address}rules/no-such-rule/`);
    assert.equal(response.status(), 404);
    await page.click('.NotFound a');
    await page.waitForSelector('.home');
    // As people shorten addresses.
    await page.goto(`${address}errors/faulty-macro`);
    await page.waitForURL('**/errors/faulty-macro/');
  });
}

export const pageTests = [
  // Both widths and both schemes; the other two pairs of them with --all.
  ...Object.entries(KINDS).flatMap(([kind, to]) => [
    { name: `the page of kind ${kind} is readable`, run: looks(kind, to, [WINDOWS[0], WINDOWS[3]]) },
    { name: `the page of kind ${kind} is readable in the other windows`, only: 'a sweep', run: looks(kind, to, [WINDOWS[1], WINDOWS[2]]) },
  ]),
  { name: 'the search finds rules and messages', run: searches },
  { name: 'an example opens in the playground', run: tries },
  { name: 'rules are filtered', run: filters },
  { name: 'the keyboard skips the menus and scrolls output', run: keyboard },
  { name: 'menus work in a narrow window', run: narrow },
  { name: 'pages are complete without scripts', run: withoutScripts },
  { name: 'a missing page leads to the others', run: missing },
];
