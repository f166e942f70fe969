// Inputs of channels, except the output of other passes.

/**
 * The input of a channel: a texture and its uniform values.
 * @typedef {object} Input
 * @property {WebGLTexture | null} texture null until it is loaded
 * @property {number[]} size width, height, depth; zeros until it is loaded
 * @property {number} time position in a video or in music, in seconds
 * @property {boolean} isLoaded
 * @property {Promise<void>} ready settles when loading has succeeded or failed
 * @property {(time: number) => void} update called before each frame
 * @property {(isOn: boolean) => void} play starts or stops sound and video with the clock
 * @property {() => void} rewind
 * @property {() => void} dispose
 */

const nothing = () => {};

/**
 * Opens the input of a channel. Mipmaps are generated if the filter requires them.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {Devices} devices
 * @param {ReturnType<typeof standInCache>} standIns
 * @returns {Input}
 */
function openInput(gl, data, devices, standIns) {
  if (!data.urls && data.standIn && data.kind !== 'music') return standInInput(data, standIns.get(data));
  switch (data.kind) {
    case 'texture':
      return data.urls ? pictureInput(gl, data, data.urls[0]) : emptyInput();
    case 'cubemap':
      return data.urls?.length === 6 ? cubeInput(gl, data, data.urls) : emptyInput();
    case 'volume':
      return data.urls ? volumeInput(gl, data, data.urls[0]) : emptyInput();
    case 'video':
      return data.urls ? filmInput(gl, data, devices.film(data.urls[0])) : emptyInput();
    case 'webcam':
      return filmInput(gl, data, devices.camera());
    case 'music':
    case 'mic':
      return data.form
        ? formInput(gl, data, openSignal(gl, data, devices, standIns))
        : signalInput(gl, data, openSignal(gl, data, devices, standIns));
    default:
      return emptyInput();
  }
}

/** @returns {Input} */
function emptyInput() {
  return {
    texture: null,
    size: [0, 0, 0],
    time: 0,
    isLoaded: false,
    ready: Promise.resolve(),
    update: nothing,
    play: nothing,
    rewind: nothing,
    dispose: nothing,
  };
}

/** @param {string} url @returns {Promise<HTMLImageElement>} */
async function loadPicture(url) {
  const picture = new Image();
  picture.src = url;
  await picture.decode();
  return picture;
}

/** Pixels are uploaded as they are in the file. @param {WebGL2RenderingContext} gl @param {boolean} flip */
function setUnpack(gl, flip) {
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, flip);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {string} url
 * @returns {Input}
 */
function pictureInput(gl, data, url) {
  const input = emptyInput();
  input.ready = loadPicture(url).then((picture) => {
    const texture = gl.createTexture();
    const [internal, format] = data.gray ? [gl.R8, gl.RED] : [gl.RGBA8, gl.RGBA];
    gl.bindTexture(gl.TEXTURE_2D, texture);
    setUnpack(gl, data.vflip);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, format, gl.UNSIGNED_BYTE, picture);
    if (data.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_2D);
    input.texture = texture;
    input.size = [picture.naturalWidth, picture.naturalHeight, 1];
    input.isLoaded = true;
  });
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * Six images, one for each face. If they are flipped, the top and the bottom are swapped.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {string[]} urls
 * @returns {Input}
 */
function cubeInput(gl, data, urls) {
  const input = emptyInput();
  const order = data.vflip ? [0, 1, 3, 2, 4, 5] : [0, 1, 2, 3, 4, 5];
  input.ready = Promise.all(order.map((i) => loadPicture(urls[i]))).then((pictures) => {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
    setUnpack(gl, data.vflip);
    pictures.forEach((picture, face) => {
      const side = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
      gl.texImage2D(side, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    });
    if (data.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_CUBE_MAP);
    input.texture = texture;
    input.isLoaded = true;
  });
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * ShaderToy's volume file: a signature, three sizes of 32 bits, the number of components, a layout,
 * a format (0 for bytes, 10 for floats), and from byte 20 on the data.
 * @param {ArrayBuffer} bytes
 */
function readVolume(bytes) {
  const view = new DataView(bytes);
  const size = [4, 8, 12].map((at) => view.getUint32(at, true));
  const components = view.getUint8(16);
  const isFloat = view.getUint16(18, true) === 10;
  const count = size[0] * size[1] * size[2] * components;
  const data = isFloat ? new Float32Array(bytes, 20, count) : new Uint8Array(bytes, 20, count);
  return { size, components, isFloat, data };
}

/** The bytes of a base64 data: URL. @param {string} url */
function loadBytes(url) {
  const text = atob(url.slice(url.indexOf(',') + 1));
  return Uint8Array.from(text, (c) => c.charCodeAt(0)).buffer;
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {string} url
 * @returns {Input}
 */
function volumeInput(gl, data, url) {
  const input = emptyInput();
  input.ready = Promise.resolve().then(() => {
    const volume = readVolume(loadBytes(url));
    const [width, height, depth] = volume.size;
    const formats = volume.isFloat
      ? [[gl.R32F, gl.RED], [gl.RG32F, gl.RG], [gl.RGB32F, gl.RGB], [gl.RGBA32F, gl.RGBA]]
      : [[gl.R8, gl.RED], [gl.RG8, gl.RG], [gl.RGB8, gl.RGB], [gl.RGBA8, gl.RGBA]];
    const [internal, format] = formats[volume.components - 1];
    const type = volume.isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_3D, texture);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage3D(gl.TEXTURE_3D, 0, internal, width, height, depth, 0, format, type, volume.data);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    if (data.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_3D);
    input.texture = texture;
    input.size = volume.size;
    input.isLoaded = true;
  });
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * A video or a camera, uploaded before each frame.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {HTMLVideoElement} film
 * @returns {Input}
 */
function filmInput(gl, data, film) {
  const input = emptyInput();
  input.update = () => {
    if (film.readyState < film.HAVE_CURRENT_DATA) return;
    input.texture ??= gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, input.texture);
    setUnpack(gl, data.vflip);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, film);
    if (data.filter === 'mipmap') gl.generateMipmap(gl.TEXTURE_2D);
    input.size = [film.videoWidth, film.videoHeight, 1];
    input.time = film.currentTime;
    input.isLoaded = true;
  };
  input.play = (isOn) => void (isOn ? film.play().catch(nothing) : film.pause());
  input.rewind = () => {
    if (!film.srcObject) film.currentTime = 0;
  };
  input.dispose = () => gl.deleteTexture(input.texture);
  return input;
}

/**
 * The audio source of a channel.
 * @param {WebGL2RenderingContext} gl
 * @param {InputData} data
 * @param {Devices} devices
 * @param {ReturnType<typeof standInCache>} standIns
 * @returns {Signal}
 */
function openSignal(gl, data, devices, standIns) {
  if (data.urls || !data.standIn) return devices.signal(data);
  const drawn = standIns.get(data);
  return devices.loop(drawn.ready.then(() => standInSound(gl, data, drawn)));
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
    const analyser = signal.analyser();
    if (analyser) {
      analyser.getByteFrequencyData(spectrum);
      analyser.getByteTimeDomainData(wave);
    } else {
      makeUpSignal(time, spectrum, wave);
    }
    input.time = analyser ? signal.time() : 10 + time;
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
    const analyser = signal.analyser();
    if (analyser) {
      analyser.getByteFrequencyData(spectrum);
      analyser.getByteTimeDomainData(wave);
    } else {
      makeUpSignal(time, spectrum, wave);
    }
    input.time = analyser ? signal.time() : 10 + time;
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
