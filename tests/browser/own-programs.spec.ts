// The user's own programs: every edit is stored, earlier states can be restored, two tabs do not overwrite each other,
// all programs can be saved to one file and imported, and a program that cannot be stored is reported and stays in the
// editor.
import { readFileSync } from 'node:fs';
import { expect, test, type BasicPage, type Locator, type Page } from './engines';
import { addInHiddenTab, items, kept, list, secondTab } from './own-programs';
import {
  chip,
  choose,
  chooseExample,
  editor,
  open,
  openFile,
  program,
  reload,
  title,
  titleText,
  type,
  value,
} from './page';

const SHAFT = 'O0011 (SHAFT)\nG00 X32 Z2\nG01 Z-30 F0.2\nM30\n';
const BUSH = 'O0012 (BUSH)\nG00 X42 Z2\nG01 Z-10 F0.2\nG00 X60\nM30\n';
const EXAMPLE = 's000-o0002';

const notice = (page: BasicPage) => page.locator('#own-news');

async function openList(page: BasicPage): Promise<void> {
  await choose(page, 'program', 'My programs…');
  await expect(list(page).getByRole('status')).not.toHaveText('');
}

async function close(page: BasicPage): Promise<void> {
  await list(page).getByRole('button', { name: 'Close' }).click();
}

async function act(page: BasicPage, name: string, what: string): Promise<void> {
  await list(page)
    .getByRole('button', { name: `Actions for ${name}`, exact: true })
    .click();
  await list(page).getByRole('button', { name: what, exact: true }).click();
}

/** Texts of all programs in the database, in alphabetical order. */
async function textsInList(page: BasicPage): Promise<readonly string[]> {
  const texts = await page.evaluate(async () => {
    const answer = <T>(request: IDBRequest<T>): Promise<T> =>
      new Promise((done) => (request.onsuccess = () => done(request.result)));
    const database = await answer(indexedDB.open(`gcode-playground:programs:${location.pathname}`));
    const all = await answer(
      database.transaction('texts').objectStore('texts').getAll() as IDBRequest<{ text: string }[]>,
    );
    database.close();
    return all.map(({ text }) => text);
  });
  return texts.sort();
}

async function typeAtEnd(page: BasicPage, text: string): Promise<void> {
  await editor(page).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.type(text);
}

test('a changed example, a file and a pasted text are in the list, and an unchanged example is not', async ({
  page,
}) => {
  await open(page);
  await openList(page);
  await expect(list(page).getByRole('status')).toContainText('Nothing is kept yet');
  await close(page);

  await typeAtEnd(page, '(mine)');
  await kept(page);
  await type(page, SHAFT);
  await kept(page);
  await openFile(page, 'flange.nc', new TextEncoder().encode('G00 X52 Z2\nG01 Z-5 F0.2\nM30\n'));
  await expect.poll(() => value(page)).toContain('X52');
  await kept(page);
  await openList(page);
  await expect(items(page)).toHaveCount(3);
  await expect(list(page).getByRole('status')).toHaveText('3 programs');
  await expect(items(page).nth(0)).toContainText('flange.nc');
  await expect(items(page).nth(0)).toContainText('open now');
  await expect(items(page).nth(1)).toContainText('O0011 SHAFT');

  await test.step('each program has a small picture', async () => {
    await expect.poll(() => items(page).nth(0).locator('path.cut').getAttribute('d')).toMatch(/^M[\d LMH-]+$/);
  });
  await test.step('a program is found by its name or its codes', async () => {
    await page.keyboard.type('flan');
    await expect(items(page)).toHaveCount(1);
    await list(page).getByRole('searchbox').fill('o0011 g01');
    await expect(items(page)).toHaveCount(1);
    await list(page).getByRole('searchbox').fill('nothing of this kind');
    await expect(list(page).getByRole('status')).toHaveText('No program matches.');
    await list(page).getByRole('searchbox').fill('');
  });
  await test.step('a program is opened with its context', async () => {
    await items(page).nth(2).getByRole('button').first().click();
    await expect(list(page)).toBeHidden();
    expect(await value(page)).toBe(`${program(EXAMPLE)}(mine)`);
    await expect(chip(page)).toContainText('GSK 980TD');
    await expect(titleText(page)).toHaveText('Steps and a cone from one Ø125 blank');
  });
  await test.step('another edit changes the same program', async () => {
    await typeAtEnd(page, '(again)');
    await kept(page);
    await openList(page);
    await expect(items(page)).toHaveCount(3);
    await expect(items(page).nth(0)).toContainText('open now');
  });
});

