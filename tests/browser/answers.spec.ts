// Answers to exercises: a learner hands in a link, a teacher collects thirty of them in one table.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { EMPTY_SHARED, makeLink, type Shared } from '../../www/src/files/shared-link';
import { expect, test, type BasicPage, type Locator, type Page } from './engines';
import { choose, clipboard, open, settled, type, value } from './page';

const ID = 'one-cycle';
const program = (name: string): string => readFileSync(join(__dirname, '../exercise', ID, `${name}.nc`), 'utf8');

/** The checksum of the exercise file: FNV-1a, 64 bits. */
function version(): string {
  const bytes = readFileSync(join(__dirname, '../../www/exercises', `${ID}.md`));
  const sum = bytes
    .filter((byte) => byte !== 13)
    .reduce((sum, byte) => BigInt.asUintN(64, (sum ^ BigInt(byte)) * 0x100000001b3n), 0xcbf29ce484222325n);
  return sum.toString(16).padStart(16, '0');
}

async function answer(name: string, text: string, changed: Partial<Shared> = {}): Promise<string> {
  const exercise = { id: ID, version: version(), hints: 1 };
  const made = await makeLink({ ...EMPTY_SHARED, text, name, exercise, ...changed });
  return made.kind === 'link' ? `https://example.org/playground/${made.link}` : '';
}

const PROGRAM = `(STOCK D=30 LENGTH=60 FACE=0 GRIP=20)
(TOOL T0101 TYPE=TURNING INSERT=C KR=95)
O0001
T0101
G97 S800 M03
G00 X32 Z2
G90 X26 Z-30 F0.1
G00 X100 Z100
M30
`;

/** The open table, and its rows without the heading. */
async function openAnswers(page: BasicPage): Promise<Locator> {
  await choose(page, 'share', 'Answers of a class…');
  return page.getByRole('dialog', { name: 'Answers of a class' });
}

const rows = (dialog: Locator): Locator => dialog.locator('tbody tr');

async function check(dialog: Locator, links: string): Promise<void> {
  await dialog.getByLabel('Links that the learners have sent').fill(links);
  await dialog.getByRole('button', { name: 'Check the links' }).click();
}

/** The text of the file that a link of the dialog saves. */
async function savedBy(page: Page, dialog: Locator, name: string): Promise<string> {
  const saving = page.waitForEvent('download');
  await dialog.getByRole('link', { name }).click();
  return readFileSync(await (await saving).path(), 'utf8');
}

