// Pictures and films of what the shader draws.

/** @param {Blob} blob @param {string} name */
function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** @param {Player} player */
function showCapture(player) {
  const { canvas } = player;
  element('shot', HTMLButtonElement).addEventListener('click', () => {
    canvas.toBlob((blob) => blob && save(blob, 'shader.png'));
  });
  const button = element('record', HTMLButtonElement);
  const canRecord = typeof MediaRecorder !== 'undefined' && 'captureStream' in canvas;
  button.hidden = !canRecord;
  /** @type {MediaRecorder | null} */
  let recorder = null;
  button.addEventListener('click', () => {
    if (recorder) {
      recorder.stop();
      return;
    }
    /** @type {Blob[]} */
    const parts = [];
    recorder = new MediaRecorder(canvas.captureStream(60), { videoBitsPerSecond: 16e6 });
    recorder.addEventListener('dataavailable', (event) => parts.push(event.data));
    recorder.addEventListener('stop', () => {
      save(new Blob(parts, { type: recorder?.mimeType }), 'shader.webm');
      recorder = null;
      button.setAttribute('aria-pressed', 'false');
    });
    recorder.start();
    button.setAttribute('aria-pressed', 'true');
    player.play();
  });
}

