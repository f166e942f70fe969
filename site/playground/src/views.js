// Images that the processor draws: heat maps, the values of a variable, and what differs between two versions.
import { DrawnImage } from './drawn.js';
import { momentOf, passOf } from './moment.js';

/** Width of the images in pixels; those that are compared are sixteen. */
const WIDTH = { view: 320, compared: 128 };

/** What can be shown, by its name in `shaderlint run --heatmap`. */
const HEATMAPS = { steps: 'Loop iterations', cost: 'Operations', divergence: 'Divergence', nan: 'Not finite' };

/** The name under the cursor of an editor, with its line. @param {import('codemirror').EditorView} view */
function nameAtCursor({ state }) {
  const { head } = state.selection.main;
  const line = state.doc.lineAt(head);
  const at = head - line.from;
  const words = [...line.text.matchAll(/[A-Za-z_]\w*/g)];
  const word = words.find(({ index, 0: name }) => index <= at && at <= index + name.length);
  return word && { name: word[0], line: line.number };
}

/** A share in percent, as the command line writes it. @param {number} share */
function percent(share) {
  const shown = 100 * share;
  if (shown === 0 || shown === 100) return `${shown} %`;
  if (shown < 0.01) return '< 0.01 %';
  if (shown < 1) return `${shown.toFixed(2)} %`;
  return `${Math.min(shown, 99.9).toFixed(1)} %`;
}

/** What a comparison found, in words. @param {any} facts */
function differences({ same, moments, size: [width, height] }) {
  if (same) return `Same image in ${moments.length} frames, bit for bit.`;
  const worst = moments.reduce((most, moment) => (moment.pixels > most.pixels ? moment : most));
  const share = percent(worst.pixels / (width * height));
  return `Differs: at ${worst.time} s in ${share} of the pixels, ${worst.shown === 0 ? 'none of them visibly' : `by up to ${worst.most.toPrecision(2)}`}.`;
}

/** The list of views, and the button that compares versions. */
export class Views {
  #image;
  #documents;
  #runner;
  #drawn;
  #parent;
  #select;
  #button;
  #status;
  /** The version to compare with. @type {import('./passes.js').Files | undefined} */
  #kept;

  /**
   * @param {{ image: import('./image.js').ShaderImage, documents: import('./documents.js').Documents,
   *   runner: import('./runner.js').Runner }} shader
   * @param {{ image: HTMLElement, select: HTMLSelectElement, button: HTMLElement, status: HTMLElement }} places
   */
  constructor({ image, documents, runner }, { image: parent, select, button, status }) {
    this.#image = image;
    this.#documents = documents;
    this.#runner = runner;
    this.#parent = parent;
    this.#drawn = new DrawnImage(parent);
    this.#select = select;
    this.#button = button;
    this.#status = status;
    select.append(new Option('Image', ''));
    for (const [name, label] of Object.entries(HEATMAPS)) select.append(new Option(label, name));
    select.append(new Option('Variable at the cursor', 'variable'));
    select.addEventListener('change', () => this.#draw());
    button.addEventListener('click', () => this.#compare());
    documents.addEventListener('change', () => this.close());
  }

  /** Shows the image of the GPU. */
  close() {
    this.#select.value = '';
    this.#drawn.close();
    this.#status.textContent = '';
  }

  /** Forgets another shader. */
  restart() {
    this.close();
    this.#kept = undefined;
    this.#button.textContent = 'Keep version';
  }

  /** The size of an image of this width. @param {number} width @returns {[number, number]} */
  #size(width) {
    const { clientWidth, clientHeight } = this.#parent;
    return [width, Math.max(1, Math.round(width * clientHeight / clientWidth))];
  }

  async #draw() {
    const { value } = this.#select;
    this.#drawn.close();
    this.#status.textContent = '';
    if (value === '') return;
    const { files, view } = this.#documents;
    const pass = passOf(this.#documents);
    const show = value === 'variable' ? nameAtCursor(view) : undefined;
    if (value === 'variable' && !show) {
      this.#select.value = '';
      this.#status.textContent = 'Place the cursor on a variable first.';
      return;
    }
    const label = show ? `Values of ${show.name} on line ${show.line}` : `Heat map: ${HEATMAPS[value].toLowerCase()}`;
    await this.#run(label, async () => {
      const options = { ...momentOf(await this.#image.state()), ...pass, size: this.#size(WIDTH.view) };
      const { image } = await this.#runner.run(files, { ...options, ...(show ? { show } : { heatmap: value }) });
      this.#drawn.show(image, label);
      return `${label}.`;
    });
  }

  async #compare() {
    const { files } = this.#documents;
    if (!this.#kept) {
      this.#kept = files;
      this.#button.textContent = 'Compare';
      this.#status.textContent = 'Kept. Change the code, then compare.';
      return;
    }
    this.#select.value = '';
    await this.#run('Comparison', async () => {
      const { facts, image } = await this.#runner.run(files, { size: this.#size(WIDTH.compared) }, this.#kept);
      if (image) this.#drawn.show(image, 'Where the versions differ');
      return differences(facts);
    });
  }

  /** Runs the shader, and shows what came of it. @param {string} label @param {() => Promise<string>} work */
  async #run(label, work) {
    this.#status.textContent = 'Drawing on the processor…';
    try {
      this.#status.textContent = await work();
    } catch (error) {
      if (error.name === 'AbortError') return;
      this.#select.value = '';
      this.#status.textContent = `${label}: ${error.message}.`;
    }
  }
}
