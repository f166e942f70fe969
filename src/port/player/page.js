// The page around the player: controls, error panel, sliders, files for channels.

/** @template {HTMLElement} T @param {string} id @param {new () => T} type @returns {T} */
function element(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${id}`);
  return found;
}

/**
 * @param {string} tag @param {string} [text] @param {string} [className]
 * @returns {HTMLElement}
 */
function make(tag, text = '', className = '') {
  const node = document.createElement(tag);
  node.textContent = text;
  node.className = className;
  return node;
}

/** What the address asks for: `#size=320x180&t=2.5&paused`. */
function readAddress() {
  const words = new URLSearchParams(location.hash.slice(1));
  const size = /^(\d{1,4})x(\d{1,4})$/.exec(words.get('size') ?? '');
  const time = Number(words.get('t') ?? NaN);
  return {
    size: size ? [Number(size[1]), Number(size[2])] : null,
    time: Number.isFinite(time) ? time : null,
    isPaused: words.has('paused'),
  };
}

/** Keeps the canvas as large as it is shown, times the chosen scale. @param {Player} player */
function fitCanvas(player) {
  const { canvas } = player;
  const scale = element('scale', HTMLSelectElement);
  const { size } = readAddress();
  if (size) {
    canvas.style.width = `${size[0]}px`;
    canvas.style.height = `${size[1]}px`;
    player.resize(size[0], size[1]);
    scale.hidden = true;
    return;
  }
  let [width, height] = [canvas.clientWidth * devicePixelRatio, canvas.clientHeight * devicePixelRatio];
  const apply = () => player.resize(width * Number(scale.value), height * Number(scale.value));
  new ResizeObserver(([entry]) => {
    const box = entry.devicePixelContentBoxSize?.[0];
    width = box ? box.inlineSize : Math.round(canvas.offsetWidth * devicePixelRatio);
    height = box ? box.blockSize : Math.round(canvas.offsetHeight * devicePixelRatio);
    apply();
  }).observe(canvas);
  scale.addEventListener('change', apply);
  apply();
}

/** @param {Player} player */
function listenToPointer(player) {
  const { canvas } = player;
  /** @param {PointerEvent} event @returns {[number, number]} */
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * canvas.width;
    const y = canvas.height - ((event.clientY - box.top) / box.height) * canvas.height;
    return [x, y];
  };
  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 && event.pointerType === 'mouse') return;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    player.setMouse(...place(event), true);
    player.poke();
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!player.mouse.isDown) return;
    player.setMouse(...place(event), true);
    player.poke();
  });
  for (const name of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(name, () => {
      player.mouse.release();
      player.poke();
    });
  }
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
}

/** Keys count while the canvas has the focus. @param {Player} player */
function listenToKeys(player) {
  const { canvas } = player;
  /** @param {KeyboardEvent} event @param {boolean} isDown */
  const handle = (event, isDown) => {
    player.setKey(event.keyCode, isDown);
    // Shortcuts of the browser and the way out of the canvas stay.
    const isShortcut = event.ctrlKey || event.metaKey || event.altKey || event.key === 'Tab';
    if (!isShortcut && !/^F\d+$/.test(event.key)) event.preventDefault();
    if (!event.repeat) player.poke();
  };
  canvas.addEventListener('keydown', (event) => handle(event, true));
  canvas.addEventListener('keyup', (event) => handle(event, false));
  canvas.addEventListener('blur', () => player.keyboard.releaseAll());
}

const PLAY = 'M4 2l10 6-10 6z';
const PAUSE = 'M3 2h4v12H3zM9 2h4v12H9z';

/** @param {Player} player */
function showControls(player) {
  const play = element('play', HTMLButtonElement);
  const icon = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  icon.setAttribute('viewBox', '0 0 16 16');
  icon.append(path);
  play.append(icon);
  play.addEventListener('click', () => (player.isPlaying ? player.pause() : player.play()));
  element('restart', HTMLButtonElement).addEventListener('click', () => player.restart());
  const scrub = element('scrub', HTMLInputElement);
  scrub.addEventListener('input', () => player.seek(Number(scrub.value)));
  const sound = element('sound', HTMLButtonElement);
  sound.hidden = !player.hasSound;
  sound.addEventListener('click', () => player.setSound(!player.isSoundOn));
  element('full', HTMLButtonElement).addEventListener('click', () => {
    if (document.fullscreenElement) void document.exitFullscreen();
    else void element('stage', HTMLElement).requestFullscreen();
  });
  const more = element('more', HTMLButtonElement);
  const panel = element('panel', HTMLElement);
  more.addEventListener('click', () => {
    panel.hidden = !panel.hidden;
    more.setAttribute('aria-expanded', String(!panel.hidden));
  });
  player.listeners.push(() => {
    path.setAttribute('d', player.isPlaying ? PAUSE : PLAY);
    sound.setAttribute('aria-pressed', String(player.isSoundOn));
  });
}

