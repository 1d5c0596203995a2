// The views beside the section: the end face, the side of the turret, dimensions of an edge, and two compared parts.
import { expect, test, type Page } from './engines';
import { choose, chooseExample, editor, locate, open, openMenu, program, status, tooltip, type } from './page';

interface Playground extends HTMLElement {
  locateOnFace(x: number, c: number): Promise<{ clientX: number; clientY: number }>;
}

const face = (page: Page) => page.getByRole('img', { name: /end face/ });
const section = (page: Page) => page.getByRole('img', { name: /tool path/ });

test('a square milled on the face is shown in a separate picture, and can be picked', async ({ page }) => {
  await open(page, '#s002-g121-square');
  await expect(face(page)).toBeVisible();
  await expect(section(page)).toBeVisible();
  const place = await page
    .locator('gcode-playground')
    .evaluate((element) => (element as Playground).locateOnFace(70, 12));
  await page.mouse.move(place.clientX, place.clientY);
  await expect(tooltip(page)).toContainText('line 12');
  await page.mouse.click(place.clientX, place.clientY);
  await expect(editor(page)).toBeFocused();
  await page.getByRole('radio', { name: 'Section' }).click();
  await expect(face(page)).toBeHidden();
  await page.keyboard.press('ArrowRight');
  await expect(face(page)).toBeVisible();
  await expect(section(page)).toBeHidden();
  await type(page, program('s003-g71'));
  await expect(section(page)).toBeVisible();
  await expect(page.getByRole('radiogroup', { name: 'View' })).toBeHidden();
});

test('a front turret has X+ below the axis', async ({ page }) => {
  await open(page, '#s003-g71');
  const below = async () => (await locate(page, 30, -20)).y > (await locate(page, 0, -20)).y;
  expect(await below()).toBe(false);
  const turret = page.getByRole('menuitemcheckbox', { name: 'Front turret' });
  await page.getByRole('button', { name: 'More', exact: true }).focus();
  await page.keyboard.press('ArrowDown');
  await turret.focus();
  await page.keyboard.press('Space');
  await expect(turret).toBeHidden();
  expect(await below()).toBe(true);
  await openMenu(page, 'more');
  await expect(turret).toHaveAttribute('aria-checked', 'true');
  await turret.click();
  expect(await below()).toBe(false);
  await openMenu(page, 'more');
  await expect(turret).toHaveAttribute('aria-checked', 'false');
  await page.keyboard.press('Escape');
  await type(page, '(MACHINE TURRET=FRONT)\nG00 X50 Z2\nG01 Z-30 F0.2\n');
  await expect(status(page)).toContainText('2 motions');
});

test('an edge of the part shows its dimensions', async ({ page }) => {
  await open(page, '#s001-o6003');
  // The nose radius of 0.2 mm leaves 2 · 0.2 · (1 + tan α − 1 / cos α) = 0.061 on the cone, tan α = 5.5 / 33.
  const place = await locate(page, -(31 - (11 * 13) / 33 - 0.061), -10);
  await page.mouse.move(place.x, place.y);
  await expect(tooltip(page)).toContainText('to ⌀29.94');
  await expect(tooltip(page)).toContainText('9.462° to the axis, 1:3');
});

test('a kept part is compared with the next one, and the difference is measured', async ({ page }) => {
  await open(page, '#s004-g94-wrong');
  // The example has its own comparison; a part kept by the user stays for the next example.
  await page.getByRole('button', { name: 'End comparison' }).click();
  await choose(page, 'more', 'Keep this part to compare');
  await expect(page.getByText('Same as the kept part')).toBeVisible();
  await chooseExample(page, 'R calculated from the start point: -24');
  await expect(page.getByText('only in the kept part')).toBeVisible();
  await expect(page.getByText('1.667 mm in radius at Z−16.667; 3.333 mm along Z at X50')).toBeVisible();
  await page.getByRole('button', { name: 'End comparison' }).click();
  await expect(page.getByText('only in the kept part')).toBeHidden();
});
