// The values of a pixel, in a panel and at the lines that wrote them.
import { momentOf, passOf } from './moment.js';
import { Picker } from './pick.js';
import { PixelPanel } from './pixel.js';
import { Trace, nameOf } from './trace.js';
import { mark } from './trace-marks.js';
import { inShort, isInvalid } from './values.js';

/** Milliseconds without changes before the pixel is traced again. */
const PAUSE = 400;

/** Traces the pixel of an image that somebody chooses. */
export class Inspector {
  #image;
  #documents;
  #runner;
  #button;
  #picker;
  #panel;
  #timer;
  /** @type {Trace | undefined} */
  #trace;
  /** The state of the image when the inspection began. */
  #state;

  /**
   * @param {{ image: import('./image.js').ShaderImage, documents: import('./documents.js').Documents,
   *   runner: import('./runner.js').Runner }} shader
   * @param {{ button: HTMLElement, image: HTMLElement, panel: HTMLElement }} places
   */
  constructor({ image, documents, runner }, { button, image: parent, panel }) {
    this.#image = image;
    this.#documents = documents;
    this.#runner = runner;
    this.#button = button;
    this.#picker = new Picker(parent);
    this.#panel = new PixelPanel(panel);
    button.addEventListener('click', () => (this.#isOpen ? this.close() : this.#open()));
    this.#picker.addEventListener('pick', () => this.#run());
    this.#panel.addEventListener('close', () => {
      this.close();
      button.focus();
    });
    this.#panel.addEventListener('step', ({ detail }) => this.#mark(detail.isChosen));
    documents.addEventListener('change', () => this.#later());
  }

  get #isOpen() {
    return this.#button.getAttribute('aria-pressed') === 'true';
  }

  /** Ends the inspection; the image plays on. */
  close() {
    if (!this.#isOpen) return;
    clearTimeout(this.#timer);
    if (this.#state?.isPlaying) this.#image.pause(false);
    this.#button.setAttribute('aria-pressed', 'false');
    this.#picker.close();
    this.#panel.close();
    this.#unmark();
  }

  async #open() {
    this.#button.setAttribute('aria-pressed', 'true');
    this.#state = await this.#image.state();
    if (!this.#isOpen) return;
    if (!this.#state) {
      this.#panel.fail('There is no image yet.');
      return;
    }
    this.#image.pause(true);
    this.#picker.open(this.#state);
    this.#picker.focus();
    await this.#run();
  }

  /** Traces again after a change. */
  #later() {
    if (!this.#isOpen || !this.#state) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#run(), PAUSE);
  }

  async #run() {
    const options = {
      ...momentOf(this.#state),
      size: this.#state.size,
      pixel: this.#picker.pixel,
      ...passOf(this.#documents),
    };
    try {
      const { facts } = await this.#runner.run(this.#documents.files, options);
      if (!this.#isOpen) return;
      this.#trace = new Trace(facts);
      this.#panel.show(this.#trace);
    } catch (error) {
      if (!this.#isOpen || error.name === 'AbortError') return;
      this.#unmark();
      this.#panel.fail(`The pixel cannot be traced: ${error.message}.`);
    }
  }

  /** The file that a place lies in. @param {import('./trace.js').Site} site */
  #fileOf({ pass }) {
    const { names } = this.#documents;
    return names.length === 1 ? names[0] : `${pass}.glsl`;
  }

  /** Shows the values up to the current step in the editors. @param {boolean} isChosen whether to go to its line */
  #mark(isChosen) {
    const { step } = this.#panel;
    const { site: last } = this.#trace.steps[step];
    /** By file and line: the last value of each name. @type {Map<string, Map<number, Map<string, any[]>>>} */
    const files = new Map(this.#documents.names.map((name) => [name, new Map()]));
    for (const [site, value] of this.#trace.placesAt(step)) {
      const lines = files.get(this.#fileOf(site));
      lines?.set(site.line, (lines.get(site.line) ?? new Map()).set(nameOf(site), value));
    }
    for (const [name, lines] of files) {
      const values = new Map([...lines].map(([line, names]) => {
        const texts = [...names].map(([own, value]) => `${own} ${inShort(value)}`);
        return [line, { text: texts.join('   '), isInvalid: [...names.values()].some(isInvalid) }];
      }));
      const current = this.#fileOf(last) === name ? last.line : undefined;
      mark(this.#documents.editor(name), name.endsWith('.json') ? null : { values, current });
    }
    if (isChosen) this.#documents.reveal(this.#fileOf(last), last.line);
  }

  #unmark() {
    this.#trace = undefined;
    for (const name of this.#documents.names) mark(this.#documents.editor(name), null);
  }
}
