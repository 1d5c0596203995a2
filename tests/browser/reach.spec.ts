// Access to the page: by keyboard alone, in three languages. Phones and dark mode are in phone.spec.ts. The screenshots
// in test-results are for manual review, not goldens.
import { expect, test } from './engines';
import { choose, drawing, editor, open, openProblems, problems, reload, status, title, titleText, type } from './page';

test('menus, gallery, editor, problems, playback, help and drawing are usable by keyboard alone', async ({ page }) => {
  await open(page);
  const first = await titleText(page).textContent();
  /** Opens a program of the gallery by a term that only it contains. */
  const openByKeyboard = async (term: string): Promise<void> => {
    await title(page).focus();
    await page.keyboard.press('Enter');
    await expect(page.getByRole('menuitem').first()).toBeFocused();
    // The first letter of "Gallery…".
    await page.keyboard.press('g');
    await expect(page.getByRole('menuitem', { name: 'Gallery…' })).toBeFocused();
    await page.keyboard.press('Enter');
    const gallery = page.getByRole('dialog', { name: 'Gallery' });
    await expect(gallery.getByRole('searchbox')).toBeFocused();
    await page.keyboard.type(term);
    // The heading of the chapter is a link, which not every engine reaches by Tab.
    const card = gallery.locator('button.card');
    await expect(card).toHaveCount(1);
    await expect(async () => {
      await page.keyboard.press('Tab');
      await expect(card).toBeFocused({ timeout: 500 });
    }).toPass();
    await page.keyboard.press('Enter');
    await expect(gallery).toBeHidden();
  };
  await openByKeyboard('s001-o6003');
  await expect(titleText(page)).toHaveText('Sleeve with an outer and an inner cone');
  await openByKeyboard('s000-o0002');
  await expect(titleText(page)).toHaveText(first ?? '');
  await expect(status(page)).toContainText(/^42 motions/);

  await test.step('arrows and first letters move in a menu, and Escape returns to its button', async () => {
    const more = page.getByRole('button', { name: 'More', exact: true });
    await more.focus();
    await page.keyboard.press('ArrowDown');
    await expect(page.getByRole('menuitemradio', { name: 'English' })).toBeFocused();
    await page.keyboard.press('ArrowDown');
    await expect(page.getByRole('menuitemradio', { name: '中文' })).toBeFocused();
    await page.keyboard.press('m');
    await expect(page.getByRole('menuitem', { name: 'Motions', exact: true })).toBeFocused();
    await page.keyboard.press('Escape');
    await expect(more).toBeFocused();
    await expect(more).toHaveAttribute('aria-expanded', 'false');
  });

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
  // The source of the example, At the cursor, outline, divider, the row over the drawing, the assumed blank, and a hint.
  for (let i = 0; i < 14 && !(await drawing(page).evaluate((canvas) => canvas.matches(':focus'))); i++) {
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
  await openProblems(page);
  const message = problems(page).getByRole('listitem').first();
  const english = await message.textContent();

  await choose(page, 'more', '中文');
  await expect(status(page)).toHaveText(/1 段运动 · \d 行 · 1 个问题/);
  await expect(page.getByRole('button', { name: '播放', exact: true })).toBeVisible();
  expect(await message.textContent()).not.toBe(english);
  await page.screenshot({ path: info.outputPath('zh.png') });

  await choose(page, 'more', 'Русский');
  await expect(status(page)).toHaveText(/1 перемещение · \d строки? · 1 замечание/);
  await expect(page.getByRole('button', { name: 'Пуск', exact: true })).toBeVisible();
  await expect(editor(page)).toContainText('G0 X50 Z2');
  await page.screenshot({ path: info.outputPath('ru.png') });

  await reload(page);
  await expect(status(page)).toContainText('перемещение');
});
