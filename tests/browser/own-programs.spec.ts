// The reader's own programs: every edit is in the list, earlier states come back, two tabs overwrite nothing, all
// programs go into one file and come out of it, and what cannot be kept is said while the text stays.
import { readFileSync } from 'node:fs';
import { expect, test, type BasicPage, type Locator, type Page } from './engines';
import { addUnseen, items, kept, list, secondTab } from './own-programs';
import { editor, open, openFile, program, type, value } from './page';

const SHAFT = 'O0011 (SHAFT)\nG00 X32 Z2\nG01 Z-30 F0.2\nM30\n';
const BUSH = 'O0012 (BUSH)\nG00 X42 Z2\nG01 Z-10 F0.2\nG00 X60\nM30\n';
const EXAMPLE = 's000-o0002';

const button = (page: BasicPage) => page.getByRole('button', { name: 'My programs…' }).first();
const said = (page: BasicPage) => page.locator('#own-news');

async function openList(page: BasicPage): Promise<void> {
  await button(page).click();
  await expect(list(page).getByRole('status')).not.toHaveText('');
}

async function close(page: BasicPage): Promise<void> {
  await list(page).getByRole('button', { name: 'Close' }).click();
}

async function act(page: BasicPage, name: string, what: string): Promise<void> {
  await list(page)
    .getByRole('button', { name: `What can be done with ${name}`, exact: true })
    .click();
  await list(page).getByRole('button', { name: what, exact: true }).click();
}

/** The texts of all programs that the database has, in order of the alphabet. */
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

