// Navigation in a program: occurrences of a number, the outline, folding. By keyboard, in three languages.
import { expect, test, type BasicPage, type Locator, nightUnless } from './engines';
import { atCursor, chooseLanguage, editor, goTo, open, runAgain, selected, type } from './page';

const CONTOUR = [
  'O1000 (SHAFT)',
  '(ROUGHING)',
  'N1 T0101',
  'G96 S180 M03',
  'G00 X62 Z2',
  'G71 U2 R1',
  'G71 P10 Q20 U0.4 W0.1 F0.25',
  'N10 G00 X30',
  'G01 Z-20',
  'N20 X62',
  '(FINISHING)',
  'T0303',
  'G70 P10 Q20 F0.1',
  '#101=5',
  'G00 X[#101+95] Z100',
  'M30',
].join('\n');

const used = (page: BasicPage): Locator => page.locator('.cm-used-number');
const entries = (page: BasicPage): Locator => page.locator('.outline-entry');

test('F12 goes from P10 to N10, and Shift F12 back', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await goTo(page, 7, 'G71 P1'.length);
  await expect(used(page)).toHaveText(['P10', 'N10', 'P10']);
  await page.keyboard.press('F12');
  await expect.poll(() => selected(page)).toBe('N10');
  await page.keyboard.press('Shift+F12');
  // Back at the word it came from: typed text is inserted there.
  await expect(page.locator('.cm-activeLine')).toHaveText('G71 P10 Q20 U0.4 W0.1 F0.25');
  // A variable: from its assignment to where it is read.
  await goTo(page, 14, 2);
  await page.keyboard.press('F12');
  await expect.poll(() => selected(page)).toBe('#101');
  await expect(page.locator('.cm-activeLine')).toContainText('G00 X[#101+95]');
  // Where there is no number, the key shows its purpose.
  await goTo(page, 16, 3);
  await page.keyboard.press('F12');
  await expect(page.getByText('F12 goes from a sequence number')).toBeVisible();
});

test('the occurrences of the number at the cursor are listed and linked', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await goTo(page, 8, 2);
  await page.keyboard.press('F1');
  const places = atCursor(page).locator('.uses');
  await expect(places).toContainText('Places of N10');
  await expect(places.getByRole('listitem')).toHaveCount(3);
  // The content above the list arrives a moment later.
  await expect(atCursor(page)).toContainText('The control before and after line 8');
  await places.getByRole('button', { name: /13/ }).click();
  await expect(editor(page)).toBeFocused();
  await expect(page.locator('.cm-activeLine')).toContainText('G70 P10 Q20');
  // A word that is not a reference to a number has no occurrences.
  await goTo(page, 9, 1);
  await expect(places).toHaveCount(1);
  await expect(places).not.toBeVisible();
});

test('a button pressed during the next run has its usual effect', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await goTo(page, 8, 2);
  await page.keyboard.press('F1');
  const [place, since] = [
    atCursor(page).locator('.uses').getByRole('button', { name: /13/ }),
    atCursor(page).getByRole('button', { name: 'To line 4', exact: true }).first(),
  ];
  for (const [line, button, block] of [
    [8, place, 'G70 P10 Q20'],
    [13, since, 'G96 S180 M03'],
  ] as const) {
    await expect(atCursor(page)).toContainText(`The control before and after line ${line}`);
    await button.scrollIntoViewIfNeeded();
    const box = (await button.boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await runAgain(page);
    await page.mouse.up();
    await expect(editor(page)).toBeFocused();
    await expect(page.locator('.cm-activeLine')).toContainText(block);
  }
});

const OUTLINE = { en: 'Outline of the program', zh: '程序大纲', ru: 'Структура программы' } as const;

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(
    `the outline is searched and closed by keys alone, ${locale}`,
    nightUnless(locale === 'en'),
    async ({ page }) => {
      await open(page);
      await chooseLanguage(page, locale);
      await type(page, CONTOUR);
      await goTo(page, 13, 4);
      await page.keyboard.press('Control+Shift+O');
      const dialog = page.getByRole('dialog', { name: OUTLINE[locale] });
      await expect(dialog).toBeVisible();
      await expect(entries(page).first()).toContainText('O1000');
      await expect(entries(page).first()).toContainText('SHAFT');
      // The block at the cursor is selected.
      await expect(dialog.locator('[aria-selected=true]')).toContainText('G70 P10 Q20');
      await page.keyboard.insertText('rough');
      await expect(dialog.locator('[aria-selected=true]')).toContainText('ROUGHING');
      await page.keyboard.press('Enter');
      await expect(dialog).not.toBeVisible();
      await expect(editor(page)).toBeFocused();
      await expect(page.locator('.cm-activeLine')).toContainText('N1 T0101');
      // Closing the outline does not move the cursor.
      await page.keyboard.press('Control+Shift+O');
      await expect(dialog).toBeVisible();
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('Escape');
      await expect(dialog).not.toBeVisible();
      await expect(page.locator('.cm-activeLine')).toContainText('N1 T0101');
    },
  );
}

test('a button opens the outline, which shows a message if nothing is found', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await atCursor(page)
    .getByRole('button', { name: /^Outline/ })
    .click();
  const dialog = page.getByRole('dialog', { name: OUTLINE.en });
  await expect(dialog).toBeVisible();
  await page.keyboard.insertText('nowhere');
  await expect(dialog).toContainText('No entry contains these words.');
  await page.keyboard.press('Escape');
  await type(page, 'G00 X20 Z5');
  await atCursor(page)
    .getByRole('button', { name: /^Outline/ })
    .click();
  await expect(dialog).toContainText('There is nothing to list');
});

test('programs, tools and contours can be folded, and going to a folded line unfolds it', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await goTo(page, 3, 1);
  await expect(page.locator('.fold-sign[title=Fold]').first()).toBeVisible();
  // With Shift, the keyboard sends the brace.
  await page.keyboard.press('Control+Shift+{');
  const folded = page.locator('.folded-lines');
  await expect(folded).toHaveText(/^Show lines 4–/);
  await page.keyboard.press('Control+End');
  await page.keyboard.press('Control+Shift+O');
  // Text typed immediately goes into the outline, not into the program.
  await page.keyboard.insertText('G71');
  await expect(page.locator('.outline-entry[aria-selected=true]')).toContainText('G71');
  await page.keyboard.press('Enter');
  await expect(folded).toHaveCount(0);
  await expect(page.locator('.cm-activeLine')).toContainText('G71');
});
