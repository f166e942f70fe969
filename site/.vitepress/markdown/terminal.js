// What the programs print, coloured as in a terminal.

const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
const span = (name, text) => (text ? `<span class="${name}">${escape(text)}</span>` : '');

/** The marks below a line of source and their label: `^^^^ this one`, `---- another`. */
function marks(text, severity) {
  const [, runs, label] = /^(\s*(?:(?:\^+|-+)(?:\s+|$))*)(.*)$/.exec(text);
  let last = 'bar';
  const drawn = runs.replace(/\^+|-+/g, (run) => {
    last = run.startsWith('^') ? severity : 'bar';
    return span(last, run);
  });
  return drawn + span(last, label);
}

/** Colours the lines of findings. The severity of a finding applies to its marks. */
function colored(text) {
  let severity = 'error';
  return text.trimEnd().split('\n').map((line) => {
    const head = /^(error|warning|info)(\[[^\]]+\])(: .*)$/.exec(line);
    if (head) {
      severity = head[1];
      return span(severity, head[1] + head[2]) + span('title', head[3]);
    }
    const source = /^(\s*\d+ │)(.*)$/.exec(line);
    if (source) return span('bar', source[1]) + escape(source[2]);
    const marked = /^(\s*│)(.*)$/.exec(line);
    if (marked) return span('bar', marked[1]) + marks(marked[2], severity);
    const note = /^(\s*= )(help: )?(.*)$/.exec(line);
    if (note) return span('bar', note[1]) + span('help', note[2]) + escape(note[3]);
    if (/^\s*(┌─|·)/.test(line)) return span('bar', line);
    if (line.startsWith('$ ')) return span('bar', '$ ') + span('title', line.slice(2));
    return escape(line);
  }).join('\n');
}

/** A block of output. It can be focused, so that the keyboard scrolls it. */
export function terminal(text, caption = '') {
  const label = caption ? `<figcaption><span class="what">${caption}</span></figcaption>` : '';
  return `<figure class="example output">${label}<pre class="terminal" tabindex="0" v-pre><code>${colored(text)}</code></pre></figure>`;
}
