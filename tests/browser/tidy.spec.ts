// "Format", "Renumber…" and "Convert…": the text changes, the program does not.
import { expect, test } from './engines';
import { choose, editor, open, settled, type, value } from './page';

test('a program is formatted in one step, which undo reverts', async ({ page }) => {
  await open(page);
  const text = 'g0x52z2\nG1  Z-20.F.2\nm30\n';
  await type(page, text);
  await settled(page);
  await choose(page, 'more', 'Format');
  await expect.poll(() => value(page)).toBe('G00 X52 Z2\nG01 Z-20. F.2\nM30\n');
  await expect(page.getByText('Formatted; the program is the same.')).toBeVisible();
  await choose(page, 'more', 'Format');
  await expect(page.getByText('The program is formatted already.')).toBeVisible();
  await editor(page).focus();
  await page.keyboard.press('Control+z');
  expect(await value(page)).toBe(text);
});

test('references follow new numbers, and a computed one keeps the old numbers', async ({ page }) => {
  await open(page);
  await type(page, 'N1 G00 X52 Z2\nN2 GOTO 4\nN3 X60\nN4 M30\n');
  await settled(page);
  await choose(page, 'more', 'Renumber…');
  const dialog = page.getByRole('dialog', { name: 'Renumber' });
  await dialog.getByLabel('First number').fill('100');
  await dialog.getByLabel('Step').fill('5');
  await dialog.getByRole('button', { name: 'Renumber', exact: true }).click();
  await expect(dialog).toBeHidden();
  expect(await value(page)).toBe('N100 G00 X52 Z2\nN105 GOTO 115\nN110 X60\nN115 M30\n');

  await choose(page, 'more', 'Renumber…');
  await dialog.getByRole('combobox').selectOption('none');
  await expect(dialog.getByLabel('Step')).toBeDisabled();
  await dialog.getByRole('button', { name: 'Renumber', exact: true }).click();
  await expect(dialog).toBeHidden();
  expect(await value(page)).toBe('G00 X52 Z2\nGOTO 115\nX60\nN115 M30\n');

  await type(page, 'G00 X52 Z2\nM30\n');
  await settled(page);
  await choose(page, 'more', 'Renumber…');
  await expect(dialog.getByRole('combobox')).toHaveValue('all');
  await dialog.getByRole('button', { name: 'Renumber', exact: true }).click();
  await expect(dialog).toBeHidden();
  expect(await value(page)).toMatch(/^N\d+ G00 X52 Z2\nN\d+ M30\n$/);

  const computed = 'N1 #1=3\nN2 GOTO #1\nN3 M30\n';
  await type(page, computed);
  await settled(page);
  await choose(page, 'more', 'Renumber…');
  await dialog.getByRole('combobox').selectOption('all');
  await dialog.getByRole('button', { name: 'Renumber', exact: true }).click();
  await expect(dialog.getByRole('status')).toContainText('Not renumbered. Line 2:');
  expect(await value(page)).toBe(computed);
});

test('a program is converted in one step, and a word that must stay is named', async ({ page }) => {
  await open(page);
  // From X20 Z-5, the first known position, by 10 mm on the diameter and -5 mm; the distance before it is unknown.
  const text = 'G00 U-4\nX20 Z-5\nG02 U10 W-5 R5 F.1\nM30\n';
  await type(page, text);
  await settled(page);
  const dialog = page.getByRole('dialog', { name: 'Convert' });
  const convert = async (form: string): Promise<void> => {
    await choose(page, 'more', 'Convert…');
    await dialog.getByRole('combobox').selectOption(form);
    await dialog.getByRole('button', { name: 'Convert', exact: true }).click();
  };
  await convert('absolute');
  await expect(dialog).toBeHidden();
  expect(await value(page)).toBe('G00 U-4\nX20 Z-5\nG02 X30 Z-10 R5 F.1\nM30\n');
  await expect(page.getByText('1 word stays: U-4 in line 1.')).toBeVisible();
  await convert('center');
  await expect(dialog).toBeHidden();
  expect(await value(page)).toBe('G00 U-4\nX20 Z-5\nG02 X30 Z-10 I5 K0 F.1\nM30\n');
  await convert('two-blocks');
  await expect(dialog.getByRole('status')).toHaveText('Nothing to convert: the program is already in this form.');
  await dialog.getByRole('combobox').selectOption('absolute');
  await expect(dialog.getByRole('status')).toHaveText('');
  await dialog.getByRole('button', { name: 'Convert', exact: true }).click();
  await expect(dialog.getByRole('status')).toHaveText('Not converted: U-4 in line 1 cannot be changed.');
  await page.keyboard.press('Escape');
  await editor(page).focus();
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await value(page)).toBe(text);
});
