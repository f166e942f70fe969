// External text stays text: nothing in it runs, and the page still draws.
import assert from 'node:assert/strict';
import { colors, frame, open, port, put } from './browser.js';
import { shader } from './cases.js';

const WORDS = [
  ['end of the script element', '</script><script>globalThis.hacked = 1</script>'],
  ['comment that opens a script', '<!--<script>'],
  ['end of a comment', '--> <img src=x onerror="globalThis.hacked = 1">'],
  ['template literal', '`${globalThis.hacked = 1}`'],
  ['line separators', '\u2028globalThis.hacked = 1\u2029globalThis.hacked = 1//'],
  ['quotes', '"\'; globalThis.hacked = 1; //'],
  ['attribute', '" autofocus onfocus="globalThis.hacked = 1" x="'],
  ['a style', '</style><style>body { display: none }</style>'],
  ['placeholder of the template', '{{script}}{{project}}'],
  ['a link', 'javascript:globalThis.hacked=1'],
  ['one million letters', `</script>${'x'.repeat(1 << 20)}`],
];

async function check(context, words, index) {
  // An export may have 8 MiB: the longest text is used only for the title and the author's name.
  const short = words.slice(0, 1000);
  const code = `/* ${short.replaceAll('*/', '')} */
void mainImage(out vec4 O, vec2 U) { O = vec4(U / iResolution.xy, 0.5, 1.0); }`;
  const toy = shader({ type: 'image', name: short, code, inputs: [], outputs: [] });
  Object.assign(toy.info, { id: short, name: words, username: words, description: short, tags: [short] });
  toy.renderpass[0].inputs.push({ id: short, type: 'texture', channel: 0, filepath: short, sampler: { filter: short, wrap: short } });
  const address = await port(put(`hostile${index}.json`, JSON.stringify(toy)), `hostile${index}`);
  const { page } = await open(context, address, '#size=32x18&paused');
  await page.evaluate(() => globalThis.shaderport.ready);
  assert.ok(colors(await frame(page, 1)) > 1, 'the page draws');
  await page.click('#more');
  const seen = await page.evaluate(() => ({
    hacked: globalThis.hacked,
    title: document.querySelector('#title').textContent,
    description: document.querySelector('#description').textContent,
    links: [...document.links].map((a) => a.href),
    scripts: document.scripts.length,
    images: document.images.length,
    styles: document.querySelectorAll('style').length,
    errors: globalThis.shaderport.errors,
  }));
  assert.equal(seen.hacked, undefined, 'no injected code has run');
  assert.equal(seen.title, words);
  assert.equal(seen.description, short);
  assert.deepEqual([seen.links, seen.scripts, seen.images, seen.styles, seen.errors], [[], 3, 0, 1, []]);
}

async function policy(context) {
  const address = await port(put('policy.glsl', 'void mainImage(out vec4 O, vec2 U) { O = vec4(1.0); }'), 'policy');
  const { page } = await open(context, address, '#size=32x18&paused');
  const tries = await page.evaluate(async () => {
    const blocked = [];
    const all = new Promise((resolve) => {
      document.addEventListener('securitypolicyviolation', (e) => {
        blocked.push(e.effectiveDirective);
        if (blocked.length === 3) resolve();
      });
    });
    const script = document.createElement('script');
    script.textContent = 'globalThis.hacked = 1';
    document.body.append(script);
    const picture = new Image();
    picture.src = 'http://page.test/x.png';
    await fetch('http://page.test/').catch(() => {});
    await all;
    return { hacked: globalThis.hacked, blocked: blocked.sort() };
  });
  assert.equal(tries.hacked, undefined);
  assert.deepEqual(tries.blocked, ['connect-src', 'img-src', 'script-src-elem']);
}

export const hostileTests = [
  ...WORDS.map(([name, words], index) => ({
    name: `hostile: ${name}`,
    run: (context) => check(context, words, index),
  })),
  { name: 'hostile: the content security policy blocks requests', run: policy, mayComplain: true },
];
