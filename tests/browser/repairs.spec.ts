// Repairs: safe fixes are applied and undone together, the others one by one; and the levels of rules in the setup
// form.
import { expect, test, type Locator, type Page } from './engines';
import { editor, open, openFile, openProblems, problems, problemsButton, settled, type, value } from './page';

const all = (page: Page): Locator => problems(page).getByRole('button', { name: /^Apply \d+ safe fix(es)?$/ });

test('all safe repairs take one click and one undo', async ({ page }) => {
  const before = 'GO1 X5O F0.1 M3 S500\nG00 X60 X61 Z–2\nM30 (END';
  const after = 'G01 X50 F0.1 M3 S500\nG00 X60 X61 Z-2\nM30 (END)';
  await open(page);
  await type(page, before);
  await openProblems(page);
  await expect(all(page)).toHaveText('Apply 4 safe fixes');
  // The second click must not apply them again.
  await all(page).dblclick();
  await expect.poll(() => value(page)).toBe(after);
  await expect(all(page)).toBeHidden();
  await expect(editor(page)).toBeFocused();

  await test.step('when a run removes the focused button, the focus moves to the program', async () => {
    await type(page, before);
    // The list closes if the empty text has run before the new one.
    await openProblems(page);
    await all(page).focus();
    await page.evaluate((text) => {
      document.querySelector<HTMLElement & { value: string }>('gcode-playground')!.value = text;
    }, after);
    await expect(all(page)).toBeHidden();
    await expect(editor(page)).toBeFocused();
  });

  await test.step('a repair with alternatives stays with its message', async () => {
    const offered = problems(page).getByRole('button', { name: /^Fix: / });
    await expect(offered).toHaveCount(2);
    const [first, second] = await Promise.all([offered.first().boundingBox(), offered.last().boundingBox()]);
    expect(second!.y).toBe(first!.y);
  });
});

test('one undo reverts all repairs', async ({ page }) => {
  const before = 'G00 X60 Z–2\nG00 X50 Z–3\nM30';
  await open(page);
  await type(page, before);
  await openProblems(page);
  await expect(all(page)).toHaveText('Apply 2 safe fixes');
  await all(page).click();
  await expect.poll(() => value(page)).toBe('G00 X60 Z-2\nG00 X50 Z-3\nM30');
  await expect(problemsButton(page)).toHaveText('✓ no problems');
  await expect(problems(page)).toBeHidden();
  await page.keyboard.press('Control+z');
  await expect.poll(() => value(page)).toBe(before);
  await openProblems(page);
  await expect(all(page)).toHaveText('Apply 2 safe fixes');
});

test('an edit elsewhere keeps the row of a problem, and its repair is applied at the new position', async ({
  page,
}) => {
  const before = 'G00 X50 Z1\nG00 X60 Z–2\nM30';
  await open(page);
  for (const where of ['list', 'tooltip'] as const) {
    await type(page, before);
    await openProblems(page);
    const repair = problems(page).getByRole('button', { name: /^Fix: / });
    await expect(repair).toHaveCount(1);
    await repair.evaluate((button) => Object.assign(button, { isTheSame: true }));
    await editor(page).focus();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('N10 ');
    await expect.poll(() => value(page)).toBe(`N10 ${before}`);
    await settled(page);
    expect(
      await repair.evaluate((button) => (button as HTMLElement & { isTheSame?: boolean }).isTheSame === true),
    ).toBe(true);
    if (where === 'list') await repair.click();
    else {
      await page.locator('.cm-lintRange').first().hover();
      await page.locator('.cm-tooltip').getByRole('button').first().click();
    }
    await expect.poll(() => value(page)).toBe('N10 G00 X50 Z1\nG00 X60 Z-2\nM30');
  }
});

test('the tooltip of a problem keeps its position, and is not clipped', async ({ page }) => {
  await open(page);
  await type(page, 'G00 X60 Z–2\nM30');
  for (const width of [1440, 500]) {
    await page.setViewportSize({ width, height: 900 });
    await page.locator('.cm-lintRange').first().hover();
    const tooltip = page.locator('.cm-tooltip');
    await expect(tooltip.getByRole('button')).toBeVisible();
    const places = await tooltip.evaluate(async (element) => {
      const seen = new Set<string>();
      const end = performance.now() + 500;
      while (performance.now() < end) {
        const { x, y, width, height } = element.getBoundingClientRect();
        if (y > -1000) seen.add([x, y, width, height].map(Math.round).join(' '));
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
      return [...seen];
    });
    expect(places).toHaveLength(1);
    const covered = await tooltip.evaluate((element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      const corners = [
        [left + 12, top + 12],
        [right - 12, top + 12],
        [left + 12, bottom - 12],
        [right - 12, bottom - 12],
      ] as const;
      return corners.filter(([x, y]) => !element.contains((element.getRootNode() as ShadowRoot).elementFromPoint(x, y)))
        .length;
    });
    expect(covered).toBe(0);
    await page.mouse.move(width / 2, 890);
    await expect(tooltip).toHaveCount(0);
  }
});

test('the classroom checklist is selected in the setup form, and the levels of other rules are kept', async ({
  page,
}) => {
  await open(page);
  await openFile(page, 'own.nc', Buffer.from('O0001\n(RULES NO-PROGRAM-END=ERROR)\nG00 X40 Z2\n'));
  await expect(problems(page).getByRole('button', { name: /^Error: / })).toHaveCount(1);
  await page.getByRole('button', { name: /^Setup/ }).click();
  const form = page.getByRole('dialog', { name: 'Setup' });
  const checklist = form.getByLabel('Classroom checklist');
  await expect(checklist).toContainText('Off (assumed)');
  await checklist.selectOption('warning');
  await form.getByRole('button', { name: 'Apply' }).click();
  await expect.poll(() => value(page)).toContain('(RULES CLASSROOM=WARNING NO-PROGRAM-END=ERROR)');
  await expect(problems(page).getByRole('button', { name: /^Error: / })).toHaveCount(1);
});
