// Many elements on a page: they share one worker and one module, and a program that hangs or fails in one element does
// not affect the others.
import { expect } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage, nightUnless } from './engines';
import { FOREIGN } from './embedded';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { program, settled } from './page';
import { serve } from './sites';
import { runBeforeWorker } from './worker-script';

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');

const PROGRAM = program('s000-o0002');
/** Timeout of the worker's watchdog, with some margin. */
const WATCH_MS = 25_000;

interface Picture extends HTMLElement {
  value: string;
  readonly settled: Promise<number>;
}

/** Opens a page with `count` elements that all have the same program. */
async function openMany(page: ChromiumPage, count: number): Promise<void> {
  await page.goto(FOREIGN);
  await page.evaluate(
    async ({ count, text }) => {
      const elements = Array.from({ length: count }, () => {
        const element = document.createElement('gcode-playground') as Picture;
        element.setAttribute('view', 'picture');
        element.style.height = '300px';
        element.textContent = text;
        return element;
      });
      document.body.replaceChildren(...elements);
      const script = document.createElement('script');
      script.type = 'module';
      script.src = new URL('../../element.js', location.href).href;
      document.head.append(script);
      await customElements.whenDefined('gcode-playground');
      await Promise.all(elements.map((element) => element.settled));
    },
    { count, text: PROGRAM },
  );
}

/** Width of the canvas of an element and a hash of its pixels: "640: 77". */
function shown(page: ChromiumPage, which: number): Promise<string> {
  return page.evaluate((which) => {
    const canvas = document.querySelectorAll('gcode-playground')[which]?.shadowRoot?.querySelector('canvas');
    if (canvas === null || canvas === undefined) return 'no canvas';
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let at = 0; at < data.length; at += 4)
      sum = (sum * 31 + data[at]! * 7 + data[at + 1]! * 3 + data[at + 2]!) % 1_000_003;
    return `${canvas.width}: ${sum}`;
  }, which);
}

function put(page: ChromiumPage, which: number, text: string): Promise<void> {
  return page.evaluate(
    ({ which, text }) => {
      (document.querySelectorAll('gcode-playground')[which] as Picture).value = text;
    },
    { which, text },
  );
}

/** Injects a fault into the worker, in the middle of the run of any text that contains `(FAULT)`. */
async function injectFault(page: ChromiumPage, fault: string): Promise<void> {
  await runBeforeWorker(
    page,
    `
    let isHit = false;
    self.addEventListener('message', ({ data }) => { if (JSON.stringify(data?.content ?? '').includes('(FAULT)')) isHit = true; });
    const now = performance.now.bind(performance);
    performance.now = () => { if (isHit) { isHit = false; ${fault} } return now(); };
  `,
  );
}

test('thirty elements share one worker, and request each file once', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await openMany(page, 30);
  expect(page.workers().length).toBe(1);
  const ours = asked.filter((path) => /\.(js|wasm)$/.test(path));
  expect(ours.filter((path, at) => ours.indexOf(path) !== at)).toEqual([]);
  // Pictures far from the viewport become small copies meanwhile: all pictures of one size are equal.
  const pictures = await Promise.all(Array.from({ length: 30 }, (_, which) => shown(page, which)));
  const sizes = new Set(pictures.map((picture) => picture.split(':')[0]));
  expect(new Set(pictures).size).toBe(sizes.size);
  expect(sizes.size).toBeLessThanOrEqual(2);
});

test('pictures far from the viewport are stored small, and are complete again after scrolling to them', {
  tag: '@night',
}, async ({ page }) => {
  await openMany(page, 12);
  const width = (which: number): Promise<number> =>
    page.evaluate(
      (which) => document.querySelectorAll('gcode-playground')[which]!.shadowRoot!.querySelector('canvas')!.width,
      which,
    );
  const whole = await width(0);
  const picture = await shown(page, 0);
  await expect.poll(() => width(11)).toBe(Math.ceil(whole / 2));
  expect(await width(0)).toBe(whole);
  // A picture that changes outside the viewport is soon small again, too.
  await put(page, 10, 'G00 X50 Z2\nG01 Z-30 F0.2\n');
  await settled(page, 10);
  expect(await width(10)).toBe(whole);
  await expect.poll(() => width(10)).toBe(Math.ceil(whole / 2));
  await page.evaluate(() => document.querySelectorAll('gcode-playground')[11]!.scrollIntoView());
  await expect.poll(() => width(11)).toBe(whole);
  expect(await shown(page, 11)).toBe(picture);
  await expect.poll(() => width(0)).toBe(Math.ceil(whole / 2));
  // After a pause, the worker only has the program left to paint them from.
  await page.waitForTimeout(4_000);
  await page.evaluate(() => document.querySelectorAll('gcode-playground')[0]!.scrollIntoView());
  await expect.poll(() => width(0)).toBe(whole);
  expect(await shown(page, 0)).toBe(picture);
});

