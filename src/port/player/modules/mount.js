// The export of the module: mounts the player on a canvas of any page.

/**
 * Plays the shader on a canvas.
 * @param {HTMLCanvasElement} canvas
 * @param {{paused?: boolean, time?: number, size?: [number, number], scale?: number, pointer?: boolean,
 *   keyboard?: boolean, sound?: boolean, hidden?: boolean, onError?: (errors: ShaderError[]) => void}} [options]
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
  if (options.hidden) void player.open();
  else playWhenSeen(player, end.signal);
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
    /** @param {string} name @param {number | boolean | number[]} value */
    setTunable: (name, value) => player.setTunable(name, value),
    uniforms: uniformsOf(player),
    get controls() {
      return structuredClone(player.project.controls);
    },
    /** @param {number} pass @param {number} channel @param {string} url */
    setInput: (pass, channel, url) => player.setInput(pass, channel, '', url),
    dispose: () => {
      end.abort();
      player.dispose();
    },
  };
}

/**
 * The uniforms set by the user, as properties: a number, a boolean, or an array with one number per
 * component.
 * @param {Player} player
 */
function uniformsOf(player) {
  const uniforms = {};
  for (const { name, kind, value } of player.project.controls) {
    Object.defineProperty(uniforms, name, {
      enumerable: true,
      get: () => {
        const numbers = [...player.controls.get(name)];
        if (value.length > 1) return numbers;
        return kind === 'bool' || kind === 'event' ? numbers[0] !== 0 : numbers[0];
      },
      set: (given) => {
        const numbers = [given].flat().map(Number);
        const isFit = numbers.length === value.length && numbers.every(Number.isFinite);
        if (!isFit) throw new TypeError(`${name} must be ${value.length === 1 ? 'a number' : `an array of ${value.length} numbers`}`);
        player.setControl(name, numbers);
      },
    });
  }
  return Object.preventExtensions(uniforms);
}

export default mount;
