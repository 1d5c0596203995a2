// The caches of the service worker: one for each version of the page, and one with the version of each tab.
//
// In: the list of a build, the network. Out: complete caches of exactly the listed files. Responses of a server during
// an update, or of a network with a login page, are rejected. A cache is deleted once no tab needs it. Must not know:
// who requests a file.

import { languageOfPack, packOf, typeOf, type BuildManifest } from './list';

declare const self: ServiceWorkerGlobalScope;

/** Other playgrounds may exist in other folders of the same origin. */
const CACHE_PREFIX = `gcode-playground ${new URL(self.registration.scope).pathname} `;
const TABS_CACHE = `${CACHE_PREFIX}tabs`;
/** The list of files in a cache, stored once all of them are stored. */
const FILE_LIST = 'offline-files.json';
/** Parallel requests, few, so that the page's own requests come first. */
const MAX_PARALLEL_REQUESTS = 4;
/** For this time, ms, a tab that is being opened may be missing from the browser's list of clients. */
const TAB_OPENING_MS = 60_000;

type Files = BuildManifest['files'];
type Pack = Readonly<Record<string, string>>;

interface Tab {
  readonly version: string;
  readonly since: number;
}

const address = (path: string): string => new URL(path, self.registration.scope).href;
const openCache = (version: string): Promise<Cache> => caches.open(CACHE_PREFIX + version);

/** The stored versions, the newest last. */
async function storedVersions(): Promise<string[]> {
  return (await caches.keys())
    .filter((name) => name.startsWith(CACHE_PREFIX) && name !== TABS_CACHE)
    .map((name) => name.slice(CACHE_PREFIX.length));
}

/**
 * Stores a build: the files that every reader needs, the pages in a language, and those in languages that are stored
 * already. Unchanged files are copied from earlier versions, not fetched again.
 */
export async function storeBuild({ version, files, entry }: BuildManifest, language: string): Promise<void> {
  const cache = await openCache(version);
  const storedAddresses = new Set((await cache.keys()).map(({ url }) => url));
  const earlier = await Promise.all(
    (await storedVersions())
      .filter((other) => other !== version)
      .map(async (other) => ({ store: await openCache(other), files: await filesOf(other) })),
  );
  const packsBefore = await Promise.all(earlier.map(({ store }) => store.keys()));
  const before = new Set(packsBefore.flat().map(({ url }) => url));
  const isWanted = (path: string): boolean =>
    [undefined, language].includes(languageOfPack(path)) || before.has(address(path));
  const missing = Object.entries(files).filter(([path]) => isWanted(path) && !storedAddresses.has(address(path)));
  const copy = async (path: string, hash: string): Promise<Response | undefined> => {
    const other = earlier.find(({ files }) => files[path] === hash);
    return other?.store.match(address(path));
  };
  const storeNext = async (): Promise<void> => {
    for (let file = missing.shift(); file !== undefined; file = missing.shift()) {
      const [path, hash] = file;
      await cache.put(address(path), (await copy(path, hash)) ?? (await fetchListed(path, hash, entry)));
    }
  };
  await Promise.all(Array.from({ length: MAX_PARALLEL_REQUESTS }, storeNext));
  await cache.put(address(FILE_LIST), new Response(JSON.stringify(files)));
}

/** Stores the packs of a language, if they are not stored yet. */
export async function storeLanguage({ version, files, entry }: BuildManifest, language: string): Promise<void> {
  const cache = await openCache(version);
  for (const [path, hash] of Object.entries(files)) {
    if (languageOfPack(path) !== language || (await cache.match(address(path))) !== undefined) continue;
    await cache.put(address(path), await fetchListed(path, hash, entry));
    packs.delete(keyOf(path, version));
  }
}

async function filesOf(version: string): Promise<Files> {
  const list = await (await openCache(version)).match(address(FILE_LIST));
  return list === undefined ? {} : ((await list.json()) as Files);
}

