// The element in other people's pages. The table in www/docs/element.md lists the ways of embedding and the expected
// result in each engine. A row without a test, or a test without a row, fails.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test, expect } from './engines';
import { motionCount, program } from './page';
import { serve, type ServedSite, type Site } from './sites';

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');
const ID = 's000-o0002';

/** The reported result: number of motions of the picture, or the message that the element shows instead. */
interface Outcome {
  readonly motions?: number;
  readonly strokes?: number;
  readonly message?: string;
  readonly after: number;
}

/** Script in the page of a manual that reports the result of its element to the address `REPORT`. */
const REPORTER = `
const begun = performance.now();
const element = document.querySelector('gcode-playground');
let isSent = false;
const send = (outcome) => {
  if (isSent) return;
  isSent = true;
  fetch('REPORT', { method: 'POST', mode: 'no-cors', body: JSON.stringify({ ...outcome, after: performance.now() - begun }) });
};
let motions = 0;
element.addEventListener('gcode-report', ({ detail }) => { motions = detail.summary.motions; });
element.addEventListener('gcode-settled', () => {
  const canvas = element.shadowRoot.querySelector('canvas');
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let strokes = 0;
  for (let at = 0; at < data.length; at += 4) if (data[at + 2] > 120 && data[at] < 60) strokes++;
  send({ motions, strokes });
});
const look = setInterval(() => {
  const notice = element.shadowRoot?.querySelector('[part~=notice]');
  if (notice !== null && notice !== undefined && notice.textContent !== '' && !notice.hidden) send({ message: notice.textContent });
  if (isSent) clearInterval(look);
}, 20);
setTimeout(() => {
  if (!customElements.get('gcode-playground')) send({ message: 'not defined: ' + element.innerText });
}, 4000);
`;

/** The page of the folder that contains one element. */
const FRAME_PAGE = readFileSync(join(FILES, 'index.html'), 'utf8');

/** One way in which a manual embeds the element. `at` is the URL of the folder with the element's files. */
interface Way {
  /** The files are served from another origin. */
  readonly apart?: boolean;
  readonly folder?: string;
  readonly fileHeaders?: Record<string, string>;
  /** The Content-Security-Policy of the page. */
  policy?(own: string, other: string): string;
  readonly missing?: RegExp;
  readonly framed?: boolean;
  /** The frame shows the page of the folder, with the program in its URL. */
  readonly addressed?: boolean;
}

const CORS = { 'access-control-allow-origin': '*' };

const WAYS: Readonly<Record<string, Way>> = {
  'same origin': {},
  'a subfolder': { folder: '/books/turning/_static/gcode/' },
  'a host that sends `no-cache`': { fileHeaders: { 'cache-control': 'no-cache' } },
  'another origin, with CORS': { apart: true, fileHeaders: CORS },
  'another origin, without CORS': { apart: true },
  '`<iframe sandbox="allow-scripts">`': { framed: true, fileHeaders: CORS },
  '`index.html#…` in such a frame': { framed: true, addressed: true, fileHeaders: CORS },
  'a strict policy, same origin': {
    policy: () => "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'",
  },
  'a strict policy, another origin': {
    apart: true,
    fileHeaders: CORS,
    policy: (own, other) =>
      `default-src 'none'; script-src ${own} ${other} 'wasm-unsafe-eval'; connect-src ${own} ${other}; worker-src blob:`,
  },
  'a strict policy, another origin, without `worker-src blob:`': {
    apart: true,
    fileHeaders: CORS,
    policy: (own, other) =>
      `default-src 'none'; script-src ${own} ${other} 'wasm-unsafe-eval'; connect-src ${own} ${other}`,
  },
  "a policy without `'wasm-unsafe-eval'`": {
    policy: () => "default-src 'none'; script-src 'self'; connect-src 'self'",
  },
  'Trusted Types required': {
    policy: () =>
      "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; require-trusted-types-for 'script'; trusted-types gcode-playground",
  },
  'the worker is missing': { missing: /^worker\.js$/ },
  'the module is missing': { missing: /^core\.wasm$/ },
};

/**
 * Possible targets of the link in a frame. `OWN` is the origin of the frame, `fromUrl` the value in the URL of the
 * frame, `fromPage` the value in a `meta` of its page.
 */
