// Time: it runs while the player plays, stands while it is paused, and counts the frames.

/** Seconds from a frame to the next where nothing says how long it took. */
const FIRST_DELTA = 1 / 60;
/** Behind this many seconds the number of the frame would not fit into 32 bits. */
const LAST_TIME = 3e7;

class Clock {
  constructor() {
    this.time = 0;
    /** Number of the frame that is drawn next. */
    this.number = 0;
    this.rate = 60;
    /** When the frame before was drawn, in milliseconds of the page; null before the first. */
    this.last = /** @type {number | null} */ (null);
    this.frames = 0;
    this.since = 0;
    this.rebase = () => {
      this.last = null;
    };
    window.addEventListener('focus', this.rebase);
  }

  dispose() {
    window.removeEventListener('focus', this.rebase);
  }

  reset() {
    this.time = 0;
    this.number = 0;
    this.last = null;
  }

  resume() {
    this.last = null;
  }

  pause() {
    this.last = null;
  }

  /** Goes to a time, and to the frame that would be drawn then. @param {number} time */
  seek(time) {
    if (typeof time !== 'number' || Number.isNaN(time)) throw new TypeError('a time is a number of seconds');
    this.time = Math.min(Math.max(0, time), LAST_TIME);
    this.number = Math.round(this.time / FIRST_DELTA);
    this.last = null;
  }

  /** The next frame while playing. */
  tick() {
    const now = performance.now();
    const delta = this.last === null ? FIRST_DELTA : (now - this.last) / 1000;
    if (this.last !== null) this.time += delta;
    this.last = now;
    this.#count(now);
    return this.#next(delta, this.rate);
  }

  /** A frame while time stands. */
  frozen() {
    return this.#next(FIRST_DELTA, this.rate);
  }

  /** The next of sixty frames a second. */
  step() {
    this.time = this.number * FIRST_DELTA;
    return this.#next(FIRST_DELTA, 60);
  }

  /** @param {number} delta @param {number} rate */
  #next(delta, rate) {
    return { number: this.number++, time: this.time, delta, rate };
  }

  /** Counts frames a second. @param {number} now */
  #count(now) {
    this.frames++;
    if (now - this.since < 1000) return;
    if (this.since > 0) this.rate = (1000 * this.frames) / (now - this.since);
    this.since = now;
    this.frames = 0;
  }
}
