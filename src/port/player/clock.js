// The clock: advances while the player plays, stops while it is paused, and counts frames.

/** Default frame duration in seconds, if the previous frame has no time. */
const FIRST_DELTA = 1 / 60;
/** Maximum time in seconds: later frame numbers do not fit into 32 bits. */
const LAST_TIME = 3e7;

class Clock {
  constructor() {
    this.time = 0;
    /** Number of the next frame. */
    this.number = 0;
    this.rate = 60;
    /** Time of the previous frame in milliseconds, by the clock of the page; null before the first frame. */
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

  /** Seeks to a time and the corresponding frame. @param {number} time */
  seek(time) {
    if (typeof time !== 'number' || Number.isNaN(time)) throw new TypeError('the time must be a number of seconds');
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

  /** The next frame while paused. */
  frozen() {
    return this.#next(FIRST_DELTA, this.rate);
  }

  /** The next frame at 60 frames per second. */
  step() {
    this.time = this.number * FIRST_DELTA;
    return this.#next(FIRST_DELTA, 60);
  }

  /** @param {number} delta @param {number} rate */
  #next(delta, rate) {
    return { number: this.number++, time: this.time, delta, rate };
  }

  /** Measures the frame rate. @param {number} now */
  #count(now) {
    this.frames++;
    if (now - this.since < 1000) return;
    if (this.since > 0) this.rate = (1000 * this.frames) / (now - this.since);
    this.since = now;
    this.frames = 0;
  }
}
