// How shaders get into the playground, and the playground into the browser: addresses, examples, the theme,
// and opening it without a network.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { drawn, findings, imageOf, linkTo, text, within } from './playground.js';
import { serve } from './serve.js';

const red = 'void mainImage(out vec4 c, in vec2 p) {\n    c = vec4(1.0, 0.0, 0.0, 1.0);\n}\n';

/** A server elsewhere: answers by path, and notes the headers of requests. */
async function elsewhere(answers) {
  const seen = [];
  const server = http.createServer((request, response) => {
    seen.push(request.headers);
    if (request.url === '/never') return;
    const { status = 200, headers = {}, body = '' } = answers[request.url] ?? { status: 404 };
    response.writeHead(status, { 'Access-Control-Allow-Origin': '*', ...headers }).end(body);
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { seen, address: `http://127.0.0.1:${port}`, end: () => {
    server.close();
    server.closeAllConnections();
  } };
}

async function addresses(browser, address) {
  const script = '// <script>alert(1)</script>\nvoid mainImage(out vec4 c, in vec2 p) {\n    c = vec4(2);\n    c = 1;\n}\n';
  const other = await elsewhere({
    '/a/water.frag': { body: script, headers: { 'Set-Cookie': 'a=b' } },
    '/long.glsl': { body: 'x'.repeat(2 << 20) },
    '/image.png': { body: Buffer.from([0x89, 0x50, 0x4e, 0x47, 0, 0xff]) },
    '/private.glsl': { body: red, headers: { 'Access-Control-Allow-Origin': 'https://example.org' } },
    '/away.glsl': { status: 302, headers: { Location: 'http://shaders.invalid/x.glsl' } },
  });
  try {
    for (const fragment of [`#url=${other.address}/a/water.frag`, `#url=${encodeURIComponent(`${other.address}/a/water.frag`)}`]) {
      await within(browser, address, { fragment, allowed: other.address }, async (page) => {
        await findings(page, { has: ['type-mismatch'] });
        assert.equal(await text(page), script);
        assert.deepEqual(await page.getByRole('tab').allInnerTexts(), ['water.frag']);
        assert.equal(await page.locator('#notice').isVisible(), false);
      });
    }
    assert.ok(other.seen.length === 2 && other.seen.every(({ cookie, referer }) => !cookie && !referer));
    await within(browser, address, { fragment: `#url=${other.address}/never`, allowed: other.address, mayComplain: true }, async (page) => {
      await page.locator('#notice', { hasText: 'Loading from 127.0.0.1' }).waitFor();
      await page.locator('#examples').click();
      await page.getByRole('button', { name: 'cast_is_reserved.glsl' }).click();
      await findings(page, { has: ['reserved-word'] });
      assert.equal(await page.locator('#notice').isVisible(), false);
    });
    const failures = {
      [`${other.address}/long.glsl`]: 'longer than 1 MB',
      [`${other.address}/image.png`]: 'not a text',
      [`${other.address}/none.glsl`]: '127.0.0.1 answered with status 404',
      [`${other.address}/private.glsl`]: '127.0.0.1 cannot be reached, or does not allow other sites to read it',
      [`${other.address}/away.glsl`]: '127.0.0.1 cannot be reached',
      'http://example.org/x.glsl': 'must begin with https://',
      'javascript:alert(1)': 'must begin with https://',
      'data:text/plain,x': 'must begin with https://',
      'water.frag': 'not valid',
    };
    for (const [url, reason] of Object.entries(failures)) {
      await within(browser, address, { fragment: `#url=${url}`, allowed: other.address, mayComplain: true }, async (page) => {
        await page.locator('#notice', { hasText: `The link cannot be opened: ` }).and(page.locator('#notice', { hasText: reason })).waitFor();
        assert.equal(await text(page), '');
      });
    }
  } finally {
    other.end();
  }
}

/** The policy of the page: an address can be read, and nothing else comes from elsewhere. */
async function policy(browser, address) {
  await within(browser, address, { mayComplain: true }, async (page) => {
    const refused = (make) => page.evaluate((code) => {
      const violation = new Promise((resolve) => { document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => resolve(effectiveDirective), { once: true }); });
      const elements = {
        script: () => Object.assign(document.createElement('script'), { src: 'https://example.invalid/x.js' }),
        inline: () => Object.assign(document.createElement('script'), { textContent: 'window.ran = true' }),
        image: () => Object.assign(document.createElement('img'), { src: 'https://example.invalid/x.png' }),
        frame: () => Object.assign(document.createElement('iframe'), { src: 'https://example.invalid/' }),
      };
      document.body.append(elements[code]());
      return violation;
    }, make);
    assert.equal(await refused('script'), 'script-src-elem');
    assert.equal(await refused('inline'), 'script-src-elem');
    assert.equal(await refused('image'), 'img-src');
    assert.equal(await refused('frame'), 'frame-src');
    assert.equal(await page.evaluate(() => /** @type {any} */ (window).ran), undefined);
  });
}

async function examples(browser, address) {
  await within(browser, address, {}, async (page) => {
    await findings(page, { has: ['nan-pixels'] });
    const loaded = () => page.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => name.includes('examples.json')));
    assert.equal(await loaded(), false, 'examples are loaded with the page');
    await page.locator('#examples').focus();
    await page.keyboard.press('Enter');
    const dialog = page.getByRole('dialog', { name: 'Examples' });
    await dialog.getByLabel('Find').fill('sqrt negative');
    const group = dialog.locator('section:visible', { hasText: 'sqrt-negative' });
    await group.getByRole('button', { name: 'Not reported' }).first().waitFor();
    const bad = group.getByRole('button', { name: 'Reported', exact: true });
    assert.equal(await dialog.locator('section:visible', { hasText: 'faulty-macro' }).count(), 0);
    await bad.focus();
    await page.keyboard.press('Enter');
    await findings(page, { has: ['sqrt-negative'] });
    assert.equal(await dialog.isVisible(), false);
    // Shaders in pages are examples too.
    await page.locator('#examples').click();
    await dialog.getByLabel('Find').fill('webgl1-context');
    await dialog.locator('section:visible').getByRole('button', { name: 'Reported', exact: true }).click();
    await findings(page, { has: ['webgl1-context'] });
    await page.getByRole('tab', { name: 'page.html' }).waitFor();
  });
}

