// The switches of the operator's panel: they are shown if the text uses them, and are part of the interpreter's setup.
import { expect, test, type Page } from './engines';
import { chip, chooseLanguage, open, openFile, openReading, reading, reload, status, type } from './page';

const PROGRAMS =
  'O0001\n/G0 X50 Z2\nN20 /3 G0 X40\n(a/2 b)\nG0 X30 /M8\n#1=#2/4\nM30\nO0007 (second)\n/2 G0 X10\nM30\n';

const skip = (page: Page, mark: string) => page.getByRole('switch', { name: `Block skip ${mark}`, exact: true });
const chosen = (page: Page) => page.getByRole('combobox', { name: 'Program to run' });

interface Setup {
  readonly blockSkip?: readonly number[];
  readonly program?: number;
}

/** Records messages of the page to its worker. */
async function listen(page: Page): Promise<() => Promise<Setup>> {
  await page.addInitScript(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
      const { setup } = (message as { content?: { setup?: string } }).content ?? {};
      if (setup !== undefined) Reflect.set(window, 'lastSetup', setup);
      Reflect.apply(post, this, [message, ...rest]);
    };
  });
  return () => page.evaluate(() => JSON.parse(Reflect.get(window, 'lastSetup') as string) as Setup);
}

test('switches are shown for the block-skip levels and programs of the text, and are part of the setup', async ({
  page,
}, info) => {
  const setup = await listen(page);
  await open(page);
  await openReading(page);
  await expect(page.getByRole('switch')).toHaveCount(0);
  await expect(chosen(page)).toHaveCount(0);
  await page.keyboard.press('Escape');
  expect(await setup()).not.toHaveProperty('blockSkip');
  expect(await setup()).not.toHaveProperty('program');

  await type(page, PROGRAMS);
  await openReading(page);
  await expect(page.getByRole('switch')).toHaveText(['/', '/2', '/3']);
  await expect(chosen(page).getByRole('option')).toHaveText(['O0001', 'O0007']);
  await expect(chosen(page)).toHaveValue('1');
  await expect(status(page)).toContainText(/\b3 motions/);

  await test.step('by keyboard', async () => {
    await page.keyboard.press('Escape');
    await chip(page).focus();
    await page.keyboard.press('Enter');
    await skip(page, '/2').focus();
    await page.keyboard.press('Space');
    await expect(skip(page, '/2')).toHaveAttribute('aria-checked', 'true');
    await expect(skip(page, '/2')).toBeFocused();
    expect((await setup()).blockSkip).toEqual([2]);
    await chosen(page).focus();
    await page.keyboard.press('ArrowDown');
    await expect(chosen(page)).toHaveValue('7');
    expect(await setup()).toMatchObject({ blockSkip: [2], program: 7 });
  });
  await skip(page, '/').click();
  expect((await setup()).blockSkip).toEqual([1, 2]);
  await skip(page, '/2').click();
  expect((await setup()).blockSkip).toEqual([1]);
  await expect(page.locator('gcode-playground')).toHaveAttribute('block-skip', '1');
  await expect(page.locator('gcode-playground')).toHaveAttribute('program', '7');
  await expect(status(page)).toContainText(/\b1 motion/);
  await page.screenshot({ path: info.outputPath('switches.png') });

  await test.step('stored with the text', async () => {
    await reload(page);
    await openReading(page);
    await expect(skip(page, '/')).toHaveAttribute('aria-checked', 'true');
    await expect(skip(page, '/2')).toHaveAttribute('aria-checked', 'false');
    await expect(chosen(page)).toHaveValue('7');
    expect(await setup()).toMatchObject({ blockSkip: [1], program: 7 });
  });

  await test.step('a selected program that no longer exists can be deselected', async () => {
    await type(page, 'O0001\nG0 X50 Z2\nM30\n');
    await page.locator('gcode-playground').evaluate((element) => element.setAttribute('program', '7'));
    await expect(chosen(page).getByRole('option')).toHaveText(['O0001', 'O0007 ?']);
    await chosen(page).selectOption('1');
    await expect(page.getByRole('switch')).toHaveCount(0);
    await expect(chosen(page)).toHaveCount(0);
    await expect(reading(page)).toBeVisible();
    await page.keyboard.press('Escape');
  });

  await test.step('another program starts with the switches unset', async () => {
    await page.getByRole('button', { name: 'Open the first example' }).click();
    expect(await setup()).not.toHaveProperty('blockSkip');
    expect(await setup()).not.toHaveProperty('program');
    await openReading(page);
    await expect(page.getByRole('switch')).toHaveCount(0);
  });
});

