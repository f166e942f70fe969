// Inputs of channels, except the output of other passes. Mipmaps are generated if the filter requires them.

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

/**
 * Pixels are uploaded as they are in the file. Like ShaderToy, faces of cube maps are converted to the colours
 * of the page.
 * @param {WebGL2RenderingContext} gl @param {boolean} flip @param {boolean} [isFace]
 */
function setUnpack(gl, flip, isFace = false) {
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, flip);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, isFace ? gl.BROWSER_DEFAULT_WEBGL : gl.NONE);
}
