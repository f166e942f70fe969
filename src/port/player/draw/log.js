// Parses the log of the compiler.

/** @typedef {{pass: string, line: number, text: string, token?: string}} ShaderError */

/**
 * Splits a log into entries: severity, position, quoted token and message; position and token are
 * optional. A token may be any text of the code, even a line break or a quote.
 * @param {string} log
 * @returns {{isError: boolean, line: number, token: string, words: string}[]} lines from 1; 0 without one
 */
function readLog(log) {
  const entries = log.replace(/\0/g, '').split(/^(?=(?:ERROR|WARNING): )/m);
  return entries.flatMap((entry) => {
    const match = /^(ERROR|WARNING): (?:-?\d+:(-?\d+): (?:'([\s\S]*?)' : )?)?([\s\S]*)$/.exec(entry);
    if (!match) return [];
    const [, severity, line = '0', token = '', words] = match;
    return [{ isError: severity === 'ERROR', line: Number(line), token, words: words.trim() }];
  });
}

/**
 * Maps the line numbers of a log to the user's own text.
 * @param {string} log
 * @param {SourceText[]} files the compiled texts, in order
 * @param {string} passName
 * @returns {ShaderError[]}
 */
function mapErrors(log, files, passName) {
  const errors = readLog(log).filter((entry) => entry.isError);
  if (errors.length === 0) {
    const text = log.replace(/\0/g, '').trim();
    return text ? [{ pass: passName, line: 0, text }] : [];
  }
  return errors.map(({ line, token, words }) => {
    const shown = token === '\n' ? 'end of line' : `'${token}'`;
    const place = line > 0 ? placeOf(line, files, passName) : { pass: passName, line: 0 };
    return { ...place, text: token ? `${shown} : ${words}` : words, token };
  });
}

/**
 * @param {number} line in the compiled text, from 1
 * @param {SourceText[]} files
 * @param {string} passName
 */
function placeOf(line, files, passName) {
  let first = 1;
  for (const [i, file] of files.entries()) {
    const isLast = i === files.length - 1;
    const count = joined(file, isLast).split(/\r\n|\r|\n/).length - 1;
    if (line < first + count || isLast) {
      const own = line - first + 1;
      return file.hidden ? { pass: passName, line: 0 } : { pass: file.name, line: own };
    }
    first += count;
  }
  return { pass: passName, line: 0 };
}