/** The bar goes away while nobody moves and the shader plays. @param {Player} player */
function hideBarWhenIdle(player) {
  const stage = element('stage', HTMLElement);
  let timer = 0;
  const wake = () => {
    stage.classList.remove('idle');
    clearTimeout(timer);
    timer = setTimeout(() => {
      const isUsed = element('bar', HTMLElement).matches(':hover, :focus-within');
      const isOpen = !element('panel', HTMLElement).hidden;
      stage.classList.toggle('idle', player.isPlaying && !isUsed && !isOpen);
    }, 2500);
  };
  for (const name of ['pointermove', 'pointerdown', 'focusin']) document.addEventListener(name, wake);
  player.listeners.push(wake);
}

/** Shows time and frame rate as they change. @param {Player} player */
function showClock(player) {
  const time = element('time', HTMLOutputElement);
  const rate = element('rate', HTMLOutputElement);
  const scrub = element('scrub', HTMLInputElement);
  const show = () => {
    const now = player.clock.time;
    time.value = now.toFixed(2);
    rate.value = player.isPlaying ? `${player.clock.rate.toFixed(0)} fps` : '';
    if (now > Number(scrub.max)) scrub.max = String(2 * now);
    if (document.activeElement !== scrub || player.isPlaying) scrub.value = String(now);
    requestAnimationFrame(show);
  };
  show();
}

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

/** @param {Player} player */
function showErrors(player) {
  const box = element('errors', HTMLElement);
  player.listeners.push(() => {
    const { errors, project } = player;
    box.hidden = errors.length === 0;
    const nodes = [make('h2', errors.length === 1 ? '1 error' : `${errors.length} errors`)];
    for (const error of errors) {
      const place = error.line > 0 ? `${error.pass}, line ${error.line}: ` : error.pass ? `${error.pass}: ` : '';
      nodes.push(make('p', place + error.text));
      const file = project.files.find((f) => !f.hidden && f.name === error.pass);
      const line = error.line > 0 ? file?.text.split(/\r\n|\r|\n/)[error.line - 1] : '';
      if (line?.trim()) nodes.push(make('pre', line));
    }
    box.replaceChildren(...nodes);
  });
}

/** Who made the shader; all of it is text. @param {ProjectData} project */
function showCredits(project) {
  document.title = project.title || 'shader';
  element('title', HTMLElement).textContent = project.title;
  element('license', HTMLElement).textContent = project.license;
  element('description', HTMLElement).textContent = project.description;
  const credits = element('credits', HTMLElement);
  if (project.author) credits.append(`by ${project.author}`);
  if (project.link.startsWith('https://')) {
    const link = document.createElement('a');
    link.href = project.link;
    link.rel = 'noopener noreferrer';
    link.textContent = project.link;
    credits.append(project.author ? ', ' : '', link);
  }
}

/** A slider for each number that the author left to be tuned. @param {Player} player */
function showSliders(player) {
  const box = element('sliders', HTMLElement);
  const seen = new Set();
  for (const tunable of player.project.tunables) {
    if (seen.has(tunable.name)) continue;
    seen.add(tunable.name);
    if (seen.size === 1) box.append(make('h2', 'Tunable'));
    const label = make('label', tunable.name);
    const value = document.createElement('output');
    const slider = document.createElement('input');
    slider.type = 'range';
    slider.min = String(Math.min(tunable.min, tunable.value));
    slider.max = String(Math.max(tunable.max, tunable.value));
    slider.step = tunable.integer ? '1' : String((tunable.max - tunable.min) / 200);
    slider.value = String(tunable.value);
    slider.name = tunable.name;
    value.value = slider.value;
    slider.addEventListener('input', () => {
      value.value = slider.value;
      void player.setTunable(tunable.name, Number(slider.value));
    });
    label.append(value, slider);
    if (tunable.label) label.append(make('small', tunable.label));
    box.append(label);
  }
}

/** @param {File} file @returns {Promise<string>} */
function dataAddress(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}

