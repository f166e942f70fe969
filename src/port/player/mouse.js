// iMouse: where the button was pressed, where it is, and what the signs say.

class Mouse {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.clickX = 0;
    this.clickY = 0;
    this.isDown = false;
    /** The button went down since the last frame. */
    this.isClick = false;
    /** Where the mouse is, pressed or not; null until it has come. @type {{x: number, y: number} | null} */
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

  /** Where it is, and whether its button is down. */
  pointer() {
    return this.place && { ...this.place, isDown: this.isDown };
  }

  endFrame() {
    this.isClick = false;
  }
}
