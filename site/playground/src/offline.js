// Keeps the playground in the browser, so that it opens without a network.

/** Starts the service worker, where there can be one: not in files, and not in every window. */
export function workOffline() {
  if (!/^https?:$/.test(location.protocol) || !navigator.serviceWorker) return;
  // A browser may refuse to store anything.
  navigator.serviceWorker.register(new URL('service-worker.js', document.baseURI)).catch(() => {});
}
