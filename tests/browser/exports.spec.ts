// Exported files: each kind is chosen from the menu "Share" and has the expected content.
import { expect, test, type Page } from './engines';
import { readFileSync } from 'node:fs';
import {
  choose,
  chooseFile,
  editor,
  motionCount,
  open,
  openFile,
  openMenu,
  settled,
  status,
  titleText,
  type,
} from './page';

const button = (page: Page) => page.getByRole('button', { name: 'Share' });
const menu = (page: Page) => page.getByRole('menu', { name: 'Share' });

/** Chooses a kind of file; returns its file name and bytes. */
async function save(page: Page, item: RegExp): Promise<{ name: string; bytes: Buffer; text: string }> {
  const saved = page.waitForEvent('download');
  await choose(page, 'share', item);
  const download = await saved;
  const bytes = readFileSync(await download.path());
  return { name: download.suggestedFilename(), bytes, text: bytes.toString('utf8') };
}

test('every kind of file contains the program', async ({ page }) => {
  await open(page, '#s003-g71');
  const motions = motionCount('s003-g71');
  await expect(status(page)).toContainText(`${motions} motions`);

  await test.step('card', async () => {
    const { name, text } = await save(page, /Setup sheet/);
    expect(name).toBe('setup-sheet.html');
    expect(text).toMatch(/^<!doctype html>/);
    for (const part of [
      '<h1>Setup sheet',
      '<svg ',
      '<code>G71 P50 Q120 U0.5 W0.2 F100</code>',
      'rough turning',
      '10 passes',
    ]) {
      expect(text).toContain(part);
    }
  });
  await test.step('drawing', async () => {
    const { name, text } = await save(page, /SVG/);
    expect(name).toBe('program.svg');
    expect(text).toMatch(/^<svg xmlns/);
    expect(text).toContain('class="part"');
  });
  await test.step('picture', async () => {
    const { name, bytes } = await save(page, /PNG/);
    expect(name).toBe('program.png');
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    const box = await page.getByRole('img', { name: /tool path/ }).boundingBox();
    expect(bytes.readUInt32BE(16)).toBe(Math.round(2 * (box?.width ?? 0)));
    expect(bytes.length).toBeGreaterThan(20_000);
  });
  await test.step('table', async () => {
    const { name, text } = await save(page, /CSV/);
    expect(name).toBe('program.csv');
    const lines = text.trimEnd().split('\r\n');
    expect(lines[0]).toMatch(/^line,kind,tool,x,z,/);
    expect(lines).toHaveLength(motions + 1);
  });
  await test.step('profile', async () => {
    const { name, text } = await save(page, /DXF/);
    expect(name).toBe('program.dxf');
    expect(text).toMatch(/^ {2}0\r\nSECTION\r\n/);
    expect(text).toContain('AC1009');
    // The ball nose and the fillet.
    expect(text.match(/\r\nARC\r\n/g)).toHaveLength(2);
    expect(text).toMatch(/\r\n 40\r\n5\.500000\r\n/);
    expect(text).toMatch(/\r\n 40\r\n7\.500000\r\n/);
  });
  await test.step('solid', async () => {
    const { name, bytes } = await save(page, /STL/);
    expect(name).toBe('program.stl');
    expect(bytes.length).toBe(84 + 50 * bytes.readUInt32LE(80));
    expect(bytes.length).toBeGreaterThan(100_000);
  });
  await test.step('expanded', async () => {
    const { name, text } = await save(page, /NC/);
    expect(name).toBe('program-plain.nc');
    expect(text).toContain('G01 X37.5 Z-60.3');
    expect(text).not.toMatch(/^\s*(N\d+\s*)?G7[01]\b/m);
  });
});

