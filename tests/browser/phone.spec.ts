// On a phone and in dark mode: touch, a small screen and the system's colour scheme, which only Playwright can emulate.
// The screenshots in test-results are for manual review, not goldens.
import { chromiumTest as test, type ChromiumPage, expect } from './engines';
import { drawing, editor, open, play, status, tab } from './page';

test('a phone shows drawing, playback, program and status together, with no overflow', async ({
  browser,
  baseURL,
}, info) => {
  const context = await browser.newContext({
    ...(baseURL === undefined ? {} : { baseURL }),
    viewport: { width: 390, height: 844 },
    deviceScaleFactor: 2,
    isMobile: true,
    hasTouch: true,
    locale: 'en-US',
  });
  const page = (await context.newPage()) as ChromiumPage;
  await open(page);
  for (const part of [drawing(page), play(page), editor(page), status(page)]) {
    await expect(part).toBeInViewport();
  }
  const button = await play(page).boundingBox();
  expect(button?.height).toBeGreaterThanOrEqual(44);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await page.screenshot({ path: info.outputPath('phone.png') });
  await page.getByRole('button', { name: 'Settings' }).tap();
  await expect(page.getByLabel('Language')).toBeVisible();
  await page.screenshot({ path: info.outputPath('phone-settings.png') });
  await context.close();
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
  await page.getByLabel('Theme').selectOption('light');
  expect(await ground()).toBe(light);
  await page.emulateMedia({ colorScheme: 'light' });
  await page.getByLabel('Theme').selectOption('dark');
  expect(await ground()).toBe(dark);
});

test('the table of codes is shown in Chinese and Russian, in dark mode and on a phone', async ({
  page,
  browser,
  baseURL,
}, info) => {
  await open(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.getByLabel('Language').selectOption('zh');
  await page.getByRole('button', { name: '帮助 (?)' }).click();
  await page.getByRole('button', { name: '支持的代码' }).click();
  await expect(page.getByRole('dialog', { name: '支持的代码' })).toContainText('快速定位');
  await page.screenshot({ path: info.outputPath('codes-dark-zh.png') });

  const context = await browser.newContext({
    ...(baseURL === undefined ? {} : { baseURL }),
    viewport: { width: 390, height: 844 },
    deviceScaleFactor: 2,
    isMobile: true,
    hasTouch: true,
    locale: 'ru-RU',
  });
  const phone = (await context.newPage()) as ChromiumPage;
  await open(phone);
  await tab(phone, 'state').click();
  await phone.getByRole('button', { name: 'Справка (?)' }).tap();
  await phone.screenshot({ path: info.outputPath('help-phone.png') });
  await phone.getByRole('button', { name: 'Поддерживаемые коды' }).tap();
  const table = phone.getByRole('dialog', { name: 'Поддерживаемые коды' });
  await expect(table).toContainText('ускоренное перемещение');
  await phone.screenshot({ path: info.outputPath('codes-phone-ru.png') });
  await table.getByRole('searchbox').fill('G77');
  await expect(table.getByText('FANUC B: G77')).toBeVisible();
  await phone.screenshot({ path: info.outputPath('codes-phone-filter.png') });
  expect(await phone.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await context.close();
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
