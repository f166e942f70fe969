// Observes what goes wrong in a page.
import { listen } from '../browser/browser.js';

/** Whether a request was given up because another frame replaced the one that made it. */
const isReplaced = (request) =>
  new URL(request.url()).pathname.endsWith('/player.html') && request.failure()?.errorText === 'net::ERR_ABORTED';

/**
 * Messages of the console, and requests that fail or leave the given addresses, fail the test.
 * @param {string[]} addresses
 */
export function watch(page, ...addresses) {
  const add = listen(page);
  page.on('request', (request) => {
    const isOwn = [...addresses, 'data:'].some((start) => request.url().startsWith(start));
    if (!isOwn) add(`request: ${request.url()}`);
  });
  page.on('requestfailed', (request) => {
    if (!isReplaced(request)) add(`failed: ${request.url()}: ${request.failure()?.errorText}`);
  });
  return add;
}

/** Closes a window; the requests that it gives up are not wrong. */
export async function close(context) {
  for (const page of context.pages()) page.removeAllListeners('requestfailed');
  await context.close();
}
