// Sound as texels: recorded, summed, or made up where there is none. Shared with the module for three.js.

/** Initial texels of a sound texture. @param {string} [form] */
function signalTexels(form) {
  if (form === 'sum') return new Float32Array(4 * SIGNAL_WIDTH);
  return new Uint8Array(4 * SIGNAL_WIDTH * (form === 'history' ? HISTORY_ROWS : 1));
}

/**
 * Adds a row to a sound texture; rows of a history move up, and a sum grows by one per second at full
 * level.
 * @param {Uint8Array | Float32Array} texels
 * @param {Uint8Array} values
 * @param {number} seconds since the previous row
 */
function addSignal(texels, values, seconds) {
  if (texels instanceof Float32Array) {
    for (let i = 0; i < texels.length; i++) texels[i] += (i % 4 < 3 ? seconds : 0) * (values[i >> 2] / 255);
    return;
  }
  const hasHistory = texels.length > 4 * SIGNAL_WIDTH;
  texels.copyWithin(4 * SIGNAL_WIDTH, 0);
  for (let i = 0; i < SIGNAL_WIDTH; i++) {
    texels.fill(values[i], 4 * i, 4 * i + 4);
    if (!hasHistory) texels[4 * i + 3] = 255;
  }
}

/**
 * Synthesises a spectrum and waveform for silent sound.
 * @param {number} time
 * @param {Uint8Array} spectrum
 * @param {Uint8Array} wave
 */
function makeUpSignal(time, spectrum, wave) {
  const count = spectrum.length;
  for (let j = 0; j < count; j++) {
    const x = j / count;
    let f = (0.75 + 0.25 * Math.sin(10 * j + 13 * time)) * Math.exp(-3 * x);
    if (j < 3) f = Math.pow(0.5 + 0.5 * Math.sin(6.2831 * time), 4) * (1 - j / 3);
    spectrum[j] = Math.floor(255 * f);
  }
  for (let j = 0; j < wave.length; j++) {
    const x = j / wave.length;
    const f = 0.5 + 0.15 * Math.sin(17 * time + 62.831 * x) * Math.sin(23 * time + 1.9 * x);
    wave[j] = Math.floor(255 * f);
  }
}