const LINKS: readonly { readonly fromUrl?: string; readonly fromPage?: string; readonly href: string | null }[] = [
  { href: 'OWN/embed/index.html' },
  { fromUrl: '', href: null },
  { fromUrl: '../play/', href: 'OWN/play/' },
  { fromUrl: 'OWN/play/', href: 'OWN/play/' },
  ...[
    'https://evil.example/',
    '//evil.example/',
    'OWN@evil.example/',
    'OWN.evil.example/',
    'javascript:alert(1)',
    'http://127.0.0.1:9/',
    'blob:OWN/play/',
    'https://[',
  ].map((fromUrl) => ({ fromUrl, href: 'OWN/embed/index.html' })),
  { fromPage: 'https://lathe.example/play/', href: 'https://lathe.example/play/' },
  {
    fromPage: 'https://lathe.example/play/',
    fromUrl: 'https://lathe.example/other/',
    href: 'https://lathe.example/other/',
  },
  { fromPage: 'https://lathe.example/play/', fromUrl: 'OWN/play/', href: 'OWN/play/' },
  { fromPage: 'https://lathe.example/play/', fromUrl: 'https://evil.example/', href: 'https://lathe.example/play/' },
];

/** The link appears after the picture, so check for three seconds that there is none. */
async function expectNone(leadsTo: () => Promise<string | null>): Promise<void> {
  for (let at = 0; at < 15; at++) {
    expect(await leadsTo()).toBe(null);
    await new Promise((done) => setTimeout(done, 200));
  }
}

test('"Open in the playground" of a frame leads to its own host, or to the page that its copy names', {
  tag: '@night',
}, async ({ page }) => {
  for (const { fromUrl, fromPage, href } of LINKS) {
    const own = await serve(FILES, (origin): Site => {
      const attributes = new URLSearchParams({
        program: 'G00 X1',
        ...(fromUrl === undefined ? {} : { playground: fromUrl.replace('OWN', origin) }),
      });
      return {
        pages: {
          '/index.html': `<!DOCTYPE html><title>A manual</title><iframe src="/embed/copy.html#${String(attributes).replaceAll('+', '%20').replaceAll('&', '&amp;')}" width="900" height="600"></iframe>`,
          '/embed/copy.html':
            fromPage === undefined
              ? FRAME_PAGE
              : FRAME_PAGE.replace('<title>', `<meta name="playground" content="${fromPage}"><title>`),
        },
        filesAt: '/embed/',
      };
    });
    try {
      await page.goto(`${own.origin}/index.html`);
      const leadsTo = (): Promise<string | null> =>
        page.evaluate(() => {
          const { contentDocument } = document.querySelector('iframe') ?? { contentDocument: document };
          const link = contentDocument
            ?.querySelector('gcode-playground')
            ?.shadowRoot?.querySelector<HTMLAnchorElement>('[part=open-link]');
          return link == null || link.hidden ? null : link.href;
        });
      if (href !== null) await expect.poll(leadsTo, `${fromUrl} ${fromPage}`).toBe(href.replace('OWN', own.origin));
      else await expectNone(leadsTo);
      // Outside a frame there is no link, whatever the URL contains.
      if (fromUrl !== 'https://evil.example/') continue;
      await page.goto(`${own.origin}/embed/copy.html#program=G00%20X1&playground=${encodeURIComponent(fromUrl)}`);
      await expectNone(leadsTo);
    } finally {
      await own.close();
    }
  }
});

/** The cells of the table (`shown`, `message` or `program`) by way and engine. */
function expected(): ReadonlyMap<string, Readonly<Record<string, string>>> {
  const document = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  const table = document.split('<!-- ways -->')[1]?.split('<!-- /ways -->')[0] ?? '';
  const [head = [], , ...rows] = table
    .trim()
    .split('\n')
    .map((row) =>
      row
        .split('|')
        .slice(1, -1)
        .map((cell) => cell.trim()),
    );
  const engines = head.slice(1).map((name) => name.toLowerCase());
  return new Map(
    rows.map(([way = '', ...cells]) => [way, Object.fromEntries(cells.map((cell, at) => [engines[at] ?? '', cell]))]),
  );
}

