// The first minute: three hints, each at the control it is about, then none.
import { expect, test, type Page } from './engines';
import { editor, open, play, status } from './page';

const hint = (page: Page) => page.getByRole('note');
const GOT_IT = 'Got it';

test('hints for actions already done are not shown, and finally there are none', async ({ page }) => {
  await open(page);
  await expect(hint(page)).toHaveText(/^Change a number in the program/);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('(MY OWN)');
  await expect(hint(page)).toHaveText(/^Play below shows the tool/);
  // The notice about the change takes space above the button.
  await page
    .locator('gcode-playground')
    .evaluate((element) => (element as unknown as { settled: Promise<number> }).settled);
  await play(page).click();
  await expect(hint(page)).toHaveText(/^Click a stroke/);
  await page.getByRole('button', { name: GOT_IT }).click();
  await expect(hint(page)).toBeHidden();

  await page.reload();
  await expect(status(page)).toContainText(/motions/);
  await expect(play(page)).toBeEnabled();
  await expect(hint(page)).toBeHidden();
});

test('a dismissed hint is followed by the next one, also after a reload', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: GOT_IT }).click();
  await expect(hint(page)).toHaveText(/^Play below/);
  await page.reload();
  await expect(hint(page)).toHaveText(/^Play below/);
});
