// Playing a program: steps, stops, the readout, and the text that follows. playing-smoothly.spec.ts measures its cost.
import { expect, test, type Page, nightUnless } from './engines';
import { editor, motionCount, open, openFile, program, status, type } from './page';

const slider = (page: Page) => page.getByRole('slider', { name: 'Position along the path' });
const share = async (page: Page): Promise<number> => Number(await slider(page).inputValue());
/** The value beside a label of the readout. */
const shown = (page: Page, name: string) =>
  page.locator('.cell', { has: page.locator('dt', { hasText: new RegExp(`^${name}$`) }) }).locator('dd');
const running = (page: Page) => page.locator('.cm-running-line');
/** The popover of speed, steps and stops. */
const options = (page: Page) => page.getByRole('dialog', { name: 'Speed and steps' });
const optionsButton = (page: Page) => page.getByRole('button', { name: /^Speed and steps: / });

async function setSpeed(page: Page, speed: string): Promise<void> {
  await optionsButton(page).click();
  await options(page).getByRole('combobox', { name: 'Speed' }).selectOption(speed);
  await optionsButton(page).click();
  await expect(options(page)).toBeHidden();
  await expect(optionsButton(page)).toHaveText(speed);
}

const STOPS = 'T0101\nG99 M03 S500\nG00 X50 Z2\nG01 Z-10 F0.2\nM01\nG00 X60\nZ2\nM00\nG00 X80\nM30\n';

async function load(page: Page, text: string, motions: number): Promise<void> {
  await openFile(page, 'part.nc', Buffer.from(text));
  await expect(status(page)).toContainText(new RegExp(`^${motions.toLocaleString('en')} motion`));
}

test('steps go forward and back by motion, block and pass, by keyboard', async ({ page }) => {
  await open(page);
  await load(page, 'M03 S500\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nX45\nG00 X100\nM30\n', 10);
  await editor(page).focus();
  const at = async (key: string, line: string, x: string, z: string): Promise<void> => {
    await page.keyboard.press(key);
    await expect(running(page)).toHaveText(line);
    await expect(shown(page, 'X Ø')).toHaveText(x);
    await expect(shown(page, 'Z')).toHaveText(z);
  };
  await at('F9', 'G00 X62 Z2', '62.000', '2.000');
  await at('F9', 'G90 X50 Z-30 F0.2', '50.000', '2.000');
  await at('Alt+F9', 'G90 X50 Z-30 F0.2', '62.000', '2.000');
  await at('Control+F9', 'X45', '62.000', '2.000');
  await at('Shift+F9', 'X45', '62.000', '−30.000');
  await at('Alt+Shift+F9', 'G90 X50 Z-30 F0.2', '62.000', '2.000');
  await at('Control+Shift+F9', 'G00 X62 Z2', '62.000', '2.000');
  await optionsButton(page).click();
  await options(page).getByRole('combobox', { name: 'Step by' }).selectOption('block');
  await page.getByRole('button', { name: 'Next block' }).click();
  await expect(running(page)).toHaveText('G90 X50 Z-30 F0.2');
});

test('playback stops at M00, at M01 if optional stop is on, and resumes from there', async ({ page }) => {
  await open(page);
  await load(page, STOPS, 5);
  const doing = page.locator('.doing');
  await setSpeed(page, '50×');
  const held = async (code: string, line: number): Promise<void> => {
    await expect(doing).toContainText(`${code} in line ${line}`);
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
    await expect(running(page)).toHaveText(code);
  };
  await editor(page).focus();
  await page.keyboard.press('Control+Enter');
  await held('M01', 5);
  await page.keyboard.press('Control+Enter');
  await held('M00', 8);
  await page.keyboard.press('Control+Enter');
  await expect.poll(() => share(page)).toBe(1);
  await optionsButton(page).click();
  const optional = options(page).getByRole('button', { name: 'Optional stop' });
  await optional.focus();
  await page.keyboard.press('Space');
  await expect(optional).toHaveAttribute('aria-pressed', 'false');
  await page.keyboard.press('Control+Enter');
  await held('M00', 8);
});

test('the readout shows feed, speed, time and tool, and marks unknown values', async ({ page }) => {
  await open(page);
  await load(page, 'G99 G50 S1000\nT0101\nG96 S100 M03\nG00 X62 Z2\nX40\nG01 Z-30 F0.25\nG04 X3\nG00 X80\nM30\n', 5);
  await editor(page).focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press('F9');
  // 100 m/min at Ø40 are 795.8 rpm.
  await expect(shown(page, 'Spindle')).toHaveText('796 rpm');
  await expect(shown(page, 'Cutting speed')).toHaveText('100 m/min');
  await expect(shown(page, 'Feed')).toHaveText('0.25 mm/rev · 199 mm/min');
  // 32 mm at 198.9 mm/min are 9.65 s, and the dwell 3 s. Rapids at 8 m/min: 198 mm to Z2 in 1.485 s, then 11 mm and
  // 20 mm across.
  const time = page.locator('[part~=time]');
  await expect(time).toHaveText('0:11 / 0:14');
  await expect(time).toBeInViewport();
  await expect(shown(page, 'Tool')).toHaveText('T0101 turning tool, assumed');
  await page.keyboard.press('F9');
  await expect(page.locator('.doing')).toContainText('3 s');
  await expect(time).toContainText('0:14 /');

  await test.step('the readout is shown only while there is a position', async () => {
    const readout = page.locator('[part~=readout]');
    await expect(readout).toBeInViewport();
    await page.getByRole('button', { name: 'Show the whole path' }).click();
    await expect(readout).toBeHidden();
    await expect(time).toHaveText('0:14');
    await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeFocused();
  });
});

