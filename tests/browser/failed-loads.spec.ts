// Files that fail to load, at the start and later: a notice with "Try again" stays until everything works, no loading
// state is shown meanwhile, an outdated picture is labelled, and the page works once the files are available.
import { expect, test, type Page, nightUnless } from './engines';
import { chip, choose, chooseLanguage, editor, settled, type } from './page';
import { DIST, storedSite, type Refusal, type StoredSite } from './stored-site';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const PROGRAM = 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nM30\n';
const NEXT_PROGRAM = 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nX45\nM30\n';
/** Needs the part that reads setups. */
const WITH_SETUP = { program: PROGRAM, setup: '{"stock":{"diameter":60,"length":80}}' };

const INTERPRETER = 'The interpreter could not be loaded';
const PARTS = 'Not all of the playground could be loaded';

interface File {
  readonly pattern: RegExp;
  readonly message: string;
  /** Status line while the file is missing. */
  readonly status: string | RegExp;
}

const FILES: Readonly<Record<string, File>> = {
  'the core module': { pattern: /gcode_playground_bg-[\w-]+\.wasm$/, message: INTERPRETER, status: '—' },
  'the script of the worker': { pattern: /\/worker-[\w-]{8}\.js$/, message: INTERPRETER, status: '—' },
  'the part that reads the setup': { pattern: /\/early-[\w-]{8}\.wasm$/, message: PARTS, status: '—' },
  'the part of the machine': {
    pattern: /\/late-[\w-]{8}\.wasm$/,
    message: PARTS,
    status: /part and messages could not be loaded/,
  },
  'the sentences': { pattern: /\/en-[\w-]{8}\.txt$/, message: PARTS, status: /part and messages could not be loaded/ },
  'the editor': { pattern: editorFile(), message: 'The editor could not be loaded', status: /^2 motions/ },
};

/** The file of the editor; another file has a similar name. */
function editorFile(): RegExp {
  const file = /import\("\.\/assets\/(editor-[\w-]+)\.js"\)/.exec(readFileSync(join(DIST, 'element.js'), 'utf8'))?.[1];
  if (file === undefined) throw new Error('element.js imports no editor');
  return new RegExp(`/${file}\\.js$`);
}

/** The file that contains CodeMirror, which the editor imports. */
function codeMirror(): RegExp {
  const assets = join(DIST, 'assets');
  const found = readdirSync(assets).filter(
    (file) => /^index-[\w-]+\.js$/.test(file) && readFileSync(join(assets, file), 'utf8').includes('cm-content'),
  );
  if (found.length !== 1) throw new Error(`CodeMirror is in ${found.length} files`);
  return new RegExp(`/${found[0]?.replace('.js', '')}\\.js$`);
}

const status = (page: Page) => page.locator('gcode-playground').getByRole('status');
const oldPicture = (page: Page) => page.getByText('Old picture: the current program could not be run');
const notice = (page: Page, message: string) => page.getByRole('alert').filter({ hasText: message });
const online = (page: Page) => page.evaluate(() => void dispatchEvent(new Event('online')));

/** Everything works, and no message says otherwise. */
async function works(page: Page, motions: number): Promise<void> {
  await expect(status(page)).toContainText(`${motions} motions`);
  await expect(status(page)).toContainText('problem');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expect(editor(page)).toBeVisible();
  await expect(chip(page)).toContainText(' · mm');
  await expect(oldPicture(page)).toHaveCount(0);
}

/** The notice is shown, and no message says that the file is loading. */
async function fails(page: Page, { message, status: statusText }: File): Promise<void> {
  await expect(notice(page, message)).toBeVisible();
  await expect(notice(page, message).getByRole('button', { name: 'Try again' })).toBeVisible();
  await expect(status(page)).toContainText(statusText);
  await expect(status(page)).not.toContainText('…');
  await expect(page.getByText('Reading …')).toHaveCount(0);
}

/** Actions that make the page retry. */
const TRIGGERS: Readonly<Record<Refusal, (page: Page, message: string) => Promise<void>>> = {
  missing: (page) => press(page),
  closed: (page) => online(page),
  corrupted: (page, message) =>
    // An edit retries, too, so the notice may be gone: then a click would wait for it.
    notice(page, message).evaluateAll((notices) => {
      for (const notice of notices) notice.querySelector('button')?.click();
    }),
};

/** Types into the program, whether or not the editor is loaded. */
async function press(page: Page): Promise<void> {
  await page.locator('gcode-playground').locator('.cm-content, pre.waiting').focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText(' ');
}

/**
 * Run without `--all`, in every engine, with one kind of failure. Browsers differ most in these two: a WebAssembly
 * module, and a script imported by another script.
 */
const IN_EVERY_ENGINE = ['the core module', 'the editor'];

