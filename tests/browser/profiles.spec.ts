// Machines and tool tables are stored under names, and an exported file is a setup. Own programs start with the
// selected machine, which may be one of the examples; programs of the page keep their own setup.
import { readFileSync } from 'node:fs';
import { expect, test, type Locator, type Page, nightUnless } from './engines';
import {
  chip,
  chooseExample,
  chooseLanguage,
  copy,
  editor,
  locate,
  open,
  openFile,
  problems,
  reload,
  settled,
  status,
  titleText,
  value,
} from './page';

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

/** Opens the program, and waits until it has replaced the first one, which closes the popover. */
async function openOwnProgram(page: Page): Promise<void> {
  await openFile(page, 'own.nc', Buffer.from(PROGRAM));
  await expect.poll(() => value(page)).toBe(PROGRAM);
}

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
  await expect(page.getByText('Opened own.nc')).toBeVisible();
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
    await reload(page);
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

/**
 * 5000 mm of rapid along Z, 1000 mm along X (2000 on the diameter), then a cut of 100 mm at 0.1 mm/rev and 6000 rpm. At
 * the assumed rapid rate of 8 m/min: 37.5 s, 7.5 s and 10 s.
 */
const LONG = `O0001\nG21 G99 T0101\nG97 S6000 M3\n${'G0 Z-300\nZ200\n'.repeat(5)}${'X0\nX200\n'.repeat(5)}G1 Z100 F0.1\nM30\n`;

for (const { name, control, total, turret, end } of [
  // 5 m at 24 m/min, 1 m at 20 m/min, 100 mm at 5000 rpm: 12.5 s, 3 s, 12 s.
  { name: 'Small lathe, FANUC', control: 'FANUC', total: '0:27', turret: 'rear', end: 'Z-320' },
  // 500 in/min and 400 in/min, 3000 rpm: 23.622 s, 5.906 s, 20 s.
  { name: 'Small lathe in inches, FANUC', control: 'FANUC', total: '0:49', turret: 'rear', end: 'Z-508' },
  // 8 m/min and 4 m/min, 2000 rpm: 37.5 s, 15 s, 30 s.
  { name: 'Small lathe, GSK 980TD', control: 'GSK 980TD', total: '1:22', turret: 'front', end: 'Z-500' },
] as const) {
  test(
    `an example machine changes control, times and travel: ${name}`,
    nightUnless(name === 'Small lathe, GSK 980TD'),
    async ({ page }) => {
      const time = page.locator('[part~=time]');
      await open(page);
      await openFile(page, 'own.nc', Buffer.from(LONG));
      await expect(time).toHaveText('0:55');
      await openMachines(page);
      await expect(dialog(page).getByText('No machine is kept yet.')).toBeVisible();
      await expect(dialog(page).getByText(/^Example values/)).toBeVisible();
      await dialog(page)
        .getByRole('button', { name: `Use: ${name}`, exact: true })
        .click();
      await expect(page.getByText(`${name} is in the setup of this page now`)).toBeVisible();
      await expect(chip(page)).toContainText(control);
      await expect(time).toHaveText(total);
      await expectMachine(page, `Machine: ${name}`);
      expect((await locate(page, 50, 0)).y > (await locate(page, 0, 0)).y).toBe(turret === 'front');

      await test.step('its travel ends the path', async () => {
        await openFile(page, 'far.nc', Buffer.from(LONG.replace('Z-300', 'Z-600')));
        await expect(problems(page).getByText(`beyond the travel of the machine, which ends at ${end}`)).toBeVisible();
        await expectMachine(page, `Machine: ${name}`);
      });
      await test.step('it is marked in the list, and the next visit begins with it', async () => {
        await reload(page);
        await expectMachine(page, `Machine: ${name}`);
        await openMachines(page);
        await expect(dialog(page).getByText(`${name} (in use)`)).toBeVisible();
        await dialog(page).getByRole('button', { name: 'Use no machine' }).click();
        await expectMachine(page, 'Choose machine');
        expect(await setup(page)).toEqual({});
      });
    },
  );
}

test('the inch machine reads a program without G20 in inches', async ({ page }) => {
  await open(page);
  await openOwnProgram(page);
  await expect(chip(page)).toContainText('mm');
  await openMachines(page);
  await dialog(page).getByRole('button', { name: 'Use: Small lathe in inches, FANUC' }).click();
  await expect(chip(page)).toContainText('inch');
});

test('an example machine has its name in the language of the page', async ({ page }) => {
  await open(page);
  await openOwnProgram(page);
  await openMachines(page);
  await dialog(page).getByRole('button', { name: 'Use: Small lathe, GSK 980TD' }).click();
  await expectMachine(page, 'Machine: Small lathe, GSK 980TD');
  await chooseLanguage(page, 'ru');
  await chip(page).click();
  await expect(page.getByRole('button', { name: 'Станок: Малый станок, GSK 980TD' })).toBeVisible();
});
