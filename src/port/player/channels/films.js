// Videos and cameras.

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

openers.video = (gl, data, { devices }) => (data.urls && devices ? filmInput(gl, data, devices.film(data.urls[0])) : emptyInput());
openers.webcam = (gl, data, { devices }) => (devices ? filmInput(gl, data, devices.camera()) : emptyInput());
