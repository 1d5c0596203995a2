// On a phone and in dark mode: touch, a small screen and the system's colour scheme, which only Playwright can emulate.
// The screenshots in test-results are for manual review, not goldens.
import { chromiumTest as test, expect } from './engines';
import {
  choose,
  drawing,
  editor,
  linesInView,
  newPhonePage,
  open,
  play,
  problems,
  problemsButton,
  status,
  tab,
  title,
  type,
  value,
} from './page';

test('a phone shows title, drawing, playback, program and tabs together, with no overflow', async ({
  browser,
  baseURL,
}, info) => {
  const page = await newPhonePage(browser, baseURL);
  await open(page);
  for (const part of [title(page), drawing(page), play(page), editor(page), tab(page, 'problems')]) {
    await expect(part).toBeInViewport();
  }
  const button = await play(page).boundingBox();
  expect(button?.height).toBeGreaterThanOrEqual(44);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await page.screenshot({ path: info.outputPath('phone.png') });
  await page.getByRole('button', { name: 'More', exact: true }).tap();
  await expect(page.getByRole('menuitemradio', { name: 'English' })).toBeInViewport();
  await page.screenshot({ path: info.outputPath('phone-menu.png') });
  await page.keyboard.press('Escape');
  await expect(page.getByRole('menuitemradio', { name: 'English' })).toBeHidden();

  // The tab has the number of problems, also while another tab is selected.
  await type(page, 'G99 M3 S800\nG00 X50 Z2\nG01 X60 Z- F0.2\nM30');
  await expect(status(page)).toContainText(/\d problem/);
  const count = /(\d+) problem/.exec((await status(page).textContent()) ?? '')?.[1] ?? '';
  await expect(tab(page, 'problems')).toHaveText(`Problems ${count}`);
  await tab(page, 'problems').click();
  await expect(problems(page).getByRole('listitem').first()).toBeInViewport();
  await expect(drawing(page)).toBeInViewport();
  // The tab says it already.
  await expect(problemsButton(page)).toBeHidden();
  // A finger covers the place that it points at.
  await page.getByRole('img', { name: /tool path/ }).tap({ position: { x: 200, y: 60 } });
  await expect(page.locator('[part~=pointer]')).toBeHidden();
  await page.context().close();
});

test('above the keyboard of a phone are a row of keys and at least 8 lines of the program', async ({
  browser,
  baseURL,
}, info) => {
  // The keyboard takes 334 of 844 pixels; the page gets the rest.
  const page = await newPhonePage(browser, baseURL, { height: 510 });
  await open(page);
  const row = page.getByRole('toolbar', { name: 'Keys' });
  await expect(row).toBeHidden();
  await page.getByRole('textbox', { name: 'Program' }).tap();
  await expect(row).toBeVisible();
  // The row at the top, the playback and the tabs make room.
  for (const hidden of [title(page), play(page), tab(page, 'problems')]) await expect(hidden).toBeHidden();
  const first = ['Undo', '−', '.', ';', 'X', 'Z', 'G', 'F'];
  expect(
    (
      await row
        .getByRole('button')
        .evaluateAll((keys) => keys.map((key) => key.getAttribute('aria-label') ?? key.textContent))
    ).slice(0, 8),
  ).toEqual(first);
  for (const key of await row.getByRole('button').all()) {
    const box = await key.boundingBox();
    expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
  }
  expect(await linesInView(page)).toBeGreaterThanOrEqual(8);
  await page.screenshot({ path: info.outputPath('typing.png') });
  await page.keyboard.press('Control+End');
  for (const key of ['G', 'X', '−', '.', ';']) await row.getByRole('button', { name: key, exact: true }).tap();
  await expect.poll(() => value(page)).toContain('GX-.;');
  await expect(editor(page)).toBeFocused();
  await row.getByRole('button', { name: 'Undo' }).tap();
  await expect.poll(() => value(page)).not.toContain('GX-.;');
  await page.context().close();
});

