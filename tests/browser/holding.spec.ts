// Pausing while the program plays: breakpoints, single-block mode, the block at the cursor.
import { expect, test, type BasicPage } from './engines';
import { goTo, open, openPace, type } from './page';

const LOOP = [
  'O1',
  'T0101 M3 S500',
  'G0 X50 Z2',
  '#1=0',
  'WHILE [#1 LT 2] DO1',
  'G1 X[40-#1] F1',
  'G0 Z[5-#1]',
  '#1=#1+1',
  'END1',
  'G0 X100',
  'M30',
].join('\n');

/** Opens the program and plays it fast, so that the test does not wait. */
async function openLoop(page: BasicPage): Promise<void> {
  await open(page);
  await type(page, LOOP);
  await openPace(page);
  await page.getByRole('combobox', { name: 'Speed' }).selectOption('50×');
  await page.keyboard.press('Escape');
}

const runningLine = (page: BasicPage): Promise<string | null> => page.locator('.cm-running-line').textContent();

test('a breakpoint pauses the tool in each pass, and moves with its line', async ({ page }) => {
  await openLoop(page);
  await goTo(page, 7);
  await page.keyboard.press('Control+F8');
  await expect(page.locator('.cm-lineNumbers .cm-breakpoint')).toHaveText('7');
  await page.keyboard.press('Control+Enter');
  await expect(page.getByText('Paused before line 7')).toBeVisible();
  expect(await runningLine(page)).toBe('G0 Z[5-#1]');
  const first = await page.locator('.cell.x dd').textContent();
  await page.keyboard.press('Control+Enter');
  // The same line in the second pass, with another X.
  await expect.poll(() => page.locator('.cell.x dd').textContent()).not.toBe(first);
  await expect(page.getByText('Paused before line 7')).toBeVisible();
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
  // A line inserted before it moves the breakpoint; a click on the line number removes it.
  await goTo(page, 1);
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await expect(page.locator('.cm-lineNumbers .cm-breakpoint')).toHaveText('8');
  await page.locator('.cm-lineNumbers .cm-breakpoint').click();
  await expect(page.locator('.cm-lineNumbers .cm-breakpoint')).toHaveCount(0);
});

test('single-block mode pauses the tool after each block', async ({ page }) => {
  await openLoop(page);
  await openPace(page);
  await page.getByRole('button', { name: 'Single block' }).click();
  await page.keyboard.press('Escape');
  const lines = [];
  for (let press = 0; press < 4; press++) {
    await page.keyboard.press('Control+Enter');
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
    lines.push(await runningLine(page));
  }
  expect(lines).toEqual(['G0 X50 Z2', 'G1 X[40-#1] F1', 'G0 Z[5-#1]', 'G1 X[40-#1] F1']);
});

test('the block at the cursor is played alone, or the program is played up to it', async ({ page }) => {
  await openLoop(page);
  await goTo(page, 6);
  await page.keyboard.press('F10');
  await expect.poll(() => page.locator('.cell.x dd').textContent()).toContain('40');
  await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
  expect(await runningLine(page)).toBe('G1 X[40-#1] F1');
  await goTo(page, 10);
  await page.keyboard.press('Control+F10');
  await expect(page.getByText('Paused before line 10')).toBeVisible();
  // The pause at the cursor's line is temporary and sets no breakpoint.
  await expect(page.locator('.cm-breakpoint')).toHaveCount(0);
  // The buttons have the same effect.
  await page.keyboard.press('F1');
  await page.getByRole('button', { name: 'Stop here' }).click();
  await expect(page.locator('.cm-lineNumbers .cm-breakpoint')).toHaveText('10');
});
