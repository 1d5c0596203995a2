// Work on a task: each link to a task restores the pupil's work on it, whatever was opened in between; deleted work is
// not restored, and no stored value keeps the page from starting.
import { expect, test, type BasicPage } from './engines';
import { addInHiddenTab, items, kept, list, secondTab } from './own-programs';
import { choose, drawing, editor, open, tab, value } from './page';

interface Task {
  readonly sentence: string;
  readonly begin: string;
  readonly link: string;
}

const FIRST: Omit<Task, 'link'> = {
  sentence: 'Turn the shoulder',
  begin: 'O0001\nT0101\nG97 S800 M03\nG00 X42 Z2\n\nM30\n',
};
const SECOND: Omit<Task, 'link'> = {
  sentence: 'Face the blank',
  begin: 'O0002\nT0202\nG97 S600 M03\nG00 X44 Z0\n\nM30\n',
};

/** Link to a task, in the page's format but without compression. */
function linkTo({ sentence, begin }: Omit<Task, 'link'>): string {
  const body = `b${Buffer.from(JSON.stringify({ p: begin, q: sentence, a: `${begin}(solved)` })).toString('base64url')}`;
  let crc = -1;
  for (let at = 0; at < body.length; at++) {
    crc ^= body.charCodeAt(at);
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ ((crc & 1) === 0 ? 0 : 0xedb88320);
  }
  return `#share=1.${body.length + 8}.${body}${(~crc >>> 0).toString(16).padStart(8, '0')}`;
}

const first: Task = { ...FIRST, link: linkTo(FIRST) };
const second: Task = { ...SECOND, link: linkTo(SECOND) };

/** Opens a URL as in a new tab. */
async function openNewPage(page: BasicPage, hash = ''): Promise<void> {
  await page.goto('about:blank');
  await open(page, hash);
}

/** Changes the fragment of the URL in the open page. */
async function go(page: BasicPage, hash: string): Promise<void> {
  await page.evaluate((hash) => void (location.hash = hash), hash);
}

/** Types an answer into the empty line of a task, and returns the whole text. */
async function work(page: BasicPage, { begin }: Task, answer: string): Promise<string> {
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let line = 1; line < 5; line++) await page.keyboard.press('ArrowDown');
  await page.keyboard.insertText(answer);
  const done = begin.replace('\n\n', `\n${answer}\n`);
  await expect.poll(() => value(page)).toBe(done);
  return done;
}

async function isShown(page: BasicPage, { sentence }: Task, text: string): Promise<void> {
  await expect.poll(() => value(page)).toBe(text);
  await expect(page.getByText(`Task: ${sentence}`)).toBeVisible();
  await expect(page.getByText('This program is from a link')).toBeVisible();
}

async function hasPrograms(page: BasicPage, count: number): Promise<void> {
  await choose(page, 'program', 'My programs…');
  await expect(list(page).getByRole('status')).toHaveText(count === 1 ? '1 program' : `${count} programs`);
  await expect(items(page)).toHaveCount(count);
  await list(page).getByRole('button', { name: 'Close' }).click();
}

test('each link of two tasks restores its own work, which can be continued', async ({ page }) => {
  await open(page, first.link);
  const onFirst = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  const onSecond = await work(page, second, 'G01 X-1 F0.2');
  await kept(page);
  await openNewPage(page, first.link);
  await isShown(page, first, onFirst);
  await expect(page.getByText('Your last program is kept')).toHaveCount(0);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('(MORE)');
  const more = `${onFirst}(MORE)`;
  await expect.poll(() => value(page)).toBe(more);
  await kept(page);
  await openNewPage(page, second.link);
  await isShown(page, second, onSecond);
  await openNewPage(page, first.link);
  await isShown(page, first, more);
  await hasPrograms(page, 2);
});

test('a changed example on the page without a link does not affect the work', { tag: '@night' }, async ({ page }) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page);
  await page.goto('about:blank');
  await open(page, '#s003-g71');
  await editor(page).focus();
  await page.keyboard.insertText('(MINE)');
  await kept(page);
  await openNewPage(page, first.link);
  await isShown(page, first, done);
});

