// The table of motions in words: a text alternative of the drawing, navigated by keyboard, in sync with the tool.
import { expect, test, type Page } from './engines';
import { choose, chooseLanguage, drawing, editor, open, openFile, status } from './page';

const menu = (page: Page) => page.getByRole('button', { name: 'More', exact: true });
const table = (page: Page) => page.getByRole('grid', { name: 'Motions in words' });
const marked = (page: Page) => page.locator('.motions tr[aria-selected="true"]');
const TURNED = 'G99 M3 S800 T0101\nG0 X62 Z2\nG90 X55 Z-30 F0.2\nX50\nG0 X100 Z100\nM30\n';

async function load(page: Page, text: string, motions: string): Promise<void> {
  await openFile(page, 'own.nc', Buffer.from(text));
  await expect(status(page)).toContainText(new RegExp(`^${motions} motions`));
}

test('all motions are listed in words, and arrow keys move the tool', async ({ page }) => {
  await open(page);
  await load(page, TURNED, '10');
  const about = await drawing(page).first().getAttribute('aria-describedby');
  await expect(page.locator(`#${about ?? 'none'}`)).toHaveText('Its motions in words: menu More, Motions');
  // By keys alone: the first letter goes to the item.
  await menu(page).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('menuitem', { name: 'Motions', exact: true })).toBeVisible();
  await page.keyboard.press('m');
  await expect(page.getByRole('menuitem', { name: 'Motions', exact: true })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(table(page).getByRole('row')).toHaveCount(11);
  const row = (n: number) => table(page).getByRole('row').nth(n);
  await expect(row(3)).toContainText('G90, pass 1 of 2: cut at feed to X55 Z-30');
  await expect(row(1)).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(row(2)).toBeFocused();
  await expect(marked(page)).toContainText('infeed');
  // The effect of the row's block, for users of screen readers.
  const does = page.locator('.motions .does');
  await expect(does).toContainText('G90');
  await expect(does).toHaveAttribute('aria-live', 'polite');
  await expect(page.locator('.cm-running-line')).toHaveText('G90 X55 Z-30 F0.2');
  await page.keyboard.press('End');
  await expect(marked(page)).toContainText('rapid to X100 Z100');
  await expect(row(10)).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(table(page)).toBeHidden();
  await expect(menu(page)).toBeFocused();
});

test('the selected row follows the tool, and a click on a row moves the tool there', async ({ page }) => {
  await open(page);
  await load(page, TURNED, '10');
  await choose(page, 'more', 'Motions');
  await editor(page).focus();
  await page.keyboard.press('F9');
  await page.keyboard.press('F9');
  await page.keyboard.press('F9');
  await expect(marked(page)).toContainText('pass 1 of 2: cut at feed to X55 Z-30');
  await expect(editor(page)).toBeFocused();
  await table(page).getByRole('row').nth(7).click();
  await expect(marked(page)).toContainText('pass 2 of 2');
  await expect(page.locator('.doing')).toContainText('G90, pass 2 of 2');

  await test.step('the table is updated after an edit and a change of language', async () => {
    await load(page, TURNED.replace('X50', 'X48'), '10');
    await expect(table(page)).toContainText('cut at feed to X48 Z-30');
    await chooseLanguage(page, 'zh');
    await expect(page.getByRole('grid', { name: '动作的文字说明' })).toContainText('第 2 刀');
  });
});

test('for a long program, the page only contains the rows around the tool', async ({ page }) => {
  await open(page);
  const lines = Array.from(
    { length: 5000 },
    (_, at) => `G1 X${(20 + (at % 50) / 10).toFixed(1)} Z${(-at / 100).toFixed(2)}`,
  );
  await load(page, `G99 M3 S800 T0101\nG0 X30 Z2\nG1 F0.2\n${lines.join('\n')}\nM30\n`, '5,001');
  await choose(page, 'more', 'Motions');
  await expect(table(page).getByRole('row').nth(1)).toBeFocused();
  await page.keyboard.press('End');
  await expect(marked(page)).toContainText('Z-49.99');
  expect(await table(page).getByRole('row').count()).toBeLessThan(100);
  await expect(table(page)).toHaveAttribute('aria-rowcount', '5002');
  await page.keyboard.press('Home');
  await expect(marked(page)).toContainText('rapid to X30 Z2');
  await page.getByRole('button', { name: 'Later motions' }).click();
  await expect(table(page).getByRole('row').nth(1)).toContainText('31');
});
