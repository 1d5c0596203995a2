// Measures the first picture for a reader with a slow line and a slow processor: 1.6 Mbit/s, a round trip of 150 ms,
// four times slower, gzip, nothing cached. Run by `cargo xtask bench` after the site has been built.
//
//   node tests/speed/first-picture.mjs [--rounds N] [--report FILE] [--network]
//
// PLAYGROUND_CHROMIUM names the browser; without it Playwright's browser is used. Each measurement starts a new
// browser; figures are medians. --network only lists the requests, in order.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { slowServer } from './slow-network.mjs';
import { slowProcessor } from './slow-processor.mjs';
import { median } from './stopwatch.mjs';

const SLOWER = 4;
/** Budgets until the first picture: one element, 30 elements, the whole page. */
const AIMS = { picture: { kB: 220, s: 2.2 }, many: { kB: 220, s: 3.3 }, all: { kB: 400, s: 3.5 } };
/** Memory above an empty page, MB. */
const MOST_FOR_MANY = 63;
/** Time after which an unused element frees what it can compute again. */
const REST_MS = 5_000;
const TYPING_AIMS = { task: 50, key: 60 };
const TYPED_LINES = 3483;
const KEYS = 24;
const KEY_EVERY_MS = 250;
const SETTLED_WITHIN_MS = 60_000;

const root = fileURLToPath(new URL('../../', import.meta.url));
const dist = join(root, 'www', 'dist');
const { chromium } = createRequire(join(root, 'www', 'package.json'))('@playwright/test');
const { values: options } = parseArgs({
  options: { rounds: { type: 'string' }, report: { type: 'string' }, network: { type: 'boolean' } },
});

const program = readFileSync(join(root, 'tests/programs/s000-o0002/program.nc'), 'utf8');
const MANY = 30;
/** A page of a manual, as an author writes it. */
const manual = (count) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Pictures</title>
<style>gcode-playground { display: block; height: 19rem; }</style>
<link rel="preload" as="fetch" type="application/wasm" crossorigin href="embed/core.wasm">
<script type="module" src="embed/element.js"></script>${`<p>Words.</p><gcode-playground view="picture">${program}</gcode-playground>`.repeat(count)}</html>`;
const PAGES = {
  '/one.html': manual(1),
  '/many.html': manual(MANY),
  '/empty.html': '<!doctype html><html lang="en"><meta charset="utf-8"><title>Nothing</title></html>',
};

const server = await slowServer(dist, PAGES);
try {
  if (options.network) await listRequests();
  else await measure(Number(options.rounds ?? 3));
} finally {
  server.close();
}

async function measure(rounds) {
  const rows = [];
  for (const [name, path, aims] of [
    ['one element, `view="picture"`', 'one.html', AIMS.picture],
    [`the first of ${MANY} elements`, 'many.html', AIMS.many],
    ['the whole page', 'index.html', AIMS.all],
  ]) {
    const runs = [];
    for (let round = 0; round < rounds; round++) runs.push(await firstPicture(path));
    const of = (key) => median(runs.map((run) => run[key]));
    rows.push(`| ${name} | ${kB(of('bytes'))} | ${kB(of('bytes') - of('core'))} | ${aims.kB} | ${seconds(of('report'))} | ${seconds(of('picture'))} | ${aims.s.toFixed(1)} | ${kB(of('all'))} |`);
  }
  const memory = { one: [], many: [] };
  const typing = [];
  for (let round = 0; round < rounds; round++) {
    memory.one.push(await memoryOf('one.html'));
    memory.many.push(await memoryOf('many.html'));
    typing.push(await typed());
  }
  const text = [
    `### The first picture: 1.6 Mbit/s, 150 ms, a processor ${SLOWER} times slower (${rounds} rounds)`, '',
    '| page | kB until the picture | of it beside the core | aim | first report, s | picture, s | aim | kB in all |',
    '|---|---:|---:|---:|---:|---:|---:|---:|', ...rows, '',
    `### Memory, and typing in a program of ${TYPED_LINES} lines at the slow processor`, '',
    '| | figure | aim |', '|---|---:|---:|',
    `| memory of one element, above an empty page, MB | ${median(memory.one).toFixed(1)} | |`,
    `| memory of ${MANY} elements, all of them drawn | ${median(memory.many).toFixed(1)} | ${MOST_FOR_MANY} |`,
    `| longest task while typing, ms | ${longest(median(typing.map(({ task }) => task)))} | ${TYPING_AIMS.task} |`,
    `| slowest key, ms | ${median(typing.map(({ key }) => key)).toFixed(0)} | ${TYPING_AIMS.key} |`, '',
  ].join('\n');
  console.log(text);
  if (options.report) writeFileSync(options.report, text);
}