test('a program is renamed, duplicated and deleted, and the deletion can be undone', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await openList(page);
  await act(page, 'O0011 SHAFT', 'Rename');
  await page.keyboard.press('Escape');
  await expect(list(page).getByRole('textbox')).toHaveCount(0);
  await list(page).getByRole('button', { name: 'Rename', exact: true }).click();
  await page.keyboard.type('My  shaft <b>');
  await page.keyboard.press('Enter');
  await expect(items(page).nth(0)).toContainText('My shaft <b>');
  await list(page).getByRole('button', { name: 'Duplicate', exact: true }).click();
  await expect(items(page)).toHaveCount(2);
  await expect(items(page).nth(0)).toContainText('My shaft <b> (2)');
  await act(page, 'My shaft <b> (2)', 'Delete');
  await expect(items(page)).toHaveCount(1);
  await expect(list(page).getByRole('status')).toContainText('“My shaft <b> (2)” was deleted.');
  await list(page).getByRole('button', { name: 'Undo' }).click();
  await expect(items(page)).toHaveCount(2);
  await close(page);
  await test.step('an edit keeps a name that the user has given', async () => {
    await typeAtEnd(page, '(more)');
    await kept(page);
    await openList(page);
    await expect(items(page).nth(0)).toContainText('My shaft <b>');
    await act(page, 'My shaft <b>', 'Delete');
    await close(page);
  });
  await test.step('after it is deleted, the open program stays on the page, and is not restored the next time', async () => {
    expect(await value(page)).toBe(`${SHAFT}(more)`);
    await reload(page);
    await expect.poll(() => value(page)).toBe(program(EXAMPLE));
    await openList(page);
    await expect(items(page)).toHaveCount(1);
  });
});

test('an earlier state is restored, and the current text becomes a state', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await typeAtEnd(page, '(second)');
  await kept(page);
  await openList(page);
  await act(page, 'O0011 SHAFT', 'Earlier states');
  const states = page.getByRole('dialog', { name: 'Earlier states of O0011 SHAFT' });
  await expect(states.getByRole('listitem')).toHaveCount(1);
  await states
    .getByRole('button', { name: /^Restore/ })
    .first()
    .click();
  await expect.poll(() => value(page)).toBe(SHAFT);
  await openList(page);
  await expect(items(page)).toHaveCount(1);
  await act(page, 'O0011 SHAFT', 'Earlier states');
  await expect(states.getByRole('listitem')).toHaveCount(2);
  await states
    .getByRole('button', { name: /^Restore/ })
    .first()
    .click();
  await expect.poll(() => value(page)).toBe(`${SHAFT}(second)`);
});

