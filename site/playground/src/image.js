// The image of the shader: the page of `shaderport` in a frame that can reach nothing else.

import { frameCost, inWords } from './cost.js';
import { theme } from './theme.js';

/** Milliseconds without changes before the image is drawn anew. */
const PAUSE = 250;
/** Milliseconds that the last image has for telling its time. */
const PATIENCE = 500;

/** Shows the image of a shader in an element, unless that might stop the browser from responding. */
export class ShaderImage {
  #parent;
  #isDue;
  #worker;
  #timer;
  #number = 0;
  /** The frame that is shown, and the next one until it has drawn. */
  #frame;
  #next;
  #state;
  /** Who waits for the state. */
  #asked = [];
  /** The shader for the next frame. */
  #project;
  /** Size and uniforms of a link. @type {import('./debug-link.js').DebugStart | undefined} */
  #start;
  /** What somebody answered about a shader that takes many operations: drawn pixels per pixel. */
  #answer;
  /** Whether the next shader is another one, and not a change of the last. */
  #isOther = true;

  /**
   * @param {HTMLElement} parent
   * @param {Promise<unknown>} isDue when the module for the image may be loaded
   */
  constructor(parent, isDue) {
    this.#parent = parent;
    this.#isDue = isDue;
    addEventListener('message', ({ data, source }) => this.#heard(data, source));
    document.addEventListener('theme', () => this.#frame?.contentWindow.postMessage({ theme: theme() }, '*'));
  }

  /** What the frame shows: time, mouse, size and place of the canvas; undefined if no frame answers. */
  state() {
    const frame = this.#frame;
    if (!frame) return Promise.resolve(undefined);
    frame.contentWindow.postMessage({ isWanted: true }, '*');
    return new Promise((resolve) => {
      this.#asked.push(resolve);
      setTimeout(() => resolve(undefined), PATIENCE);
    });
  }

  /** Stops the image, or lets it continue. @param {boolean} isPaused */
  pause(isPaused) {
    this.#frame?.contentWindow.postMessage({ isPaused }, '*');
  }

  /** Shows files after a pause, or at once if they are another shader. @param {import('./passes.js').Files} files */
  show(files) {
    clearTimeout(this.#timer);
    if (this.#isOther) this.#port(files);
    else this.#timer = setTimeout(() => this.#port(files), PAUSE);
    this.#isOther = false;
  }

  /**
   * Forgets the image, the time and the mouse of another shader, and what its port would still answer.
   * @param {import('./debug-link.js').DebugStart} [start] what the next image shows, standing still
   */
  restart(start) {
    clearTimeout(this.#timer);
    this.#number++;
    this.#isOther = true;
    this.#start = start;
    const [x, y] = start?.mouse ?? [];
    const mouse = start?.mouse && { x, y, clickX: x, clickY: y };
    this.#state = start?.time === undefined ? undefined : { time: start.time, isPlaying: false, mouse };
    this.#answer = undefined;
    this.#forget();
  }

  async #port(files) {
    const number = ++this.#number;
    await this.#isDue;
    if (number !== this.#number) return;
    if (!this.#worker) {
      this.#worker = new Worker(new URL('./port-worker.js', import.meta.url), { type: 'module' });
      this.#worker.onmessage = ({ data }) => this.#ported(data);
    }
    this.#worker.postMessage({ number, files });
  }

  /** A shader with errors keeps the last image. */
  #ported({ number, errors, project, operations, isMore }) {
    if (number !== this.#number) return;
    this.#parent.classList.toggle('stale', errors > 0);
    if (errors > 0) return;
    this.#parent.querySelector('.question')?.remove();
    this.#project = project;
    const { clientWidth, clientHeight } = this.#parent;
    const [width, height] = this.#start?.size ?? [clientWidth * devicePixelRatio, clientHeight * devicePixelRatio];
    const { operations: all, divisor } = frameCost(operations, width * height);
    if (divisor > 1 && this.#answer === undefined) this.#ask(all, isMore, divisor);
    else this.#draw(divisor > 1 ? this.#answer : 1);
  }

  /** Asks before a frame is drawn that takes long. */
  #ask(all, isMore, divisor) {
    this.#forget();
    const question = document.createElement('div');
    question.className = 'question';
    question.setAttribute('role', 'alert');
    const text = document.createElement('p');
    text.textContent = `This frame needs ${isMore ? 'more than ' : ''}${inWords(all)} operations, which may freeze the browser.`;
    const button = (label, scale) => {
      const made = Object.assign(document.createElement('button'), { type: 'button', textContent: label });
      made.addEventListener('click', () => {
        this.#answer = scale;
        question.remove();
        this.#draw(scale);
      });
      return made;
    };
    question.append(text, button(`Draw 1/${divisor} of the pixels`, 1 / divisor), button('Draw all', 1));
    this.#parent.append(question);
  }

  /** Draws the shader in a frame. @param {number} share of the pixels */
  #draw(share) {
    this.#next?.remove();
    const frame = document.createElement('iframe');
    frame.title = 'Image of the shader';
    frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
    frame.allow = 'autoplay; fullscreen';
    frame.className = 'next';
    frame.inert = true;
    const { size, uniforms = [] } = this.#start ?? {};
    const settings = new URLSearchParams(uniforms);
    if (share < 1) settings.set('scale', Math.sqrt(share).toFixed(3));
    else if (size) settings.set('size', size.join('x'));
    frame.dataset.settings = settings.toString();
    this.#next = frame;
    this.#load(frame).catch(() => {});
  }

  /** Loads the page of the player into a frame, and shows it. @param {HTMLIFrameElement} frame */
  async #load(frame) {
    const page = new URL('player.html', document.baseURI);
    if (navigator.onLine) {
      page.hash = frame.dataset.settings;
      frame.src = page.href;
    } else {
      // The service worker has the page, but not for frames with a sandbox. The policy allows its script.
      frame.srcdoc = await (await fetch(page)).text();
    }
    if (frame === this.#next) this.#parent.append(frame);
  }

  /** Removes all images and questions. */
  #forget() {
    this.#frame?.remove();
    this.#next?.remove();
    this.#frame = undefined;
    this.#next = undefined;
    this.#parent.querySelector('.question')?.remove();
  }

  #heard(data, source) {
    if (source === this.#frame?.contentWindow && data.state) {
      this.#state = data.state;
      for (const resolve of this.#asked.splice(0)) resolve(data.state);
      this.#open(this.#next);
    }
    const next = this.#next;
    if (!next || source !== next.contentWindow) return;
    if (data.isReady) {
      next.dataset.state = 'ready';
      // The state is that of the moment at which the next image starts. A frame that is busy drawing may not
      // answer.
      this.#frame?.contentWindow.postMessage({ isWanted: true }, '*');
      setTimeout(() => this.#open(next), this.#frame ? PATIENCE : 0);
    }
    if (data.drawn) {
      this.#frame?.remove();
      this.#frame = next;
      this.#next = undefined;
      this.#frame.className = '';
      this.#frame.inert = false;
      this.#parent.dispatchEvent(new Event('drawn'));
    }
  }

  /** Sends the shader to a frame, once. */
  #open(frame) {
    if (!frame || frame !== this.#next || frame.dataset.state !== 'ready') return;
    frame.dataset.state = 'opened';
    const { settings } = frame.dataset;
    frame.contentWindow.postMessage({ project: this.#project, state: this.#state, theme: theme(), settings }, '*');
  }
}
