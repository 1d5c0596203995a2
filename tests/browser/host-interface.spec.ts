// The interface of the element for the page around it: properties, methods and events.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test, type BasicPage } from './engines';
import { manual, openHtml, programOf } from './embedded';
import { copy, editor, openPace, settled } from './page';
import { serve } from './sites';

const LINES = ['O0001', 'T0101 M03 S800', 'G00 X52 Z2', 'G01 X40 F0.2', 'Z-20', 'X54', 'G00 X200 Z200', 'M30'];
const PROGRAM = LINES.join('\n');

interface Place {
  readonly share: number;
  readonly stroke: { readonly motion: number; readonly line: number; readonly atX: number; readonly atZ: number };
}

/** The element as a script of the page uses it. */
interface Host extends HTMLElement {
  value: string;
  opened: { readonly text: string; readonly file: undefined };
  control: string | null;
  setup: string | null;
  speed: string | number | null;
  cursorLine: number;
  readonly settled: Promise<number>;
  readonly diagnostics: readonly { readonly from: number; readonly to: number; readonly line: number }[];
  readonly summary: { readonly motions: number } | undefined;
  readonly playing: boolean;
  readonly readout: Place | undefined;
  goToLine(line: number): void;
  play(): void;
  pause(): void;
  seek(to: object | null): Promise<Place | undefined>;
}

/** An event with its detail. */
interface Fired<Detail> {
  readonly type: string;
  readonly detail: Detail;
}

/** Records all events of elements from the start. */
const RECORDER = `<script>
  window.fired = [];
  for (const name of ['change', 'cursor', 'report', 'error', 'play', 'pause', 'step', 'context'])
    document.addEventListener('gcode-' + name, ({ type, detail }) => fired.push({ type, detail: JSON.parse(JSON.stringify(detail)) }));
</script>`;

/** Opens a page with one element, and waits until it is shown. */
async function show(page: BasicPage, attributes: string, text = PROGRAM): Promise<void> {
  await openHtml(page, manual(`<gcode-playground ${attributes}><pre>\n${text}\n</pre></gcode-playground>`, RECORDER));
  await settled(page);
}

/** The recorded events of these types since the last call. */
async function fired<Detail>(page: BasicPage, ...types: readonly string[]): Promise<Fired<Detail>[]> {
  const all = await page.evaluate(() => (Reflect.get(window, 'fired') as Fired<unknown>[]).splice(0));
  return all.filter(({ type }) => types.includes(type)) as Fired<Detail>[];
}

function attributesOf(page: BasicPage): Promise<readonly (string | null)[]> {
  return page.locator('gcode-playground').evaluate((element) => [(element as Host).control, (element as Host).setup]);
}

test('diagnostics and summary belong to the current program, and are frozen', async ({ page }) => {
  await show(page, '');
  const found = await page.locator('gcode-playground').evaluate(async (element) => {
    const host = element as Host;
    const before = { motions: host.summary?.motions, count: host.diagnostics.length };
    host.opened = { text: 'O0001\r\nT0101 M03 S800\r\nG00 X52 Z2\r\nG999\r\nM30\r\n', file: undefined };
    const meanwhile = { summary: host.summary, count: host.diagnostics.length };
    await host.settled;
    const { diagnostics, summary } = host;
    const isFrozen = [diagnostics, summary, ...diagnostics].every((value) => Object.isFrozen(value));
    const words = diagnostics.map(({ from, to }) => host.opened.text.slice(from, to));
    return { before, meanwhile, isFrozen, words, lines: diagnostics.map(({ line }) => line), summary };
  });
  expect(found.before).toEqual({ motions: 5, count: 0 });
  expect(found.meanwhile).toEqual({ summary: undefined, count: 0 });
  expect(found.isFrozen).toBe(true);
  expect(found.words).toContain('G999');
  expect(found.lines).toContain(4);
  expect(found.summary?.motions).toBe(1);
  const reports = await fired<{ complete: boolean; summary: { motions: number } }>(page, 'gcode-report');
  expect(reports.at(-1)?.detail).toMatchObject({ complete: true, summary: { motions: 1 } });
});