test('a learner hands in a checked answer, and a teacher grades and opens it', async ({ page }) => {
  await open(page, `#exercise=${ID}`);
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  await expect(page.getByRole('button', { name: 'Copy link to hand in' })).toHaveCount(0);
  await page.getByRole('button', { name: 'Hint 1 of 3' }).click();
  await type(page, program('reference'));
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  await page.getByRole('textbox', { name: 'Your name' }).fill('Anna');
  await page.getByRole('button', { name: 'Copy link to hand in' }).click();
  await expect(page.locator('#link-bar').getByText('Copied', { exact: true })).toBeVisible();
  const link = await clipboard(page);
  expect(link).toMatch(/#share=3\.\S+$/);

  await page.goto('about:blank');
  await open(page);
  const dialog = await openAnswers(page);
  await check(dialog, link);
  await expect(dialog.getByRole('status')).toHaveText('1 of 1 passed.');
  await expect(rows(dialog)).toHaveCount(1);
  await expect(rows(dialog).first()).toContainText('Anna');
  await expect(rows(dialog).first()).toContainText('Same part');
  // One hint, and the same version of the exercise.
  await expect(rows(dialog).first().locator('td').nth(8)).toHaveText('1');
  await expect(rows(dialog).first().locator('td').nth(9)).toHaveText('');
  // The same link is the same answer.
  await check(dialog, link);
  await expect(dialog.getByRole('status')).toHaveText('These answers are in the table already.');
  await expect(rows(dialog)).toHaveCount(1);

  const opened = await dialog.getByRole('link', { name: 'Anna' }).getAttribute('href');
  await page.goto('about:blank');
  await open(page, opened ?? '');
  await settled(page);
  await expect(page.getByText('From: Anna')).toBeVisible();
  expect((await value(page)).trim()).toBe(program('reference').trim());
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  // The report appears immediately, and does not count as a check by the reader.
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  expect(await page.evaluate(() => localStorage.getItem('gcode-playground:exercises'))).toContain('"tries":1');
});

test('thirty answers are one table, sorted, filtered and saved', async ({ page }) => {
  const wrong = ['wrong-1', 'wrong-2', 'wrong-3', 'wrong-4'].map(program);
  const links: string[] = [];
  for (let at = 0; at < 30; at++) {
    const text = at < 20 ? `${program('reference')}(${at})\n` : `${wrong[at % wrong.length] ?? ''}`;
    const link = await answer(`Learner ${at + 1}`, text);
    // Eight of them through a messenger on a phone, which breaks lines and adds text.
    links.push(at % 4 === 3 ? `${link.replace(/(.{60})/g, '$1\n')} sent from my phone` : link);
  }
  await open(page);
  const dialog = await openAnswers(page);
  await check(dialog, links.join('\n'));
  await expect(dialog.getByRole('status')).toHaveText('20 of 30 passed.', { timeout: 60_000 });
  await expect(rows(dialog)).toHaveCount(30);
  // The comment differs, the blocks do not.
  await expect(rows(dialog).nth(1)).toContainText('same text as Learner 1, …');
  await expect(rows(dialog).nth(0)).toContainText('same text as Learner 2, …');

  await dialog.getByRole('button', { name: 'Points' }).click();
  await expect(dialog.getByRole('columnheader', { name: 'Points' })).toHaveAttribute('aria-sort', 'ascending');
  await expect(rows(dialog).first().locator('td').nth(1)).toHaveText('not passed');
  await expect(rows(dialog).first().locator('td').nth(2)).toHaveText('0');
  // Sorting by key keeps the focus.
  await dialog.getByRole('button', { name: 'Points' }).focus();
  await page.keyboard.press('Enter');
  await expect(rows(dialog).first().locator('td').nth(2)).toHaveText('10');
  await expect(dialog.getByRole('button', { name: 'Points' })).toBeFocused();
  await dialog.getByRole('button', { name: 'Name' }).click();
  await expect(rows(dialog).nth(9)).toContainText('Learner 10');

  await dialog.getByLabel('Filter').fill('learner 2');
  // 2, and 20 to 29.
  await expect(rows(dialog)).toHaveCount(11);
  const csv = await savedBy(page, dialog, 'CSV');
  expect(csv.split('\r\n')).toHaveLength(13);
  expect(csv).toMatch(/^\ufeffName,Exercise,Result,Points,Part,Failed checks,/);
  const printed = await savedBy(page, dialog, 'Page to print');
  expect(printed).toContain('<h1>Answers of a class</h1>');
  expect(printed.match(/<tr>/g)).toHaveLength(12);
});

test('answers that cannot be graded say why', async ({ page }) => {
  const links = [
    await answer('Older', program('reference'), { exercise: { id: ID, version: '0123456789abcdef', hints: 0 } }),
    await answer('Unknown', program('reference'), {
      exercise: { id: 'no-such-exercise', version: version(), hints: 0 },
    }),
    await answer('Plain', program('reference'), { exercise: null }),
    (await answer('Cut', program('reference'))).slice(0, -20),
    await answer('=1+1', program('wrong-1')),
  ];
  await open(page);
  const dialog = await openAnswers(page);
  await check(dialog, 'Good morning!');
  await expect(dialog.getByRole('status')).toHaveText('There is no link in this text.');
  await check(dialog, links.join('\n'));
  await expect(dialog.getByRole('status')).toHaveText('1 of 5 passed.');
  for (const [at, text] of [
    'another version of the exercise',
    'The exercise no-such-exercise could not be loaded: open its file above.',
    'The answer names no exercise: choose one above.',
    'The link is damaged or not complete.',
    '',
  ].entries())
    await expect(rows(dialog).nth(at).locator('td').last()).toHaveText(text);
  // A spreadsheet must not read a name as a formula.
  const csv = await savedBy(page, dialog, 'CSV');
  expect(csv).toContain("\r\n'=1+1,");

  // A program without an exercise belongs to the chosen one, also to one that is chosen later.
  await dialog.getByRole('combobox').selectOption(ID);
  await expect(dialog.getByRole('status')).toHaveText('2 of 5 passed.');
  await expect(rows(dialog).nth(2)).toContainText('Plain');
  await expect(rows(dialog).nth(2).locator('td').nth(1)).toHaveText('passed');

  await dialog.getByRole('button', { name: 'Clear' }).click();
  await expect(rows(dialog)).toHaveCount(0);
  await dialog.getByRole('button', { name: 'Undo' }).click();
  await expect(rows(dialog)).toHaveCount(5);
});

test('a teacher makes an exercise of a program, and a learner opens it from the link', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await choose(page, 'share', 'Exercise that checks the part…');
  const dialog = page.getByRole('dialog', { name: 'Exercise that checks the part' });
  // The part: Ø26 over 30 mm on a bar of Ø30.
  const target = dialog.getByLabel(/^Blank, tools and wanted part/);
  await expect.poll(() => target.inputValue()).toContain('X26');
  expect(await target.inputValue()).toContain('Z-30');
  expect(await target.inputValue()).not.toContain('G90');
  await dialog.getByLabel('Title').fill('A step');
  await dialog.getByLabel('Task').fill('Turn the step.\n\n* Ø26\n* 30 mm long');
  await dialog.getByLabel(/^Hints/).fill('Use one cycle.');
  await dialog.getByLabel('Required codes').fill('G71');
  await expect(dialog.getByRole('status')).toContainText('Your program does not pass');
  await dialog.getByLabel('Required codes').fill('g90');
  await expect(dialog.getByRole('status')).toHaveText('Your program passes.');
  await expect(dialog.getByRole('button', { name: 'Copy the link' })).toBeEnabled();
  await dialog.getByRole('button', { name: 'Copy the link' }).click();
  await expect(dialog.getByRole('status')).toHaveText('Copied');
  const link = (await dialog.getByRole('link', { name: 'Try as a learner' }).getAttribute('href')) ?? '';
  expect(link).toMatch(/#share=3\.\S+$/);
  // A fault of the entered text is named.
  await target.fill('```setup\n(STOCK D=30)\n```\n\n```target\nX26\n```');
  await expect(dialog.getByRole('status')).toContainText('The exercise has a fault (“');
  await expect(dialog.getByRole('button', { name: 'Copy the link' })).toBeDisabled();

  await page.goto('about:blank');
  await open(page, link.slice(link.indexOf('#')));
  await expect(page.getByRole('heading', { name: 'A step' })).toBeVisible();
  await expect(page.locator('.exercise-task li')).toHaveText(['Ø26', '30 mm long']);
  await type(page, PROGRAM.replace('X26', 'X27'));
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await expect(page.locator('.exercise-report')).toContainText('Ø27');
  // An answer that does not pass can be handed in, too.
  await expect(page.getByRole('button', { name: 'Copy link to hand in' })).toHaveCount(0);
  await page.getByRole('button', { name: 'Hand in…' }).click();
  await expect(page.getByRole('button', { name: 'Copy link to hand in' })).toBeVisible();
  await type(page, PROGRAM);
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  await page.getByRole('textbox', { name: 'Your name' }).fill('李雷');
  await page.getByRole('button', { name: 'Copy link to hand in' }).click();
  await expect(page.locator('#link-bar').getByText('Copied', { exact: true })).toBeVisible();
  const answered = await clipboard(page);

  // The site has no file of this exercise: the link of the answer contains it.
  await page.goto('about:blank');
  await open(page);
  const answers = await openAnswers(page);
  await check(answers, answered);
  await expect(answers.getByRole('status')).toHaveText('1 of 1 passed.');
  await expect(rows(answers).first()).toContainText('李雷');
  await expect(rows(answers).first().locator('td').nth(0)).toHaveText('A step');
  await expect(rows(answers).first().locator('td').nth(9)).toContainText('exercise as in the link');
  for (const address of [answered, (await answers.getByRole('link', { name: '李雷' }).getAttribute('href')) ?? '']) {
    await page.goto('about:blank');
    await open(page, address.slice(address.indexOf('#')));
    await expect(page.getByRole('heading', { name: 'A step' })).toBeVisible();
    await expect(page.getByText('From: 李雷')).toBeVisible();
    await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  }
});

test('an exercise with a Chinese title and Chinese commas has its own id', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  await choose(page, 'share', 'Exercise that checks the part…');
  const dialog = page.getByRole('dialog', { name: 'Exercise that checks the part' });
  const save = dialog.getByRole('link', { name: 'Save as a file' });
  await dialog.getByLabel('Task').fill('车台阶。');
  const ids: string[] = [];
  for (const title of ['台阶', '圆锥']) {
    await dialog.getByLabel('Title').fill(title);
    await dialog.getByLabel('Required codes').fill('G90，G97、M03');
    await expect(save).toBeVisible();
    await expect(dialog.getByRole('status')).toHaveText('Your program passes.');
    ids.push((await save.getAttribute('download')) ?? '');
  }
  expect(ids[0]).toMatch(/^exercise-[a-z0-9]+\.md$/);
  expect(ids[1]).not.toBe(ids[0]);
});
