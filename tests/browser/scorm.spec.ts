// A SCORM package: a teacher saves one, a learning platform runs it, and learns the learner's score and completion.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { strFromU8, unzipSync } from 'fflate';
import { expect, test, type BasicPage } from './engines';
import { choose, open, type Playground } from './page';
import { serve } from './sites';

const ID = 'one-cycle';
const WWW = join(__dirname, '../../www');
const program = (name: string): string => readFileSync(join(__dirname, '../exercise', ID, `${name}.nc`), 'utf8');
const PLATFORM = readFileSync(join(WWW, 'node_modules/scorm-again/dist/scorm12.min.js'), 'utf8');

/** The run-time of the platform. */
interface Platform {
  readonly cmi: { suspend_data: string; readonly core: { lesson_status: string; readonly score: { raw: string } } };
}

/** What the platform keeps from one visit to the next. */
interface Saved {
  readonly status: string;
  readonly score: string;
  readonly program: string;
}

/** Opens the package in a page of the platform, with the data of an earlier visit. */
async function launch(page: BasicPage, origin: string, before?: Saved): Promise<void> {
  await page.goto(`${origin}/platform.html`);
  await page.evaluate((before) => {
    const { Scorm12API } = window as unknown as { Scorm12API: new (settings: object) => Platform };
    const api = new Scorm12API({ logLevel: 5 });
    if (before !== undefined) {
      api.cmi.core.lesson_status = before.status;
      api.cmi.core.score.raw = before.score;
      api.cmi.suspend_data = before.program;
    }
    const calls: string[] = [];
    for (const name of ['LMSSetValue', 'LMSFinish']) {
      const own = Reflect.get(api, name) as (...values: string[]) => string;
      Reflect.set(api, name, (...values: string[]) => {
        calls.push([name, ...values].join(' '));
        return own.apply(api, values);
      });
    }
    Object.assign(window, { API: api, calls });
    const frame = document.createElement('iframe');
    frame.src = '/package/index.html';
    frame.style.cssText = 'width: 1000px; height: 700px';
    document.body.append(frame);
  }, before);
  const isShown = (element: Playground): boolean =>
    /\S/.test(element.shadowRoot!.querySelector('.exercise-task')?.textContent ?? '');
  await expect.poll(() => inPackage(page, isShown)).toBe(true);
}

/** Calls a function with the element of the package. */
function inPackage<T>(page: BasicPage, act: (element: Playground) => T): Promise<T | undefined> {
  return page.evaluate((act) => {
    const element = document.querySelector('iframe')?.contentDocument?.querySelector('gcode-playground');
    if (element?.shadowRoot === undefined || element.shadowRoot === null) return undefined;
    return (new Function('element', `return (${act})(element)`) as (element: unknown) => T)(element);
  }, act.toString());
}

/** Checks a program as the learner does, and returns what the platform knows then. */
async function answer(page: BasicPage, text: string): Promise<Saved> {
  await page.evaluate((text) => {
    const element = document.querySelector('iframe')!.contentDocument!.querySelector('gcode-playground') as Playground;
    element.value = text;
  }, text);
  await inPackage(page, (element) => {
    element.shadowRoot!.querySelector('.exercise-report')!.replaceChildren();
    element.shadowRoot!.querySelector<HTMLButtonElement>('.exercise-buttons .primary')!.click();
  });
  await expect
    .poll(() => inPackage(page, (element) => element.shadowRoot!.querySelectorAll('.exercise-verdict').length))
    .toBe(1);
  return saved(page);
}

function saved(page: BasicPage): Promise<Saved> {
  return page.evaluate(() => {
    const { suspend_data, core } = (Reflect.get(window, 'API') as Platform).cmi;
    return { status: core.lesson_status, score: String(core.score.raw), program: suspend_data };
  });
}

test('a package tells the learning platform score and completion', { tag: '@night' }, async ({ page }) => {
  test.setTimeout(120_000);
  await open(page);
  await choose(page, 'program', 'Exercises…');
  await page.getByRole('button', { name: 'Answers of a class…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Answers of a class' });
  const link = dialog.getByRole('link', { name: 'SCORM package of the exercise' });
  await expect(link).toBeHidden();
  await dialog.getByRole('combobox').selectOption(ID);
  await expect(link).toBeVisible();
  const saving = page.waitForEvent('download');
  await link.click();
  const files = unzipSync(readFileSync(await (await saving).path()));
  expect(Object.keys(files).sort()).toEqual(['imsmanifest.xml', 'index.html']);
  const [manifest, html] = ['imsmanifest.xml', 'index.html'].map((name) => strFromU8(files[name]!)) as [string, string];
  expect(manifest).toContain('<schemaversion>1.2</schemaversion>');
  expect(manifest).toContain('adlcp:scormtype="sco" href="index.html"');
  const script = /src="([^"]+\/embed\/[\d.]+\/sco\.js)"/.exec(html)?.[1] ?? '';
  expect(script).not.toBe('');

  const site = await serve(join(WWW, 'dist/embed'), () => ({
    filesAt: '/embed/',
    pages: {
      '/platform.html': `<!doctype html><meta charset="utf-8"><script>${PLATFORM}</script><body>`,
      '/package/index.html': html.replace(script, '/embed/sco.js'),
    },
  }));
  try {
    await launch(page, site.origin);
    expect((await saved(page)).status).toBe('incomplete');
    const failed = await answer(page, 'G00 X100 Z100\nM30\n');
    expect(failed.status).toBe('incomplete');
    expect(Number(failed.score)).toBeLessThan(100);
    expect(failed.program).toContain('G00 X100 Z100');

    await launch(page, site.origin, failed);
    const text = await page.evaluate(
      () => (document.querySelector('iframe')!.contentDocument!.querySelector('gcode-playground') as Playground).value,
    );
    expect(text).toContain('G00 X100 Z100');
    const passed = await answer(page, program('reference'));
    expect([passed.status, passed.score]).toEqual(['passed', '100']);

    // A later attempt takes nothing away.
    const again = await answer(page, 'M30\n');
    expect([again.status, again.score]).toEqual(['passed', '100']);
    await page.evaluate(() => document.querySelector('iframe')!.remove());
    const calls = (): Promise<string[]> => page.evaluate(() => Reflect.get(window, 'calls') as string[]);
    await expect.poll(async () => (await calls()).at(-1)).toMatch(/^LMSFinish/);
    const ends = (await calls()).slice(-3).join('\n');
    expect(ends).toMatch(
      /LMSSetValue cmi\.core\.session_time \d{4}:\d{2}:\d{2}\nLMSSetValue cmi\.core\.exit suspend\n/,
    );
  } finally {
    await site.close();
  }
});