test('programs with names are selected by name', async ({ page }) => {
  const setup = await listen(page);
  await open(page);
  await openReading(page);
  await type(page, '<SHAFT-1>\nG0 X50 Z2\nM30\nO<bush>\nG0 X10\nX20\nM30\nO0007<DISC>\nM30\n');
  await expect(chosen(page).getByRole('option')).toHaveText(['<SHAFT-1>', '<bush>', 'O0007']);
  await expect(status(page)).toContainText(/\b1 motion/);
  await chosen(page).selectOption('<bush>');
  await expect(status(page)).toContainText(/\b2 motions/);
  await chosen(page).selectOption('<SHAFT-1>');
  expect((await setup()).program ?? 1_254_805_063).toBe(1_254_805_063);
});

test('switches are set by attributes, and have labels in Chinese and Russian', async ({ page }) => {
  const setup = await listen(page);
  await open(page);
  await type(page, PROGRAMS);
  await page.locator('gcode-playground').evaluate((element) => {
    element.setAttribute('block-skip', '1, 3');
    element.setAttribute('program', '7');
  });
  expect(await setup()).toMatchObject({ blockSkip: [1, 3], program: 7 });
  await openReading(page);
  await expect(skip(page, '/3')).toHaveAttribute('aria-checked', 'true');
  await expect(skip(page, '/2')).toHaveAttribute('aria-checked', 'false');
  await chooseLanguage(page, 'zh');
  await openReading(page);
  await expect(page.getByRole('switch', { name: '程序段跳过 /3' })).toBeVisible();
  await expect(page.getByRole('combobox', { name: '要运行的程序' })).toHaveValue('7');
  await chooseLanguage(page, 'ru');
  await openReading(page);
  await expect(page.getByRole('switch', { name: 'Пропуск кадров /3' })).toBeVisible();
  await expect(page.getByRole('combobox', { name: 'Выполняемая программа' })).toHaveValue('7');
  await expect(status(page)).toContainText(/\d/);
});

test('deleting lines while a long text is still being scanned hides no switch', async ({ page }) => {
  // The worker gets the change immediately after it has scanned the first lines, earlier than a user could type it.
  await page.addInitScript(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...rest: unknown[]) {
      Reflect.apply(post, this, [message, ...rest]);
      const { session, content } = message as {
        session?: number;
        content?: { run?: number; text?: { kind: string; pieces?: string[] } };
      };
      const { run, text } = content ?? {};
      if (text?.kind !== 'text' || (text.pieces?.join('').length ?? 0) < 200_000) return;
      this.addEventListener(
        'message',
        ({ data: { event } }: MessageEvent<{ event?: { kind: string; inText?: unknown } }>) => {
          if (event?.kind === 'switches') Reflect.set(window, 'switchesTold', event.inText);
        },
      );
      Reflect.apply(post, this, [{ kind: 'to-session', session, content: { kind: 'stop' } }]);
      const edit = { kind: 'edit', changes: [{ from: 0, to: 99_000, insert: '' }] };
      Reflect.apply(post, this, [
        { kind: 'to-session', session, content: { kind: 'run', run, text: edit, tried: [], framing: 'keep' } },
      ]);
    };
  });
  await open(page);
  await openFile(page, 'long.nc', Buffer.from(`${'\n'.repeat(100_000)}/3 X2\n${'\n'.repeat(100_000)}/5 X2\n`));
  await expect
    .poll(() => page.evaluate(() => Reflect.get(window, 'switchesTold') as unknown))
    .toMatchObject({ blockSkip: [3, 5] });
});