test('on a phone a blank line offers a cycle under the tab Program, also with no keyboard on the screen', async ({
  browser,
  baseURL,
}, info) => {
  const page = await newPhonePage(browser, baseURL);
  await open(page);
  const insert = page.getByRole('button', { name: 'Insert cycle…' });
  await expect(insert).toBeHidden();
  await type(page, 'O1\nT0101\nG97 G99 S600 M03\nG00 X52 Z2\n');
  await expect(insert).toBeInViewport();
  await page.screenshot({ path: info.outputPath('insert.png') });
  await page.keyboard.press('ArrowUp');
  await expect(insert).toBeHidden();
  await page.keyboard.press('ArrowDown');
  await insert.tap();
  await page.getByRole('dialog').getByRole('button', { name: /^G71/ }).tap();
  await expect.poll(() => value(page)).toContain('G71 U2 R1');
  await page.context().close();
});

test('light and dark mode follow the system or the setting', async ({ page }, info) => {
  const ground = () => page.locator('body').evaluate((body) => getComputedStyle(body).backgroundColor);
  await open(page);
  await page.screenshot({ path: info.outputPath('wide.png') });
  const light = await ground();
  await page.emulateMedia({ colorScheme: 'dark' });
  const dark = await ground();
  expect(dark).not.toBe(light);
  await page.screenshot({ path: info.outputPath('dark.png') });
  await choose(page, 'more', 'Light');
  expect(await ground()).toBe(light);
  await page.emulateMedia({ colorScheme: 'light' });
  await choose(page, 'more', 'Dark');
  expect(await ground()).toBe(dark);
});

test('the table of codes is shown in Chinese and Russian, in dark mode and on a phone', async ({
  page,
  browser,
  baseURL,
}, info) => {
  await open(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await choose(page, 'more', '中文');
  await choose(page, 'help', '支持的代码');
  await expect(page.getByRole('dialog', { name: '支持的代码' })).toContainText('快速定位');
  await page.screenshot({ path: info.outputPath('codes-dark-zh.png') });

  const phone = await newPhonePage(browser, baseURL, { locale: 'ru-RU' });
  await open(phone);
  // On a phone "Help" is an item of the menu "More".
  await expect(phone.getByRole('button', { name: 'Справка', exact: true })).toBeHidden();
  const more = phone.getByRole('button', { name: 'Ещё', exact: true });
  await more.tap();
  const help = phone.getByRole('menuitem', { name: 'Справка' });
  const above = (await help.boundingBox())?.y;
  expect(above).toBeLessThan((await phone.getByRole('menuitemradio', { name: 'English' }).boundingBox())?.y ?? 0);
  await help.tap();
  await expect(phone.getByRole('menuitem', { name: 'Руководство' })).toBeInViewport();
  await phone.getByRole('menuitem', { name: 'Клавиши и жесты' }).tap();
  const keys = phone.getByRole('dialog', { name: 'Клавиши и жесты' });
  await expect(keys).toBeInViewport();
  await phone.screenshot({ path: info.outputPath('help-phone.png') });
  await keys.getByRole('button', { name: 'Закрыть' }).tap();
  await expect(keys).toBeHidden();
  await more.tap();
  await help.tap();
  await phone.getByRole('menuitem', { name: 'Поддерживаемые коды' }).tap();
  const table = phone.getByRole('dialog', { name: 'Поддерживаемые коды' });
  await expect(table).toContainText('ускоренное перемещение');
  await phone.screenshot({ path: info.outputPath('codes-phone-ru.png') });
  await table.getByRole('searchbox').fill('G77');
  await expect(table.getByText('FANUC B: G77')).toBeVisible();
  await phone.screenshot({ path: info.outputPath('codes-phone-filter.png') });
  expect(await phone.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await phone.context().close();
});

test('the page of a rule fits on a phone', async ({ page }) => {
  await page.setViewportSize({ width: 400, height: 800 });
  for (const name of ['index', 'rapid-through-stock']) {
    await page.goto(`./rules/ru/${name}.html`);
    // Make sure it is not the playground, which the server returns for a missing page.
    await expect(page.locator('html')).toHaveAttribute('lang', 'ru');
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(400);
  }
});
