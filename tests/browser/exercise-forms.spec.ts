// Exercises that are answered in a form: end points, the order of blocks, gaps.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test, type BasicPage, type Locator } from './engines';
import { chooseLanguage, editor, goTo, locate, open, settled, tooltip, value } from './page';

const reference = (id: string): readonly string[] =>
  readFileSync(join(__dirname, '../exercise', id, 'reference.nc'), 'utf8')
    .trim()
    .split('\n');

const form = (page: BasicPage): Locator => page.locator('.exercise-form');
const rows = (page: BasicPage): Locator => form(page).getByRole('listitem');
const check = (page: BasicPage): Promise<void> => page.getByRole('button', { name: 'Check', exact: true }).click();
const report = (page: BasicPage): Locator => page.locator('.exercise-report');

/** The lines of the program in the editor, without the setup after it. */
const lines = async (page: BasicPage): Promise<readonly string[]> =>
  (await value(page)).split('\n').filter((line) => line !== '' && !line.startsWith('('));

async function openExercise(page: BasicPage, id: string): Promise<void> {
  await open(page, `#exercise=${id}`);
  await expect(rows(page).first()).toBeVisible();
}

test('end points are entered or clicked, and the path does not show them before', async ({ page }) => {
  await openExercise(page, 'increments');
  await expect(rows(page)).toHaveCount(3);
  const start = ['O0108', 'T0101', 'M03 S400', 'G00 X32 Z2'];
  await expect.poll(() => lines(page)).toEqual([...start, 'M30']);
  await check(page);
  await expect(report(page).getByText('Not passed').first()).toBeVisible();

  const fields = (line: number): Locator =>
    rows(page)
      .filter({ hasText: String(line) })
      .getByRole('textbox');
  await fields(5).first().fill('28');
  await fields(5).last().fill('2');
  await expect.poll(() => lines(page)).toEqual([...start, 'G00 X28 Z2', 'M30']);

  // G01 W-22 from Z2 ends at Z-20; U4 at X32. The first click is 1 mm beside it.
  await settled(page);
  const at = async (x: number, z: number): Promise<void> => {
    const place = await locate(page, x, z);
    await page.mouse.click(place.x, place.y);
    await settled(page);
  };
  await at(28, -20);
  // It would cover the next place.
  await expect(tooltip(page)).toBeHidden();
  await at(32, -21);
  await expect(rows(page).nth(1).getByRole('textbox').last()).toHaveValue('-20');
  await expect
    .poll(() => lines(page))
    .toEqual([...start, 'G00 X28 Z2', 'G01 X28 Z-20 F0.1', 'X32 Z-21', 'G00 Z2', 'G00 X100 Z100', 'M30']);
  await check(page);
  await expect(report(page).getByRole('listitem').filter({ hasText: 'Not passed' })).toHaveCount(1);
  await expect(report(page)).toContainText('end point of line 7');

  await rows(page).nth(2).getByRole('textbox').last().fill('-20');
  await check(page);
  await expect(page.locator('.exercise-verdict.passed')).toHaveText('Passed');

  // The program in the editor is the answer: the form follows it, also in another language.
  await goTo(page, 6, 'G01 X28'.length);
  await page.keyboard.press('Backspace');
  await page.keyboard.type('6');
  await expect(rows(page).nth(1).getByRole('textbox').first()).toHaveValue('26');
  await chooseLanguage(page, 'ru');
  await expect(page.getByRole('textbox', { name: 'X в конце строки 6' })).toHaveValue('26');
});

test('blocks are put in order by arrows and by dragging', async ({ page }) => {
  await openExercise(page, 'order');
  const wanted = reference('order');
  await expect(rows(page)).toHaveCount(wanted.length);
  const shown = (): Promise<string[]> =>
    form(page).evaluate((element) => [...element.querySelectorAll('code')].map((code) => code.textContent ?? ''));

  await form(page).getByRole('button', { name: 'Move up: O0109' }).focus();
  // The focus stays at the block.
  for (let at = (await shown()).indexOf('O0109'); at > 0; at--) await page.keyboard.press('Enter');
  expect((await shown())[0]).toBe('O0109');
  expect((await lines(page))[0]).toBe('O0109');

  await test.step('dragging', async () => {
    const box = async (at: number, part: string): Promise<{ x: number; y: number }> => {
      const place = rows(page).nth(at).locator(part);
      const { x, y, width, height } = (await place.boundingBox())!;
      return { x: x + width / 2, y: y + height / 2 };
    };
    const from = (await shown()).indexOf('T0101');
    await rows(page).nth(from).scrollIntoViewIfNeeded();
    await rows(page)
      .nth(from - 1)
      .scrollIntoViewIfNeeded();
    const handle = await box(from, '.exercise-handle');
    const above = await box(from - 1, 'code');
    await page.mouse.move(handle.x, handle.y);
    await page.mouse.down();
    await page.mouse.move(handle.x, (handle.y + above.y) / 2);
    await page.mouse.move(handle.x, above.y - 4);
    await page.mouse.up();
    await expect.poll(shown).toEqual(await lines(page));
    expect((await shown()).indexOf('T0101')).toBe(from - 1);
  });

  // The rest by the arrows.
  for (const [to, block] of wanted.entries()) {
    const place = (await shown()).indexOf(block, to);
    const up = form(page).getByRole('button', { name: `Move up: ${block}`, exact: true });
    // Of equal blocks the last one.
    await up.last().focus();
    for (let at = place; at > to; at--) await page.keyboard.press('Enter');
  }
  expect(await shown()).toEqual(wanted);
  expect(await lines(page)).toEqual(wanted);
  await check(page);
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  await expect(report(page)).not.toContainText('Not passed');
});

test('gaps are filled in fields or in the program', async ({ page }) => {
  await openExercise(page, 'cone-blanks');
  await expect(rows(page)).toHaveCount(2);
  const r = page.getByRole('textbox', { name: 'Gap R in line 5' });
  await r.fill('-2.2');
  await expect.poll(async () => (await lines(page))[4]).toBe('G90 X48 Z-30 R-2.2 F0.2');
  await check(page);
  await expect(report(page).getByText('Not passed').first()).toBeVisible();

  await goTo(page, 8, 'X__'.length);
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Backspace');
  await page.keyboard.type('40');
  await expect(page.getByRole('textbox', { name: 'Gap X in line 8' })).toHaveValue('40');
  await expect(editor(page)).toContainText('X40 F0.1');
  await check(page);
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  await expect(report(page)).not.toContainText('Not passed');

  // An empty field is a gap again.
  await r.fill('');
  await expect.poll(async () => (await lines(page))[4]).toBe('G90 X48 Z-30 R__ F0.2');
});
