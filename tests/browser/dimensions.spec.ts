// The menu "Dimensions": dimensions and letters in the picture.
import { expect, test, type Page } from './engines';
import { manual, openHtml } from './embedded';
import { goTo, open, settled, type, type Playground } from './page';
import { pixels } from './pixels';

const TAPER = 'G00 X62 Z2\nG90 X58 Z-25 R-10.8 F0.2\nG00 X100\nM30';

test('the word at the cursor draws its dimension, and another choice replaces it', async ({ page }) => {
  await open(page);
  await type(page, TAPER);
  await goTo(page, 4);
  await expect.poll(() => pixels(page, 'tool')).toBe(0);
  // an arrow, two extension lines, the angle and two labels.
  await goTo(page, 2, 13);
  await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(150);
  const word = await pixels(page, 'tool');

  const menu = page.getByRole('button', { name: 'Dimensions', exact: true });
  await menu.click();
  await expect(page.getByRole('menuitemradio', { name: 'Dimension of the word at the cursor' })).toBeChecked();
  await page.getByRole('menuitemradio', { name: 'No dimensions' }).click();
  await expect.poll(() => pixels(page, 'tool')).toBe(0);
  // The letters A, B, C and D, and the dimensions of X, Z and R.
  await menu.click();
  await page.getByRole('menuitemradio', { name: 'Letters and dimensions of the cycle' }).click();
  await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(word * 1.5);
  await menu.click();
  await page.getByRole('menuitemradio', { name: 'Dimensions of the part' }).click();
  await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(150);
  // The part keeps its dimensions while the cursor moves and the text changes.
  await goTo(page, 4);
  await type(page, TAPER.replace('X58', 'X57'));
  await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(150);
});

test('annotate chooses the dimensions of an element', async ({ page }) => {
  const element = (attributes: string): string =>
    manual(`<gcode-playground view="picture" ${attributes}><pre>\n${TAPER}\n</pre></gcode-playground>`);
  await openHtml(page, element(''));
  await settled(page);
  expect(await pixels(page, 'tool')).toBe(0);
  for (const choice of ['cycle', 'part']) {
    await openHtml(page, element(`annotate="${choice}"`));
    await settled(page);
    await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(150);
  }
});

/** A point of the section in the window: X as a diameter, mm. */
async function click(page: Page, x: number, z: number): Promise<void> {
  const { clientX, clientY } = await page.evaluate(
    ([x, z]) => document.querySelector<Playground>('gcode-playground')!.locate(x, z),
    [x, z] as const,
  );
  await page.mouse.click(clientX, clientY);
}

test('two clicks measure a distance, and one says what an edge is', async ({ page }) => {
  await open(page);
  // Ø40, then a cone to Ø50 over 20 mm, and a face at Z-45.
  await type(page, 'G00 X40 Z2\nG01 Z-25 F0.2\nX50 Z-45\nX62\nG00 X100 Z50\nM30');
  await page.getByRole('button', { name: 'Dimensions', exact: true }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Measure' }).click();
  const note = page.locator('.measuring');
  await expect(note).toContainText('Measure: click a corner, an edge or a line of the path.');
  const cursor = await page.locator('.cm-activeLine').textContent();

  await click(page, 40, -10);
  await expect(note).toContainText('Ø40');
  // From the cylinder to the other side of it.
  await click(page, -40, -15);
  await expect(note).toContainText('Along Z 0 · radial 40 · distance 40');
  await expect.poll(() => pixels(page, 'tool')).toBeGreaterThan(50);
  // The corners of the cone: 20 along Z and 5 on the radius, √425 = 20.616, arctan(5/20) = 14.04°.
  await click(page, 40, -25);
  await expect(note).toContainText('Ø40, Z−25');
  await click(page, 50, -45);
  await expect(note).toContainText('Along Z 20 · radial 5 · distance 20.616 · 14.04° to the axis');
  // A click selects no block meanwhile.
  await expect(page.locator('.cm-activeLine')).toHaveText(cursor!);

  await click(page, 58, -15);
  await expect(note).toContainText('No corner or edge here');
  await page.locator('canvas').first().focus();
  await page.keyboard.press('Escape');
  await expect(note).toBeHidden();
  await click(page, 45, -35);
  await expect(page.locator('.cm-activeLine')).toHaveText('X50 Z-45');
});
