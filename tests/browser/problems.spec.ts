// The problems of a program: one count, one line per rule and code, filters, and links to the program and to the
// drawing.
import { chromiumTest, expect, test, type BasicPage, type Page } from './engines';
import {
  between,
  chooseLanguage,
  copy,
  drawing,
  editor,
  open,
  openFile,
  openProblems,
  problems,
  problemsButton,
  selected,
  settled,
  status,
  tooltip,
  type,
  value,
} from './page';
import { runBeforeWorker } from './worker-script';

/** Sixty-six unknown M codes, with one serious mistake among them, and a warning. */
const MANY = [
  'G99 T0101',
  'M3 S800',
  'G00 X50 Z2',
  ...Array.from({ length: 33 }, (_, i) => `M${300 + i}`),
  'G01 X40 Z- F0.2',
  ...Array.from({ length: 33 }, (_, i) => `M${400 + i}`),
  'G00 X60',
  'M30',
].join('\n');

const rows = (page: Page) => problems(page).getByRole('listitem');
const count = (page: Page) => problems(page).locator('.problems-head .count');

test('the list, the button over the program and the status show the same count, including collisions', async ({
  page,
}) => {
  await open(page);
  await type(page, '(STOCK D=50 LENGTH=80)\nG99 T0101\nM3 S800\nG00 X60 Z2\nG00 X40 Z-20\nG00 X60\nG00 X100 Z100\nM30');
  await settled(page);
  await openProblems(page);
  await expect(
    problems(page)
      .getByText(/runs into the work/)
      .first(),
  ).toBeVisible();
  const listed = Number(await count(page).textContent());
  expect(listed).toBeGreaterThan(0);
  await expect(status(page)).toContainText(listed === 1 ? '1 problem' : `${listed} problems`);
  const counts = (await problemsButton(page).getAttribute('aria-label'))?.match(/\d+/g) ?? [];
  expect(counts.reduce((sum, severity) => sum + Number(severity), 0)).toBe(listed);
});

test('a comment hides the message of its line, and without it the message is back', async ({ page }) => {
  await open(page);
  const program = (comment: string): string => `O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nM234${comment}\nM30\n`;
  await type(page, program(''));
  await settled(page);
  await openProblems(page);
  const row = rows(page).filter({ hasText: 'M234' });
  await expect(row).toHaveCount(1);
  await type(page, program(' (IGNORE RULE=UNKNOWN-M-CODE)'));
  await settled(page);
  await expect(row).toHaveCount(0);
  await type(page, program(''));
  await settled(page);
  await openProblems(page);
  await expect(row).toHaveCount(1);
});

test('the list opens by itself with a new program that has errors or warnings, never by typing', async ({ page }) => {
  const faulty = 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG6\nG1 Z-20 F0.2\nX44\nM30\n';
  const noted = 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2 M399\nG1 Z-20 F0.2\nX44\nM30\n';
  await open(page);
  await expect(problemsButton(page)).toHaveText('✓ no problems');
  await expect(problemsButton(page)).toBeDisabled();
  await expect(problems(page)).toBeHidden();

  await test.step('not by typing', async () => {
    await type(page, faulty);
    await settled(page);
    await expect(page.getByRole('button', { name: /^Problems: 1 error/ })).toBeVisible();
    await expect(problems(page)).toBeHidden();
    await expect(editor(page)).toBeFocused();
  });

  await test.step('by opening a file; Close closes it, and typing does not open it again', async () => {
    await openFile(page, 'faulty.nc', Buffer.from(faulty));
    await expect(problems(page)).toBeVisible();
    await expect(problemsButton(page)).toHaveAttribute('aria-expanded', 'true');
    await problems(page).getByRole('button', { name: 'Close' }).click();
    await expect(problems(page)).toBeHidden();
    await expect(problemsButton(page)).toBeFocused();
    await expect(problemsButton(page)).toHaveAttribute('aria-expanded', 'false');
    await editor(page).focus();
    await page.keyboard.press('Control+Home');
    await page.keyboard.insertText('G6\n');
    await expect(page.getByRole('button', { name: /^Problems: 2 errors/ })).toBeVisible();
    await expect(problems(page)).toBeHidden();
  });

  await test.step('not with a program that has only notes', async () => {
    await openFile(page, 'noted.nc', Buffer.from(noted));
    await expect(page.getByRole('button', { name: /^Problems: 1 note$/ })).toBeVisible();
    await settled(page);
    await expect(problems(page)).toBeHidden();
  });

  await test.step('by pasting a program', async () => {
    await copy(page, faulty);
    await editor(page).focus();
    await page.keyboard.press('Control+A');
    await page.keyboard.press('Control+V');
    await expect(problems(page)).toBeVisible();
    await expect(editor(page)).toBeFocused();
  });
});

