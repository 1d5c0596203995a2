// The gallery: lazy loading, search, chapters, sources, and examples that are compared with another one.
import { expect, nightUnless, test, type Page } from './engines';
import {
  choose,
  chooseExample,
  chooseLanguage,
  editor,
  examples,
  motionCount,
  open,
  openFile,
  program,
  reload,
  status,
  titleText,
  type,
  value,
} from './page';

const gallery = (page: Page) => page.getByRole('dialog', { name: 'Gallery' });
/** Above the program: the source of the example and the changes against it. */
const source = (page: Page) => page.locator('#intro details');

const CHAPTERS = {
  en: {
    heading: 'G32, G92: threads',
    source: 'Source and changes',
    origin: 'Page of a GSK 980TD manual on G90 (Chinese), Fig. 3-58.',
    changed: 'X80 instead of X90 (line 7). X90 is printed twice',
    added: 'M03 S600 added (line 2), N140 M30 added (line 14).',
    unchanged: 'The program is unchanged.',
  },
  zh: {
    heading: 'G32、G92：螺纹',
    source: '出处与改动',
    origin: 'GSK 980TD 手册中 G90 的一页，图 3-58。',
    changed: 'X80，原文为 X90（第 7 行）。',
    added: '补充 M03 S600（第 2 行）；补充 N140 M30（第 14 行）。',
    unchanged: '程序与原文相同。',
  },
  ru: {
    heading: 'G32, G92: нарезание резьбы',
    source: 'Источник и изменения',
    origin: 'Страница руководства GSK 980TD о G90 (на китайском), рис. 3-58.',
    changed: 'X80 вместо X90 (строка 7). В ряду',
    added: 'добавлено M03 S600 (строка 2), добавлено N140 M30 (строка 14).',
    unchanged: 'Программа не изменена.',
  },
} as const;

for (const language of ['en', 'zh', 'ru'] as const) {
  const words = CHAPTERS[language];

  test(
    `chapters lead to the manual, and each example names its source and changes: ${language}`,
    nightUnless(language === 'en'),
    async ({ page }) => {
      await open(page, '#s000-o0002');
      await chooseLanguage(page, language);
      await expect(source(page)).not.toContainText(words.origin);
      await page.locator('#intro summary').click();
      await expect(source(page)).toContainText(words.source);
      await expect(source(page)).toContainText(words.origin);
      await expect(source(page)).toContainText(words.changed);
      await choose(page, 'program', /^(Gallery|全部示例|Все примеры)…$/);
      const dialog = page.getByRole('dialog');
      const threads = dialog.getByRole('heading', { name: words.heading }).getByRole('link');
      expect(await threads.getAttribute('href')).toMatch(new RegExp(`/manual/${language}/threads\\.html$`));
      const card = (id: string) => dialog.locator(`li[data-example="${id}"]`);
      await expect(dialog.locator('details')).toHaveCount(examples.length);
      await card('s003-g71').locator('summary').click();
      await expect(card('s003-g71').locator('details')).toContainText(words.added);
      // Opening the source does not choose the example.
      await expect(dialog).toBeVisible();
      await expect(card('s001-o0002').locator('details')).toContainText(words.unchanged);
    },
  );
}

test('an example is found by its topic, and opened', async ({ page }) => {
  await open(page);
  await choose(page, 'program', 'Gallery…');
  await expect(gallery(page).getByRole('status')).toHaveText(`${examples.length} examples`);
  await expect(gallery(page).getByRole('heading', { name: 'G32, G92: threads' })).toBeVisible();
  await test.step('each program with a cut has a picture', async () => {
    const drawn = await gallery(page)
      .getByRole('listitem')
      .evaluateAll((cards: readonly Element[]) =>
        cards.map((card) => card.querySelector('path.cut')?.getAttribute('d') ?? ''),
      );
    // G50 and G96 only set speeds; nothing moves.
    expect(drawn.filter((path) => path === '')).toHaveLength(1);
    expect(drawn.join(' ')).not.toContain('NaN');
  });
  await page.keyboard.type('g76 pull');
  await expect(gallery(page).getByRole('status')).toHaveText('No example matches.');
  await page.keyboard.press('Control+A');
  await page.keyboard.type('tapping');
  const card = gallery(page).getByRole('button', { name: /Tapping M10/ });
  await expect(card).toBeVisible();
  await card.click();
  await expect(gallery(page)).toBeHidden();
  await expect(status(page)).toContainText(`${motionCount('syn-g84-tap')} motions`);
  await expect(titleText(page)).toHaveText('Tapping M10: G84');
  expect(await value(page)).toBe(program('syn-g84-tap'));
});

