// The small shaders of corpus/verdicts and the browser's verdict on each; their README describes the
// format.
import fs from 'node:fs';
import path from 'node:path';
import { top } from './browser.js';

const folder = path.join(top, 'corpus/verdicts');

/** The head of a case: the browser's verdict, the rule of shaderlint for it, version and stage, and a title. */
const HEAD = /^\/\/: (\?|accepted|refused \d+)(?: ([a-z][a-z0-9-]*))?(?:, ([a-z0-9 ]+))?(?:: (.+))?$/;

/** A case as a complete shader, with as little as it needs to compile: its first lines and how many were added up to them and after them. */
function wrap(code, isNew, isFragment, hasContext) {
  if (/^\s*#\s*version/m.test(code)) return { source: code, first: 0, added: [0, 0] };
  // Directives for a context stand before all code.
  const directives = hasContext ? code.match(/^(?:#.*\n)*/)[0] : '';
  const precision = isFragment ? 'precision highp float;\n' : '';
  const version = isNew ? '#version 300 es\n' : '#version 100\n';
  const after = /\bmain\b/.test(code) ? '' : 'void main() {}\n';
  return {
    source: version + directives + precision + code.slice(directives.length) + after,
    first: directives.split('\n').length,
    added: [1, isFragment ? 2 : 1],
  };
}

function read(file, head, at, code) {
  const found = head.match(HEAD);
  if (!found) throw new Error(`${file}:${at + 1}: not the head of a case: ${head}`);
  const [, verdict, rule, where, title] = found;
  const isNew = !/\b100\b/.test(where ?? '');
  const isFragment = !/\bvertex\b/.test(where ?? '');
  const hasContext = /\bwebgl[12]\b/.test(where ?? '');
  return {
    id: `${file}:${at + 1}`, at, verdict, rule, where, title, ok: verdict === 'accepted',
    stage: isFragment ? 'fragment' : 'vertex',
    api: /\bwebgl1\b/.test(where ?? '') ? 'webgl' : 'webgl2',
    isExtended: /\bextended\b/.test(where ?? ''),
    ...wrap(code, isNew, isFragment, hasContext),
  };
}

/** The lines of each file, and its cases. */
export function files() {
  return fs.readdirSync(folder).filter((f) => f.endsWith('.glsl')).sort().map((file) => {
    const lines = fs.readFileSync(path.join(folder, file), 'utf8').split('\n');
    const heads = lines.flatMap((line, i) => (line.startsWith('//:') ? [i] : []));
    const ends = (i) => lines.findIndex((l, k) => k > i && (/^\/\/[:#]/.test(l) || k === lines.length - 1));
    const code = (i) => `${lines.slice(i + 1, ends(i)).join('\n').trimEnd()}\n`;
    return { path: path.join(folder, file), lines, cases: heads.map((i) => read(file, lines[i], i, code(i))) };
  });
}

/** The head with the browser's current verdict: for a rejection, with the line in the case. */
export function head(one, { ok, line }) {
  const added = one.added[line > one.first ? 1 : 0];
  const verdict = ok ? 'accepted' : `refused ${Math.max(0, line - added)}`;
  const rule = !ok && one.rule ? ` ${one.rule}` : '';
  return `//: ${verdict}${rule}${one.where ? `, ${one.where}` : ''}${one.title ? `: ${one.title}` : ''}`;
}
