// What the module exports: the player on a canvas of somebody else's page.

/**
 * Plays the shader on a canvas.
 * @param {HTMLCanvasElement} canvas
 * @param {{paused?: boolean, time?: number, size?: [number, number], scale?: number, pointer?: boolean,
 *   keyboard?: boolean, sound?: boolean, onError?: (errors: ShaderError[]) => void}} [options]
 */
export function mount(canvas, options = {}) {
  const player = new Player(canvas, structuredClone(PROJECT));
  const end = new AbortController();
  if (options.size) player.resize(...options.size);
  else fitToElement(player, () => options.scale ?? 1, end.signal);
  if (options.pointer ?? true) listenToPointer(player, end.signal);
  if (options.keyboard ?? true) {
    if (!canvas.hasAttribute('tabindex')) canvas.tabIndex = 0;
    listenToKeys(player, end.signal);
  }
  const ready = player.ready.then(() => {
    if (end.signal.aborted) return;
    if (player.errors.length > 0) options.onError?.(player.errors);
    if (options.time) player.seek(options.time);
    if (options.sound) player.setSound(true);
    if (options.paused) player.poke();
    else player.play();
  });
  return {
    ready,
    get errors() {
      return player.errors.map(({ pass, line, text }) => ({ pass, line, text }));
    },
    get time() {
      return player.clock.time;
    },
    get playing() {
      return player.isPlaying;
    },
    play: () => player.play(),
    pause: () => player.pause(),
    restart: () => player.restart(),
    /** @param {number} time */
    seek: (time) => player.seek(time),
    /** @param {number} n */
    renderFrame: async (n) => {
      await ready;
      await player.renderFrame(n);
    },
    /** @param {number} x @param {number} y @param {boolean} down */
    setMouse: (x, y, down) => player.setMouse(x, y, down),
    /** @param {number} code @param {boolean} down */
    setKey: (code, down) => player.setKey(code, down),
    /** @param {boolean} on */
    setSound: (on) => player.setSound(on),
    /** @param {string} name @param {number} value */
    setTunable: (name, value) => player.setTunable(name, value),
    /** @param {string} name @param {number[]} numbers */
    setControl: (name, numbers) => player.setControl(name, numbers),
    /** @param {number} pass @param {number} channel @param {string} url */
    setInput: (pass, channel, url) => player.setInput(pass, channel, '', url),
    dispose: () => {
      end.abort();
      player.dispose();
    },
  };
}

export default mount;
