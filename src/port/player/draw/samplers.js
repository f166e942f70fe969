// Textures for samplers of integers, of layers and of comparisons.

/** @param {WebGL2RenderingContext} gl @param {string} type of a sampler */
function targetOf(gl, type) {
  if (type.includes('Cube')) return gl.TEXTURE_CUBE_MAP;
  if (type.includes('3D')) return gl.TEXTURE_3D;
  return type.includes('Array') ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
}

/** @param {WebGL2RenderingContext} gl @param {string} type of a sampler @returns {[number, number, number]} */
function formatOf(gl, type) {
  if (type.endsWith('Shadow')) return [gl.DEPTH_COMPONENT16, gl.DEPTH_COMPONENT, gl.UNSIGNED_SHORT];
  if (type.startsWith('i')) return [gl.RGBA8I, gl.RGBA_INTEGER, gl.BYTE];
  if (type.startsWith('u')) return [gl.RGBA8UI, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE];
  return [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE];
}

/**
 * Binds a texture of one texel to the unit at hand, for a sampler of integers, of layers or of a
 * comparison: one of another kind would keep the whole pass from being drawn.
 * @param {WebGL2RenderingContext} gl
 * @param {string} type isampler2D, sampler2DArray, sampler2DShadow
 */
function plainTexture(gl, type) {
  const texture = /** @type {WebGLTexture} */ (gl.createTexture());
  const target = targetOf(gl, type);
  const [internal, format, kind] = formatOf(gl, type);
  const sides = [0, 1, 2, 3, 4, 5].map((face) => gl.TEXTURE_CUBE_MAP_POSITIVE_X + face);
  gl.bindTexture(target, texture);
  if (target === gl.TEXTURE_3D || target === gl.TEXTURE_2D_ARRAY) {
    gl.texImage3D(target, 0, internal, 1, 1, 1, 0, format, kind, null);
  } else {
    for (const side of target === gl.TEXTURE_CUBE_MAP ? sides : [target]) {
      gl.texImage2D(side, 0, internal, 1, 1, 0, format, kind, null);
    }
  }
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  if (type.endsWith('Shadow')) gl.texParameteri(target, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
  return texture;
}

Object.assign(parts, { plainTexture, samplerTarget: targetOf });
