// A static server of the built page that knows nothing of it, can be down, can refuse files, and can have another build.
//
// In: the folder, files that are in place of others. Out: its address. Each is an origin of its own, so nothing is stored
// of another test. Must not know: which tests there are.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import { basename, extname, join, normalize } from 'node:path';
import { listenOnNewPort } from './engines/new-port';

export const DIST = join(__dirname, '..', '..', 'www', 'dist');

/** Files that are other ones, by path; `undefined`: it is not there. */
export type Changes = ReadonlyMap<string, string | undefined>;

/** How a file fails: there is no such file, the connection is closed, or other bytes come, which the browser may keep. */
export type Refusal = 'missing' | 'closed' | 'corrupted';

export interface StoredSite {
  readonly address: string;
  /** Paths that were asked for. */
  readonly asked: string[];
  /** No request is answered any more. */
  stop(): Promise<void>;
  start(): Promise<void>;
  /** From now on the files whose paths match are refused, the last time at an address that matches `last`; without a pattern all are served. */
  refuse(pattern?: RegExp, how?: Refusal, last?: RegExp): void;
  /** From now on another build is served. */
  publish(changes: Changes): void;
}

/** What servers without any settings say of files. */
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
  const asked: string[] = [];
  let changes: Changes = new Map();
  let refused: { readonly pattern: RegExp; readonly how: Refusal; readonly last: RegExp | undefined } | undefined;
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = normalize(pathname.slice(at.length) + (pathname.endsWith('/') ? 'index.html' : ''));
    asked.push(path);
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
    asked,
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

/** What the next build of the page would be: its script has another name, its examples another text. */
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
    // Scripts that are loaded later import it by its name.
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
