// Links: between files of the repository, as they work on a forge, and from the names of rules.
import fs from 'node:fs';
import path from 'node:path';
import { source } from '../address.js';
import { addresses, findings, root } from '../pages.js';

/** The file that a page is made from, relative to the repository; titles are rendered without one. */
export const fileOf = (env) => path.relative(root, env.realPath ?? env.path ?? root).replaceAll(path.sep, '/');

/** The address of what a link in `file` refers to. */
function resolve(href, file) {
  if (/^([a-z]+:|#)/.test(href)) return href;
  const [, to, rest] = /^([^?#]*)(.*)$/.exec(href);
  if (to.startsWith('/')) return href;
  const target = path.posix.join(path.posix.dirname(file), to);
  if (target === 'README.md') return `/${rest}`;
  if (addresses.has(target)) return `/${addresses.get(target)}${rest}`;
  if (!fs.existsSync(path.join(root, target))) throw new Error(`${file}: the link ${href} refers to no file`);
  return source(target) + rest;
}

/** Rewrites the links of a paragraph, and makes links of names of rules in code marks. */
function rewrite(children, file, Token, isHeading) {
  let depth = 0;
  return children.flatMap((token) => {
    if (token.type === 'link_open') {
      depth++;
      token.attrSet('href', resolve(token.attrGet('href'), file));
    }
    if (token.type === 'link_close') depth--;
    const address = token.type === 'code_inline' && token.content.includes('-') && findings.get(token.content);
    if (!address || depth > 0 || isHeading || address === `/${addresses.get(file)}`) return [token];
    const open = new Token('link_open', 'a', 1);
    open.attrSet('href', address);
    return [open, token, new Token('link_close', 'a', -1)];
  });
}

export function links(md) {
  md.core.ruler.push('links of the repository', (state) => {
    const file = fileOf(state.env);
    let isHeading = false;
    for (const token of state.tokens) {
      if (token.type.startsWith('heading_')) isHeading = token.nesting > 0;
      if (token.children) token.children = rewrite(token.children, file, state.Token, isHeading);
    }
  });
}