test('an example that was changed, a file and a pasted text are in the list, and an example alone is not', async ({
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

  await test.step('each has a small picture', async () => {
    await expect.poll(() => items(page).nth(0).locator('path.cut').getAttribute('d')).toMatch(/^M[\d LMH-]+$/);
  });
  await test.step('one is found by its name, or by its codes', async () => {
    await page.keyboard.type('flan');
    await expect(items(page)).toHaveCount(1);
    await list(page).getByRole('searchbox').fill('o0011 g01');
    await expect(items(page)).toHaveCount(1);
    await list(page).getByRole('searchbox').fill('nothing of this kind');
    await expect(list(page).getByRole('status')).toHaveText('No program matches.');
    await list(page).getByRole('searchbox').fill('');
  });
  await test.step('and is opened with what goes with it', async () => {
    await items(page).nth(2).getByRole('button').first().click();
    await expect(list(page)).toBeHidden();
    expect(await value(page)).toBe(`${program(EXAMPLE)}(mine)`);
    await expect(page.getByRole('combobox', { name: 'Control' })).toHaveValue('gsk');
    await expect(page.getByRole('combobox', { name: 'Example' })).toHaveValue(EXAMPLE);
  });
  await test.step('another edit is of the same program', async () => {
    await typeAtEnd(page, '(again)');
    await kept(page);
    await openList(page);
    await expect(items(page)).toHaveCount(3);
    await expect(items(page).nth(0)).toContainText('open now');
  });
});

test('a program is renamed, duplicated, and deleted with a way back', async ({ page }) => {
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
  await test.step('a name that was given stays with an edit', async () => {
    await typeAtEnd(page, '(more)');
    await kept(page);
    await openList(page);
    await expect(items(page).nth(0)).toContainText('My shaft <b>');
    await act(page, 'My shaft <b>', 'Delete');
    await close(page);
  });
  await test.step('the one that is open stays on the page, and is not there the next time', async () => {
    expect(await value(page)).toBe(`${SHAFT}(more)`);
    await page.reload();
    await expect.poll(() => value(page)).toBe(program(EXAMPLE));
    await openList(page);
    await expect(items(page)).toHaveCount(1);
  });
});

test('an earlier state comes back, and what was there is kept as one', async ({ page }) => {
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

test('all programs go into one file, and come back without overwriting any', async ({ page }) => {
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
  const said = JSON.parse(file.toString()) as {
    format: string;
    version: number;
    programs: { name: string; program: { text: string } }[];
  };
  expect([said.format, said.version]).toEqual(['gcode-playground programs', 1]);
  expect(said.programs.map((each) => each.program.text).sort()).toEqual([SHAFT, BUSH].sort());

  const take = (text: string | Buffer) =>
    list(page)
      .locator('input[type=file]')
      .setInputFiles({ name: 'programs.json', mimeType: 'application/json', buffer: Buffer.from(text) });
  const status = list(page).getByRole('status');
  await test.step('what is there is there already', async () => {
    await take(file);
    await expect(status).toHaveText('Added: 0 programs. Already in the list: 2.');
    await expect(items(page)).toHaveCount(2);
  });
  await test.step('another text under the same id comes beside it', async () => {
    await take(file.toString().replace('X32', 'X33'));
    await expect(status).toHaveText('Added: 1 program. Already in the list: 1.');
    await expect(items(page)).toHaveCount(3);
  });
  await test.step('what was deleted comes back', async () => {
    await act(page, 'O0012 BUSH', 'Delete');
    await take(file);
    await expect(status).toHaveText('Added: 1 program. Already in the list: 1.');
  });
  await test.step('another file is refused, with the reason', async () => {
    for (const [text, reason] of [
      ['G00 X1\n', 'no file of programs'],
      ['[]', 'no file of programs'],
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

test('what is asked for at once is done in turn: a file of programs taken while one is being deleted', async ({
  page,
}) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  await openList(page);
  const saving = page.waitForEvent('download');
  await list(page).getByRole('button', { name: 'Export all' }).click();
  const file = readFileSync(await (await saving).path()).toString();
  await list(page).getByRole('button', { name: 'What can be done with O0011 SHAFT', exact: true }).click();
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

test('a program that gave way to another one is kept with its last key', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await typeAtEnd(page, 'G4 X1');
  // Before it was time to keep it.
  await page.getByLabel('Example').selectOption('s003-g71');
  await expect.poll(() => value(page)).toBe(program('s003-g71'));
  await openList(page);
  await items(page).nth(0).getByRole('button').first().click();
  await expect.poll(() => value(page)).toBe(`${SHAFT}G4 X1`);
});

// A browser can put a page aside as it is, with what it was about to write, and show it again when the reader goes back.
test('a page that is left while the list is written keeps no other waiting, and goes on when it is shown again', async ({
  page,
}) => {
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

test('a page that is left before its list is open goes on when it is shown again', async ({ page, engine }) => {
  await open(page, '#program=O1%0AG00%20X1');
  await page.evaluate(() =>
    addEventListener('pageshow', ({ persisted }) => void (document.title = `shown again: ${persisted}`)),
  );
  await typeAtEnd(page, '(A)');
  await page.goto('about:blank');
  await page.goBack();
  await expect.poll(() => value(page)).toContain('(A)');
  // Chromium puts no page aside that a test drives, and loads it anew.
  if (engine !== 'chromium') await expect.poll(() => page.evaluate(() => document.title)).toBe('shown again: true');
  await openList(page);
  await expect(items(page)).toHaveCount(1);
});

test('what another tab makes of a program, while the page that it was typed in is put aside, is not overwritten', async ({
  page,
  engine,
}) => {
  await open(page, '#program=O1%0AG00%20X1');
  await page.evaluate(() => void (document.documentElement.dataset['before'] = 'yes'));
  await typeAtEnd(page, '(A)');
  await page.goto('about:blank');
  // The next page takes over what was left, and goes on with it.
  await open(page);
  await expect.poll(() => value(page)).toContain('(A)');
  await typeAtEnd(page, '(B)');
  await kept(page);
  const next = await page.evaluate(() => performance.timeOrigin);
  await page.goBack();
  await page.goBack();
  // On the way there is no page to ask.
  await expect.poll(() => page.evaluate(() => performance.timeOrigin).catch(() => next)).not.toBe(next);
  await expect.poll(() => value(page)).toContain('O1');
  // Who has not put it aside loads it anew.
  const isShownAgain = (await page.evaluate(() => document.documentElement.dataset['before'])) === 'yes';
  if (engine === 'webkit') expect(isShownAgain).toBe(true);
  if (isShownAgain) await expect(said(page)).toContainText('in another tab');
  await typeAtEnd(page, '(C)');
  await kept(page);
  await openList(page);
  await expect
    .poll(async () => (await textsInList(page)).filter((text) => text.startsWith('O1\nG00 X1(A)(B)')))
    .toHaveLength(1);
  if (isShownAgain) expect(await textsInList(page)).toContain('O1\nG00 X1(A)(C)');
});

test('a program that is too long for the journal is not left without a question until the list has it', async ({
  page,
}) => {
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

test('a link takes the place of the program, which stays in the list', async ({ page }) => {
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

test('the program that was kept before there was a list is taken into it once', async ({ page }) => {
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

test('a list that is full takes no more, and says so; what is in the editor stays', async ({ page }) => {
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
  await expect(said(page)).toContainText('The list of your programs is full: this program is not in it.');
  await page.reload();
  await expect.poll(() => value(page)).toBe(SHAFT);
  await test.step('until there is room', async () => {
    await openList(page);
    await list(page).getByRole('searchbox').fill('Part 777');
    await act(page, 'Part 777', 'Delete');
    await close(page);
    await typeAtEnd(page, 'G4 X1');
    await expect(said(page)).toBeHidden();
    await openList(page);
    await list(page).getByRole('searchbox').fill('O0011');
    await expect(items(page).nth(0)).toContainText('O0011 SHAFT');
  });
});

// ---- two tabs ---------------------------------------------------------------------------------------

/** A click in a tab that nobody may see, where nothing is painted. */
const press = (button: Locator): Promise<void> => button.evaluate((element) => element.click());

async function openListUnseen(page: BasicPage): Promise<void> {
  await press(button(page));
  await expect(list(page).getByRole('status')).not.toHaveText('');
}

test('what another tab does to the same program is said, and shown where the reader wants it', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  const second = await secondTab(page);
  await expect.poll(() => value(second)).toBe(SHAFT);
  await addUnseen(second, '(of the second tab)');
  await expect(said(page)).toContainText('This program was changed in another tab.');
  const theirs = await value(second);
  expect(theirs).toContain('(of the second tab)');
  await press(said(page).getByRole('button', { name: 'Show the other text' }));
  await expect.poll(() => value(page)).toBe(theirs);
  await expect(said(page)).toBeHidden();
  await test.step('and it goes on as one program', async () => {
    await addUnseen(page, '(of the first)');
    await expect(said(second)).toContainText('This program was changed in another tab.');
    await openListUnseen(page);
    await expect(items(page)).toHaveCount(1);
  });
});

test('two tabs that change the same program keep both texts', async ({ page }) => {
  await open(page);
  await type(page, SHAFT);
  await kept(page);
  const second = await secondTab(page);
  await addUnseen(second, '(of the second tab)');
  await expect(said(page)).toContainText('This program was changed in another tab.');
  await addUnseen(page, '(of the first)');
  await expect(said(page)).toContainText('Both are kept: this one is now “O0011 SHAFT (2)”.');
  const mine = await value(page);
  await openListUnseen(page);
  await expect(items(page)).toHaveCount(2);
  await expect(items(page).filter({ hasText: 'open now' })).toContainText('O0011 SHAFT (2)');
  expect(mine).toContain('(of the first)');
  await press(items(page).filter({ hasText: 'O0011 SHAFT' }).last().getByRole('button').first());
  await expect.poll(() => value(page)).toContain('(of the second tab)');
  await test.step('or at once where the reader says so', async () => {
    await addUnseen(second, '(more)');
    await press(said(page).getByRole('button', { name: 'Keep both' }));
    await expect(said(page)).toContainText('Both are kept');
    await openListUnseen(page);
    await expect(items(page)).toHaveCount(3);
  });
  await test.step('and what is deleted in the other tab stays on the page', async () => {
    await press(list(page).getByRole('button', { name: 'Close' }));
    await openListUnseen(second);
    await press(list(second).getByRole('button', { name: 'What can be done with O0011 SHAFT (3)', exact: true }));
    await press(list(second).getByRole('button', { name: 'Delete', exact: true }));
    await expect(said(page)).toContainText('This program was deleted in another tab.');
    expect(await value(page)).toContain('(of the second tab)');
  });
});

// ---- when the browser does not keep it --------------------------------------------------------------

/** The database answers as one that has no room, or is not allowed, as long as `window.refuses` says so. */
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

test('a full store is said, the text stays, and is kept when there is room', async ({ page }) => {
  await page.addInitScript(refusing);
  await open(page);
  await setRefusal(page, 'QuotaExceededError');
  await type(page, SHAFT);
  await expect(said(page)).toContainText('The browser has no room left: the last changes are not kept.');
  expect(await value(page)).toBe(SHAFT);
  const saving = page.waitForEvent('download');
  await said(page).getByRole('button', { name: 'Save file' }).click();
  expect(readFileSync(await (await saving).path(), 'utf8')).toBe(SHAFT);
  await setRefusal(page, '');
  // Without another key.
  await expect(said(page)).toBeHidden();
  await openList(page);
  await expect(items(page)).toHaveCount(1);
});

test('a browser that refuses to keep a list keeps the last program, or says that it keeps none', async ({ page }) => {
  await page.addInitScript(refusing);
  await open(page);
  await setRefusal(page, 'NotAllowedError');
  await type(page, SHAFT);
  await expect(said(page)).toContainText('only the last program will be here next time');
  await setRefusal(page, 'SecurityError');
  await typeAtEnd(page, 'G4 X1');
  await expect(said(page)).toContainText('The browser does not keep programs for this page');
  expect(await value(page)).toBe(`${SHAFT}G4 X1`);
  await expect(said(page).getByRole('button', { name: 'Save file' })).toBeVisible();
});

test('what is deleted while the page is open is said, and the text is kept again', async ({ page }) => {
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
  await expect(said(page)).toContainText('What the browser had kept for this page was deleted.');
  await openList(page);
  await expect(items(page)).toHaveCount(1);
  await close(page);
  await page.reload();
  await expect.poll(() => value(page)).toBe(SHAFT);
});

// ---- what is stored can be anything -----------------------------------------------------------------

test('stored values of any type are read as what anybody can have written', { tag: '@night' }, async ({ page }) => {
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

test('a list whose rows are of any type is shown all the same', async ({ page }) => {
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
  await page.reload();
  await openList(page);
  await expect(items(page)).toHaveCount(7);
  await items(page).last().getByRole('button').first().click();
  await expect(items(page)).toHaveCount(7);
  const saving = page.waitForEvent('download');
  await list(page).getByRole('button', { name: 'Export all' }).click();
  const { programs } = JSON.parse(readFileSync(await (await saving).path(), 'utf8')) as { programs: unknown[] };
  expect(programs).toHaveLength(1);
});
