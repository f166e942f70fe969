// The page for a frame of another page: it shows a still image, and opens the player after a click.

/** Opens the player when the button or the image is clicked, or at once if the address asks for it. */
function openOnClick() {
  const button = element('begin', HTMLButtonElement);
  const canvas = element('canvas', HTMLCanvasElement);
  const poster = element('poster', HTMLElement);
  canvas.hidden = true;
  button.hidden = false;
  button.setAttribute('aria-label', `Play ${document.title}`);
  const open = () => {
    button.removeEventListener('click', open);
    poster.removeEventListener('click', open);
    button.disabled = true;
    canvas.hidden = false;
    canvas.focus();
    const player = openPage();
    if (!player) {
      button.hidden = true;
      return;
    }
    // The page's own actions for this moment come first; the click counts more than a paused address.
    void player.ready.then(() => {
      button.disabled = false;
      button.hidden = true;
      player.play();
      requestAnimationFrame(() => poster.remove());
    });
  };
  button.addEventListener('click', open);
  poster.addEventListener('click', open);
  // A link of a gallery is a click too.
  const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (readAddress().isOpened && !isCalm) open();
}
