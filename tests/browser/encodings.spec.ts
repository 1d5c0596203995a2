// Files from machines and old editors: they are decoded correctly, and saving gives the same bytes.
import { expect, test, type Page, nightUnless } from './engines';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { choose, chooseFile, chooseLanguage, editor, open, reload, status, value } from './page';

/** The same cases are tested with the command line. */
const cases = (
  JSON.parse(readFileSync(join(__dirname, '..', 'encodings.json'), 'utf8')) as {
    encoding: string;
    text: string;
    bytes: string;
  }[]
).map(({ encoding, text, bytes }) => ({ encoding, text, bytes: Buffer.from(bytes, 'hex') }));

const encoding = (page: Page) => page.getByRole('combobox', { name: 'Encoding' });

/** Opens the page and then a file. */
async function openAlone(page: Page, name: string, bytes: Buffer): Promise<void> {
  await open(page);
  await chooseFile(page, name, bytes);
  await expect(page.getByText(`Opened ${name}`)).toBeVisible();
}

async function save(page: Page): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.waitForEvent('download');
  await choose(page, 'program', 'Save file');
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Text of the element with all line ends normalized to `\n`. */
const folded = (text: string): string => text.replace(/\r\n?/g, '\n');

/** Places the cursor after `text`, the start of a line (from 1). */
async function cursorAfter(page: Page, line: number, text: string): Promise<void> {
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let i = 1; i < line; i++) await page.keyboard.press('ArrowDown');
  for (let i = 0; i < text.length; i++) await page.keyboard.press('ArrowRight');
}

// A test for each: opening a page takes its time, and there are many.
for (const [i, one] of cases.entries()) {
  test(`a program in ${one.encoding} is decoded correctly and saved unchanged, ${i + 1}`, { tag: '@night' }, async ({
    page,
  }) => {
    const name = `part-${i}.nc`;
    await openAlone(page, name, one.bytes);
    expect(await value(page)).toBe(folded(one.text));
    await expect(encoding(page)).toHaveValue(one.encoding);
    const saved = await save(page);
    expect(saved.name).toBe(name);
    expect(saved.bytes.toString('hex')).toBe(one.bytes.toString('hex'));
  });
}

const ALL_BYTES = Buffer.from(Array.from({ length: 256 }, (_, byte) => byte));
const ODD_FILES: [string, Buffer][] = [
  ['mixed.nc', Buffer.from('O1\r\nG0 X1\nG1 Z-1\r\rM8\n\rM30\r\n\u001a', 'latin1')],
  ['only-cr.nc', Buffer.from('O1\rG0 X1\rM30\r', 'latin1')],
  ['tape.nc', Buffer.from('\0\0\0%\r\nO1\0\r\nM30\r\n%\0\0\u001a\u001a', 'latin1')],
  ['cut-short.nc', Buffer.concat([Buffer.from('G0 X1 ('), Buffer.from([0xb4, 0xd6, 0xb3])])],
  ['all-bytes.nc', ALL_BYTES],
  [
    'euro-of-old.nc',
    Buffer.concat([Buffer.from('(price '), Buffer.from([0x80, 0x20, 0xb4, 0xd6]), Buffer.from(')\n')]),
  ],
  ['bom-alone.nc', Buffer.from([0xef, 0xbb, 0xbf])],
  ['bom-and-no-utf8.nc', Buffer.concat([Buffer.from([0xef, 0xbb, 0xbf]), ALL_BYTES])],
  ['half-a-pair.nc', Buffer.from([0xff, 0xfe, 0x47, 0x00, 0x00, 0xd8, 0x0a, 0x00])],
  ['odd-utf16.nc', Buffer.from([0xff, 0xfe, 0x47, 0x00, 0x30])],
  ['empty.nc', Buffer.alloc(0)],
];

for (const [name, bytes] of ODD_FILES) {
  test(
    `arbitrary bytes are saved unchanged: ${name}`,
    nightUnless(name === 'all-bytes.nc' || name === 'mixed.nc'),
    async ({ page }) => {
      await openAlone(page, name, bytes);
      expect((await save(page)).bytes.toString('hex')).toBe(bytes.toString('hex'));
    },
  );
}

test('editing one word changes nothing else in the file', async ({ page }) => {
  await open(page);
  const head = Buffer.from('O1 (', 'latin1');
  const chinese = Buffer.from([0xb4, 0xd6, 0xb3, 0xb5]);
  const tail = (x: string) => Buffer.from(`)\r\nG0 X${x} Z2\nG1 Z-9 F1\rM30\r\n\u001a`, 'latin1');
  await chooseFile(page, 'edit.nc', Buffer.concat([head, chinese, tail('5')]));
  await expect(encoding(page)).toHaveValue('gb18030');
  await cursorAfter(page, 2, 'G0 X5');
  await page.keyboard.type('0');
  expect((await save(page)).bytes).toEqual(Buffer.concat([head, chinese, tail('50')]));

  await test.step('undo restores a different line end', async () => {
    await cursorAfter(page, 2, 'G0 X50');
    await page.keyboard.press('Backspace');
    await cursorAfter(page, 3, 'G1 Z-9 F1');
    await page.keyboard.press('Delete');
    await expect.poll(() => value(page)).toContain('F1M30');
    expect((await save(page)).bytes.includes('F1M30\r\n')).toBe(true);
    await editor(page).focus();
    await page.keyboard.press('Control+Z');
    await expect.poll(() => value(page)).toContain('F1\nM30');
    expect((await save(page)).bytes).toEqual(Buffer.concat([head, chinese, tail('5')]));
  });

  await test.step('a new line gets the most frequent line end', async () => {
    await cursorAfter(page, 4, '');
    await page.keyboard.type('M9\n');
    const changed = Buffer.from(tail('5').toString('latin1').replace('M30', 'M9\r\nM30'), 'latin1');
    expect((await save(page)).bytes).toEqual(Buffer.concat([head, chinese, changed]));
  });
});

