// A student's first minutes: type a program, read the drawing, make a mistake, find the block of a stroke.
import { expect, test } from './engines';
import { kept } from './own-programs';
import {
  between,
  chip,
  chooseExample,
  editor,
  locate,
  open,
  openProblems,
  problems,
  program,
  reload,
  selected,
  status,
  tooltip,
  type,
  value,
} from './page';

test('types O0002, reads its strokes, breaks a line, selects a block from the picture', async ({ page }) => {
  await open(page);
  // The blank and the start point come from the gallery; the text is typed.
  await chooseExample(page, 'Steps and a cone from one Ø125 blank');
  await expect(chip(page)).toContainText('GSK 980TD');
  await type(page, program('s000-o0002'));
  await expect(status(page)).toContainText(/^42 motions/);
  await expect(status(page)).toContainText('no problems');

  // Strokes of several blocks overlap here: the tooltip names the stroke that ends nearest to the pointer.
  await test.step('the rapid of line 7 ends at X80', async () => {
    const place = await between(page, { x: 90, z: 3 }, { x: 80, z: 3 });
    await page.mouse.move(place.x, place.y);
    await expect(tooltip(page)).toContainText('line 7');
    await expect(tooltip(page)).toContainText('X80');
  });

  await test.step('the rapid of line 11 ends at X105', async () => {
    const place = await between(page, { x: 120, z: -30 }, { x: 105, z: -30 });
    await page.mouse.move(place.x, place.y);
    await expect(tooltip(page)).toContainText('line 11');
    await expect(tooltip(page)).toContainText('X105');
  });

  await test.step('a syntax error is underlined at its column', async () => {
    await page.getByText('X110 Z-30', { exact: false }).first().click();
    await page.keyboard.press('Home');
    for (let i = 0; i < 'X110 '.length; i++) await page.keyboard.press('ArrowRight');
    // `X110 Z-30` becomes `X110 ZZ-30`: the first Z has no number.
    await page.keyboard.type('Z');
    await expect(status(page)).toContainText(/1 problem|2 problems/);
    await openProblems(page);
    const first = problems(page).getByRole('listitem').first().getByRole('button').first();
    await expect(first).toContainText('line 4, column 6');
    const squiggle = page.locator('.cm-lintRange-error');
    await expect(squiggle).toHaveText('Z');
    await expect(page.locator('.cm-line', { has: squiggle })).toHaveText('X110 ZZ-30;');
    await first.click();
    await expect.poll(() => selected(page)).toMatch(/^Z/);
    await page.keyboard.press('Control+Z');
    await expect(status(page)).toContainText('no problems');
  });

  await test.step('a click on a stroke selects its block', async () => {
    // The cone's last cut, X60 Z-30 to X120 Z-80, belongs only to line 14.
    const place = await between(page, { x: 60, z: -30 }, { x: 120, z: -80 }, 0.4);
    await page.mouse.move(place.x, place.y);
    await expect(tooltip(page)).toContainText('line 14');
    await page.mouse.click(place.x, place.y);
    await expect.poll(() => selected(page)).toContain('Z-80 R-30');
    await expect(editor(page)).toBeFocused();
  });
});

test('a resting pointer shows the stroke under it after the program has changed', async ({ page }) => {
  await open(page);
  await type(page, 'G0 X50 Z2\nG1 Z-20 F0.2\n');
  await expect(status(page)).toContainText(/^2 motions/);
  const place = await between(page, { x: 50, z: 2 }, { x: 50, z: -20 });
  await page.mouse.move(place.x, place.y);
  await expect(tooltip(page)).toContainText('line 2');
  await type(page, '(one line more)\nG0 X50 Z2\nG1 Z-20 F0.2\n');
  await expect(tooltip(page)).toContainText('line 3');
});

test('the drawing keeps the point under the pointer while zooming, and can be fitted again', async ({ page }) => {
  await open(page);
  const before = await locate(page, 60, -30);
  await page.mouse.move(before.x, before.y);
  await page.mouse.wheel(0, -400);
  await expect.poll(async () => (await locate(page, 120, -110)).x).toBeLessThan(before.x - 400);
  const after = await locate(page, 60, -30);
  // Pointer coordinates are whole pixels; zooming by 400 px of wheel magnifies the lost fraction by two.
  expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeLessThan(2);
  await page.getByRole('button', { name: 'Show all' }).click();
  const fitted = await locate(page, 60, -30);
  expect(Math.hypot(fitted.x - before.x, fitted.y - before.y)).toBeLessThan(1);
});

test('typed text is restored after a reload, and can be discarded', async ({ page }) => {
  await open(page);
  await expect(page.getByText('Restored your last program')).toHaveCount(0);
  await type(page, 'G0 X50 Z2\nG1 Z-20 F0.2\n');
  await expect(status(page)).toContainText(/^2 motions/);
  await reload(page);
  await expect(status(page)).toContainText(/^2 motions/);
  await page.getByRole('button', { name: 'Open the first example' }).click();
  await expect(status(page)).toContainText(/^7 motions/);
});

test('a changed example is restored after a reload, and can be reset', async ({ page }) => {
  await open(page, '#s003-g71');
  await expect.poll(() => value(page)).toBe(program('s003-g71'));
  await editor(page).focus();
  await page.keyboard.insertText('(MINE)');
  await kept(page);
  await reload(page);
  await expect.poll(() => value(page)).toContain('(MINE)');
  await page.getByRole('button', { name: 'Reset example' }).click();
  await expect.poll(() => value(page)).toBe(program('s003-g71'));
});

test('play moves the tool and marks its block, and steps stop at the ends of motions', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Next motion' }).click();
  const place = page.getByRole('slider', { name: 'Position along the path' });
  await expect(place).toHaveAttribute('aria-valuetext', 'X diameter 130.000, Z 3.000');
  await page.getByRole('button', { name: 'Next motion' }).click();
  await expect(place).toHaveAttribute('aria-valuetext', 'X diameter 120.000, Z 3.000');
  await page.getByRole('button', { name: 'Previous motion' }).click();
  await expect(place).toHaveAttribute('aria-valuetext', 'X diameter 130.000, Z 3.000');
  const start = Number(await place.inputValue());
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(async () => Number(await place.inputValue())).toBeGreaterThan(start + 0.02);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('button', { name: 'Show the whole path' }).click();
  await expect(place).toHaveAttribute('aria-valuetext', '–');
});
