// The page inside another one, which sends the project, and asks for the state before it shows another.

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
    if (data.isWanted && player) send({ state: stateOf(player) });
  });
  send({ isReady: true });
}
