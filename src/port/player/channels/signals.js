// Music and microphones.

/**
 * The audio source of a channel.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {Surroundings} around
 * @returns {Signal}
 */
function openSignal(gl, data, { devices, standIns }) {
  if (!devices) return silence;
  if (data.urls || !data.standIn || !standIns) return devices.signal(data);
  const drawn = standIns.get(data);
  return devices.loop(drawn.ready.then(() => standInSound(gl, data, drawn)));
}

/**
 * Reads the spectrum and the waveform of a signal, which are made up while it is silent. Returns the position in
 * it, in seconds.
 * @param {Signal} signal @param {number} time @param {Uint8Array<ArrayBuffer>} spectrum @param {Uint8Array<ArrayBuffer>} wave
 */
function readSignal(signal, time, spectrum, wave) {
  const analyser = signal.analyser();
  if (!analyser) {
    makeUpSignal(time, spectrum, wave);
    return 10 + time;
  }
  analyser.getByteFrequencyData(spectrum);
  analyser.getByteTimeDomainData(wave);
  return signal.time();
}

/**
 * Music or a microphone as a texture of 512 x 2: the spectrum and the waveform. Without sound, both are
 * synthesised from the time, as in ShaderToy.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {Signal} signal
 * @returns {Input}
 */
function signalInput(gl, data, signal) {
  const input = emptyInput();
  const spectrum = new Uint8Array(1024);
  const wave = new Uint8Array(1024);
  input.texture = gl.createTexture();
  input.size = [512, 2, 1];
  input.isLoaded = true;
  gl.bindTexture(gl.TEXTURE_2D, input.texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, 512, 2, 0, gl.RED, gl.UNSIGNED_BYTE, null);
  input.update = (time) => {
    input.time = readSignal(signal, time, spectrum, wave);
    gl.bindTexture(gl.TEXTURE_2D, input.texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 512, 1, gl.RED, gl.UNSIGNED_BYTE, spectrum);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 1, 512, 1, gl.RED, gl.UNSIGNED_BYTE, wave);
    if (data.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_2D);
  };
  input.play = signal.play;
  input.rewind = signal.rewind;
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * Music or a microphone as a texture of the spectrum, of the waveform, of the most recent spectra with the
 * newest at the bottom, or of the sum of all spectra.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {Signal} signal
 * @returns {Input}
 */
function formInput(gl, data, signal) {
  const input = emptyInput();
  const [spectrum, wave] = [new Uint8Array(1024), new Uint8Array(1024)];
  const texels = signalTexels(data.form);
  const rows = texels.length / (4 * SIGNAL_WIDTH);
  const isFloat = texels instanceof Float32Array;
  const [internal, type] = isFloat ? [gl.RGBA32F, gl.FLOAT] : [gl.RGBA8, gl.UNSIGNED_BYTE];
  let last = 0;
  input.texture = gl.createTexture();
  input.size = [SIGNAL_WIDTH, rows, 1];
  input.isLoaded = true;
  input.update = (time) => {
    input.time = readSignal(signal, time, spectrum, wave);
    const values = data.form === 'wave' ? wave : spectrum;
    addSignal(texels, values, Math.max(0, time - last));
    last = time;
    gl.bindTexture(gl.TEXTURE_2D, input.texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, SIGNAL_WIDTH, rows, 0, gl.RGBA, type, texels);
  };
  input.play = signal.play;
  input.rewind = () => {
    texels.fill(0);
    last = 0;
    signal.rewind();
  };
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * The samples of a tune, which its stand-in holds as bytes.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {DrawnTexture} drawn
 */
function standInSound(gl, data, { texture }) {
  const [width, height] = data.size ?? [1, 1];
  const bytes = new Uint8Array(width * height * 4);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  gl.deleteFramebuffer(framebuffer);
  const side = (/** @type {number} */ at) =>
    Float32Array.from({ length: width * height }, (_, i) => soundSample(bytes[4 * i + at], bytes[4 * i + at + 1]));
  return [side(0), side(2)];
}

/** @param {WebGL2RenderingContext} gl @param {InputData} data @param {Surroundings} around */
function openHeard(gl, data, around) {
  const signal = openSignal(gl, data, around);
  return data.form ? formInput(gl, data, signal) : signalInput(gl, data, signal);
}

openers.music = openHeard;
openers.mic = openHeard;
