// Runs one round in headless Chromium and prints a line of JSON: `node tests/speed/page/measure.mjs FILE`.
// PLAYGROUND_CHROMIUM names the browser; without it Playwright's browser is used.
import { createReadStream } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const file = resolve(process.argv[2]);
// Playwright is a dependency of the page.
const { chromium } = createRequire(join(root, 'www', 'package.json'))('@playwright/test');
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm' };

const server = createServer((request, response) => {
  const path = new URL(request.url, 'http://localhost').pathname;
  response.setHeader('content-type', TYPES[extname(path)] ?? 'text/plain');
  const source = path === '/program' ? file : join(root, path);
  createReadStream(source).on('error', () => response.writeHead(404).end()).pipe(response);
});
await new Promise((done) => server.listen(0, '127.0.0.1', done));
const executablePath = process.env.PLAYGROUND_CHROMIUM || undefined;
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu', '--disable-quic'] });
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/tests/speed/page/index.html`);
  await page.waitForFunction(() => 'measure' in window);
  console.log(JSON.stringify(await page.evaluate(() => window.measure('/program'))));
} finally {
  await browser.close();
  server.close();
}
