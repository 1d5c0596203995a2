// The frame of the page: how many controls are visible, how much of the window is program and drawing, and that no two
// controls overlap.
import { chromiumTest as test, expect, type Page, nightUnless } from './engines';
import { linesInView, open, openProblems, play, settled, type } from './page';

/** What is measured in a window: controls in view, and the parts of the window that are program and drawing. */
interface Measured {
  readonly controls: readonly string[];
  readonly code: number;
  readonly drawing: number;
  /** Distance of the first line of the program from the top, CSS pixels. */
  readonly firstLine: number;
  /** Pairs of controls that overlap. */
  readonly overlaps: readonly string[];
}

/** Buttons, links, fields, the editor and the divider; the help at the cursor counts once. */
async function measure(page: Page): Promise<Measured> {
  return page.evaluate(() => {
    const all: HTMLElement[] = [];
    const walk = (root: ParentNode): void => {
      for (const element of root.querySelectorAll<HTMLElement>('*')) {
        if (element.shadowRoot !== null) walk(element.shadowRoot);
        if (element.matches('button, select, a[href], input, [contenteditable=true], [role=separator]'))
          all.push(element);
      }
    };
    walk(document);
    // The text of the editor can be larger than its box.
    const boxOf = (element: Element): DOMRect => (element.closest('.cm-scroller') ?? element).getBoundingClientRect();
    const isInView = (element: HTMLElement): boolean => {
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) return false;
      const { width, height, left, right, top, bottom } = boxOf(element);
      return width > 1 && height > 1 && right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
    };
    const nameOf = (element: Element): string =>
      (element.getAttribute('aria-label') ?? element.textContent ?? '').trim().slice(0, 30) || element.tagName;
    const visible = all.filter(isInView);
    const strip = visible.filter((element) => element.closest('.at-cursor') !== null);
    const controls = visible.filter((element) => !strip.slice(1).includes(element));
    const others = visible.filter((element) => !element.matches('[role=separator]'));
    const overlaps: string[] = [];
    for (const [at, one] of others.entries())
      for (const other of others.slice(at + 1)) {
        const [a, b] = [boxOf(one), boxOf(other)];
        const [across, down] = [
          Math.min(a.right, b.right) - Math.max(a.left, b.left),
          Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top),
        ];
        if (across > 1 && down > 1 && !one.contains(other) && !other.contains(one))
          overlaps.push(`${nameOf(one)} | ${nameOf(other)}`);
      }
    const root = document.querySelector('gcode-playground')?.shadowRoot;
    const share = (selector: string): number => {
      const found = root?.querySelector(selector);
      if (found === null || found === undefined) return 0;
      const { left, right, top, bottom } = boxOf(found);
      const width = Math.min(right, innerWidth) - Math.max(left, 0);
      const height = Math.min(bottom, innerHeight) - Math.max(top, 0);
      return (width * height) / (innerWidth * innerHeight);
    };
    return {
      controls: controls.map(nameOf),
      code: share('.editor'),
      drawing: share('.pictures'),
      firstLine: root?.querySelector('.cm-line')?.getBoundingClientRect().top ?? Number.NaN,
      overlaps,
    };
  });
}

interface WindowKind {
  readonly name: string;
  readonly viewport: { readonly width: number; readonly height: number };
  readonly hasTouch: boolean;
  readonly controls: number;
  readonly code: number;
  readonly drawing: number;
}

const WINDOWS: readonly WindowKind[] = [
  { name: '1440', viewport: { width: 1440, height: 900 }, hasTouch: false, controls: 25, code: 0.3, drawing: 0.42 },
  { name: '1366', viewport: { width: 1366, height: 768 }, hasTouch: false, controls: 25, code: 0.28, drawing: 0.42 },
  {
    name: '1024 touch',
    viewport: { width: 1024, height: 768 },
    hasTouch: true,
    controls: 22,
    code: 0.33,
    drawing: 0.45,
  },
  { name: '390 touch', viewport: { width: 390, height: 844 }, hasTouch: true, controls: 16, code: 0.3, drawing: 0.3 },
];

/** A program of the user with an error. */
const OWN = 'O0001\nG99 S800 M03\nT0101\nG00 X42 Z2\nG01 Z-2O F0.2\nG00 X60 Z20\nM30\n';

for (const { name, viewport, hasTouch, controls, code, drawing } of WINDOWS) {
  test.describe(`window ${name}`, () => {
    test.use({ viewport, hasTouch, isMobile: hasTouch });

    for (const locale of ['en-US', 'zh-CN', 'ru-RU'] as const) {
      test.describe(locale, () => {
        test.use({ locale });

        test(
          `few controls, and most of the window is program and drawing, ${locale}`,
          nightUnless(locale === 'en-US' || name === '1440'),
          async ({ page }) => {
            await open(page);
            const check = async (state: string): Promise<void> => {
              const measured = await measure(page);
              expect(measured.controls.length, `${state}: ${measured.controls.join(' · ')}`).toBeLessThanOrEqual(
                controls,
              );
              expect(measured.overlaps, state).toEqual([]);
              expect(measured.code, `${state}: program`).toBeGreaterThanOrEqual(code);
              expect(measured.drawing, `${state}: drawing`).toBeGreaterThanOrEqual(drawing);
              if (name === '1440') expect(measured.firstLine, state).toBeLessThanOrEqual(100);
            };
            await check('example');
            await type(page, OWN);
            await settled(page);
            await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
            await expect(page.locator('.cm-focused')).toHaveCount(0);
            await check('own program');
          },
        );
      });
    }
  });
}

test('with the list of problems open, at least 8 lines of the program are in view', async ({ page }) => {
  await page.setViewportSize({ width: 1366, height: 768 });
  await open(page);
  await type(page, OWN.replace('M30\n', `${'G01 X4O\n'.repeat(30)}M30\n`));
  await openProblems(page);
  expect(await linesInView(page)).toBeGreaterThanOrEqual(8);
});

test('no two controls overlap in any width', async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  const problems: string[] = [];
  for (const state of ['rest', 'playing'] as const) {
    if (state === 'playing') {
      await play(page).click();
      await page.waitForTimeout(500);
      await page.getByRole('button', { name: 'Pause' }).click();
    }
    for (const width of [320, 360, 390, 480, 600, 735, 768, 844, 1024, 1180, 1280, 1366, 1440, 1680, 1920]) {
      await page.setViewportSize({ width, height: 800 });
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const { overlaps } = await measure(page);
      problems.push(...overlaps.map((pair) => `${width} ${state}: ${pair}`));
    }
  }
  expect(problems).toEqual([]);
});
