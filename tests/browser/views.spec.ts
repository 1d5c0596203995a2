// The views beside the section: the end face, the side of the turret, dimensions of an edge, the place of the pointer,
// and two compared parts.
import { expect, test, type Page } from './engines';
import {
  choose,
  chooseExample,
  editor,
  locate,
  open,
  openMenu,
  openReading,
  program,
  status,
  tooltip,
  type,
} from './page';

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
  await expect(tooltip(page)).toContainText('to Ø29.94');
  await expect(tooltip(page)).toContainText('9.462° to the axis, 1:3');
});

test('a kept part is compared with the next one, and the difference is measured', async ({ page }) => {
  await open(page, '#s004-g94-wrong');
  // The example has its own comparison; a part kept by the user stays for the next example.
  await page.getByRole('button', { name: 'End comparison' }).click();
  await choose(page, 'more', 'Keep this part to compare');
  await expect(page.getByText('Same as the reference')).toBeVisible();
  await chooseExample(page, 'R calculated from the start point: -24');
  await expect(page.getByText('only in the reference')).toBeVisible();
  await expect(page.getByText('1.667 mm in radius at Z−16.667; 3.333 mm along Z at X50')).toBeVisible();
  await page.getByRole('button', { name: 'End comparison' }).click();
  await expect(page.getByText('only in the reference')).toBeHidden();
});

test.describe('X and Z at the pointer', () => {
  const place = (page: Page) => page.locator('[part~=pointer]');

  /** X, Z and the number of their decimals, as shown: "X Ø30.2Z−20.1". */
  const shown = async (page: Page): Promise<{ x: number; z: number; decimals: number }> => {
    const text = ((await place(page).textContent()) ?? '').replaceAll('−', '-');
    const [, x = '', z = ''] = /^X Ø(-?[\d.]+)Z(-?[\d.]+)/.exec(text) ?? [];
    return { x: Number(x), z: Number(z), decimals: z.split('.')[1]?.length ?? 0 };
  };

  /** Moves the mouse to a point (X a diameter, Z; mm), and checks what is shown: a pixel is at most 0.25 mm. */
  const check = async (page: Page, x: number, z: number, unit = 1): Promise<void> => {
    const point = await locate(page, x, z);
    await page.mouse.move(point.x, point.y);
    await expect(place(page)).toBeVisible();
    await expect.poll(async () => Math.abs((await shown(page)).x - x / unit)).toBeLessThan(0.6 / unit);
    expect(Math.abs((await shown(page)).z - z / unit)).toBeLessThan(0.3 / unit);
  };

  test('are shown over the section only, and move nothing', async ({ page }) => {
    await open(page, '#s003-g71');
    const legend = page.locator('[part~=legend]');
    const before = await legend.boundingBox();
    await expect(place(page)).toBeHidden();
    await check(page, 30, -20);
    expect(await legend.boundingBox()).toEqual(before);
    await check(page, 60, 2);
    // Below the axis X is negative.
    await check(page, -40, -30);
    // Screen readers do not read it with each movement.
    await expect(place(page)).toHaveAttribute('aria-hidden', 'true');

    await test.step('with more digits in a larger picture', async () => {
      const { decimals } = await shown(page);
      await section(page).focus();
      for (let step = 0; step < 12; step++) await page.keyboard.press('=');
      await expect.poll(async () => (await shown(page)).decimals).toBeGreaterThan(decimals);
    });
    await test.step('until the pointer leaves', async () => {
      const box = await editor(page).boundingBox();
      await page.mouse.move((box?.x ?? 0) + 20, (box?.y ?? 0) + 20);
      await expect(place(page)).toBeHidden();
    });
  });

  test('follow the side of the turret and the unit', async ({ page }) => {
    await open(page, '#s003-g71');
    await choose(page, 'more', 'Front turret');
    await check(page, 30, -20);
    await openReading(page);
    await page.getByRole('button', { name: /^Lengths in mm/ }).click();
    await page.keyboard.press('Escape');
    await check(page, 30, -20, 25.4);
    await expect(place(page)).toContainText('in');
  });

  test('are not shown over the end face', async ({ page }) => {
    await open(page, '#s002-g121-square');
    await check(page, 30, -5);
    const box = await face(page).boundingBox();
    await page.mouse.move((box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2);
    await expect(place(page)).toBeHidden();
  });
});
