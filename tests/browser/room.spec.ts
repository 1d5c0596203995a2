// Space of drawing and program in windows of all sizes: on phones, with an on-screen keyboard, at 200 %. Playwright emulates
// small windows and touch. The screenshots in test-results are for manual review, not goldens.
import { chromiumTest as test, type ChromiumPage, expect, nightUnless } from './engines';
import { chip, drawing, editor, open, problems, problemsButton, tab, title, type } from './page';

/** Size of a window, CSS pixels. At 200 % a window has half as many, each twice as large. */
interface Window {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly by: 'finger' | 'mouse';
  readonly ratio: 1 | 2;
  /** Least heights while the program is typed; by default that of the drawing at any time, and 100. */
  readonly whileTyping?: { readonly drawing: number; readonly program: number };
}

const WINDOWS: readonly Window[] = [
  { name: 'phone', width: 390, height: 844, by: 'finger', ratio: 2 },
  // The area above an on-screen keyboard.
  {
    name: 'phone with its keyboard',
    width: 390,
    height: 450,
    by: 'finger',
    ratio: 2,
    whileTyping: { drawing: 150, program: 200 },
  },
  { name: 'phone on its side', width: 844, height: 390, by: 'finger', ratio: 2 },
  { name: 'small phone', width: 320, height: 640, by: 'finger', ratio: 2 },
  { name: 'tablet', width: 820, height: 1180, by: 'finger', ratio: 2 },
  { name: '1280 at 100 %', width: 1280, height: 720, by: 'mouse', ratio: 1 },
  { name: '1280 at 200 %', width: 640, height: 360, by: 'mouse', ratio: 2 },
  { name: '1920 at 100 %', width: 1920, height: 1080, by: 'mouse', ratio: 1 },
  { name: '1920 at 200 %', width: 960, height: 540, by: 'mouse', ratio: 2 },
];

for (const { name, width, height, by, ratio, whileTyping } of WINDOWS) {
  for (const locale of ['en', 'zh', 'ru'] as const) {
    test(
      `the drawing has at least 240 pixels or half of the window: ${name}, ${locale}`,
      nightUnless(locale === 'en' && (name === 'phone' || name === '1280 at 100 %')),
      async ({ browser, baseURL }, info) => {
        const finger = by === 'finger';
        const context = await browser.newContext({
          ...(baseURL === undefined ? {} : { baseURL }),
          viewport: { width, height },
          deviceScaleFactor: ratio,
          isMobile: finger,
          hasTouch: finger,
          locale,
        });
        const page = (await context.newPage()) as ChromiumPage;
        await open(page);
        const least = Math.min(240, height / 2);
        const measured: string[] = [];
        const measure = async (when: string, leastNow = least): Promise<void> => {
          // During playback the layout never settles.
          if (when !== 'playing')
            await page
              .locator('gcode-playground')
              .evaluate(async (element) => (element as unknown as { settled: Promise<number> }).settled);
          const box = await drawing(page).boundingBox();
          measured.push(`${when}: ${Math.round(box?.width ?? 0)} × ${Math.round(box?.height ?? 0)}`);
          expect(box?.height, when).toBeGreaterThanOrEqual(leastNow);
          expect(box?.y, when).toBeGreaterThanOrEqual(0);
          expect((box?.y ?? 0) + (box?.height ?? 0), when).toBeLessThanOrEqual(height);
          expect(await page.evaluate(() => document.documentElement.scrollWidth), when).toBeLessThanOrEqual(width);
          await page.screenshot({ path: info.outputPath(`${when}.png`) });
        };
        await measure('first');
        // The title of the program is wide enough to be readable.
        expect((await title(page).boundingBox())?.width).toBeGreaterThanOrEqual(120);

        await type(page, 'O1\nG50 S2000\nT0101\nG96 S150 M3\nG0 X52 Z2\nG90 X48 Z-30 F0.2\nX44\nX\nG0 X200 Z200\nM30');
        await measure('writing', whileTyping?.drawing);
        const box = await editor(page).boundingBox();
        expect(
          Math.min(height, (box?.y ?? 0) + (box?.height ?? 0)) - (box?.y ?? 0),
          'lines to write in',
        ).toBeGreaterThanOrEqual(whileTyping?.program ?? 100);

        // While the user types on a phone, only the drawing and the text are shown.
        await drawing(page).focus();
        await expect(problemsButton(page).or(tab(page, 'problems')).first()).toBeVisible();
        // A narrow element gets its tabs in the frame after the other parts are shown.
        await page.evaluate(() => new Promise((shown) => requestAnimationFrame(() => requestAnimationFrame(shown))));
        if ((await page.getByRole('tabpanel').count()) > 0) {
          for (const which of ['problems', 'explain', 'program'] as const) {
            await tab(page, which).click();
            await expect(tab(page, which)).toHaveAttribute('aria-selected', 'true');
            if (which === 'problems') await expect(problems(page)).toBeVisible();
            if (which === 'explain') await expect(chip(page)).toBeVisible();
            if (which === 'program') await expect(editor(page)).toBeVisible();
            await measure(which);
          }
        } else {
          for (const part of [editor(page), problemsButton(page), chip(page)]) await expect(part).toBeInViewport();
          await problemsButton(page).click();
          await expect(problems(page)).toBeInViewport();
          await measure('problems');
          await expect(editor(page)).toBeInViewport();
        }
        await page.getByRole('button', { name: /^(Play|播放|Пуск)$/ }).click();
        // The readout during playback is over the drawing.
        await expect(page.locator('[part~=readout]')).toBeVisible();
        await measure('playing');
        info.annotations.push({ type: 'canvas', description: measured.join(', ') });
        await context.close();
      },
    );
  }
}