test('all programs are saved to one file, and imported without overwriting any', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await type(page, BUSH);
  await kept(page);
  await openList(page);
  await expect(items(page)).toHaveCount(2);
  const saving = page.waitForEvent('download');
  await list(page).getByRole('button', { name: 'Export all' }).click();
  const saved = await saving;
  expect(saved.suggestedFilename()).toMatch(/^gcode-programs-\d{4}-\d\d-\d\d\.json$/);
  const file = readFileSync(await saved.path());
  const exported = JSON.parse(file.toString()) as {
    format: string;
    version: number;
    programs: { name: string; program: { text: string } }[];
  };
  expect([exported.format, exported.version]).toEqual(['gcode-playground programs', 1]);
  expect(exported.programs.map((each) => each.program.text).sort()).toEqual([SHAFT, BUSH].sort());

  const take = (text: string | Buffer) =>
    list(page)
      .locator('input[type=file]')
      .setInputFiles({ name: 'programs.json', mimeType: 'application/json', buffer: Buffer.from(text) });
  const status = list(page).getByRole('status');
  await test.step('existing programs are recognised', async () => {
    await take(file);
    await expect(status).toHaveText('Added: 0 programs. Already in the list: 2.');
    await expect(items(page)).toHaveCount(2);
  });
  await test.step('another text with the same id is added as another program', async () => {
    await take(file.toString().replace('X32', 'X33'));
    await expect(status).toHaveText('Added: 1 program. Already in the list: 1.');
    await expect(items(page)).toHaveCount(3);
  });
  await test.step('deleted programs are restored', async () => {
    await act(page, 'O0012 BUSH', 'Delete');
    await take(file);
    await expect(status).toHaveText('Added: 1 program. Already in the list: 1.');
  });
  await test.step('a file of another kind is rejected with the reason', async () => {
    for (const [text, reason] of [
      ['G00 X1\n', 'not a file of programs'],
      ['[]', 'not a file of programs'],
      [file.toString().replace('"version": 1', '"version": 2'), 'newer version'],
    ] as const) {
      await take(text);
      await expect(status).toContainText(reason);
    }
    await take(
      JSON.stringify({
        format: 'gcode-playground programs',
        version: 1,
        programs: [
          1,
          null,
          { program: { text: 5 } },
          { program: { text: 'G4', example: '', control: '' }, states: 7, created: 'x', name: [] },
        ],
      }),
    );
    await expect(status).toHaveText('Added: 1 program. Not readable: 3.');
  });
});

test('requests at the same time are executed in order: an import while a program is being deleted', {
  tag: '@night',
}, async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await openList(page);
  const saving = page.waitForEvent('download');
  await list(page).getByRole('button', { name: 'Export all' }).click();
  const file = readFileSync(await (await saving).path()).toString();
  await list(page).getByRole('button', { name: 'Actions for O0011 SHAFT', exact: true }).click();
  await page.evaluate((file) => {
    const dialog = document.querySelector('dialog[open]')!;
    [...dialog.querySelectorAll('button')].find((button) => button.textContent === 'Delete')?.click();
    const chosen = new DataTransfer();
    chosen.items.add(new File([file], 'programs.json', { type: 'application/json' }));
    const field = dialog.querySelector<HTMLInputElement>('input[type=file]')!;
    field.files = chosen.files;
    field.dispatchEvent(new Event('change', { bubbles: true }));
  }, file);
  await expect(list(page).getByRole('status')).toHaveText('Added: 1 program.');
  await expect(items(page)).toHaveCount(1);
});

test('a program that is replaced by another one is stored with its last edit', async ({ page }) => {
  await open(page);
  // Loads the gallery, so that it opens at once.
  await choose(page, 'program', 'Gallery…');
  await page.getByRole('dialog', { name: 'Gallery' }).getByRole('button', { name: 'Close', exact: true }).click();
  await type(page, SHAFT);
  await typeAtEnd(page, 'G4 X1');
  // Before the timer stores it.
  await chooseExample(page, 'Rough turning to a contour: G71 and G70');
  await expect.poll(() => value(page)).toBe(program('s003-g71'));
  await openList(page);
  await items(page).nth(0).getByRole('button').first().click();
  await expect.poll(() => value(page)).toBe(`${SHAFT}G4 X1`);
});

// A browser can freeze a page with pending writes in its back/forward cache, and restore it when the user goes back.
test('leaving a page while the list is written does not block another page, and the page continues when restored', {
  tag: '@night',
}, async ({ page }) => {
  await open(page, '#program=O1%0AG00%20X1');
  for (let round = 1; round <= 4; round++) {
    await typeAtEnd(page, `(${round})`);
    await page.goto('about:blank');
    if (round < 4) {
      await open(page, `#program=O${round + 1}%0AG00%20X1`);
      await openList(page);
      await expect(items(page)).toHaveCount(round);
      await close(page);
    } else await page.goBack();
  }
  await expect.poll(() => value(page)).toContain('(4)');
  await typeAtEnd(page, '(5)');
  await kept(page);
  await openList(page);
  await expect(items(page)).toHaveCount(4);
  await expect(items(page).first()).toContainText('O4');
});

