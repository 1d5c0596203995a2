// A generic static server for the built page, which can be down, refuse files, or serve another build.
//
// In: the folder and replacements for files. Out: its URL. Each server is a separate origin, so no test sees the
// storage of another one. Must not know: which tests there are.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import { basename, extname, join, normalize } from 'node:path';
import { listenOnNewPort } from './engines/new-port';

export const DIST = join(__dirname, '..', '..', 'www', 'dist');

/** Replaced files by path; `undefined` for a missing file. */
export type Changes = ReadonlyMap<string, string | undefined>;

/** How a file fails: not found, connection closed, or other bytes, which the browser may cache. */
export type Refusal = 'missing' | 'closed' | 'corrupted';

export interface StoredSite {
  readonly address: string;
  /** Requested paths. */
  readonly requested: string[];
  /** Stops answering requests. */
  stop(): Promise<void>;
  start(): Promise<void>;
  /**
   * Refuses files whose paths match from now on, for the last time at a URL that matches `last`. Without a pattern, all
   * files are served again.
   */
  refuse(pattern?: RegExp, how?: Refusal, last?: RegExp): void;
  /** Serves another build from now on. */
  publish(changes: Changes): void;
}

/** Content types of a server with default settings. */
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
  '.txt': 'text/plain; charset=utf-8',
  '.json': 'application/json',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

/** Serves the page from a folder of its site: `/` or `/some/where/`. */
export async function storedSite(at = '/', folder = DIST): Promise<StoredSite> {
  const requested: string[] = [];
  let changes: Changes = new Map();
  let refused: { readonly pattern: RegExp; readonly how: Refusal; readonly last: RegExp | undefined } | undefined;
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = normalize(pathname.slice(at.length) + (pathname.endsWith('/') ? 'index.html' : ''));
    requested.push(path);
    const refusal = refused?.pattern.test(path) === true ? refused.how : undefined;
    if (refusal !== undefined && refused?.last?.test(request.url ?? '') === true) refused = undefined;
    if (refusal === 'closed') return void request.socket.destroy();
    if (refusal === 'corrupted')
      return void response
        .writeHead(200, { 'content-type': TYPES[extname(path)], 'cache-control': 'max-age=600' })
        .end('<h1>200</h1>');
    const bytes =
      !pathname.startsWith(at) || path.startsWith('..') || refusal === 'missing'
        ? undefined
        : changes.has(path)
          ? changes.get(path)
          : await readFile(join(folder, path)).catch(() => undefined);
    if (bytes === undefined) response.writeHead(404, { 'content-type': 'text/html' }).end('<h1>404</h1>');
    else response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' }).end(bytes);
  };
  const server = createServer((request, response) => void answer(request, response));
  const port = await listenOnNewPort(server);
  return {
    address: `http://127.0.0.1:${port}${at}`,
    requested,
    stop: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
    start: () =>
      new Promise((resolve, reject) => {
        server.once('error', reject);
        server.listen(port, '127.0.0.1', resolve);
      }),
    refuse(pattern, how = 'missing', last = undefined) {
      refused = pattern && { pattern, how, last };
    },
    publish(build) {
      changes = build;
    },
  };
}

/** Simulates the next build of the page: its script has another name, and its examples other texts. */
export function nextBuild(): Changes {
  const read = (path: string): string => readFileSync(join(DIST, path), 'utf8');
  const hash = (text: string): string => createHash('sha256').update(text).digest('hex').slice(0, 32);
  const entry = /assets\/index-[\w-]+\.js/.exec(read('index.html'))![0];
  const next = 'assets/index-nextnext.js';
  const examples = read('offline/examples.json').replaceAll('G71', 'G71 (NEXT)');
  const files: readonly (readonly [string, string, string])[] = [
    [
      'index.html',
      'index.html',
      read('index.html').replaceAll(entry, next).replace('<head>', '<head><meta name="build" content="next">'),
    ],
    [entry, next, read(entry)],
    ['offline/examples.json', 'offline/examples.json', examples],
    // Lazily loaded scripts import it by its name.
    ...readdirSync(join(DIST, 'assets'))
      .map((file) => `assets/${file}`)
      .filter((file) => file !== entry && file.endsWith('.js') && read(file).includes(basename(entry)))
      .map((file) => [file, file, read(file).replaceAll(basename(entry), basename(next))] as const),
  ];
  let worker = read('service-worker.js');
  const put = (from: string, to: string): void => {
    if (!worker.includes(from)) throw new Error(`the service worker does not list ${from}`);
    worker = worker.replaceAll(from, to);
  };
  for (const [from, , text] of files) put(hash(read(from)), hash(text));
  put(entry, next);
  const version = /version:\s*"([0-9a-f]{32})"/.exec(worker)?.[1] ?? '';
  put(version, hash(worker));
  const loaded = JSON.parse(examples) as Record<string, string>;
  return new Map<string, string | undefined>([
    ...files.map(([, path, text]) => [path, text] as const),
    ...Object.entries(loaded),
    [entry, undefined],
    ['service-worker.js', worker],
  ]);
}
