// Draws fragment shaders without a page around them.
import { bytesOf } from './browser.js';

/**
 * Draws fragment shaders; resolves to the pixels of each, `null` for one that cannot be drawn alone. @param
 * {object} given values of uniforms
 */
export async function draw(page, sources, given = {}) {
  const drawn = await page.evaluate(({ all, known }) => {
    const gl = new OffscreenCanvas(64, 36).getContext('webgl2', { antialias: false });
    const vertex = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }`;
    const made = (type, source) => {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      return shader;
    };
    /** Sets every uniform to different numbers. */
    function fill(program) {
      const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
      for (let i = 0; i < count; i++) {
        const { name, type, size } = gl.getActiveUniform(program, i);
        const place = gl.getUniformLocation(program, name);
        const widths = {
          [gl.FLOAT]: '1f', [gl.FLOAT_VEC2]: '2f', [gl.FLOAT_VEC3]: '3f', [gl.FLOAT_VEC4]: '4f',
          [gl.INT]: '1i', [gl.INT_VEC2]: '2i', [gl.INT_VEC3]: '3i', [gl.INT_VEC4]: '4i',
        };
        const form = widths[type];
        const value = (k) => (form?.endsWith('f') ? 0.75 + 0.25 * (i + k) : 2 + i + k);
        const values = known[name] ?? (form && Array.from({ length: Number(form[0]) * size }, (_, k) => value(k)));
        if (form && place) gl[`uniform${form}v`](place, values);
      }
    }
    return all.map((source) => {
      const program = gl.createProgram();
      gl.attachShader(program, made(gl.VERTEX_SHADER, vertex));
      gl.attachShader(program, made(gl.FRAGMENT_SHADER, source));
      gl.linkProgram(program);
      if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
      gl.useProgram(program);
      fill(program);
      gl.clear(gl.COLOR_BUFFER_BIT);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const bytes = new Uint8Array(64 * 36 * 4);
      gl.readPixels(0, 0, 64, 36, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      gl.deleteProgram(program);
      return bytes.toBase64();
    });
  }, { all: sources, known: given });
  return drawn.map((base64) => base64 && bytesOf(base64));
}
