// Syntax highlighting.

const GLSL_TYPE = /^(?:void|bool|float|u?int|[biu]?vec[234]|mat[234](?:x[234])?|[iu]?sampler\w+)$/;
const GLSL_WORD = /^(?:const|in|out|inout|uniform|struct|if|else|for|while|do|switch|case|default|break|continue|return|discard|true|false|precision|highp|mediump|lowp|flat|smooth|centroid|layout|invariant)$/;
const GLSL_TOKEN = /(\/\/.*|\/\*[\s\S]*?(?:\*\/|$))|(^\s*#\s*\w*)|(0[xX][\da-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[fuFU]?)|([A-Za-z_]\w*)/g;

/** The class of a word. @param {string} word @param {string} rest the text after it */
function wordKind(word, rest) {
  if (GLSL_TYPE.test(word)) return 'type';
  if (GLSL_WORD.test(word)) return 'word';
  if (/^(?:i[A-Z]\w*|gl_\w+)$/.test(word)) return 'given';
  return /^\s*\(/.test(rest) ? 'call' : '';
}

/** By line: whether it starts inside a comment. @param {string} text */
function commentStarts(text) {
  const starts = [false];
  let inside = '';
  for (const [mark] of text.matchAll(/\/\*|\*\/|\/\/|\n/g)) {
    if (mark === '\n') {
      if (inside === '//') inside = '';
      starts.push(inside === '/*');
    } else if (inside === '/*' ? mark === '*/' : inside === '') {
      inside = mark === '*/' ? '' : mark;
    }
  }
  return starts;
}

/** A highlighted line. @param {string} line @param {boolean} isInComment @returns {Node[]} */
function colored(line, isInComment) {
  /** @type {Node[]} */
  const nodes = [];
  let from = 0;
  /** @param {number} to @param {string} kind */
  const add = (to, kind) => {
    const text = line.slice(from, to);
    if (text) nodes.push(kind ? make('span', text, kind) : document.createTextNode(text));
    from = to;
  };
  if (isInComment) {
    const end = line.indexOf('*/');
    add(end < 0 ? line.length : end + 2, 'comment');
  }
  const rest = line.slice(from);
  const start = from;
  for (const match of rest.matchAll(GLSL_TOKEN)) {
    const [all, comment, directive, number, word] = match;
    const at = start + match.index;
    const kind = comment ? 'comment' : directive ? 'directive' : number ? 'number' : wordKind(word, line.slice(at + all.length, at + all.length + 20));
    if (!kind) continue;
    add(at, '');
    add(at + all.length, kind);
  }
  add(line.length, '');
  return nodes;
}
