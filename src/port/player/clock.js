// The clock: advances while the player plays, stops while it is paused, and counts frames.

/** Default frame duration in seconds, if the previous frame has no time. */
const FIRST_DELTA = 1 / 60;
/** Maximum time in seconds: later frame numbers do not fit into 32 bits. */
const LAST_TIME = 3e7;

/** A pause between two frames, in seconds and as a multiple of the usual one, after which the time goes on as if
 * there had been none: the tab, the machine or a debugger stood still. */
const GAP = 1;
const GAP_FACTOR = 8;

class Clock {
  constructor() {
    this.time = 0;
    /** Number of the next frame. */
    this.number = 0;
    this.rate = 60;
    /** Time of the previous frame in milliseconds, by the clock of the page; null before the first frame. */
    this.last = /** @type {number | null} */ (null);
    /** Seconds between the previous frames. */
    this.usual = 0;
    this.frames = 0;
    this.since = 0;
    this.rebase = () => this.rest();
    window.addEventListener('focus', this.rebase);
    document.addEventListener('visibilitychange', this.rebase);
  }

  /** Number of the last frame. */
  get shown() {
    return Math.max(0, this.number - 1);
  }

  dispose() {
    window.removeEventListener('focus', this.rebase);
    document.removeEventListener('visibilitychange', this.rebase);
  }

  reset() {
    this.time = 0;
    this.number = 0;
    this.last = null;
  }

  /** Leaves out the time until the next frame. */
  rest() {
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
    const delta = this.#since(now);
    if (this.last !== null) this.time += delta;
    this.last = now;
    this.#count(now);
    return this.#next(delta, this.rate);
  }

  /** Seconds since the previous frame. @param {number} now */
  #since(now) {
    if (this.last === null) return FIRST_DELTA;
    const passed = (now - this.last) / 1000;
    const isGap = passed > GAP && passed > GAP_FACTOR * this.usual;
    // A shader whose frames all take that long loses the first pause only.
    this.usual = passed;
    return isGap ? FIRST_DELTA : passed;
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
