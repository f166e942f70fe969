// Images, cube maps and volumes.

/** @param {string} url @returns {Promise<HTMLImageElement>} */
async function loadPicture(url) {
  const picture = new Image();
  picture.src = url;
  await picture.decode();
  return picture;
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
    setUnpack(gl, data.vflip, true);
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

openers.texture = (gl, data) => (data.urls ? pictureInput(gl, data, data.urls[0]) : emptyInput());
openers.cubemap = (gl, data) => (data.urls?.length === 6 ? cubeInput(gl, data, data.urls) : emptyInput());
openers.volume = (gl, data) => (data.urls ? volumeInput(gl, data, data.urls[0]) : emptyInput());
