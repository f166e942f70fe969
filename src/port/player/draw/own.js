// Uniforms and sizes of passes that declare their own.

/**
 * Sets the uniforms of a frame.
 * @param {PassProgram} program
 * @param {OwnUniform[]} uniforms
 * @param {Frame} frame
 * @param {number} width @param {number} height
 */
function setOwnUniforms(program, uniforms, frame, width, height) {
  program.gl.uniform2f(program.at('port_size'), width, height);
  for (const { name, type, source } of uniforms) {
    if (source === 'textureSize') continue;
    if (source === 'identity') setIdentity(program, name, type);
    else if (source === 'control') setUniform(program, name, type, frame.controls.get(name) ?? []);
    else setUniform(program, name, type, SOURCES[source](frame, width, height));
  }
}

/**
 * Sets the uniforms that hold sizes of textures.
 * @param {PassProgram} program
 * @param {OwnUniform[]} uniforms
 * @param {{size: number[]}[]} channels
 */
function setOwnSizes(program, uniforms, channels) {
  for (const { name, type, source, of } of uniforms) {
    const channel = source === 'textureSize' ? program.data.inputs.findIndex((i) => i?.uniform === of) : -1;
    if (channel >= 0) setUniform(program, name, type, channels[channel].size);
  }
}

/** Sets a scalar or vector; missing components are 0. @param {PassProgram} program @param {string} name @param {string} type @param {number[]} value */
function setUniform(program, name, type, value) {
  const place = program.at(name);
  if (!place || !SETTERS[type]) return;
  const [method, size] = SETTERS[type];
  const gl = /** @type {Record<string, any>} */ (/** @type {unknown} */ (program.gl));
  gl[`uniform${method}`](place, lanesOf(size, value));
}

/** Sets an identity matrix. @param {PassProgram} program @param {string} name @param {string} type mat4, mat2x3 */
function setIdentity(program, name, type) {
  const place = program.at(name);
  const gl = /** @type {Record<string, any>} */ (/** @type {unknown} */ (program.gl));
  if (place) gl[`uniformMatrix${type.slice(3)}fv`](place, false, identityOf(type));
}

/**
 * The size of a target, which may depend on controls.
 * @param {[SizeTerm, SizeTerm]} size
 * @param {number} width @param {number} height of the canvas
 * @param {Map<string, number[]>} controls
 * @returns {[number, number]}
 */
function ownSize(size, width, height, controls) {
  /** @type {Record<string, number>} */
  const canvas = { $WIDTH: width, $HEIGHT: height };
  const valueOf = (/** @type {string} */ name) => canvas[name] ?? controls.get(name)?.[0] ?? 0;
  return [pixels(sizeOf(size[0], valueOf)), pixels(sizeOf(size[1], valueOf))];
}

Object.assign(parts, { setOwnUniforms, setOwnSizes, ownSize });
