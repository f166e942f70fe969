// Debugs a pixel of the image: steps forwards and backwards, breakpoints, and values.
import { breakpointsIn, changeBreakpoint } from './breakpoints.js';
import { DebugClient } from './debug-client.js';
import { debugWords } from './debug-link.js';
import { DebugPanel } from './debug-panel.js';
import { DebugValues } from './debug-values.js';
import { element } from './element.js';
import { momentOf, passOf } from './moment.js';
import { isFolder, titleOf } from './passes.js';
import { Picker } from './pick.js';
import { shaderOf } from './shader.js';
import { mark } from './trace-marks.js';

/** Milliseconds without changes before the program is read again. */
const PAUSE = 400;
/** How many motions may wait for another one: a key that is held down must not run ahead. */
const MOST_WAITING = 2;
/** How often the image is asked for its state. */
const MOST_TRIES = 10;
/** How many lines of output are shown. */
const MOST_LINES = 50;

const REASONS = { entry: 'At the start', breakpoint: 'Breakpoint', exception: 'Stopped' };

/** The arguments of `launch` that say which files are debugged. @param {import('./passes.js').Files} files */
function textsOf(files) {
  const { name, ...texts } = shaderOf(files);
  return { program: name, ...texts };
}

/** Debugs the pixel of an image that somebody chooses. */
export class Debugger {
  #image;
  #documents;
  #button;
  #code;
  #picker;
  #panel;
  #values;
  #client = new DebugClient();
  #parent;
  /** What a link opens the debugger for. @type {import('./debug-link.js').DebugStart | undefined} */
  #link;
  #over = element('img', { className: 'drawn', hidden: true });
  /** What the debugger was started with; undefined while it has no program. @type {any} */
  #launch;
  #state;
  #timer;
  /** The work in its order. */
  #queue = Promise.resolve();
  #waiting = 0;
  #thread = 1;
  #frame = 0;
  #frames = [];
  #threads = [];
  #filters = new Set();
  #lines = [];
  /** What breakpoints hit, by file, line and condition. */
  #hits = new Map();

