// Where things stand: tabs where room is short.
import { expect, test } from './engines';
import { drawing, editor, open, problems, status, tab, type } from './page';

test('where height is short, tabs show program, problems and state; the drawing stays', async ({ page }) => {
  await page.setViewportSize({ width: 820, height: 420 });
  await open(page);
  await expect(tab(page, 'program')).toHaveAttribute('aria-selected', 'true');
  await expect(editor(page)).toBeVisible();
  await type(page, 'G0 X50 Z2\nX\nM30');
  await expect(tab(page, 'problems')).toContainText('1');

  await tab(page, 'problems').click();
  await expect(problems(page).getByRole('listitem')).toHaveCount(1);
  await expect(editor(page)).toBeHidden();
  await expect(drawing(page)).toBeVisible();
  await expect(page.getByRole('tabpanel', { name: /^Problems/ })).toBeVisible();
  // Arrows move among the tabs, round and round.
  await page.keyboard.press('ArrowRight');
  await expect(tab(page, 'state')).toHaveAttribute('aria-selected', 'true');
  await expect(status(page)).toContainText('1 motion');
  await expect(page.getByRole('button', { name: 'Help (?)' })).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(tab(page, 'drawing')).toHaveAttribute('aria-selected', 'true');
  await expect(drawing(page)).toBeVisible();
  await page.keyboard.press('ArrowLeft');
  await expect(tab(page, 'state')).toHaveAttribute('aria-selected', 'true');

  // A problem shows its block, wherever the reader is.
  await page.keyboard.press('F8');
  await expect(tab(page, 'program')).toHaveAttribute('aria-selected', 'true');
  await expect(editor(page)).toBeFocused();
  await tab(page, 'program').focus();
  await page.keyboard.press('ArrowRight');
  await problems(page).getByRole('listitem').getByRole('button').first().click();
  await expect(editor(page)).toBeFocused();
});

test('where there is room for everything there are no tabs', async ({ page }) => {
  await open(page);
  await type(page, 'G0 X50 Z2\nX\nM30');
  await expect(problems(page)).toBeVisible();
  await expect(tab(page, 'program')).toBeHidden();
  await expect(page.getByRole('tabpanel')).toHaveCount(0);
  await expect(status(page)).toBeVisible();
});