/** Number of colours in the picture. */
function colours(page: ChromiumPage): Promise<number> {
  return page.evaluate(() => {
    const canvas = document.querySelector('gcode-playground')?.shadowRoot?.querySelector('canvas');
    if (canvas === null || canvas === undefined) return -1;
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const found = new Set<number>();
    for (let at = 0; at < data.length; at += 4) found.add((data[at]! << 16) | (data[at + 1]! << 8) | data[at + 2]!);
    return found.size;
  });
}

for (const colorScheme of ['light', 'dark'] as const) {
  test(`in forced-colours mode the picture uses the system colours: ${colorScheme}`, async ({
    browser,
    baseURL,
  }, info) => {
    const context = await browser.newContext({
      ...(baseURL === undefined ? {} : { baseURL }),
      forcedColors: 'active',
      colorScheme,
    });
    const page = (await context.newPage()) as ChromiumPage;
    await open(page);
    expect(await colours(page)).toBeGreaterThan(20);
    await page.screenshot({ path: info.outputPath('forced.png') });
    await context.close();
  });
}

test('a printout contains drawing, problems, setup and the whole program, in light colours', async ({
  browser,
  baseURL,
}, info) => {
  const context = await browser.newContext({ ...(baseURL === undefined ? {} : { baseURL }), colorScheme: 'dark' });
  const page = (await context.newPage()) as ChromiumPage;
  await open(page);
  const lines = Array.from({ length: 120 }, (_, at) => `G01 X${60 - at / 10} Z-${at} F0.2`);
  await type(page, ['(STOCK D=70 LENGTH=150)', 'G00 X80 Z2', 'X', ...lines, 'M30'].join('\n'));
  // Suppress the browser's print dialog.
  await page.evaluate(() => {
    window.print = () => Reflect.set(window, 'printed', true);
  });
  await page.keyboard.press('Control+p');
  await page.waitForFunction(() => Reflect.get(window, 'printed') === true);
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  const sheet = page.locator('.sheet');
  await expect(sheet.getByRole('listitem').filter({ hasText: 'G01 X48.1 Z-119 F0.2' })).toBeVisible();
  await expect(sheet.locator('.sheet-program > li')).toHaveCount(124);
  await expect(sheet.locator('.sheet-problems')).toContainText('has no number');
  await expect(sheet.locator('.sheet-setup')).toContainText('70');
  await expect(sheet.locator('img')).toBeVisible();
  await expect(editor(page)).toBeHidden();
  await page.screenshot({ path: info.outputPath('paper.png'), fullPage: true });
  expect(await sheet.evaluate((element) => getComputedStyle(element).color)).toBe('rgb(0, 0, 0)');
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  await expect(sheet.getByRole('listitem')).toHaveCount(0);
  await context.close();
});
