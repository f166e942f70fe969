// Links, downloads and the clipboard.

/** Text with code in backticks. @param {string} tag @param {string} words @param {string} [className] */
function makeWords(tag, words, className) {
  const node = make(tag, '', className);
  words.split(/\x60([^\x60]+)\x60/).forEach((part, i) => node.append(i % 2 ? make('code', part) : part));
  return node;
}

/** A link to another site; only for https: URLs. @param {string} address @param {string} text */
function makeLink(address, text) {
  if (!/^https:\/\/[^\s"<>]+$/i.test(address)) return document.createTextNode(text);
  const link = document.createElement('a');
  link.href = address;
  link.rel = 'noopener noreferrer';
  link.target = '_blank';
  link.textContent = text;
  return link;
}

/** @param {Blob} blob @param {string} name */
function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** The file name of a download: the title, reduced to letters and digits. @param {Player} player @param {string} ending */
function fileName(player, ending) {
  const words = player.project.title.normalize('NFKD').match(/[\p{L}\p{N}]+/gu) ?? ['shader'];
  return `${words.join('-').slice(0, 60)}-${player.clock.time.toFixed(2)}s.${ending}`;
}

/** Copies text to the clipboard. @param {string} text */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Fallback for a frame without the permission.
    const area = document.createElement('textarea');
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
}

/** Shows a notice for a few seconds. @param {string} text */
function flash(text) {
  dismissed.delete('flash');
  retract('flash');
  notify('flash', text);
  const shown = notices.get('flash');
  setTimeout(() => {
    if (shown && notices.get('flash') === shown) retract('flash');
  }, 4000);
}
