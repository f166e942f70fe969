// The panel: next to the image, or a bottom sheet on phones.

const TABS = [
  { id: 'tune', name: 'Controls' },
  { id: 'about', name: 'About' },
  { id: 'code', name: 'Code' },
  { id: 'export', name: 'Export' },
];

/** Called when the panel opens, closes or changes its tab. @type {(() => void)[]} */
const panelListeners = [];
const narrow = matchMedia('(max-width: 700px)');
/** The size set by the user; the width is null until then. @type {{width: number | null, height: number}} */
const panelSize = { width: null, height: 0.5 };

/** @param {string} id */
function isTabOpen(id) {
  return !element('panel', HTMLElement).hidden && !element(id, HTMLElement).hidden;
}

/** Whether this page has a panel. */
function canOpenPanel() {
  const { hasBar, isEmbedded } = readAddress();
  return hasBar && !isEmbedded;
}

/** Lays out the panel. */
function sizePanel() {
  const app = element('app', HTMLElement);
  const panel = element('panel', HTMLElement);
  const [width, height] = [app.clientWidth, app.clientHeight];
  const usual = isTabOpen('code') ? Math.min(Math.max(0.45 * width, 420), 760) : 340;
  // An on-screen keyboard leaves little room for the code.
  const share = height < 520 && document.activeElement instanceof HTMLTextAreaElement ? 0.9 : panelSize.height;
  const sheet = narrow.matches ? share * height : Math.min(panelSize.width ?? usual, width - 160);
  const dock = panel.hidden ? 0 : narrow.matches ? Math.min(sheet, 0.5 * height) : sheet;
  app.style.setProperty('--sheet', `${Math.round(sheet)}px`);
  app.style.setProperty('--dock', `${Math.round(dock)}px`);
  const grip = element('grip', HTMLElement);
  grip.setAttribute('aria-orientation', narrow.matches ? 'horizontal' : 'vertical');
  grip.setAttribute('aria-valuenow', String(Math.round((100 * sheet) / (narrow.matches ? height : width))));
}

/** @param {boolean} isOpen */
function setPanel(isOpen) {
  const panel = element('panel', HTMLElement);
  const more = element('more', HTMLElement);
  if (!isOpen && panel.contains(document.activeElement)) more.focus();
  // In full screen there is only the image.
  if (isOpen && document.fullscreenElement) void document.exitFullscreen();
  panel.hidden = !isOpen;
  more.setAttribute('aria-expanded', String(isOpen));
  sizePanel();
  panelListeners.forEach((listener) => listener());
}

function closePanel() {
  panelSize.height = 0.5;
  setPanel(false);
}

/** @param {string} id */
function openTab(id) {
  for (const tab of TABS) element(tab.id, HTMLElement).hidden = tab.id !== id;
  document.querySelectorAll('#tabs button').forEach((button) => {
    selectTab(button, button.getAttribute('aria-controls') === id);
  });
  if (canOpenPanel()) setPanel(true);
}

/** Makes the edge of the panel draggable, with the keyboard too. @param {HTMLElement} grip */
function makeDraggable(grip) {
  const app = element('app', HTMLElement);
  /** @type {{at: number, size: number, time: number, last: number} | null} */
  let drag = null;
  /** @param {PointerEvent} event */
  const along = (event) => (narrow.matches ? event.clientY : event.clientX);
  const size = () => parseFloat(app.style.getPropertyValue('--sheet'));
  grip.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    grip.setPointerCapture(event.pointerId);
    drag = { at: along(event), size: size(), time: event.timeStamp, last: along(event) };
  });
  grip.addEventListener('pointermove', (event) => {
    if (!drag) return;
    const now = Math.max(0, drag.size + drag.at - along(event));
    // Only the sheet moves; the image is resized when the drag ends.
    app.style.setProperty('--sheet', `${now}px`);
  });
  const end = () => {
    if (!drag) return;
    const now = size();
    const share = now / app.clientHeight;
    drag = null;
    if (narrow.matches && share < 0.3) return closePanel();
    if (narrow.matches) panelSize.height = share > 0.68 ? 0.9 : 0.5;
    else if (now < 200) return closePanel();
    else panelSize.width = Math.max(280, now);
    return sizePanel();
  };
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) grip.addEventListener(name, end);
  grip.addEventListener('dblclick', () => {
    panelSize.width = null;
    sizePanel();
  });
  grip.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    if (narrow.matches) {
      panelSize.height = Math.min(Math.max(panelSize.height + 0.1 * step, 0.2), 0.9);
    } else panelSize.width = Math.max(280, size() + 40 * step);
    sizePanel();
  });
}

/** On phones, moves controls that do not fit into the bar to the panel. */
function placeExtras() {
  const extras = element('extras', HTMLElement);
  if (narrow.matches) element('panel', HTMLElement).querySelector('header')?.append(extras);
  else element('time', HTMLElement).after(extras);
  sizePanel();
}

/** Whether there are controls or channels. */
function hasControls() {
  return element('tune', HTMLElement).querySelector('.control, .channel') !== null;
}

/** Hides empty tabs. */
function showTabs() {
  const [tune] = element('tabs', HTMLElement).children;
  if (tune instanceof HTMLElement) tune.hidden = !hasControls();
}

/** Arrow keys move between tabs; the Tab key stops only at the selected one. @param {HTMLElement} tabs */
function goByArrows(tabs) {
  tabs.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const shown = [...tabs.children].filter((tab) => tab instanceof HTMLElement && !tab.hidden);
    const next = step && shown[(shown.findIndex((tab) => tab === document.activeElement) + step + shown.length) % shown.length];
    if (!(next instanceof HTMLElement)) return;
    event.preventDefault();
    next.focus();
    next.click();
  });
}

/** Marks a tab as selected or not. @param {Element} tab @param {boolean} isSelected */
function selectTab(tab, isSelected) {
  tab.setAttribute('aria-selected', String(isSelected));
  tab.setAttribute('tabindex', isSelected ? '0' : '-1');
}

/** Sets up the tabs, the open and close buttons, and the edge. */
function showPanel() {
  const tabs = element('tabs', HTMLElement);
  for (const { id, name } of TABS) {
    const tab = makeButton(name, () => openTab(id));
    tab.setAttribute('role', 'tab');
    tab.setAttribute('aria-controls', id);
    tabs.append(tab);
  }
  goByArrows(tabs);
  element('more', HTMLElement).addEventListener('click', () => {
    if (!element('panel', HTMLElement).hidden) return closePanel();
    const open = TABS.find(({ id }) => !element(id, HTMLElement).hidden);
    return openTab(open?.id ?? (hasControls() ? 'tune' : 'about'));
  });
  element('close', HTMLElement).addEventListener('click', closePanel);
  element('panel', HTMLElement).addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || event.target instanceof HTMLTextAreaElement) return;
    closePanel();
  });
  makeDraggable(element('grip', HTMLElement));
  narrow.addEventListener('change', placeExtras);
  window.addEventListener('resize', sizePanel);
  placeExtras();
}
