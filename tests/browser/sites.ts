// Web sites that embed the element like a manual: pages of one origin, and the element's files on the same or another
// one.
//
// In: the folder of the element's files, pages and headers. Out: two servers on this machine, and the report of a page,
// sent by a plain request, which every policy and sandbox of these tests allows. Must not know: which tests there are.

import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import { readFile } from 'node:fs/promises';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { listenOnNewPort } from './engines/new-port';

export type Headers = Readonly<Record<string, string>>;

/** Content of a site. */
export interface Site {
  /** HTML by path: `/index.html`. */
  readonly pages?: Readonly<Record<string, string>>;
  /** Headers of each page. */
  readonly pageHeaders?: Headers;
  /** Path of the element's files: `/embed/`. */
  readonly filesAt?: string;
  /** Headers of each file. */
  readonly fileHeaders?: Headers;
  /** Files of the element that are missing. */
  readonly missing?: RegExp;
}

/** A running site. */
export interface ServedSite {
  readonly origin: string;
  /** Requested paths, in order. */
  readonly requested: readonly string[];
  /** The report that a page has sent to `/report`. */
  readonly reported: Promise<string>;
  close(): Promise<void>;
}

const TYPES: Headers = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.css': 'text/css; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
};

/** Serves a site on a new port and therefore as a separate origin. `at` may be called before the port is known. */
export async function serve(files: string, site: (origin: string) => Site): Promise<ServedSite> {
  const requested: string[] = [];
  let report: (text: string) => void = () => undefined;
  const reported = new Promise<string>((resolve) => (report = resolve));
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    requested.push(path);
    if (path === '/report') {
      void bodyOf(request).then((text) => {
        report(text);
        response.writeHead(204).end();
      });
      return;
    }
    void answer(path, site(originOf(server)), files, response);
  });
  await listenOnNewPort(server);
  return {
    origin: originOf(server),
    requested,
    reported,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

function originOf(server: Server): string {
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
}

async function answer(path: string, site: Site, files: string, response: ServerResponse): Promise<void> {
  const page = site.pages?.[path];
  if (page !== undefined) {
    response
      .writeHead(200, { 'content-type': path.endsWith('.js') ? TYPES['.js'] : TYPES['.html'], ...site.pageHeaders })
      .end(page);
    return;
  }
  const at = site.filesAt;
  const inside = at !== undefined && path.startsWith(at) ? normalize(path.slice(at.length)) : undefined;
  const isThere = inside !== undefined && !inside.startsWith('..') && site.missing?.test(inside) !== true;
  const bytes = isThere ? await readFile(join(files, inside)).catch(() => undefined) : undefined;
  if (bytes === undefined) response.writeHead(404, site.fileHeaders).end();
  else
    response
      .writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream', ...site.fileHeaders })
      .end(bytes);
}

async function bodyOf(request: IncomingMessage): Promise<string> {
  const pieces: Buffer[] = [];
  for await (const piece of request) pieces.push(piece as Buffer);
  return Buffer.concat(pieces).toString('utf8');
}