for (const { fault, does, message } of [
  { fault: 'hangs', does: 'for (;;);', message: 'The run took too long' },
  { fault: 'fails', does: "throw new Error('a fault');", message: 'The interpreter failed' },
]) {
  test(
    `a program that ${fault} does not affect the pictures of other elements`,
    nightUnless(fault !== 'hangs'),
    async ({ page }) => {
      await injectFault(page, does);
      await openMany(page, 3);
      const before = await shown(page, 0);
      await put(page, 1, 'G00 X50 Z2 (FAULT)\n');
      const notice = page.locator('gcode-playground').nth(1).getByText(message);
      await expect(notice).toBeVisible({ timeout: WATCH_MS });
      const begun = Date.now();
      await settled(page, 0);
      await settled(page, 2);
      expect(Date.now() - begun).toBeLessThan(2_000);
      expect(await shown(page, 0)).toBe(before);
      expect(await shown(page, 2)).toBe(before);
      await expect(page.locator('gcode-playground').nth(0).getByText(message)).toHaveCount(0);
      // The failed element continues separately from the others, with its next program.
      await put(page, 1, PROGRAM);
      await settled(page, 1);
      expect(await shown(page, 1)).toBe(before);
      await expect.poll(() => page.workers().length).toBe(2);
      await put(page, 0, 'G00 X50 Z2\nG01 Z-30 F0.2\n');
      await settled(page, 0);
      expect(await shown(page, 0)).not.toBe(before);
    },
  );
}

/** The CSS rule from the reference. */
const KEEPS_THE_PLACE =
  '<style>@media (scripting: enabled) { gcode-playground { display: block; height: 24rem; overflow: auto; } }</style>';

const ASKS_EARLY = '<link rel="preload" as="fetch" type="application/wasm" crossorigin href="embed/core.wasm">';

/** Opens a page with `count` elements below each other, as an author writes it. */
async function manual(page: ChromiumPage, count: number, attributes: string, act: () => Promise<void>): Promise<void> {
  const element = `<p>${'Words. '.repeat(60)}</p>\n<gcode-playground view="picture" ${attributes}>\n${PROGRAM}\n</gcode-playground>\n`;
  const html = `<!DOCTYPE html><html lang="en"><head><title>A manual</title>${KEEPS_THE_PLACE}${ASKS_EARLY}
    <script type="module" src="/embed/element.js"></script></head><body>${element.repeat(count)}</body></html>`;
  const site = await serve(FILES, () => ({
    filesAt: '/embed/',
    fileHeaders: { 'cache-control': 'no-cache' },
    pages: { '/index.html': html },
  }));
  await page.addInitScript(() => {
    Object.assign(window, { shift: 0 });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries())
        (window as unknown as { shift: number }).shift += (entry as unknown as { value: number }).value;
    }).observe({ type: 'layout-shift', buffered: true });
  });
  try {
    await page.goto(`${site.origin}/index.html`);
    await act();
    const asked = site.requested.filter((path) => path.startsWith('/embed/'));
    expect(
      asked.filter((path, at) => asked.indexOf(path) !== at),
      'asked for twice',
    ).toEqual([]);
  } finally {
    await site.close();
  }
}

/** Number of elements with a picture. */
function drawn(page: ChromiumPage): Promise<number> {
  return page.evaluate(
    () =>
      [...document.querySelectorAll('gcode-playground')].filter((element) =>
        element.shadowRoot?.querySelector('[part=fallback][hidden]'),
      ).length,
  );
}

test('the reference shows how to reserve space for an element and preload the files of the picture', () => {
  const reference = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  for (const line of [KEEPS_THE_PLACE, ASKS_EARLY]) expect(reference).toContain(line);
});

test('elements start when they come near the viewport, and the layout does not shift', async ({ page }) => {
  await manual(page, 30, '', async () => {
    await expect.poll(() => drawn(page)).toBeGreaterThan(1);
    await page.waitForTimeout(500);
    const first = await drawn(page);
    expect(first).toBeLessThan(10);
    expect(
      await page.evaluate(() =>
        customElements
          .whenDefined('gcode-playground')
          .then(() => (document.querySelector('gcode-playground:last-of-type') as Picture).value),
      ),
    ).toBe(PROGRAM.trim());
    await page.evaluate(() => document.querySelector('gcode-playground:last-of-type')!.scrollIntoView());
    await expect
      .poll(() =>
        page.evaluate(
          () =>
            document
              .querySelector('gcode-playground:last-of-type')!
              .shadowRoot!.querySelector('[part=fallback][hidden]') !== null,
        ),
      )
      .toBe(true);
    expect(await drawn(page)).toBeLessThan(20);
    expect(page.workers().length).toBe(1);
    expect(await page.evaluate(() => (window as unknown as { shift: number }).shift)).toBe(0);
  });
});

test('an element that waits for a click loads nothing before it, and reading settled starts it too', async ({
  page,
}) => {
  await manual(page, 2, 'loading="click"', async () => {
    const show = page.getByRole('button', { name: 'Show the tool path' });
    await expect(show).toHaveCount(2);
    expect(await drawn(page)).toBe(0);
    expect(page.workers().length).toBe(0);
    await show.first().click();
    await expect.poll(() => drawn(page)).toBe(1);
    await page.evaluate(() => (document.querySelectorAll('gcode-playground')[1] as Picture).settled);
    expect(await drawn(page)).toBe(2);
    await expect(show).toHaveCount(0);
    expect(await page.evaluate(() => (window as unknown as { shift: number }).shift)).toBe(0);
  });
});
