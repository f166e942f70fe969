// Lets somebody choose a pixel of the image, with the mouse or the keyboard.
import { element } from './element.js';

/** How far the arrow keys go in pixels, and with Shift. */
const STEPS = { near: 1, far: 10 };
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * The image that a pixel is chosen of: its pixels, and where it lies in the element.
 * @typedef {{ size: [number, number], box: { left: number, top: number, width: number, height: number } }} Target
 */

/** A layer above the image. It fires `pick` when a pixel is chosen. */
export class Picker extends EventTarget {
  #parent;
  #layer = element('div', { className: 'picker', tabIndex: 0 });
  #cross = element('div', { className: 'cross' });
  /** @type {Target | undefined} */
  #target;
  /** The pixel, from the lower left corner. @type {[number, number]} */
  pixel = [0, 0];

  /** @param {HTMLElement} parent */
  constructor(parent) {
    super();
    this.#parent = parent;
    this.#layer.setAttribute('role', 'application');
    this.#layer.ariaLabel = 'Pixel of the image: arrow keys move, with Shift by ten pixels';
    this.#layer.append(this.#cross);
    this.#layer.addEventListener('pointerdown', (event) => this.#clicked(event));
    this.#layer.addEventListener('keydown', (event) => this.#pressed(event));
  }

  /** Lets a pixel be chosen of an image. @param {Target} target @param {number[]} [pixel] the first one */
  open(target, pixel) {
    const isOther = this.#target?.size.join() !== target.size.join();
    this.#target = target;
    if (isOther) this.pixel = [Math.floor(target.size[0] / 2), Math.floor(target.size[1] / 2)];
    if (pixel) this.pixel = this.#inside(pixel);
    this.#parent.append(this.#layer);
    this.#place();
  }

  focus() {
    this.#layer.focus();
  }

  close() {
    this.#layer.remove();
  }

  #clicked({ offsetX, offsetY, target }) {
    const { size: [width, height], box } = this.#target;
    const isCross = target === this.#cross;
    const x = (isCross ? this.#cross.offsetLeft + offsetX : offsetX) - box.left;
    const y = (isCross ? this.#cross.offsetTop + offsetY : offsetY) - box.top;
    this.#choose([Math.floor(x / box.width * width), height - 1 - Math.floor(y / box.height * height)]);
  }

  #pressed(event) {
    const arrow = ARROWS[event.key];
    if (!arrow) return;
    event.preventDefault();
    const by = event.shiftKey ? STEPS.far : STEPS.near;
    this.#choose([this.pixel[0] + by * arrow[0], this.pixel[1] + by * arrow[1]]);
  }

  /** The nearest pixel of the image. @returns {[number, number]} */
  #inside([x, y]) {
    const { size: [width, height] } = this.#target;
    return [Math.min(Math.max(0, x), width - 1), Math.min(Math.max(0, y), height - 1)];
  }

  #choose(pixel) {
    this.pixel = this.#inside(pixel);
    this.#place();
    this.dispatchEvent(new Event('pick'));
  }

  #place() {
    const { size: [width, height], box } = this.#target;
    const [x, y] = this.pixel;
    this.#cross.style.left = `${box.left + (x + 0.5) / width * box.width}px`;
    this.#cross.style.top = `${box.top + (height - 0.5 - y) / height * box.height}px`;
  }
}
