// The table of supported codes: opened from the menu of the help, starts with the chosen control, filtered by typing.
import { expect, test, type Page } from './engines';
import { choose, chooseControl, open, type } from './page';

const dialog = (page: Page) => page.getByRole('dialog', { name: 'Supported codes' });
const headings = (page: Page) => dialog(page).getByRole('columnheader').locator('visible=true');
const row = (page: Page, code: string) =>
  dialog(page)
    .getByRole('row')
    .filter({ has: page.getByRole('rowheader', { name: code, exact: true }) });

async function openCodes(page: Page): Promise<void> {
  await choose(page, 'help', 'Supported codes');
  await expect(dialog(page)).toBeVisible();
}

test('the table is opened, filtered, read and closed by keyboard', async ({ page }, info) => {
  await open(page);
  await chooseControl(page, 'fanuc');
  await page.getByRole('button', { name: 'Help' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('menuitem', { name: 'Manual' })).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('menuitem', { name: 'Keys and gestures' })).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('menuitem', { name: 'Supported codes' })).toBeFocused();
  await page.keyboard.press('Enter');
  const filter = dialog(page).getByRole('searchbox', { name: 'Filter' });
  await expect(filter).toBeFocused();
  await expect(headings(page)).toHaveText(['FANUC A', 'What it does', 'FANUC B', 'FANUC C', 'GSK', 'Group']);
  await expect(row(page, 'G01')).toContainText('straight cut');
  const manual = row(page, 'G01').getByRole('link', { name: 'Manual: G01' });
  await expect(manual).toHaveAttribute('href', /\/manual\/en\/lines-and-arcs\.html#g01$/);
  await expect(row(page, 'M08')).toHaveCount(0);
  await expect(row(page, 'M07 M08 M09')).toContainText('no effect on the path');
  await expect(row(page, 'G51.2')).toContainText('not supported here');
  await page.screenshot({ path: info.outputPath('codes.png') });

  await page.keyboard.type('g1');
  await expect(dialog(page).getByRole('log')).toHaveText('1 row');
  await expect(row(page, 'G01')).toBeVisible();
  await filter.fill('G77');
  await expect(dialog(page).getByRole('rowheader').locator('visible=true')).toHaveText([
    'Single cycles',
    'G90',
    'Multiple repetitive cycles',
    'G75',
  ]);
  await expect(row(page, 'G90')).toContainText('G77');
  await filter.fill('thread');
  await expect(row(page, 'G76')).toBeVisible();
  await expect(row(page, 'G01')).toBeHidden();
  await filter.fill('quux');
  await expect(dialog(page).getByRole('log')).toHaveText('0 rows');
  await filter.fill('');
  await expect(row(page, 'G01')).toBeVisible();

  // Tab reaches the table, which the arrow keys then scroll; Shift Tab reaches the close button.
  await page.keyboard.press('Tab');
  await expect(dialog(page).getByRole('region', { name: 'Supported codes' })).toBeFocused();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Shift+Tab');
  await expect(dialog(page).getByRole('button', { name: 'Close' })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  await expect(page.getByRole('button', { name: 'Help' })).toBeFocused();
});

test('the control of the program comes first', async ({ page }) => {
  await open(page);
  await chooseControl(page, 'gsk');
  await openCodes(page);
  await expect(headings(page).first()).toHaveText('GSK');
  await expect(row(page, 'G33')).toContainText('tapping');
  await dialog(page).getByRole('button', { name: 'Close' }).click();

  // System B is recognised from the program.
  await chooseControl(page, 'fanuc');
  await type(page, 'O1\nG21 G95\nG92 S2000\nM3 S500\nG0 X50 Z2\nG77 X40 Z-20 F0.2\nM30\n');
  await openCodes(page);
  await expect(headings(page).first()).toHaveText('FANUC B');
  await expect(row(page, 'G77')).toContainText('turning cycle');
});
