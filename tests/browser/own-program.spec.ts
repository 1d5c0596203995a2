// Own programs: a text that replaces the previous one is a new program with its own context, and one undo restores the
// previous program with its context. The program of a link stays in the URL until the text differs.
import { expect, test, type Page } from './engines';
import {
  chip,
  chooseControl,
  copy,
  editor,
  open,
  openFile,
  openProblems,
  problems,
  program,
  reload,
  status,
  titleText,
  value,
} from './page';

const OWN = 'G00 X32 Z2\nG90 X28 Z-30 F0.2\n';
/** An example for a GSK control with its own blank. */
const EXAMPLE = 's000-o0002';

/** Attributes of the element that affect the run. */
const context = (page: Page): Promise<Record<string, string | null>> =>
  page.locator('gcode-playground').evaluate((element) => {
    const { control, setup, blockSkip, program, origin } = element as unknown as Record<
      'control' | 'setup' | 'blockSkip' | 'program' | 'origin',
      string | null
    >;
    return { control, setup, blockSkip, program, origin };
  });

const NEUTRAL = { control: null, setup: null, blockSkip: null, program: null, origin: null };
/** The button for the description, which only an example has. */
const about = (page: Page) => page.getByRole('button', { name: 'About this program' });

async function expectOwn(page: Page, name = 'My own program'): Promise<void> {
  await expect.poll(() => context(page)).toEqual(NEUTRAL);
  await expect(chip(page)).toContainText('FANUC');
  await expect(titleText(page)).toHaveText(name);
  await expect(about(page)).toBeHidden();
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeVisible();
}

async function expectExample(page: Page, before: Record<string, string | null>): Promise<void> {
  await expect.poll(() => value(page)).toBe(program(EXAMPLE));
  await expect.poll(() => context(page)).toEqual(before);
  await expect(chip(page)).toContainText('GSK 980TD');
  await expect(titleText(page)).toHaveText('Steps and a cone from one Ø125 blank');
  await expect(about(page)).toBeVisible();
  await expect.poll(() => address(page)).toMatch(/#s000-o0002$/);
}

/** Like a paste over the whole text. */
async function pasteOver(page: Page, text: string): Promise<void> {
  await copy(page, text);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Control+V');
}

const address = (page: Page): Promise<string> => page.evaluate(() => location.href);

test('a text that replaces everything is a new program, and one undo restores the example', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  const before = await context(page);
  expect(before).toMatchObject({ control: 'gsk', origin: EXAMPLE });

  const ways: readonly (readonly [string, () => Promise<unknown>])[] = [
    ['pasted', () => pasteOver(page, OWN)],
    [
      'typed',
      async () => {
        await editor(page).focus();
        await page.keyboard.press('Control+A');
        await page.keyboard.insertText(OWN);
      },
    ],
    ['opened', () => openFile(page, 'own.nc', Buffer.from(OWN))],
  ];
  for (const [how, act] of ways) {
    await test.step(how, async () => {
      await act();
      await expect.poll(() => value(page)).toBe(OWN);
      await expectOwn(page, how === 'opened' ? 'own.nc' : undefined);
      await openProblems(page);
      await expect(problems(page).getByRole('listitem').first()).toBeVisible();
      await expect(problems(page).getByText(/stock/i)).toHaveCount(0);
      await editor(page).focus();
      await page.keyboard.press('Control+z');
      await expectExample(page, before);
    });
  }
  await test.step('redo restores the own program without them', async () => {
    await page.keyboard.press('Control+Shift+z');
    await expect.poll(() => value(page)).toBe(OWN);
    await expectOwn(page, 'own.nc');
  });
});

test('a program that is cut and pasted again is the same program', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  const before = await context(page);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await expect.poll(() => context(page)).toEqual(NEUTRAL);
  await pasteOver(page, program(EXAMPLE).replace('F', 'F0'));
  await expect.poll(() => context(page)).toEqual(before);
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await pasteOver(page, OWN);
  await expectOwn(page);
});