for (const view of ['all', 'playback', 'picture']) {
  test(`seek moves the tool to a motion, a line or a share: view="${view}"`, async ({ page }) => {
    await show(page, `view="${view}"`);
    const seek = (to: object | null): Promise<Place | null> =>
      page.locator('gcode-playground').evaluate(async (element, to) => {
        const place = await (element as Host).seek(to);
        if (JSON.stringify(place) !== JSON.stringify((element as Host).readout)) throw new Error('another readout');
        return place ?? null;
      }, to);
    await fired(page);
    expect(await seek({ motion: 2 })).toMatchObject({ stroke: { motion: 1, line: 4, atX: 40, atZ: 2 } });
    // The same position again is no step.
    await seek({ motion: 2 });
    expect(await seek({ line: 5 })).toMatchObject({ stroke: { line: 5, atX: 40, atZ: 2 } });
    expect(await seek({ motion: 3 })).toMatchObject({ stroke: { motion: 2, line: 5, atX: 40, atZ: -20 } });
    expect(await seek({ share: 1 })).toMatchObject({ share: 1, stroke: { motion: 4, atX: 200, atZ: 200 } });
    expect(await seek({ motion: 0 })).toMatchObject({ share: 0, stroke: { motion: 0 } });
    expect(await seek({ motion: 99 })).toBe(null);
    expect(await seek(null)).toBe(null);
    const steps = await fired<{ readout?: Place }>(page, 'gcode-step');
    expect(steps.map(({ detail }) => detail.readout?.stroke.motion)).toEqual([1, 2, 2, 4, 0, undefined]);
    const refused = await page
      .locator('gcode-playground')
      .evaluate((element) =>
        Promise.all(
          [{ share: 2 }, { motion: -1 }, { line: 0 }, { line: Number.NaN }].map((to) =>
            (element as Host).seek(to).then(String, (reason: unknown) => (reason as Error).name),
          ),
        ),
      );
    expect(refused).toEqual(['RangeError', 'RangeError', 'RangeError', 'RangeError']);
  });
}

test('seek waits for the program that was just set', async ({ page }) => {
  await show(page, 'view="playback"');
  const line = await page.locator('gcode-playground').evaluate(async (element) => {
    (element as Host).value = 'T0101 M03 S800\nG00 X60 Z5\nG01 X30 F0.1\nM30\n';
    return (await (element as Host).seek({ motion: 2 }))?.stroke.line;
  });
  expect(line).toBe(3);
});

test('view="code" offers no seek', async ({ page }) => {
  await show(page, 'view="code"');
  const refused = await page.locator('gcode-playground').evaluate((element) =>
    (element as Host).seek({ motion: 1 }).then(
      () => 'moved',
      (reason: unknown) => String(reason),
    ),
  );
  expect(refused).toContain('view="code" does not offer seek');
});

test('the playback reports its beginning, each motion and its end', async ({ page }) => {
  await show(page, 'view="playback" speed="1 s"');
  await fired(page);
  const playing = (): Promise<boolean> =>
    page.locator('gcode-playground').evaluate((element) => (element as Host).playing);
  expect(await playing()).toBe(false);
  await page.locator('gcode-playground').evaluate((element) => (element as Host).play());
  await expect.poll(playing).toBe(true);
  await expect.poll(playing).toBe(false);
  const events = await fired<{ readout?: Place }>(page, 'gcode-play', 'gcode-pause', 'gcode-step');
  const [first, last] = [events[0], events.at(-1)];
  expect(first).toMatchObject({ type: 'gcode-play' });
  expect(last).toMatchObject({ type: 'gcode-pause', detail: { readout: { share: 1, stroke: { motion: 4 } } } });
  const motions = events.slice(1, -1).map(({ detail }) => detail.readout?.stroke.motion ?? -1);
  expect(motions).toEqual([...new Set(motions)].sort((a, b) => a - b));
  expect(motions.length).toBeGreaterThan(1);
});

test('the reader and pause() end the playback with an event', async ({ page }) => {
  await show(page, 'view="playback" speed="60 s"');
  for (const how of ['reader', 'method'] as const) {
    await page.locator('gcode-playground').evaluate((element) => (element as Host).play());
    await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
    if (how === 'reader') await page.getByRole('button', { name: 'Pause' }).click();
    else await page.locator('gcode-playground').evaluate((element) => (element as Host).pause());
    await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
    const events = await fired(page, 'gcode-play', 'gcode-pause');
    expect(events.map(({ type }) => type)).toEqual(['gcode-play', 'gcode-pause']);
  }
});

