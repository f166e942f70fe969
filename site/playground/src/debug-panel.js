// The panel of the debugger: its buttons, and what the pixel is at the moment.
import { element } from './element.js';

/** The motions: request, label, what it does, and its key. */
const MOTIONS = [
  ['continue', 'Continue', 'To the next breakpoint, or to the end', 'F8'],
  ['reverseContinue', 'Reverse', 'Back to the last breakpoint, or to the start', 'Shift+F8'],
  ['next', 'Over', 'To the next statement, over calls', 'F10'],
  ['stepBack', 'Back', 'To the statement before, over calls', 'Shift+F10'],
  ['stepIn', 'In', 'Into a call', 'F11'],
  ['stepOut', 'Out', 'Out of the function', 'Shift+F11'],
  ['shaderlint/nextIteration', 'Iteration', 'To the next iteration of the loop', 'Ctrl+F10'],
];

/** The key that sets a breakpoint. */
const BREAKPOINT_KEY = 'F9';

const button = (textContent, title, onclick, properties = {}) => element('button', { type: 'button', textContent, title, onclick, ...properties });
const section = (label, body, isOpen = true) => element('details', { open: isOpen }, element('summary', { textContent: label }), body);

/**
 * A row of a table of values.
 * @typedef {{ name: string, value: string, type?: string, color?: string, expression: string, hasParts: boolean,
 *   isOpen: boolean, isChanged: boolean, isError?: boolean, isWritten?: boolean, depth: number }} Row
 */

/** What happens when somebody uses the panel, by name. @typedef {Record<string, (...args: any[]) => void>} Actions */

/** Shows the debugger in an element. */
export class DebugPanel {
  #parent;
  #actions;
  #title = element('h2');
  #status = element('p', { className: 'status' });
  #quad = element('div', { className: 'quad' });
  #stack = element('ul', { className: 'stack' });
  #scopes = element('div');
  #watches = element('tbody');
  #breakpoints = element('ul');
  #filters = element('div', { className: 'filters' });
  #log = element('pre', { className: 'log', hidden: true });
  #hide;

