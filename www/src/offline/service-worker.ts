// The service worker of the page: after the first visit all of it is there without a network.
//
// In: requests of the page and of the pages that belong to it. Out: files of the version that a tab has begun with; what is not
// listed is left to the network. A new version waits until the page says that the reader wants it. Only the page registers it,
// never the element in somebody else's. Must not know: what is in a file.

import { pathOf, type Listed } from './list';
import { TAKE_OVER } from './take-over';
import { adopt, begin, begunWith, fill, find, tidy } from './stores';

declare const self: ServiceWorkerGlobalScope;
/** Put in by the build. */
declare const LISTED_BY_THE_BUILD: Listed;

const LISTED = LISTED_BY_THE_BUILD;

self.addEventListener('install', (event) => event.waitUntil(fill(LISTED)));

self.addEventListener('activate', (event) => event.waitUntil(activate()));

self.addEventListener('message', ({ data }) => {
  if (data === TAKE_OVER) void self.skipWaiting();
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const path = request.method === 'GET' ? pathOf(request.url, self.registration.scope, LISTED.files) : undefined;
  if (path === undefined) return;
  event.respondWith(answer(event, path));
});

async function activate(): Promise<void> {
  // The tab of the first visit has its parts from here on, too.
  await self.clients.claim();
  await adopt(LISTED.version);
  await tidy(LISTED.version);
}

async function answer(event: FetchEvent, path: string): Promise<Response> {
  const { request, clientId, resultingClientId } = event;
  const opens = request.mode === 'navigate';
  if (opens && resultingClientId !== '') {
    await begin(resultingClientId, LISTED.version);
    event.waitUntil(tidy(LISTED.version));
  }
  const version = opens || clientId === '' ? LISTED.version : ((await begunWith(clientId)) ?? LISTED.version);
  // A browser that is short of room throws things away.
  return (await find(path, version)) ?? fetch(request);
}
