// Keeps the files of the playground. The build writes `VERSION`, and `FILES` with their addresses, before this.
/* global VERSION, FILES */

const PREFIX = 'shaderlint-playground-';
const CACHE = PREFIX + VERSION;

/** Whether the name of a file changes with its content. */
const isHashed = ({ pathname }) => /\/assets\/[^/]+-[\w-]{8}\.\w+$/.test(pathname);

/** Whether an address is that of a file of the playground. */
const isOwn = (url) => url.href.startsWith(self.registration.scope);

async function keep(request, response) {
  if (response.ok) await (await caches.open(CACHE)).put(request, response.clone());
  return response;
}

/** The newest file, or the last one that was seen. */
async function fromNetwork(request) {
  try {
    // The address instead of the request: the cache of the browser may have an old page for it.
    return await keep(request, await fetch(request.url, { cache: 'no-cache' }));
  } catch (error) {
    const kept = await caches.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }
}

const fromCache = async (request) => await caches.match(request) ?? keep(request, await fetch(request));

self.addEventListener('install', (event) => {
  const requests = FILES.map((file) => {
    const url = new URL(file, self.registration.scope);
    return new Request(url, { cache: isHashed(url) ? 'default' : 'no-cache' });
  });
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)));
});

// A new version waits until no page of the old one is open: that may still load old files.
self.addEventListener('activate', (event) => {
  const clean = async () => {
    const names = await caches.keys();
    const old = names.filter((name) => name.startsWith(PREFIX) && name !== CACHE);
    await Promise.all(old.map((name) => caches.delete(name)));
    await self.clients.claim();
  };
  event.waitUntil(clean());
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || !isOwn(url)) return;
  event.respondWith(isHashed(url) ? fromCache(request) : fromNetwork(request));
});