for (const [name, file] of Object.entries(FILES)) {
  for (const how of ['missing', 'closed', 'corrupted'] as const) {
    test(
      `${name} is ${how} when the page starts`,
      nightUnless(how === 'missing' && IN_EVERY_ENGINE.includes(name)),
      async ({ page }) => {
        const site = await storedSite();
        site.refuse(file.pattern, how);
        await page.goto(`${site.address}#${new URLSearchParams(WITH_SETUP)}`);
        await fails(page, file);
        for (const [by, trigger] of Object.entries(TRIGGERS)) {
          const refused = (): number => site.requested.filter((path) => file.pattern.test(`/${path}`)).length;
          const before = refused();
          await trigger(page, file.message);
          await expect.poll(refused, `asked again after ${by}`).toBeGreaterThan(before);
          await fails(page, file);
        }
        site.refuse();
        await TRIGGERS[how](page, file.message);
        await works(page, 2);
        await site.stop();
      },
    );
  }
}

test('the network returns while the editor is being retried', async ({ page, engine }) => {
  const site = await storedSite();
  // WebKit does not cache a failed import, and requests the same URL.
  site.refuse(editorFile(), 'closed', engine === 'webkit' ? /editor/ : /again=/);
  await page.goto(`${site.address}#${new URLSearchParams(WITH_SETUP)}`);
  await works(page, 2).catch((error: unknown) => {
    throw new Error(`asked for ${site.requested.join(' ')}`, { cause: error });
  });
  await site.stop();
});

for (const how of ['missing', 'closed', 'corrupted'] as const) {
  test(
    `the library of the editor is ${how} when the page starts`,
    nightUnless(how === 'missing'),
    async ({ page, engine }) => {
      const site = await storedSite();
      const library = { pattern: codeMirror(), message: 'The editor could not be loaded', status: /^2 motions/ };
      site.refuse(library.pattern, how);
      await page.goto(`${site.address}#${new URLSearchParams(WITH_SETUP)}`);
      await expect(notice(page, library.message)).toBeVisible();
      site.refuse();
      // Browsers cache the failure of a file imported by another file: all of them for a script with a syntax error,
      // Firefox for every failure.
      await TRIGGERS[how](page, library.message);
      if (how === 'corrupted' || engine === 'firefox')
        await notice(page, 'the page has to be reloaded').getByRole('button', { name: 'Reload' }).click();
      await works(page, 2);
      await site.stop();
    },
  );
}

/** Runs before the scripts of the page: stores its workers in `workers`. */
const KEEPS_WORKERS = `
  window.workers = [];
  const Own = window.Worker;
  window.Worker = class extends Own {
    constructor(...given) {
      super(...given);
      window.workers.push(this);
    }
  };
`;

async function open(page: Page, site: StoredSite): Promise<void> {
  const html = readFileSync(join(DIST, 'index.html'), 'utf8').replace(
    '<head>',
    '<head><script src="./keeps-workers.js"></script>',
  );
  site.publish(
    new Map([
      ['index.html', html],
      ['keeps-workers.js', KEEPS_WORKERS],
    ]),
  );
  await page.goto(`${site.address}#${new URLSearchParams({ program: PROGRAM, setup: '{}' })}`);
  await works(page, 2);
  await settled(page);
}

/** Throws an uncaught error in the worker. */
async function workerFails(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      void (Reflect.get(window, 'workers') as Worker[])
        .at(-1)
        ?.dispatchEvent(new ErrorEvent('error', { message: 'a fault' })),
  );
}

test('after an error of the worker, the notice stays until a program has run', async ({ page }) => {
  const site = await storedSite();
  await open(page, site);
  await workerFails(page);
  const failed = notice(page, 'The interpreter failed');
  await expect(failed).toBeVisible();
  await expect(status(page)).toHaveText('—');
  // The picture is that of the current program.
  await expect(oldPicture(page)).toHaveCount(0);
  await failed.getByRole('button', { name: 'Try again' }).click();
  await works(page, 2);
  await workerFails(page);
  await expect(failed).toBeVisible();
  await type(page, NEXT_PROGRAM);
  await works(page, 3);
  await site.stop();
});

for (const how of ['missing', 'closed', 'corrupted'] as const) {
  test(`an error of the worker while its script is ${how}`, { tag: '@night' }, async ({ page }) => {
    const site = await storedSite();
    const worker = FILES['the script of the worker']!;
    await open(page, site);
    site.refuse(worker.pattern, how);
    await workerFails(page);
    // A worker script that the browser has cached still starts.
    await expect(page.getByRole('alert').filter({ hasText: 'The interpreter' })).toBeVisible();
    await workerFails(page);
    await expect(
      page.getByRole('alert').filter({ hasText: 'The interpreter' }).getByRole('button', { name: 'Try again' }),
    ).toBeVisible();
    site.refuse();
    await type(page, NEXT_PROGRAM);
    await works(page, 3);
    await site.stop();
  });
}

/** Programs that need the part `early` before they can run. */
const LATER = {
  'a program with macros': { program: 'G00 X50 Z2\n#1=40\nG01 X#1 Z-20 F0.2\nM30\n', motions: 2 },
  'a program with a rounding': { program: 'G00 X40 Z2\nG01 Z-20 R2 F0.2\nX50\nM30\n', motions: 4 },
};

