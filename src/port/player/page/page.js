// The page with its panel.

/** Builds the page for the project in it. Returns its player, or null. */
function openPage() {
  /** @type {ProjectData} */
  const project = JSON.parse(element('project', HTMLScriptElement).textContent ?? '');
  const { hasBar, isEmbedded } = readAddress();
  document.body.classList.toggle('bare', !hasBar);
  document.body.classList.toggle('framed', isEmbedded);
  showAbout(project);
  const player = openPlayer(project);
  if (!player) return null;
  checkedTexts.push(...project.files.map((f) => f.text));
  showPanel();
  showErrors(player);
  pageParts.showSliders?.(player);
  showCode(player);
  showExport(player);
  pageParts.showDebug?.(player);
  fitCanvas(player);
  attach(player);
  listenToHelp(player);
  showRate(player);
  const ready = player.ready.then(() => {
    pageParts.showChannels?.(player);
    begin(player);
    tellKeys(player);
    watchSpeed(player);
  });
  player.ready.catch(showFailure);
  playWhenSeen(player);
  Object.assign(window, { shaderport: publicFace(player, ready) });
  return player;
}
