// What can be seen in the files of the site: links and their anchors, what search engines read, and the
// shaders that "Try it" opens.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { base, repository, site } from '../../site/.vitepress/address.js';
import { addresses } from '../../site/.vitepress/pages.js';
import { attributes, folder, pages, textOf, unescaped } from './read.js';

const all = pages();
const byAddress = new Map(all.map((page) => [page.address, page]));

/** What is wrong with a link of a page, if anything. */
function complaint(link, page) {
  const from = `http://page.test${base}${page.address.slice(1)}`;
  const to = new URL(link, from);
  if (to.origin !== 'http://page.test') return undefined;
  if (!to.pathname.startsWith(base)) return 'is outside the site';
  const pathname = `/${to.pathname.slice(base.length)}`;
  // Built from a folder of its own, which may be missing.
  if (pathname === '/playground/') return undefined;
  const target = byAddress.get(decodeURIComponent(pathname));
  if (!target) return fs.existsSync(path.join(folder, pathname)) && path.extname(pathname) ? undefined : 'refers to no page';
  const anchor = decodeURIComponent(to.hash.slice(1));
  return anchor && !target.anchors.has(anchor) ? 'refers to no anchor' : undefined;
}

function links() {
  const wrong = [];
  const linked = new Set();
  let count = 0;
  for (const page of all) {
    for (const link of new Set([...attributes(page.html, 'href'), ...attributes(page.html, 'src')])) {
      const what = complaint(link, page);
      if (what) wrong.push(`${page.address}: ${link} ${what}`);
      const address = new URL(link, `http://page.test${base}${page.address.slice(1)}`).pathname.slice(base.length);
      if (`/${address}` !== page.address) linked.add(address);
      count++;
    }
  }
  assert.equal(wrong.length, 0, wrong.join('\n'));
  assert.deepEqual([...addresses.values()].filter((address) => !linked.has(address)), [], 'no other page has a link to these');
  assert.ok(count > 10000, `only ${count} links`);
}

/** Nothing is loaded from another host, and links to files of the repository have its address. */
function otherHosts() {
  const wrong = [];
  for (const { address, html } of all) {
    for (const [tag] of html.matchAll(/<(script|img|link|iframe|source|video)\s[^>]*>/g)) {
      const isLoaded = !/rel="canonical"/.test(tag);
      if (isLoaded && /(src|href)="(https?:)?\/\//.test(tag)) wrong.push(`${address}: ${tag}`);
    }
  }
  assert.equal(wrong.length, 0, wrong.join('\n'));
  const known = all.flatMap(({ html }) => attributes(html, 'href')).filter((link) => link.startsWith(`${repository}/blob/`));
  for (const link of new Set(known)) {
    const file = link.slice(`${repository}/blob/HEAD/`.length).replace(/#.*/, '');
    assert.ok(fs.existsSync(path.join(folder, '../..', file)), `${link} refers to no file`);
  }
}

function meta(html, attribute, name) {
  const tag = new RegExp(`<meta ${attribute}="${name}" content="([^"]*)"`).exec(html);
  return tag && unescaped(tag[1]);
}

/** Titles and descriptions are of the page, and the addresses for search engines exist. */
function found() {
  const titles = new Map();
  for (const { address, html } of all) {
    if (address === '/404.html') continue;
    const title = textOf(/<title>(.*?)<\/title>/.exec(html)[1]);
    assert.ok(!titles.has(title), `${address} and ${titles.get(title)} have the title "${title}"`);
    titles.set(title, address);
    const description = meta(html, 'name', 'description');
    assert.ok(description?.length > 15 && description.length < 180, `${address}: description "${description}"`);
    assert.equal(meta(html, 'property', 'og:description'), description, address);
    assert.equal(meta(html, 'property', 'og:title'), title, address);
    assert.match(html, new RegExp(`<link rel="canonical" href="${site}${address.slice(1)}">`));
    const image = meta(html, 'property', 'og:image');
    assert.ok(image.startsWith(site) && fs.existsSync(path.join(folder, image.slice(site.length))), `${address}: ${image}`);
  }
  const map = fs.readFileSync(path.join(folder, 'sitemap.xml'), 'utf8');
  const listed = Array.from(map.matchAll(/<loc>([^<]*)<\/loc>/g), ([, url]) => url.slice(site.length)).sort();
  assert.deepEqual(listed, [...addresses.values(), 'playground/'].sort());
  assert.deepEqual([...titles.values()].sort(), [...addresses.values()].map((address) => `/${address}`).sort());
}

/** The text in a link, as the playground reads it. */
function decoded(data, address) {
  try {
    return zlib.inflateRawSync(Buffer.from(data, 'base64url')).toString();
  } catch (error) {
    throw new Error(`${address}: ${data}: ${error.message}`);
  }
}

/** Each example has a link, and the link has its code. */
function shaders() {
  let count = 0;
  let pages = 0;
  for (const { address, html } of all) {
    for (const [, figure] of html.matchAll(/<figure class="example (?!output)[a-z]+">(.*?)<\/figure>/gs)) {
      const code = textOf(/<pre[^>]*>(.*?)<\/pre>/s.exec(figure)[1]);
      const link = attributes(figure, 'href').find((href) => href.startsWith(`${base}playground/#code=`));
      assert.ok(link, `${address}: an example without a link:\n${code}`);
      const data = link.split('#code=')[1];
      assert.match(data, /^[\w-]+$/, address);
      const linked = decoded(data, address);
      const isPage = /<(script|canvas)/.test(code);
      const text = isPage ? Object.entries(JSON.parse(linked)).find(([name]) => name.endsWith('.html'))[1] : linked;
      assert.equal(text.trimEnd(), code.trimEnd(), address);
      if (isPage) pages++;
      count++;
    }
  }
  assert.ok(count > 400 && pages > 10, `only ${count} examples, ${pages} of them pages`);
}

export const builtTests = [
  { name: 'links and their anchors exist', run: links },
  { name: 'nothing is loaded from another host', run: otherHosts },
  { name: 'titles, descriptions and the sitemap are complete', run: found },
  { name: 'links to the playground have the code of their example', run: shaders },
];