test('in one tab, the link to the task restores the work after another link was opened', { tag: '@night' }, async ({
  page,
}) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  // Immediately, before the timer stores it.
  await go(page, second.link);
  await expect.poll(() => value(page)).toBe(second.begin);
  const onSecond = await work(page, second, 'G01 X-1 F0.2');
  await go(page, first.link);
  await isShown(page, first, done);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('(MORE)');
  await kept(page);
  await go(page, '#program=G00%20X1%20Z1');
  await expect.poll(() => value(page)).toBe('G00 X1 Z1');
  await go(page, first.link);
  await isShown(page, first, `${done}(MORE)`);
  await go(page, second.link);
  await isShown(page, second, onSecond);
  await hasPrograms(page, 2);
});

test('in one tab, the link to the task restores the work after the URL without a link, reloaded or not', {
  tag: '@night',
}, async ({ page }) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await go(page, '');
  await page.waitForTimeout(300);
  await go(page, first.link);
  await isShown(page, first, done);
  await openNewPage(page);
  await expect.poll(() => value(page)).toBe(done);
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('(MORE)');
  await go(page, first.link);
  await isShown(page, first, `${done}(MORE)`);
  await expect(page.getByText('Your last program is kept')).toHaveCount(0);
  await hasPrograms(page, 1);
});

test('"Open the link again" starts over, and the new text becomes the work', async ({ page }) => {
  await open(page, first.link);
  await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await page.getByRole('button', { name: 'Open the link again' }).click();
  await expect.poll(() => value(page)).toBe(first.begin);
  const anew = await work(page, first, 'G01 X32 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  await openNewPage(page, first.link);
  await isShown(page, first, anew);
  await hasPrograms(page, 2);
});

test('a line break or a full stop added by a mail program does not make another task', { tag: '@night' }, async ({
  page,
}) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  await openNewPage(page, `${first.link.slice(0, 60)}%0A${first.link.slice(60)}.`);
  await isShown(page, first, done);
});

test('deleted work is not restored, except by undo', async ({ page }) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  await choose(page, 'program', 'My programs…');
  await expect(items(page)).toHaveCount(1);
  await list(page).getByRole('button', { name: 'Actions for O0001', exact: true }).click();
  await list(page).getByRole('button', { name: 'Delete', exact: true }).click();
  await expect(items(page)).toHaveCount(0);
  await go(page, first.link);
  await expect.poll(() => value(page)).toBe(first.begin);
  await expect(page.getByText('Bring it back')).toHaveCount(0);
  await list(page).getByRole('button', { name: 'Undo' }).click();
  await expect(items(page)).toHaveCount(1);
  await list(page).getByRole('button', { name: 'Close' }).click();
  await openNewPage(page, first.link);
  await isShown(page, first, done);
  await choose(page, 'program', 'My programs…');
  await list(page).getByRole('button', { name: 'Actions for O0001', exact: true }).click();
  await list(page).getByRole('button', { name: 'Delete', exact: true }).click();
  await expect(items(page)).toHaveCount(0);
  await openNewPage(page, first.link);
  await expect.poll(() => value(page)).toBe(first.begin);
  await expect(page.getByText('Bring it back')).toHaveCount(0);
});

test('the link opens the newer work of another tab, and continues with the same program', { tag: '@night' }, async ({
  page,
}) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  const other = await secondTab(page, first.link);
  await expect.poll(() => value(other)).toBe(done);
  await other.waitForTimeout(1000);
  await go(page, second.link);
  await expect.poll(() => value(page)).toBe(second.begin);
  await addInHiddenTab(other, '(OF THE OTHER)');
  await kept(other);
  await go(page, first.link);
  await isShown(page, first, `${done}(OF THE OTHER)`);
  await addInHiddenTab(page, '(OF THIS)');
  await kept(page);
  // The tab is hidden, so the item of the closed menu is clicked by a script.
  await page
    .getByRole('menuitem', { name: 'My programs…', includeHidden: true })
    .evaluate((element) => element.click());
  await expect(items(page)).toHaveCount(1);
  expect(await value(page)).toBe(`${done}(OF THE OTHER)(OF THIS)`);
});

