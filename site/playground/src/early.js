// Runs before the page is shown: the theme that somebody chose. See theme.js.
try {
  const theme = localStorage.getItem('vitepress-theme-appearance');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // The browser may not let pages keep anything.
}
