// The reference: links from the menu of the help to a document, and between documents.
import { chromiumTest as test, expect, nightUnless } from './engines';
import { manual, openHtml } from './embedded';
import { choose, chooseLanguage, open, openMenu, settled } from './page';

for (const [language, link] of [
  ['en', 'Reference for developers'],
  ['zh', '开发者参考（英文）'],
  ['ru', 'Справочник разработчика (на английском)'],
] as const) {
  test(`the help leads to the reference: ${language}`, nightUnless(language === 'en'), async ({ page }) => {
    await open(page);
    await chooseLanguage(page, language);
    const [reference] = await Promise.all([page.waitForEvent('popup'), choose(page, 'help', link)]);
    await reference.waitForLoadState();
    expect(reference.url()).toMatch(/\/docs\/index\.html$/);
    await expect(reference.getByRole('heading', { level: 1 })).toHaveText('Reference');
  });
}

test('the help of the published element leads to its own copy of the reference', async ({ page }) => {
  await page.goto('./embed/index.html#program=G00%20X50%20Z2');
  const [reference] = await Promise.all([page.waitForEvent('popup'), choose(page, 'help', 'Reference for developers')]);
  await reference.waitForLoadState();
  expect(reference.url()).toMatch(/\/embed\/docs\/index\.html$/);
  await expect(reference.getByRole('heading', { level: 1 })).toHaveText('Reference');
  await reference.getByRole('link', { name: 'All rules' }).click();
  await expect(reference).toHaveURL(/\/embed\/rules\/en\/index\.html$/);
  await expect(reference.getByRole('heading', { level: 1 })).toHaveText('All rules');
});

test('attributes of the element set the folders of the documents and of the rule pages', async ({ page }) => {
  await openHtml(
    page,
    manual(
      '<gcode-playground docs="https://manual.example/lathe/docs" rules=""><pre>\nG00 X50 Z2\nM30\n</pre></gcode-playground>',
    ),
  );
  await settled(page);
  await openMenu(page, 'help');
  const reference = page.getByRole('menuitem', { name: 'Reference for developers' });
  await reference.focus();
  await expect(reference).toHaveAttribute('href', 'https://manual.example/lathe/docs/index.html');
  await expect(page.getByRole('menuitem', { name: 'All rules' })).toHaveCount(0);
  // The arrow keys skip the hidden item.
  await page.getByRole('menuitem', { name: 'Supported codes' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(reference).toBeFocused();
  await page.evaluate(() => document.querySelector('gcode-playground')!.setAttribute('rules', 'pages/'));
  const rules = page.getByRole('menuitem', { name: 'All rules' });
  await rules.focus();
  await expect(rules).toHaveAttribute('href', /^https?:.*\/pages\/en\/index\.html$/);
  const entry = page.getByRole('menuitem', { name: 'Manual' });
  await expect(entry).toHaveAttribute('href', /^https?:.*\/manual\/en\/index\.html$/);
  await page.evaluate(() => document.querySelector('gcode-playground')!.setAttribute('manual', 'lessons/'));
  await entry.focus();
  await expect(entry).toHaveAttribute('href', /^https?:.*\/lessons\/en\/index\.html$/);
  await page.evaluate(() => document.querySelector('gcode-playground')!.setAttribute('manual', ''));
  await expect(entry).toHaveCount(0);
});

test('links lead from one document to another, to a section of it, and back to the playground', async ({ page }) => {
  await page.goto('./docs/index.html');
  await page.getByRole('main').getByRole('link', { name: 'Supported codes' }).click();
  await expect(page).toHaveURL(/docs\/codes\.html$/);
  await expect(page.getByRole('cell', { name: 'turning cycle, straight or taper', exact: true })).toBeVisible();
  await page.getByRole('link', { name: 'encodings' }).click();
  await expect(page).toHaveURL(/docs\/command-line\.html#encodings$/);
  await expect(page.getByRole('heading', { name: 'Encodings' })).toBeVisible();
  await page.getByRole('navigation', { name: 'Reference' }).getByRole('link', { name: 'Glossary' }).click();
  await expect(page.getByRole('cell', { name: '刀尖方位号', exact: true })).toBeVisible();
  await page.getByRole('link', { name: 'G-code playground' }).click();
  await expect(page.locator('gcode-playground')).toBeVisible();
});

test('in a narrow window a wide table scrolls, not the page', async ({ page }) => {
  await page.setViewportSize({ width: 400, height: 800 });
  await page.goto('./docs/setup.html');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(wide).toBeLessThanOrEqual(0);
  const scrolls = await page.evaluate(() =>
    [...document.querySelectorAll('.table')].some((table) => table.scrollWidth > table.clientWidth),
  );
  expect(scrolls).toBe(true);
});
