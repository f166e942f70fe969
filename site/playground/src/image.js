// The image of the shader: the page of `shaderport` in a frame that can reach nothing else.

/** Milliseconds without changes before the image is drawn anew. */
const PAUSE = 250;

/** Shows the image of a shader in an element. */
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
  /** The shader for the next frame. */
  #project;

  /**
   * @param {HTMLElement} parent
   * @param {Promise<unknown>} isDue when the module for the image may be loaded
   */
  constructor(parent, isDue) {
    this.#parent = parent;
    this.#isDue = isDue;
    addEventListener('message', ({ data, source }) => this.#heard(data, source));
  }

  /** Shows a shader after a pause. @param {string} name @param {string} text */
  show(name, text) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#port(name, text), PAUSE);
  }

  /** Forgets the time and the mouse of another shader. */
  restart() {
    this.#state = undefined;
    this.#frame?.remove();
    this.#frame = undefined;
  }

  async #port(name, text) {
    await this.#isDue;
    if (!this.#worker) {
      this.#worker = new Worker(new URL('./port-worker.js', import.meta.url), { type: 'module' });
      this.#worker.onmessage = ({ data }) => this.#ported(data);
    }
    this.#worker.postMessage({ number: ++this.#number, name, text });
  }

  /** A shader with errors keeps the last image. */
  #ported({ number, errors, project }) {
    if (number !== this.#number) return;
    this.#parent.classList.toggle('stale', errors > 0);
    if (errors > 0) return;
    this.#next?.remove();
    const frame = document.createElement('iframe');
    frame.title = 'Image of the shader';
    frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
    frame.allow = 'autoplay; fullscreen';
    frame.className = 'next';
    frame.src = new URL('player.html', document.baseURI).href;
    this.#next = frame;
    this.#project = project;
    this.#parent.append(frame);
  }

  #heard(data, source) {
    if (source === this.#frame?.contentWindow && data.state) {
      this.#state = data.state;
      this.#open();
    }
    if (source !== this.#next?.contentWindow) return;
    // The state is that of the moment at which the next image starts.
    if (data.isReady && this.#frame) this.#frame.contentWindow.postMessage({ isWanted: true }, '*');
    else if (data.isReady) this.#open();
    if (data.drawn) {
      this.#frame?.remove();
      this.#frame = this.#next;
      this.#next = undefined;
      this.#frame.className = '';
    }
  }

  #open() {
    this.#next?.contentWindow.postMessage({ project: this.#project, state: this.#state }, '*');
  }
}
