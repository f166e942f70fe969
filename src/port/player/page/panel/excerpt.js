// Code excerpts with carets under the labelled spans, and the labels after the carets.

/** @param {string} text @returns {string[]} */
function linesOf(text) {
  return text.split(/\r\n|\r|\n/);
}

/** The position of an offset. @param {string} text @param {number} offset @returns {[number, number]} line from 1, column from 0 */
function placeAt(text, offset) {
  const before = linesOf(text.slice(0, offset));
  return [before.length, before[before.length - 1].length];
}

/** @typedef {{line: number, column: number, length: number, words: string}} Mark length 0: the line alone */

/** Converts a label to a mark in its line. @param {string} text @param {LabelData} label @returns {Mark} */
function markOf(text, label) {
  const [line, column] = placeAt(text, label.start);
  const rest = linesOf(text.slice(label.start, label.end))[0];
  return { line, column, length: Math.max(1, rest.length), words: label.text };
}

/**
 * The mark of a compile error: its token, if that occurs exactly once in the line.
 * @param {string} text @param {number} line @param {string} token
 * @returns {Mark}
 */
function markToken(text, line, token) {
  const code = linesOf(text)[line - 1] ?? '';
  if (token === '\n') return { line, column: code.length, length: 1, words: '' };
  const escaped = token.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const found = token ? [...code.matchAll(new RegExp(/^\w+$/.test(token) ? `\\b${escaped}\\b` : escaped, 'g'))] : [];
  const column = found.length === 1 ? found[0].index : 0;
  return { line, column, length: found.length === 1 ? token.length : 0, words: '' };
}

/** The lines with their marks. @param {string} text @param {Mark[]} marks the primary mark first */
function excerpt(text, marks) {
  const lines = linesOf(text);
  const box = make('pre', '', 'excerpt');
  const numbers = [...new Set(marks.map((m) => m.line))].sort((a, b) => a - b);
  // Number of visible columns.
  const room = narrow.matches ? 44 : 110;
  const width = String(numbers[numbers.length - 1] ?? '').length;
  numbers.forEach((number, i) => {
    const here = marks.filter((m) => m.line === number);
    const line = lines[number - 1] ?? '';
    const cut = here[0].column + 12 > room ? here[0].column - Math.floor(room / 2) : 0;
    if (i > 0 && numbers[i - 1] < number - 1) box.append(make('span', `${' '.repeat(width)} ·\n`, 'gutter'));
    box.append(make('span', `${String(number).padStart(width)} │ `, 'gutter'));
    box.append(`${line.slice(cut, cut + 2 * room)}\n`);
    for (const mark of here.filter((m) => m.length > 0).sort((a, b) => b.column - a.column)) {
      const isFirst = mark === marks[0];
      const before = line.slice(cut, mark.column).replace(/[^\t]/g, ' ');
      const length = Math.max(1, Math.min(mark.length, cut + 2 * room - mark.column));
      box.append(make('span', `${' '.repeat(width)} │ `, 'gutter'), before);
      box.append(make('span', `${(isFirst ? '^' : '-').repeat(length)} ${mark.words}`, isFirst ? 'carets' : 'dashes'), '\n');
    }
  });
  return box;
}
