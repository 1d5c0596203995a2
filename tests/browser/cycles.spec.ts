// Cycles on the page: every example runs, a stroke names its pass, and a program can be expanded.
import { expect, test, type Page } from './engines';
import {
  between,
  choose,
  chooseLanguage,
  clipboard,
  editor,
  examples,
  motionCount,
  open,
  openMenu,
  problems,
  program,
  status,
  tooltip,
  type,
  value,
} from './page';

const dialog = (page: Page) => page.getByRole('dialog', { name: 'The expanded program' });
const writeOut = (page: Page) => choose(page, 'more', 'Expand cycles');
interface Summary {
  readonly motions: number;
  readonly errors: number;
}

const CYCLE_CALL = /^\s*(N\d+\s*)?G7[0-6]\b/m;

test('every example opens without an error and draws the expected motions', async ({ page }) => {
  // Not the first one, so that each is opened by a change of the address.
  await open(page, `#${examples.at(-1)?.id}`);
  // The latest report for each text of the editor.
  await page.locator('gcode-playground').evaluate((element) => {
    const found: Record<string, Summary> = {};
    Reflect.set(window, 'reports', found);
    element.addEventListener('gcode-report', (event) => {
      found[(element as HTMLElement & { value: string }).value] = (event as CustomEvent).detail.summary;
    });
  });
  const report = (text: string) =>
    page.evaluate((text) => (Reflect.get(window, 'reports') as Record<string, Summary>)[text] ?? null, text);
  for (const { id } of examples) {
    await test.step(id, async () => {
      await page.evaluate((id) => void (location.hash = id), id);
      const text = program(id);
      await expect.poll(async () => (await report(text))?.errors).toBe(0);
      expect((await report(text))?.motions).toBe(motionCount(id));
      await expect(problems(page).getByText('not supported here')).toHaveCount(0);
    });
  }
});

test('a roughing pass shows its cycle, its number and its step', async ({ page }) => {
  await open(page, '#s003-g71');
  await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
  await expect(status(page)).toContainText('no problems');
  const place = await between(page, { x: 33.5, z: 0.2 }, { x: 33.5, z: -60.3 });
  await page.mouse.move(place.x, place.y);
  await expect(tooltip(page)).toContainText('line 4');
  await expect(tooltip(page)).toContainText(/G71, pass 2 of 10: cut at feed to X33\.5 Z-60\.3/);
  // While the pointer rests, the effect of the whole block is shown below.
  await expect(tooltip(page)).toContainText(/G71: 10 passes/);
});

test('a program is expanded, read, copied, replaced by the expanded one, and restored', async ({ page }) => {
  await open(page, '#s003-g71');
  const motions = `${motionCount('s003-g71')} motions`;
  await expect(status(page)).toContainText(motions);

  await test.step('opened, read and closed by keyboard', async () => {
    const more = page.getByRole('button', { name: 'More' });
    await more.focus();
    await page.keyboard.press('Enter');
    const item = page.getByRole('menuitem', { name: 'Expand cycles' });
    // The run has ended. Until then, a letter passes over it.
    await expect(item).toBeEnabled();
    // The first letter of the item moves to it.
    await page.keyboard.press('e');
    await expect(item).toBeFocused();
    await page.keyboard.press('Enter');
    const text = dialog(page).getByRole('textbox');
    await expect(text).toBeFocused();
    await expect(text).toContainText('G01 X37.5 Z-60.3');
    await expect(text).toContainText('G00 X39.5 Z0.2');
    await page.keyboard.type('X1');
    await expect(text).not.toContainText('X1N010');
    await page.keyboard.press('Escape');
    await expect(dialog(page)).toBeHidden();
    await expect(more).toBeFocused();
    expect(await value(page)).toBe(program('s003-g71'));
  });

  await test.step('copied', async () => {
    await writeOut(page);
    await dialog(page).getByRole('button', { name: 'Copy' }).click();
    await expect(dialog(page).getByRole('button', { name: 'Copied' })).toBeVisible();
    const copied = await clipboard(page);
    expect(copied).toMatch(/^G03 X11\.5 Z-5\.3 /m);
    expect(copied).not.toMatch(CYCLE_CALL);
  });

  await test.step('replaced by the expanded program: the tool path is the same', async () => {
    await dialog(page).getByRole('button', { name: 'Put into the editor' }).click();
    await expect(dialog(page)).toBeHidden();
    expect(await value(page)).not.toMatch(CYCLE_CALL);
    await expect(status(page)).not.toContainText('15 lines');
    await expect(status(page)).toContainText(motions);
    await expect(page.getByText('Ctrl Z in the editor restores yours')).toBeVisible();
  });

  await test.step('expanding it again changes nothing', async () => {
    await writeOut(page);
    await expect(dialog(page)).toContainText('nothing to expand');
    await expect(dialog(page).getByRole('button', { name: 'Put into the editor' })).toBeHidden();
    await dialog(page).getByRole('button', { name: 'Close' }).click();
  });

  await test.step('undo restores the original program', async () => {
    await editor(page).focus();
    await page.keyboard.press('Control+Z');
    expect(await value(page)).toBe(program('s003-g71'));
    await expect(status(page)).toContainText('15 lines');
    await expect(status(page)).toContainText(motions);
  });
});

test('a program without motions cannot be expanded, and the item has labels in three languages', async ({ page }) => {
  const item = (name: string) => page.getByRole('menuitem', { name });
  await open(page);
  await openMenu(page, 'more');
  await expect(item('Expand cycles')).toBeEnabled();
  await page.keyboard.press('Escape');
  await chooseLanguage(page, 'zh');
  await openMenu(page, 'more');
  await expect(item('展开循环')).toBeVisible();
  await page.keyboard.press('Escape');
  await chooseLanguage(page, 'ru');
  await type(page, '');
  await expect(status(page)).toContainText('0 ');
  await openMenu(page, 'more');
  await expect(item('Развернуть циклы')).toBeDisabled();
});
