// Access to the page: by keyboard alone, in three languages. Phones and dark mode are in phone.spec.ts. The screenshots
// in test-results are for manual review, not goldens.
import { expect, test } from './engines';
import { drawing, editor, examples, open, status, type } from './page';

test('gallery, editor, problems, playback, help and drawing are usable by keyboard alone', async ({ page }) => {
  await open(page);
  await page.getByLabel('Example').focus();
  // The list is loaded after the first picture.
  await expect(page.locator('#example option')).toHaveCount(examples.length);
  await page.keyboard.press('ArrowUp');
  await expect(page.getByLabel('Example')).not.toHaveValue('s000-o0002');
  await page.keyboard.press('ArrowDown');
  await expect(status(page)).toContainText(/^42 motions/);

  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('\nX');
  await expect(status(page)).toContainText('1 problem');
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('F8');
  await expect(editor(page)).toBeFocused();
  await page.keyboard.press('Control+Z');
  await expect(status(page)).toContainText('no problems');

  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  await page.keyboard.press('F9');

  // Tab leaves the editor, and reaches the drawing later.
  await page.keyboard.press('Tab');
  await expect(editor(page)).not.toBeFocused();
  for (let i = 0; i < 8 && !(await drawing(page).evaluate((canvas) => canvas.matches(':focus'))); i++) {
    await page.keyboard.press('Tab');
  }
  await expect(drawing(page)).toBeFocused();
  for (const key of ['ArrowLeft', '+', '-', 'f']) await page.keyboard.press(key);
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Keys and gestures' });
  await expect(help).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
});

test('in Chinese and Russian the page and its messages change, and the program does not', async ({ page }, info) => {
  await open(page);
  await type(page, 'G0 X50 Z2\nX\nM30');
  await expect(status(page)).toHaveText(/1 motion · \d lines · 1 problem/);
  const message = page
    .getByRole('region', { name: /^(Problems|问题|Замечания)$/ })
    .getByRole('listitem')
    .first();
  const english = await message.textContent();

  await page.getByLabel('Language').selectOption('zh');
  await expect(status(page)).toHaveText(/1 段运动 · \d 行 · 1 个问题/);
  await expect(page.getByRole('button', { name: '播放' })).toBeVisible();
  expect(await message.textContent()).not.toBe(english);
  await page.screenshot({ path: info.outputPath('zh.png') });

  await page.getByLabel('语言').selectOption('ru');
  await expect(status(page)).toHaveText(/1 перемещение · \d строки? · 1 замечание/);
  await expect(page.getByRole('button', { name: 'Пуск' })).toBeVisible();
  await expect(editor(page)).toContainText('G0 X50 Z2');
  await page.screenshot({ path: info.outputPath('ru.png') });

  await page.reload();
  await expect(status(page)).toContainText('перемещение');
});
