// Collects what goes wrong in a page.
import { listen } from '../browser/browser.js';

/** Whether a request was given up because another frame replaced the one that made it. */
const isReplaced = (request) =>
  new URL(request.url()).pathname.endsWith('/player.html') && request.failure()?.errorText === 'net::ERR_ABORTED';

/**
 * Messages of the console, and requests that fail or leave the given addresses.
 * @param {string[]} addresses
 */
export function watch(page, ...addresses) {
  const complaints = listen(page);
  page.on('request', (request) => {
    const isOwn = [...addresses, 'data:'].some((start) => request.url().startsWith(start));
    if (!isOwn) complaints.push(`request: ${request.url()}`);
  });
  page.on('requestfailed', (request) => {
    if (!isReplaced(request)) complaints.push(`failed: ${request.url()}: ${request.failure()?.errorText}`);
  });
  return complaints;
}