test('files are named after the opened file, and the program keeps its encoding', async ({ page }) => {
  await open(page);
  await chooseFile(
    page,
    'втулка.MPF.nc',
    new Uint8Array([
      0x28,
      0xc2,
      0xf2,
      0xf3,
      0xeb,
      0xea,
      0xe0,
      0x20,
      0xe4,
      0xeb,
      0xff,
      0x20,
      0xe2,
      0xe0,
      0xeb,
      0xe0,
      0x29,
      0x0a,
      ...Buffer.from('G0 X20 Z2\nG90 X18 Z-10 F0.2\nX16\nM30\n'),
    ]),
  );
  await expect(status(page)).toContainText('9 motions');
  const { name, bytes } = await save(page, /NC/);
  expect(name).toBe('втулка.MPF-plain.nc');
  expect(bytes.includes(Buffer.from([0xc2, 0xf2, 0xf3, 0xeb, 0xea, 0xe0]))).toBe(true);
  expect((await save(page, /Setup sheet/)).name).toBe('втулка.MPF-setup-sheet.html');
});

test('the menu works by keyboard', async ({ page }) => {
  await open(page);
  await button(page).focus();
  await page.keyboard.press('Enter');
  // The page's item precedes the items of the element.
  const first = page.getByRole('menuitem', { name: 'Link, task, QR code…' });
  const last = page.getByRole('menuitem', { name: 'Expanded program (NC)' });
  await expect(first).toBeFocused();
  await expect(button(page)).toHaveAttribute('aria-expanded', 'true');
  await page.keyboard.press('ArrowUp');
  await expect(last).toBeFocused();
  await page.keyboard.press('Home');
  await expect(first).toBeFocused();
  await page.keyboard.press('m');
  await expect(page.getByRole('menuitem', { name: 'Motions as a table' })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(menu(page)).toBeHidden();
  await expect(button(page)).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await expect(last).toBeFocused();
  const saved = page.waitForEvent('download');
  await page.keyboard.press('Enter');
  expect((await saved).suggestedFilename()).toBe('O0002-plain.nc');
  await expect(menu(page)).toBeHidden();
  await expect(button(page)).toBeFocused();
});

test('without a part the page shows a message', async ({ page }) => {
  // An example without a blank; without a cut, no blank can be assumed.
  await open(page, '#s003-g71');
  await type(page, 'G0 X20 Z2\nM30');
  await expect(status(page)).toContainText('1 motion ');
  await choose(page, 'share', /STL/);
  await expect(page.getByText('There is no part to export')).toBeVisible();
  await type(page, '');
  await expect(status(page)).toContainText('0 motions');
  await openMenu(page, 'share');
  for (const item of [/SVG/, /STL/, /NC/]) await expect(page.getByRole('menuitem', { name: item })).toBeDisabled();
  await expect(page.getByRole('menuitem', { name: 'Link, task, QR code…' })).toBeEnabled();
});

test('the printed sheet names the program, the start and the clamping of the blank', async ({ page }) => {
  await page.addInitScript(() => {
    window.print = () => {
      dispatchEvent(new Event('beforeprint'));
      const sheet = document.querySelector('gcode-playground')?.shadowRoot?.querySelector('.sheet');
      Reflect.set(window, 'printed', sheet?.textContent ?? '');
    };
  });
  await open(page);
  await openFile(page, 'shaft.nc', Buffer.from('O0042 (SHAFT)\nT0101\nG97 S800 M03\nG00 X42 Z2\nG01 Z-9 F0.2\nM30\n'));
  // The page sets the setup of the opened program together with its title.
  await expect(titleText(page)).toHaveText('shaft.nc');
  await page
    .locator('gcode-playground')
    .evaluate((element) => element.setAttribute('setup', '{"stock":{"diameter":46,"length":60,"grip":25}}'));
  await expect(page.getByRole('button', { name: /Ø46×60/ })).toBeVisible();
  await settled(page);
  await editor(page).focus();
  await page.keyboard.press('Control+P');
  const printed = (): Promise<string> => page.evaluate(() => String(Reflect.get(window, 'printed')));
  await expect.poll(printed).toContain('shaft.nc');
  expect(await printed()).toContain('Clamping length 25 mm');
  expect(await printed()).toContain('Blank out of the jaws: 35 mm');
  expect(await printed()).toMatch(/X \(diameter\) 200 mm \(assumed\), Z 200 mm \(assumed\)/);
});