test('a page that is left before its list is open continues when it is restored', { tag: '@night' }, async ({
  page,
  engine,
}) => {
  await open(page, '#program=O1%0AG00%20X1');
  await page.evaluate(() =>
    addEventListener('pageshow', ({ persisted }) => void (document.title = `shown again: ${persisted}`)),
  );
  await typeAtEnd(page, '(A)');
  await page.goto('about:blank');
  await page.goBack();
  await expect.poll(() => value(page)).toContain('(A)');
  // Chromium keeps no page in the back/forward cache during a test, and loads it again.
  if (engine !== 'chromium') await expect.poll(() => page.evaluate(() => document.title)).toBe('shown again: true');
  await openList(page);
  await expect(items(page)).toHaveCount(1);
});

test('changes of another tab are not overwritten when the page of the program is restored', { tag: '@night' }, async ({
  page,
  engine,
}) => {
  await open(page, '#program=O1%0AG00%20X1');
  await page.evaluate(() => void (document.documentElement.dataset['before'] = 'yes'));
  await typeAtEnd(page, '(A)');
  await page.goto('about:blank');
  // The next page takes over the pending text, and continues with it.
  await open(page);
  await expect.poll(() => value(page)).toContain('(A)');
  await typeAtEnd(page, '(B)');
  await kept(page);
  const next = await page.evaluate(() => performance.timeOrigin);
  await page.goBack();
  await page.goBack();
  // During navigation there is no page to evaluate in.
  await expect.poll(() => page.evaluate(() => performance.timeOrigin).catch(() => next)).not.toBe(next);
  await expect.poll(() => value(page)).toContain('O1');
  // A browser without the cached page loads it again.
  const isRestored = (await page.evaluate(() => document.documentElement.dataset['before'])) === 'yes';
  if (engine === 'webkit') expect(isRestored).toBe(true);
  if (isRestored) await expect(notice(page)).toContainText('in another tab');
  await typeAtEnd(page, '(C)');
  await kept(page);
  await openList(page);
  await expect
    .poll(async () => (await textsInList(page)).filter((text) => text.startsWith('O1\nG00 X1(A)(B)')))
    .toHaveLength(1);
  if (isRestored) expect(await textsInList(page)).toContain('O1\nG00 X1(A)(C)');
});

test('leaving asks for confirmation while a long program is unsaved', async ({ page }) => {
  const asks = (): Promise<boolean> =>
    page.evaluate(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })));
  await open(page);
  await page
    .locator('gcode-playground')
    .evaluate(
      (element) =>
        void ((element as unknown as { value: string }).value =
          `O1\n${`(${'LONG '.repeat(20)})\n`.repeat(21_000)}M30\n`),
    );
  await expect.poll(() => value(page)).toContain('M30');
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.insertText('%\n');
  await expect.poll(asks).toBe(true);
  await expect.poll(asks).toBe(false);
  expect((await textsInList(page)).map((text) => text.slice(0, 4))).toEqual(['%\nO1']);
});

test('a link replaces the program, which stays in the list', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await page.evaluate(() => {
    location.hash = '#program=G00%20X1%20Z1';
  });
  await expect.poll(() => value(page)).toBe('G00 X1 Z1');
  await openList(page);
  await expect(items(page)).toHaveCount(1);
  await expect(items(page).nth(0)).toContainText('O0011 SHAFT');
});

