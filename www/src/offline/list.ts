// What the page consists of, as its build lists it (`offline.vite.ts`).
//
// In: an address. Out: which file it means, of what kind, and what it is stored in. Must not know: how files are stored or answered with.

/** One build of the page. */
export interface Listed {
  /** Made of all that is listed. */
  readonly version: string;
  /** Each file with the beginning of its SHA-256, hexadecimal. */
  readonly files: Readonly<Record<string, string>>;
  /** The script of the page, which `index.html` names. */
  readonly entry: string;
}

/** Folders of which all files are stored as one: a thousand small pages would be a thousand requests. */
const PACKED = /^(docs|examples|rules\/(?:en|zh|ru|pictures))\//;
/** Folders of files that another version may have had. */
const OURS = /^(assets|docs|examples|icons|offline|rules)\//;

/** The file that holds all of the folder of a file; nothing where it is stored by itself. */
export function packOf(path: string): string | undefined {
  const folder = PACKED.exec(path)?.[1];
  return folder === undefined ? undefined : `offline/${folder.replace('/', '-')}.json`;
}

/** The path of a file of the page, by its address; nothing where it may not be one. */
export function pathOf(address: string, scope: string, files: Listed['files']): string | undefined {
  const { origin, pathname } = new URL(address);
  const folder = new URL(scope);
  if (origin !== folder.origin || !pathname.startsWith(folder.pathname)) return undefined;
  const rest = pathname.slice(folder.pathname.length);
  const path = rest === '' || rest.endsWith('/') ? `${rest}index.html` : rest;
  return path in files || OURS.test(path) ? path : undefined;
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

/** What a file is; servers that know less are not relied on. */
export function typeOf(path: string): string {
  return TYPES[path.slice(path.lastIndexOf('.') + 1)] ?? 'text/plain; charset=utf-8';
}
