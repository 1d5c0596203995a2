// The command palette and the dialog "New program".
import { expect, test, type Page } from './engines';
import { choose, chooseLanguage, chip, editor, open, program, status, type, value } from './page';

const palette = (page: Page) => page.getByRole('dialog', { name: /^(Commands|命令|Команды)$/ });
const options = (page: Page) => palette(page).getByRole('option');

async function openPalette(page: Page): Promise<void> {
  await page.keyboard.press('Control+K');
  await expect(palette(page).getByRole('combobox')).toBeFocused();
}

test('the command palette finds every action by its name, and lists the last one first', async ({ page }) => {
  await open(page);
  await openPalette(page);
  const names = await options(page).evaluateAll((options) =>
    options.map(({ firstChild }) => firstChild?.textContent ?? ''),
  );
  // From each menu, from the panels, and from the edge of the picture.
  for (const name of [
    'New…',
    'My programs…',
    'Open file…',
    'Link, task, QR code…',
    'Motions',
    'Present',
    'Show all (F)',
  ])
    expect(names).toContain(name);
  expect(names).toContain('Theme: Dark');
  expect(names).not.toContain('');
  expect(new Set(names).size).toBe(names.length);
  await page.keyboard.insertText('motions');
  const found = await options(page).evaluateAll((options) => options.map(({ textContent }) => textContent));
  expect(found[0]).toBe('Motions');
  await page.keyboard.press('Enter');
  await expect(palette(page)).toBeHidden();
  await expect(page.getByRole('grid', { name: 'Motions in words' })).toBeVisible();
  await page.keyboard.press('Escape');
  await openPalette(page);
  await expect(options(page).first()).toHaveText('Motions');
  await page.keyboard.press('Escape');
  await expect(palette(page)).toBeHidden();
});

test('the command palette is in the language of the reader, and shows keys', async ({ page }) => {
  await open(page);
  await chooseLanguage(page, 'zh');
  await openPalette(page);
  await page.keyboard.insertText('播放');
  await expect(options(page).filter({ hasText: 'Ctrl Enter' })).toHaveCount(1);
  await page.keyboard.press('Escape');
  await chooseLanguage(page, 'ru');
  await openPalette(page);
  await page.keyboard.insertText('тёмная');
  await page.keyboard.press('Enter');
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
});

test('a new program has the chosen control, unit and blank, and the previous one is kept', async ({ page }) => {
  await open(page);
  await type(page, 'G99 S800 M03\nT0101\nG00 X42 Z2\nM30\n');
  await choose(page, 'program', 'New…');
  const dialog = page.getByRole('dialog', { name: 'New program' });
  await dialog.getByLabel('Control').selectOption('GSK');
  await dialog.getByLabel('Unit').selectOption('inch (G20)');
  // The proposed blank follows the unit.
  await expect(dialog.getByLabel('Diameter of the blank')).toHaveValue('2');
  await dialog.getByLabel('Diameter of the blank').fill('1.5');
  await dialog.getByRole('button', { name: 'Create' }).click();
  await expect(dialog).toBeHidden();
  await expect.poll(() => value(page)).toBe('O0001\nG20\n\nM30\n');
  await expect(chip(page)).toContainText('GSK');
  await expect(chip(page)).toContainText('in');
  // 1.5 inches in diameter, 3 inches long.
  const setup = await page.locator('gcode-playground').evaluate((element) => element.getAttribute('setup') ?? '{}');
  expect(JSON.parse(setup)).toMatchObject({ stock: { diameter: 38.1, length: 76.2 } });
  await choose(page, 'program', 'My programs…');
  await expect(page.getByRole('dialog', { name: 'My programs' })).toContainText('2 programs');
});

test('an empty program shows what to do', async ({ page }) => {
  await open(page);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await expect(page.locator('.cm-placeholder')).toBeVisible();
  await expect(status(page)).toBeVisible();
  await page.keyboard.press('Control+Z');
  await expect.poll(() => value(page)).toBe(program('s000-o0002'));
});