/** One warning: it ends without M30. */
const WITHOUT_END = 'O0001 (STOCK D=50 LENGTH=60 GRIP=20)\nT0101\nG97 G99 S800 M03\nG00 X46 Z2 M08\nG01 Z-30 F0.2\nX52';

/** The name of the button over the program, once the current text has been reported; does not wait for a change. */
async function countsNow(page: BasicPage): Promise<string> {
  await settled(page);
  return (await problemsButton(page).getAttribute('aria-label')) ?? '';
}

test('a missing end is not reported while the last lines are typed', async ({ page }) => {
  await open(page);
  const marks = page.locator('.cm-lint-marker-warning');

  await test.step('but at once in a text that was inserted', async () => {
    await type(page, WITHOUT_END);
    expect(await countsNow(page)).toBe('Problems: 1 warning');
    await expect(marks).toHaveCount(1);
  });

  await test.step('not while it is typed: neither counted, nor marked, nor announced', async () => {
    await page.keyboard.press('Enter');
    await page.keyboard.type('G00 X200 Z200 M09');
    expect(await countsNow(page)).toBe('no problems');
    await expect(status(page)).toContainText('no problems');
    expect(await marks.count()).toBe(0);
    await page.keyboard.press('F8');
    await expect(page.locator('.cm-announced')).toHaveText('No problems');
  });

  await test.step('it is printed', async () => {
    await page.keyboard.type(' ');
    expect(await countsNow(page)).toBe('no problems');
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    await expect(page.locator('.sheet')).toContainText('The program ends without M30 or M02.');
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  });

  await test.step('when the cursor leaves the last lines', async () => {
    await page.keyboard.type(' ');
    expect(await countsNow(page)).toBe('no problems');
    await page.keyboard.press('ArrowUp');
    // No run follows that `settled` would wait for.
    await expect(page.getByRole('button', { name: 'Problems: 1 warning' })).toBeVisible();
    await expect(status(page)).toContainText('1 problem');
    await expect(marks).toHaveCount(1);
  });

  await test.step('after a pause', async () => {
    await page.keyboard.press('Control+End');
    await page.keyboard.press('Enter');
    expect(await countsNow(page)).toBe('no problems');
    await expect(page.getByRole('button', { name: 'Problems: 1 warning' })).toBeVisible();
    await expect(problems(page)).toBeHidden();
  });

  await test.step('typing before other blocks hides nothing', async () => {
    await page.keyboard.press('Control+Home');
    await page.keyboard.press('End');
    await page.keyboard.type(' ');
    expect(await countsNow(page)).toBe('Problems: 1 warning');
  });
});

test('a program that is opened or pasted after typing is reported at once', async ({ page }) => {
  await open(page);
  await type(page, '');
  await page.keyboard.type('O1');
  expect(await countsNow(page)).toBe('no problems');
  await openFile(page, 'no-end.nc', Buffer.from(WITHOUT_END));
  await expect.poll(() => value(page)).toBe(WITHOUT_END);
  expect(await countsNow(page)).toBe('Problems: 1 warning');
  await copy(page, `${WITHOUT_END}\n`);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await page.keyboard.type('O2');
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Control+V');
  await expect.poll(() => value(page)).toBe(`${WITHOUT_END}\n`);
  expect(await countsNow(page)).toBe('Problems: 1 warning');
});

const PLACEHOLDERS = {
  en: 'Write or paste a program',
  zh: '在此编写或粘贴程序',
  ru: 'Напишите или вставьте программу',
} as const;

test('an empty program has a placeholder and no problem', async ({ page }) => {
  await open(page);
  await type(page, '');
  expect(await countsNow(page)).toBe('no problems');
  await expect(status(page)).toContainText('no problems');
  for (const locale of ['en', 'zh', 'ru'] as const) {
    await chooseLanguage(page, locale);
    await expect(page.locator('.cm-placeholder')).toContainText(PLACEHOLDERS[locale]);
    await expect(problemsButton(page)).toHaveText(/no problems|没有问题|замечаний нет/);
  }
});

