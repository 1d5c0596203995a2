// The extension for Visual Studio Code, as it is packed, in Visual Studio Code for the Web.
import type { Frame } from '@playwright/test';
import { expect } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage } from './engines';
import type { Playground } from './page';
import { pixels } from './pixels';
import { vscodeSite, type VscodeSite } from './vscode-site';

// Webviews need their service worker.
test.use({ storing: 'on' });

const PROGRAM = `O0001 (SHOULDER)
(STOCK D=40 LENGTH=60)
T0101
G97 S800 M03
G00 X42 Z2
GO1 X36 F0.2
g1 Z-20
X42
G00 X100 Z100
M30
`;

let site: VscodeSite;
test.beforeAll(async () => {
  site = await vscodeSite({ 'part.nc': PROGRAM });
});
test.afterAll(() => site.close());

/** The lines of the text editor, with plain blanks. */
async function lines(page: ChromiumPage): Promise<string[]> {
  const text = await page.locator('.view-line').allInnerTexts();
  return text.map((line) => line.replaceAll('\u00a0', ' '));
}

const line = (page: ChromiumPage, text: string) => page.locator('.view-line', { hasText: text });

/** The element in the picture. */
interface Picture extends Playground {
  readonly cursorLine: number;
}

/** The document of the picture, inside the two frames of a webview. */
async function pictureOf(page: ChromiumPage): Promise<Frame> {
  const frames = page.frameLocator('iframe.webview').frameLocator('#active-frame');
  const element = await frames.locator('gcode-playground').elementHandle();
  const picture = await element?.ownerFrame();
  if (picture == null) throw new Error('the picture has no frame');
  await picture.evaluate(() => document.querySelector<Picture>('gcode-playground')!.settled);
  return picture;
}

const programOf = (picture: Frame): Promise<string> =>
  picture.evaluate(() => document.querySelector<Picture>('gcode-playground')!.value);
const cursorLineOf = (picture: Frame): Promise<number> =>
  picture.evaluate(() => document.querySelector<Picture>('gcode-playground')!.cursorLine);

test('problems, fixes, formatting and the picture of a program', async ({ page }) => {
  /** What browsers report about policies. */
  const refused: string[] = [];
  page.on('console', (message) => {
    if (/Content.Security.Policy|Refused to/i.test(message.text())) refused.push(message.text());
  });
  await page.goto(site.address);

  // The language, and its colours.
  await expect(page.locator('[id="status.editor.mode"]')).toHaveText('G-code');
  const colour = (text: string): Promise<string> =>
    page
      .locator('.view-line span span', { hasText: text })
      .first()
      .evaluate((span) => getComputedStyle(span).color);
  await expect.poll(async () => (await colour('SHOULDER')) !== (await colour('G97'))).toBe(true);

  // A problem is listed.
  await line(page, 'GO1').click();
  await page.keyboard.press('Control+Shift+m');
  await expect(page.locator('.markers-panel')).toContainText('`GO1` has a letter where the digit 0 belongs');

  // Its fix changes the text.
  await line(page, 'GO1').click();
  await page.keyboard.press('Home');
  await page.keyboard.press('Control+.');
  await expect(page.locator('.action-widget .focused')).toHaveText('Write `G01`');
  await page.keyboard.press('Enter');
  await expect.poll(() => lines(page)).toContain('G01 X36 F0.2');
  await expect(page.locator('.markers-panel')).toContainText('No problems have been detected');

  // So does the action for all safe fixes.
  await page.keyboard.press('Control+z');
  await expect.poll(() => lines(page)).toContain('GO1 X36 F0.2');
  await expect(page.locator('.markers-panel')).toContainText('`GO1` has a letter where the digit 0 belongs');
  await page.keyboard.press('F1');
  await page.keyboard.type('Fix All');
  await expect(page.locator('.quick-input-list .focused')).toContainText('Fix All');
  await page.keyboard.press('Enter');
  await expect.poll(() => lines(page)).toContain('G01 X36 F0.2');

  // Formatting.
  await page.keyboard.press('Control+Shift+i');
  await expect.poll(() => lines(page)).toContain('G01 Z-20');

  // The picture has the tool path and the part, which a later part of the interpreter makes.
  await page.getByRole('button', { name: 'Show the picture' }).click();
  const picture = await pictureOf(page);
  for (const colour of ['feed', 'part']) await expect.poll(() => pixels(picture, colour)).toBeGreaterThan(20);
  expect(await programOf(picture)).toBe(PROGRAM.replace('GO1', 'G01').replace('g1 ', 'G01 '));
  expect(refused).toEqual([]);

  // It follows the text and the cursor, and takes no key.
  await line(page, 'G00 X42').click();
  await page.keyboard.press('End');
  await page.keyboard.type(' M08');
  await expect.poll(() => programOf(picture)).toContain('G00 X42 Z2 M08\n');
  await expect.poll(() => cursorLineOf(picture)).toBe(5);
  await page.keyboard.press('ArrowDown');
  await expect.poll(() => cursorLineOf(picture)).toBe(6);
  await page.keyboard.type(' M09');
  await expect.poll(() => lines(page)).toContain('G01 X36 F0.2 M09');

  // A click on a stroke selects its block: the cut along the shoulder.
  await expect.poll(() => programOf(picture)).toContain('F0.2 M09\n');
  const at = await picture.evaluate(async () => {
    const element = document.querySelector<Picture>('gcode-playground')!;
    await element.settled;
    return element.locate(36, -10);
  });
  const frame = await (await picture.frameElement()).boundingBox();
  await page.mouse.click(frame!.x + at.clientX, frame!.y + at.clientY);
  await page.locator('.tab[data-resource-name="part.nc"]').click();
  await expect(page.locator('[id="status.editor.selection"]')).toHaveText('Ln 7, Col 9 (8 selected)');

  expect(refused).toEqual([]);
});
