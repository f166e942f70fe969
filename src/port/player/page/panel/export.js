// Export: images, videos, the URL, shaders, a module.

/** @param {Player} player */
function savePicture(player) {
  player.canvas.toBlob((blob) => blob && save(blob, fileName(player, 'png')));
}

/** A labelled control of a form. @param {string} words @param {HTMLElement} control */
function field(words, control) {
  const label = make('label', '', 'field');
  label.append(make('span', words), control);
  return label;
}

/** @param {[string, string][]} options value and label */
function choice(options) {
  const select = document.createElement('select');
  for (const [value, words] of options) select.add(new Option(words, value));
  return select;
}

/** @param {boolean} isOn */
function checkBox(isOn) {
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = isOn;
  return box;
}

/** The form for recording a video; its button starts or stops the recording. @param {Player} player @param {HTMLElement} parent */
function showFilm(player, parent) {
  const seconds = document.createElement('input');
  Object.assign(seconds, { type: 'number', min: '0.1', max: '600', step: 'any', value: '10', name: 'seconds' });
  const rate = choice([['24', '24'], ['25', '25'], ['30', '30'], ['50', '50'], ['60', '60']]);
  rate.value = '60';
  rate.name = 'rate';
  const size = choice([['', 'Current size'], ['1280x720', '1280 × 720'], ['1920x1080', '1920 × 1080'], ['1080x1080', '1080 × 1080'], ['1080x1920', '1080 × 1920'], ['3840x2160', '3840 × 2160']]);
  size.name = 'size';
  const sound = checkBox(true);
  const start = checkBox(false);
  sound.name = 'with sound';
  start.name = 'from start';
  const progress = document.createElement('progress');
  progress.hidden = true;
  progress.setAttribute('aria-label', 'Recording progress');
  /** @type {FilmRun | null} */
  let run = null;
  const barButton = element('record', HTMLButtonElement);
  const go = makeButton('Record', () => void toggle());
  go.className = 'main';
  const soundField = field('With sound', sound);
  const toggle = async () => {
    if (run) {
      run.isStopped = true;
      return;
    }
    const [width, height] = size.value.split('x').map(Number);
    /** @type {FilmOrder} */
    const order = {
      seconds: Math.min(Math.max(Number(seconds.value) || 10, 0.1), 600),
      rate: Number(rate.value),
      size: size.value ? [width, height] : null,
      hasSound: sound.checked && player.hasSound,
      isFromStart: start.checked,
    };
    const name = fileName(player, 'webm');
    run = {
      isStopped: false,
      tell: (share) => {
        progress.value = share;
        barButton.title = `Stop recording (${Math.round(100 * share)}% done)`;
      },
    };
    show();
    try {
      const made = await film(player, order, run);
      save(made, made.type.includes('mp4') ? name.replace(/webm$/, 'mp4') : name);
    } catch (error) {
      flash(`Cannot record the video: ${error instanceof Error ? error.message : error}`);
    }
    run = null;
    show();
  };
  const show = () => {
    barButton.setAttribute('aria-pressed', String(run !== null));
    barButton.title = run ? 'Stop recording' : 'Record a video';
    go.textContent = run ? 'Stop' : 'Record';
    progress.hidden = run === null;
    soundField.hidden = !player.hasSound;
  };
  barButton.addEventListener('click', () => void toggle());
  barButton.hidden = typeof VideoEncoder === 'undefined' && typeof MediaRecorder === 'undefined';
  parent.append(make('h2', 'Video'), field('Seconds', seconds), field('Frames per second', rate), field('Size', size), soundField, field('From the start', start), go, progress);
  player.listeners.push(show);
  show();
}

/** This page as a module, with the current code. @param {Player} player */
function moduleText(player) {
  const own = document.scripts[document.scripts.length - 1].textContent ?? '';
  const [, behind = ''] = own.split("'use strict';\n");
  const [code] = behind.split('// The page begins here.\n');
  const credits = document.querySelector('meta[name=description]')?.getAttribute('content') ?? '';
  const head = credits.split('\n').filter(Boolean).map((line) => `// ${line}\n`).join('');
  const mount = element('mount', HTMLScriptElement).textContent ?? '';
  const { controls, findings, ...project } = player.project;
  const data = JSON.stringify(controls ? { ...project, controls } : project);
  return `${head}\n/** @type {ProjectData} */\nconst PROJECT = ${data};\n\n${code}${mount}`;
}

/** A frame that shows this page. @param {Player} player */
function embedCode(player) {
  const { clientWidth, clientHeight } = player.canvas;
  const frame = document.createElement('iframe');
  const address = `${location.href.replace(/#.*$/, '')}#${fragmentWith({ ...pendingWords, embed: '' })}`;
  const attributes = { src: address, title: player.project.title || 'Shader', width: clientWidth, height: clientHeight, loading: 'lazy', allow: 'autoplay; fullscreen', style: 'border: 0' };
  for (const [name, value] of Object.entries(attributes)) frame.setAttribute(name, String(value));
  return frame.outerHTML;
}

/** @param {Player} player */
function showExport(player) {
  const box = element('export', HTMLElement);
  /** @param {string} what @param {() => string} text */
  const copier = (what, text) => makeButton(what, () => void copy(text()).then(() => flash(`${what} copied`)));
  const { passes } = player.project;
  const pass = choice(passes.map((p, i) => [String(i), p.name || p.kind]));
  pass.setAttribute('aria-label', 'Pass');
  pass.hidden = passes.length < 2;
  const row = make('div', '', 'row');
  row.append(copier('Link', () => addressOfNow(player)), copier('GLSL', () => passSource(player.project, passes[Number(pass.value)])), pass, ...(document.querySelector('#mount') ? [copier('Module', () => moduleText(player))] : []), copier('Embed code', () => embedCode(player)));
  const picture = makeButton('Save', () => savePicture(player));
  box.append(make('h2', 'Copy'), row, make('h2', 'Image'), picture);
  element('shot', HTMLButtonElement).addEventListener('click', () => savePicture(player));
  showFilm(player, box);
}
