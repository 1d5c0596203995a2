// The first minute: two hints over the picture, each at what it is about, then none. The help at the cursor says first
// that a number can be changed.
import { expect, test, type Page } from './engines';
import { atCursor, open, play, reload, status } from './page';

const hint = (page: Page) => page.getByRole('note');
const GOT_IT = 'Got it';

test('hints for actions already done are not shown, and finally there are none', async ({ page }) => {
  await open(page);
  await expect(atCursor(page)).toContainText('Change a number: the picture follows');
  await expect(hint(page)).toHaveText(/^Play below shows the tool/);
  await play(page).click();
  await expect(hint(page)).toHaveText(/^Click a stroke/);
  await page.getByRole('button', { name: GOT_IT }).click();
  await expect(hint(page)).toBeHidden();

  await reload(page);
  await expect(status(page)).toContainText(/motions/);
  await expect(play(page)).toBeEnabled();
  await expect(hint(page)).toBeHidden();
});

test('a dismissed hint is followed by the next one, also after a reload', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: GOT_IT }).click();
  await expect(hint(page)).toHaveText(/^Click a stroke/);
  await reload(page);
  await expect(hint(page)).toHaveText(/^Click a stroke/);
});
