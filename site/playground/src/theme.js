// Light or dark, as chosen here or on the pages of the documentation.

/** Where VitePress keeps the choice. A script in the head of the page applies it before this module is loaded. */
const KEY = 'vitepress-theme-appearance';

const THEMES = { auto: 'Auto', light: 'Light', dark: 'Dark' };

/** The theme that somebody chose. */
function chosen() {
  try {
    const name = localStorage.getItem(KEY);
    return name in THEMES ? name : 'auto';
  } catch {
    // The browser may not let pages keep anything.
    return 'auto';
  }
}

/** The theme of the page: `auto` is that of the system. */
export const theme = () => document.documentElement.dataset.theme ?? 'auto';

/** Applies a theme, and tells the image by the event `theme`. @param {string} name */
function apply(name) {
  if (name === 'auto') delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = name;
  document.dispatchEvent(new Event('theme'));
}

/** Offers the themes in a list. @param {HTMLSelectElement} select */
export function offerThemes(select) {
  for (const [name, label] of Object.entries(THEMES)) select.append(new Option(label, name));
  const follow = () => {
    select.value = chosen();
    apply(select.value);
  };
  follow();
  // Another page of the site.
  addEventListener('storage', ({ key }) => {
    if (key === KEY || key === null) follow();
  });
  select.addEventListener('change', () => {
    apply(select.value);
    try {
      localStorage.setItem(KEY, select.value);
    } catch {
      // The choice holds until the page is closed.
    }
  });
}