test('the caret stays in view when the list opens and when the window becomes lower', async ({ page }) => {
  const isCaretInView = (): Promise<boolean> =>
    page.locator('.cm-activeLine').evaluate((line) => {
      const [{ top, bottom }, outer] = [
        line.getBoundingClientRect(),
        line.closest('.cm-scroller')!.getBoundingClientRect(),
      ];
      return top >= outer.top && bottom <= outer.bottom;
    });
  await open(page);
  await type(page, `${'G01 X40 Z-5 F0.2\n'.repeat(60)}G01 X4O\nM30\n`);
  await countsNow(page);
  await page.keyboard.press('Control+Home');
  const lowest = await page.locator('.cm-line').evaluateAll((lines) => {
    const bottom = lines[0]!.closest('.cm-scroller')!.getBoundingClientRect().bottom;
    return lines.filter((line) => line.getBoundingClientRect().bottom <= bottom).length;
  });
  for (let line = 1; line < lowest; line++) await page.keyboard.press('ArrowDown');
  await expect.poll(isCaretInView).toBe(true);
  await openProblems(page);
  await expect.poll(isCaretInView).toBe(true);
  await problemsButton(page).click();
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let line = 1; line < lowest; line++) await page.keyboard.press('ArrowDown');
  await page.setViewportSize({ width: 1440, height: 600 });
  await expect.poll(isCaretInView).toBe(true);
});

test('the list opens by itself if the part of the new program takes longer than its path', async ({ page }) => {
  const passes = Array.from({ length: 600 }, (_, at) => `X${(99.9 - 0.1 * at).toFixed(2)} Z-${80 - (at % 40)}`);
  const begin = '(STOCK D=100 LENGTH=120)\nT0101\nG99 M03 S900\nG00 X102 Z2\nG90 F0.25';
  const long = `${begin} ${passes.join('\n')}\nG6\nG00 X150 Z50\nM30\n`;
  await open(page);
  await openFile(page, 'long.nc', Buffer.from(long));
  await expect(problems(page)).toBeVisible();
  await problemsButton(page).click();
  await expect(problems(page)).toBeHidden();
  await settled(page);
  await type(page, 'G0 X50 Z-\nM30');
  await settled(page);
  await expect(problems(page)).toBeHidden();
});

test('problems of one rule with one code share one line with their line numbers', async ({ page }) => {
  await open(page);
  await type(page, MANY);
  await openProblems(page);
  await expect(count(page)).toHaveText(/6[67]|68/);
  const group = rows(page).filter({ hasText: 'M300' });
  await expect(group).toContainText('66 places');
  expect(await rows(page).count()).toBeLessThan(5);

  await test.step('problems are sorted by severity or by line', async () => {
    await expect(
      rows(page)
        .first()
        .getByRole('button', { name: /^Error: / }),
    ).toBeVisible();
    await problems(page).getByLabel('Order of the problems').selectOption('place');
    await expect(rows(page).first()).toContainText('M300');
    await problems(page).getByLabel('Order of the problems').selectOption('severity');
    await expect(
      rows(page)
        .first()
        .getByRole('button', { name: /^Error: / }),
    ).toBeVisible();
  });

  await test.step('a line number leads to its block', async () => {
    await group.getByRole('button', { name: 'line 6', exact: true }).click();
    await expect.poll(() => selected(page)).toBe('M302');
    await expect(editor(page)).toBeFocused();
  });

  await test.step('all line numbers are shown on request', async () => {
    await expect(group.getByRole('button', { name: 'line 60', exact: true })).toHaveCount(0);
    await group.getByRole('button', { name: '56 more' }).click();
    await group.getByRole('button', { name: 'line 60', exact: true }).click();
    await expect.poll(() => selected(page)).toBe('M422');
  });
});

test('problems are filtered by severity and rule, and the count does not change', async ({ page }) => {
  await open(page);
  await type(page, MANY);
  await openProblems(page);
  await expect(rows(page).filter({ hasText: 'M300' })).toHaveCount(1);
  const all = await count(page).textContent();
  const notes = problems(page).getByRole('button', { name: /notes$/ });
  await notes.click();
  await expect(notes).toHaveAttribute('aria-pressed', 'false');
  await expect(rows(page).filter({ hasText: 'M300' })).toHaveCount(0);
  await expect(count(page)).toHaveText(new RegExp(`^\\d of ${all}$`));
  await expect(status(page)).toContainText(`${all} problems`);
  await notes.click();
  await problems(page).getByLabel('Rule', { exact: true }).selectOption('unknown-m-code');
  await expect(rows(page)).toHaveCount(1);
  await problems(page).getByLabel('Rule', { exact: true }).selectOption('');
  await expect(
    rows(page)
      .first()
      .getByRole('button', { name: /^Error: / }),
  ).toBeVisible();
});

