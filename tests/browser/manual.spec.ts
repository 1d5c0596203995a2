// The pages of the manual: from the menu "Help", from page to page, with their elements and exercises, and without JavaScript.
import { chromiumTest as test, type BasicPage, type ChromiumPage, expect, nightUnless } from './engines';
import { choose, chooseLanguage, drawing, editor, goTo, open, openMenu, problemsButton, settled, value } from './page';

const WORDS = {
  en: { manual: 'Manual', first: 'X, Z and diameter', next: /^Next/, last: 'A whole part: the sleeve O6003' },
  zh: { manual: '手册', first: 'X、Z 与直径', next: /^下一页/, last: '完整的零件：锥套 O6003' },
  ru: { manual: 'Руководство', first: 'X, Z и диаметр', next: /^Дальше/, last: 'Деталь целиком: втулка O6003' },
} as const;
const LANGUAGES = ['en', 'zh', 'ru'] as const;

const heading = (page: BasicPage) => page.getByRole('heading', { level: 1 });

/** The page that an action opens in a second tab. */
async function opened(page: ChromiumPage, action: () => Promise<void>): Promise<ChromiumPage> {
  const [other] = await Promise.all([page.waitForEvent('popup'), action()]);
  return other as ChromiumPage;
}

/** Number of pixels by which the page is wider than the window. */
const overflow = (page: BasicPage): Promise<number> =>
  page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

for (const language of LANGUAGES) {
  const words = WORDS[language];

  test(
    `Manual is the first entry of the menu "Help" and leads to all pages: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      await open(page);
      await chooseLanguage(page, language);
      await openMenu(page, 'help');
      await expect(page.getByRole('menuitem', { name: words.manual, exact: true })).toBeFocused();
      const lessons = await opened(page, () => page.keyboard.press('Enter'));
      await expect(lessons).toHaveURL(new RegExp(`/manual/${language}/index\\.html$`));
      await expect(heading(lessons)).toHaveText(words.manual);
      await lessons.getByRole('main').getByRole('link', { name: words.first }).first().click();
      await expect(heading(lessons)).toHaveText(words.first);
      // The way through has twelve chapters.
      for (let pages = 1; pages < 12; pages++) {
        const next = lessons.getByRole('link', { name: words.next });
        const file = (await next.getAttribute('href')) ?? '';
        await next.click();
        await expect(lessons).toHaveURL(new RegExp(`/${language}/${file}$`));
      }
      await expect(heading(lessons)).toHaveText(words.last);
    },
  );

  test(
    `every element shows its picture without a message, and no page is wider than a phone: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      await page.setViewportSize({ width: 390, height: 844 });
      for (const name of ['axes', 'moves', 'feed', 'program', 'cycles']) {
        await page.goto(`./manual/${language}/${name}.html`);
        await expect(page.locator('html')).toHaveAttribute('lang', language);
        const elements = await page.locator('gcode-playground').count();
        expect(elements, name).toBeGreaterThan(0);
        for (let at = 0; at < elements; at++) {
          await settled(page, at);
          const element = page.locator('gcode-playground').nth(at);
          await expect(element.getByRole('img').first()).toBeVisible();
          await expect(element.getByText(/no problems|没有问题|замечаний нет/).first()).toBeAttached();
        }
        expect(await overflow(page), name).toBeLessThanOrEqual(0);
      }
    },
  );

  test(
    `every page fits on a phone, and its figures are there: ${language}`,
    nightUnless(language === 'zh'),
    async ({ page }) => {
      await page.setViewportSize({ width: 390, height: 844 });
      await page.goto(`./manual/${language}/index.html`);
      const links = page.getByRole('main').getByRole('link');
      const files = new Set<string>();
      for (const link of await links.all()) files.add((await link.getAttribute('href')) ?? '');
      expect(files.size).toBeGreaterThanOrEqual(29);
      let figures = 0;
      for (const file of [...files].filter((file) => file.endsWith('.html'))) {
        await page.goto(`./manual/${language}/${file}`, { waitUntil: 'domcontentloaded' });
        const missing = await page.evaluate(async () => {
          const images = [...document.querySelectorAll<HTMLImageElement>('figure img')];
          const decoded = images.map(async (image) => {
            image.loading = 'eager';
            await image.decode().catch(() => undefined);
            return image.naturalWidth > 0 && image.alt !== '' ? [] : [image.src];
          });
          return { count: images.length, sources: (await Promise.all(decoded)).flat() };
        });
        expect(missing.sources, file).toEqual([]);
        figures += missing.count;
        expect(await overflow(page), file).toBeLessThanOrEqual(0);
      }
      expect(figures).toBeGreaterThanOrEqual(30);
    },
  );
}

