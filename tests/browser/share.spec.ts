// Sharing: the dialog makes links, and a link restores exactly the shared state. A broken link shows a message and
// changes nothing. `links.spec.ts` tests the content of links.
import { expect, test, type Locator, type Page, nightUnless } from './engines';
import { openHtml, programOf } from './embedded';
import { random, randomState, storedLinks } from './links';
import { chip, choose, chooseLanguage, clipboard, editor, open, openFile, reload, settled, type, value } from './page';
import { makeLink, EMPTY_SHARED, parseLink, type Shared } from '../../www/src/files/shared-link';

const OWN = 'O0001\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nX32\nG00 X100 Z100\nM30\n';
/** Answers of the pupils of a class. */
const ANSWERS = ['G90 X32 Z-20 F0.2', 'G90 X38 Z-20 F0.2', 'G01 X32 F0.2'];
const MESSAGE = /^(This link|This address|The program of this link)/;

/** The attributes and text of the element that are shared. */
interface State {
  readonly text: string;
  readonly setup: string | null;
  readonly control: string | null;
  readonly blockSkip: string | null;
  readonly program: string | null;
  readonly language: string;
  readonly view: string;
  readonly step: string | null;
  readonly readonly: boolean;
  readonly file: { readonly name: string; readonly encoding: string } | null;
}

interface Playground extends HTMLElement {
  opened: { text: string; file: { name: string; encoding: string } | undefined };
  setup: string | null;
  control: string | null;
  blockSkip: string | null;
  program: string | null;
  origin: string | null;
  language: string;
  view: string;
  step: string | null;
  readonly: boolean;
  readonly settled: Promise<number>;
  currentStep(): Promise<string | null>;
  pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined>;
}

const state = (page: Page): Promise<State> =>
  page.locator('gcode-playground').evaluate((element) => {
    const { opened, setup, control, blockSkip, program, language, view, step, readonly } =
      element as unknown as Playground;
    return {
      text: opened.text,
      file: opened.file ?? null,
      setup,
      control,
      blockSkip,
      program,
      language,
      view,
      step,
      readonly,
    };
  });

const openShare = (page: Page): Promise<void> =>
  choose(page, 'share', /^(Link, task, QR code|链接、任务、二维码|Ссылка, задание, QR-код)…$/);
const output = (page: Page) => page.getByRole('textbox', { name: 'To copy' });

/** Opens the dialog, and returns the link once it is made. */
async function link(page: Page): Promise<string> {
  await openShare(page);
  await expect.poll(() => page.locator('#share-output').inputValue()).toContain('#share=1.');
  return page.locator('#share-output').inputValue();
}

const titleOf = (page: Page): Promise<string> => page.evaluate(() => document.title);

async function named(name: string): Promise<string> {
  const made = await makeLink({ ...EMPTY_SHARED, text: OWN, name });
  return made.kind === 'link' ? made.link : '';
}

/** Opens a link in another browser, with empty storage. */
async function openElsewhere(page: Page, address: string): Promise<void> {
  await page.evaluate(() => localStorage.clear());
  await page.goto('about:blank');
  await open(page, address.slice(address.indexOf('#')));
}

/** Changes the fragment of the URL in the open page. */
async function go(page: Page, hash: string): Promise<void> {
  await page.evaluate((hash) => void (location.hash = hash), hash);
}

