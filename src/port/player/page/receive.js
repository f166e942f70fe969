// The page inside another one, which sends the project, asks for the state, and pauses the image to look at it.

/** Shows the page in a theme, whatever the system has. @param {string} theme `light`, `dark`, or `auto` for that of the system */
function setTheme(theme) {
  const isAuto = theme === 'auto';
  document.documentElement.style.colorScheme = isAuto ? '' : theme;
  for (const sheet of document.styleSheets) {
    for (const rule of sheet.cssRules) {
      if (!(rule instanceof CSSMediaRule)) continue;
      if (rule.media.mediaText.includes('prefers-color-scheme')) darkRules.add(rule);
      if (darkRules.has(rule)) rule.media.mediaText = isAuto ? '(prefers-color-scheme: dark)' : theme === 'dark' ? 'all' : 'not all';
    }
  }
}

/** The rules for dark systems. @type {Set<CSSMediaRule>} */
const darkRules = new Set();

/** Opens the project that the page around this one sends. */
function receiveProject() {
  const outside = window.parent;
  /** @type {Player | null} */
  let player = null;
  const send = (/** @type {object} */ message) => outside.postMessage(message, '*');
  window.addEventListener('message', ({ data, source }) => {
    if (source !== outside || outside === window) return;
    if (data.theme) setTheme(data.theme);
    // A page without an address of its own gets the settings that are in its fragment otherwise.
    if (data.settings && !player) location.hash = data.settings;
    if (data.project && !player) {
      element('project', HTMLScriptElement).textContent = data.project;
      player = openPage();
      if (!player) return;
      const opened = player;
      void opened.ready.then(() => {
        if (data.state) takeState(opened, data.state);
        send({ drawn: true });
      });
    }
    if (player && data.isPaused === true) player.pause();
    if (player && data.isPaused === false) player.play();
    if (data.isWanted && player) send({ state: stateOf(player) });
  });
  send({ isReady: true });
}
