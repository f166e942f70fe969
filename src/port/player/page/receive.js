// The page inside another one, which sends the project, asks for the state, and pauses the image to look at it.

/** Opens the project that the page around this one sends. */
function receiveProject() {
  const outside = window.parent;
  /** @type {Player | null} */
  let player = null;
  const send = (/** @type {object} */ message) => outside.postMessage(message, '*');
  window.addEventListener('message', ({ data, source }) => {
    if (source !== outside || outside === window) return;
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