test('a link restores program, setup, control and switches', async ({ page }) => {
  await open(page, '#s002-g121-square');
  await page.locator('gcode-playground').evaluate((element) => {
    element.setAttribute('block-skip', '1,3');
    element.setAttribute('control', 'gsk');
  });
  const before = await state(page);
  expect(before.setup).not.toBeNull();
  const address = await link(page);
  expect(address.length).toBeLessThan(300 + before.text.length + address.indexOf('#'));
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(page.getByText('Copied', { exact: true })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect.poll(() => clipboard(page)).toBe(address);
  await openElsewhere(page, address);
  expect(await state(page)).toEqual(before);
  await expect(chip(page)).toContainText('GSK 980TD');
});

test('a file keeps its name and its line ends', async ({ page }) => {
  await open(page);
  await openFile(page, 'вал 7.nc', Buffer.from(OWN.replaceAll('\n', '\r\n')));
  await expect.poll(() => value(page)).toBe(OWN);
  const before = await state(page);
  await openElsewhere(page, await link(page));
  expect(await state(page)).toEqual(before);
  expect(before.file?.name).toBe('вал 7.nc');
});

test('a link restores the position of the tool and the language', async ({ page }) => {
  await open(page);
  await chooseLanguage(page, 'ru');
  const playground = page.locator('gcode-playground');
  await playground.evaluate(async (element) => {
    const own = element as unknown as Playground;
    own.step = '7';
    await own.settled;
  });
  await expect.poll(() => playground.evaluate((element) => (element as unknown as Playground).currentStep())).toBe('7');
  await openShare(page);
  await page.getByLabel(/Инструмент там/).check();
  await page.getByLabel(/Только для чтения/).check();
  await expect.poll(() => page.locator('#share-output').inputValue()).toContain('#share=1.');
  await openElsewhere(page, await page.locator('#share-output').inputValue());
  expect(await state(page)).toMatchObject({ language: 'ru', step: '7', readonly: true });
  expect(await playground.evaluate((element) => (element as unknown as Playground).currentStep())).toBe('7');
  // A button makes it an editable program.
  await page.getByRole('button', { name: 'Открыть для правки' }).click();
  expect(await state(page)).toMatchObject({ readonly: false, view: 'all', step: null });
});

test('before a final dwell, the tool is at the end of the previous motion', async ({ page }) => {
  await open(page);
  const step = await page.locator('gcode-playground').evaluate(async (element) => {
    const playground = element as unknown as Playground;
    playground.opened = { text: 'T0101\nG97 S800 M03\nG00 X60 Z2\nG01 Z-5 F0.2\nG04 X1.5\nM30\n', file: undefined };
    await playground.settled;
    playground.step = 'line 5';
    await playground.settled;
    return playground.currentStep();
  });
  expect(step).toBe('2');
});

test('before the last motion, the tool is at the end of the previous one, also from a link', async ({ page }) => {
  await open(page);
  const steps = await page.locator('gcode-playground').evaluate(async (element) => {
    const playground = element as unknown as Playground;
    playground.opened = { text: 'T0101\nG97 S800 M03\nG00 X42 Z2\nG01 Z-20 F0.2\nX50\nM30\n', file: undefined };
    await playground.settled;
    const steps: (string | null)[] = [];
    for (const step of ['line 5', '2', '3']) {
      playground.step = step;
      await playground.settled;
      steps.push(await playground.currentStep());
    }
    return steps;
  });
  // At the end of the last motion the whole path is shown.
  expect(steps).toEqual(['2', '2', null]);
});

test('a step that is removed before it is applied does not keep the element waiting', async ({ page }) => {
  await open(page);
  const settled = page.locator('gcode-playground').evaluate(async (element) => {
    const playground = element as unknown as Playground;
    Object.assign(playground, { step: 'line 5', view: 'playback' });
    playground.step = null;
    return playground.settled;
  });
  expect(await settled).toBeGreaterThan(0);
});

test('opening a link in an open page stores the current program, and offers it', async ({ page }) => {
  await open(page);
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  const stored = storedLinks().find(({ what }) => what === 'a program alone');
  await go(page, stored?.link ?? '');
  await expect.poll(() => value(page)).toBe(stored?.opens.text);
  // Also after the program of the link was changed.
  await editor(page).focus();
  await page.keyboard.insertText('(X)');
  await expect(page.getByText('This program is from a link')).toBeVisible();
  await page.getByRole('button', { name: 'Bring it back' }).click();
  await expect.poll(() => value(page)).toBe(OWN);
});

test('every stored link opens in the page', async ({ page }) => {
  await open(page);
  for (const { what, link, opens } of storedLinks()) {
    await go(page, link);
    const { task: _, answerTo: __, exercise: ___, name, ...rest } = opens;
    await expect
      .poll(() => state(page), what)
      .toMatchObject({ setup: null, view: 'all', step: null, readonly: false, ...rest });
    if (typeof name === 'string')
      await expect.poll(() => page.locator('#link-bar').textContent(), what).toContain(name);
  }
});

test('broken, truncated, newer and hostile links show a message and change nothing', async ({ page }) => {
  await open(page);
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  const before = await state(page);
  const good = storedLinks().find(({ what }) => what === 'all that a link can say')?.link ?? '';
  const broken = [
    good.slice(0, -1),
    good.slice(0, 40),
    good.slice(0, 12),
    '#share=',
    good.replace('#share=1', '#share=4'),
    good.replace('#share=1', '#share=3'),
    good.replace('#share=1', '#share=2'),
    good.replace('z', 'b'),
    `${good.slice(0, 60)}A${good.slice(61)}`,
    '#zz-nonexistent',
    '#share=1.9.zAAAA',
    '#share=1.12.z00000000000',
    '#shared=1',
    '#prog=G00',
    '#%00%ff',
    '#share=1.20.zS0wcBYNg00000000000',
  ];
  for (const hash of broken) {
    await go(page, hash);
    await expect.poll(() => page.locator('#link-bar p').textContent(), hash).toMatch(MESSAGE);
    await expect(page.locator('#link-bar')).toBeVisible();
    expect(await state(page), hash).toEqual(before);
    await page.getByRole('button', { name: 'Hide', exact: true }).click();
  }
  await page.evaluate(() => {
    try {
      location.hash = `#share=1.1999990.z${'A'.repeat(1_999_980)}`;
    } catch {
      // Firefox itself rejects URLs of more than 1,048,576 characters.
      location.hash = `#share=1.1019990.z${'A'.repeat(1_019_980)}`;
    }
  });
  await expect(page.getByText(/This link is [\d,]+ characters long/)).toBeVisible();
  expect(await state(page)).toEqual(before);
  // Decompression to hundreds of millions of characters is stopped.
  await page.evaluate(async () => {
    const bytes = new Uint8Array(
      await new Response(
        new Blob([new Uint8Array(100_000_000)]).stream().pipeThrough(new CompressionStream('deflate-raw')),
      ).arrayBuffer(),
    );
    let binary = '';
    for (const byte of bytes) binary += String.fromCharCode(byte);
    const body = `z${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
    let crc = -1;
    for (const letter of body) {
      crc ^= letter.charCodeAt(0);
      for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ ((crc & 1) === 0 ? 0 : 0xedb88320);
    }
    location.hash = `#share=1.${body.length + 8}.${body}${(~crc >>> 0).toString(16).padStart(8, '0')}`;
  });
  await expect(page.getByText(/longer than 4,000,000 bytes/)).toBeVisible();
  expect(await state(page)).toEqual(before);
  // Loading the page with such a URL restores the previous program, too.
  await go(page, good.slice(0, -5));
  await reload(page);
  await expect(page.getByText(/^This link is not complete: 5 characters missing/)).toBeVisible();
  await expect.poll(() => value(page)).toBe(OWN);
});

test('the copied element, frame and Markdown show the program', async ({ page }) => {
  await open(page);
  const home = await page.evaluate(() => location.href.replace(/#.*/, ''));
  const own = 'O0001 (A<B & "C" </pre></script> *D* [E](F))\n\nT0101\nG97 S800 M03\nG00 X42 Z2\nG01 Z-20 F0.2\nM30';
  await type(page, own);
  await expect.poll(() => value(page)).toBe(own);
  await page.locator('gcode-playground').evaluate((element) => {
    element.setAttribute('setup', '{"stock": {"diameter": 40, "length": 60}}');
    element.setAttribute('program', '1');
  });
  await openShare(page);
  const form = page.getByRole('combobox', { name: 'As' });
  await page.getByRole('combobox', { name: 'Shown' }).selectOption('playback');
  await form.selectOption('markdown');
  await expect.poll(() => output(page).inputValue()).toMatch(/^\[G-code playground\]\(<http.*#share=1\.[^<>\s]+>\)$/);
  await form.selectOption('frame');
  await expect.poll(() => output(page).inputValue()).toContain('<iframe');
  const frame = await output(page).inputValue();
  await form.selectOption('element');
  await expect.poll(() => output(page).inputValue()).toContain('<gcode-playground');
  const element = await output(page).inputValue();
  await form.selectOption('qr');
  await expect(page.getByRole('img', { name: 'QR code of the link' })).toBeVisible();
  await form.selectOption('picture');
  await expect(page.getByRole('img', { name: 'Picture' })).toBeVisible();

  await openHtml(
    page,
    `<!doctype html><html lang="en"><title>A manual</title><body><p>before</p>${element}</body></html>`,
  );
  await settled(page);
  expect(await programOf(page)).toBe(own);
  expect(await state(page)).toMatchObject({
    view: 'playback',
    setup: '{"stock": {"diameter": 40, "length": 60}}',
    program: '1',
    language: 'en',
  });

  const source = await page.evaluate(
    (html) => new DOMParser().parseFromString(html, 'text/html').querySelector('iframe')?.getAttribute('src') ?? '',
    frame,
  );
  await page.goto(`./${source.slice(home.length)}`);
  await settled(page);
  expect(await programOf(page)).toBe(own);
  expect(await state(page)).toMatchObject({
    view: 'playback',
    setup: '{"stock":{"diameter":40,"length":60},"program":1}',
  });
});

test('the page reports when a QR code or a link would be too long', async ({ page }) => {
  await open(page);
  const next = random(2);
  const noise = (length: number): string =>
    Array.from({ length }, () => String.fromCharCode(65 + Math.floor(next() * 26)))
      .join('')
      .replace(/(.{60})/g, '($1)\n');
  const long = noise(4000);
  await openFile(page, 'long.nc', Buffer.from(long));
  await expect.poll(() => value(page)).toBe(long);
  await openShare(page);
  await expect(page.getByText(/cut off links of more than 2,000/)).toBeVisible();
  await page.getByRole('combobox', { name: 'As' }).selectOption('qr');
  await expect(page.getByText(/too long for a QR code: [\d,]+ characters; it holds at most 2,331/)).toBeVisible();
  await page.keyboard.press('Escape');
  const longer = noise(1_500_000);
  await openFile(page, 'longer.nc', Buffer.from(longer));
  await expect
    .poll(() =>
      page.locator('gcode-playground').evaluate((element) => (element as unknown as { length: number }).length),
    )
    .toBe(longer.length);
  await openShare(page);
  await expect(page.getByText(/too long for a link/)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Copy', exact: true })).toBeDisabled();
});

test('a teacher gives a class a task by link, and receives links to the answers', { tag: '@night' }, async ({
  page,
}) => {
  // The teacher writes the solution, and removes the part that the class has to find.
  await open(page);
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  await page
    .locator('gcode-playground')
    .evaluate((element) => element.setAttribute('setup', '{"stock":{"diameter":42,"length":60}}'));
  await openShare(page);
  // The class and the readers of the answers use the languages they have chosen.
  await expect(page.getByLabel('Opens in English')).toBeChecked();
  await page.getByLabel('As a task').check();
  await expect(page.getByLabel('Opens in English')).not.toBeChecked();
  await expect(page.getByText('The pupil begins with the solution: delete the part to be found.')).toBeVisible();
  const begin = OWN.replace('G90 X36 Z-20 F0.2\nX32\n', '\n');
  await page.getByLabel('What is to be done').fill('Turn the shoulder to X32 with G90.\nAt most 2 mm per pass.');
  await page.getByLabel('What the pupil begins with').fill(begin);
  await expect(page.getByText('The pupil begins with the solution')).toHaveCount(0);
  await expect.poll(() => output(page).inputValue()).toContain('#share=1.');
  const task = await output(page).inputValue();
  const made = await parseLink(task.slice(task.indexOf('#')));
  expect(made.kind === 'shared' && made.shared).toMatchObject({
    language: null,
    name: null,
    task: { sentence: 'Turn the shoulder to X32 with G90.\nAt most 2 mm per pass.', solution: OWN },
  });

  const returned: string[] = [];
  for (const answer of ANSWERS) {
    // Each pupil has a separate browser.
    await openElsewhere(page, task);
    await expect(page.getByText('Task: Turn the shoulder to X32 with G90.')).toBeVisible();
    await expect.poll(() => page.locator('#link-bar p').textContent()).toContain('G90.\nAt most');
    expect(await page.locator('#link-bar p').evaluate((line) => getComputedStyle(line).whiteSpace)).toBe('pre-line');
    expect(await value(page)).toBe(begin);
    await expect(page.getByText('G90 X36')).toHaveCount(0);
    await editor(page).focus();
    await page.keyboard.press('Control+Home');
    for (let line = 1; line < 5; line++) await page.keyboard.press('ArrowDown');
    await page.keyboard.insertText(answer);
    const work = begin.replace('\n\n', `\n${answer}\n`);
    await expect.poll(() => value(page)).toBe(work);
    // Showing the solution does not change the pupil's program.
    await page.getByRole('button', { name: 'Show solution' }).click();
    await expect(page.getByRole('region', { name: 'Solution', exact: true })).toContainText('G90 X36');
    expect(await value(page)).toBe(work);
    // The same link on another day does not change it either.
    await expect(page.getByText('This program is from a link')).toBeVisible();
    await reload(page);
    await expect.poll(() => value(page)).toBe(work);
    await expect(page.getByText('Task: Turn the shoulder')).toBeVisible();
    await page.goto('about:blank');
    await open(page, task.slice(task.indexOf('#')));
    await expect.poll(() => value(page)).toBe(work);
    // The URL in the browser is still the task; the link to hand in is in the bar.
    expect(await page.evaluate(() => location.href)).toBe(task);
    const name = `Anna ${returned.length + 1}`;
    await page.getByRole('textbox', { name: 'Your name' }).fill(name);
    await page.getByRole('button', { name: 'Copy link to hand in' }).click();
    await expect(page.locator('#link-bar').getByText('Copied', { exact: true })).toBeVisible();
    await expect.poll(() => clipboard(page)).toMatch(/#share=2\.\S+$/);
    returned.push(await clipboard(page));
  }
  // The "copied" message disappears when there is a newer answer.
  await editor(page).focus();
  await page.keyboard.insertText('(X)');
  await expect(page.locator('#link-bar').getByText('Copied', { exact: true })).toHaveCount(0);
  // The teacher opens the answers in order.
  for (const [at, answer] of ANSWERS.entries()) {
    await openElsewhere(page, returned[at] ?? '');
    const { text, setup, language } = await state(page);
    expect(text).toBe(begin.replace('\n\n', `\n${answer}\n`));
    expect(setup).toBe('{"stock":{"diameter":42,"length":60}}');
    expect(language).toBe('en');
    await expect(page.getByText(`From: Anna ${at + 1}`)).toBeVisible();
    await expect(page.locator('#link-bar p')).toContainText('Task: Turn the shoulder to X32 with G90.');
    expect(await titleOf(page)).toMatch(new RegExp(`^Anna ${at + 1} · `));
  }
  // Each answer is compared with the solution, in one tab.
  const solution = await makeLink({ ...EMPTY_SHARED, text: OWN, setup: '{"stock":{"diameter":42,"length":60}}' });
  await openElsewhere(page, solution.kind === 'link' ? solution.link : '');
  await choose(page, 'more', 'Keep this part to compare');
  for (const [at, same] of [1, 0, 0].entries()) {
    await go(page, (returned[at] ?? '').replace(/^.*?#/, '#'));
    await expect(page.getByText(`From: Anna ${at + 1}`)).toBeVisible();
    await page
      .locator('gcode-playground')
      .evaluate(async (element) => void (await (element as unknown as Playground).settled));
    await expect(page.getByText('Same as the reference')).toHaveCount(same);
  }
  // A teacher who uses another language keeps it.
  await chooseLanguage(page, 'ru');
  await go(page, (returned[0] ?? '').replace(/^.*?#/, '#'));
  await expect(page.getByText('От: Anna 1')).toBeVisible();
  expect(await titleOf(page)).toMatch(/^Anna 1 · /);
  expect((await state(page)).language).toBe('ru');
  // The program can be edited; the name is only shown for the answer.
  await editor(page).focus();
  await page.keyboard.insertText('(Y)');
  await expect.poll(() => value(page)).toContain('(Y)');
  await expect(page.getByText('От: Anna 1')).toBeVisible();
  await openFile(page, 'other.nc', Buffer.from('G00 X1\n'));
  await expect(page.getByText('От: Anna 1')).toHaveCount(0);
  expect(await titleOf(page)).not.toContain('Anna');
});

test('an answer shows its task and its solution, and is compared with the solution', async ({ page }) => {
  const stored = storedLinks().find(({ what }) => what === 'an answer with its task');
  await open(page, stored?.link);
  const bar = page.locator('#link-bar');
  await expect(bar.locator('p')).toHaveText('From: Anna\nTask: Turn the shoulder to X32');
  // The answer is the program; it is not work on the task.
  expect(await value(page)).toBe(stored?.opens.text);
  await expect(bar.getByRole('button', { name: 'Copy link to hand in' })).toBeHidden();
  await bar.getByRole('button', { name: 'Show solution' }).click();
  await expect(page.getByRole('region', { name: 'Solution', exact: true })).toContainText('X32');
  await bar.getByRole('button', { name: 'Hide solution' }).click();
  await bar.getByRole('button', { name: 'Compare with the solution' }).click();
  const dialog = page.getByRole('dialog', { name: 'Compare' });
  await expect(dialog.getByRole('img', { name: /^Tool paths of both/ })).toBeVisible();
  await expect(dialog.locator('del')).toContainText('X32');
});

test('an answer without a name shows its task', async ({ page }) => {
  const made = await makeLink({ ...EMPTY_SHARED, text: OWN, answerTo: { sentence: 'Face it', solution: null } });
  await open(page, made.kind === 'link' ? made.link : '');
  const bar = page.locator('#link-bar');
  await expect(bar.locator('p')).toHaveText('Task: Face it');
  await expect(bar.getByRole('button')).toHaveText(['Hide']);
  // Another program is not an answer to this task.
  await openFile(page, 'other.nc', Buffer.from('G00 X1\n'));
  await expect(bar).toBeHidden();
});

test('a task without its solution does not contain it', async ({ page }) => {
  await open(page);
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  await openShare(page);
  await page.getByLabel('As a task').check();
  await page.getByLabel('What is to be done').fill('Turn the shoulder');
  await page.getByLabel('What the pupil begins with').fill('O0001\nM30\n');
  await page.getByLabel('With the solution').click();
  await expect.poll(() => output(page).inputValue()).toContain('#share=2.');
  const address = await output(page).inputValue();
  const made = await parseLink(address.slice(address.indexOf('#')));
  expect(made.kind === 'shared' && made.shared.task).toEqual({ sentence: 'Turn the shoulder', solution: null });
  expect(JSON.stringify(made)).not.toContain('G90');
  await openElsewhere(page, address);
  await expect(page.getByText('Task: Turn the shoulder')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Show solution' })).toHaveCount(0);
  await page.getByRole('button', { name: 'Copy link to hand in' }).click();
  await expect(page.locator('#link-bar').getByText('Copied', { exact: true })).toBeVisible();
  await openElsewhere(page, await clipboard(page));
  await expect(page.locator('#link-bar p')).toHaveText('Task: Turn the shoulder');
});

test('a task of an empty program warns, and an empty task has no link', async ({ page }) => {
  await open(page);
  await type(page, '');
  await expect.poll(() => value(page)).toBe('');
  await openShare(page);
  await page.getByLabel('As a task').check();
  await page.getByLabel('What the pupil begins with').fill('');
  await expect(page.getByText('The task is empty: write what is to be done')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Copy', exact: true })).toBeDisabled();
  await page.getByLabel('What is to be done').fill('Write a program that faces the bar');
  await expect(page.getByText('The page has no program yet, so the task has no solution.')).toBeVisible();
  await expect(page.getByLabel('With the solution')).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Copy', exact: true })).toBeEnabled();
});

test('a draft of a task is kept when the dialog is closed, until the program is replaced', async ({ page }) => {
  await open(page);
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  const [sentence, start] = [page.getByLabel('What is to be done'), page.getByLabel('What the pupil begins with')];
  await openShare(page);
  await page.getByLabel('As a task').check();
  await sentence.fill('Turn it.\nQuickly.');
  await start.fill('T0101\n');
  await page.getByLabel('Opens in English').check();
  await page.keyboard.press('Escape');
  await openShare(page);
  await expect(page.getByLabel('As a task')).toBeChecked();
  await expect(page.getByLabel('Opens in English')).toBeChecked();
  await expect(sentence).toHaveValue('Turn it.\nQuickly.');
  await expect(start).toHaveValue('T0101\n');
  await page.keyboard.press('Escape');
  await type(page, 'G00 X1\n');
  await openShare(page);
  await expect(page.getByLabel('As a task')).not.toBeChecked();
  await expect(page.getByLabel('Opens in English')).toBeChecked();
  await page.getByLabel('As a task').check();
  await expect(sentence).toHaveValue('');
  await expect(start).toHaveValue('G00 X1\n');
});

// The minimum width of WebKit's window is 447 px.
for (const [width, height] of [
  [1280, 800],
  [1280, 600],
  [480, 844],
] as const) {
  test(
    `the QR code of a task is fully visible, with its length and "Close": ${width} × ${height}`,
    nightUnless(width === 480),
    async ({ page }, info) => {
      await page.setViewportSize({ width, height });
      const whole = (part: Locator): Promise<void> =>
        expect
          .poll(async () => {
            const box = await part.boundingBox();
            return (
              box !== null && box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height
            );
          })
          .toBe(true);
      await open(page);
      await openShare(page);
      await page.getByLabel('As a task').check();
      await page.getByLabel('What is to be done').fill('Turn the shoulder');
      // After copying, the buttons have not moved.
      await expect(page.getByRole('button', { name: 'Copy', exact: true })).toBeEnabled();
      await page.getByRole('button', { name: 'Copy', exact: true }).click();
      await whole(page.getByText('Copied', { exact: true }));
      await whole(page.getByRole('button', { name: 'Close', exact: true }));
      await page.screenshot({ path: info.outputPath('copied.png') });
      await page.getByRole('combobox', { name: 'As' }).selectOption('qr');
      const code = page.getByRole('img', { name: 'QR code of the link' });
      await whole(code);
      await whole(page.locator('.share .length'));
      await whole(page.getByRole('button', { name: 'Close', exact: true }));
      await page.screenshot({ path: info.outputPath('qr.png') });
      // Nothing in the dialog covers it, and it is large enough for a camera.
      const [box, buttons] = [await code.boundingBox(), await page.locator('.share .actions').boundingBox()];
      // Without a button, the row of buttons is hidden.
      expect((box?.y ?? 0) + (box?.height ?? 0)).toBeLessThanOrEqual(buttons?.y ?? height);
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(300);
    },
  );
}

test('a name in a link is plain text, on one line, and cannot change the text direction', async ({ page }) => {
  const name = ' \u202e<b>Eve</b>\nTask: <img src=x onerror="document.title=1"> ';
  await open(page);
  await go(page, await named(name));
  const bar = page.locator('#link-bar');
  await expect.poll(() => bar.textContent()).toContain('From: <b>Eve</b> Task: <img src=x onerror="document.title=1">');
  await expect(bar.locator('b, img')).toHaveCount(0);
  expect(await titleOf(page)).toBe('<b>Eve</b> Task: <img src=x onerror="document.title=1"> · G-code playground');
  // A name without a letter is not shown.
  await go(page, await named('\u202e \n'));
  await expect.poll(() => titleOf(page)).toBe('G-code playground');
  await expect(bar).toBeHidden();
});

test('if copying is forbidden, the link to hand in is shown and selected', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'clipboard', { value: undefined });
    const before = document.execCommand.bind(document);
    document.execCommand = (command, ...more) => command !== 'copy' && before(command, ...more);
  });
  await page.setViewportSize({ width: 480, height: 844 });
  await open(page, storedLinks().find(({ what }) => what === 'a task')?.link);
  await page.getByRole('textbox', { name: 'Ваше имя' }).fill('Аня');
  await page.getByRole('button', { name: 'Копировать ссылку для сдачи' }).click();
  const shown = page.getByRole('textbox', { name: 'Ссылка для сдачи' });
  await expect(shown).toBeFocused();
  await expect(page.getByText('скопируйте её вручную')).toBeVisible();
  const address = await shown.inputValue();
  expect(
    await shown.evaluate((field) =>
      ((field) => field.value.slice(field.selectionStart, field.selectionEnd))(field as HTMLTextAreaElement),
    ),
  ).toBe(address);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(480);
  await openElsewhere(page, address);
  await expect(page.getByText('From: Аня')).toBeVisible();
});

test('a link to hand in that takes long to make is still copied', { tag: '@night' }, async ({ page }) => {
  await page.addInitScript(() => {
    const read = ReadableStreamDefaultReader.prototype.read;
    ReadableStreamDefaultReader.prototype.read = async function <T>(this: ReadableStreamDefaultReader<T>) {
      if (Reflect.get(window, 'slow') === true) await new Promise((done) => setTimeout(done, 1000));
      return read.call(this) as ReturnType<ReadableStreamDefaultReader<T>['read']>;
    };
  });
  await open(page, storedLinks().find(({ what }) => what === 'a task')?.link);
  await page.evaluate(() => Reflect.set(window, 'slow', true));
  await page.getByRole('textbox', { name: 'Ваше имя' }).fill('Аня');
  await page.getByRole('button', { name: 'Копировать ссылку для сдачи' }).click();
  await expect(page.locator('#link-bar').getByText('Скопировано', { exact: true })).toBeVisible();
  await page.evaluate(() => Reflect.set(window, 'slow', false));
  const address = await clipboard(page);
  await openElsewhere(page, address);
  await expect(page.getByText('From: Аня')).toBeVisible();
});

test('a URL with an unknown example is reported, and the previous program or the first example is shown', async ({
  page,
}) => {
  await open(page, '#zz-nonexistent');
  await expect.poll(() => page.locator('#link-bar p').textContent()).toMatch(/^This address names no example/);
  expect(await value(page)).toContain('O0001');
  await type(page, OWN);
  await expect.poll(() => value(page)).toBe(OWN);
  await page.waitForTimeout(1000);
  await page.goto('about:blank');
  await open(page, '#zz-another');
  await expect.poll(() => page.locator('#link-bar p').textContent()).toMatch(/^This address names no example/);
  expect(await value(page)).toBe(OWN);
});

test('the solution of a task opens beside the program', async ({ page }) => {
  const stored = storedLinks().find(({ what }) => what === 'a task');
  await open(page, stored?.link);
  await expect.poll(() => value(page)).toBe(stored?.opens.text);
  await page.getByRole('button', { name: 'Показать решение' }).click();
  const beside = page.getByRole('link', { name: 'Открыть решение в новой вкладке' });
  await expect.poll(() => beside.getAttribute('href')).toContain('#share=1.');
  await openElsewhere(page, (await beside.getAttribute('href')) ?? '');
  expect(await state(page)).toMatchObject({ text: stored?.opens.task?.solution, setup: stored?.opens.setup });
  await expect(page.getByRole('button', { name: 'Показать решение' })).toHaveCount(0);
});

test('an element opens in the playground with all of its settings', async ({ page }) => {
  await openHtml(
    page,
    `<!doctype html><html lang="ru"><script type="module" src="../../element.js"></script><body>
    <gcode-playground view="picture" control="gsk" block-skip="1" program="2" step="2" setup='{"stock": {"diameter": 60, "length": 80}}'><pre>${OWN}</pre></gcode-playground>
    <gcode-playground view="picture" playground="">G00 X1</gcode-playground>
    <gcode-playground view="picture" playground="https://lathe.example/play/">G00 X1</gcode-playground>
    <gcode-playground view="picture" playground="javascript:alert(1)">G00 X1</gcode-playground>
    <gcode-playground view="picture" controls="none">G00 X1</gcode-playground></body></html>`,
  );
  for (let which = 0; which < 5; which++) await settled(page, which);
  const links = page.getByRole('link', { name: 'Открыть в песочнице' });
  await expect(links).toHaveCount(2);
  await links.nth(1).focus();
  await expect.poll(() => links.nth(1).getAttribute('href')).toMatch(/^https:\/\/lathe\.example\/play\/#/);
  await links.first().focus();
  await expect.poll(() => links.first().getAttribute('href')).toContain('#');
  const address = (await links.first().getAttribute('href')) ?? '';
  await page.goto('about:blank');
  await open(page, address.slice(address.indexOf('#')));
  expect(await state(page)).toMatchObject({
    text: OWN.slice(0, -1),
    control: 'gsk',
    blockSkip: '1',
    step: '2',
    language: 'ru',
    view: 'all',
    setup: '{"stock":{"diameter":60,"length":80},"program":2}',
  });
  // The page itself is the playground and has no such link.
  await expect(page.getByRole('link', { name: 'Открыть в песочнице' })).toHaveCount(0);
});

test(
  'random states survive sharing and opening: the same text, setup and picture',
  { tag: '@night' },
  async ({ page }, { project }) => {
    test.setTimeout(1_200_000);
    // PLAYGROUND_STATES sets the number of states.
    const count = Number(process.env['PLAYGROUND_STATES'] ?? (project.name === 'chromium' ? 120 : 30));
    const next = random(22);
    const states = Array.from({ length: count }, () => randomState(next));
    await open(page);
    const shared: { readonly address: string; readonly state: State; readonly picture: string }[] = [];
    for (const one of states) shared.push(await page.evaluate(shareOne, one as never));
    // In reverse order, so that each state replaces another one than when it was shared.
    for (const [at, { address, state, picture }] of [...shared.entries()].reverse()) {
      const opened = await page.evaluate(openOne, address);
      expect(opened.state, `${at}: ${address}`).toEqual({ ...state, text: state.text });
      expect(opened.picture, `${at}: ${address}`).toBe(picture);
    }
  },
);

/** Runs in the page: sets a state, and shares it with the dialog. */
async function shareOne(one: Shared): Promise<{ address: string; state: State; picture: string }> {
  const playground = document.querySelector('gcode-playground') as unknown as Playground;
  const { view, step, readonly, text, file, language, ...context } = one;
  const find = <E extends HTMLElement>(id: string): E => document.getElementById(id) as E;
  const names: Readonly<Record<string, string>> = { en: 'English', zh: '中文', ru: 'Русский' };
  const name = names[language ?? 'en'];
  [...document.querySelectorAll<HTMLElement>('[role=menuitemradio]')]
    .find((item) => item.textContent === name)
    ?.click();
  Object.assign(playground, {
    setup: context.setup,
    control: context.control,
    blockSkip: context.blockSkip,
    program: context.program,
  });
  playground.opened = { text, file: file ?? undefined };
  playground.step = null;
  await playground.settled;
  playground.step = step;
  await playground.settled;
  const toolAt = await playground.currentStep();
  find('action-share').click();
  while (!(find<HTMLDialogElement>('share-title')?.closest('dialog')?.open ?? false))
    await new Promise((done) => setTimeout(done, 1));
  const output = find<HTMLTextAreaElement>('share-output');
  const change = (id: string, set: (input: HTMLInputElement) => void): void => {
    set(find<HTMLInputElement>(id));
    find(id).dispatchEvent(new Event('input', { bubbles: true }));
  };
  while (toolAt !== null && find('share-step').closest('label')?.hidden !== false)
    await new Promise((done) => setTimeout(done, 1));
  output.value = '';
  change('share-view', (input) => (input.value = view ?? 'all'));
  change('share-readonly', (input) => (input.checked = readonly));
  change('share-step', (input) => (input.checked = toolAt !== null));
  await new Promise((done) => setTimeout(done, 5));
  while (output.value === '') await new Promise((done) => setTimeout(done, 1));
  let address = '';
  while (address !== output.value) {
    address = output.value;
    await new Promise((done) => setTimeout(done, 5));
  }
  output.closest('dialog')?.close();
  const picture = (await (await playground.pictureFile('svg'))?.text()) ?? '';
  const { opened, setup, control, blockSkip, program } = playground;
  return {
    address,
    picture,
    state: {
      text: opened.text,
      file: opened.file ?? null,
      setup,
      control,
      blockSkip,
      program,
      language: playground.language,
      view: view ?? 'all',
      step: toolAt,
      readonly,
    },
  };
}

/** Runs in the page: opens a link. */
async function openOne(address: string): Promise<{ state: State; picture: string }> {
  const playground = document.querySelector('gcode-playground') as unknown as Playground;
  const before = location.hash;
  playground.origin = 'waiting';
  const hash = address.slice(address.indexOf('#'));
  if (before !== hash) {
    const arrived = new Promise((done) => addEventListener('hashchange', done, { once: true }));
    location.hash = hash;
    await arrived;
  }
  // Decompression is asynchronous; the origin changes when the program has been replaced.
  while (playground.origin !== '#program') await new Promise((done) => setTimeout(done, 1));
  await playground.settled;
  const { opened, setup, control, blockSkip, program, language, view, readonly } = playground;
  const step = await playground.currentStep();
  const picture = (await (await playground.pictureFile('svg'))?.text()) ?? '';
  return {
    state: {
      text: opened.text,
      file: opened.file ?? null,
      setup,
      control,
      blockSkip,
      program,
      language,
      view,
      step,
      readonly,
    },
    picture,
  };
}
