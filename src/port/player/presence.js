// Players run only while their canvas can be seen, and share the few contexts that a browser has. The players of
// a page know each other, and tell those in other frames of the same page what they take and leave.

/** Contexts that all players hold together at most: browsers keep 16, and some are on their way. */
const MAX_CONTEXTS = 10;
/** How many others take a context after a player that is not seen before it leaves its own. */
const MAX_UNSEEN = 4;
/** Milliseconds in which others may answer and leave before a context is opened. */
const COURTESY = 60;
/** How many times as long it waits for others that have to leave and are busy. */
const PATIENCE = 60;
/** How many times as long the first one waits until all frames have answered; those without a player never do. */
const GREETING = 10;

/**
 * The place of a player among all that hold contexts.
 * @typedef {object} Seat
 * @property {string} id
 * @property {number} since when it took its context, on the clock of all frames
 * @property {boolean} isSeen
 * @property {boolean} isHeld
 * @property {() => void} open
 * @property {() => void} rest
 */

/**
 * What the players of this page know: the holders of contexts with the time at which they took them, those of them
 * that are not seen, and the frames that they have heard.
 * @typedef {{seats: Set<Seat>, holders: Map<string, number>, hidden: Set<string>, frames: Set<MessageEventSource | null>, isKnown: boolean}} Hall
 */

/** @typedef {'take' | 'hold' | 'leave' | 'hide' | 'here'} SeatNews */

/** The hall of this page, which all modules in it share. @returns {Hall} */
function hallOfPage() {
  const key = Symbol.for('shaderport.hall');
  const page = /** @type {{[key]?: Hall}} */ (/** @type {unknown} */ (window));
  const known = page[key];
  if (known) return known;
  /** @type {Hall} */
  const hall = { seats: new Set(), holders: new Map(), hidden: new Set(), frames: new Set(), isKnown: false };
  page[key] = hall;
  window.addEventListener('message', ({ data, source }) => {
    const [news, id, since] = data?.shaderport ?? [];
    if (source === window || typeof id !== 'string') return;
    hall.frames.add(source);
    if (news === 'take') introduce(hall, /** @type {Window} */ (source));
    hear(hall, news, { id, since: Number(since) || 0 });
  });
  return hall;
}

/** Tells the players of this page, and those in other frames of the page around it. @param {Hall} hall @param {SeatNews} news @param {Seat} seat */
function say(hall, news, seat) {
  hear(hall, news, seat);
  const { parent } = window;
  if (parent === window) return;
  for (let i = 0; i < parent.length; i++) {
    if (parent[i] !== window) parent[i].postMessage({ shaderport: [news, seat.id, seat.since] }, '*');
  }
}

/** Tells a frame, which may be new, who holds a context here. @param {Hall} hall @param {Window} frame */
function introduce({ seats }, frame) {
  for (const { isHeld, isSeen, id, since } of seats) {
    frame.postMessage({ shaderport: [isHeld ? 'hold' : 'here', id, since] }, '*');
    if (isHeld && !isSeen) frame.postMessage({ shaderport: ['hide', id] }, '*');
  }
}

/** @param {Hall} hall @param {SeatNews} news @param {{id: string, since: number}} seat */
function hear(hall, news, { id, since }) {
  const { seats, holders, hidden } = hall;
  if (news === 'hide' && holders.has(id)) hidden.add(id);
  else hidden.delete(id);
  if (news === 'leave') holders.delete(id);
  if (news === 'take' || news === 'hold') holders.set(id, since);
  for (const seat of seats) if (mustLeave(hall, seat)) leave(hall, seat);
  if (news !== 'leave' && news !== 'hide') return;
  for (const seat of seats) {
    // At different times, so that not all of them take the same place.
    const isFree = () => seat.isSeen && hall.holders.size - hidden.size < MAX_CONTEXTS;
    if (seat.isSeen && !seat.isHeld) setTimeout(() => isFree() && take(hall, seat), 300 * Math.random());
  }
}

/** Whether too many took a context after this one. @param {Hall} hall @param {Seat} seat */
function mustLeave({ holders }, seat) {
  if (!seat.isHeld) return false;
  // All frames must find the same order, however late the news are.
  const newer = [...holders].filter(([id, since]) => since > seat.since || (since === seat.since && id > seat.id)).length;
  return newer >= (seat.isSeen ? MAX_CONTEXTS : MAX_UNSEEN) || (!seat.isSeen && holders.size > MAX_CONTEXTS);
}

/** @param {Hall} hall @param {Seat} seat */
function take(hall, seat) {
  if (seat.isHeld || !hall.seats.has(seat)) return;
  seat.isHeld = true;
  seat.since = performance.timeOrigin + performance.now();
  say(hall, 'take', seat);
  if (window.parent === window) setTimeout(() => seat.isHeld && seat.open());
  else setTimeout(() => openInTurn(hall, seat, PATIENCE), COURTESY);
}

/** Opens a context when others have left enough of them. @param {Hall} hall @param {Seat} seat @param {number} patience */
function openInTurn(hall, seat, patience) {
  if (!seat.isHeld) return;
  const isFull = hall.holders.size > MAX_CONTEXTS;
  const greets = !hall.isKnown && hall.frames.size < window.parent.length - 1 && patience > PATIENCE - GREETING;
  if (greets || (isFull && patience > 0)) {
    setTimeout(() => openInTurn(hall, seat, patience - 1), COURTESY);
    return;
  }
  hall.isKnown = true;
  // Those that do not answer are gone.
  if (isFull) {
    hall.holders = new Map([...hall.seats].filter((s) => s.isHeld).map((s) => [s.id, s.since]));
    hall.hidden.clear();
  }
  seat.open();
}

/** @param {Hall} hall @param {Seat} seat */
function leave(hall, seat) {
  if (!seat.isHeld) return;
  seat.isHeld = false;
  seat.rest();
  say(hall, 'leave', seat);
}

/**
 * Opens a player when its canvas is seen for the first time, and lets it run while it is seen. A canvas outside
 * of the document counts as seen, since it is shown in another way.
 * @param {Player} player @param {AbortSignal} [signal] ends this
 */
function playWhenSeen(player, signal) {
  const { canvas } = player;
  const hall = hallOfPage();
  /** @type {Seat} */
  const seat = {
    id: `${Math.random()}`,
    since: 0,
    isSeen: false,
    isHeld: false,
    open: () => void player.open(),
    rest: () => player.rest(),
  };
  hall.seats.add(seat);
  player.listeners.push(() => {
    if (player.context.isEvicted) leave(hall, seat);
  });
  player.context.isAtRisk = window.parent !== window;
  player.isSeen = false;
  const observer = new IntersectionObserver((entries) => {
    seat.isSeen = !canvas.isConnected || entries[entries.length - 1].isIntersecting;
    player.setSeen(seat.isSeen);
    if (!seat.isSeen) say(hall, 'hide', seat);
    else if (seat.isHeld) say(hall, 'hold', seat);
    else take(hall, seat);
  });
  observer.observe(canvas);
  canvas.addEventListener('pointerdown', () => take(hall, seat), { signal });
  const end = () => {
    observer.disconnect();
    hall.seats.delete(seat);
    seat.isHeld = false;
    say(hall, 'leave', seat);
  };
  signal?.addEventListener('abort', end);
  window.addEventListener('pagehide', (event) => event.persisted || end(), { signal });
}