for (const [language, query, page] of [
  ['en', 'g1', 'lines-and-arcs'],
  ['en', 'nose radius', 'nose-radius'],
  ['zh', '圆弧半径补偿', 'nose-radius'],
  ['zh', '精加工余量', 'g71-g72'],
  ['zh', 'G12.1', 'g12-1'],
  ['ru', 'полярная', 'g12-1'],
  ['ru', 'припуск', 'g71-g72'],
] as const)
  test(
    `the search finds ${query} in ${page}: ${language}`,
    nightUnless(query === '精加工余量'),
    async ({ page: tab }) => {
      await tab.goto(`./manual/${language}/index.html`);
      const field = tab.getByRole('searchbox');
      await field.click();
      await field.fill(query);
      const links = tab.getByRole('search').getByRole('link');
      await expect.poll(async () => (await links.allInnerTexts()).length).toBeGreaterThan(0);
      const files = await links.evaluateAll((all) => all.map((link) => link.getAttribute('href') ?? ''));
      expect(files.some((file) => file.startsWith(`${page}.html`))).toBe(true);
      await field.press('Enter');
      await expect.poll(() => tab.url()).not.toContain('index.html');
      await tab.goBack();
      await field.fill('qwertz');
      await expect(tab.getByRole('search').getByRole('status')).not.toBeEmpty();
      await expect(links).toHaveCount(0);
    },
  );

test('a page of a code has its words, and its row has an anchor', async ({ page }) => {
  await page.goto('./manual/en/g71-g72.html#g72');
  await expect(page.locator('#g72')).toBeInViewport();
  const words = page.getByRole('table').filter({ hasText: 'G71 FANUC A, FANUC B' }).first();
  await expect(words.getByRole('row').filter({ hasText: 'depth of cut' }).first()).toContainText('mm, radius');
});

test('an exercise gives its message, and the program opens in the playground with the change', async ({ page }) => {
  await page.goto('./manual/en/axes.html');
  await settled(page);
  await expect(drawing(page)).toBeVisible();
  await expect(problemsButton(page)).toHaveText(/no problems/);
  // Z-30 in line 6 becomes Z-60.
  await goTo(page, 6, 'G01 Z-'.length);
  await page.keyboard.press('Delete');
  await page.keyboard.type('6');
  await expect(problemsButton(page)).not.toHaveText(/no problems/);
  await problemsButton(page).click();
  await expect(page.getByText('The tool runs into the chuck').first()).toBeVisible();
  const playground = await opened(page, () => page.getByRole('link', { name: 'Open in the playground' }).click());
  await expect(editor(playground)).toContainText('Z-60');
  expect(await value(playground)).toContain('G01 Z-60 F0.2');
  // The blank and the tool come with it.
  await expect(problemsButton(playground)).toContainText(/\d/);
});

test('figures are printed with legible letters', async ({ page }) => {
  await page.emulateMedia({ media: 'print' });
  await page.goto('./manual/en/g71-g72.html');
  const figure = page.locator('figure img').first();
  await figure.scrollIntoViewIfNeeded();
  // 140 of 170 mm, in CSS pixels. On the screen the letters are 12 pixels high at 736 pixels.
  expect((await figure.boundingBox())?.width).toBeGreaterThan((140 / 25.4) * 96);
});

test('a page of the manual of the published element has its own copy of the element', async ({ page }) => {
  await page.goto('./embed/index.html#program=G00%20X50%20Z2');
  const lessons = await opened(page, () => choose(page, 'help', 'Manual'));
  await expect(lessons).toHaveURL(/\/embed\/manual\/en\/index\.html$/);
  await lessons.getByRole('link', { name: 'What a cycle is' }).click();
  await settled(lessons);
  await expect(drawing(lessons).first()).toBeVisible();
});

test('without JavaScript the text, the programs and the links remain', async ({ browser }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, viewport: { width: 390, height: 844 } });
  const page = (await context.newPage()) as ChromiumPage;
  await page.goto('./manual/en/moves.html');
  await expect(heading(page)).toHaveText('G00 and G01');
  await expect(page.getByText('G01 X60 Z-35')).toBeVisible();
  const box = await page.locator('gcode-playground').first().boundingBox();
  const text = await page.locator('gcode-playground pre').first().boundingBox();
  expect(box!.height).toBeGreaterThanOrEqual(text!.height);
  await page.getByRole('link', { name: /^Next/ }).click();
  await expect(heading(page)).toHaveText('Feed and speed');
  await page.getByRole('link', { name: 'Русский' }).click();
  await expect(heading(page)).toHaveText('Подача и частота вращения');
  await context.close();
});
