// Serves the built page over a slow line: a fixed bandwidth for all connections together. Each answer is delayed by the
// round-trip time, the first one on a connection by twice that time.
//
// The server limits the speed, because the emulation in the browser ignores requests of workers: the parts of the
// interpreter.
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

const BITS_A_SECOND = 1.6e6;
const THERE_AND_BACK_MS = 150;
/** Bytes sent at a time: about one packet. */
const PACKET = 1400;
const TICK_MS = 5;
const TYPES = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm',
};

/** Serves a folder, and pages given as text by path. */
export async function slowServer(folder, pages) {
  /** What was sent: `[ms since the epoch, bytes, path]`. */
  const sent = [];
  const requests = [];
  const compressed = new Map();
  const contentOf = (path) => {
    if (!compressed.has(path)) {
      const file = join(folder, normalize(path));
      const text = pages[path] ?? (existsSync(file) && statSync(file).isFile() ? readFileSync(file) : undefined);
      compressed.set(path, text === undefined ? undefined : gzipSync(text, { level: 9 }));
    }
    return compressed.get(path);
  };

  /** Answers in progress; each sends one packet in turn. */
  const line = [];
  let budget = 0;
  let before = performance.now();
  const tick = setInterval(() => {
    const now = performance.now();
    budget = line.length === 0 ? 0 : budget + ((now - before) * BITS_A_SECOND) / 8000;
    before = now;
    while (budget >= PACKET && line.length > 0) {
      const answer = line.shift();
      const packet = answer.body.subarray(answer.done, answer.done + PACKET);
      answer.done += packet.length;
      budget -= packet.length;
      answer.response.write(packet);
      sent.push([Date.now(), packet.length, answer.path]);
      if (answer.done < answer.body.length) line.push(answer);
      else answer.response.end();
    }
  }, TICK_MS);

  const known = new WeakSet();
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const path = pathname === '/' ? '/index.html' : pathname;
    const isNew = !known.has(request.socket);
    known.add(request.socket);
    requests.push(path);
    setTimeout(() => {
      const body = contentOf(path);
      if (body === undefined) return response.writeHead(404).end();
      response.writeHead(200, {
        'content-type': TYPES[extname(path)] ?? 'application/octet-stream', 'content-encoding': 'gzip', 'content-length': body.length,
        'cache-control': 'max-age=600',
      });
      line.push({ response, body, path, done: 0 });
    }, THERE_AND_BACK_MS * (isNew ? 2 : 1));
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    sent,
    requests,
    close: () => {
      clearInterval(tick);
      server.closeAllConnections();
      server.close();
    },
  };
}
