// The page for a frame of another page: an image until the shader plays, and a bar without a panel.

/** Errors of shaders over the image. @param {Player} player */
function showPlainErrors(player) {
  const box = element('errors', HTMLElement);
  player.listeners.push(() => {
    const lines = player.errors.map(({ pass, line, text }) => make('p', line > 0 ? `${pass}, line ${line}: ${text}` : text));
    box.replaceChildren(...lines);
    box.hidden = lines.length === 0;
  });
}

/** Sizes the canvas. @param {Player} player */
function fitFrame(player) {
  const { size, scale } = readAddress();
  if (size) player.resize(size[0], size[1]);
  else fitToElement(player, () => scale ?? 1);
}

/** Opens the player. Its image replaces the still one as soon as there is a frame. @param {boolean} isAsked whether the user has clicked */
function openFrame(isAsked) {
  /** @type {ProjectData} */
  const project = JSON.parse(element('project', HTMLScriptElement).textContent ?? '');
  const button = element('begin', HTMLButtonElement);
  const player = openPlayer(project);
  button.disabled = player !== null;
  button.hidden = !isAsked || !player;
  if (!player) return null;
  document.body.classList.toggle('bare', !readAddress().hasBar);
  showPlainErrors(player);
  fitFrame(player);
  attach(player);
  player.context.poster = document.querySelector('img')?.src ?? '';
  const removePoster = () => player.context.drawn.then(() => requestAnimationFrame(() => document.querySelector('#poster')?.remove()));
  const ready = player.ready.then(() => {
    button.disabled = false;
    pageParts.takeValues?.(player);
    begin(player);
    tellKeys(player);
    if (!isAsked && !player.isPlaying) return;
    button.hidden = true;
    if (isAsked) player.play();
    void removePoster();
  });
  player.ready.catch((error) => {
    button.hidden = true;
    showFailure(error);
  });
  player.listeners.push(() => {
    if (player.isPlaying) void removePoster();
  });
  playWhenSeen(player);
  Object.assign(window, { shaderport: publicFace(player, ready) });
  return player;
}

/** Opens the player when the button or the image is clicked, or at once if the URL asks for it. */
function openOnClick() {
  const button = element('begin', HTMLButtonElement);
  const poster = element('poster', HTMLElement);
  const canvas = element('canvas', HTMLCanvasElement);
  button.hidden = false;
  canvas.hidden = true;
  button.setAttribute('aria-label', `Play ${document.title}`);
  const open = () => {
    button.removeEventListener('click', open);
    poster.removeEventListener('click', open);
    canvas.hidden = false;
    canvas.focus();
    openFrame(true);
  };
  button.addEventListener('click', open);
  poster.addEventListener('click', open);
  const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (readAddress().isOpened && !isCalm) open();
}

/** Opens the player, unless the page lets it wait for a click. */
function startFrame() {
  if (element('poster', HTMLElement).dataset.click === undefined) openFrame(false);
  else openOnClick();
}
