// The service worker of the page: after the first visit, the page works offline.
//
// In: requests of the page and its sub-pages. Out: files of the version that the tab began with; files that are not
// listed come from the network. A new version waits until the user accepts it. Only the page registers the worker,
// never the element in another site. Must not know: the contents of a file.

import { pathOf, type Listed } from './list';
import { TAKE_OVER } from './take-over';
import { adopt, begin, begunWith, fill, find, tidy } from './stores';

declare const self: ServiceWorkerGlobalScope;
/** Inserted by the build. */
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
  // From now on, the tab of the first visit is served by this worker, too.
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
  // A browser that is low on storage may have deleted files.
  return (await find(path, version)) ?? fetch(request);
}
