// Files and pasted texts: dropped anywhere, messages about them, and the machining time.
import { expect, test, type Page } from './engines';
import { choose, chooseExample, copy, drawing, editor, motionCount, open, openFile, status, value } from './page';

const notice = (page: Page) => page.getByRole('alert');

const PLACES = ['the drawing', 'the row at the top', 'the page outside of the element'] as const;

/** Drops a file on an element of the page. Returns whether the page accepted it. */
async function drop(page: Page, where: (typeof PLACES)[number], name: string, text: string): Promise<boolean> {
  return page.evaluate(
    ({ where, name, text }) => {
      const root = document.querySelector('gcode-playground')?.shadowRoot;
      const target = {
        'the drawing': root?.querySelector('canvas'),
        'the row at the top': root?.querySelector('[part~=head]'),
        'the page outside of the element': document.body,
      }[where];
      const data = new DataTransfer();
      data.items.add(new File([text], name, { type: 'text/plain' }));
      const event = (type: string): DragEvent =>
        new DragEvent(type, { bubbles: true, composed: true, cancelable: true, dataTransfer: data });
      target?.dispatchEvent(event('dragover'));
      const dropped = event('drop');
      target?.dispatchEvent(dropped);
      return dropped.defaultPrevented;
    },
    { where, name, text },
  );
}

for (const where of PLACES) {
  test(`a file dropped on ${where} opens`, async ({ page }) => {
    await open(page);
    const text = 'G00 X40 Z2\nG01 Z-10 F0.2\n';
    expect(await drop(page, where, 'dropped.nc', text)).toBe(true);
    await expect(notice(page)).toContainText('Opened dropped.nc');
    await expect(status(page)).toContainText('2 motions');
    expect(await value(page)).toBe(text);
    // The drop indicator is hidden again.
    await expect(page.locator('gcode-playground')).not.toHaveAttribute('data-drop', /./);
  });
}

test('the message about a file disappears with its program', async ({ page }) => {
  await open(page);
  const opened = (name: string) => openFile(page, name, new TextEncoder().encode('G00 X40 Z2\nG01 Z-10 F0.2\n'));
  await opened('mine.nc');
  await expect(notice(page)).toContainText('Opened mine.nc');

  await test.step('an edit keeps the message', async () => {
    await editor(page).focus();
    await page.keyboard.press('Control+End');
    await page.keyboard.type('X50');
    await expect(status(page)).toContainText('3 motions');
    await expect(notice(page)).toContainText('Opened mine.nc');
  });
  await test.step('another program removes the message', async () => {
    await chooseExample(page, 'Rough turning to a contour: G71 and G70');
    await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
    await expect(notice(page)).toBeHidden();
  });
  await test.step('undo, which restores the previous program, does not bring the message back', async () => {
    await opened('again.nc');
    await expect(notice(page)).toContainText('Opened again.nc');
    await editor(page).focus();
    await page.keyboard.press('Control+Z');
    await expect(status(page)).toContainText(`${motionCount('s003-g71')} motions`);
    await expect(notice(page)).toBeHidden();
  });
});

test('a stray character in a pasted program is reported in one line, which opens the dialog', async ({ page }) => {
  await open(page);
  const text = 'O1\nG00 X32， Z2\nG01 X30 Z-30 F0.2\nM30\n';
  await copy(page, text);
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Control+V');
  await expect(notice(page)).toContainText('characters in this text that do not belong in a program');
  const dialog = page.getByRole('dialog', { name: 'Programs in this text' });
  await expect(dialog).toBeHidden();
  expect(await value(page)).toBe(text);

  await page.getByRole('button', { name: 'Clean it…' }).click();
  await expect(dialog).toBeVisible();
  await dialog.getByRole('button', { name: 'Take this program' }).click();
  await expect.poll(() => value(page)).toBe(text.replace('，', ''));
});

test('the time is shown before playing, and a table lists the work of each tool', async ({ page }) => {
  await open(page);
  const text = 'T0101 M3 S1000\nG98\nG00 X40 Z2\nG01 Z-10 F60\nT0202\nG00 X30 Z2\nG01 Z-4 F60\nM30\n';
  await openFile(page, 'two-tools.nc', new TextEncoder().encode(text));
  // 12 mm and 6 mm at 60 mm/min. Rapids at 8 m/min: 198 mm from Z200 to Z2 in 1.485 s, and 12 mm in 0.09 s.
  await expect(page.getByRole('group', { name: 'Playback' }).getByText('0:19', { exact: true })).toBeVisible();
  await choose(page, 'more', 'Time and totals: 0:19');
  const totals = page.getByRole('dialog', { name: 'Time and totals' });
  await expect(totals.getByRole('row', { name: /^T0101/ })).toContainText('0:13');
  await expect(totals.getByRole('row', { name: /^T0202/ })).toContainText('0:06');
  await expect(totals.getByRole('row', { name: /^All/ })).toContainText('18.0');
  await expect(totals).toContainText('8,000 mm/min is assumed');
  await page.keyboard.press('Escape');
  await expect(totals).toBeHidden();
  await expect(drawing(page)).toBeVisible();
});
