// Stand-ins for missing files, each drawn by a small shader.

/**
 * A stand-in in a texture.
 * @typedef {object} DrawnTexture
 * @property {WebGLTexture} texture
 * @property {(time: number) => void} draw draws a video at a time, in seconds
 * @property {Promise<void>} ready resolves when it is drawn
 */

/**
 * The stand-ins of a project. Channels with the same stand-in share its texture.
 * @param {WebGL2RenderingContext} gl
 * @param {ProjectData} project
 */
function standInCache(gl, project) {
  /** @type {Map<string, DrawnTexture>} */
  const made = new Map();
  /** @param {InputData} data */
  const get = (data) => {
    const key = [data.standIn, data.size, data.gray, data.vflip].join();
    const drawn = made.get(key) ?? drawStandIn(gl, project, data);
    made.set(key, drawn);
    return drawn;
  };
  const dispose = () => made.forEach(({ texture }) => gl.deleteTexture(texture));
  return { get, dispose };
}

/**
 * @param {WebGL2RenderingContext} gl
 * @param {ProjectData} project
 * @param {InputData} data
 * @returns {DrawnTexture}
 */
function drawStandIn(gl, project, data) {
  const fragment = project.media?.find((m) => m.name === data.standIn)?.text ?? '';
  const started = startShaders(gl, project.vertex, fragment);
  const texture = /** @type {WebGLTexture} */ (gl.createTexture());
  const [width, height, depth] = data.size ?? [1, 1, 1];
  const isVolume = data.kind === 'volume';
  const isCube = data.kind === 'cubemap';
  const target = isCube ? gl.TEXTURE_CUBE_MAP : isVolume ? gl.TEXTURE_3D : gl.TEXTURE_2D;
  const levels = Math.floor(Math.log2(Math.max(width, height, depth))) + 1;
  const format = data.gray ? gl.R8 : gl.RGBA8;
  gl.bindTexture(target, texture);
  if (isVolume) gl.texStorage3D(target, levels, format, width, height, depth);
  else gl.texStorage2D(target, levels, format, width, height);

  /** Attaches a slice or a face to the framebuffer. @param {number} layer */
  const attach = (layer) => {
    const to = gl.COLOR_ATTACHMENT0;
    const face = isCube ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + layer : gl.TEXTURE_2D;
    if (isVolume) gl.framebufferTextureLayer(gl.FRAMEBUFFER, to, texture, 0, layer);
    else gl.framebufferTexture2D(gl.FRAMEBUFFER, to, face, texture, 0);
  };
  /** @param {WebGLProgram} program @param {number} time */
  const paint = (program, time) => {
    const at = uniformLookup(gl, program);
    const framebuffer = gl.createFramebuffer();
    gl.useProgram(program);
    gl.uniform2i(at('size'), width, height);
    gl.uniform1i(at('flip'), data.vflip ? 1 : 0);
    gl.uniform1f(at('time'), time);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(0, 0, width, height);
    for (let layer = 0; layer < (isCube ? 6 : depth); layer++) {
      attach(layer);
      gl.uniform1i(at('layer'), layer);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
    gl.deleteFramebuffer(framebuffer);
    gl.bindTexture(target, texture);
    gl.generateMipmap(target);
  };
  /** @type {WebGLProgram | null} */
  let program = null;
  const draw = (/** @type {number} */ time) => program && paint(program, time);
  const ready = whenCompiled(gl, started.program).then(() => {
    program = finishProgram(gl, started);
    draw(0);
  });
  return { texture, draw, ready };
}

/**
 * Waits for a program if the browser compiles in parallel.
 * @param {WebGL2RenderingContext} gl
 * @param {WebGLProgram} program
 */
async function whenCompiled(gl, program) {
  const parallel = gl.getExtension('KHR_parallel_shader_compile');
  while (parallel && !isCompiled(gl, parallel, program)) {
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
}

/**
 * @param {InputData} data
 * @param {DrawnTexture} drawn
 * @returns {Input}
 */
function standInInput(data, drawn) {
  const input = emptyInput();
  input.ready = drawn.ready.then(() => {
    input.texture = drawn.texture;
    input.size = data.kind === 'cubemap' ? [0, 0, 0] : (data.size ?? [0, 0, 0]);
    input.isLoaded = true;
  });
  if (data.kind === 'video') {
    input.update = (time) => {
      drawn.draw(time);
      input.time = time;
    };
  }
  return input;
}

openers.standIn = (_, data, { standIns }) => (standIns ? standInInput(data, standIns.get(data)) : emptyInput());
parts.standIns = standInCache;
