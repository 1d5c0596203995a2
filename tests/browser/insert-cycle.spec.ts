// "Insert cycle…": offered in a blank line by the help at the cursor. A card with a figure inserts the whole cycle, and
// Tab leads through its fields.
import { chromiumTest, expect, test, type BasicPage, type Locator, nightUnless } from './engines';
import { atCursor, chooseLanguage, editor, goTo, newPhonePage, open, selected, type, value } from './page';

const HEAD = 'O1\nT0101\nG97 G99 S600 M03\nG00 X52 Z2\n';
const INSERT = /^(Insert cycle|插入循环|Вставить цикл)…$/;

const insert = (page: BasicPage): Locator => page.getByRole('button', { name: INSERT });
const chooser = (page: BasicPage): Locator =>
  page.getByRole('dialog', { name: /^(Insert a cycle|插入循环|Вставка цикла)$/ });
const card = (page: BasicPage, code: string): Locator =>
  chooser(page)
    .getByRole('button')
    .filter({ hasText: new RegExp(`^${code}\\b`) });

/** Types the head of a program; the cursor is in the blank line after it. */
async function typeHead(page: BasicPage): Promise<void> {
  await type(page, HEAD);
  await page.keyboard.press('Control+End');
  await expect(insert(page)).toBeVisible();
}

/** Fields of G71: U, the depth of cut, is 2; then R, the retract, is 1; then U, the allowance along X, is 0.4. */
const IN_WORDS = {
  en: {
    name: /rough turning/,
    depth: /2 mm.*depth of cut/,
    retract: /0\.8 mm.*escape/,
    allowance: /finishing allowance/,
  },
  zh: { name: /粗车循环/, depth: /2 mm.*切深/, retract: /0\.8 mm.*退刀量/, allowance: /精加工余量/ },
  ru: { name: /черновое точение/, depth: /2 мм.*глубина резания/, retract: /0\.8 мм.*отвода/, allowance: /припуск/ },
} as const;

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(
    `a cycle is inserted by its card, and the help follows Tab through its fields, ${locale}`,
    nightUnless(locale === 'en'),
    async ({ page }) => {
      const { name, depth, retract, allowance } = IN_WORDS[locale];
      await open(page);
      await chooseLanguage(page, locale);
      await typeHead(page);
      await insert(page).click();
      await expect(card(page, 'G71')).toBeVisible();
      const codes = await chooser(page)
        .locator('.cycle-code')
        .evaluateAll((codes) => codes.map(({ textContent }) => textContent));
      expect(codes.toSorted()).toEqual(['G71', 'G72', 'G73', 'G74', 'G75', 'G76', 'G83', 'G90', 'G92', 'G94']);
      expect(await chooser(page).getByRole('listitem').locator('svg').count()).toBe(codes.length);
      await expect(card(page, 'G71')).toContainText(name);
      await card(page, 'G71').click();
      await expect(chooser(page)).toBeHidden();
      await expect.poll(() => value(page)).toMatch(/X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0\.4 W0\.1 F0\.25\nN10 G00 X\d/);
      await expect(editor(page)).toBeFocused();
      expect(await selected(page)).toBe('2');
      await expect(atCursor(page)).toContainText(depth);
      await page.keyboard.press('Tab');
      await page.keyboard.type('0.8');
      await expect(atCursor(page)).toContainText(retract);
      await page.keyboard.press('Tab');
      await expect(atCursor(page)).toContainText(allowance);
      expect(await value(page)).toContain('\nG71 U2 R0.8\n');
    },
  );
}

test('one undo removes the whole cycle, but not the text before it', async ({ page }) => {
  await open(page);
  await typeHead(page);
  await page.keyboard.type('(ROUGH)');
  await page.keyboard.press('Enter');
  await insert(page).click();
  await card(page, 'G90').click();
  await expect.poll(() => value(page)).toContain('\nG90 X');
  await page.keyboard.type('47');
  await expect.poll(() => value(page)).toContain('\nG90 X47 ');
  await page.keyboard.press('Control+Z');
  await expect.poll(() => value(page)).toMatch(/\n\(ROUGH\)\nG90 X48 /);
  await page.keyboard.press('Control+Z');
  await expect.poll(() => value(page)).toBe(`${HEAD}(ROUGH)\n`);
});

test('Tab leads from the last field to the end, then leaves the editor; equal numbers are not marked', async ({
  page,
}) => {
  await open(page);
  await typeHead(page);
  await insert(page).click();
  await card(page, 'G92').click();
  await expect.poll(() => value(page)).toMatch(/\nG92 X49\.5 Z-20 F2$/);
  const matches = page.locator('.cm-selectionMatch');
  const isMarked = (): Promise<boolean> =>
    matches.evaluateAll((marks) => marks.some((mark) => getComputedStyle(mark).backgroundColor !== 'rgba(0, 0, 0, 0)'));
  for (const field of ['49.5', '-20', '2']) {
    await expect.poll(() => selected(page)).toBe(field);
    await page.waitForTimeout(200);
    expect(await isMarked(), field).toBe(false);
    await page.keyboard.press('Tab');
  }
  await expect(editor(page)).toBeFocused();
  await page.keyboard.press('Enter');
  await page.keyboard.type('X49');
  await expect.poll(() => value(page)).toMatch(/ F2\nX49$/);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await expect(editor(page)).not.toBeFocused();
});

