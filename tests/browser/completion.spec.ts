// Completion at the cursor: by keys alone, in three languages.
import { chromiumTest, expect, test, type BasicPage, type Locator, nightUnless } from './engines';
import { chooseLanguage, editor, open, type } from './page';
import { runBeforeWorker } from './worker-script';

const HEAD = 'O1\nT0101\nG97 S600 M03\nG00 X34 Z4\nG76 P021260 Q100 R0.05\n';
const list = (page: BasicPage): Locator => page.getByRole('listbox');
const text = (page: BasicPage): Promise<string> =>
  page.locator('gcode-playground').evaluate((element) => (element as unknown as { value: string }).value);

const SECOND_BLOCK = /\nG76 X[\d.]+ Z-?[\d.]+ P\d+ Q\d+ F[\d.]+$/;
const HEIGHT = { en: 'thread height', zh: '牙型高度', ru: 'высота профиля' } as const;

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(`G76 is completed by keys alone, ${locale}`, nightUnless(locale === 'en'), async ({ page }) => {
    await open(page);
    await chooseLanguage(page, locale);
    await type(page, HEAD);
    await page.keyboard.press('Control+End');
    await page.keyboard.type('G7');
    // After the first block, the second one is proposed with its words.
    await expect(list(page).getByRole('option').first()).toContainText('G76 X');
    await page.keyboard.press('Tab');
    await expect.poll(() => text(page)).toMatch(SECOND_BLOCK);
    // Its placeholders are filled in order, and Escape ends the snippet.
    await page.keyboard.type('31.4');
    await page.keyboard.press('Tab');
    await page.keyboard.type('-25');
    expect(await text(page)).toMatch(/\nG76 X31\.4 Z-25 P/);
    await page.keyboard.press('Escape');
    // A missing word is proposed after a blank, with its meaning.
    await type(page, `${HEAD}G76 X31.4 Z-25 Q400 F2`);
    await page.keyboard.press('Control+End');
    await page.keyboard.type(' ');
    await expect(list(page)).toContainText(HEIGHT[locale]);
  });
}

test('a key for the list is kept while the list updates for the last letter', async ({ page }) => {
  await open(page);
  for (const keys of [['Tab'], ['ArrowDown', 'Enter'], ['ArrowUp', 'ArrowDown', 'Tab']]) {
    await type(page, HEAD);
    await page.keyboard.press('Control+End');
    await page.keyboard.type('G');
    await expect(list(page).getByRole('option').first()).toContainText('G76 X');
    await page.keyboard.type('7');
    for (const key of keys) await page.keyboard.press(key);
    await expect.poll(() => text(page), keys.join(' ')).toMatch(SECOND_BLOCK);
    await expect(editor(page)).toBeFocused();
  }
});

chromiumTest('the list opens even if another letter is typed while a request is pending', async ({ page }) => {
  // The answer to the first request arrives after the next letter.
  await runBeforeWorker(
    page,
    `
    let first;
    self.addEventListener('message', ({ data }) => {
      if (data?.content?.kind === 'question' && data.content.args?.by === 'completion') first ??= data.content.id;
      self.isAsked = first !== undefined;
    });
    const post = self.postMessage.bind(self);
    self.postMessage = (message, ...rest) => {
      const isFirst = message?.event?.kind === 'answer' && message.event.id === first;
      if (isFirst) setTimeout(() => post(message, ...rest), 1500);
      else post(message, ...rest);
    };
  `,
  );
  await open(page);
  await type(page, HEAD);
  await page.keyboard.press('Control+End');
  await page.keyboard.type('G');
  await expect
    .poll(() => page.workers()[0]!.evaluate(() => (self as unknown as { isAsked?: boolean }).isAsked))
    .toBe(true);
  await page.keyboard.type('7');
  await expect(list(page).getByRole('option').first()).toContainText('G76 X');
});

test('a key meant for a list that is already closed has its normal effect', async ({ page }) => {
  await open(page);
  await type(page, `${HEAD}M`);
  await page.keyboard.press('Control+End');
  await page.keyboard.type('3');
  await expect(list(page)).toBeVisible();
  await page.keyboard.type('0');
  await page.keyboard.press('ArrowUp');
  await expect(page.locator('.cm-activeLine')).toContainText('G76 P021260');
  expect(await text(page)).toBe(`${HEAD}M30`);
});

test('a click on a proposal is accepted while the list updates', async ({ page }) => {
  await open(page);
  await type(page, HEAD);
  await page.keyboard.press('Control+End');
  await page.keyboard.type('G');
  const first = list(page).getByRole('option').first();
  await expect(first).toContainText('G76 X');
  // The list is positioned far outside the page until it has been measured.
  await expect.poll(async () => (await first.boundingBox())?.y ?? -1).toBeGreaterThan(0);
  const box = (await first.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.keyboard.type('7');
  await page.mouse.down();
  await page.mouse.up();
  await expect.poll(() => text(page)).toMatch(SECOND_BLOCK);
  await expect(editor(page)).toBeFocused();
});

test('one remembered switch turns the list off, and Ctrl+Space still opens it', async ({ page }) => {
  await open(page);
  await type(page, HEAD);
  await page.keyboard.press('F1');
  await page.getByLabel(/Propose words/).focus();
  await page.keyboard.press('Space');
  await page.reload();
  await open(page);
  await type(page, HEAD);
  await page.keyboard.press('Control+End');
  await page.keyboard.type('G7');
  await page.waitForTimeout(600);
  await expect(list(page)).toHaveCount(0);
  await page.keyboard.press('Control+Space');
  await expect(list(page)).toContainText('G76');
  // Tab leaves the editor when no list is open.
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await expect(editor(page)).not.toBeFocused();
});

test('completion is not loaded before the editor has the focus', async ({ page }) => {
  const loaded = (): Promise<number> =>
    page.evaluate(
      () =>
        performance.getEntriesByType('resource').filter(({ name }) => /\/completion-[\w-]{8}\.js$/.test(name)).length,
    );
  await open(page);
  expect(await loaded()).toBe(0);
  await editor(page).focus();
  await expect.poll(loaded).toBe(1);
});
