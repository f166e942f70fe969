// Pages served by `shaderport --serve`: they reload on each change and restore their state.

/** The storage key of the state during a reload. */
const KEPT = 'shaderport.kept';

/**
 * @param {string} version of this page
 * @param {Player | null} player
 */
function followChanges(version, player) {
  if (player) void player.ready.then(() => restoreKept(player));
  /** @type {EventSource | null} */
  let news = null;
  // Browsers limit the connections per host, so hidden pages close theirs.
  const follow = () => {
    news?.close();
    news = document.hidden ? null : new EventSource('events');
    news?.addEventListener('message', ({ data }) => {
      if (data === version) return;
      if (player) keep(player);
      location.reload();
    });
    news?.addEventListener('trouble', ({ data }) => {
      if (!player) return;
      if (data) notify('trouble', data);
      else retract('trouble');
    });
  };
  document.addEventListener('visibilitychange', follow);
  follow();
}

/** @param {Player} player */
function keep(player) {
  writeAddress();
  sessionStorage.setItem(KEPT, JSON.stringify(stateOf(player)));
}

/** @param {Player} player */
function restoreKept(player) {
  const kept = sessionStorage.getItem(KEPT);
  sessionStorage.removeItem(KEPT);
  if (kept) takeState(player, JSON.parse(kept));
}
