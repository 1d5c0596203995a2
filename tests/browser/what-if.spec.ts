// What-if values: another value for a variable is tried by keys alone, in three languages, without changing the text.
import { expect, test, type BasicPage, type Locator, nightUnless } from './engines';
import { atCursor, chooseLanguage, editor, goTo, open, runAgain, type, value } from './page';

const CALLS = [
  'O1',
  'T0101 M3 S500',
  '#1=40',
  'WHILE [#1 GT 30] DO1',
  'G65 P9 X#1',
  '#1=#1-5',
  'END1',
  'M30',
  'O9',
  'G00 X#24 Z2',
  'G01 Z-#24 F0.2',
  'M99',
].join('\n');

const IN_WORDS = {
  en: {
    pace: 'Speed and steps',
    speed: 'Speed',
    held: 'Paused before line 11',
    caller: 'called from line 5',
    next: 'The next time',
    tryIt: 'Try another value for #24 from here on',
    back: 'As written',
  },
  zh: {
    pace: '速度与步进',
    speed: '速度',
    held: '停在第 11 行之前',
    caller: '由第 5 行调用',
    next: '下一次',
    tryIt: '从此处起为 #24 试用另一个值',
    back: '恢复原文',
  },
  ru: {
    pace: 'Скорость и шаг',
    speed: 'Скорость',
    held: 'Пауза перед строкой 11',
    caller: 'вызвана из строки 5',
    next: 'Следующий раз',
    tryIt: 'Попробовать другое значение #24 с этого места',
    back: 'Как написано',
  },
} as const;

const cells = (page: BasicPage, name: string): Locator =>
  atCursor(page).locator('.state-table tr').filter({ hasText: name });

/** A hash of the section's pixels, once it is completely drawn. */
async function picture(page: BasicPage): Promise<number> {
  return page.locator('gcode-playground').evaluate(async (element) => {
    await (element as unknown as { settled: Promise<unknown> }).settled;
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const context = Object.assign(document.createElement('canvas'), {
      width: canvas.width,
      height: canvas.height,
    }).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    return context
      .getImageData(0, 0, canvas.width, canvas.height)
      .data.reduce((sum, byte) => (31 * sum + byte) % 1_000_000_007, 0);
  });
}

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(
    `inside a macro in a loop a variable gets another value, ${locale}`,
    nightUnless(locale === 'en'),
    async ({ page }) => {
      const words = IN_WORDS[locale];
      await open(page);
      await chooseLanguage(page, locale);
      await type(page, CALLS);
      await page.getByRole('button', { name: words.pace }).click();
      await page.getByRole('combobox', { name: words.speed, exact: true }).selectOption('50×');
      await page.keyboard.press('Escape');
      // Pause inside the macro, in the loop that calls it.
      await editor(page).focus();
      await page.keyboard.press('Control+End');
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Control+F8');
      await picture(page);
      await page.keyboard.press('Control+Enter');
      await expect(page.getByText(words.held)).toBeVisible();
      await page.keyboard.press('F1');
      await expect(cells(page, '#24')).toContainText('40');
      await expect(atCursor(page)).toContainText(words.caller);
      await atCursor(page).getByRole('button', { name: words.next }).focus();
      await page.keyboard.press('Enter');
      await expect(cells(page, '#24')).toContainText('35');
      const before = await picture(page);
      await atCursor(page).getByRole('button', { name: words.tryIt }).focus();
      await page.keyboard.press('Enter');
      await page.keyboard.type('90');
      await page.keyboard.press('Enter');
      // The value is marked in the text, above the picture and in the table; the path changes, the text does not.
      await expect(page.locator('.tried-value')).toContainText('#24 = 90');
      await expect(page.locator('.what-if')).toContainText('#24 = 90');
      expect(await value(page)).toBe(CALLS);
      expect(await picture(page)).not.toBe(before);
      await expect(cells(page, '#24')).toContainText('90');
      // One key restores the program.
      await page.getByRole('button', { name: words.back }).focus();
      await page.keyboard.press('Enter');
      await expect(page.locator('.tried-value')).toHaveCount(0);
      await expect(page.locator('.what-if')).not.toBeVisible();
      await expect(editor(page)).toBeFocused();
    },
  );
}

test('a value being typed is kept when the program runs again', async ({ page }) => {
  await open(page);
  await type(page, CALLS);
  await goTo(page, 6, 1);
  await page.keyboard.press('F1');
  await atCursor(page).getByRole('button', { name: 'Try another value for #1 from here on' }).focus();
  await page.keyboard.press('Enter');
  await page.keyboard.type('3');
  await runAgain(page);
  await page.keyboard.type('3');
  await page.keyboard.press('Enter');
  await expect(page.locator('.what-if')).toContainText('#1 = 33');
  expect(await value(page)).toBe(CALLS);
});