test('a program of any length plays in about 20 s', { tag: '@night' }, async ({ page }) => {
  await open(page);
  const programs: readonly [string, number][] = [
    ['G99 M3 S500\nG0 X50 Z2\nG1 Z-1 F0.2\n', 2],
    [program('s003-g71'), motionCount('s003-g71')],
  ];
  for (const [text, motions] of programs) {
    // A run that starts after the button is pressed would pause the playback.
    await load(page, text, motions);
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    const begun = Date.now();
    await expect.poll(() => share(page)).toBeGreaterThan(0.1);
    const first = { share: await share(page), at: Date.now() };
    expect(first.at - begun).toBeLessThan(6000);
    await page.waitForTimeout(1500);
    const whole = (Date.now() - first.at) / ((await share(page)) - first.share) / 1000;
    expect(whole).toBeGreaterThan(15);
    expect(whole).toBeLessThan(30);
    await page.getByRole('button', { name: 'Pause' }).click();
  }
});

test('the editor scrolls to the running block, except while the user scrolls', async ({ page }) => {
  await open(page);
  const cuts = Array.from({ length: 200 }, (_, i) => `G01 X50 Z-${i + 1}`).join('\n');
  await load(page, `G99 M03 S500\nG00 X50 Z2 F0.2\n${cuts}\nM30\n`, 201);
  const scroller = page.locator('.cm-scroller').first();
  const top = () => scroller.evaluate((element) => element.scrollTop);
  await setSpeed(page, '50×');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await expect.poll(top).toBeGreaterThan(200);
  await expect(running(page)).toBeInViewport();
  await scroller.hover();
  // The last step of a block can undo a turn of the wheel, so the test turns it again.
  await expect
    .poll(async () => {
      await page.mouse.wheel(0, -100_000);
      return top();
    })
    .toBeLessThan(100);
  await expect(running(page)).not.toBeInViewport();
  await page.waitForTimeout(500);
  expect(await top()).toBeLessThan(100);
  await page.keyboard.press('F9');
  await expect(running(page)).toBeInViewport();
});

const PASSES = 'M03 S500\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nX45\nX40\nG00 X100\nM30\n';

test('playback starts from the block at the cursor', async ({ page }) => {
  await open(page);
  await load(page, PASSES, 14);
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let line = 0; line < 3; line++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Control+Shift+Enter');
  await expect(running(page)).toHaveText('X45');
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await page.getByRole('button', { name: 'Pause' }).click();
  await optionsButton(page).click();
  await options(page)
    .getByRole('button', { name: /^Start at the block/ })
    .click();
  await expect(options(page)).toBeHidden();
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
});

for (const [key, line, atX] of [
  ['Control+Enter', 'G01 X40 F20', '40.000'],
  ['F9', 'G98 G00 X50 Z2', '50.000'],
  ['F10', 'G01 X40 F20', '40.000'],
  ['Control+Shift+Enter', 'G01 X40 F20', '40.000'],
  ['Control+F10', 'G01 X40 F20', '50.000'],
] as const) {
  test(
    `${key} right after typing waits for the path of the typed text`,
    nightUnless(key === 'F9' || key === 'Control+Enter'),
    async ({ page }) => {
      await open(page);
      await setSpeed(page, '50×');
      // Without motions there is nothing to play yet.
      await type(page, '(EMPTY)');
      await expect(page.getByRole('button', { name: 'Next motion' })).toBeDisabled();
      await type(page, 'G98 G00 X50 Z2\nG01 X40 F20');
      await page.keyboard.press(key);
      await expect(shown(page, 'X Ø')).toHaveText(atX);
      await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
      await expect(running(page)).toHaveText(line);
    },
  );
}

test('an edit keeps the tool at its block', async ({ page }) => {
  await open(page);
  await load(page, PASSES, 14);
  await editor(page).focus();
  for (const key of ['F9', 'Control+F9', 'Control+F9']) await page.keyboard.press(key);
  await expect(running(page)).toHaveText('X45');
  await page.keyboard.press('Control+Home');
  await page.keyboard.type('G99\n');
  await expect(status(page)).toContainText('9 lines');
  await expect(running(page)).toHaveText('X45');
  await expect.poll(() => share(page)).toBeGreaterThan(0);
  // Another program is shown whole.
  await load(page, STOPS, 5);
  await expect(running(page)).toHaveCount(0);
  expect(await share(page)).toBe(0);
});

test('the legend lists the contents of the picture, and no button covers it', async ({ page }) => {
  await open(page);
  await load(
    page,
    '(STOCK D=60 LENGTH=90)\nT0101\nM03 S500\nG00 X62 Z2\nG90 X56 Z-40 F0.2\nG00 X50 Z-10\nG00 X100\nM30\n',
    7,
  );
  const legend = page.locator('.legend');
  for (const what of ['rapid', 'cutting', 'cut off the blank', 'collision']) await expect(legend).toContainText(what);
  const picture = await page.locator('[part~=drawing]').first().boundingBox();
  const button = await page.getByRole('button', { name: 'Zoom in (+)' }).boundingBox();
  expect((button?.y ?? 0) + (button?.height ?? 0)).toBeLessThan((picture?.y ?? 0) + 1);

  await test.step('nor does the readout', async () => {
    await editor(page).focus();
    await page.keyboard.press('F9');
    await expect(page.locator('[part~=readout]')).toBeVisible();
    await expect(legend).toBeHidden();
    await page.getByRole('button', { name: 'Show the whole path' }).click();
    await expect(legend).toBeVisible();
  });
});