test('switches and tools of the previous program do not affect the next one', async ({ page }) => {
  await open(page, '#s002-g121-square');
  await page.locator('gcode-playground').evaluate((element) => {
    element.setAttribute('block-skip', '1');
    element.setAttribute('program', '7');
  });
  await pasteOver(page, 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX44\nG0 X100 Z100\nM30\n');
  await expect.poll(() => context(page)).toEqual(NEUTRAL);
  await expect(page.getByText('Tools assumed')).toBeVisible();
  await expect(status(page)).toContainText(/^4 motions/);
});

test('an edit, and a text that keeps most of the program, keep its context', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  const before = await context(page);
  const text = program(EXAMPLE);
  await pasteOver(page, text.replace(/Z-?\d+/, 'Z-12').toLowerCase());
  await expect.poll(() => context(page)).toEqual(before);
  await pasteOver(page, `${text}${'G4 X1\n'.repeat(100)}`);
  await expect.poll(() => context(page)).toEqual(before);
  await expect(about(page)).toBeVisible();
  // The description does not fit the few lines that are left.
  await pasteOver(page, text.split('\n').slice(0, 4).join('\n'));
  await expect.poll(() => context(page)).toEqual(before);
  await expect(about(page)).toBeHidden();
});

test('a text set by the host page keeps the attributes set by the host page', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  const before = await context(page);
  await page
    .locator('gcode-playground')
    .evaluate((element, text) => void ((element as unknown as { value: string }).value = text), OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  expect(await context(page)).toEqual(before);
});

test('setting the current text again after each key keeps cursor and history', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  await page.locator('gcode-playground').evaluate((element) =>
    element.addEventListener('gcode-change', (event) => {
      (element as unknown as { value: string }).value = (event as CustomEvent<{ value: string }>).detail.value;
    }),
  );
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type('(HELLO)');
  await expect.poll(() => value(page)).toBe(`${program(EXAMPLE)}(HELLO)`);
  await page.keyboard.press('Control+z');
  await expect.poll(() => value(page)).toBe(program(EXAMPLE));
});

test('attributes that the host page sets together with a text apply to that text', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  await page.locator('gcode-playground').evaluate((element, text) => {
    element.setAttribute('setup', '{"stock": {"diameter": 60, "length": 80}}');
    (element as unknown as { value: string }).value = text;
  }, OWN);
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeHidden();
  expect(await context(page)).toMatchObject({ setup: '{"stock": {"diameter": 60, "length": 80}}' });
});

test('an own program is restored by a reload', async ({ page }) => {
  await open(page, `#${EXAMPLE}`);
  await pasteOver(page, OWN);
  await expectOwn(page);
  await expect.poll(() => address(page)).not.toContain('#');
  await reload(page);
  await expect.poll(() => value(page)).toBe(OWN);
  await expectOwn(page);
});

test('the program of a link stays in the URL until the text differs', async ({ page }) => {
  const hash = `#program=${encodeURIComponent('O0001\nG00 X20 Z2\nG01 Z-10 F0.1\nM30\n')}`;
  await open(page, hash);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('G');
  await page.keyboard.press('Backspace');
  await chooseControl(page, 'gsk');
  await expect(chip(page)).toContainText('GSK 980TD');
  await page.waitForTimeout(600);
  expect(await address(page)).toContain('#program=');

  await editor(page).focus();
  await page.keyboard.insertText('G04 X1\n');
  const linkNotice = page.getByText('This program is from a link');
  await expect(linkNotice).toBeVisible();
  expect(await address(page)).not.toContain('#program=');
  await page.getByRole('button', { name: 'Open the link again' }).click();
  await expect.poll(() => value(page)).toBe('O0001\nG00 X20 Z2\nG01 Z-10 F0.1\nM30\n');
  expect(await address(page)).toContain('#program=');
  await expect(linkNotice).toBeHidden();
});
