// The built pages as text.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The folder of the built site. */
export const folder = fileURLToPath(new URL('../../site/dist', import.meta.url));

const ENTITIES = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'", '#123': '{' };

/** A text of HTML, without marks of characters. */
export const unescaped = (html) => html.replace(/&(#?\w+);/g, (mark, name) => ENTITIES[name] ?? mark);

/** The text of a piece of HTML. */
export const textOf = (html) => unescaped(html.replace(/<[^>]*>/g, ''));

/** The values of an attribute of all elements. */
export const attributes = (html, name) => Array.from(html.matchAll(new RegExp(`\\s${name}="([^"]*)"`, 'g')), ([, value]) => unescaped(value));

/** @typedef {{address: string, html: string, anchors: Set<string>}} Page */

/** All pages that the generator wrote, without the playground. @returns {Page[]} */
export function pages() {
  const files = fs.readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((file) => file.replaceAll(path.sep, '/'));
  const wanted = files.filter((file) => file.endsWith('.html') && !file.startsWith('playground/'));
  return wanted.sort().map((file) => {
    const html = fs.readFileSync(path.join(folder, file), 'utf8');
    return { address: `/${file.replace(/index\.html$/, '')}`, html, anchors: new Set(attributes(html, 'id')) };
  });
}