test('the task opens with any stored value in place of the work', { tag: '@night' }, async ({ page }) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  const key = await page.evaluate(
    () => Object.keys(localStorage).find((key) => key.startsWith('gcode-playground:task:')) ?? '',
  );
  const noted = await page.evaluate((key) => localStorage.getItem(key), key);
  const check = first.link.slice(-40);
  const hostile = [
    'null',
    '1',
    '"text"',
    '[]',
    '{',
    '',
    check,
    '[["__proto__", 1]]',
    '{"__proto__": {"a": 1}}',
    JSON.stringify({ [check]: 7 }),
    JSON.stringify({ [check]: { id: 'a' } }),
    JSON.stringify({ [check]: '../x' }),
    JSON.stringify({ [check]: '0123456789abcdef0123' }),
    JSON.stringify(Object.fromEntries(Array.from({ length: 5000 }, (_, i) => [`n${i}`, i]))),
  ];
  for (const value of hostile)
    await test.step(value.slice(0, 60), async () => {
      await page.evaluate(({ key, value }) => localStorage.setItem(key, value), { key, value });
      await openNewPage(page, first.link);
      await expect(page.getByText(`Task: ${first.sentence}`)).toBeVisible();
      expect(
        await page
          .locator('gcode-playground')
          .evaluate((element) => (element as HTMLElement & { value: string }).value),
      ).toMatch(/^O0001/);
    });
  await page.evaluate(({ key, noted }) => localStorage.setItem(key, noted ?? ''), { key, noted });
  await openNewPage(page, first.link);
  await isShown(page, first, done);
});

test('the newest of a hundred tasks are remembered', { tag: '@night' }, async ({ page }) => {
  await open(page, first.link);
  const key = await page.evaluate(() => `gcode-playground:task:${location.pathname}`);
  await page.evaluate(
    (key) =>
      localStorage.setItem(
        key,
        JSON.stringify(
          Object.fromEntries(Array.from({ length: 100 }, (_, i) => [`task-${i}`, '0123456789abcdef0123'])),
        ),
      ),
    key,
  );
  await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  const all = await page.evaluate((key) => Object.keys(JSON.parse(localStorage.getItem(key) ?? '{}') as object), key);
  expect(all).toHaveLength(100);
  expect(all).not.toContain('task-0');
  expect(all.at(-1)).toBe(first.link.slice(-40));
});

test('a database that does not respond delays the picture only briefly', { tag: '@night' }, async ({ page }) => {
  await open(page, first.link);
  const done = await work(page, first, 'G90 X32 Z-20 F0.2');
  await kept(page);
  await openNewPage(page, second.link);
  await work(page, second, 'G01 X-1 F0.2');
  await kept(page);
  await page.addInitScript(() => {
    const opens = IDBFactory.prototype.open;
    const waits = new Promise<void>((done) => Object.assign(window, { answer: done }));
    IDBFactory.prototype.open = function (this: IDBFactory, ...args: [string, number?]): IDBOpenDBRequest {
      const request = opens.apply(this, args);
      const listens = request.addEventListener.bind(request) as (
        type: string,
        listener: (event: Event) => void,
      ) => void;
      request.addEventListener = (type: string, listener: (event: Event) => void) =>
        listens(type, (event) => void waits.then(() => listener(event)));
      return request;
    };
  });
  await openNewPage(page, first.link);
  await expect.poll(() => value(page)).toBe(first.begin);
  await page.evaluate(() => (window as unknown as { answer(): void }).answer());
  await page.getByRole('button', { name: 'Bring it back' }).click();
  await isShown(page, first, done);
});

for (const viewport of [
  { width: 1366, height: 768 },
  { width: 1024, height: 600 },
]) {
  test(`the solution is shown beside the program, which keeps its size, ${viewport.width}`, async ({ page }) => {
    await page.setViewportSize(viewport);
    const begin = `O0003\n${'G01 X40 F0.2\nZ-20\n'.repeat(40)}M30\n`;
    await openNewPage(page, linkTo({ sentence: 'Turn the shoulder', begin }));
    const boxes = async (): Promise<readonly unknown[]> => [
      await editor(page).boundingBox(),
      await drawing(page).boundingBox(),
    ];
    const before = await boxes();
    await page.getByRole('button', { name: 'Show solution' }).click();
    const solution = page.getByRole('region', { name: 'Solution', exact: true });
    await expect(solution).toContainText('(solved)');
    expect(await boxes()).toEqual(before);
    await expect(tab(page, 'program')).toBeHidden();
    const [shown, picture] = [await solution.boundingBox(), await drawing(page).boundingBox()];
    // The program stays in view, and the solution is inside the window.
    expect(shown?.x).toBeGreaterThanOrEqual(picture?.x ?? Number.POSITIVE_INFINITY);
    expect((shown?.y ?? 0) + (shown?.height ?? Number.NaN)).toBeLessThan(viewport.height);
    await page.getByRole('button', { name: 'Hide solution' }).click();
    await expect(solution).toBeHidden();
  });
}