test('the program stored before the list existed is added to it once', async ({ page }) => {
  await page.goto('./docs/index.html');
  await page.evaluate(
    ({ text }) => {
      const path = location.pathname.replace(/docs\/.*/, '');
      localStorage.setItem(`gcode-playground:program:${path}`, JSON.stringify({ text, example: '', control: 'gsk' }));
    },
    { text: SHAFT },
  );
  for (let visit = 0; visit < 2; visit++) {
    await open(page);
    expect(await value(page)).toBe(SHAFT);
    await openList(page);
    await expect(items(page)).toHaveCount(1);
    await close(page);
  }
});

test('a full list reports that it stores no more, and the text stays in the editor', { tag: '@night' }, async ({
  page,
}) => {
  await open(page);
  await openList(page);
  const programs = Array.from({ length: 1001 }, (_, i) => ({
    name: `Part ${i}`,
    namedBy: 'reader',
    created: i,
    changed: i,
    program: { text: `G0 X${i}`, example: '', control: '' },
    states: [],
  }));
  const buffer = Buffer.from(JSON.stringify({ format: 'gcode-playground programs', version: 1, programs }));
  await list(page)
    .locator('input[type=file]')
    .setInputFiles({ name: 'many.json', mimeType: 'application/json', buffer });
  await expect(list(page).getByRole('status')).toHaveText('Added: 1,000 programs. No room for 1: the list is full.');
  await list(page).getByRole('searchbox').fill('Part 555');
  await act(page, 'Part 555', 'Duplicate');
  await expect(list(page).getByRole('status')).toHaveText('The list is full: delete programs that you no longer need.');
  await close(page);
  await type(page, SHAFT);
  await expect(notice(page)).toContainText('The list of your programs is full: this program is not in it.');
  await reload(page);
  await expect.poll(() => value(page)).toBe(SHAFT);
  await test.step('storing resumes when there is room', async () => {
    await openList(page);
    await list(page).getByRole('searchbox').fill('Part 777');
    await act(page, 'Part 777', 'Delete');
    await close(page);
    await typeAtEnd(page, 'G4 X1');
    await expect(notice(page)).toBeHidden();
    await openList(page);
    await list(page).getByRole('searchbox').fill('O0011');
    await expect(items(page).nth(0)).toContainText('O0011 SHAFT');
  });
});

// ---- two tabs ---------------------------------------------------------------------------------------

/** Clicks a button in a hidden tab, where nothing is painted. */
const press = (button: Locator): Promise<void> => button.evaluate((element) => element.click());

async function openListInHiddenTab(page: BasicPage): Promise<void> {
  await press(title(page));
  await press(page.getByRole('menuitem', { name: 'My programs…' }));
  await expect(list(page).getByRole('status')).not.toHaveText('');
}

test('a change of the same program in another tab is reported, and shown on request', { tag: '@night' }, async ({
  page,
}) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  const second = await secondTab(page);
  await expect.poll(() => value(second)).toBe(SHAFT);
  await addInHiddenTab(second, '(of the second tab)');
  await expect(notice(page)).toContainText('This program was changed in another tab.');
  const theirs = await value(second);
  expect(theirs).toContain('(of the second tab)');
  await press(notice(page).getByRole('button', { name: 'Show the other text' }));
  await expect.poll(() => value(page)).toBe(theirs);
  await expect(notice(page)).toBeHidden();
  await test.step('both tabs continue with one program', async () => {
    await addInHiddenTab(page, '(of the first)');
    await expect(notice(second)).toContainText('This program was changed in another tab.');
    await openListInHiddenTab(page);
    await expect(items(page)).toHaveCount(1);
  });
});