test('a character outside of the encoding is reported, and the file is saved as UTF-8', async ({ page }) => {
  await open(page);
  // (Резец)
  const bytes = Buffer.concat([
    Buffer.from('('),
    Buffer.from([0xd0, 0xe5, 0xe7, 0xe5, 0xf6]),
    Buffer.from(')\r\nM30\r\n'),
  ]);
  await chooseFile(page, 'резец.nc', bytes);
  await expect(encoding(page)).toHaveValue('windows-1251');
  await cursorAfter(page, 1, '(Резец');
  await page.keyboard.insertText('😀');
  const saved = await save(page);
  expect(saved.bytes.toString('utf8')).toBe('(Резец😀)\r\nM30\r\n');
  await expect(page.getByText('Windows-1251 has no character “😀”: резец.nc was saved as UTF-8.')).toBeVisible();
  await expect(encoding(page)).toHaveValue('utf-8');

  await encoding(page).selectOption('windows-1251');
  await expect(page.getByText('the file stays UTF-8')).toBeVisible();
  await expect(encoding(page)).toHaveValue('utf-8');
  await chooseLanguage(page, 'zh');
  await page.getByRole('combobox', { name: '编码' }).selectOption('windows-1251');
  await expect(page.getByText('Windows-1251 中没有“😀”')).toBeVisible();
});

test('a wrongly detected encoding can be corrected, also after an edit', async ({ page }) => {
  await open(page);
  // 粗车 between Russian words: GB18030 is not the intended encoding.
  const bytes = Buffer.concat([Buffer.from('O1\n('), Buffer.from([0xb4, 0xd6, 0xb3, 0xb5]), Buffer.from(')\nG0 X1\n')]);
  await chooseFile(page, 'guess.nc', bytes);
  await expect.poll(() => value(page)).toBe('O1\n(粗车)\nG0 X1\n');
  await cursorAfter(page, 3, 'G0 X1');
  await page.keyboard.type('0');
  await encoding(page).selectOption('windows-1251');
  await expect(page.getByText('Read again as Windows-1251')).toBeVisible();
  expect(await value(page)).toBe('O1\n(ґЦіµ)\nG0 X10\n');
  const edited = Buffer.from(bytes.toString('latin1').replace('X1', 'X10'), 'latin1');
  expect((await save(page)).bytes).toEqual(edited);

  await encoding(page).selectOption('gb18030');
  expect(await value(page)).toBe('O1\n(粗车)\nG0 X10\n');
  await encoding(page).selectOption('utf-8');
  await expect(page.getByText('will be saved as UTF-8')).toBeVisible();
  expect((await save(page)).bytes.toString('utf8')).toBe('O1\n(粗车)\nG0 X10\n');

  await chooseFile(page, 'ru.nc', Buffer.from([0x28, 0xd0, 0xe5, 0xe7, 0xe5, 0xf6, 0x29]));
  await expect(encoding(page)).toHaveValue('windows-1251');
  await encoding(page).selectOption('gb18030');
  await expect(page.getByText('ru.nc is not GB18030 text; it stays Windows-1251.')).toBeVisible();
  await expect(encoding(page)).toHaveValue('windows-1251');
});

test('after a reload, and after undoing another file, a program is still saved in its own encoding', async ({
  page,
}) => {
  await open(page);
  const first = Buffer.concat([Buffer.from('(Gr'), Buffer.from([0xf6, 0xdf]), Buffer.from('e)\r\nG0 X1 Z1\nM30\r\n')]);
  await chooseFile(page, 'first.nc', first);
  await expect(encoding(page)).toHaveValue('windows-1252');
  await chooseFile(page, 'second.nc', Buffer.from('G0 X2 Z2\nG1 Z1 F1\n'));
  await expect(encoding(page)).toHaveValue('utf-8');
  await editor(page).focus();
  await page.keyboard.press('Control+Z');
  await expect(encoding(page)).toHaveValue('windows-1252');
  expect(await save(page)).toEqual({ name: 'first.nc', bytes: first });

  await reload(page);
  await expect(status(page)).toContainText(/^1 motion/);
  await expect(encoding(page)).toHaveValue('windows-1252');
  expect(await save(page)).toEqual({ name: 'first.nc', bytes: first });

  await page.getByRole('button', { name: 'Open the first example' }).click();
  await expect(encoding(page)).toHaveCount(0);
  await editor(page).focus();
  const waiting = page.waitForEvent('download');
  await page.keyboard.press('Control+S');
  expect((await waiting).suggestedFilename()).toBe('O0001.nc');
});

test('an element outside of a document refuses to open a file', async ({ page }) => {
  await open(page);
  const error = await page.evaluate(async () => {
    const element = document.createElement('gcode-playground') as HTMLElement & { openFile(file: File): Promise<void> };
    return element.openFile(new File(['G0 X1\r\n'], 'early.nc')).then(() => '', String);
  });
  expect(error).toBe('Error: the playground is not in a document');
});
