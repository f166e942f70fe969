// A text area with syntax highlighting. It remains a native text area, including undo; the visible text is
// painted behind it. Only lines in view are painted, so long texts stay fast.

/** Line height in pixels, as in the style sheet. */
const LINE = 20;

/** @typedef {{line: number, words: string}} LineMark lines from 1 */

class Editor {
  /** @param {string} name @param {(text: string) => void} onInput */
  constructor(name, onInput) {
    this.area = document.createElement('textarea');
    this.area.setAttribute('aria-label', `Code of ${name}`);
    this.area.spellcheck = false;
    this.area.wrap = 'off';
    this.area.setAttribute('autocapitalize', 'off');
    this.area.setAttribute('autocomplete', 'off');
    this.rows = make('div', '', 'rows');
    this.numbers = make('div', '', 'numbers');
    this.node = make('div', '', 'editor');
    const back = make('div', '', 'back');
    back.setAttribute('aria-hidden', 'true');
    back.append(this.rows, this.numbers);
    this.node.append(back, this.area);
    /** @type {string[]} */
    this.lines = [];
    /** @type {boolean[]} */
    this.starts = [];
    /** @type {Map<number, string>} */
    this.marks = new Map();
    this.area.addEventListener('input', () => {
      this.#read();
      onInput(this.area.value);
    });
    this.area.addEventListener('scroll', () => this.paint());
    this.area.addEventListener('keydown', (event) => this.#key(event));
    new ResizeObserver(() => this.paint()).observe(this.area);
  }

  #read() {
    this.lines = this.area.value.split('\n');
    this.starts = commentStarts(this.area.value);
    this.paint();
  }

  /** Replaces the text and keeps the cursor position. @param {string} text */
  set(text) {
    const [start, end] = changed(this.area.value, text);
    const tail = this.area.value.length - end;
    if (this.lines.length === 0) this.area.value = text;
    else this.area.setRangeText(text.slice(start, text.length - tail), start, end, 'preserve');
    this.#read();
  }

  /** @param {LineMark[]} marks */
  mark(marks) {
    this.marks = new Map(marks.map((m) => [m.line, m.words]));
    this.paint();
  }

  /** @param {number} line from 1 @param {number} [column] */
  goTo(line, column = 0) {
    const before = this.lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0);
    this.area.focus();
    this.area.setSelectionRange(before + column, before + column);
    this.area.scrollTop = Math.max(0, (line - 1) * LINE - this.area.clientHeight / 3);
    this.paint();
  }

  /** Paints the lines in view. */
  paint() {
    const { scrollTop, scrollLeft, clientHeight } = this.area;
    const first = Math.max(0, Math.floor(scrollTop / LINE) - 2);
    const last = Math.min(this.lines.length, Math.ceil((scrollTop + clientHeight) / LINE) + 2);
    const rows = [];
    const numbers = [];
    for (let i = first; i < last; i++) {
      const words = this.marks.get(i + 1);
      const row = make('div', '', words === undefined ? '' : 'bad');
      // Long lines are painted only as far as a screen can show them.
      row.append(...colored(this.lines[i].slice(0, 2000), this.starts[i]));
      if (words) row.append(make('i', `   ${words}`));
      rows.push(row);
      numbers.push(make('div', String(i + 1), words === undefined ? '' : 'bad'));
    }
    this.rows.replaceChildren(...rows);
    this.numbers.replaceChildren(...numbers);
    this.rows.style.transform = `translate(${-scrollLeft}px, ${first * LINE - scrollTop}px)`;
    this.numbers.style.transform = `translateY(${first * LINE - scrollTop}px)`;
  }

  /** Tab and Enter indent; the inserted text can be undone. @param {KeyboardEvent} event */
  #key(event) {
    const { area } = this;
    if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
    if (event.key === 'Tab' && !event.shiftKey) {
      event.preventDefault();
      document.execCommand('insertText', false, '  ');
    } else if (event.key === 'Enter') {
      const before = area.value.slice(0, area.selectionStart);
      const [indent] = /^[ \t]*/.exec(before.slice(before.lastIndexOf('\n') + 1)) ?? [''];
      event.preventDefault();
      document.execCommand('insertText', false, `\n${indent}`);
    }
  }
}
