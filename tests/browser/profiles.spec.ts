// Machines and tool tables are stored under names, and an exported file is a setup. Own programs start with the
// selected machine; programs of the page keep their own setup.
import { readFileSync } from 'node:fs';
import { expect, test, type Locator, type Page } from './engines';
import { chip, chooseExample, copy, editor, open, openFile, status, value, titleText } from './page';

const PROGRAM = 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX44\nG0 X100 Z100\nM30\n';
const SHOP = {
  dialect: { control: 'gsk', refPoint: { x: 250, z: 300 } },
  machine: { rapidX: 8000, turret: 'front' },
  tailstock: { z: 2, diameter: 20 },
};

const dialog = (page: Page): Locator => page.getByRole('dialog', { name: 'Machines and tool tables' });
/** The popover of the chip over the program. */
const reading = (page: Page): Locator => page.getByRole('dialog', { name: 'How the program was read' });
const machine = (page: Page): Locator => reading(page).getByRole('button', { name: /^(Choose machine|Machine: )/ });
const setup = async (page: Page): Promise<unknown> =>
  JSON.parse((await page.locator('gcode-playground').getAttribute('setup')) ?? '{}');

/** Waits until the run is over, so that the popover with the button does not move. */
const settled = async (page: Page): Promise<unknown> =>
  page
    .locator('gcode-playground')
    .evaluate((element) => (element as HTMLElement & { settled: Promise<number> }).settled);

async function openMachines(page: Page): Promise<void> {
  await settled(page);
  await chip(page).click();
  await machine(page).click();
  await expect(dialog(page)).toBeVisible();
}

/** Checks the text of the button in the popover of the chip. */
async function expectMachine(page: Page, text: string): Promise<void> {
  await chip(page).click();
  await expect(machine(page)).toHaveText(text);
  await chip(page).click();
  await expect(reading(page)).toBeHidden();
}

async function importProfile(page: Page, name: string, json: unknown): Promise<void> {
  await openMachines(page);
  await dialog(page)
    .locator('input[type=file]')
    .setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(json)) });
}

test('a machine is imported, used for own programs, and exported unchanged', async ({ page }) => {
  await open(page);
  await openFile(page, 'own.nc', Buffer.from(PROGRAM));
  await expect(page.getByText('own.nc').first()).toBeVisible();
  await expectMachine(page, 'Choose machine');
  await importProfile(page, 'Shop 1.json', SHOP);
  await expect(dialog(page).getByText('Shop 1 is kept.')).toBeVisible();
  await dialog(page).getByRole('button', { name: 'Use: Shop 1' }).click();
  await expect(chip(page)).toBeFocused();
  await expectMachine(page, 'Machine: Shop 1');
  expect(await setup(page)).toEqual(SHOP);
  await expect(chip(page)).toContainText('GSK 980TD');
  await chip(page).click();
  await expect(reading(page)).toContainText('GSK 980TD (set)');
  await page.keyboard.press('Escape');
  await expect(reading(page)).toBeHidden();
  await expect(chip(page)).toBeFocused();

  await test.step('the next program starts with the machine, and an example has its own setup', async () => {
    await chooseExample(page, 'Sleeve with an outer and an inner cone');
    await expect(titleText(page)).toHaveText('Sleeve with an outer and an inner cone');
    await expectMachine(page, 'Choose machine');
    await copy(page, PROGRAM);
    await editor(page).focus();
    await page.keyboard.press('Control+A');
    await page.keyboard.press('Control+V');
    await expectMachine(page, 'Machine: Shop 1');
    expect(await setup(page)).toEqual(SHOP);
    await page.reload();
    await expectMachine(page, 'Machine: Shop 1');
  });
  await test.step('the exported file is a setup', async () => {
    await openMachines(page);
    const download = page.waitForEvent('download');
    await dialog(page).getByRole('button', { name: 'Export: Shop 1' }).click();
    const file = await download;
    expect(file.suggestedFilename()).toBe('Shop 1.json');
    expect(JSON.parse(readFileSync(await file.path(), 'utf8'))).toEqual(SHOP);
  });
  await test.step('without the machine, the program runs with the defaults', async () => {
    await dialog(page).getByRole('button', { name: 'Use no machine' }).click();
    await expectMachine(page, 'Choose machine');
    expect(await setup(page)).toEqual({});
  });
});

test('machine and tools of a program are stored separately, and a file that is not a setup is rejected', async ({
  page,
}) => {
  await open(page);
  await openFile(page, 'own.nc', Buffer.from(`(TOOL T0101 TYPE=TURNING R=0.8)\n(MACHINE RAPIDX=9000)\n${PROGRAM}`));
  await expect(status(page)).toContainText(/^4 motions/);
  await openMachines(page);
  await dialog(page).getByLabel('Keep the tools of this program as').first().fill('Set A');
  await page.keyboard.press('Enter');
  await expect(dialog(page).getByText('Set A is kept.')).toBeVisible();
  await dialog(page).getByRole('button', { name: 'Close' }).click();

  await openFile(page, 'other.nc', Buffer.from(PROGRAM));
  await expect.poll(() => value(page)).toBe(PROGRAM);
  await openMachines(page);
  await dialog(page).getByRole('button', { name: 'Use: Set A' }).click();
  await expect.poll(() => setup(page)).toEqual({ tools: { T0101: { type: 'turning', noseRadius: 0.8 } } });

  await importProfile(page, 'bad.json', { stok: {} });
  await expect(dialog(page).getByText(/bad.json is not a setup: .*stok/)).toBeVisible();
  await dialog(page).getByRole('button', { name: 'Delete: Set A' }).click();
  await expect(dialog(page).getByText('No tool table is kept yet.')).toBeVisible();
});
