// The service worker of the page: after the first visit, the page works offline.
//
// In: requests of the page and its sub-pages. Out: files of the version that the tab began with; files that are not
// listed come from the network. A new version waits until the user accepts it. Only the page registers the worker,
// never the element in another site. Must not know: the contents of a file.

import { languageOfPack, packOf, pathOf, type BuildManifest } from './list';
import { TAKE_OVER, type StoreLanguage } from './messages';
import {
  assignMissingVersions,
  assignVersion,
  deleteUnusedCaches,
  findFile,
  storeBuild,
  storeLanguage,
  versionOfTab,
} from './stores';

declare const self: ServiceWorkerGlobalScope;
/** Inserted by the build. */
declare const BUILD_MANIFEST: BuildManifest;

const MANIFEST = BUILD_MANIFEST;

// The page tells the reader's language after its first picture, if it is another one.
self.addEventListener('install', (event) => event.waitUntil(storeBuild(MANIFEST, self.navigator.language.slice(0, 2))));

self.addEventListener('activate', (event) => event.waitUntil(activate()));

self.addEventListener('message', (event) => {
  const data = event.data as typeof TAKE_OVER | StoreLanguage;
  if (data === TAKE_OVER) void self.skipWaiting();
  else event.waitUntil(storeLanguage(MANIFEST, data.language).catch(() => undefined));
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  const path = request.method === 'GET' ? pathOf(request.url, self.registration.scope, MANIFEST.files) : undefined;
  if (path === undefined) return;
  event.respondWith(answer(event, path));
});

async function activate(): Promise<void> {
  // From now on, the tab of the first visit is served by this worker, too.
  await self.clients.claim();
  await assignMissingVersions(MANIFEST.version);
  await deleteUnusedCaches(MANIFEST.version);
}

async function answer(event: FetchEvent, path: string): Promise<Response> {
  const { request, clientId, resultingClientId } = event;
  const isNavigation = request.mode === 'navigate';
  if (isNavigation && resultingClientId !== '') {
    await assignVersion(resultingClientId, MANIFEST.version);
    event.waitUntil(deleteUnusedCaches(MANIFEST.version));
  }
  const version =
    isNavigation || clientId === '' ? MANIFEST.version : ((await versionOfTab(clientId)) ?? MANIFEST.version);
  const found = await findFile(path, version);
  if (found !== undefined) return found;
  // The first page in another language. A browser that is low on storage may also have deleted files.
  const language = languageOfPack(packOf(path) ?? '');
  if (language !== undefined) event.waitUntil(storeLanguage(MANIFEST, language).catch(() => undefined));
  return fetch(request);
}
