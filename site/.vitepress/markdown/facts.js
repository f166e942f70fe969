// The head of the pages of rules and compile errors, and the lists of all of them.
import { base } from '../address.js';
import { fileOf } from './links.js';

/** A fact as a label with a link to what explains it. */
function label(key, value) {
  const text = value.replaceAll('`', '');
  const link = (to, name, words) => `<a class="fact ${name}" href="${base}${to}">${words}</a>`;
  switch (key) {
    case 'Compile error': return link('errors/', 'error', 'error');
    case 'Severity': return link(`rules/?severity=${text}`, text, text);
    case 'Group': return link(`rules/?group=${text}`, 'group', text);
    case 'Fix': return link('docs/fixes/', `fix-${text}`, text === 'none' ? 'no automatic fix' : `${text} fix`);
    case 'Default': return link('docs/configuration/', `default-${text.slice(0, 2).trim()}`, text === 'on' ? 'on by default' : text.replace('off (preset ', 'off; in preset ').replace(')', ''));
    case 'Since': return `<span class="fact since">since ${text}</span>`;
    default: return `<span class="fact">${key.toLowerCase()}: ${text}</span>`;
  }
}

/** The line `**Group:** numeric · **Severity:** warning` as labels, the severity first. */
export function labels(line) {
  const facts = line.split(' · ').map((fact) => /^\*\*([^*:]+):?\*\* ?(.*)$/.exec(fact)).map(([, key, value]) => [key, value]);
  facts.sort(([a], [b]) => Number(b === 'Severity') - Number(a === 'Severity'));
  return `<div class="facts">${facts.map(([key, value]) => label(key, value)).join('')}</div>\n`;
}

function html(Token, content) {
  const token = new Token('html_block', '', 0);
  token.content = content;
  return token;
}

/** What replaces the tables between `<!-- NAME -->` and `<!-- /NAME -->`. */
const LISTS = {
  rules: ["<script setup>\nimport RuleIndex from '../site/.vitepress/theme/RuleIndex.vue';\n</script>\n", '<RuleIndex />\n'],
  errors: [`<p><a href="${base}errors/">All compile errors</a></p>\n`],
};

function replaceLists(tokens, Token) {
  const find = (mark) => tokens.findIndex((token) => token.type === 'html_block' && token.content.trim() === mark);
  for (const [name, blocks] of Object.entries(LISTS)) {
    const start = find(`<!-- ${name} -->`);
    const end = find(`<!-- /${name} -->`);
    if (start >= 0 && end > start) tokens.splice(start, end - start + 1, ...blocks.map((block) => html(Token, block)));
  }
}

export function facts(md) {
  md.core.ruler.push('facts of rules', (state) => {
    const { tokens, Token } = state;
    if (fileOf(state.env) === 'rules/README.md') replaceLists(tokens, Token);
    const line = tokens.findIndex((token) => token.type === 'inline' && /^\*\*(Group:|Compile error)\*\* /.test(token.content));
    if (line > 0) tokens.splice(line - 1, 3, html(Token, labels(tokens[line].content)));
  });
}
