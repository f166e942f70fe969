// Shaders of numbered vertices.

/** Maximum number of vertices. */
const MAX_VERTICES = 100000;

/**
 * Draws numbered vertices on a background. Controls set their number, the background and the primitive
 * type: the values of `port_mode` are those of WebGL.
 * @param {WebGL2RenderingContext} gl
 * @param {Map<string, number[]>} controls
 */
function drawVertices(gl, controls) {
  const [mode, count, background] = ['port_mode', 'vertexCount', 'background'].map((name) => controls.get(name) ?? []);
  const [r = 0, g = 0, b = 0, a = 1] = background;
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  gl.clearColor(r, g, b, a);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.drawArrays(mode[0] ?? gl.LINES, 0, Math.min(MAX_VERTICES, Math.max(0, Math.floor(count[0] ?? 0))));
  gl.disable(gl.DEPTH_TEST);
  gl.disable(gl.BLEND);
}

/** The numbers of the vertices as an attribute. @param {WebGL2RenderingContext} gl */
function numberVertices(gl) {
  return fillAttribute(gl, 1, 1, Float32Array.from({ length: MAX_VERTICES }, (_, i) => i));
}

Object.assign(parts, { numberVertices, drawVertices });