test('speed sets the playback speed, and follows the choice of the reader', async ({ page }) => {
  await show(page, 'view="playback" speed="5"');
  const button = page.getByRole('button', { name: /^Speed and steps: / });
  await expect(button).toHaveText('5×');
  for (const [speed, text] of [
    [3, '3×'],
    ['60 s', 'all in 60 s'],
    ['90 s', 'all in 90 s'],
    ['fast', 'all in 20 s'],
    [null, 'all in 20 s'],
  ] as const) {
    await page.locator('gcode-playground').evaluate((element, speed) => void ((element as Host).speed = speed), speed);
    await expect(button).toHaveText(text);
  }
  await openPace(page);
  await page.getByRole('combobox', { name: 'Speed' }).selectOption('10×');
  await expect(page.locator('gcode-playground')).toHaveAttribute('speed', '10');
});

test('gcode-cursor has line, column and the offset into the original text', async ({ page }) => {
  await show(page, '');
  await page.locator('gcode-playground').evaluate(async (element, text) => {
    (element as Host).opened = { text, file: undefined };
    await (element as Host).settled;
  }, LINES.join('\r\n'));
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let line = 1; line < 4; line++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
  const moves = await fired(page, 'gcode-cursor');
  // Lines of 5, 14 and 10 letters and their CRLF, then 12 letters.
  expect(moves.at(-1)?.detail).toEqual({ line: 4, column: 13, offset: 47 });
  await page.keyboard.type('1');
  expect((await fired(page, 'gcode-cursor')).at(-1)?.detail).toEqual({ line: 4, column: 14, offset: 48 });
  await page.locator('gcode-playground').evaluate((element) => (element as Host).goToLine(2));
  expect(await fired(page, 'gcode-cursor')).toEqual([]);
  expect(await page.locator('gcode-playground').evaluate((element) => (element as Host).cursorLine)).toBe(2);
});

test('assigning the current value changes nothing', async ({ page }) => {
  await show(page, '');
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
  await page.locator('gcode-playground').evaluate((element) => (element as Host).settled);
  await fired(page);
  const isSame = await page.locator('gcode-playground').evaluate(async (element) => {
    const host = element as Host;
    const settledBefore = await host.settled;
    const before = host.value;
    // biome-ignore lint/correctness/noSelfAssign: the subject of the test.
    host.value = host.value;
    // biome-ignore lint/correctness/noSelfAssign: the subject of the test.
    host.setup = host.setup;
    await new Promise((resolve) => setTimeout(resolve, 300));
    return host.value === before && (await host.settled) === settledBefore;
  });
  expect(isSame).toBe(true);
  expect(await fired(page, 'gcode-change', 'gcode-report', 'gcode-cursor', 'gcode-context')).toEqual([]);
  // The cursor is where it was, and nothing can be undone.
  await page.keyboard.type('1');
  expect((await fired(page, 'gcode-cursor')).at(-1)?.detail).toMatchObject({ line: 2, column: 16 });
  await page.keyboard.press('Control+z');
  await expect.poll(() => programOf(page)).toBe(PROGRAM);
  await page.keyboard.press('Control+z');
  expect(await programOf(page)).toBe(PROGRAM);
});

const SETUP = '{"stock":{"diameter":60,"length":80}}';

test('declared attributes stay while the reader types, and end when another program is pasted', async ({ page }) => {
  await show(page, `control="gsk" setup='${SETUP}'`);
  await editor(page).focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await page.keyboard.press('Enter');
  await page.keyboard.type('G00 X30');
  expect(await attributesOf(page)).toEqual(['gsk', SETUP]);
  await page.keyboard.press('Control+a');
  await page.keyboard.type('G01 Z5');
  expect(await attributesOf(page)).toEqual(['gsk', SETUP]);
  expect(await fired(page, 'gcode-context')).toEqual([]);
  // Cut and pasted again, it is the same program.
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await copy(page, 'G01 Z5');
  await editor(page).focus();
  await page.keyboard.press('Control+v');
  await expect.poll(() => programOf(page)).toBe('G01 Z5');
  expect(await attributesOf(page)).toEqual(['gsk', SETUP]);
  await copy(page, PROGRAM);
  await editor(page).focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Control+v');
  await expect.poll(() => attributesOf(page)).toEqual([null, null]);
  expect(await fired(page, 'gcode-context')).toHaveLength(1);
  await page.keyboard.press('Control+z');
  await expect.poll(() => attributesOf(page)).toEqual(['gsk', SETUP]);
});

