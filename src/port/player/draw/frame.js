// The state for drawing a frame. Shared with the module for three.js.

/**
 * The state for drawing a frame.
 * @typedef {object} Frame
 * @property {number} number
 * @property {number} time seconds
 * @property {number} delta seconds since the previous frame
 * @property {number} rate frames per second
 * @property {number[]} mouse
 * @property {{x: number, y: number, isDown: boolean} | null} pointer the mouse position, if known
 * @property {Map<string, number[]>} controls values set by the user
 * @property {number[]} date
 */

/** Year, month from 0, day, and seconds since midnight. */
function dateUniform() {
  const now = new Date();
  const seconds = now.getHours() * 3600 + now.getMinutes() * 60 + now.getSeconds();
  return [now.getFullYear(), now.getMonth(), now.getDate(), seconds + now.getMilliseconds() / 1000];
}

/** Number of frames in the history of the spectrum. */
const HISTORY_ROWS = 240;
const SIGNAL_WIDTH = 512;

/** Samples of sound per second. */
const SOUND_RATE = 44100;
