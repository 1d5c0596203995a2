// Help for the word and the state at the cursor: by keyboard, by pointer, in three languages.
import { expect, test, type BasicPage, type Locator, nightUnless } from './engines';
import { atCursor, chooseLanguage, editor, goTo, open, status, tab, type } from './page';

const THREAD =
  'O1\nT0101\nG97 S600 M03\nG00 X34 Z4\nG76 P021260 Q100 R0.05\nG76 X27.4 Z-25 P1299 Q400 F2\nG00 X100 Z100\nM30';
const LOOP = 'O1\n#1=40\nWHILE [#1 GT 30] DO1\nG65 P9 X#1\n#1=#1-2\nEND1\nM30\nO9\nG00 X#24 Z2\nM99';

const row = (page: BasicPage, name: string): Locator =>
  atCursor(page)
    .getByRole('row')
    .filter({ has: page.getByRole('rowheader', { name, exact: true }) });

/** Records announcements from now on; the live region shows each only for a moment. */
async function announcements(page: BasicPage): Promise<() => Promise<string>> {
  await page.locator('.cm-announced').evaluate((live) => {
    const liveTexts: string[] = [];
    Object.assign(globalThis, { liveTexts });
    new MutationObserver(() => liveTexts.push(live.textContent ?? '')).observe(live, {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  return () => page.evaluate(() => (globalThis as unknown as { liveTexts: string[] }).liveTexts.join(' '));
}

const IN_WORDS = {
  en: { peck: 'first depth of cut', thread: 'multi-pass threading' },
  zh: { peck: '第一次切深', thread: '螺纹' },
  ru: { peck: 'глубина первого прохода', thread: 'резьб' },
} as const;

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(`the meaning of Q is shown by keys alone, ${locale}`, nightUnless(locale === 'en'), async ({ page }) => {
    await open(page);
    await chooseLanguage(page, locale);
    await type(page, THREAD);
    await goTo(page, 6, 'G76 X27.4 Z-25 P1299 '.length);
    const liveTexts = await announcements(page);
    await page.keyboard.press('F1');
    const panel = atCursor(page);
    await expect(panel).toContainText('Q400');
    await expect(panel).toContainText(IN_WORDS[locale].peck);
    await expect(panel).toContainText('0.4');
    // It is also announced.
    await expect.poll(liveTexts).toContain(IN_WORDS[locale].peck);
    // The code of the same block, and the active modal codes.
    await page.keyboard.press('Home');
    await expect(panel).toContainText('G76');
    await expect(panel).toContainText(IN_WORDS[locale].thread);
  });
}

test('the signature of the block shows missing words and the defaults of omitted ones', async ({ page }) => {
  await open(page);
  await type(page, THREAD.replace(' P1299', ''));
  await goTo(page, 6, 'G76 X27.4 Z-25 '.length);
  await page.keyboard.press('F1');
  const form = atCursor(page).locator('.at-cursor-form');
  await expect(form.locator('.missing').last()).toHaveText('P thread height, on radius. Missing.');
  await expect(form.locator('mark')).toHaveText('Q');
  await expect(form.locator('li.left-out')).toContainText('taper of the thread');
  // The panel takes space; the block stays visible.
  await expect(page.locator('.cm-line').filter({ hasText: 'Q400' })).toBeInViewport();
  // Once the word is written, it is no longer missing, and the effect of the block is shown.
  await page.keyboard.type('P1299 ');
  await expect(form.locator('.missing')).toHaveCount(0);
  await expect(atCursor(page).locator('.at-cursor-state')).toContainText(/G76: \d+ passes/);
});

test('the state before and after the block links to the blocks that set it', async ({ page }) => {
  await open(page);
  await type(page, THREAD);
  await goTo(page, 7, 1);
  await page.keyboard.press('F1');
  await expect(row(page, 'X')).toContainText('Ø34');
  await expect(row(page, 'X')).toContainText('Ø100');
  await expect(row(page, 'X')).toHaveAttribute('class', /changed/);
  const speed = row(page, 'S').first();
  await expect(speed).toContainText('600');
  // Buttons are reached by Tab from the text, and return the focus to it.
  await speed.getByRole('button', { name: 'To line 3' }).focus();
  await page.keyboard.press('Enter');
  await expect(editor(page)).toBeFocused();
  await expect(atCursor(page)).toContainText('before and after line 3');
});

test('inside a loop and a call the state is that of the selected pass', async ({ page }) => {
  await open(page);
  await type(page, LOOP);
  await goTo(page, 9, 5);
  await page.keyboard.press('F1');
  const panel = atCursor(page);
  await expect(panel).toContainText('time 1 of 5');
  await expect(panel).toContainText('#24');
  await expect(row(page, '#24')).toContainText('40');
  await panel.getByRole('button', { name: 'The next time' }).focus();
  await page.keyboard.press('Enter');
  await expect(panel).toContainText('time 2 of 5');
  await expect(row(page, '#24')).toContainText('38');
  // A block that is never executed is described as such.
  await type(page, 'O1\nGOTO 5\nG00 X10\nN5 M30');
  await goTo(page, 3, 1);
  await expect(panel).toContainText('Line 3 is not carried out.');
});

test('a tooltip explains the word under the pointer', async ({ page }) => {
  await open(page);
  await type(page, THREAD.replace('S600', 'S2500'));
  // Panels that arrive with the report move the lines, so wait for it.
  await expect(status(page)).toContainText(/\b[1-9] problem/);
  const word = editor(page).locator('.cm-line').nth(4);
  const box = (await word.boundingBox())!;
  await page.mouse.move(box.x + 8, box.y + box.height / 2);
  await page.mouse.move(box.x + 10, box.y + box.height / 2);
  const card = page.locator('.word-card');
  await expect(card).toContainText('G76');
  await expect(card).toContainText('threading');
  await page.mouse.move(box.x + 8, box.y + 200);
  await expect(card).toBeHidden();
  // Where there is a problem, the tooltip shows only the problem: at S2500 the slide is too slow for the thread of line 6.
  const wrong = (await editor(page).locator('.cm-line').nth(5).boundingBox())!;
  await page.mouse.move(wrong.x + 8, wrong.y + wrong.height / 2);
  await page.mouse.move(wrong.x + 10, wrong.y + wrong.height / 2);
  await expect(page.locator('.cm-tooltip')).toContainText('With S2500 and a lead of 2 mm');
  await expect(page.locator('.word-card')).toHaveCount(0);
});

test('an answer belongs to the latest text', async ({ page }) => {
  await open(page);
  await type(page, 'G00 X50 Z2\nG01 Z-10 F0.2\nM30');
  await goTo(page, 2, 9);
  await page.keyboard.press('F1');
  await expect(atCursor(page)).toContainText('F0.2');
  await page.keyboard.press('End');
  await page.keyboard.type('5');
  await expect(atCursor(page)).toContainText('F0.25');
});

test('the help is not loaded before the editor has the focus', async ({ page }) => {
  await open(page);
  await expect(atCursor(page)).toContainText('Point at a word to read what it means');
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await expect(atCursor(page)).toContainText('no word');
});

test('on a phone the help has a tab of its own', async ({ page }) => {
  await page.setViewportSize({ width: 460, height: 700 });
  await open(page);
  await tab(page, 'program').click();
  await type(page, THREAD);
  await goTo(page, 6, 'G76 X27.4 Z-25 P1299 '.length);
  await expect(atCursor(page)).toHaveCount(0);
  await tab(page, 'explain').click();
  await expect(atCursor(page)).toContainText('Q400');
  // All of it is shown at once.
  await expect(atCursor(page).getByRole('table').first()).toBeVisible();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(460);
});
