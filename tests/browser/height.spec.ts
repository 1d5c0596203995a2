// The attribute height="auto": an element, and a frame, as high as its contents.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test, type BasicPage } from './engines';
import { manual, openHtml } from './embedded';
import { editor, settled, type Playground } from './page';
import { serve } from './sites';

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');

/** A program with this number of lines. */
function program(lines: number): string {
  return [
    'T0101 M03 S800',
    'G00 X52 Z2',
    ...Array.from({ length: lines - 3 }, (_, at) => `G01 Z-${at + 1} F0.2`),
    'M30',
  ].join('\n');
}

interface Sizes {
  /** Height of the element, CSS pixels. */
  readonly element: number;
  /** Lines for which the editor has room. */
  readonly rows: number;
  /** Whether the program scrolls. */
  readonly scrolls: boolean;
  /** Height of the drawing; 0 without one. */
  readonly drawing: number;
}

/** The sizes of the only element, once it is settled. */
function sizes(page: BasicPage): Promise<Sizes> {
  return page.locator('gcode-playground').evaluate(async (element) => {
    await (element as Playground).settled;
    const root = element.shadowRoot!;
    const scroller = root.querySelector<HTMLElement>('.cm-scroller');
    const content = root.querySelector('.cm-content');
    const style = content === null ? undefined : getComputedStyle(content);
    const number = (length: string | undefined): number => Number.parseFloat(length ?? '0');
    const padding = number(style?.paddingBlockStart) + number(style?.paddingBlockEnd);
    return {
      element: element.offsetHeight,
      rows: scroller === null ? 0 : (scroller.clientHeight - padding) / number(style?.lineHeight),
      scrolls: scroller !== null && scroller.scrollHeight > scroller.clientHeight + 1,
      drawing: root.querySelector<HTMLElement>('.pictures')?.offsetHeight ?? 0,
    };
  });
}

async function show(page: BasicPage, attributes: string, lines: number): Promise<Sizes> {
  await openHtml(page, manual(`<gcode-playground ${attributes}><pre>\n${program(lines)}\n</pre></gcode-playground>`));
  await settled(page);
  return sizes(page);
}

/** The default height, 34rem. */
const DEFAULT_HEIGHT_PX = 544;

test('an element with a listing has room for its lines, within the limits', async ({ page }) => {
  const seven = await show(page, 'view="code" controls="none" height="auto"', 7);
  expect(seven.scrolls).toBe(false);
  expect(seven.rows).toBeGreaterThanOrEqual(7);
  expect(seven.rows).toBeLessThan(7.5);
  expect(seven.element).toBeLessThan(DEFAULT_HEIGHT_PX);
  const cut = await show(page, 'view="code" controls="none" height="auto" rows-max="12"', 40);
  expect(cut.scrolls).toBe(true);
  expect(cut.rows).toBeGreaterThanOrEqual(12);
  expect(cut.rows).toBeLessThan(12.5);
  const least = await show(page, 'view="code" controls="none" height="auto" rows-min="9"', 4);
  expect(least.rows).toBeGreaterThanOrEqual(9);
  expect(least.rows).toBeLessThan(9.5);
});

for (const width of [1000, 420]) {
  test(`program and drawing have room in an element ${width} px wide`, async ({ page }) => {
    const style = `style="width: ${width}px"`;
    const long = await show(page, `${style} height="auto"`, 25);
    expect(long.scrolls).toBe(false);
    expect(long.rows).toBeGreaterThanOrEqual(25);
    expect(long.drawing).toBeGreaterThanOrEqual(240);
    const short = await show(page, `${style} height="auto"`, 4);
    expect(short.scrolls).toBe(false);
    expect(short.drawing).toBeGreaterThanOrEqual(240);
    expect(short.element).toBeLessThan(long.element);
  });
}

test('the element grows while the reader types, and becomes lower afterwards', async ({ page }) => {
  const before = await show(page, 'view="code" height="auto"', 8);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  for (let line = 0; line < 5; line++) {
    await page.keyboard.press('Enter');
    await page.keyboard.type('X1');
  }
  const typed = await sizes(page);
  expect(typed.scrolls).toBe(false);
  expect(typed.element).toBeGreaterThan(before.element);
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('G00 X1\nM30\n');
  expect((await sizes(page)).element).toBeGreaterThanOrEqual(before.element);
  await page.evaluate(() => document.body.appendChild(document.createElement('button')).focus());
  await expect.poll(async () => (await sizes(page)).element).toBeLessThan(before.element);
});

test('a drawing alone has the proportion 16 : 9, and the attribute can be removed', async ({ page }) => {
  const { drawing } = await show(page, 'view="picture" height="auto" style="width: 640px"', 5);
  expect(Math.abs(drawing - 360)).toBeLessThanOrEqual(3);
  await page.locator('gcode-playground').evaluate((element) => element.removeAttribute('height'));
  expect((await sizes(page)).element).toBe(DEFAULT_HEIGHT_PX);
  await page.locator('gcode-playground').evaluate((element) => element.setAttribute('height', 'auto'));
  expect(Math.abs((await sizes(page)).drawing - 360)).toBeLessThanOrEqual(3);
});

test('a settled element keeps its height', async ({ page }) => {
  const before = await show(page, 'height="auto"', 20);
  await page.waitForTimeout(800);
  expect((await sizes(page)).element).toBe(before.element);
});

test('a frame tells its height to the page around it, as in the reference', async ({ page }) => {
  const reference = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  const block = /(?<=\n\n) {4}<iframe id="example"(?:.*\n)(?: {4}.*\n)*/.exec(reference)?.[0] ?? '';
  const site = await serve(FILES, () => ({
    filesAt: '/embed/',
    pages: { '/index.html': `<!doctype html><title>A manual</title>${block.replace(/^ {4}/gm, '')}` },
  }));
  try {
    await page.goto(`${site.origin}/index.html`);
    const heights = (): Promise<readonly number[]> =>
      page.evaluate(async () => {
        const frame = document.querySelector('iframe')!;
        const element = frame.contentDocument?.querySelector<HTMLElement>('gcode-playground');
        await (element as Playground | null | undefined)?.settled;
        return [Number.parseFloat(frame.style.height), element?.offsetHeight ?? -1];
      });
    // The editor of a program of two lines has a least height.
    await expect
      .poll(async () => {
        const [frame = 0, element = -1] = await heights();
        return frame === element && frame > 0 && frame < 250;
      })
      .toBe(true);
  } finally {
    await site.close();
  }
});
