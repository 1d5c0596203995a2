// The presentation: how much of the window is program and picture, the size of drawing and text, the row of controls, and
// the current block in words.
import { chromiumTest as test, expect, type ChromiumPage, nightUnless } from './engines';
import { choose, editor, goTo, locate, open } from './page';

const LOCALES = [
  { locale: 'en-US', present: 'Present', hint: /Page Down/, words: /^G71: .* passes/ },
  { locale: 'zh-CN', present: '演示', hint: /Page Down/, words: /^G71：走刀/ },
  { locale: 'ru-RU', present: 'Показ', hint: /Page Down/, words: /^G71: проходов/ },
] as const;
const WINDOWS = [
  { width: 1280, height: 720 },
  { width: 1440, height: 900 },
  { width: 1920, height: 1080 },
] as const;

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** CSS pixels per mm of the drawing. */
async function scaleOf(page: ChromiumPage): Promise<number> {
  const [near, far] = [await locate(page, 0, 0), await locate(page, 0, -50)];
  return (near.x - far.x) / 50;
}

/** Font size of the program, CSS pixels. */
const textSize = (page: ChromiumPage): Promise<number> =>
  page
    .locator('.cm-line')
    .first()
    .evaluate((line) => Number.parseFloat(getComputedStyle(line).fontSize));

async function boxOf(page: ChromiumPage, selector: string): Promise<Box> {
  const box = await page.locator(selector).first().boundingBox();
  if (box === null) throw new Error(`${selector} is not in view`);
  return box;
}

/** Number of separate texts in a column of the screen: rows with ink, divided by empty rows. */
async function textsIn(page: ChromiumPage, clip: Box): Promise<number> {
  const png = (await page.screenshot({ clip })).toString('base64');
  return page.evaluate(async (png) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    if (context === null) throw new Error('no canvas');
    context.drawImage(image, 0, 0);
    const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
    let [texts, rows] = [0, 0];
    for (let y = 0; y <= height; y += 1) {
      let ink = 0;
      for (let x = 0; x < width && y < height; x += 1) {
        const at = 4 * (y * width + x);
        if (Math.abs((data[at] ?? 0) - (data[0] ?? 0)) > 60) ink += 1;
      }
      // A grid line or a tick is thinner than a digit.
      if (ink > 0) rows += 1;
      else {
        if (rows >= 6) texts += 1;
        rows = 0;
      }
    }
    return texts;
  }, png);
}

/** The position of the tool: a diameter and Z, mm. */
async function toolPlace(page: ChromiumPage): Promise<{ readonly x: number; readonly z: number }> {
  const spoken = (await page.getByRole('slider').getAttribute('aria-valuetext')) ?? '';
  const [x, z] = (spoken.replaceAll('−', '-').match(/-?[\d.]+/g) ?? []).map(Number);
  if (x === undefined || z === undefined) throw new Error(`no position: ${spoken}`);
  return { x, z };
}