test('two tabs that change the same program keep both texts', { tag: '@night' }, async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  const second = await secondTab(page);
  await addInHiddenTab(second, '(of the second tab)');
  await expect(notice(page)).toContainText('This program was changed in another tab.');
  await addInHiddenTab(page, '(of the first)');
  await expect(notice(page)).toContainText('Both are kept: this one is now “O0011 SHAFT (2)”.');
  const mine = await value(page);
  await openListInHiddenTab(page);
  await expect(items(page)).toHaveCount(2);
  await expect(items(page).filter({ hasText: 'open now' })).toContainText('O0011 SHAFT (2)');
  expect(mine).toContain('(of the first)');
  await press(items(page).filter({ hasText: 'O0011 SHAFT' }).last().getByRole('button').first());
  await expect.poll(() => value(page)).toContain('(of the second tab)');
  await test.step('both texts are kept immediately on request', async () => {
    await addInHiddenTab(second, '(more)');
    await press(notice(page).getByRole('button', { name: 'Keep both' }));
    await expect(notice(page)).toContainText('Both are kept');
    await openListInHiddenTab(page);
    await expect(items(page)).toHaveCount(3);
  });
  await test.step('a program deleted in the other tab stays on the page', async () => {
    await press(list(page).getByRole('button', { name: 'Close' }));
    await openListInHiddenTab(second);
    await press(list(second).getByRole('button', { name: 'Actions for O0011 SHAFT (3)', exact: true }));
    await press(list(second).getByRole('button', { name: 'Delete', exact: true }));
    await expect(notice(page)).toContainText('This program was deleted in another tab.');
    expect(await value(page)).toContain('(of the second tab)');
  });
});

// ---- storage failures -------------------------------------------------------------------------------

/** The database fails as if full or forbidden while `window.refuses` is set. */
const refusing = (): void => {
  Reflect.set(window, 'refuses', sessionStorage.getItem('refuses') ?? '');
  const refuse = (): void => {
    const why = Reflect.get(window, 'refuses') as string;
    if (why !== '') throw new DOMException(why, why);
  };
  const put = IDBObjectStore.prototype.put;
  IDBObjectStore.prototype.put = function (this: IDBObjectStore, ...values: Parameters<typeof put>) {
    refuse();
    return Reflect.apply(put, this, values) as IDBRequest<IDBValidKey>;
  };
  const setItem = Storage.prototype.setItem;
  Storage.prototype.setItem = function (this: Storage, key: string, value: string) {
    if (key.startsWith('gcode-playground:journal') && Reflect.get(window, 'refuses') !== 'NotAllowedError') refuse();
    Reflect.apply(setItem, this, [key, value]);
  };
};

const setRefusal = (page: Page, why: string): Promise<void> =>
  page.evaluate((why) => {
    Reflect.set(window, 'refuses', why);
  }, why);

test('a full storage is reported, the text stays, and is stored once there is room', { tag: '@night' }, async ({
  page,
}) => {
  await page.addInitScript(refusing);
  await open(page);
  await setRefusal(page, 'QuotaExceededError');
  await type(page, SHAFT);
  await expect(notice(page)).toContainText('The browser has no room left: the last changes are not kept.');
  expect(await value(page)).toBe(SHAFT);
  const saving = page.waitForEvent('download');
  await notice(page).getByRole('button', { name: 'Save file' }).click();
  expect(readFileSync(await (await saving).path(), 'utf8')).toBe(SHAFT);
  await setRefusal(page, '');
  // Without another key press.
  await expect(notice(page)).toBeHidden();
  await openList(page);
  await expect(items(page)).toHaveCount(1);
});

test('a browser that forbids the database stores the last program, or reports that it stores none', async ({
  page,
}) => {
  await page.addInitScript(refusing);
  await open(page);
  await setRefusal(page, 'NotAllowedError');
  await type(page, SHAFT);
  await expect(notice(page)).toContainText('only the last program will be here next time');
  await setRefusal(page, 'SecurityError');
  await typeAtEnd(page, 'G4 X1');
  await expect(notice(page)).toContainText('The browser does not keep programs for this page');
  expect(await value(page)).toBe(`${SHAFT}G4 X1`);
  await expect(notice(page).getByRole('button', { name: 'Save file' })).toBeVisible();
});

