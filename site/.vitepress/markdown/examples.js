// Examples: the code of the pages of rules and errors, with a caption and a link to the playground, and
// what the programs print.
import { playground } from '../playground.js';
import { fileOf } from './links.js';
import { terminal } from './terminal.js';

/** Paragraphs that only introduce a block. The caption of the block replaces them. */
const CAPTIONS = new Map([
  ['shaderlint prints:', 'shaderlint prints'],
  ['Not reported:', 'Not reported'],
  ['Accepted:', 'Accepted'],
  ['`--fix` writes:', 'Fixed by <code>--fix</code>'],
  ['`--unsafe-fixes` writes:', 'Fixed by <code>--unsafe-fixes</code>'],
]);

/** Captions of blocks without such a paragraph. */
const DEFAULTS = { bad: 'Reported', good: 'Not reported', fixed: 'Fixed', suggested: 'Fixed by <code>--unsafe-fixes</code>', plain: 'Example' };

/** What a fence is: `glsl bad old.frag`. */
function kindOf(token, file) {
  const [language, kind, name] = token.info.trim().split(/\s+/);
  if (language === 'text' || language === 'console') return { language, kind: 'output' };
  if (kind) return { language, kind, name };
  const isExample = language === 'glsl' && file.startsWith('rules/errors/');
  return { language, kind: isExample ? 'plain' : undefined };
}

/** The caption that the paragraph before a fence is, if it is one. */
function captionBefore(tokens) {
  const [open, inline] = tokens.slice(-3);
  return (open?.type === 'paragraph_open' && CAPTIONS.get(inline.content)) || '';
}

export function examples(md) {
  md.core.ruler.push('captions of examples', (state) => {
    const file = fileOf(state.env);
    const tokens = [];
    for (const token of state.tokens) {
      if (token.type === 'fence') {
        const caption = captionBefore(tokens);
        token.meta = { ...kindOf(token, file), caption };
        if (caption) tokens.length -= 3;
      }
      tokens.push(token);
    }
    state.tokens = tokens;
  });

  const code = md.renderer.rules.fence;
  md.renderer.rules.fence = (tokens, index, options, env, self) => {
    const token = tokens[index];
    const { language, kind, name, caption } = token.meta ?? {};
    // A diagram of the architecture is text too, but nothing that a program printed.
    if (kind === 'output' && /^(error|warning|info)\[|^\$ /m.test(token.content)) return terminal(token.content, caption);
    if (!(kind in DEFAULTS)) return code(tokens, index, options, env, self);
    token.info = language;
    const file = name ? `<span class="file">${md.utils.escapeHtml(name)}</span>` : '';
    // A page with shaders in it is one by its name.
    const named = language === 'html' || name?.endsWith('.html') ? (name ?? 'page.html') : undefined;
    const link = `<a class="try" target="_self" href="${playground(token.content, named)}" aria-label="Try it in the playground">Try it</a>`;
    return `<figure class="example ${kind}"><figcaption><span class="what">${caption || DEFAULTS[kind]}</span>${file}${link}</figcaption>${code(tokens, index, options, env, self)}</figure>`;
  };
}