/** The background of the page, the editor and the bar of the image. */
async function colors(page) {
  const frame = await imageOf(page);
  const isDark = ([r, g, b]) => r + g + b < 384;
  const numbers = (css) => css.match(/\d+/g).slice(0, 3).map(Number);
  const own = await page.evaluate(() => [document.body, /** @type {any} */ (document.querySelector('#code')).shadowRoot.querySelector('.cm-editor')].map((e) => getComputedStyle(e).backgroundColor));
  const inside = await frame.evaluate(() => getComputedStyle(document.querySelector('#bar')).backgroundColor);
  return [...own, inside].map((css) => isDark(numbers(css)));
}

/** Waits until these are dark. The frame gets the theme in a message. */
async function becomes(page, expected) {
  while (String(await colors(page)) !== String(expected));
}

const KEY = 'vitepress-theme-appearance';

async function themes(browser, address) {
  await within(browser, address, { fragment: linkTo(red), colorScheme: 'light', reducedMotion: 'reduce' }, async (page) => {
    await drawn(page, [255, 0, 0, 255]);
    assert.deepEqual(await colors(page), [false, false, false]);
    await page.getByLabel('Theme').selectOption('Dark');
    assert.equal(await page.evaluate((key) => localStorage.getItem(key), KEY), 'dark');
    await becomes(page, [true, true, true]);
    // The next image has the theme too.
    await page.evaluate((hash) => { location.hash = hash; }, linkTo(red.replace('1.0, 0.0, 0.0', '0.0, 1.0, 0.0')));
    await drawn(page, [0, 255, 0, 255]);
    await becomes(page, [true, true, true]);
    // Another page of the site changes it.
    const other = await page.context().newPage();
    await other.goto(address);
    await other.evaluate((key) => localStorage.setItem(key, 'light'), KEY);
    await page.waitForFunction(() => document.documentElement.dataset.theme === 'light');
    assert.equal(await page.getByLabel('Theme').inputValue(), 'light');
    await other.evaluate((key) => localStorage.setItem(key, 'auto'), KEY);
    await page.waitForFunction(() => document.documentElement.dataset.theme === undefined);
    await other.evaluate((key) => localStorage.setItem(key, 'dark'), KEY);
    await other.close();
    const again = await page.context().newPage();
    // Before any module is loaded, so that no light page is seen.
    await again.route('**/assets/index-*.js', (route) => route.fulfill({ contentType: 'text/javascript', body: '' }));
    await again.goto(`${address}playground/`);
    assert.equal(await again.evaluate(() => document.documentElement.dataset.theme), 'dark');
    await again.close();
  });
}

/** A copy of the built site that can be changed, with a server. */
async function deployment(address) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'playground-'));
  const server = await serve(folder);
  const response = await fetch(`${address}playground/service-worker.js`);
  const files = JSON.parse(/FILES = (\[.*?\]);/.exec(await response.text())[1]);
  for (const file of [...files, 'service-worker.js', '../404.html', '../favicon.svg']) {
    const body = await fetch(`${address}playground/${file}`);
    const to = path.join(folder, 'playground', file === './' ? 'index.html' : file);
    fs.mkdirSync(path.dirname(to), { recursive: true });
    fs.writeFileSync(to, Buffer.from(await body.arrayBuffer()));
  }
  const at = (file) => path.join(folder, 'playground', file);
  const end = async () => {
    await server.end();
    fs.rmSync(folder, { recursive: true });
  };
  return { at, end, address: server.address };
}

