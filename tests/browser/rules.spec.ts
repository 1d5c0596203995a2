// The pages of the rules: from a message to its page, in each language, and back with the program.
import { expect, test, type Page, nightUnless } from './engines';
import {
  chip,
  choose,
  editor,
  open,
  openMenu,
  openProblems,
  problems,
  problemsButton,
  reload,
  type,
  value,
} from './page';

const FAULTY = 'O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X52 Z M08\nG00 X200 Z200 M09\nM30';

/** Clicks a link that opens another tab. */
async function follow(page: Page, click: () => Promise<void>): Promise<Page> {
  const [opened] = await Promise.all([page.waitForEvent('popup'), click()]);
  await opened.waitForLoadState();
  return opened;
}

for (const [language, name, more, heading, failing] of [
  ['en', 'English', 'More', 'Repair', 'Failing'],
  ['zh', '中文', '详情', '如何改正', '有误的程序'],
  ['ru', 'Русский', 'Подробнее', 'Как исправить', 'С ошибкой'],
] as const) {
  test(`a message leads to the page of its rule: ${language}`, nightUnless(language === 'en'), async ({ page }) => {
    await open(page);
    await choose(page, 'more', name);
    await type(page, FAULTY);
    await openProblems(page);
    const link = problems(page).getByRole('link', { name: more });
    // Until the text is typed, the link belongs to the empty program.
    await expect(link).toHaveAttribute('href', /number-missing/);
    await expect(link).toHaveCount(1);
    await expect(link).toHaveAttribute('rel', 'noopener');
    const rule = await follow(page, () => link.click());
    expect(rule.url()).toMatch(new RegExp(`/rules/${language}/number-missing\\.html$`));
    await expect(rule.locator('html')).toHaveAttribute('lang', language);
    await expect(rule.getByRole('heading', { name: heading, exact: true })).toBeVisible();
    await expect(rule.getByRole('heading', { name: failing, exact: true })).toBeVisible();
    await expect(rule.locator('mark')).toHaveText('Z');
    await expect(rule.getByText('(RULES number-missing=OFF)')).toBeVisible();
    const pictures = rule.getByRole('img');
    await expect(pictures).toHaveCount(2);
    for (const picture of await pictures.all()) {
      await picture.scrollIntoViewIfNeeded();
      await expect(picture).toHaveJSProperty('complete', true);
      expect(await picture.evaluate((image) => (image as HTMLImageElement).naturalWidth)).toBeGreaterThan(100);
    }
  });
}

test('the tooltip of a problem links to the page as well', async ({ page }) => {
  await open(page);
  await type(page, FAULTY);
  await page.locator('.cm-lintRange-error').first().hover();
  const rule = await follow(page, () => page.locator('.cm-tooltip').getByRole('link', { name: 'More' }).click());
  await expect(rule).toHaveURL(/rules\/en\/number-missing\.html$/);
});

test('both programs open in the playground, in the language of the page', async ({ page }) => {
  await page.goto('./rules/ru/number-missing.html');
  const rule = page.url();
  const found = page.getByRole('region', { name: 'Замечания' });
  for (const which of [0, 1]) {
    await page.goto(rule);
    const listing = await page.locator('pre').nth(which).textContent();
    await page.getByRole('link', { name: 'Открыть в песочнице' }).nth(which).click();
    await expect(editor(page)).toBeVisible();
    expect(await value(page)).toBe(listing?.trimEnd());
    if (which === 0) await expect(found).toContainText('PS0005');
    else {
      await expect(problemsButton(page)).toHaveText('✓ замечаний нет');
      await expect(found).toBeHidden();
    }
  }
});

test('a changed program of a URL is stored, and restored', async ({ page }) => {
  await open(
    page,
    `#program=${encodeURIComponent('O0001\nG00 X20 Z2\nM30')}&setup=${encodeURIComponent('{"dialect": {"control": "gsk"}}')}`,
  );
  await expect(chip(page)).toContainText('GSK 980TD');
  expect(await value(page)).toBe('O0001\nG00 X20 Z2\nM30');
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('\nO0002\nM99');
  await expect(page).toHaveURL(/\/$/);
  await reload(page);
  await expect(editor(page)).toContainText('O0002');
  await expect(chip(page)).toContainText('GSK 980TD');
});

test('an invalid setup in a URL is reported, and is not fatal', async ({ page }) => {
  await open(page, '#program=M30&setup=nonsense');
  expect(await value(page)).toBe('M30');
  await expect(
    page
      .locator('gcode-playground')
      .getByRole('alert')
      .or(page.getByText(/setup was not accepted/))
      .first(),
  ).toBeVisible();
});

test('the list of all rules links to each of them', async ({ page }) => {
  await open(page);
  await openMenu(page, 'help');
  const list = await follow(page, () => page.getByRole('menuitem', { name: 'All rules' }).click());
  const links = list.getByRole('table').getByRole('link');
  expect(await links.count()).toBeGreaterThan(2);
  for (const href of await links.evaluateAll((all) => all.map((link) => (link as HTMLAnchorElement).href))) {
    expect((await fetch(href)).ok, href).toBe(true);
  }
  await list.getByRole('link', { name: 'Русский' }).click();
  await expect(list.getByRole('heading', { name: 'Все правила' })).toBeVisible();
  await links.first().click();
  await list.getByRole('link', { name: 'Все правила' }).click();
  await expect(list.getByRole('heading', { level: 1 })).toHaveText('Все правила');
});

test('the link of a problem is beside it, and its repair below', async ({ page }) => {
  await open(page);
  await type(page, 'GO1 X5\nM30');
  await openProblems(page);
  const item = problems(page).getByRole('listitem').first();
  await expect(item.getByRole('button')).toHaveCount(2);
  await expect(async () => {
    const places = [item.getByRole('button').first(), item.getByRole('link'), item.getByRole('button').last()];
    const [messageBox, link, repair] = await Promise.all(places.map(async (place) => (await place.boundingBox())!));
    expect(messageBox!.x + messageBox!.width).toBeLessThanOrEqual(link!.x + 1);
    expect(repair!.y).toBeGreaterThanOrEqual(messageBox!.y + messageBox!.height - 1);
  }).toPass({ timeout: 5000 });
});
