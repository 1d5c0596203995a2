// The 3D view of the part: rendered when it is opened, rotated by keyboard and mouse, follows the tool, and frees its
// resources when closed.
import { expect, type Locator } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage } from './engines';
import { motionCount, open, type } from './page';

test.use({
  // WebGL is rendered by the CPU here: small pictures are enough.
  viewport: { width: 800, height: 560 },
  launchOptions: {
    ...(process.env['PLAYGROUND_CHROMIUM'] ? { executablePath: process.env['PLAYGROUND_CHROMIUM'] } : {}),
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist',
      '--disable-quic',
      '--no-first-run',
    ],
  },
});

const status = (page: ChromiumPage) => page.getByRole('status');
const button = (page: ChromiumPage) => page.getByRole('button', { name: 'Show the part as a solid' });
const dialog = (page: ChromiumPage) => page.getByRole('dialog', { name: 'The part, a quarter cut away' });
const view = (page: ChromiumPage) => dialog(page).getByRole('img', { name: /three dimensions/ });

/** Share of pixels that differ from the background, and a number that changes with the picture. */
async function seen(picture: Locator): Promise<{ share: number; sum: number }> {
  const png = (await picture.screenshot()).toString('base64');
  return picture.page().evaluate(async (png) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(4, 4, image.width - 8, image.height - 8);
    let [other, sum] = [0, 0];
    for (let at = 0; at < data.length; at += 4) {
      if (Math.abs(data[at]! - data[0]!) + Math.abs(data[at + 2]! - data[2]!) > 24) other += 1;
      sum = (sum * 31 + data[at]!) % 1_000_003;
    }
    return { share: (4 * other) / data.length, sum };
  }, png);
}

test('the part is rendered, rotated, follows the tool, and is released', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  await open(page, '#s001-o6003');
  await expect(status(page)).toContainText(`${motionCount('s001-o6003')} motions`);
  const heavy = () => loaded.filter((url) => url.includes('solid-view')).length;
  expect(heavy()).toBe(0);

  await button(page).focus();
  await page.keyboard.press('Enter');
  await expect(view(page)).toBeFocused();
  expect(heavy()).toBe(1);
  await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(0.15);
  const first = await seen(view(page));

  await test.step('rotated by keyboard and mouse', async () => {
    await page.keyboard.press('ArrowLeft');
    await expect.poll(async () => (await seen(view(page))).sum).not.toBe(first.sum);
    await page.keyboard.press('Home');
    await expect.poll(async () => (await seen(view(page))).sum).toBe(first.sum);
    await page.keyboard.press('-');
    await expect.poll(async () => (await seen(view(page))).share).toBeLessThan(first.share);
    const box = (await view(page).boundingBox())!;
    const before = (await seen(view(page))).sum;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 90, box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    await expect.poll(async () => (await seen(view(page))).sum).not.toBe(before);
    await dialog(page).getByRole('button', { name: 'Reset view' }).click();
    await expect.poll(async () => (await seen(view(page))).sum).toBe(first.sum);
  });

  await test.step('the part is the one at the current step', async () => {
    // The blank: nothing is removed before the first cut.
    await page.keyboard.press('F9');
    await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(first.share + 0.01);
  });

  await test.step('closed', async () => {
    await page.keyboard.press('Escape');
    await expect(dialog(page)).toBeHidden();
    await expect(button(page)).toBeFocused();
    await expect(page.locator('.solid canvas')).toHaveCount(0);
    await button(page).click();
    await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(0.15);
    expect(heavy()).toBe(1);
  });
});

