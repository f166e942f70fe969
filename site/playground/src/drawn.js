// An image that was drawn on the processor, above that of the GPU.
import { element } from './element.js';

/** Shows images in an element. */
export class DrawnImage {
  #canvas = element('canvas', { className: 'drawn', hidden: true });

  /** @param {HTMLElement} parent */
  constructor(parent) {
    this.#canvas.setAttribute('role', 'img');
    parent.append(this.#canvas);
  }

  /**
   * Shows an image of three bytes per pixel.
   * @param {{ size: [number, number], rgb: string }} image
   * @param {string} label
   */
  show({ size: [width, height], rgb }, label) {
    const bytes = Uint8Array.from(atob(rgb), (char) => char.charCodeAt(0));
    const pixels = new ImageData(width, height);
    for (let from = 0, to = 0; from < bytes.length; from += 3, to += 4) {
      pixels.data.set([bytes[from], bytes[from + 1], bytes[from + 2], 255], to);
    }
    Object.assign(this.#canvas, { width, height, ariaLabel: label, hidden: false });
    this.#canvas.getContext('2d').putImageData(pixels, 0, 0);
  }

  close() {
    this.#canvas.hidden = true;
  }
}