test('a program that is pasted after everything was deleted is another one', async ({ page }) => {
  await show(page, `control="gsk" setup='${SETUP}'`);
  await editor(page).focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await page.keyboard.press('Enter');
  expect(await attributesOf(page)).toEqual(['gsk', SETUP]);
  await copy(page, 'O7777\nG97 S500\nG28 U0\nM30\n');
  await editor(page).focus();
  await page.keyboard.press('Control+v');
  await expect.poll(() => attributesOf(page)).toEqual([null, null]);
});

test('settled is resolved in a page without frames, as a hidden one is', async ({ page }) => {
  await page.addInitScript(() => {
    window.requestAnimationFrame = () => 0;
  });
  await show(page, 'height="auto"');
  const run = await page.locator('gcode-playground').evaluate((element) => (element as Host).settled);
  expect(run).toBeGreaterThan(0);
});

test('gcode-error reports once that a setup was not accepted', async ({ page }) => {
  await show(page, `view="picture" setup='{"stok": 1}'`);
  const [error, ...others] = await fired<{ kind: string; reason: string; message: string }>(page, 'gcode-error');
  expect(others).toEqual([]);
  expect(error?.detail.kind).toBe('setup');
  expect(error?.detail.reason).toContain('stok');
  expect(error?.detail.message).toContain(`The setup was not accepted: ${error?.detail.reason}`);
  await page.locator('gcode-playground').evaluate(async (element) => {
    (element as Host).value += '\n';
    await (element as Host).settled;
  });
  expect(await fired(page, 'gcode-error')).toEqual([]);
  await page.locator('gcode-playground').evaluate(async (element) => {
    (element as Host).setup = '{';
    await (element as Host).settled;
  });
  expect(await fired(page, 'gcode-error')).toMatchObject([{ detail: { kind: 'setup' } }]);
});

const FILES = join(__dirname, '..', '..', 'www', 'dist', 'embed');

for (const [what, missing, attributes, error] of [
  ['the program of src', /^none$/, 'src="/missing.nc"', { kind: 'source', reason: '404', message: '/missing.nc' }],
  ['the worker', /^worker\.js$/, '', { kind: 'interpreter', reason: '', message: 'could not be' }],
  ['the panels', /^with-playback\.js$/, '', { kind: 'panels', reason: '', message: 'could not be loaded' }],
] as const) {
  test(`gcode-error reports that a file cannot be loaded: ${what}`, async ({ page }) => {
    const element = `<gcode-playground view="playback" ${attributes}>G00 X1</gcode-playground>`;
    const site = await serve(FILES, () => ({
      filesAt: '/embed/',
      missing,
      pages: {
        '/index.html': `<!doctype html><title>A manual</title>${RECORDER}${element}<script type="module" src="/embed/element.js"></script>`,
      },
    }));
    try {
      await page.goto(`${site.origin}/index.html`);
      const errors: Fired<Record<'kind' | 'reason' | 'message', string>>[] = [];
      await expect
        .poll(async () => {
          errors.push(...(await fired<Record<'kind' | 'reason' | 'message', string>>(page, 'gcode-error')));
          return errors.map(({ detail }) => detail.kind);
        })
        .toContain(error.kind);
      const found = errors.find(({ detail }) => detail.kind === error.kind)?.detail;
      expect(found?.reason).toContain(error.reason);
      expect(found?.message).toContain(error.message);
    } finally {
      await site.close();
    }
  });
}

/** The block of the reference that begins with this text. */
function snippet(start: string): string {
  const reference = readFileSync(join(__dirname, '..', '..', 'www', 'docs', 'element.md'), 'utf8');
  const blocks = reference.match(/(?<=\n\n) {4}<.*\n(?:\n* {4}.*\n)*/g) ?? [];
  const found = blocks.map((block) => block.replace(/^ {4}/gm, '')).find((block) => block.startsWith(start));
  if (found === undefined) throw new Error(`the reference has no block ${start}`);
  return found;
}

test('the script of the reference shows where the tool is', async ({ page }) => {
  await openHtml(page, manual(snippet('<gcode-playground view="playback" speed="5"')));
  await expect(page.getByText('Line 4: the tool is at X40 Z2')).toBeVisible();
});
