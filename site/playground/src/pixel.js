// The panel of a traced pixel: its colour, loops and invalid numbers, and its steps.
import { element } from './element.js';
import { nameOf } from './trace.js';
import { inFull, inShort, isInvalid } from './values.js';

const number = new Intl.NumberFormat('en');
const button = (textContent, title, onclick) => element('button', { type: 'button', textContent, title, onclick });

/** A button that goes to a line. */
const lineButton = (line, go) => element('button', { type: 'button', className: 'place', textContent: `Line ${line}`, onclick: go });

/** The file and the line in a position such as `shader.glsl:12:5`. @param {string} at */
function placeOf(at) {
  const [, file, line] = /^(.*):(\d+):\d+$/.exec(at);
  return { file, line: Number(line) };
}

/** Shows a trace in an element. */
export class PixelPanel extends EventTarget {
  #parent;
  #trace;
  #step = 0;
  #slider = element('input', { type: 'range', id: 'step', min: '0' });
  #label = element('label', { htmlFor: 'step' });
  #table = element('tbody');

  /** @param {HTMLElement} parent */
  constructor(parent) {
    super();
    this.#parent = parent;
    this.#slider.addEventListener('input', () => this.#go(Number(this.#slider.value)));
  }

  /** The step that is shown. */
  get step() {
    return this.#step;
  }

  /** Shows a trace at its last step, or at the same step as the last trace. @param {import('./trace.js').Trace} trace */
  show(trace) {
    const isSame = this.#trace?.steps.length === trace.steps.length;
    this.#trace = trace;
    const { facts, steps } = trace;
    this.#slider.max = String(steps.length - 1);
    this.#parent.replaceChildren(...this.#head(facts), ...this.#causes(facts));
    if (steps.length > 0) {
      this.#parent.append(this.#stepper(facts), this.#variables());
      this.#go(isSame ? this.#step : steps.length - 1, false);
    }
    this.#parent.hidden = false;
  }

  /** Shows why there is no trace. @param {string} message */
  fail(message) {
    this.#trace = undefined;
    const close = button('Close', 'Back to the image', () => this.#fire('close'));
    this.#parent.replaceChildren(element('div', { className: 'row' }, element('h2', { textContent: 'Pixel' }), close));
    this.#parent.append(element('p', { textContent: message }));
    this.#parent.hidden = false;
  }

  close() {
    this.#trace = undefined;
    this.#parent.hidden = true;
    this.#parent.replaceChildren();
  }

  #fire(type) {
    this.dispatchEvent(new Event(type));
  }

  #head({ pixel: [x, y], time, outputs: [image], discarded, operations, more, stopped }) {
    const close = button('Close', 'Back to the image', () => this.#fire('close'));
    const title = element('h2', { textContent: `Pixel ${x}, ${y} at ${Number(time.toFixed(2))} s` });
    const color = element('p', { className: 'color' });
    const value = image?.value ?? [];
    if (discarded) color.append('discarded');
    else {
      const [red, green, blue] = value.map((lane) => Math.round(255 * Math.min(Math.max(Number(lane) || 0, 0), 1)));
      const swatch = element('span', { className: 'swatch' });
      swatch.style.backgroundColor = `rgb(${red} ${green} ${blue})`;
      color.append(swatch, element('code', { textContent: inShort(value), title: inFull(value) }));
    }
    color.append(`, ${number.format(operations)} operations`);
    const notes = [stopped && `Stopped: ${stopped}.`, more && 'Only the first steps were recorded.'].filter(Boolean);
    return [
      element('div', { className: 'row' }, title, close), color, ...notes.map((note) => element('p', { textContent: note })),
    ];
  }

  /** The loops, and the operations that first gave invalid numbers. */
  #causes({ loops, numbers }) {
    const items = [
      ...numbers.map(({ at, text, kind, operands }) => [at, element('span', { className: 'invalid' }, element('code', { textContent: text }), ` is ${kind === 'nan' ? 'NaN' : kind}`, operands.length > 0 ? ` for ${inShort(operands.map((n) => n ?? 'NaN'))}` : '')]),
      ...loops.map(({ at, function: name, most, pixels, mean }) => [at, `loop in ${name}(): ${most === mean || pixels === 0 ? most : `at most ${most}`} iterations`]),
    ];
    if (items.length === 0) return [];
    const rows = items.map(([at, what]) => element('li', {}, lineButton(placeOf(at).line, () => this.#seek(placeOf(at))), ' ', what));
    return [element('ul', { className: 'causes' }, ...rows)];
  }

  #stepper() {
    const move = (by) => () => this.#go(this.#step + by);
    const same = (direction) => () => this.#go(this.#trace.again(this.#step, direction));
    return element('div', { className: 'stepper' },
      this.#label, this.#slider,
      button('«', 'The same line, the time before', same(-1)), button('‹', 'One step back', move(-1)),
      button('›', 'One step forward', move(1)), button('»', 'The same line, the next time', same(1)));
  }

  #variables() {
    const head = element('thead', {}, element('tr', {}, ...['Variable', 'Type', 'Value'].map((textContent) => element('th', { textContent, scope: 'col' }))));
    return element('table', {}, head, this.#table);
  }

  /** Goes to the first step at a line, or to that at the next line with one. @param {{ file: string, line: number }} place */
  #seek({ file, line }) {
    const places = this.#trace.steps.map(({ site }) => placeOf(site.at));
    const lines = places.filter((place) => place.file === file && place.line >= line).map((place) => place.line);
    const next = Math.min(...lines);
    const at = places.findIndex((place) => place.file === file && place.line === next);
    this.#go(at < 0 ? this.#step : at);
  }

  /** @param {number} step @param {boolean} [isChosen] whether somebody chose this step */
  #go(step, isChosen = true) {
    const trace = this.#trace;
    this.#step = Math.min(Math.max(0, step), trace.steps.length - 1);
    this.#slider.value = String(this.#step);
    const { site, value } = trace.steps[this.#step];
    this.#label.textContent = `Step ${this.#step + 1} of ${trace.steps.length}: line ${site.line}, ${nameOf(site)} ${inShort(value)}`;
    this.#slider.setAttribute('aria-valuetext', this.#label.textContent);
    const rows = trace.variablesAt(this.#step).map((row) => {
      const cells = [nameOf(row.site), row.site.type, inShort(row.value)].map((textContent) => element('td', { textContent }));
      cells[2].title = inFull(row.value);
      const state = [row.site === site && 'current', isInvalid(row.value) && 'invalid'].filter(Boolean);
      return element('tr', { className: state.join(' ') }, ...cells);
    });
    this.#table.replaceChildren(...rows);
    this.dispatchEvent(new CustomEvent('step', { detail: { isChosen } }));
  }
}
