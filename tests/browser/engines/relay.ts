// A proxy in front of the page's server that injects scripts into each document before all others. WebDriver can
// neither run a script so early nor report errors; the injected scripts do both.
import { createServer } from 'node:http';
import { listenOnNewPort } from './new-port';

export interface Relay {
  /** The injected scripts. */
  readonly scripts: string[];
  /** Maps a URL of the page's server to this proxy, and back. */
  inFront(address: string): string;
  behind(address: string): string;
  close(): void;
}

/** Stores uncaught errors until they are requested. */
const ERRORS = `globalThis.errorsOfPage = [];
addEventListener('error', ({ error, message }) => errorsOfPage.push(message + '\\n' + (error?.stack ?? '')));
addEventListener('unhandledrejection', ({ reason }) => errorsOfPage.push(reason + '\\n' + (reason?.stack ?? '')));`;

interface File {
  readonly status: number;
  readonly type: string;
  readonly body: Buffer;
}

/** The files of the page's server, which do not change during the tests. */
const files = new Map<string, Promise<File>>();

async function load(address: string, accept: string): Promise<File> {
  const answer = await fetch(address, { headers: { accept } });
  return {
    status: answer.status,
    type: answer.headers.get('content-type') ?? 'application/octet-stream',
    body: Buffer.from(await answer.arrayBuffer()),
  };
}

function file(address: string, accept: string): Promise<File> {
  const key = `${accept} ${address}`;
  const known = files.get(key);
  if (known !== undefined) return known;
  const loading = load(address, accept);
  // Documents have a new query each time.
  if (!address.includes('?')) files.set(key, loading);
  loading.catch(() => files.delete(key));
  return loading;
}

export async function relay(server: string): Promise<Relay> {
  const origin = new URL(server).origin;
  const scripts: string[] = [];
  const http = createServer((request, response) => {
    void (async () => {
      const { status, type, body: stored } = await file(origin + (request.url ?? '/'), request.headers.accept ?? '*/*');
      let body = stored;
      if (type.startsWith('text/html')) {
        const put = `<script>${[ERRORS, ...scripts].join(';\n').replaceAll('</', '<\\/')}</script>`;
        body = Buffer.from(
          body
            .toString('utf8')
            .replace(/<head>|<meta charset/i, (found) => (found === '<head>' ? found + put : put + found)),
        );
      }
      response.writeHead(status, {
        'content-type': type,
        'content-length': body.length,
        'cache-control': 'no-store',
      });
      response.end(body);
    })().catch((error: unknown) => response.writeHead(502).end(String(error)));
  });
  const own = `http://127.0.0.1:${await listenOnNewPort(http)}`;
  const swapped = (address: string, from: string, to: string): string =>
    address.startsWith(from) ? to + address.slice(from.length) : address;
  return {
    scripts,
    inFront: (address) => swapped(address, origin, own),
    behind: (address) => swapped(address, own, origin),
    close: () => {
      http.close();
      http.closeAllConnections();
    },
  };
}
