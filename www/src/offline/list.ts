// The files of the page, as listed by its build (`offline.vite.ts`).
//
// In: an address. Out: the path and type of its file, and the pack that contains it. Must not know: how files are
// stored or served.

/** One build of the page. */
export interface BuildManifest {
  /** Hash of the list. */
  readonly version: string;
  /** Each file with the first digits of its SHA-256, hexadecimal. */
  readonly files: Readonly<Record<string, string>>;
  /** The script of the page, which `index.html` names. */
  readonly entry: string;
}

/** Folders whose files are stored in one pack: a thousand small pages would be a thousand requests. */
const PACKED_FOLDERS = /^(docs|examples|manual\/(?:en|zh|ru)|manual|rules\/(?:en|zh|ru|pictures))\//;
/** A figure of the manual, which has words in its language. */
const FIGURE = /^manual\/figures\/.*-(en|zh|ru)\.svg$/;
/** A pack with pages in one language. */
const PACK_OF_LANGUAGE = /^offline\/(?:manual|rules)-(en|zh|ru)\.json$/;
/** Folders of files that may belong to another version. */
const PAGE_FOLDERS = /^(assets|docs|examples|icons|manual|offline|rules)\//;

/** The pack that contains a file; undefined if the file is stored separately. */
export function packOf(path: string): string | undefined {
  const language = FIGURE.exec(path)?.[1];
  const folder = language === undefined ? PACKED_FOLDERS.exec(path)?.[1] : `manual/${language}`;
  return folder === undefined ? undefined : `offline/${folder.replace('/', '-')}.json`;
}

/** The language of the pages in a pack; undefined for a file that every reader needs. */
export function languageOfPack(name: string): string | undefined {
  return PACK_OF_LANGUAGE.exec(name)?.[1];
}

/** The path of a file of the page, by its address; undefined if it cannot be one. */
export function pathOf(address: string, scope: string, files: BuildManifest['files']): string | undefined {
  const { origin, pathname } = new URL(address);
  const folder = new URL(scope);
  if (origin !== folder.origin || !pathname.startsWith(folder.pathname)) return undefined;
  const rest = pathname.slice(folder.pathname.length);
  const path = rest === '' || rest.endsWith('/') ? `${rest}index.html` : rest;
  return path in files || PAGE_FOLDERS.test(path) ? path : undefined;
}

const TYPES: Readonly<Record<string, string>> = {
  css: 'text/css; charset=utf-8',
  html: 'text/html; charset=utf-8',
  js: 'text/javascript; charset=utf-8',
  json: 'application/json',
  png: 'image/png',
  svg: 'image/svg+xml',
  wasm: 'application/wasm',
  webmanifest: 'application/manifest+json',
};

/** The MIME type of a file, because not all servers send the right one. */
export function typeOf(path: string): string {
  return TYPES[path.slice(path.lastIndexOf('.') + 1)] ?? 'text/plain; charset=utf-8';
}
