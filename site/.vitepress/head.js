// What search engines and other sites show of a page.
import { site } from './address.js';
import { addresses, read } from './pages.js';

const LONGEST = 160;

/** The first paragraph of a page, without marks of Markdown. */
export function description(file) {
  const blocks = read(file).split(/\n{2,}/).map((block) => block.trim());
  const isText = (block) => /^[\p{L}`*[]/u.test(block) && !/^\*\*(Group:|Compile error)/.test(block);
  const first = blocks.slice(blocks.findIndex((block) => block.startsWith('# ')) + 1).find(isText) ?? '';
  // VitePress writes the description into an attribute as it is.
  const text = first.replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/[`*]/g, '').replaceAll('"', "'").replace(/\s+/g, ' ');
  if (text.length <= LONGEST) return text;
  const cut = text.slice(0, LONGEST);
  const sentence = cut.lastIndexOf('. ');
  return sentence > LONGEST / 2 ? cut.slice(0, sentence + 1) : `${cut.slice(0, cut.lastIndexOf(' '))} …`;
}

/** A word after the title that makes it understandable in a list of results. */
const KINDS = [['rules/errors/', 'compile error'], ['rules/hosts/', 'host'], ['rules/', 'rule']];

/** Titles of pages whose heading is also that of another page. */
const TITLES = { 'editors/README.md': 'Editor setup', 'rules/hosts/README.md': 'All hosts' };

export function title(pageData) {
  const own = TITLES[pageData.filePath];
  if (own) return own;
  const kind = KINDS.find(([folder]) => pageData.filePath.startsWith(folder));
  return kind && !pageData.filePath.endsWith('README.md') ? `${pageData.title} (${kind[1]})` : pageData.title;
}

export function head({ pageData, title: full, description: text }) {
  const address = addresses.get(pageData.filePath);
  if (address === undefined) return [];
  const meta = (property, content) => ['meta', { property, content }];
  return [
    ['link', { rel: 'canonical', href: site + address }],
    meta('og:type', 'website'),
    meta('og:site_name', 'shaderlint'),
    meta('og:title', full),
    meta('og:description', text),
    meta('og:url', site + address),
    meta('og:image', `${site}preview.png`),
    meta('og:image:width', '960'),
    meta('og:image:height', '520'),
    meta('og:image:alt', 'A landscape drawn by a shader, with sliders for its constants'),
    ['meta', { name: 'twitter:card', content: 'summary_large_image' }],
  ];
}
