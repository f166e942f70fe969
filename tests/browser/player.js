// Parts of the player that need no page.
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';
import { top } from './browser.js';

/** The declarations of some of the player's files. */
export function load(files, names) {
  const player = path.join(top, 'src/port/player');
  const code = files.map((f) => fs.readFileSync(path.join(player, f), 'utf8')).join('');
  // The files are scripts that share one scope, not modules.
  const open = vm.runInThisContext(`(navigator, window, document) => {\n${code}\nreturn { ${names.join(', ')} };\n}`);
  return open({ userAgent: '' }, { addEventListener() {} }, { addEventListener() {} });
}
