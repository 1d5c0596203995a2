// Pasting or opening a text that contains more than a program: the page offers to extract programs, and typed text is
// never lost.
import { chromiumTest, expect, test, type BasicPage } from './engines';
import { choose, chooseFile, copy, editor, open, status, value } from './page';
import { runBeforeWorker } from './worker-script';

const dialog = (page: BasicPage) => page.getByRole('dialog', { name: 'Programs in this text' });
const cleaned = (page: BasicPage) => dialog(page).getByRole('region', { name: 'The program, cleaned' });

const SLIDE = [
  'Example 4: taper facing. Write the program.',
  '•O8234 •N10 G50 X100.0 Z100.0; •N30 G00 X85.0 Z5.0; •N40 G94 X20.0 Z–3 F200; •N90 M30;',
  'Example 5',
  'O1; G00 X80.0 Z30.0; G98 G01 Z?20.0 F100; M30;',
  'See figure 4.',
].join('\n');

/** Pastes a text over the text of the editor. */
async function paste(page: BasicPage, text: string): Promise<void> {
  await copy(page, text);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Control+V');
  // Engines read the clipboard asynchronously.
  await expect.poll(() => value(page)).toBe(text);
}

test('a program is chosen, its question answered, and undo restores the text', async ({ page }) => {
  await open(page);
  await paste(page, SLIDE);
  await expect(dialog(page)).toBeVisible();
  expect(await value(page)).toBe(SLIDE);
  await expect(dialog(page).getByRole('radio', { name: /^O8234/ })).toBeChecked();
  await expect(cleaned(page).locator('del', { hasText: 'Z–3' })).toHaveAttribute('title', /minus/);
  await expect(cleaned(page).locator('ins', { hasText: 'Z-3' })).toBeVisible();

  await page.keyboard.press('ArrowDown');
  await expect(dialog(page).getByRole('radio', { name: /^O0001/ })).toBeChecked();
  await expect(cleaned(page).getByRole('radio', { name: 'Z?20.0 as printed' })).toBeChecked();
  await cleaned(page).getByRole('radio', { name: 'Z-20.0' }).check();
  await dialog(page).getByRole('button', { name: 'Take this program' }).click();
  await expect(dialog(page)).toBeHidden();
  expect(await value(page)).toBe('O1;\nG00 X80.0 Z30.0;\nG98 G01 Z-20.0 F100;\nM30;\n');
  await expect(status(page)).toContainText('2 motions');

  await editor(page).focus();
  await page.keyboard.press('Control+Z');
  expect(await value(page)).toBe(SLIDE);
});

test('the text is unchanged when it is pasted as it is', async ({ page }) => {
  await open(page);
  await paste(page, SLIDE);
  await dialog(page).getByRole('button', { name: 'Paste as it is' }).click();
  await expect(dialog(page)).toBeHidden();
  expect(await value(page)).toBe(SLIDE);

  await choose(page, 'program', 'Programs in a text…');
  await expect(dialog(page)).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  expect(await value(page)).toBe(SLIDE);
});

test('only the pasted text is replaced', async ({ page }) => {
  await open(page);
  await paste(page, 'O9\nM30\n');
  await expect(editor(page)).toContainText('O9');
  await page.keyboard.press('Control+End');
  await copy(page, SLIDE);
  await editor(page).focus();
  await page.keyboard.press('Control+V');
  await dialog(page).getByRole('button', { name: 'Take this program' }).click();
  await expect
    .poll(() => value(page))
    .toBe('O9\nM30\nO8234\nN10 G50 X100.0 Z100.0;\nN30 G00 X85.0 Z5.0;\nN40 G94 X20.0 Z-3 F200;\nN90 M30;\n');
});

chromiumTest('a program can be taken only after it has arrived', async ({ page }) => {
  // The worker answers the requests for programs when the test says so.
  await runBeforeWorker(
    page,
    `
    const requests = new Set();
    const held = [];
    self.addEventListener('message', ({ data }) => {
      if (data?.content?.kind === 'question' && data.content.about === 'pieces-of') requests.add(data.content.id);
    });
    const post = self.postMessage.bind(self);
    self.postMessage = (message, ...rest) => {
      if (message?.event?.kind === 'answer' && requests.has(message.event.id)) held.push(() => post(message, ...rest));
      else post(message, ...rest);
    };
    self.release = (index) => held[index]();
    self.heldCount = () => held.length;
  `,
  );
  const inWorker = (script: string): Promise<unknown> => page.workers()[0]!.evaluate(script);
  await open(page);
  await paste(page, SLIDE);
  const take = dialog(page).getByRole('button', { name: 'Take this program' });
  await expect(take).toBeDisabled();
  await expect.poll(() => inWorker('heldCount()')).toBe(1);
  await page.keyboard.press('ArrowDown');
  await expect.poll(() => inWorker('heldCount()')).toBe(2);
  // The pieces of the program that is no longer chosen.
  await inWorker('release(0)');
  await page.waitForTimeout(200);
  await expect(take).toBeDisabled();
  await inWorker('release(1)');
  await expect(cleaned(page)).toContainText('G98 G01');
  await take.click();
  await expect.poll(() => value(page)).toBe('O1;\nG00 X80.0 Z30.0;\nG98 G01 Z?20.0 F100;\nM30;\n');
});

test('a plain program is pasted without a message, and a text without programs is reported as such', async ({
  page,
}) => {
  await open(page);
  const plain = 'O1\nG00 X80.0 Z30.0\nG01 Z-20.0 F100 (cut)\nM30\n';
  await paste(page, plain);
  await expect(status(page)).toContainText('2 motions');
  await expect(dialog(page)).toBeHidden();
  await choose(page, 'program', 'Programs in a text…');
  await expect(cleaned(page)).toContainText('G01 Z-20.0 F100 (cut)');
  await expect(dialog(page).getByRole('radio', { name: /as it was/ })).toBeChecked();
  await dialog(page).getByRole('button', { name: 'Close' }).click();
  await paste(page, 'Nothing but a sentence about turning.');
  await choose(page, 'program', 'Programs in a text…');
  await expect(page.getByText('No program was found in this text.')).toBeVisible();
});

test('all lost signs are answered in one step, in a file that is opened', async ({ page }) => {
  await open(page);
  const text = 'Setup sheet\nO6003\nG00 X70 Z3 to the start\nG90 X62 Z43 F0.3\nX60.4\nG90 X58.4 Z20 R2.3\nM30\n';
  await chooseFile(page, 'card.txt', new TextEncoder().encode(text));
  await expect(dialog(page)).toBeVisible();
  await dialog(page).getByRole('button', { name: 'All of these negative' }).click();
  await dialog(page).getByRole('button', { name: 'Take this program' }).click();
  expect(await value(page)).toBe(
    'O6003\nG00 X70 Z3 (to the start)\nG90 X62 Z-43 F0.3\nX60.4\nG90 X58.4 Z-20 R-2.3\nM30\n',
  );
});