  /** @param {HTMLElement} parent @param {Actions} actions */
  constructor(parent, actions) {
    this.#parent = parent;
    this.#actions = actions;
    this.#status.setAttribute('role', 'status');
    this.#quad.setAttribute('role', 'group');
    this.#quad.ariaLabel = 'Pixels of the quad';
    this.#log.setAttribute('role', 'log');
    this.#hide = button('Hide the image', 'Shows the image of the shader again', () => actions.hide(), { hidden: true });
    parent.append(
      element('div', { className: 'row' }, this.#title, button('Close', 'Back to the image', () => actions.close())),
      this.#toolbar(), this.#status, this.#hide, this.#log,
      section('Variables', this.#scopes), section('Watch', this.#watchTable()),
      section('Call stack', element('div', { className: 'where' }, this.#stack, this.#quad)),
      section('Breakpoints', element('div', {}, this.#breakpoints, this.#adder(), this.#filters)),
    );
  }

  open() {
    this.#parent.hidden = false;
  }

  close() {
    this.#parent.hidden = true;
    this.log([]);
  }

  /** The motion of a key; undefined if it has none. @param {KeyboardEvent} event */
  static motionOf(event) {
    const { key, ctrlKey, shiftKey, altKey, metaKey } = event;
    if (altKey || metaKey) return undefined;
    const name = `${ctrlKey ? 'Ctrl+' : ''}${shiftKey ? 'Shift+' : ''}${key}`;
    return name === BREAKPOINT_KEY ? 'breakpoint' : MOTIONS.find((motion) => motion[3] === name)?.[0];
  }

  /** @param {string} title @param {string} status @param {boolean} isWrong */
  say(title, status, isWrong = false) {
    this.#title.textContent = title;
    this.#status.textContent = status;
    this.#status.classList.toggle('invalid', isWrong);
  }

  /** Whether an image lies above that of the shader. @param {boolean} isShown */
  covered(isShown) {
    this.#hide.hidden = !isShown;
  }

  /** @param {boolean} isBusy whether an answer is missing */
  busy(isBusy) {
    this.#parent.ariaBusy = String(isBusy);
  }

  /** What breakpoints and the debugger print. @param {string[]} lines */
  log(lines) {
    this.#log.textContent = lines.join('');
    this.#log.hidden = lines.length === 0;
  }

  /** @param {{ id: number, name: string }[]} threads @param {number} chosen */
  quad(threads, chosen) {
    // The upper row comes first.
    const order = [2, 3, 0, 1].map((at) => threads[at]);
    this.#quad.replaceChildren(...order.map(({ id, name }) => button(name.replace('pixel ', ''), 'Debug this pixel of the quad', () => this.#actions.thread(id), { ariaPressed: String(id === chosen) })));
  }

  /** @param {{ name: string, place: string }[]} frames @param {number} chosen */
  stack(frames, chosen) {
    this.#stack.replaceChildren(...frames.map(({ name, place }, at) => {
      const made = button(`${name}, ${place}`, 'Show the variables of this call', () => this.#actions.frame(at));
      if (at === chosen) made.setAttribute('aria-current', 'true');
      return element('li', {}, made);
    }));
  }

  /** @param {{ name: string, isOpen: boolean, rows: Row[] }[]} scopes */
  scopes(scopes) {
    const { focus, top } = this.#kept(this.#scopes);
    this.#scopes.replaceChildren(...scopes.flatMap(({ name, isOpen, rows }) => {
      const toggle = button(name, isOpen ? 'Close' : 'Open', () => this.#actions.scope(name), { className: 'scope', ariaExpanded: String(isOpen) });
      toggle.dataset.key = `scope ${name}`;
      const table = element('table', { ariaLabel: name }, element('tbody', {}, ...rows.map((row) => this.#row(row))));
      const none = element('p', { textContent: 'No variable has a value yet.' });
      return [toggle, ...(isOpen ? [rows.length > 0 ? table : none] : [])];
    }));
    this.#restore(this.#scopes, focus, top);
  }

  /** @param {Row[]} rows */
  watches(rows) {
    const { focus, top } = this.#kept(this.#watches);
    this.#watches.replaceChildren(...rows.map((row) => this.#row(row, row.depth === 0 ? () => this.#actions.unwatch(row.expression) : undefined)));
    this.#restore(this.#watches, focus, top);
  }

  /** @param {{ file: string, line: number, place: string, message: string, condition: string }[]} breakpoints */
  breakpoints(breakpoints) {
    if (this.#breakpoints.contains(document.activeElement)) {
      // Somebody may be typing a condition: only the counts change.
      const counts = this.#breakpoints.querySelectorAll('.hits');
      if (counts.length === breakpoints.length) {
        breakpoints.forEach(({ message }, at) => { counts[at].textContent = message; });
        return;
      }
    }
    this.#breakpoints.replaceChildren(...breakpoints.map(({ file, line, place, message, condition }) => {
      const field = element('input', { value: condition, placeholder: 'Condition', ariaLabel: `Condition of ${place}`, spellcheck: false });
      field.addEventListener('change', () => this.#actions.condition(file, line, field.value));
      return element('li', {},
        button(place, 'Go to the line', () => this.#actions.reveal(file, line)), field,
        button('×', 'Remove the breakpoint', () => this.#actions.breakpoint(file, line), { ariaLabel: `Remove the breakpoint at ${place}` }),
        element('span', { className: 'hits', textContent: message }));
    }));
  }

  /** @param {{ filter: string, label: string }[]} filters @param {Set<string>} chosen */
  filters(filters, chosen) {
    this.#filters.replaceChildren('Stop at', ...filters.map(({ filter, label }) => {
      const box = element('input', { type: 'checkbox', checked: chosen.has(filter) });
      box.addEventListener('change', () => this.#actions.filter(filter, box.checked));
      return element('label', {}, box, ` ${label}`);
    }));
  }

  #toolbar() {
    const buttons = MOTIONS.map(([request, label, title, key]) => {
      const made = button(label, `${title} (${key})`, () => this.#actions.motion(request));
      made.setAttribute('aria-keyshortcuts', key.replace('Ctrl', 'Control'));
      return made;
    });
    const made = element('div', { className: 'tools' }, ...buttons);
    made.setAttribute('role', 'toolbar');
    made.ariaLabel = 'Steps';
    return made;
  }

  #watchTable() {
    const field = element('input', { placeholder: 'Expression', ariaLabel: 'Expression to watch', spellcheck: false });
    const form = element('form', {}, field, element('button', { textContent: 'Watch' }));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (field.value.trim()) this.#actions.watch(field.value.trim());
      field.value = '';
    });
    return element('div', {}, element('table', { ariaLabel: 'Watch' }, this.#watches), form);
  }

  #adder() {
    return button('Breakpoint at the cursor', `Sets or removes a breakpoint at the line of the cursor (${BREAKPOINT_KEY})`, () => this.#actions.motion('breakpoint'));
  }

  /** @param {Row} row @param {() => void} [remove] */
  #row({ name, value, type, color, expression, hasParts, isOpen, isChanged, isError, isWritten, depth }, remove) {
    const label = element('td');
    label.style.setProperty('--depth', String(depth));
    if (hasParts) {
      const toggle = button(isOpen ? '▾' : '▸', isOpen ? 'Close' : 'Open', () => this.#actions.part(expression), { className: 'part', ariaLabel: `Parts of ${expression}`, ariaExpanded: String(isOpen) });
      toggle.dataset.key = `part ${expression}`;
      label.append(toggle, ' ');
    } else label.classList.add('simple');
    label.append(element('span', { textContent: name, title: type ?? '' }));
    const shown = element('td', { className: isError ? 'invalid' : '' });
    if (color) {
      const swatch = element('span', { className: 'swatch' });
      swatch.style.backgroundColor = color;
      shown.append(swatch);
    }
    if (expression && !isError) {
      const over = button(value, `${type}: shows ${expression} over the image`, () => this.#actions.over(expression), { className: 'value' });
      over.dataset.key = `value ${expression}`;
      shown.append(over);
    } else shown.append(value);
    if (isChanged) shown.append(element('span', { className: 'mark', textContent: ' changed' }));
    const last = element('td');
    if (isWritten) last.append(button('↶', 'Goes back to where it was written', () => this.#actions.written(expression), { ariaLabel: `Back to where ${expression} was written` }));
    if (remove) last.append(button('×', 'Removes it', remove, { ariaLabel: `Remove ${expression}` }));
    return element('tr', { className: isChanged ? 'changed' : '' }, label, shown, last);
  }

  /** What replacing the rows would lose. @param {HTMLElement} within */
  #kept(within) {
    const active = /** @type {HTMLElement} */ (document.activeElement);
    return { focus: within.contains(active) ? active.dataset.key : undefined, top: this.#parent.parentElement.scrollTop };
  }

  #restore(within, focus, top) {
    const again = [.../** @type {NodeListOf<HTMLElement>} */ (within.querySelectorAll('[data-key]'))].find(({ dataset }) => dataset.key === focus);
    if (focus !== undefined) again?.focus({ preventScroll: true });
    this.#parent.parentElement.scrollTop = top;
  }
}
