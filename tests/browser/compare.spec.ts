// Comparing the program with another version: pasted, from a link, from a file.
import { expect, test, type BasicPage, type Locator } from './engines';
import { choose, chooseExample, editor, open, type } from './page';

const PROGRAM =
  '(STOCK D=60 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X62 Z2\nG00 X50\nG01 Z-20 F0.2\nX56 Z-30\nG00 X100 Z100\nM30\n';
const OTHER = PROGRAM.replace('G00 X50\n', 'G00 X49.96\n');

const dialog = (page: BasicPage): Locator => page.getByRole('dialog');
const field = (page: BasicPage): Locator => dialog(page).getByRole('textbox');

async function openDialog(page: BasicPage): Promise<void> {
  await choose(page, 'more', 'Compare with another version…');
  await expect(dialog(page)).toBeVisible();
}

async function compareWith(page: BasicPage, text: string): Promise<void> {
  await field(page).fill(text);
  await dialog(page).getByRole('button', { name: 'Compare', exact: true }).click();
}

test('a pasted version is compared with the program: blocks, their effect, totals, paths', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await openDialog(page);
  await compareWith(page, OTHER);
  const status = dialog(page).getByRole('status');
  await expect(status).toHaveText('Text and motion differ; the text in 1 place.');
  const result = dialog(page).getByRole('region', { name: 'Comparison' });
  await expect(result).toContainText('G00 X49.96');
  await expect(result).toContainText('end point: X49.96 Z2 → X50 Z2');
  await expect(result).toContainText('Unchanged blocks whose motion differs from here on: 1');
  await expect(result).toContainText('end point: X49.96 Z-20 → X50 Z-20');
  await expect(result.getByRole('row', { name: 'tools T0101 T0101' })).toBeVisible();
  await expect(result.getByRole('img', { name: /^Tool paths of both/ })).toBeVisible();
  // The program is unchanged, and the pasted text is still in the field.
  await expect(field(page)).toHaveValue(OTHER);
  // A line number links to the line of the program.
  await result.getByRole('button', { name: /line 5$/ }).click();
  await expect(dialog(page)).toBeHidden();
  await expect(page.locator('.cm-activeLine')).toHaveText('G00 X50');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.type('/');
  await expect(editor(page)).toContainText('/G00 X50');
});

test('different number formats and blanks are no difference, and an empty field reports what is missing', async ({
  page,
}) => {
  await open(page);
  await type(page, PROGRAM);
  await openDialog(page);
  const status = dialog(page).getByRole('status');
  await compareWith(page, '  ');
  await expect(status).toContainText('There is no program yet');
  const numbered = PROGRAM.split('\n')
    .map((line, at) => (line === '' ? '' : `N${at + 1}0  ${line}`))
    .join('\n');
  await compareWith(page, numbered);
  await expect(status).toHaveText('No difference.');
});

test('a link contains the other version, and loads the macros that only it needs', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await openDialog(page);
  const macro = PROGRAM.replace('G00 X50\n', '#1=48\nG00 X#1\n');
  await compareWith(page, `https://playground.example/#program=${encodeURIComponent(macro)}`);
  await expect(dialog(page).getByRole('status')).toContainText('Text and motion differ');
  await expect(dialog(page)).toContainText('end point: X48 Z2 → X50 Z2');
});

test('a link that cannot be read reports why', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await openDialog(page);
  await compareWith(page, 'https://playground.example/#programs=O1');
  await expect(dialog(page).getByRole('status')).toHaveText('This address names no example, and holds no program.');
  await compareWith(page, OTHER);
  await expect(dialog(page).getByRole('status')).toContainText('Text and motion differ');
});

test('a stored program is chosen from a list', async ({ page }) => {
  await open(page);
  await type(page, OTHER);
  // The program is stored, then another one is started.
  await chooseExample(page, 'Tapping M10: G84');
  await expect(editor(page)).toContainText('G84');
  await openDialog(page);
  const own = dialog(page).getByRole('combobox', { name: 'Earlier states and my programs…' });
  await expect(own).toBeVisible();
  await own.selectOption('0');
  await expect(dialog(page).getByRole('status')).toContainText('Text and motion differ');
  await expect(dialog(page)).toContainText('G00 X49.96');
});

test('a text that is not a program is compared as text', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await openDialog(page);
  await compareWith(page, '<b id="no-markup">(((');
  await expect(dialog(page).getByRole('status')).toContainText('Text and motion differ');
  await expect(dialog(page)).toContainText('<b id="no-markup">(((');
  expect(await page.locator('#no-markup').count()).toBe(0);
});