/** Fetches a file and verifies that it is the listed one. */
async function fetchListed(path: string, hash: string, entry: string): Promise<Response> {
  const response = await fetch(address(path), { cache: 'no-cache', credentials: 'same-origin' });
  const bytes = await response.arrayBuffer();
  // Some servers insert a line into a page: accept it if it names the right script.
  const isListed =
    response.ok &&
    ((await hashOf(bytes)).startsWith(hash) ||
      (path === 'index.html' && new TextDecoder().decode(bytes).includes(entry)));
  if (!isListed) throw new Error(`${path} is not what was listed (${response.status})`);
  // A new response, because a redirected one cannot answer a navigation.
  return new Response(bytes, { headers: headers(response, path) });
}

/** The server's headers, including its policies, without those about the transfer. */
function headers(response: Response, path: string): Headers {
  const all = new Headers(response.headers);
  for (const name of ['content-encoding', 'content-length']) all.delete(name);
  all.set('content-type', typeOf(path));
  return all;
}

async function hashOf(bytes: ArrayBuffer): Promise<string> {
  return Array.from(new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)), (byte) =>
    byte.toString(16).padStart(2, '0'),
  ).join('');
}

// ---- finding --------------------------------------------------------------------------------------

/** Packs that were read, by version and name. */
const packs = new Map<string, Promise<{ readonly pack: Pack; readonly response: Response } | undefined>>();

/**
 * A file of a version. A script that this version lacks comes from any other: its name contains the hash of its
 * content.
 */
export async function findFile(path: string, version: string): Promise<Response | undefined> {
  const own = await findIn(path, version);
  if (own !== undefined || !path.startsWith('assets/')) return own;
  for (const other of await storedVersions()) {
    const found = await findIn(path, other);
    if (found !== undefined) return found;
  }
  return undefined;
}

async function findIn(path: string, version: string): Promise<Response | undefined> {
  const name = packOf(path);
  if (name === undefined) return (await openCache(version)).match(address(path));
  const found = await readPack(name, version);
  const text = found?.pack[path];
  return found === undefined || text === undefined
    ? undefined
    : new Response(text, { headers: headers(found.response, path) });
}

const keyOf = (pack: string, version: string): string => `${version} ${pack}`;

function readPack(
  name: string,
  version: string,
): Promise<{ readonly pack: Pack; readonly response: Response } | undefined> {
  const key = keyOf(name, version);
  const cached = packs.get(key);
  if (cached !== undefined) return cached;
  const reading = (async () => {
    const response = await (await openCache(version)).match(address(name));
    return response === undefined ? undefined : { pack: (await response.clone().json()) as Pack, response };
  })();
  packs.set(key, reading);
  return reading;
}

// ---- tabs -----------------------------------------------------------------------------------------

/** Stores the version that a tab begins with; the tab keeps it. */
export async function assignVersion(tab: string, version: string): Promise<void> {
  const entry: Tab = { version, since: Date.now() };
  await (await caches.open(TABS_CACHE)).put(address(`tabs/${tab}`), new Response(JSON.stringify(entry)));
}

/** The version that a tab began with, if known. */
export async function versionOfTab(tab: string): Promise<string | undefined> {
  const entry = await (await caches.open(TABS_CACHE)).match(address(`tabs/${tab}`));
  return entry === undefined ? undefined : ((await entry.json()) as Tab).version;
}

/** Tabs that came from the network have the newest version. */
export async function assignMissingVersions(version: string): Promise<void> {
  for (const { id } of await self.clients.matchAll({ type: 'window' }))
    if ((await versionOfTab(id)) === undefined) await assignVersion(id, version);
}

/** Deletes the caches that no tab needs, except `current`; deletes nothing while another version is being installed. */
export async function deleteUnusedCaches(current: string): Promise<void> {
  if (self.registration.installing !== null || self.registration.waiting !== null) return;
  const open = new Set(
    (await self.clients.matchAll({ type: 'all', includeUncontrolled: true })).map(({ id }) => address(`tabs/${id}`)),
  );
  const tabs = await caches.open(TABS_CACHE);
  const used = new Set([current]);
  for (const request of await tabs.keys()) {
    const tab = (await (await tabs.match(request))?.json()) as Tab | undefined;
    if (tab === undefined) continue;
    if (open.has(request.url) || Date.now() - tab.since < TAB_OPENING_MS) used.add(tab.version);
    else await tabs.delete(request);
  }
  for (const version of await storedVersions()) if (!used.has(version)) await caches.delete(CACHE_PREFIX + version);
}
