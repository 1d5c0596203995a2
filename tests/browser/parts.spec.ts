// Parts of the interpreter that are loaded after the first picture: until they arrive, the page shows only correct
// content and reports what is loading; a part that fails to load is reported, and can be retried.
import { expect, type Route } from '@playwright/test';
import { chromiumTest as test, type ChromiumPage, nightUnless } from './engines';
import {
  choose,
  chooseLanguage,
  examples,
  motionCount,
  open,
  openFile,
  openFirstVisit,
  openProblems,
  settled,
  type,
} from './page';

const LATE_MS = 3_000;
const PROGRAM = 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nM30\n';
const PROGRAM_WITH_NOTE = `(STOCK D=60 LENGTH=80)\n${PROGRAM}`;
const LOADING = /^\d+ motions · \d+ lines · part and messages are loading …$/;

/** Intercepts requests for the file of a part or a language. */
async function route(page: ChromiumPage, part: string, answer: (route: Route) => Promise<void>): Promise<void> {
  await page.route(new RegExp(`/assets/${part}-[\\w-]{8}\\.(wasm|txt)$`), answer);
}

async function late(route: Route): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, LATE_MS));
  await route.continue();
}

interface Watched {
  /** Successive texts of the status line. */
  readonly statusTexts: string[];
  /** Number of problems in the panel at each of them. */
  readonly listed: number[];
  /** Texts of the button that says how many problems there are, while it is shown. */
  readonly counted: string[];
  /** Size of the canvas and a hash of its pixels, for each change. */
  readonly pictures: string[];
}