/** Browsers report tasks of 50 ms or more. */
function longest(task) {
  return task === 0 ? 'under 50' : task.toFixed(0);
}

async function withBrowser(act) {
  const executablePath = process.env.PLAYGROUND_CHROMIUM || undefined;
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'] });
  try {
    return await act(browser);
  } finally {
    await browser.close();
  }
}

/** Bytes and seconds until the first report and the first picture. */
async function firstPicture(path) {
  return withBrowser(async (browser) => {
    const page = await browser.newPage();
    await page.addInitScript(watch);
    const fast = await slowProcessor(browser, SLOWER);
    try {
      server.sent.length = 0;
      await page.goto(server.address + path, { waitUntil: 'commit' });
      const seen = await page.waitForFunction(() => window.seen.picture !== undefined && window.seen, undefined, { timeout: SETTLED_WITHIN_MS });
      const { report, picture, origin } = await seen.jsonValue();
      const until = server.sent.filter(([at]) => at <= origin + picture);
      await fast();
      await settled(page);
      const sum = (packets) => packets.reduce((bytes, [, length]) => bytes + length, 0);
      const core = until.filter(([, , file]) => /(_bg-[\w-]+|core)\.wasm$/.test(file));
      return { bytes: sum(until), core: sum(core), report, picture, all: sum(server.sent) };
    } finally {
      await fast();
    }
  });
}

/** Runs in the page: records when the worker first reports a run, and when the canvas first shows strokes. */
function watch() {
  const seen = { origin: performance.timeOrigin, report: undefined, picture: undefined };
  window.seen = seen;
  const Own = window.Worker;
  window.Worker = class extends Own {
    constructor(...given) {
      super(...given);
      this.addEventListener('message', ({ data: { event } }) => {
        if (event?.kind === 'path' || event?.kind === 'report') seen.report ??= performance.now();
        if (event?.kind === 'pictures' && seen.picture === undefined) requestAnimationFrame(look);
      });
    }
  };
  /** Pixels in the colour of a feed stroke. */
  const look = () => {
    const root = document.querySelector('gcode-playground').shadowRoot;
    const canvas = root.querySelector('canvas');
    const probe = root.querySelector('[part~=drawing]').appendChild(document.createElement('span'));
    probe.style.color = 'var(--playground-feed)';
    const [red, green, blue] = getComputedStyle(probe).color.match(/[\d.]+/g).map(Number);
    probe.remove();
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let strokes = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (Math.abs(data[at] - red) + Math.abs(data[at + 1] - green) + Math.abs(data[at + 2] - blue) < 24) strokes++;
    }
    if (strokes > 20) seen.picture ??= performance.now();
  };
}

function settled(page) {
  return page.locator('gcode-playground').first().evaluate((element) => element.settled);
}

/** Memory of the renderers with all elements of a page drawn, minus that with an empty page, MB. */
async function memoryOf(path) {
  return withBrowser(async (browser) => {
    const page = await browser.newPage();
    const session = await browser.newBrowserCDPSession();
    const memory = async () => {
      await page.requestGC();
      await page.waitForTimeout(1000);
      const { processInfo } = await session.send('SystemInfo.getProcessInfo');
      const kilobytes = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => Number(/RssAnon:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1]));
      return kilobytes.reduce((sum, one) => sum + one, 0) / 1024;
    };
    await page.goto(`${server.address}empty.html`);
    const empty = await memory();
    await page.goto(server.address + path);
    await page.evaluate(async () => {
      await customElements.whenDefined('gcode-playground');
      await Promise.all([...document.querySelectorAll('gcode-playground')].map((element) => element.settled));
    });
    await page.waitForTimeout(REST_MS);
    return (await memory()) - empty;
  });
}

