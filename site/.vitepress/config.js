// Configuration of VitePress: https://vitepress.dev/reference/site-config
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitepress';
import { base, repository, site, source } from './address.js';
import { description, head, title } from './head.js';
import { braces } from './markdown/braces.js';
import { examples } from './markdown/examples.js';
import { facts } from './markdown/facts.js';
import { links } from './markdown/links.js';
import { addresses, excluded, read, root } from './pages.js';
import { sidebar } from './sidebar.js';

const here = fileURLToPath(new URL('..', import.meta.url));

/** Anchors as forges write them, so that links between files have the same ones everywhere. */
const slugify = (text) => text.trim().toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').replace(/\s/g, '-');

/** What the search finds of a page: its text and what is printed, without the code of examples. */
function searchable(text, env, md) {
  const html = md.render(text.replace(/^```(glsl|html|toml|yaml|json).*\n[^]*?^```$/gm, ''), env);
  return env.frontmatter?.search === false ? '' : html;
}

/** The icon of the repository. The theme would load others from another host. */
const branches = '<svg viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="2" style="fill:none"><circle cx="6" cy="5" r="2.5"/><circle cx="6" cy="19" r="2.5"/><circle cx="18" cy="8" r="2.5"/><path d="M6 7.5v9M18 10.5c0 4-12 2-12 6"/></svg>';

/** Adds what is not made from Markdown: the playground, the image of links, and `robots.txt`. */
function finish({ outDir, pages }) {
  const missing = [...addresses.keys()].filter((file) => !pages.includes(file));
  const unknown = pages.filter((file) => !addresses.has(file));
  if (missing.length + unknown.length > 0) throw new Error(`pages.js: no page is made from ${missing}; no address for ${unknown}`);
  const built = path.join(here, 'playground/dist');
  if (fs.existsSync(built)) fs.cpSync(built, path.join(outDir, 'playground'), { recursive: true });
  fs.copyFileSync(path.join(root, 'tests/browser/page.png'), path.join(outDir, 'preview.png'));
  fs.writeFileSync(path.join(outDir, 'robots.txt'), `User-agent: *\nAllow: /\nSitemap: ${site}sitemap.xml\n`);
}

/** Pages outside this folder find the packages of this folder. */
const packages = {
  name: 'packages of the site',
  enforce: 'pre',
  resolveId(id, importer, options) {
    if (!/^vue(\/|$)/.test(id) || !importer || importer.startsWith(here)) return null;
    return this.resolve(id, path.join(here, 'package.json'), { ...options, skipSelf: true });
  },
};

export default defineConfig({
  base,
  lang: 'en',
  title: 'shaderlint',
  description: 'Finds mistakes in GLSL shaders for WebGL2 and ShaderToy.',
  head: [
    ['link', { rel: 'icon', href: `${base}favicon.svg`, type: 'image/svg+xml' }],
    ['meta', { name: 'theme-color', media: '(prefers-color-scheme: light)', content: '#ffffff' }],
    ['meta', { name: 'theme-color', media: '(prefers-color-scheme: dark)', content: '#131519' }],
  ],

  srcDir: root,
  srcExclude: excluded(),
  outDir: path.join(here, 'dist'),
  cacheDir: path.join(here, '.cache'),
  rewrites: (file) => (addresses.has(file) ? `${addresses.get(file)}index.md` : file),
  cleanUrls: true,
  // One file for all pages instead of a copy of the sidebars in each.
  metaChunk: true,
  // The sidebars have so many links that loading them early would cost more than the page.
  router: { prefetchLinks: false },
  ignoreDeadLinks: [/^\/playground\//],
  sitemap: {
    hostname: site,
    transformItems: (items) => [...items, { url: 'playground/' }],
  },

  markdown: {
    anchor: { slugify },
    // The default themes have too little contrast.
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-default' },
    // It knows more of GLSL than the one of the highlighter.
    languages: [{ ...JSON.parse(read('editors/vscode/syntaxes/glsl.tmLanguage.json')), name: 'glsl' }],
    config(md) {
      // In this order: a paragraph that is replaced needs no links.
      facts(md);
      examples(md);
      links(md);
      braces(md);
    },
  },
  transformPageData(pageData) {
    // The pages of rules have the same few headings; the space is for their code.
    if (pageData.filePath.startsWith('rules/') && !pageData.filePath.endsWith('README.md')) pageData.frontmatter.aside = false;
    pageData.title = title(pageData);
    pageData.description ||= description(pageData.filePath);
  },
  transformHead: head,
  buildEnd: finish,

  vite: {
    publicDir: path.join(here, 'public'),
    plugins: [packages],
    server: { watch: { ignored: ['**/target/**'] } },
  },

  themeConfig: {
    logo: { src: '/favicon.svg', width: 24, height: 24, alt: '' },
    nav: [
      { text: 'Docs', link: '/docs/getting-started/', activeMatch: '^/(docs|editors|architecture|contributing|changelog|benchmarks|corpus)/' },
      { text: 'Rules', link: '/rules/', activeMatch: '^/rules/' },
      { text: 'Errors', link: '/errors/', activeMatch: '^/errors/' },
      { text: 'Hosts', link: '/hosts/', activeMatch: '^/hosts/' },
      { text: 'Playground', link: '/playground/', target: '_self' },
    ],
    sidebar: sidebar(),
    outline: { level: [2, 3], label: 'On this page' },
    socialLinks: [{ icon: { svg: branches }, link: repository, ariaLabel: 'Source code' }],
    editLink: { pattern: source(':path'), text: 'Source of this page' },
    footer: { message: 'Licensed under MIT or Apache-2.0, at your option.' },
    notFound: { title: 'Page not found', quote: 'The search at the top finds rules, errors and messages.', linkLabel: 'Go to the home page', linkText: 'Home page' },
    externalLinkIcon: false,
    search: {
      provider: 'local',
      options: { detailedView: false, _render: searchable, miniSearch: { searchOptions: { boost: { title: 6, titles: 1, text: 1 } } } },
    },
  },
});
