// The Learn pages: from the menu "Help", from page to page, with their elements and exercises, and without JavaScript.
import { chromiumTest as test, type BasicPage, type ChromiumPage, expect, nightUnless } from './engines';
import { choose, chooseLanguage, drawing, editor, goTo, open, openMenu, problemsButton, settled, value } from './page';

const WORDS = {
  en: { learn: 'Learn', first: 'X, Z and diameter', next: /^Next/, last: 'What a cycle is' },
  zh: { learn: '学习', first: 'X、Z 与直径', next: /^下一页/, last: '什么是循环' },
  ru: { learn: 'Обучение', first: 'X, Z и диаметр', next: /^Дальше/, last: 'Что такое цикл' },
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
    `Learn is the first entry of the menu "Help" and leads to all pages: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      await open(page);
      await chooseLanguage(page, language);
      await openMenu(page, 'help');
      await expect(page.getByRole('menuitem', { name: words.learn, exact: true })).toBeFocused();
      const lessons = await opened(page, () => page.keyboard.press('Enter'));
      await expect(lessons).toHaveURL(new RegExp(`/learn/${language}/index\\.html$`));
      await expect(heading(lessons)).toHaveText(words.learn);
      await lessons.getByRole('main').getByRole('link', { name: words.first }).first().click();
      await expect(heading(lessons)).toHaveText(words.first);
      for (let pages = 1; pages < 5; pages++) {
        const next = lessons.getByRole('link', { name: words.next });
        const file = (await next.getAttribute('href')) ?? '';
        await next.click();
        await expect(lessons).toHaveURL(new RegExp(`/${language}/${file}$`));
      }
      await expect(heading(lessons)).toHaveText(words.last);
      await expect(lessons.getByRole('link', { name: words.next })).toHaveCount(0);
    },
  );

  test(
    `every element shows its picture without a message, and no page is wider than a phone: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      await page.setViewportSize({ width: 390, height: 844 });
      for (const name of ['axes', 'moves', 'feed', 'program', 'cycles']) {
        await page.goto(`./learn/${language}/${name}.html`);
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
}

test('an exercise gives its message, and the program opens in the playground with the change', async ({ page }) => {
  await page.goto('./learn/en/axes.html');
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

test('a Learn page of the published element has its own copy of the element', async ({ page }) => {
  await page.goto('./embed/index.html#program=G00%20X50%20Z2');
  const lessons = await opened(page, () => choose(page, 'help', 'Learn'));
  await expect(lessons).toHaveURL(/\/embed\/learn\/en\/index\.html$/);
  await lessons.getByRole('link', { name: 'What a cycle is' }).click();
  await settled(lessons);
  await expect(drawing(lessons).first()).toBeVisible();
});

test('without JavaScript the text, the programs and the links remain', async ({ browser }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, viewport: { width: 390, height: 844 } });
  const page = (await context.newPage()) as ChromiumPage;
  await page.goto('./learn/en/moves.html');
  await expect(heading(page)).toHaveText('G00 and G01');
  await expect(page.getByText('G01 X60 Z-35')).toBeVisible();
  const box = await page.locator('gcode-playground').boundingBox();
  const text = await page.locator('gcode-playground pre').boundingBox();
  expect(box!.height).toBeGreaterThanOrEqual(text!.height);
  await page.getByRole('link', { name: /^Next/ }).click();
  await expect(heading(page)).toHaveText('Feed and speed');
  await page.getByRole('link', { name: 'Русский' }).click();
  await expect(heading(page)).toHaveText('Подача и частота вращения');
  await context.close();
});