/** Records the page from its start until everything is loaded. */
async function watched(page: ChromiumPage): Promise<Watched> {
  await page.addInitScript(() => {
    const seen = {
      statusTexts: [] as string[],
      listed: [] as number[],
      counted: [] as string[],
      pictures: [] as string[],
    };
    Object.assign(window, { seen });
    const add = <T>(list: T[], value: T): void => {
      if (list.at(-1) !== value) list.push(value);
    };
    const look = (): void => {
      const root = document.querySelector('gcode-playground')?.shadowRoot;
      const statusText = root?.querySelector('[role=status]')?.textContent;
      if (root !== null && root !== undefined && statusText !== null && statusText !== undefined) {
        add(seen.statusTexts, statusText);
        const list = root.querySelector('[part=problems]');
        add(seen.listed, list === null || (list as HTMLElement).hidden ? 0 : list.querySelectorAll('li').length);
        const button = root.querySelector('button[aria-controls=problems]');
        if (button?.checkVisibility() === true) add(seen.counted, button.getAttribute('aria-label') ?? '');
        const canvas = root.querySelector('canvas');
        // Pixels cannot be read from the canvas itself, which only accepts images; they are read from a copy.
        if (canvas !== null && canvas !== undefined && canvas.width > 1) {
          const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
          context.drawImage(canvas, 0, 0);
          const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
          let sum = 0;
          for (let at = 0; at < data.length; at += 4)
            sum = (sum * 31 + data[at]! * 7 + data[at + 1]! * 3 + data[at + 2]!) % 1_000_003;
          add(seen.pictures, `${canvas.width}x${canvas.height} ${sum}`);
        }
      }
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await page.goto('./');
  await settled(page);
  return page.evaluate(() => (window as unknown as { seen: Watched }).seen);
}

test('without delays the page ends in the same state', async ({ page }) => {
  const { statusTexts } = await watched(page);
  expect(statusTexts.at(-1)).toMatch(/^\d+ motions · \d+ lines · no problems/);
});

for (const part of ['late', 'en']) {
  test(
    `${part} arrives three seconds late: the path is drawn, and no wrong state is shown`,
    nightUnless(part === 'late'),
    async ({ page }) => {
      const atOnce = await watched(page);
      await route(page, part, late);
      const { statusTexts, listed, counted, pictures } = await watched(page);
      // Loading, the path, then everything; sizes of the layout may change in between.
      expect(statusTexts.filter((line) => !line.startsWith('Part …'))).toEqual([
        'Loading …',
        expect.stringMatching(LOADING),
        atOnce.statusTexts.at(-1),
      ]);
      expect(listed).toEqual(atOnce.listed.at(-1) === 0 ? [0] : [0, atOnce.listed.at(-1)]);
      expect(counted).toEqual([atOnce.counted.at(-1)]);
      expect(pictures.at(-1)).toBeDefined();
      expect(pictures.at(-1)).toBe(atOnce.pictures.at(-1));
      // Nothing, the path, the path with its part, each only once: panels that arrive late only reduce the size of the
      // picture.
      const size = pictures.at(-1)?.split(' ')[0] ?? '';
      expect(pictures.filter((picture) => picture.startsWith(size)).length).toBeLessThanOrEqual(3);
    },
  );
}

for (const part of ['early', 'early-late']) {
  test(
    `${part} arrives three seconds late: nothing is drawn before it, then everything is correct`,
    nightUnless(part === 'early'),
    async ({ page }) => {
      const atOnce = await watched(page);
      await route(page, part, late);
      const { statusTexts, listed, counted, pictures } = await watched(page);
      expect(statusTexts.filter((line) => !line.startsWith('Part …') && !LOADING.test(line))).toEqual([
        'Loading …',
        atOnce.statusTexts.at(-1),
      ]);
      expect(listed).toEqual(atOnce.listed.at(-1) === 0 ? [0] : [0, atOnce.listed.at(-1)]);
      expect(counted).toEqual([atOnce.counted.at(-1)]);
      expect(pictures.at(-1)).toBe(atOnce.pictures.at(-1));
      // Nothing, the path, the path with its part.
      expect(pictures.length).toBeLessThanOrEqual(3);
    },
  );
}

test('the editor is loaded after the first picture', async ({ page }) => {
  await page.addInitScript(() => {
    const Own = window.Worker;
    window.Worker = class extends Own {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        this.addEventListener('message', ({ data }: MessageEvent<{ readonly event?: { readonly kind: string } }>) => {
          if (data.event?.kind === 'pictures' && Reflect.get(window, 'picture') === undefined)
            Reflect.set(window, 'picture', performance.now());
        });
      }
    };
  });
  await page.setViewportSize({ width: 1280, height: 800 });
  // Delay the part that reads the setup of the first program.
  await route(page, 'early', late);
  await open(page);
  const [picture, editor] = await page.evaluate(() => {
    const files = performance
      .getEntriesByType('resource')
      .filter(({ name }) => /\/assets\/index-[\w-]{8}\.js$/.test(name));
    // The later file; the other one is the page's own.
    return [Reflect.get(window, 'picture') as number, Math.max(...files.map(({ startTime }) => startTime))] as const;
  });
  expect(picture).toBeGreaterThan(LATE_MS);
  expect(editor).toBeGreaterThanOrEqual(picture);
});

test('a setup in a comment applies from the first picture', { tag: '@night' }, async ({ page }) => {
  await route(page, 'early', late);
  await page.goto(`./#${new URLSearchParams({ program: PROGRAM_WITH_NOTE, setup: '{}' })}`);
  await expect(page.getByRole('status')).toContainText('Loading …');
  await page.waitForTimeout(LATE_MS / 2);
  await expect(page.getByRole('status')).toContainText('Loading …');
  await expect(page.getByRole('status')).toContainText('2 motions');
  await settled(page);
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeHidden();
});

test('without a setup, the first picture does not wait for the setup part', async ({ page }) => {
  await route(page, 'early', late);
  await page.goto(`./#${new URLSearchParams({ program: PROGRAM, setup: '{}' })}`);
  await expect(page.getByRole('status')).toHaveText(LOADING);
  await settled(page);
  await expect(page.getByRole('status')).toHaveText(/^2 motions · 4 lines · 1 problem$/);
});

test('a setup part that fails to load is reported, nothing is drawn without it, and it can be retried', async ({
  page,
}) => {
  let broken = true;
  await route(page, 'early', (route) => (broken ? route.abort() : route.continue()));
  await page.goto('./');
  const notice = page.getByRole('alert').filter({ hasText: 'Not all of the playground could be loaded' });
  await expect(notice).toBeVisible();
  await expect(page.getByRole('status')).toHaveText('—');
  await settled(page);
  await type(page, PROGRAM_WITH_NOTE);
  await settled(page);
  await expect(notice).toBeVisible();
  await expect(page.getByRole('status')).toHaveText('—');
  broken = false;
  // Typing also triggers a retry: the button may already be gone.
  await page.evaluate(() => void dispatchEvent(new Event('online')));
  await expect(notice).toBeHidden();
  await expect(page.getByRole('status')).toContainText('2 motions');
});

test('a request made before its part is loaded is answered afterwards', { tag: '@night' }, async ({ page }) => {
  await route(page, 'late', late);
  await page.goto('./');
  await choose(page, 'help', 'Supported codes');
  await expect(page.getByRole('rowheader', { name: 'G71', exact: true })).toBeVisible();
});

test('a part that fails to load is reported, the rest works, and it can be retried', async ({ page }) => {
  let broken = true;
  await route(page, 'late', (route) => (broken ? route.abort() : route.continue()));
  await page.goto('./');
  const notice = page.getByRole('alert').filter({ hasText: 'Not all of the playground could be loaded' });
  await expect(notice).toBeVisible();
  await expect(page.getByRole('status')).toContainText('part and messages could not be loaded');
  // Editing still works, and each run retries.
  await type(page, 'G00 X50 Z2\nG01 X40 Z-20 F0.2\nG01 X');
  await expect(page.getByRole('status')).toContainText(/^2 motions/);
  await settled(page);
  await expect(notice).toBeVisible();
  broken = false;
  // Typing also triggers a retry: the button may already be gone.
  await page.evaluate(() => void dispatchEvent(new Event('online')));
  await expect(notice).toBeHidden();
  await expect(page.getByRole('status')).toContainText('problem');
  await openProblems(page);
  await expect(page.getByRole('region', { name: 'Problems' }).getByRole('listitem').first()).toBeVisible();
});

const ONLY_SOME_NEED = {
  'a program with macros': { program: 'G00 X50 Z2\n#1=40\nG01 X#1 Z-20 F0.2\nM30', statusText: '2 motions' },
  // The nose radius is set in the program, so that no setup is read.
  'a compensated program': {
    program: 'G10 P1 X0 Z0 R0.8 Q3\nT0101\nG00 X50 Z2\nG42 G00 X40 Z1\nG01 Z-20 F0.2\nX46\nG40 G00 X50 Z2\nM30',
    statusText: '5 motions',
  },
  'a program with a rounding': { program: 'G00 X40 Z2\nG01 Z-20 R2 F0.2\nX50\nM30', statusText: '4 motions' },
  'a misread program': { program: 'G00 X5O Z2\nG01 Z-20 F0.2\nM30', statusText: '2 motions' },
  'a program for another control': {
    program: 'G95 DIAMON\nT1 D1\nG0 X40 Z2\nG1 Z-20 F0.2\nM30',
    statusText: '0 motions',
  },
};

for (const [name, { program, statusText }] of Object.entries(ONLY_SOME_NEED)) {
  test(
    `${name} is drawn once the part that reads it is loaded, and not before`,
    nightUnless(name === 'a program with macros'),
    async ({ page }) => {
      await route(page, 'early', late);
      await page.goto(`./#${new URLSearchParams({ program, setup: '{}' })}`);
      await expect(page.getByRole('status')).toHaveText('Loading …');
      const canvas = page.locator('gcode-playground').locator('canvas').first();
      const before = await canvas.screenshot();
      await page.waitForTimeout(LATE_MS / 2);
      await expect(page.getByRole('status')).toHaveText('Loading …');
      expect((await canvas.screenshot()).equals(before)).toBe(true);
      await expect(page.getByRole('status')).toContainText(statusText);
      if (!statusText.startsWith('0'))
        await expect.poll(async () => (await canvas.screenshot()).equals(before)).toBe(false);
    },
  );
}

test('a module that fails to load is reported', async ({ page }) => {
  await page.route(/gcode_playground_bg-[\w-]+\.wasm$/, (route) => route.abort());
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('The interpreter could not be loaded');
});

test('a module that failed to load is loaded when the network is back', { tag: '@night' }, async ({ page }) => {
  let broken = true;
  await page.route(/gcode_playground_bg-[\w-]+\.wasm$/, (route) => (broken ? route.abort() : route.continue()));
  await page.goto('./');
  const notice = page.getByRole('alert').filter({ hasText: 'The interpreter could not be loaded' });
  await expect(notice).toBeVisible();
  await notice.getByRole('button', { name: 'Try again' }).click();
  await expect(notice).toBeVisible();
  broken = false;
  await page.context().setOffline(true);
  await page.context().setOffline(false);
  await expect(page.getByRole('status')).toContainText(/\d+ motions/);
  await expect(notice).toBeHidden();
});

test('panels and the editor that failed to load are loaded by a retry', async ({ page }) => {
  let broken = true;
  await page.route(/\/assets\/(further|editor)-[\w-]+\.js/, (route) => (broken ? route.abort() : route.continue()));
  await page.goto('./');
  const notice = page.getByRole('alert');
  await expect(notice).toContainText(/Part of the page could not be loaded|The editor could not be loaded/);
  broken = false;
  await page.context().setOffline(true);
  await page.context().setOffline(false);
  await expect(page.getByRole('button', { name: /^Setup/ })).toBeVisible();
  await expect(page.getByRole('textbox', { name: 'Program' })).toBeVisible();
  await expect(page.getByRole('status')).toContainText(/\d+ motions/);
  await expect(notice).toBeHidden();
});

test('a part that fails just after the network has returned is loaded again', async ({ page }) => {
  let isBroken = true;
  await page.route(/\/assets\/further-[\w-]+\.js/, (route) => (isBroken ? route.abort() : route.continue()));
  // Earlier requests for the editor fail after the network has returned, and so do requests in the next 500 ms.
  let fail = (): void => undefined;
  const failing = new Promise<void>((resolve) => (fail = resolve));
  let failsUntil = Number.POSITIVE_INFINITY;
  await page.route(/\/assets\/editor-[\w-]+\.js/, async (route) => {
    await failing;
    await (Date.now() < failsUntil ? route.abort() : route.continue());
  });
  await page.goto('./');
  const notice = page.getByRole('alert');
  await expect(notice).toContainText('Part of the page could not be loaded');
  isBroken = false;
  await page.context().setOffline(true);
  await page.context().setOffline(false);
  failsUntil = Date.now() + 500;
  fail();
  await expect(notice).toBeHidden();
  await expect(page.getByRole('button', { name: /^Setup/ })).toBeVisible();
  await expect(page.locator('.cm-content')).toBeVisible();
});

test('changing the language while the part is computed waits for the messages of that language', {
  tag: '@night',
}, async ({ page }) => {
  await route(page, 'ru', late);
  await open(page);
  // Thousands of small corners make the part slow to compute.
  const waves = Array.from(
    { length: 6_000 },
    (_, at) => `X${(30 + (at % 2) * 4 + (at % 7) / 10).toFixed(1)} Z${(-at / 100).toFixed(2)}`,
  );
  // It may finish before an assertion polls again.
  const begun = page.locator('gcode-playground').evaluate(
    (element) =>
      new Promise<void>((resolve) => {
        const status = element.shadowRoot!.querySelector('[role="status"]')!;
        const watch = new MutationObserver(() => status.textContent.startsWith('Part …') && resolve());
        watch.observe(status, { childList: true, characterData: true, subtree: true });
      }),
  );
  await openFile(
    page,
    'waves.nc',
    Buffer.from(`(STOCK D=60 LENGTH=80)\nG99 T0101\nG0 X62 Z2\nG1 F0.2\n${waves.join('\n')}\nM30\n`),
  );
  await begun;
  await chooseLanguage(page, 'ru');
  await expect(page.getByRole('status')).toHaveText(/^6.001 перемещение.* замечани[ея]$/, { timeout: 30_000 });
});

test('the list of examples is loaded when the gallery is opened, and a program when it is shown', async ({ page }) => {
  const asked: string[] = [];
  let shown = false;
  page.on('request', (request) => {
    const file = /examples\/.*/.exec(request.url())?.[0];
    if (file !== undefined) asked.push(`${file} ${shown ? 'after' : 'before'} the picture`);
  });
  await page.exposeFunction('pictureShown', () => {
    shown = true;
  });
  await page.addInitScript(() => {
    addEventListener('gcode-report', () => void Reflect.get(window, 'pictureShown')(), { once: true });
  });
  await openFirstVisit(page);
  await page.waitForTimeout(500);
  expect(asked).toEqual([]);
  await choose(page, 'program', 'Gallery…');
  const gallery = page.getByRole('dialog', { name: 'Gallery' });
  await expect(gallery.getByRole('listitem')).toHaveCount(examples.length);
  expect(asked).toEqual(['examples/en.json after the picture']);
  await gallery.getByRole('button').filter({ hasText: 'Rough turning to a contour: G71 and G70' }).click();
  await expect(page.getByRole('status')).toContainText(`${motionCount('s003-g71')} motions`);
  expect(asked.slice(1)).toEqual(['examples/s003-g71.json after the picture']);
});