test('a rule can be hidden everywhere in one step, and shown again', async ({ page }) => {
  await open(page);
  await type(page, MANY);
  await openProblems(page);
  await problems(page).getByRole('button', { name: 'Hide this rule here: unknown-m-code' }).click();
  await expect(rows(page).filter({ hasText: 'M300' })).toHaveCount(0);
  await expect(status(page)).toContainText(/\b[12] problems?/);
  await expect(page.locator('.cm-lintRange-info').filter({ hasText: 'M302' })).toHaveCount(0);
  await expect(problems(page)).toContainText('1 rule is hidden here');
  await problems(page).getByRole('button', { name: 'Show unknown-m-code' }).click();
  await expect(rows(page).filter({ hasText: 'M300' })).toHaveCount(1);
  // An error means that a motion is missing, so it cannot be hidden by a click.
  await expect(rows(page).first().getByRole('button', { name: /^Hide/ })).toHaveCount(0);
});

test('a marker in the gutter disappears with its text', async ({ page }) => {
  await open(page);
  await type(page, 'G99 M3 S800\nG00 X50 Z2\n');
  const dots = page.locator('.cm-lint-marker-error');
  await page.keyboard.type('G6');
  await expect(dots).toHaveCount(1);
  await page.keyboard.press('Backspace');
  await page.keyboard.press('Backspace');
  await page.keyboard.type('X42');
  await expect.poll(() => value(page)).toBe('G99 M3 S800\nG00 X50 Z2\nX42');
  await settled(page);
  await expect(dots).toHaveCount(0);

  await test.step('a marker moves with its line', async () => {
    await page.keyboard.type('\nG6');
    await expect(dots).toHaveCount(1);
    await page.keyboard.press('Home');
    await page.keyboard.press('Enter');
    await settled(page);
    await expect(dots).toHaveCount(1);
    const [dot, line] = await Promise.all([dots.boundingBox(), page.locator('.cm-line').last().boundingBox()]);
    expect(Math.abs(dot!.y + dot!.height / 2 - line!.y - line!.height / 2)).toBeLessThan(6);
  });
});

test('the tooltip of a marker is above its line, and its repair works', async ({ page }) => {
  await open(page);
  await type(page, 'G99 M3 S800\n\n\n\n\n\n\n\nG00 X60 Z–2\nG00 X50\nM30');
  await settled(page);
  await page.locator('.cm-lint-marker').first().hover();
  const popUp = page.locator('.cm-tooltip');
  await expect(popUp.getByRole('button').first()).toBeVisible();
  const line = page.locator('.cm-line', { hasText: 'Z–2' });
  const [shown, own] = await Promise.all([popUp.boundingBox(), line.boundingBox()]);
  expect(shown!.y + shown!.height).toBeLessThan(own!.y + own!.height / 4);
  await popUp.getByRole('button').first().click();
  await expect.poll(() => value(page)).toContain('X60 Z-2');

  await test.step('the tooltip of a word is above it, also in the first line', async () => {
    await type(page, 'G00 X60 Z–2\nG00 X50\nM30');
    await settled(page);
    const word = page.locator('.cm-lintRange').first();
    await word.hover();
    await expect(popUp.getByRole('button').first()).toBeVisible();
    const [shown, own] = await Promise.all([popUp.boundingBox(), word.boundingBox()]);
    expect(shown!.y + shown!.height).toBeLessThan(own!.y + own!.height / 2);
  });
});

test('a selected problem highlights its stroke', async ({ page }) => {
  await open(page);
  await type(page, 'G99 T0101\nM3 S800\nG00 X50 Z2\nG01 Z-20 F0.2 M399\nX60\nG00 X100 Z100\nM30');
  await settled(page);
  await openProblems(page);
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await settled(page);
  const place = await between(page, { x: 50, z: 2 }, { x: 50, z: -20 });
  const before = await pixels(page, place);
  await rows(page).filter({ hasText: 'M399' }).getByRole('button', { name: /M399/ }).first().click();
  await expect.poll(() => selected(page)).toBe('M399');
  await expect.poll(async () => (await pixels(page, place)) === before).toBe(false);
});

