// Lengths are shown in the unit of the program, or in the unit that the user selects.
import { expect, test, type Page } from './engines';
import {
  choose,
  chooseLanguage,
  editor,
  locate,
  open,
  openFile,
  openReading,
  problems,
  status,
  tooltip,
  value,
} from './page';

const TURNED =
  'O0001\n(STOCK D=50.8 LENGTH=101.6 FACE=0)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\nG20 G99\nT0101\nG97 S800 M3\nG0 X2.1 Z.1\nG1 X1.5 F.01\nZ-1.\nX2.1\nG0 X4. Z4.\nM30\n';
const cell = (page: Page, name: string) =>
  page.locator('.cell', { has: page.locator('dt', { hasText: new RegExp(`^${name}$`) }) }).locator('dd');
/** In the popover of the chip over the program. */
const button = (page: Page) => page.getByRole('button', { name: /^Lengths in / });
const [MM, INCH] = ['Lengths in mm: show them in inches', 'Lengths in inch: show them in mm'] as const;

async function load(page: Page, text: string): Promise<void> {
  await openFile(page, 'own.nc', Buffer.from(text));
  // The previous example has more motions.
  await expect(status(page)).toContainText(/^\d motion/);
}

test('an inch program is shown in inches, until the user selects mm', async ({ page }) => {
  await open(page);
  await openReading(page);
  await expect(button(page)).toHaveText(MM);
  await load(page, TURNED);
  await expect(button(page)).toHaveText(INCH);
  await editor(page).focus();
  for (let step = 0; step < 3; step++) await page.keyboard.press('F9');
  await expect(cell(page, 'X Ø, in')).toHaveText('1.5000');
  await expect(cell(page, 'Z, in')).toHaveText('−1.0000');
  await expect(cell(page, 'Feed')).toHaveText('0.01 in/rev · 8 in/min');
  await expect(cell(page, 'Cutting speed')).toHaveText('314 ft/min');
  await expect(page.locator('.doing')).toHaveText('line 9: feed to X1.5 Z-1');

  await button(page).click();
  await expect(button(page)).toHaveText(MM);
  await expect(cell(page, 'X Ø')).toHaveText('38.100');
  await expect(cell(page, 'Z')).toHaveText('−25.400');
  await expect(cell(page, 'Feed')).toHaveText('0.254 mm/rev · 203 mm/min');
  await expect(page.locator('.doing')).toHaveText('line 9: feed to X38.1 Z-25.4');

  await test.step('the selected unit is kept for other programs', async () => {
    await load(page, TURNED.replace('X1.5', 'X1.4'));
    await openReading(page);
    await expect(button(page)).toHaveText(MM);
    await button(page).click();
    await expect(button(page)).toHaveText(INCH);
    await load(page, 'O2\nG21\nG0 X50 Z2\nM30\n');
    await expect(button(page)).toHaveText(MM);
  });
});

test('dimensions, messages and totals use the displayed unit', async ({ page }) => {
  await open(page);
  await load(page, TURNED.replace('X2.1\nG0 X4.', 'G2 X2.1 Z-1.5 I.3 K0\nG0 X4.'));
  await expect(problems(page)).toContainText('0.3 in from the start but 0.5 in from the end');
  await openReading(page);
  await button(page).click();
  await expect(problems(page)).toContainText('7.62 mm from the start but 12.7 mm from the end');
  await button(page).click();
  await page.keyboard.press('Escape');

  await load(page, TURNED);
  const edge = await locate(page, -38.1, -12.7);
  await page.mouse.move(edge.x, edge.y);
  await expect(tooltip(page)).toContainText('Ø1.5, length 0.97');
  await choose(page, 'more', /^Time and totals: /);
  const totals = page.getByRole('dialog', { name: 'Time and totals' });
  await expect(totals).toContainText('Cut, in');
  await expect(totals).toContainText('1.5 … 2.1');
});

test('the setup form has the displayed unit, and entries that are not changed keep their digits', async ({ page }) => {
  await open(page);
  await load(page, TURNED.replace('LENGTH=101.6', 'LENGTH=101.7'));
  await page.getByRole('button', { name: /^Setup/ }).click();
  const stock = page.getByRole('dialog', { name: 'Setup' }).getByRole('region', { name: 'Stock' });
  const diameter = stock.getByLabel('Diameter', { exact: true });
  await expect(diameter).toHaveValue('2');
  await expect(stock.locator('.unit').first()).toHaveText('in');
  // 101.7 mm is 4.003937… in, and is written with its own digits again.
  await expect(stock.getByLabel('Length', { exact: true })).toHaveValue('4.00394');
  // 1.75 in is 44.45 mm.
  await diameter.fill('1.75');
  await page.getByRole('button', { name: 'Apply' }).click();
  await expect.poll(() => value(page)).toContain('(STOCK D=44.45 LENGTH=101.7');
});

test('the unit is named in Chinese and Russian', async ({ page }) => {
  await open(page);
  await load(page, TURNED);
  await chooseLanguage(page, 'zh');
  await openReading(page);
  await expect(page.getByRole('button', { name: '长度单位英寸：改为 mm' })).toBeVisible();
  await chooseLanguage(page, 'ru');
  await openReading(page);
  await page.getByRole('button', { name: 'Длины, дюймы: показать в мм' }).click();
  await expect(page.getByRole('button', { name: 'Длины, мм: показать в дюймах' })).toBeVisible();
});