/** @param {Player} player @param {number} pass @param {number} channel @param {File} file */
async function putFile(player, pass, channel, file) {
  const isVolume = player.project.passes[pass].inputs[channel]?.kind === 'volume';
  const url = isVolume ? await dataAddress(file) : URL.createObjectURL(file);
  try {
    await player.setInput(pass, channel, file.name, url);
  } catch {
    player.errors.push({ pass: '', line: -1, text: `${file.name} cannot be read` });
  }
  player.listeners.forEach((listener) => listener());
}

const FILE_KINDS = ['texture', 'cubemap', 'volume', 'video', 'music'];

/** A line for each channel that a file or a device can feed. @param {Player} player */
function showChannels(player) {
  const box = element('channels', HTMLElement);
  player.project.passes.forEach((pass, index) => {
    pass.inputs.forEach((input, channel) => {
      if (!input || (!FILE_KINDS.includes(input.kind) && !['webcam', 'mic'].includes(input.kind))) return;
      if (!box.hasChildNodes()) box.append(make('h2', 'Channels'));
      box.append(channelRow(player, index, channel, input));
    });
  });
  const stage = element('stage', HTMLElement);
  stage.addEventListener('dragover', (event) => event.preventDefault());
  stage.addEventListener('drop', (event) => {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    const image = player.project.passes.findIndex((p) => p.kind === 'image');
    const channel = player.project.passes[image].inputs.findIndex((i) => i && FILE_KINDS.includes(i.kind));
    if (file) void putFile(player, image, Math.max(0, channel), file);
  });
}

/** @param {Player} player @param {number} pass @param {number} channel @param {InputData} input */
function channelRow(player, pass, channel, input) {
  const row = make('div', '', 'channel');
  const text = make('span', `${player.project.passes[pass].name} iChannel${channel}: ${input.name || input.kind}`);
  const button = make('button', FILE_KINDS.includes(input.kind) ? 'file…' : 'allow');
  /** @param {File | undefined} file */
  const put = async (file) => {
    if (!file) return;
    await putFile(player, pass, channel, file);
    text.textContent = `${player.project.passes[pass].name} iChannel${channel}: ${file.name}`;
  };
  const chooser = document.createElement('input');
  chooser.type = 'file';
  chooser.addEventListener('change', () => void put(chooser.files?.[0]));
  button.addEventListener('click', () => {
    if (input.kind === 'webcam') void player.devices.openCamera().catch(() => {});
    else if (input.kind === 'mic') void player.devices.openMicrophone().catch(() => {});
    else chooser.click();
  });
  row.addEventListener('dragover', () => row.classList.add('over'));
  row.addEventListener('dragleave', () => row.classList.remove('over'));
  row.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    row.classList.remove('over');
    void put(event.dataTransfer?.files[0]);
  });
  row.append(text, button);
  return row;
}

/** Opens the player; where that fails, the page says why. @param {ProjectData} project */
function openPlayer(project) {
  try {
    return new Player(element('canvas', HTMLCanvasElement), project);
  } catch (error) {
    const box = element('errors', HTMLElement);
    box.replaceChildren(make('h2', error instanceof Error ? error.message : String(error)));
    box.hidden = false;
    return null;
  }
}

/** Builds the page around the project that it holds. */
function openPage() {
  /** @type {ProjectData} */
  const project = JSON.parse(element('project', HTMLScriptElement).textContent ?? '');
  showCredits(project);
  const player = openPlayer(project);
  if (!player) return;
  showErrors(player);
  showControls(player);
  showCapture(player);
  showSliders(player);
  showChannels(player);
  fitCanvas(player);
  listenToPointer(player);
  listenToKeys(player);
  showClock(player);
  hideBarWhenIdle(player);
  const asked = readAddress();
  const ready = player.ready.then(() => {
    if (asked.time !== null) player.seek(asked.time);
    else if (asked.isPaused) player.poke();
    if (!asked.isPaused) player.play();
  });
  Object.assign(window, { shaderport: publicFace(player, ready) });
}

/** What tests and pages around this one may use. @param {Player} player @param {Promise<void>} ready */
function publicFace(player, ready) {
  return {
    ready,
    /** @param {number} n */
    renderFrame: async (n) => {
      await ready;
      await player.renderFrame(n);
    },
    /** @param {number} t */
    seek: (t) => player.seek(t),
    /** @param {number} x @param {number} y @param {boolean} down */
    setMouse: (x, y, down) => player.setMouse(x, y, down),
    /** @param {number} code @param {boolean} down */
    setKey: (code, down) => player.setKey(code, down),
    get errors() {
      return player.errors.map(({ pass, line, text }) => ({ pass, line, text }));
    },
    player,
  };
}