test('the problem selected by F8 is announced', async ({ page }) => {
  await open(page);
  await type(page, 'G99 M3 S800\nG00 X50 Z2\nM399\nG01 X60 Z- F0.2\nM30');
  await settled(page);
  const live = page.locator('.cm-announced');
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('F8');
  await expect(live).toHaveText(/Problem 1 of \d, line 3\. Note: .*M399/);
  await page.keyboard.press('F8');
  await expect(live).toHaveText(/Problem 2 of \d, line 4\. Error: /);
  await drawing(page).focus();
  await page.keyboard.press('Shift+F8');
  await expect(live).toHaveText(/line 3\. Note: /);
});

const CONTOUR = [
  'G99 T0101',
  'M3 S800',
  'G00 X52 Z2',
  'G71 U2 R0.5',
  'G71 P10 Q20 U0.4 W0.1 F0.25',
  'N10 G00 X20',
  'G01 Z-15',
  'X30 Z-25',
  'X40',
  'N20 G01 X50 Z-40',
  'G70 P10 Q20 F0.1',
  'G00 X100 Z100',
  'M30',
].join('\n');

/** Places the cursor after `X30 Z-25` of the contour. */
async function toTypedBlock(page: BasicPage): Promise<void> {
  await page.keyboard.press('Control+Home');
  for (let i = 0; i < 7; i++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
}

test('while a word of a contour is typed, the previous picture stays, labelled as such', async ({ page }) => {
  await open(page);
  await type(page, CONTOUR);
  await settled(page);
  const motions = Number(/(\d+) motions/.exec((await drawing(page).getAttribute('aria-label')) ?? '')?.[1]);
  expect(motions).toBeGreaterThan(20);
  await toTypedBlock(page);
  await settled(page);
  const place = await between(page, { x: 30, z: -25 }, { x: 40, z: -25 });
  const old = page.getByText(/^Old picture \(run \d+\)/);
  await expect(old).toBeHidden();
  // `X30 Z-25` becomes `X30 Z-2`, `X30 Z-`, `X30 Z`.
  for (let i = 0; i < 2; i++) await page.keyboard.press('Backspace');
  await settled(page);
  await expect(old).toBeVisible();
  await expect(status(page)).not.toContainText(`${motions} motions`);
  await expect(page.getByRole('button', { name: /^Problems: \d+ errors?\b/ })).toBeVisible();
  expect(await drawing(page).getAttribute('aria-label')).toContain(`${motions} motions`);

  await test.step('the pointer finds no motions of the new run there', async () => {
    await page.mouse.move(place.x, place.y);
    await page.mouse.move(place.x + 1, place.y);
    await settled(page);
    await expect(tooltip(page)).toBeHidden();
  });

  await test.step('the picture is updated when the word is complete', async () => {
    await page.keyboard.type('26');
    await expect(old).toBeHidden();
    await expect(status(page)).toContainText(`${motions} motions`);
  });

  await test.step('leaving the block shows the current path of the program', async () => {
    for (let i = 0; i < 2; i++) await page.keyboard.press('Backspace');
    await expect(old).toBeVisible();
    // The list of proposals opens a moment after the last key and would take ArrowDown, so use Ctrl+Home.
    await page.keyboard.press('Control+Home');
    await expect(old).toBeHidden();
    await expect(drawing(page)).not.toHaveAttribute('aria-label', new RegExp(`\\b${motions} motions`));
  });
});

test('the list opens without problems if a rule is hidden', async ({ page }) => {
  await open(page);
  await type(page, 'T0101\nG97 S500 M03\nG00 X60 Z5\nM30\n');
  await settled(page);
  const toggle = page.getByRole('button', { name: 'No problems' });
  await expect(toggle).toBeDisabled();
  await page.locator('gcode-playground').evaluate((element) => {
    (element as unknown as { setup: string }).setup = '{"rules": {"cut-too-deep": "off"}}';
  });
  await settled(page);
  await toggle.click();
  await expect(problems(page).getByRole('button', { name: /cut-too-deep/ })).toBeVisible();
});

test('the legend belongs to the previous picture while it stays, and then to the current one', async ({ page }) => {
  await open(page);
  await type(page, 'G50 X60 Z40\nG00 X32 Z2 M03 S500\nG90 X26 Z-20 F0.2\nG00 X60 Z40\nM30\n');
  await settled(page);
  const legend = page.locator('.legend');
  await expect(legend).toContainText('cut off the blank');
  await page.keyboard.press('Control+Home');
  for (let i = 0; i < 2; i++) await page.keyboard.press('ArrowDown');
  await settled(page);
  // `G90` becomes `90`: nothing is cut.
  await page.keyboard.press('Delete');
  await settled(page);
  await expect(page.getByText(/^Old picture \(run \d+\)/)).toBeVisible();
  await expect(legend).toContainText('cut off the blank');
  await page.keyboard.press('Control+Home');
  await settled(page);
  await expect(legend).toContainText('rapid');
  await expect(legend).not.toContainText('cutting');
  await expect(legend).not.toContainText('cut off the blank');
});

chromiumTest('a picture that stays has the colours that were chosen before its run', async ({ page }) => {
  // The worker receives the palette immediately before the run, so that the run cancels the drawing.
  await runBeforeWorker(
    page,
    `
    let held;
    self.addEventListener('message', (event) => {
      const content = event.data?.content;
      if (content?.kind === 'palette' && self.holdsPalettes === true) {
        event.stopImmediatePropagation();
        held = event.data;
      } else if (content?.kind === 'run' && held !== undefined) {
        self.holdsPalettes = false;
        const palette = held;
        held = undefined;
        event.stopImmediatePropagation();
        self.dispatchEvent(new MessageEvent('message', { data: palette }));
        self.dispatchEvent(new MessageEvent('message', { data: event.data }));
      }
    });
  `,
  );
  await open(page);
  await type(page, CONTOUR);
  await settled(page);
  await toTypedBlock(page);
  const { x, y, width } = (await drawing(page).boundingBox())!;
  const corner = { x: x + width - 20, y: y + 20 };
  const light = await pixels(page, corner);
  await page.workers()[0]!.evaluate(() => Object.assign(self, { holdsPalettes: true }));
  await page.locator('gcode-playground').evaluate((element) => element.setAttribute('theme', 'dark'));
  await page.keyboard.press('Backspace');
  await expect.poll(() => pixels(page, corner)).not.toBe(light);
});

chromiumTest('leaving the block during its run shows the current path of the program', async ({ page }) => {
  // The worker receives the cursor move after the first slice of the run.
  await runBeforeWorker(
    page,
    `
    let held;
    self.addEventListener('message', (event) => {
      const content = event.data?.content;
      if (content?.kind === 'run' && self.holdsRuns === true) {
        event.stopImmediatePropagation();
        held = event.data;
        self.holdsRuns = false;
      } else if (content?.kind === 'cursor' && held !== undefined) {
        const run = held;
        held = undefined;
        // End the first slice immediately.
        const now = performance.now;
        let late = 0;
        performance.now = () => now.call(performance) + (late += 1_000);
        self.dispatchEvent(new MessageEvent('message', { data: run }));
        performance.now = now;
      }
    });
  `,
  );
  await open(page);
  const further = Array.from({ length: 2_000 }, (_, at) => `G01 X${60 + (at % 40)} Z${5 + (at % 7)} F0.2`).join('\n');
  await openFile(page, 'contour.nc', Buffer.from(`${CONTOUR.replace('M30', further)}\nM30`));
  // The file is read in a worker: until its text is in the editor, keys go to the program before it.
  await expect.poll(() => value(page)).toContain(further);
  await editor(page).focus();
  await settled(page);
  await toTypedBlock(page);
  await settled(page);
  await page.workers()[0]!.evaluate(() => Object.assign(self, { holdsRuns: true }));
  await page.keyboard.press('Backspace');
  await expect
    .poll(() => page.workers()[0]!.evaluate(() => (self as unknown as { holdsRuns: boolean }).holdsRuns))
    .toBe(false);
  await page.keyboard.press('ArrowDown');
  await settled(page);
  await expect(page.getByText(/^Old picture \(run \d+\)/)).toBeHidden();
  await openProblems(page);
  await expect(
    rows(page)
      .first()
      .getByRole('button', { name: /^Error: / }),
  ).toBeVisible();
});

/** Pixels of the drawing around a position. */
async function pixels(page: Page, place: { x: number; y: number }): Promise<string> {
  await settled(page);
  return page.locator('gcode-playground').evaluate((element, { x, y }) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const { left, top, width } = canvas.getBoundingClientRect();
    const [scale, size] = [canvas.width / width, 12];
    const copy = Object.assign(document.createElement('canvas'), { width: size, height: size }).getContext('2d')!;
    copy.drawImage(canvas, (x - left) * scale - size / 2, (y - top) * scale - size / 2, size, size, 0, 0, size, size);
    return copy.getImageData(0, 0, size, size).data.join();
  }, place);
}