test('deleting the database while the page is open is reported, and the text is stored again', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await page.evaluate(async () => {
    localStorage.clear();
    for (const name of [`gcode-playground:programs:${location.pathname}`]) {
      await new Promise<void>((done, failed) => {
        const request = indexedDB.deleteDatabase(name);
        request.onsuccess = () => done();
        request.onerror = () => failed(request.error as DOMException);
      });
    }
  });
  await expect(notice(page)).toContainText('What the browser had kept for this page was deleted.');
  await openList(page);
  await expect(items(page)).toHaveCount(1);
  await close(page);
  await reload(page);
  await expect.poll(() => value(page)).toBe(SHAFT);
});

// ---- arbitrary stored values ------------------------------------------------------------------------

test('stored values of any type are treated as untrusted input', { tag: '@night' }, async ({ page }) => {
  await page.goto('./docs/index.html');
  const values: readonly unknown[] = [
    null,
    true,
    0,
    -1,
    1e300,
    '',
    'x',
    '<img src=x onerror=alert(1)>',
    [],
    [[]],
    {},
    { id: {}, text: [] },
  ];
  const fields = [
    'language',
    'theme',
    'hints',
    'split',
    'textSize',
    'description',
    'text',
    'example',
    'control',
    'file',
    'setup',
    'blockSkip',
    'program',
    'time',
    'base',
  ];
  const id = '0123456789abcdef0123';
  for (const of of values) {
    await page.evaluate(
      ({ of, fields, id }) => {
        const path = location.pathname.replace(/(docs\/.*|index\.html)$/, '');
        const program = { text: 'G0 X1', example: '', control: '', time: 1, base: 0 };
        localStorage.clear();
        const all = Object.fromEntries(fields.map((field) => [field, of]));
        const key = `gcode-playground:journal:${path}:${id}:${id}`;
        const stored: Record<string, unknown> = {
          'gcode-playground:choices': all,
          'gcode-playground:profiles': of,
          'gcode-playground:completes': of,
          [`gcode-playground:program:${path}`]: { ...program, file: of, setup: of, blockSkip: of, program: of },
          [`gcode-playground:last:${path}`]: of,
          [key]: { ...program, ...all, text: 'G0 X1', example: '', control: '' },
          [`gcode-playground:journal:${path}:${id}`]: of,
          [`gcode-playground:journal:${path}::`]: of,
          [`gcode-playground:journal:${path}:a${id.slice(1)}:${id}`]: of,
        };
        for (const [name, value] of Object.entries(stored)) localStorage.setItem(name, JSON.stringify(value));
      },
      { of, fields, id },
    );
    await open(page);
    expect(await value(page), JSON.stringify(of)).toBe('G0 X1');
    await openList(page);
    await expect(list(page).getByRole('status')).toContainText('program');
    await close(page);
  }
});

test('a list whose rows are of any type is still shown', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await page.evaluate(async () => {
    const db = await new Promise<IDBDatabase>((done) => {
      const request = indexedDB.open(`gcode-playground:programs:${location.pathname}`);
      request.onsuccess = () => done(request.result);
    });
    const transaction = db.transaction(['programs', 'texts', 'states'], 'readwrite');
    for (const [i, of] of [null, 5, 'x', [], {}, -1e300].entries()) {
      const id = `${i}123456789abcdef0123`;
      transaction.objectStore('programs').put({
        id,
        name: of,
        namedBy: of,
        created: of,
        changed: of,
        revision: of,
        tab: of,
        length: of,
        words: of,
        picture: of,
      });
      transaction.objectStore('texts').put(of, id);
      transaction.objectStore('states').put(of, [id, 5, 5]);
    }
    transaction.objectStore('programs').put({ id: '<b>', name: 5 });
    await new Promise((done) => {
      transaction.oncomplete = done;
    });
    db.close();
  });
  await reload(page);
  await openList(page);
  await expect(items(page)).toHaveCount(7);
  await items(page).last().getByRole('button').first().click();
  await expect(items(page)).toHaveCount(7);
  const saving = page.waitForEvent('download');
  await list(page).getByRole('button', { name: 'Export all' }).click();
  const { programs } = JSON.parse(readFileSync(await (await saving).path(), 'utf8')) as { programs: unknown[] };
  expect(programs).toHaveLength(1);
});
