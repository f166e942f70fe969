// The WebGL context of a canvas, which can be given back and opened again: browsers have few, and take away
// the oldest if there are more. Meanwhile the canvas shows its last image.

const NO_WEBGL2 = 'WebGL2 is not available in this browser';
/** Width of the last image in pixels, and the shortest time between two of them in milliseconds. */
const STILL_WIDTH = 640;
const STILL_PAUSE = 4000;

/** What gives a lost context back to its canvas; another player may open it. @type {WeakMap<HTMLCanvasElement, WEBGL_lose_context>} */
const givenBack = new WeakMap();

/** Who uses the context of a canvas. @type {WeakMap<HTMLCanvasElement, ContextHolder>} */
const owners = new WeakMap();

class ContextHolder {
  /** @type {WEBGL_lose_context | null} */
  #extension = null;
  /** The last image. @type {HTMLCanvasElement | null} */
  #still = null;
  #stillTime = -Infinity;
  /** Whether the context shows a frame. */
  #hasFrame = false;
  /** Whether the context is being given back: until then it cannot be asked for again. */
  #isLeaving = false;
  #firstFrame = () => {};
  /** The style of the canvas while it shows the last image. @type {{background: string, objectPosition: string, objectFit: string} | null} */
  #style = null;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {ProjectData} project
   * @param {AbortSignal} signal
   * @param {{opened: (gl: WebGL2RenderingContext) => void, lost: () => void}} told
   */
  constructor(canvas, project, signal, told) {
    this.canvas = canvas;
    this.hasVertices = project.passes.some((p) => p.fragment);
    this.told = told;
    /** @type {WebGL2RenderingContext | null} */
    this.gl = null;
    /** Whether the context was given back on purpose. */
    this.isGivenBack = false;
    /** Whether the browser took the context away, to give it to others. */
    this.isEvicted = false;
    /** Whether images are kept in case the browser takes the context away. */
    this.isAtRisk = false;
    /** Address of the image that a canvas without a frame shows instead. */
    this.poster = '';
    /** Settles when the first frame is drawn. @type {Promise<void>} */
    this.drawn = new Promise((resolve) => {
      this.#firstFrame = resolve;
    });
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.isEvicted = this.isAtRisk && !this.#isLeaving;
      this.#isLeaving = false;
      this.#showStill();
      this.told.lost();
      // It can be restored after this event.
      if (!this.isGivenBack) setTimeout(() => this.#askBack());
    }, { signal });
    canvas.addEventListener('webglcontextrestored', () => this.#restored(), { signal });
  }

  get isLost() {
    return !this.gl || this.gl.isContextLost();
  }

  /** Opens the context, or asks for it again. Throws an Error if there is none. */
  open() {
    this.isGivenBack = false;
    this.isEvicted = false;
    const { canvas, hasVertices } = this;
    owners.set(canvas, this);
    this.gl ??= canvas.getContext('webgl2', {
      alpha: false,
      antialias: hasVertices,
      depth: hasVertices,
      stencil: false,
      preserveDrawingBuffer: true,
      powerPreference: 'high-performance',
    });
    if (!this.gl) throw new Error(NO_WEBGL2);
    if (!this.gl.isContextLost()) return this.#open();
    if (!this.#isLeaving) this.#askBack();
    return undefined;
  }

  #askBack() {
    if (!this.isLost) return;
    givenBack.get(this.canvas)?.restoreContext();
    givenBack.delete(this.canvas);
  }

  #restored() {
    if (!this.isGivenBack) return this.#open();
    this.#extension = this.gl?.getExtension('WEBGL_lose_context') ?? null;
    return this.#lose();
  }

  #open() {
    if (!this.gl) return;
    this.#extension = this.gl.getExtension('WEBGL_lose_context');
    this.#hasFrame = false;
    this.told.opened(this.gl);
  }

  /** Gives the context back, also one that the browser took away and would restore. */
  giveBack() {
    if (this.isGivenBack) return;
    this.isGivenBack = true;
    if (!this.#extension || this.isLost) return;
    if (this.#hasFrame) this.#keepStill();
    this.#lose();
  }

  #lose() {
    if (!this.#extension || this.isLost) return;
    givenBack.set(this.canvas, this.#extension);
    this.#isLeaving = true;
    this.#extension.loseContext();
  }

  /** To be called when a frame is drawn. */
  drew() {
    this.#hasFrame = true;
    this.#firstFrame();
    if (this.#style) {
      Object.assign(this.canvas.style, this.#style);
      this.#style = null;
    }
    if (this.isAtRisk && performance.now() - this.#stillTime > STILL_PAUSE) this.#keepStill();
  }

  #keepStill() {
    const { canvas } = this;
    this.#still ??= document.createElement('canvas');
    this.#still.width = Math.min(STILL_WIDTH, canvas.width);
    this.#still.height = Math.max(1, Math.round((canvas.height * this.#still.width) / canvas.width));
    this.#still.getContext('2d')?.drawImage(canvas, 0, 0, this.#still.width, this.#still.height);
    this.#stillTime = performance.now();
  }

  /** The browser shows a symbol in a canvas without its context; it is moved out of sight. */
  #showStill() {
    const { style } = this.canvas;
    if (this.#style) return;
    this.#style = { background: style.background, objectPosition: style.objectPosition, objectFit: style.objectFit };
    const image = this.#still?.toDataURL('image/webp', 0.9) ?? this.poster;
    if (image) style.background = `url("${image}") center / 100% 100% no-repeat`;
    Object.assign(style, { objectPosition: '-99999px 0', objectFit: 'none' });
  }

  /** A canvas that stays in its document keeps the context for the next player. */
  dispose() {
    setTimeout(() => {
      if (!this.canvas.isConnected && owners.get(this.canvas) === this) this.#lose();
    });
  }
}
