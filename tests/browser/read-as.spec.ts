// A chip always shows how the program was read. In its popover each value that depends on a setting links to its field.
// A message about a setting has a button that sets it.
import { expect, test, type Locator, type Page } from './engines';

import {
  chip,
  choose,
  chooseLanguage,
  editor,
  open,
  openFile,
  openProblems,
  openReading,
  problems,
  settled,
  value,
} from './page';

/** The popover of the chip. */
const reading = (page: Page): Locator => page.getByRole('dialog', { name: 'How the program was read' });
const form = (page: Page): Locator => page.getByRole('dialog', { name: 'Setup' });
const setup = async (page: Page): Promise<unknown> =>
  JSON.parse((await page.locator('gcode-playground').getAttribute('setup')) ?? '{}');

/** Opens a text as a file, and waits for its run. */
async function own(page: Page, text: string): Promise<void> {
  await openFile(page, 'own.nc', Buffer.from(text));
  await expect.poll(() => value(page)).toBe(text);
  await settled(page);
}

test('chip and popover show control, system, unit, point, feed, block skip and program, and marks recognised and set values', async ({
  page,
}) => {
  await open(page);
  await expect(chip(page)).toHaveText('GSK 980TD · mm · no point = mm · mm/min · block skip off · O0002');
  await chip(page).click();
  await expect(reading(page)).toContainText(
    'Read as GSK 980TD (set), mm, no point = mm, mm/min (set), block skip off, O0002',
  );
  await own(page, 'O0007\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nM30\n');
  await expect(reading(page)).toContainText(
    'Read as FANUC, system A, mm, no point = mm, mm/rev, block skip off, O0007',
  );
  await expect(chip(page)).toHaveText('FANUC · system A · mm · no point = mm · mm/rev · block skip off · O0007');
  await own(page, 'O0001\nG20 G99 T0101\nG97 S800 M3\nG0 X2. Z.1\nG1 X1. F.016\nZ-1.\nX2.\nG0 W2000\nM30\n');
  await expect(reading(page)).toContainText('inch, no point = 0.0001 in (recognised), in/rev');
  await own(
    page,
    'O0001\nG21 G95 G90\nG92 S2000\nT0101\nG96 S120 M3\nG0 X50 Z2\nG77 X40 Z-20 F0.2\nG0 X100 Z100\nM30\n',
  );
  await expect(reading(page)).toContainText('FANUC, system B (recognised)');
  await expect(chip(page)).toContainText('FANUC · system B');

  await test.step('in Chinese and Russian', async () => {
    await choose(page, 'more', '中文');
    await chip(page).click();
    await expect(page.getByRole('dialog', { name: '程序的读法' })).toContainText('体系 B（识别）');
    await choose(page, 'more', 'Русский');
    await chip(page).click();
    await expect(page.getByRole('dialog', { name: 'Как прочитана программа' })).toContainText('система B (распознано)');
  });
});

test('no line of the facts begins with a comma, in any width', async ({ page }) => {
  for (const language of ['en', 'zh', 'ru'] as const) {
    await open(page);
    await chooseLanguage(page, language);
    await openReading(page);
    // The popover is narrowed step by step, so that a line ends after each fact in turn.
    const commas = await page.locator('.facts-read').evaluate((line: HTMLElement) => {
      const found: number[] = [];
      for (let narrow = 120; narrow <= 420; narrow += 4) {
        line.style.inlineSize = `${narrow}px`;
        for (const span of line.querySelectorAll('.fact')) {
          const after = span.nextSibling;
          const text = after?.textContent ?? '';
          if (after === null || !/^[,，]/.test(text)) continue;
          const range = document.createRange();
          range.setStart(after, 0);
          range.setEnd(after, 1);
          const [comma, fact] = [range.getBoundingClientRect(), [...span.getClientRects()].at(-1)];
          if (fact === undefined || comma.left < fact.right - 1 || comma.top > fact.bottom) found.push(narrow);
        }
      }
      return found;
    });
    expect(commas, language).toEqual([]);
    await page.goto('about:blank');
  }
});

test('each value that depends on a setting links to its field', async ({ page }) => {
  await open(page);
  await own(page, 'O0007\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nM30\n');
  await chip(page).click();
  await reading(page).getByRole('button', { name: 'system A' }).click();
  await expect(form(page).getByLabel('G-code system')).toBeFocused();
  await form(page).getByRole('button', { name: 'Close' }).click();
  await expect(chip(page)).toBeFocused();
  await page.keyboard.press('Enter');
  await reading(page).getByRole('button', { name: 'Change…' }).focus();
  await page.keyboard.press('Enter');
  const control = form(page).getByLabel('Control', { exact: true });
  await expect(control).toBeFocused();
  await control.selectOption('gsk');
  await form(page).getByLabel('Feed mode at the start').selectOption('G98');
  await form(page).getByRole('button', { name: 'Apply' }).click();
  await expect(chip(page)).toContainText('GSK 980TD · mm · no point = mm · mm/min');
  await chip(page).click();
  await expect(reading(page)).toContainText('Read as GSK 980TD (set), mm, no point = mm, mm/min');
  expect(await setup(page)).toEqual({ dialect: { control: 'gsk', feedMode: 'G98' } });
});

test('a message about a setting has a button that sets it', async ({ page }) => {
  await open(page);
  const milling =
    'O0001\nG90 G54 G17\nT1 M6\nG43 H1 Z50.\nS1200 M3\nG0 X10. Y20.\nG1 Z-2. F200\nX40. Y35.\nG0 Z50.\nM30\n';
  await own(page, milling);
  await expect(chip(page)).toContainText('not run');
  await openProblems(page);
  await problems(page).getByRole('button', { name: 'Recognise programs for other controls' }).click();
  await expect(chip(page)).toHaveText(/^FANUC/);
  expect(await setup(page)).toEqual({ dialect: { recognise: false } });

  await test.step('a value that only the user knows is entered in the form', async () => {
    await own(page, 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nG53 X0 Z0\nM30\n');
    await openProblems(page);
    await problems(page).getByRole('button', { name: 'enter Reference point X' }).first().click();
    await expect(form(page).getByLabel('Reference point X (diameter)')).toBeFocused();
    await form(page).getByLabel('Reference point X (diameter)').fill('250');
    await form(page).getByRole('button', { name: 'Apply' }).click();
    await expect.poll(() => setup(page)).toEqual({ dialect: { refPoint: { x: 250, z: 300 } } });
    await expect(problems(page).getByRole('button', { name: 'enter Reference point X' })).toHaveCount(0);
  });
  await test.step('a setup in the program is changed in the program, and undo removes the change', async () => {
    const text =
      '(STOCK D=50 LENGTH=60)\nO0001\nT0101\nG97 S300 M3\nG0 X52 Z-10\nG75 R1\nG75 X40 Z-20 P3 Q3 F0.1\nG0 X100 Z100\nM30\n';
    await own(page, text);
    await openProblems(page);
    await problems(page)
      .getByRole('button', { name: /set P and Q of G74 to G76 to in mm/ })
      .first()
      .click();
    await expect.poll(() => value(page)).toContain('(DIALECT PQUNIT=MM)');
    await expect(problems(page).getByRole('button', { name: /set P and Q/ })).toHaveCount(0);
    await editor(page).focus();
    await page.keyboard.press('Control+z');
    await expect.poll(() => value(page)).toBe(text);
  });
});
