// iMouse: the position of the last drag, and of the last click with the button state as its signs.

class Mouse {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.clickX = 0;
    this.clickY = 0;
    this.isDown = false;
    /** Whether the button was pressed since the previous frame. */
    this.isClick = false;
    /** Position of the mouse, pressed or not; null until it has entered the canvas. @type {{x: number, y: number} | null} */
    this.place = null;
  }

  /** @param {number} x pixels from the left @param {number} y pixels from the bottom */
  hover(x, y) {
    this.place = { x, y };
  }

  /**
   * @param {number} x pixels from the left
   * @param {number} y pixels from the bottom
   */
  press(x, y) {
    this.hover(x, y);
    this.clickX = Math.floor(x);
    this.clickY = Math.floor(y);
    this.x = this.clickX;
    this.y = this.clickY;
    this.isDown = true;
    this.isClick = true;
  }

  /** @param {number} x @param {number} y */
  move(x, y) {
    this.hover(x, y);
    if (!this.isDown) return;
    this.x = Math.floor(x);
    this.y = Math.floor(y);
  }

  release() {
    this.isDown = false;
  }

  /** The uniform: z is positive while the button is down, w only in the frame of the click. */
  value() {
    const z = Math.abs(this.clickX);
    const w = Math.abs(this.clickY);
    return [this.x, this.y, this.isDown ? z : -z, this.isClick ? w : -w];
  }

  /** Position and button state. */
  pointer() {
    return this.place && { ...this.place, isDown: this.isDown };
  }

  endFrame() {
    this.isClick = false;
  }
}