for (const [name, { program, motions }] of Object.entries(LATER)) {
  for (const how of ['missing', 'closed', 'corrupted'] as const) {
    test(`the part for ${name} is ${how}`, { tag: '@night' }, async ({ page }) => {
      const site = await storedSite();
      const pattern = /\/early-[\w-]{8}\.wasm$/;
      site.refuse(pattern, how);
      // A program that does not need it is drawn.
      await page.goto(`${site.address}#${new URLSearchParams({ program: PROGRAM, setup: '{}' })}`);
      await fails(page, { pattern, message: PARTS, status: /^2 motions .* part and messages could not be loaded/ });
      await expect(editor(page)).toBeVisible();
      await type(page, program);
      const file = { pattern, message: PARTS, status: '—' };
      await fails(page, file);
      await expect(oldPicture(page)).toBeVisible();
      await press(page);
      await fails(page, file);
      await expect(oldPicture(page)).toBeVisible();
      // An ordinary program runs meanwhile.
      await type(page, NEXT_PROGRAM);
      await expect(status(page)).toContainText('3 motions');
      await expect(oldPicture(page)).toHaveCount(0);
      await expect(notice(page, PARTS)).toBeVisible();
      await type(page, program);
      await fails(page, file);
      site.refuse();
      await TRIGGERS[how](page, PARTS);
      await works(page, motions);
      await site.stop();
    });
  }
}

test('the messages of another language are missing', async ({ page }) => {
  const site = await storedSite();
  await open(page, site);
  site.refuse(/\/ru-[\w-]{8}\.txt$/);
  await chooseLanguage(page, 'ru');
  const missing = notice(page, 'Загружено не всё');
  await expect(missing).toBeVisible();
  await type(page, NEXT_PROGRAM);
  await expect(status(page)).toContainText('деталь и сообщения не загружены');
  await expect(missing).toBeVisible();
  site.refuse();
  await missing.getByRole('button', { name: 'Повторить' }).click();
  await expect(missing).toHaveCount(0);
  await expect(status(page)).toContainText('замечани');
  await site.stop();
});

test('the codes are missing, and the request is answered once they are available', async ({ page }) => {
  const site = await storedSite();
  site.refuse(/\/late-[\w-]{8}\.wasm$/);
  await page.goto(`${site.address}#${new URLSearchParams({ program: PROGRAM, setup: '{}' })}`);
  await expect(status(page)).toContainText('2 motions');
  await choose(page, 'help', 'Supported codes');
  await expect(notice(page, PARTS)).toHaveCount(1);
  site.refuse();
  await online(page);
  await expect(page.getByRole('rowheader', { name: 'G71', exact: true })).toBeVisible();
  await expect(notice(page, PARTS)).toHaveCount(0);
  await site.stop();
});

test('the completions of the editor are missing', { tag: '@one-engine' }, async ({ page }) => {
  const site = await storedSite();
  await open(page, site);
  site.refuse(/\/completion-[\w-]{8}\.js$/);
  await editor(page).focus();
  const missing = notice(page, 'The proposals of the editor could not be loaded');
  await expect(missing).toBeVisible();
  site.refuse();
  await press(page);
  await works(page, 2);
  await site.stop();
});

test('panels and other files are missing, and the notices are shown one at a time', async ({ page }) => {
  const site = await storedSite();
  const either = (...patterns: readonly RegExp[]): RegExp => new RegExp(patterns.map(({ source }) => source).join('|'));
  const panels = /\/further-[\w-]{8}\.js$/;
  site.refuse(either(panels, editorFile(), FILES['the core module']!.pattern), 'closed');
  await page.goto(`${site.address}#${new URLSearchParams(WITH_SETUP)}`);
  await expect(notice(page, INTERPRETER)).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(1);
  site.refuse(either(panels, editorFile()), 'missing');
  await online(page);
  await expect(notice(page, 'Part of the page could not be loaded')).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(1);
  site.refuse();
  await notice(page, 'Part of the page').getByRole('button', { name: 'Try again' }).click();
  await works(page, 2);
  await site.stop();
});

test('typing retries at most every two seconds', { tag: '@one-engine' }, async ({ page }) => {
  const site = await storedSite();
  const { pattern } = FILES['the core module']!;
  site.refuse(pattern);
  await page.goto(`${site.address}#${new URLSearchParams(WITH_SETUP)}`);
  await expect(notice(page, INTERPRETER)).toBeVisible();
  await expect(editor(page)).toBeVisible();
  const begun = Date.now();
  const before = site.requested.filter((path) => pattern.test(path)).length;
  await editor(page).focus();
  for (let key = 0; key < 50; key++) {
    await page.keyboard.press('X');
    await page.waitForTimeout(100);
  }
  const seconds = (Date.now() - begun) / 1000;
  const attempts = site.requested.filter((path) => pattern.test(path)).length - before;
  expect(attempts).toBeGreaterThan(0);
  // Two more: one at the first key, and one that was already running.
  expect(attempts).toBeLessThanOrEqual(Math.ceil(seconds / 2) + 2);
  await expect(notice(page, INTERPRETER)).toBeVisible();
  await site.stop();
});