for (const viewport of WINDOWS) {
  test.describe(`${viewport.width}×${viewport.height}`, () => {
    test.use({ viewport });

    test(
      `a presentation enlarges text and drawing of G71, ${viewport.width}`,
      nightUnless(viewport.width === 1280),
      async ({ page }) => {
        await open(page, '#s003-g71');
        const before = { scale: await scaleOf(page), text: await textSize(page) };
        await choose(page, 'more', 'Present');
        await expect(page.getByRole('button', { name: 'End presentation' })).toBeFocused();
        await expect.poll(() => scaleOf(page)).toBeGreaterThan(before.scale * 1.1);
        expect(await textSize(page)).toBeGreaterThan(before.text * 1.3);

        const [program, picture] = [await boxOf(page, '.editor'), await boxOf(page, '.pictures')];
        const all = viewport.width * viewport.height;
        expect((program.width * program.height) / all).toBeGreaterThanOrEqual(0.42);
        expect((program.width * program.height) / all).toBeLessThanOrEqual(0.48);
        expect((picture.width * picture.height) / all).toBeGreaterThanOrEqual(0.52);
        expect((picture.width * picture.height) / all).toBeLessThanOrEqual(0.58);

        await test.step('no block is cut off', async () => {
          const overflow = await page
            .locator('.cm-scroller')
            .evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
          expect(overflow).toBeLessThanOrEqual(0);
          await expect(editor(page)).toContainText('N040 G71 P50 Q120 U0.5 W0.2 F100');
        });

        const canvas = await boxOf(page, 'canvas');
        await test.step('one row of controls over the picture', async () => {
          const bar = await boxOf(page, '.playback');
          expect(bar.height).toBeLessThan(0.08 * viewport.height);
          expect(bar.x).toBeGreaterThanOrEqual(picture.x - 1);
          expect(bar.y + bar.height).toBeLessThanOrEqual(canvas.y + 1);
          for (const control of await page.locator('.playback').locator('button, input').all()) {
            const box = await control.boundingBox();
            if (box === null) continue;
            expect(Math.abs(box.y + box.height / 2 - (bar.y + bar.height / 2))).toBeLessThan(4);
          }
        });

        await test.step('the axis of X is numbered', async () => {
          // The ruler without its ticks; its width follows the size of the text.
          const width = 2.6 * (await textSize(page));
          const ruler = { x: canvas.x + 1, y: canvas.y + 1, width, height: canvas.height * 0.8 };
          expect(await textsIn(page, ruler)).toBeGreaterThanOrEqual(4);
        });

        await test.step('the block is described, and the tool is in view', async () => {
          await expect(page.getByText(/Page Down.*Escape/)).toBeVisible();
          for (let block = 0; block < 2; block += 1) await page.keyboard.press('PageDown');
          const words = page.getByText(/^G71: .* passes/);
          await expect(words).toBeVisible();
          const said = (await words.boundingBox()) as Box;
          expect(said.y + said.height).toBeLessThanOrEqual(viewport.height);
          for (let motion = 0; motion < 12; motion += 1) {
            await page.keyboard.press('ArrowRight');
            const { x, z } = await toolPlace(page);
            const at = await locate(page, x, z);
            expect(at.x).toBeGreaterThan(canvas.x);
            expect(at.x).toBeLessThan(canvas.x + canvas.width);
            expect(at.y).toBeGreaterThan(canvas.y + 20);
            // The description does not cover the tool.
            expect(at.y).toBeLessThan(said.y);
          }
          const readout = await boxOf(page, '.readout');
          expect(readout.y + readout.height).toBeLessThanOrEqual(canvas.y + 1);
        });

        await page.keyboard.press('Escape');
        await expect.poll(() => scaleOf(page)).toBeCloseTo(before.scale, 1);
        expect(await textSize(page)).toBe(before.text);
      },
    );
  });
}

for (const { locale, present, hint, words } of LOCALES) {
  test.describe(locale, () => {
    test.use({ locale, viewport: { width: 1280, height: 720 } });

    test(`the current block is described in words, ${locale}`, async ({ page }) => {
      await open(page, '#s003-g71');
      await choose(page, 'more', present);
      await expect(page.getByText(hint)).toBeVisible();
      // Without a position of the tool, the block at the cursor is described.
      await goTo(page, 4);
      await expect(page.getByText(words)).toBeVisible();
      await page.keyboard.press('PageDown');
      await expect(page.getByText(words)).toBeHidden();
      await page.keyboard.press('PageDown');
      await expect(page.getByText(words)).toBeVisible();
    });
  });
}

test('on an upright phone, the picture is over the program', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, '#s003-g71');
  await choose(page, 'more', 'Present');
  await expect(page.getByRole('button', { name: 'End presentation' })).toBeVisible();
  await expect.poll(async () => (await boxOf(page, '.pictures')).width).toBe(390);
  const [program, picture] = [await boxOf(page, '.editor'), await boxOf(page, '.pictures')];
  expect(program.width).toBe(390);
  expect(program.y).toBeGreaterThanOrEqual(picture.y + picture.height - 1);
  expect(picture.height / 844).toBeGreaterThan(0.5);
});