/** Types in the middle of a long program: the longest task and the slowest key, ms. */
async function typed() {
  return withBrowser(async (browser) => {
    const page = await browser.newPage();
    await page.goto(server.address);
    await settled(page);
    await page.locator('gcode-playground').evaluate((element, text) => (element.value = text), longProgram());
    await settled(page);
    await page.getByRole('textbox', { name: 'Program' }).focus();
    await page.evaluate(() => {
      const worst = { task: 0, key: 0 };
      window.worst = worst;
      new PerformanceObserver((list) => list.getEntries().forEach(({ duration }) => (worst.task = Math.max(worst.task, duration)))).observe({ type: 'longtask' });
      new PerformanceObserver((list) => list.getEntries().forEach(({ name, duration }) => {
        if (name === 'keydown' || name === 'keypress') worst.key = Math.max(worst.key, duration);
      })).observe({ type: 'event', durationThreshold: 16 });
    });
    for (let line = 0; line < 12; line++) await page.keyboard.press('ArrowDown');
    await page.keyboard.press('End');
    await page.keyboard.press('Enter');
    await settled(page);
    await page.evaluate(() => Object.assign(window.worst, { task: 0, key: 0 }));
    // Typing is measured on the main thread only, so the emulation of the browser fits: it stops that thread many times
    // per millisecond. Stopping the process for 12 ms at a time would make any task up to 12 ms longer.
    const processor = await page.context().newCDPSession(page);
    await processor.send('Emulation.setCPUThrottlingRate', { rate: SLOWER });
    try {
      for (const key of 'G01 X41.5 Z-12.25 F0.15;'.slice(0, KEYS)) {
        await page.keyboard.press(key === ';' ? 'Enter' : key);
        await page.waitForTimeout(KEY_EVERY_MS);
      }
    } finally {
      await processor.send('Emulation.setCPUThrottlingRate', { rate: 1 });
    }
    await page.waitForTimeout(500);
    return page.evaluate(() => window.worst);
  });
}

/** A roughed shaft, pass by pass, with a fault in every eightieth line: each has its row in the list of problems. */
function longProgram() {
  const lines = ['O0001', 'G50 S2000', 'T0101', 'G96 S150 M03', 'G00 X102.0 Z2.0'];
  for (let pass = 0; lines.length < TYPED_LINES - 2; pass++) {
    const x = (100 - (pass % 400) * 0.2).toFixed(3);
    lines.push(`G00 X${x}`, `G01 Z-${(80 - (pass % 37)).toFixed(3)} F0.2`, `G01 X${(Number(x) + 1).toFixed(3)} Z-${(80.5 - (pass % 37)).toFixed(3)}`, 'G00 Z2.0');
    if (pass % 20 === 19) lines.push('G04');
  }
  return [...lines.slice(0, TYPED_LINES - 2), 'M30', '%', ''].join('\n');
}

/** Prints the requests in order; fails if a file is requested twice. */
async function listRequests() {
  for (const path of ['one.html', 'index.html']) {
    server.requests.length = 0;
    await withBrowser(async (browser) => {
      const page = await browser.newPage();
      await page.goto(server.address + path);
      await settled(page);
    });
    console.log([path, ...server.requests.map((file) => `  ${file}`)].join('\n'));
    const twice = server.requests.filter((file, at) => server.requests.indexOf(file) !== at);
    if (twice.length === 0) continue;
    console.error(`asked for twice: ${twice.join(', ')}`);
    process.exitCode = 1;
  }
}

function kB(bytes) {
  return (bytes / 1000).toFixed(0);
}

function seconds(ms) {
  return (ms / 1000).toFixed(2);
}