test('holes of live tools are drawn on the part', { tag: '@night' }, async ({ page }) => {
  // Three holes in the side, one of them in the face of the cut, and one in the end face; they remove nothing from the
  // turned part.
  const blocks = (side: string, face: string) => `(STOCK D=60 LENGTH=60)
(TOOL T0303 TYPE=DRILL D=12)
M45
G28 H0
T0303
G97 S1000 M13
G00 X66 Z-30 C0
${side}
G80
G00 Z5 X30
${face}
G80
G00 X100 Z100
M46
M30`;
  const pictures: { share: number; sum: number }[] = [];
  await open(page, '#s003-g71');
  for (const text of [blocks('', ''), blocks('G98 G87 Z-30 C0 X20 R-1 F80\nC120\nC240', 'G83 X30 C300 Z-12 R-1 F80')]) {
    await type(page, text);
    await expect(status(page)).toContainText('motions');
    await button(page).click();
    await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(0.15);
    await page.waitForTimeout(500);
    pictures.push(await seen(view(page)));
    await page.keyboard.press('Escape');
    await expect(dialog(page)).toBeHidden();
  }
  const [plain, drilled] = pictures as [(typeof pictures)[0], (typeof pictures)[0]];
  expect(drilled.sum).not.toBe(plain.sum);
  // The part has not moved.
  expect(Math.abs(drilled.share - plain.share)).toBeLessThan(0.02);
});

test('without a part the dialog shows a message', async ({ page }) => {
  // An example without a blank; without a cut, no blank can be assumed.
  await open(page, '#s003-g71');
  await type(page, 'G0 X20 Z2\nM30');
  await expect(status(page)).toContainText('1 motion ');
  await button(page).click();
  await expect(dialog(page).getByText('There is no part to show')).toBeVisible();
});

test('without WebGL the dialog shows a message, and loads nothing', async ({ page }) => {
  await page.addInitScript(() => {
    const before = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith('webgl') ? null : Reflect.apply(before, this, [kind, ...rest]);
    } as typeof before;
  });
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  await open(page);
  await button(page).click();
  await expect(dialog(page).getByText('WebGL is missing')).toBeVisible();
  expect(loaded.some((url) => url.includes('solid-view'))).toBe(false);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('the part is opened at the drawing, played in the dialog, and shows the tool', async ({ page }) => {
    await open(page, '#s003-g71');
    await expect(button(page)).toBeInViewport();
    await button(page).tap();
    await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(0.05);
    // A finger has neither a wheel nor keys.
    await expect(dialog(page)).toContainText('one finger');
    await expect(dialog(page)).not.toContainText(/wheel|arrow keys|F9|Ctrl/i);

    const finished = await seen(view(page));
    const playHere = dialog(page).getByRole('button', { name: 'Play' });
    for (const control of [playHere, dialog(page).getByRole('button', { name: /^Next motion/ })]) {
      const box = await control.boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
    }
    await dialog(page)
      .getByRole('button', { name: /^Next motion/ })
      .tap();
    await expect.poll(async () => (await seen(view(page))).sum).not.toBe(finished.sum);
    await playHere.tap();
    await expect(dialog(page).getByRole('button', { name: 'Pause' })).toBeVisible();
    await dialog(page).getByRole('button', { name: 'Pause' }).tap();
    await expect(playHere).toBeVisible();
  });
});

test('the tool is drawn at its position', { tag: '@night' }, async ({ page }) => {
  // The tool moves along the finished part without a cut.
  await open(page, '#s003-g71');
  await type(
    page,
    '(STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X60 Z5\nG00 X42 Z2\nG00 Z-50\nG01 X40 F0.2\nG01 X42\nM30\n',
  );
  await expect(status(page)).toContainText('motions');
  await button(page).click();
  await expect.poll(async () => (await seen(view(page))).share).toBeGreaterThan(0.1);
  const without = await seen(view(page));
  const next = dialog(page).getByRole('button', { name: /^Next motion/ });
  for (let motion = 0; motion < 2; motion += 1) await next.click();
  await expect.poll(async () => (await seen(view(page))).sum).not.toBe(without.sum);
  const right = await seen(view(page));
  await next.click();
  await expect.poll(async () => (await seen(view(page))).sum).not.toBe(right.sum);
});
