// The calculators: at a word of the program, and in the pages of the manual. The results are worked examples of the
// controls' manuals and of the standards.
import { type BasicPage, expect, type Locator, nightUnless, test } from './engines';
import { atCursor, chooseLanguage, editor, goTo, open, settled, type, value } from './page';

const LANGUAGES = ['en', 'zh', 'ru'] as const;
const R_OF_G90 = { en: 'R of G90', zh: 'G90 的 R', ru: 'R цикла G90' } as const;
const WRITE = { en: 'Write into the block', zh: '写入程序段', ru: 'Записать в кадр' } as const;
const NOT_A_NUMBER = { en: 'Enter a number.', zh: '请输入数字。', ru: 'Введите число.' } as const;

/** Seed 001: a cone from 20 mm to 40 mm over 25 mm, from Z2, with a wrong R. */
const PROGRAM = 'O1\nT0101\nG97 G99 S600 M03\nG00 X44 Z2\nG90 X40 Z-25 R-8 F0.2\nG00 X100 Z50\nM30\n';

/** Opens the calculator of R in the fifth line. */
async function openCalculator(page: BasicPage, language: (typeof LANGUAGES)[number]): Promise<Locator> {
  await open(page);
  await chooseLanguage(page, language);
  await type(page, PROGRAM);
  await goTo(page, 5, 'G90 X40 Z-25 R'.length - 1);
  await page.keyboard.press('F1');
  await atCursor(page)
    .getByRole('button', { name: `${R_OF_G90[language]}…` })
    .click();
  const dialog = page.getByRole('dialog', { name: R_OF_G90[language] });
  await expect(dialog).toBeVisible();
  return dialog;
}

for (const language of LANGUAGES)
  test(
    `R is calculated from the block, and written into it with one undo: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      const dialog = await openCalculator(page, language);
      const field = dialog.getByRole('textbox', { name: 'x1' });
      // R-8 over 27 mm leads to 40 - 2 · 8 · 25 / 27 at Z0.
      await expect(field).toHaveValue('25.185');
      const write = dialog.getByRole('button', { name: WRITE[language] });
      await expect(write).toBeDisabled();
      await field.fill('x');
      await expect(dialog.getByRole('alert').filter({ hasText: NOT_A_NUMBER[language] })).toBeVisible();
      await expect(field).toHaveAttribute('aria-invalid', 'true');
      await field.fill('20');
      await expect(dialog.getByRole('alert').filter({ hasText: NOT_A_NUMBER[language] })).toBeHidden();
      await expect(dialog.getByText(/^-10\.8\s/)).toBeVisible();
      await expect(dialog.getByRole('img')).toBeVisible();
      await write.click();
      await expect(dialog).toBeHidden();
      await expect.poll(() => value(page)).toBe(PROGRAM.replace('R-8', 'R-10.8'));
      await expect(editor(page)).toBeFocused();
      await page.keyboard.press('Control+z');
      await expect.poll(() => value(page)).toBe(PROGRAM);
    },
  );

/** The page, the calculator, a field with its new value, a result, and the block in the program. */
const IN_MANUAL = [
  ['passes-of-a-cone', 'cone', 'd', '30', '1:', '1', 'X50 Z-20'],
  ['passes-of-a-cone', 'passes-of-a-cone', 'n', '3', 'ΔZ', '8', 'R-16'],
  ['g90', 'r-of-g90', 'Za', '5', 'R', '-12', 'R-12'],
  ['g94', 'r-of-g94', 'Xa', '50', 'R', '-20', 'R-20'],
  ['threads', 'thread-by-name', '', 'M20x1,5', 'P', '1.5', 'F1.5'],
  ['threads', 'thread-height', 'P', '4', 'k', '2.454', 'P2454'],
  ['threads', 'run-in', 'a', '0.02', 'δ1', '1.618', 'Z1.618'],
  ['threads', 'thread-speed', 'P', '4', 'n', '220', 'G97 S220'],
  ['g76', 'passes-of-g76', 'd', '0', 'n', '12', 'R0'],
  ['g71-g72', 'passes-of-g71', 'Δd', '2.5', 'n', '8', 'U2.5'],
  ['g73', 'steps-of-g73', 'd', '5', 't', '4.5', 'G73 U18 R5'],
  ['g74-g75', 'columns-of-g75', 'Δk', '2.5', 'n', '6', 'Q2500'],
  ['speeds', 'speed', 'D', '30', 'n', '1061.033', 'G97 S1061'],
] as const;

for (const language of LANGUAGES)
  for (const [name, calculator, letter, entry, result, number, block] of IN_MANUAL)
    test(
      `the calculator ${calculator} in the manual follows its fields: ${language}`,
      nightUnless(language === 'en' && calculator === 'r-of-g90'),
      async ({ page }) => {
        await page.goto(`./manual/${language}/${name}.html`);
        const element = page.locator(`gcode-playground[calculator=${calculator}]`);
        await element.scrollIntoViewIfNeeded();
        const row = element.locator('.calculator-field').filter({ has: page.getByText(letter, { exact: true }) });
        const field = (letter === '' ? element.locator('.calculator-field').first() : row.first()).locator('input');
        await expect(field).toBeVisible();
        await field.fill(entry);
        const found = element.locator('dt').filter({ has: page.getByText(result, { exact: true }) });
        await expect
          .poll(() => found.first().evaluate((term) => term.nextElementSibling?.textContent ?? ''))
          .toMatch(new RegExp(`^${number.replace('.', '\\.')}(\\s|$)`));
        await expect
          .poll(() => element.evaluate((own) => (own as HTMLElement & { value: string }).value))
          .toContain(block);
        await settled(
          page,
          await element.evaluate((own) => [...document.querySelectorAll(own.localName)].indexOf(own)),
        );
      },
    );