const TABLE = expected();

function page(element: string, reporter: string, view: string): string {
  return `<!DOCTYPE html>
<html lang="en">
  <head>
    <title>A manual</title>
    <script type="module" src="${element}"></script>
  </head>
  <body>
    <gcode-playground view="${view}">
${program(ID)}
    </gcode-playground>
    <script type="module" src="${reporter}"></script>
  </body>
</html>`;
}

/** Opens a page that embeds the element in this way, and returns the result. */
async function embed(
  way: Way,
  view: string,
  open: (address: string) => Promise<unknown>,
): Promise<{ readonly outcome: Outcome; readonly asked: readonly string[] }> {
  const filesAt = way.folder ?? '/embed/';
  const filesOf = {
    filesAt,
    ...(way.fileHeaders === undefined ? {} : { fileHeaders: way.fileHeaders }),
    ...(way.missing === undefined ? {} : { missing: way.missing }),
  };
  const other = way.apart === true ? await serve(FILES, () => filesOf) : undefined;
  const own = await serve(FILES, (origin): Site => {
    const policy = way.policy?.(origin, other?.origin ?? origin);
    const manual = page(`${other?.origin ?? origin}${filesAt}element.js`, '/reporter.js', view);
    const addressed = `${filesAt}with-reporter.html#${new URLSearchParams({ view, program: program(ID) })}`
      .replaceAll('+', '%20')
      .replaceAll('&', '&amp;');
    const inFrame = way.addressed === true ? addressed : '/frame.html';
    const frame = `<!DOCTYPE html><title>A manual</title><iframe sandbox="allow-scripts" src="${inFrame}" width="800" height="600"></iframe>`;
    return {
      pages: {
        '/index.html': way.framed === true ? frame : manual,
        '/frame.html': manual,
        [`${filesAt}with-reporter.html`]: FRAME_PAGE.replace(
          '<noscript>',
          '<script type="module" src="/reporter.js"></script><noscript>',
        ),
        '/reporter.js': REPORTER.replace('REPORT', `${origin}/report`),
      },
      pageHeaders: {
        ...(policy === undefined ? {} : { 'content-security-policy': policy }),
        ...(way.framed === true ? CORS : {}),
      },
      ...(other === undefined ? filesOf : {}),
    };
  });
  try {
    void open(`${own.origin}/index.html`).catch(() => undefined);
    return { outcome: JSON.parse(await own.reported) as Outcome, asked: (other ?? own).requested };
  } finally {
    await closeAll([own, other]);
  }
}

async function closeAll(sites: readonly (ServedSite | undefined)[]): Promise<void> {
  await Promise.all(sites.map((site) => site?.close()));
}

test('the table of ways to embed lists exactly the tested ways', () => {
  expect([...TABLE.keys()].sort()).toEqual(Object.keys(WAYS).sort());
});

for (const [name, way] of Object.entries(WAYS)) {
  // The whole element has the same requirements as the picture.
  for (const view of name.startsWith('a strict policy') || name.startsWith('Trusted')
    ? ['picture', 'all']
    : ['picture']) {
    test(`embedded: ${name}, view="${view}"`, async ({ page, engine }) => {
      const { outcome, asked } = await embed(way, view, (address) => page.goto(address));
      const cell = TABLE.get(name)?.[engine];
      const text = JSON.stringify(outcome);
      if (cell === 'shown') {
        expect(outcome.motions, text).toBe(motionCount(ID));
        expect(outcome.strokes, text).toBeGreaterThan(200);
      } else if (cell === 'message') {
        expect(outcome.message, text).toMatch(/could not be (loaded|started)/);
        expect(outcome.after, text).toBeLessThan(1_500);
      } else if (cell === 'program') {
        expect(outcome.message, text).toContain('not defined');
        expect(outcome.message, text).toContain('O0002');
      } else throw new Error(`${name}, ${engine}: nothing is expected`);
      const files = asked.filter((path) => /\.(js|wasm)$/.test(path) && !path.endsWith('/reporter.js'));
      if (cell === 'shown')
        expect(
          files.filter((path, at) => files.indexOf(path) !== at),
          'asked for twice',
        ).toEqual([]);
    });
  }
}
