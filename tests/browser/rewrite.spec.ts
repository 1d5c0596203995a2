// Rewriting plain moves as a cycle.
import { expect, test, type Page } from './engines';
import { choose, editor, motionCount, open, problemsButton, program, status, type, value } from './page';

const dialog = (page: Page) => page.getByRole('dialog', { name: 'Write as a cycle' });

test('four moves become a G90, and undo restores them', async ({ page }) => {
  await open(page, '#s001-o0001');
  const motions = `${motionCount('s001-o0001')} motions`;
  await expect(status(page)).toContainText(motions);
  await choose(page, 'more', 'Write as a cycle…');
  const offer = dialog(page).getByRole('listitem');
  await expect(offer).toHaveCount(1);
  await expect(offer.getByRole('heading')).toHaveText('Write these four moves as G90');
  await expect(offer).toContainText('Lines 5 to 8');
  await expect(offer).toContainText('G90 X26 Z-30 F0.1');
  await dialog(page).getByRole('button', { name: 'Write it so' }).click();
  await expect(dialog(page)).toBeHidden();
  await expect.poll(() => value(page)).toBe(program('s001-o0002').replace('O0002', 'O0001'));
  await expect(status(page)).toContainText(motions);
  await expect(page.getByText('Written as G90')).toBeVisible();
  await expect(editor(page)).toBeFocused();
  await page.keyboard.press('Control+Z');
  await expect.poll(() => value(page)).toBe(program('s001-o0001'));
});

test('by keyboard, the blocks at the cursor are listed first', async ({ page }) => {
  await open(page);
  const cut = (x: number) => `G00 X${x}\nG01 Z-30 F0.1\nX62\nG00 Z2\n`;
  await type(page, `G00 X62 Z2\n${cut(56)}G00 X62 Z2 M08\nM09\n${cut(40)}`);
  await expect(status(page)).toContainText('9 motions');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Alt+Enter');
  const offers = dialog(page).getByRole('listitem');
  await expect(offers).toHaveCount(2);
  await expect(offers.first()).toContainText('G90 X40 Z-30');
  await page.keyboard.press('Enter');
  await expect.poll(() => value(page)).toBe(`G00 X62 Z2\n${cut(56)}G00 X62 Z2 M08\nM09\nG90 X40 Z-30 F0.1\n`);
  await expect(status(page)).toContainText('9 motions');
  await expect(problemsButton(page)).not.toHaveAttribute('aria-label', /error/);
});

test('for a program without such moves, the dialog explains which moves are needed', async ({ page }) => {
  await open(page, '#s001-o0002');
  await choose(page, 'more', 'Write as a cycle…');
  await expect(dialog(page)).toContainText('No plain moves of this program');
  await expect(dialog(page).getByRole('listitem')).toHaveCount(0);
  await page.keyboard.press('Escape');
  await choose(page, 'more', '中文');
  await choose(page, 'more', '写成循环…');
  await expect(page.getByRole('dialog', { name: '写成循环' })).toContainText('没有构成');
});