test('the gallery opens at the current example, and no card is cut at the top', async ({ page }) => {
  for (const id of ['s000-o0002', 's001-frag-g90-taper', 'syn-g90-q4', 's003-g71', 's002-g121-square-asprinted']) {
    await open(page, `#${id}`);
    await choose(page, 'program', 'Gallery…');
    await expect(gallery(page).getByRole('status')).toHaveText(`${examples.length} examples`);
    const { current, cut } = await gallery(page).evaluate((dialog: Element) => {
      const list = dialog.querySelector('.chapters')?.getBoundingClientRect();
      if (list === undefined) throw new Error('no list');
      const cards = [...dialog.querySelectorAll('.card')].map((card) => {
        const { top, bottom } = card.getBoundingClientRect();
        return { current: card.hasAttribute('aria-current'), top, bottom };
      });
      const current = cards.find((card) => card.current);
      return {
        current: current !== undefined && current.top >= list.top - 1 && current.bottom <= list.bottom + 1,
        cut: cards.filter(({ top, bottom }) => top < list.top - 1 && bottom > list.top + 1).length,
      };
    });
    expect({ id, current, cut }).toEqual({ id, current: true, cut: 0 });
    await page.goto('about:blank');
  }
});

test('a URL selects an example, and changing the URL opens another one', async ({ page }) => {
  await open(page, '#s003-g71');
  await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  await page.locator('#intro summary').click();
  await expect(source(page)).toContainText('M03 S600 added (line 2), N140 M30 added (line 14).');
  await page.evaluate(() => {
    location.hash = '#s003-g74';
  });
  await expect(status(page)).toContainText(`${motionCount('s003-g74')} motions`);
  await expect(titleText(page)).toHaveText('Peck drilling with G74');
});

test('a URL with an unknown example opens the first example', async ({ page }) => {
  await open(page, '#no-such-example');
  await expect(status(page)).toContainText(`${motionCount('s001-o0001')} motions`);
});

test('the wrong part is compared with the right one, and the next example is shown without comparison', async ({
  page,
}) => {
  await open(page, '#s004-g94-wrong');
  const differences = page.getByRole('button', { name: 'End comparison' });
  await expect(differences).toBeVisible();
  expect(await value(page)).toBe(program('s004-g94-wrong'));
  await chooseExample(page, 'Facing with G94');
  await expect(status(page)).toContainText(`${motionCount('s001-frag-g94')} motions`);
  await expect(differences).toBeHidden();
  // Choosing it in the gallery has the same effect as the URL.
  await chooseExample(page, 'Start at X54 with R left at -20');
  await expect(differences).toBeVisible();
  expect(await value(page)).toBe(program('s004-g94-wrong'));
});

test('examples show no warnings except the ones they demonstrate', async ({ page }) => {
  await open(page);
  for (const id of ['s003-g71', 's003-g76', 's004-g94-right', 's001-o6003', 'syn-four-tools', 'syn-macro-ellipse']) {
    await page.evaluate((id) => void (location.hash = id), id);
    await expect(status(page)).toContainText(`${motionCount(id)} motions`);
    await expect(status(page)).toContainText('no problems');
  }
});

test('the description goes when the text is no longer the example, and comes back by undo', async ({ page }) => {
  await open(page, '#s000-o0002');
  const described = page.getByText(/^G90 takes the Ø125 blank to Ø120/);
  await expect(described).toBeVisible();
  const text = await value(page);
  // A small edit keeps it.
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.insertText('(MINE)');
  await expect.poll(() => value(page)).toBe(`(MINE)${text}`);
  await expect(described).toBeVisible();
  // The first lines alone: half of this text is from the example, but most of the example is gone.
  const rest = text.split('\n').slice(0, 3).join('\n');
  await type(page, `${rest}\nG00 X10\n`);
  await expect.poll(() => value(page)).toContain('G00 X10');
  await expect(described).toBeHidden();
  await expect(page.getByRole('button', { name: 'About this program' })).toBeHidden();
  await editor(page).focus();
  await expect(async () => {
    await page.keyboard.press('Control+Z');
    await expect(described).toBeVisible({ timeout: 500 });
  }).toPass({ timeout: 10_000 });
});

test('a word of a program does not break after its minus sign', async ({ page }) => {
  await open(page, '#s000-o0002');
  const unbroken = page.locator('#intro .unbroken');
  await expect(unbroken).toHaveText(['Z-30', 'R-7.5', 'R-30']);
  for (const word of await unbroken.all())
    expect(await word.evaluate((element) => getComputedStyle(element).whiteSpace)).toBe('nowrap');
  // The text that is copied is unchanged.
  await expect(page.locator('#intro p').first()).toContainText('four cycles from X120 Z-30 with R-7.5 to R-30');
});

test('the description of an example is hidden and shown by its button, which is remembered', async ({ page }) => {
  const about = page.getByRole('button', { name: 'About this program' });
  const shows = page.getByText(/^G71 cuts along Z, 2 mm in radius a pass/);
  await open(page, '#s003-g71');
  await expect(about).toHaveAttribute('aria-expanded', 'true');
  await expect(shows).toBeVisible();
  await about.click();
  await expect(about).toHaveAttribute('aria-expanded', 'false');
  await expect(shows).toBeHidden();
  await reload(page);
  await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  await expect(shows).toBeHidden();
  await about.click();
  await expect(shows).toBeVisible();
  // A file has no description.
  await openFile(page, 'mine.nc', Buffer.from('G00 X40 Z2\nG01 Z-10 F0.2\n'));
  await expect(titleText(page)).toHaveText('mine.nc');
  await expect(about).toBeHidden();
  await expect(shows).toBeHidden();
});