  /**
   * @param {{ image: import('./image.js').ShaderImage, documents: import('./documents.js').Documents }} shader
   * @param {{ button: HTMLElement, image: HTMLElement, panel: HTMLElement, code: HTMLElement }} places
   */
  constructor({ image, documents }, { button, image: parent, panel, code }) {
    this.#image = image;
    this.#documents = documents;
    this.#button = button;
    this.#code = code;
    this.#parent = parent;
    this.#picker = new Picker(parent);
    parent.append(this.#over);
    this.#values = new DebugValues((command, args) => this.#ask(command, args));
    this.#panel = new DebugPanel(panel, this.#actions());
    button.addEventListener('click', () => (this.isOpen ? this.close() : this.#open()));
    this.#picker.addEventListener('pick', () => this.#do(() => this.#pick()));
    documents.addEventListener('change', () => this.#later());
    documents.addEventListener('breakpoints', () => this.#do(() => this.#setBreakpoints()));
    document.addEventListener('keydown', (event) => this.#pressed(event), { capture: true });
    // Some systems open a menu when Shift+F10 is released.
    document.addEventListener('keyup', (event) => { if (this.isOpen && DebugPanel.motionOf(event)) event.preventDefault(); });
  }

  get isOpen() {
    return this.#button.getAttribute('aria-pressed') === 'true';
  }

  /** What follows the code in a link to what is debugged; nothing without a program. */
  get words() {
    return this.#launch ? debugWords(this.#launch) : '';
  }

  /** Opens for what a link names, as soon as its image is there. @param {import('./debug-link.js').DebugStart} link */
  openAt(link) {
    this.#link = link;
    const file = `${link.pass}.glsl`;
    if (this.#documents.names.includes(file)) this.#documents.select(file);
    this.#parent.addEventListener('drawn', () => { if (this.#link === link && !this.isOpen) this.#open(); }, { once: true });
  }

  /** Ends the session; the image plays on. */
  close() {
    this.#link = undefined;
    if (!this.isOpen) return;
    clearTimeout(this.#timer);
    if (this.#state?.isPlaying) this.#image.pause(false);
    this.#button.setAttribute('aria-pressed', 'false');
    this.#code.classList.remove('debugging');
    this.#picker.close();
    this.#panel.close();
    this.#client.close();
    this.#launch = undefined;
    this.#hide();
    this.#unmark();
  }

  /** What the panel can do. @returns {import('./debug-panel.js').Actions} */
  #actions() {
    const later = (work) => (...args) => this.#do(() => work(...args));
    return {
      close: () => {
        this.close();
        this.#button.focus();
      },
      motion: (request) => this.#move(request),
      thread: later((id) => this.#stopped([{ event: 'stopped', body: { threadId: id } }])),
      frame: later((at) => this.#showFrame(at)),
      scope: later((name) => this.#toggled(() => this.#values.toggleScope(name))),
      part: later((expression) => this.#toggled(() => this.#values.togglePart(expression))),
      watch: later((expression) => this.#toggled(() => this.#values.watch(expression))),
      unwatch: later((expression) => this.#toggled(() => this.#values.unwatch(expression))),
      over: later((expression) => this.#showOver(expression)),
      hide: () => this.#hide(),
      written: later(async (expression) => this.#stopped((await this.#ask('shaderlint/written', { expression, frameId: this.#frameId })).events)),
      reveal: (file, line) => this.#documents.reveal(file, line),
      breakpoint: (file, line) => changeBreakpoint(this.#documents.editor(file), line),
      condition: (file, line, condition) => changeBreakpoint(this.#documents.editor(file), line, condition.trim()),
      filter: later((filter, isOn) => {
        if (isOn) this.#filters.add(filter);
        else this.#filters.delete(filter);
        return this.#ask('setExceptionBreakpoints', { filters: [...this.#filters] });
      }),
    };
  }

  get #frameId() {
    return this.#frames[this.#frame]?.id;
  }

  #ask(command, args) {
    return this.#client.ask(command, args);
  }

  /** Does something after everything before, and says what went wrong. @param {() => any} work */
  #do(work) {
    if (!this.isOpen) return;
    this.#waiting++;
    this.#panel.busy(true);
    this.#queue = this.#queue.then(async () => {
      try {
        if (this.isOpen) await work();
      } catch (error) {
        if (!this.#client.isRunning) this.#launch = undefined;
        if (this.isOpen && error.name !== 'AbortError') this.#panel.say(this.#title, `${error.message[0].toUpperCase()}${error.message.slice(1)}.`, true);
      } finally {
        this.#waiting--;
        this.#panel.busy(this.#waiting > 0);
      }
    });
  }

  async #open() {
    this.#button.setAttribute('aria-pressed', 'true');
    this.#code.classList.add('debugging');
    this.#documents.view.requestMeasure();
    this.#panel.open();
    this.#panel.say('Debugger', 'Starting…');
    this.#state = undefined;
    const { pixel, ...known } = this.#link ?? {};
    this.#link = undefined;
    // A frame that is busy drawing answers late.
    for (let tries = 0; tries < MOST_TRIES && !this.#state && this.isOpen; tries++) this.#state = await this.#image.state();
    if (!this.isOpen) return;
    if (!this.#state) {
      this.#panel.say('Debugger', 'There is no image yet.', true);
      return;
    }
    this.#image.pause(true);
    for (const name of ['size', 'time', 'frame']) this.#state[name] = known[name] ?? this.#state[name];
    this.#picker.open(this.#state, pixel);
    this.#picker.focus();
    this.#do(() => this.#start());
  }

  get #title() {
    const thread = this.#threads.find(({ id }) => id === this.#thread);
    const name = thread?.name ?? `pixel ${this.#picker.pixel.join()}`;
    return `Debugger: ${name.replace(',', ', ')} at ${Number((this.#state?.time ?? 0).toFixed(2))} s`;
  }

  /** Starts at the chosen pixel. */
  async #start() {
    this.#launch = undefined;
    this.#lines = [];
    this.#panel.log(this.#lines);
    const { files } = this.#documents;
    const { size } = this.#state;
    const launch = { ...textsOf(files), ...momentOf(this.#state), ...passOf(this.#documents), size, pixel: this.#picker.pixel };
    const { body } = await this.#ask('initialize', { adapterID: 'shaderlint' });
    const known = body.exceptionBreakpointFilters;
    if (this.#filters.size === 0) this.#filters = new Set(known.filter((filter) => filter.default).map(({ filter }) => filter));
    this.#panel.filters(known, this.#filters);
    await this.#ask('setExceptionBreakpoints', { filters: [...this.#filters] });
    const { events } = await this.#ask('launch', launch);
    this.#launch = launch;
    await this.#setBreakpoints();
    const configured = await this.#ask('configurationDone');
    await this.#stopped([...events, ...configured.events]);
  }

  /** Goes to the pixel that somebody chose. */
  async #pick() {
    const { pixel } = this.#picker;
    if (!this.#launch) {
      await this.#start();
      return;
    }
    const { pass } = passOf(this.#documents);
    const isCommon = isFolder(this.#documents.files) && this.#documents.current === 'common.glsl';
    this.#launch.pixel = pixel;
    if (pass !== this.#launch.pass && !isCommon) await this.#start();
    else await this.#stopped((await this.#ask('shaderlint/pixel', { pixel })).events);
  }

  /** Reads the program again after a change. */
  #later() {
    if (!this.isOpen || !this.#state) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#do(async () => {
      if (!this.#launch) {
        await this.#start();
        return;
      }
      const texts = textsOf(this.#documents.files);
      const isSame = texts.program === this.#launch.program;
      const launch = { ...this.#launch, ...texts };
      const { events } = isSame ? await this.#ask('shaderlint/reload', texts) : await this.#ask('launch', launch);
      this.#launch = launch;
      this.#hits.clear();
      await this.#setBreakpoints();
      await this.#stopped(events);
    }), PAUSE);
  }

  #move(request) {
    if (request === 'breakpoint') {
      const { view } = this.#documents;
      changeBreakpoint(view, view.state.doc.lineAt(view.state.selection.main.head).number);
      return;
    }
    if (this.#waiting >= MOST_WAITING || !this.#launch) return;
    this.#do(async () => this.#stopped((await this.#ask(request, { threadId: this.#thread })).events));
  }

  #pressed(event) {
    if (!this.isOpen) return;
    const request = DebugPanel.motionOf(event);
    if (!request) return;
    event.preventDefault();
    event.stopPropagation();
    this.#move(request);
  }

  /** Sends the breakpoints, and counts what they hit. */
  async #setBreakpoints() {
    if (!this.#launch) return;
    const sources = this.#documents.names.map((file) => ({ file, breakpoints: breakpointsIn(this.#documents.editor(file)) }));
    const rows = [];
    for (const { file, breakpoints } of sources) {
      const { body } = await this.#ask('setBreakpoints', { source: { path: file }, breakpoints });
      body.breakpoints.forEach((placed, at) => rows.push({ file, ...breakpoints[at], placed }));
    }
    const show = () => this.#panel.breakpoints(rows.map(({ file, line, condition = '', placed }) => ({
      file,
      line,
      condition,
      place: this.#place(file, placed.verified ? placed.line : line),
      message: placed.verified ? this.#hits.get(`${file}:${line}:${condition}`) ?? 'counting…' : placed.message,
    })));
    show();
    const isKnown = ({ file, line, condition = '', placed }) => !placed.verified || this.#hits.has(`${file}:${line}:${condition}`);
    if (rows.every(isKnown)) return;
    // Nobody waits for the counts.
    this.#client.count(this.#launch, sources).then((counts) => {
      sources.forEach(({ file, breakpoints }, at) => breakpoints.forEach(({ line, condition = '' }, number) => {
        this.#hits.set(`${file}:${line}:${condition}`, counts[at]?.[number] ?? '');
      }));
      show();
    }, () => {});
  }

  /** A line of a file in words. */
  #place(file, line) {
    return this.#documents.names.length > 1 ? `${titleOf(file)}, line ${line}` : `line ${line}`;
  }

  /** The file of a frame; undefined if it has no editor. */
  #fileOf({ source }) {
    const { names } = this.#documents;
    if (!source?.path) return undefined;
    return names.length === 1 ? names[0] : names.find((name) => name === source.path);
  }

  /** Shows where the pixel is after a motion. @param {any[]} events */
  async #stopped(events) {
    const printed = events.filter(({ event }) => event === 'output').map(({ body }) => body.output);
    this.#lines = [...this.#lines, ...printed].slice(-MOST_LINES);
    if (printed.length > 0) this.#panel.log(this.#lines);
    const stop = events.find(({ event }) => event === 'stopped')?.body;
    if (!stop) {
      if (events.some(({ event }) => event === 'terminated')) this.#panel.say(this.#title, 'At the end of the pixel. Only steps back remain.');
      return;
    }
    this.#thread = stop.threadId;
    this.#threads = (await this.#ask('threads')).body.threads;
    this.#frames = (await this.#ask('stackTrace', { threadId: this.#thread })).body.stackFrames;
    this.#panel.quad(this.#threads, this.#thread);
    const [first] = this.#frames;
    const place = first ? `${first.name}, ${this.#place(this.#fileOf(first) ?? first.source?.name, first.line)}` : '';
    const why = [REASONS[stop.reason], stop.text].filter(Boolean).join(': ');
    this.#panel.say(this.#title, [why, place].filter(Boolean).join('. '));
    await this.#showFrame(0);
  }

  /** Shows a call: its line and its variables. @param {number} at */
  async #showFrame(at) {
    this.#frame = at;
    const frame = this.#frames[at];
    this.#panel.stack(this.#frames.map((one) => ({ name: one.name, place: this.#place(this.#fileOf(one) ?? one.source?.name, one.line) })), at);
    this.#unmark();
    const file = frame && this.#fileOf(frame);
    if (file && !file.endsWith('.json')) {
      mark(this.#documents.editor(file), { values: new Map(), current: frame.line });
      this.#documents.reveal(file, frame.line);
    }
    await this.#showValues(true);
  }

  /** @param {boolean} isMoved whether values may have changed */
  async #showValues(isMoved) {
    const shown = await this.#values.at(this.#frameId, `${this.#thread} ${this.#frames.length} ${this.#frames[this.#frame]?.name}`, isMoved);
    this.#panel.scopes(shown.scopes);
    this.#panel.watches(shown.watches);
  }

  async #toggled(change) {
    change();
    if (this.#launch) await this.#showValues(false);
  }

  /** Shows an expression over the screen. @param {string} expression */
  async #showOver(expression) {
    const label = `Values of ${expression} at ${this.#place(undefined, this.#frames[this.#frame]?.line)}`;
    if (!this.#over.hidden && this.#over.alt === label) {
      this.#hide();
      return;
    }
    const { body } = await this.#ask('shaderlint/image', { expression, frameId: this.#frameId });
    Object.assign(this.#over, { src: `data:image/png;base64,${body.png}`, alt: label, hidden: false });
    for (const [side, length] of Object.entries(this.#state.box)) this.#over.style.setProperty(side, `${length}px`);
    this.#panel.covered(true);
    const all = body.width * body.height;
    this.#panel.say(this.#title, `${label}: in ${body.pixels.toLocaleString('en')} of ${all.toLocaleString('en')} pixels`);
  }

  #hide() {
    this.#over.hidden = true;
    this.#panel.covered(false);
  }

  #unmark() {
    for (const name of this.#documents.names) mark(this.#documents.editor(name), null);
  }
}