/** Another version of the playground: its script has another name, and the page another title. */
function deploy({ at }) {
  const edit = (file, change) => fs.writeFileSync(at(file), change(fs.readFileSync(at(file), 'utf8')));
  const scripts = () => fs.readdirSync(at('assets')).filter((file) => file.endsWith('.js'));
  const script = scripts().find((file) => file.startsWith('start-'));
  const renamed = 'start-NEWnew00.js';
  fs.renameSync(at(`assets/${script}`), at(`assets/${renamed}`));
  const files = ['index.html', 'service-worker.js', ...scripts().map((file) => `assets/${file}`)];
  for (const file of files) edit(file, (code) => code.replaceAll(script, renamed));
  edit('index.html', (html) => html.replace('<title>', '<title>New: '));
  edit('service-worker.js', (code) => code.replace(/VERSION = '/, "VERSION = 'new"));
}

/** Waits until the service worker of the page has stored everything. */
const stored = (page) => page.evaluate(async () => {
  await navigator.serviceWorker.ready;
  if (!navigator.serviceWorker.controller) await new Promise((resolve) => { navigator.serviceWorker.addEventListener('controllerchange', resolve, { once: true }); });
});

/** The versions that are stored. */
const versions = (page) => page.evaluate(() => caches.keys());

async function offline(browser, address) {
  const site = await deployment(address);
  try {
    await within(browser, site.address, { mayComplain: true, reducedMotion: 'reduce' }, async (page) => {
      const context = page.context();
      await stored(page);
      assert.equal((await versions(page)).length, 1);
      await context.setOffline(true);
      await page.goto(`${site.address}playground/${linkTo(red)}`);
      await page.reload();
      await findings(page, { count: 0 });
      await drawn(page, [255, 0, 0, 255]);
      await page.locator('#examples').click();
      await page.getByRole('button', { name: 'cast_is_reserved.glsl' }).click();
      await findings(page, { has: ['reserved-word'] });
      await context.setOffline(false);
    });
  } finally {
    await site.end();
  }
}

async function deploying(browser, address) {
  const site = await deployment(address);
  try {
    await within(browser, site.address, { mayComplain: true }, async (page) => {
      await stored(page);
      const [old] = await versions(page);
      deploy(site);
      await page.goto(`${site.address}playground/`);
      assert.match(await page.title(), /^New: /);
      await findings(page, { has: ['nan-pixels'] });
      // The old version goes when no page of it is open.
      await page.evaluate(async () => {
        const registration = await navigator.serviceWorker.ready;
        const next = (target, type) => new Promise((resolve) => { target.addEventListener(type, resolve, { once: true }); });
        while (!registration.waiting) {
          await (registration.installing ? next(registration.installing, 'statechange') : next(registration, 'updatefound'));
        }
      });
      assert.equal((await versions(page)).length, 2);
      await page.goto('about:blank');
      const next = await page.context().newPage();
      await next.goto(`${site.address}playground/`);
      while ((await versions(next)).includes(old));
      const kept = await versions(next);
      assert.ok(kept.length === 1 && kept[0].includes('new'), kept.join());
      await next.context().setOffline(true);
      await next.reload();
      assert.match(await next.title(), /^New: /);
      await findings(next, { has: ['nan-pixels'] });
    });
  } finally {
    await site.end();
  }
}

/** Without service workers, and where nothing can be stored, everything else works. */
async function unsupported(browser, address) {
  const init = [() => {
    Object.defineProperty(Navigator.prototype, 'serviceWorker', { get: () => undefined });
    Object.defineProperty(window, 'localStorage', { get: () => { throw new DOMException('denied', 'SecurityError'); } });
  }];
  await within(browser, address, { init }, async (page) => {
    await findings(page, { has: ['nan-pixels'] });
    await page.getByLabel('Theme').selectOption('Dark');
    await page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
  });
}

export const openingTests = [
  { name: 'the playground opens shaders at addresses', run: addresses },
  { name: 'the playground loads nothing else from elsewhere', run: policy },
  { name: 'the playground has the examples of all rules', run: examples },
  { name: 'the playground shares its theme with the documentation', run: themes },
  { name: 'the playground opens without a network', run: offline },
  { name: 'a new playground replaces the stored one', run: deploying },
  { name: 'the playground needs no service worker and no storage', run: unsupported },
];