test('a number typed in the last field stays when Tab leaves the field', async ({ page }) => {
  await open(page);
  await type(page, `${HEAD}G01 Z-5 F0.25\nX52 Z2\n`);
  await page.keyboard.press('Control+End');
  await insert(page).click();
  await card(page, 'G90').click();
  await expect.poll(() => selected(page)).not.toBe('');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await expect.poll(() => selected(page)).toMatch(/^0\./);
  await page.keyboard.type('0.2');
  await expect(page.getByRole('listbox')).toContainText('F0.25');
  await page.keyboard.press('Tab');
  await expect.poll(() => value(page)).toMatch(/\nG90 X\S+ Z\S+ F0\.2$/);
});

test('it is offered only in a blank line, and Escape inserts nothing', async ({ page }) => {
  await open(page);
  await expect(insert(page)).toBeHidden();
  await type(page, `${HEAD}\nG00 X60\nM30\n`);
  await goTo(page, 5);
  await expect(insert(page)).toBeVisible();
  await goTo(page, 6);
  await expect(insert(page)).toBeHidden();
  await goTo(page, 5);
  await page.keyboard.type('M8');
  await expect(insert(page)).toBeHidden();
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Backspace');
  await insert(page).click();
  await expect(chooser(page).getByRole('listitem').getByRole('button').first()).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(chooser(page)).toBeHidden();
  expect(await value(page)).toBe(`${HEAD}\nG00 X60\nM30\n`);
});

test('an empty program offers it, too, and the palette has it in a blank line', async ({ page }) => {
  await open(page);
  await type(page, '');
  await expect(insert(page)).toBeVisible();
  await page.keyboard.press('Control+K');
  await expect(page.getByRole('dialog', { name: 'Commands' }).getByRole('combobox')).toBeFocused();
  await page.keyboard.insertText('insert cycle');
  await page.keyboard.press('Enter');
  // By keys alone: the arrow keys move between the cards.
  await expect(chooser(page).getByRole('listitem').getByRole('button').first()).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(chooser(page).getByRole('listitem').getByRole('button').nth(1)).toBeFocused();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  await expect.poll(() => value(page)).toMatch(/^G71 U/);
});

test('in system C the cards have its codes, with the figures of the same cycles', async ({ page }) => {
  await open(page);
  await typeHead(page);
  await insert(page).click();
  const figure = (code: string): Promise<string> =>
    card(page, code)
      .locator('svg .part')
      .evaluate((part) => part.getAttribute('d') ?? '');
  const [rough, thread] = [await figure('G71'), await figure('G92')];
  await page.keyboard.press('Escape');
  await page.locator('gcode-playground').evaluate(async (element) => {
    element.setAttribute('setup', '{"dialect": {"gSystem": "C"}}');
    await (element as HTMLElement & { settled: Promise<number> }).settled;
  });
  await insert(page).click();
  await expect(card(page, 'G73')).toContainText('rough turning');
  expect(await figure('G73')).toBe(rough);
  await expect(card(page, 'G21')).toContainText('threading cycle');
  expect(await figure('G21')).toBe(thread);
});

test('the dialog is not loaded before it is opened', async ({ page }) => {
  const loaded = (): Promise<number> =>
    page.evaluate(
      () => performance.getEntriesByType('resource').filter(({ name }) => name.includes('/cycle-chooser-')).length,
    );
  await open(page);
  await typeHead(page);
  expect(await loaded()).toBe(0);
  await insert(page).click();
  await expect(chooser(page)).toBeVisible();
  expect(await loaded()).toBe(1);
});

chromiumTest('a phone offers it above the keyboard', async ({ browser, baseURL }, info) => {
  // With the keyboard open.
  const page = await newPhonePage(browser, baseURL, { height: 510, locale: 'ru-RU' });
  await open(page);
  await page.getByRole('textbox', { name: 'Программа' }).tap();
  await type(page, HEAD);
  await page.keyboard.press('Control+End');
  await expect(insert(page)).toBeInViewport();
  await page.screenshot({ path: info.outputPath('insert-cycle-line.png') });
  await page.getByRole('button', { name: 'Вставить цикл…' }).tap();
  await expect(card(page, 'G71')).toBeInViewport();
  const box = await card(page, 'G71').boundingBox();
  expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await page.screenshot({ path: info.outputPath('insert-cycle.png') });
  await page.getByRole('button', { name: /^G71 черновое точение/ }).tap();
  await expect.poll(() => value(page)).toMatch(/\nG71 U2 R1\n/);
  await expect(editor(page)).toBeFocused();
  // A key takes the place of Tab, until the last field is left.
  const next = page.getByRole('button', { name: 'Следующее число' });
  expect(await selected(page)).toBe('2');
  await next.tap();
  await expect.poll(() => selected(page)).toBe('1');
  await expect(editor(page)).toBeFocused();
  for (let field = 2; field < 9; field++) await next.tap();
  await expect(next).toBeVisible();
  await next.tap();
  await expect(next).toBeHidden();
  await page.context().close();
});
