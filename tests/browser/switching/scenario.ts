// Switches states at random, and compares the page with a fresh page in the same state: pixels, motions, messages,
// texts.
//
// In: a page of any engine, of which only navigation and evaluation of functions are used. Out: an error with the seed,
// the steps and the differences. Pixels are read from the canvas of the page, so they are what is presented, not what
// the worker has painted.

import { go, look, picture, prepare, ready, type Look } from './in-page';
import { pool, random, step, type State, type Step } from './state';

/** The engine interface of the test. */
export interface Page {
  goto(address: string): Promise<unknown>;
  /** Runs in every document before its own scripts. */
  addInitScript(act: () => void): Promise<unknown>;
  evaluate<R, A>(act: (argument: A) => R | Promise<R>, argument: A): Promise<R>;
  evaluate<R>(act: () => R | Promise<R>): Promise<R>;
}

export interface Options {
  readonly seed: number;
  readonly steps: number;
  /** Number of states; each is loaded fresh once. */
  readonly states: number;
  /** Programs of the gallery. */
  readonly programs: readonly string[];
  /** Stores a picture of a failure: its name and the PNG. */
  readonly keep: (name: string, png: Buffer) => void;
}

/** Most steps between two comparisons. */
const MOST_AT_ONCE = 5;
/** Longest delay between two steps, ms. Many delays are shorter than a run. */
const LONGEST_DELAY = 160;

/** `PLAYGROUND_SWITCHING_STEPS`, `…_SEED` and `…_STATES`, with defaults. */
export function fromEnvironment(usual: {
  readonly seed: number;
  readonly steps: number;
  readonly states: number;
}): typeof usual {
  const number = (name: keyof typeof usual): number =>
    Number(process.env[`PLAYGROUND_SWITCHING_${name.toUpperCase()}`] ?? usual[name]);
  return { seed: number('seed'), steps: number('steps'), states: number('states') };
}

let opened = 0;

/** Opens a new document each time. */
async function open(page: Page, program: string): Promise<void> {
  await page.goto(`./?opened=${++opened}#${program}`);
  await page.evaluate(ready);
}

/** Visible state of a fresh page. */
async function fresh(page: Page, state: State): Promise<Look> {
  await open(page, state.program);
  await page.evaluate(go, { steps: [{ to: state, delay: 0 }], from: undefined });
  return page.evaluate(look);
}

export async function switching(page: Page, { seed, steps, states, programs, keep }: Options): Promise<void> {
  await page.addInitScript(prepare);
  const next = random(seed);
  const all = pool(programs, states, next);
  const expected = new Map<State, { readonly look: Look; readonly png: string }>();
  for (const state of all) expected.set(state, { look: await fresh(page, state), png: await page.evaluate(picture) });

  const first = all[0] as State;
  await open(page, first.program);
  await page.evaluate(go, { steps: [{ to: first, delay: 0 }], from: undefined });
  let now = first;
  for (let done = 0; done < steps; ) {
    const some: (Step & { delay: number })[] = [];
    const from = now;
    const count = Math.min(1 + Math.floor(next() * MOST_AT_ONCE), steps - done);
    while (some.length < count) {
      const one = step(all, next);
      // Some steps follow immediately, others after a delay long enough for a run to end.
      some.push({ ...one, delay: next() < 0.4 ? 0 : Math.floor(next() * LONGEST_DELAY) });
      if ('to' in one) now = one.to;
    }
    done += count;
    await page.evaluate(go, { steps: some, from });
    const shown = await page.evaluate(look);
    const wanted = expected.get(now);
    const wrong = wanted === undefined ? 'a state of which nothing is known' : difference(shown, wanted.look);
    if (wrong === undefined) continue;
    keep('switched', fromUrl(await page.evaluate(picture)));
    if (wanted !== undefined) keep('fresh', fromUrl(wanted.png));
    const way = some
      .map((one) => `  after ${one.delay} ms more: ${JSON.stringify('to' in one ? one.to : one.detour)}`)
      .join('\n');
    throw new Error(
      `seed ${seed}, after ${done} steps: ${wrong}\nThe last steps, from ${JSON.stringify(from)}:\n${way}`,
    );
  }
}

/** Loads the first program repeatedly: each time the same picture, with the finished part. */
export async function freshLoads(page: Page, loads: number, keep: Options['keep']): Promise<void> {
  await page.addInitScript(prepare);
  let first: Look | undefined;
  for (let load = 1; load <= loads; load++) {
    await open(page, '');
    const shown = await page.evaluate(look);
    // Turning the turret there and back repaints the same run: the picture must be equal.
    await page.evaluate(turnThereAndBack);
    const again = await page.evaluate(look);
    const wrong = difference(shown, first ?? shown) ?? difference(shown, again);
    first ??= shown;
    if (wrong === undefined) continue;
    keep(`load-${load}`, fromUrl(await page.evaluate(picture)));
    throw new Error(`load ${load} of ${loads}: ${wrong}`);
  }
}

async function turnThereAndBack(): Promise<void> {
  const playground = document.querySelector('gcode-playground') as HTMLElement & { readonly settled: Promise<number> };
  for (let turn = 0; turn < 2; turn++) {
    playground.shadowRoot?.querySelector<HTMLButtonElement>('[role=menuitemcheckbox]')?.click();
    await playground.settled;
  }
}

/** Differences between the visible and the expected state; undefined if there are none. */
function difference(shown: Look, wanted: Look): string | undefined {
  const keys = new Set([...Object.keys(shown), ...Object.keys(wanted)]);
  const wrong = [...keys].filter((key) => shown[key] !== wanted[key]);
  if (wrong.length === 0) return undefined;
  return wrong
    .map(
      (key) =>
        `${key} is\n    ${excerpt(shown[key], wanted[key])}\n  but fresh\n    ${excerpt(wanted[key], shown[key])}`,
    )
    .join('\n  ');
}

/** Excerpt of the text, from shortly before the first difference. */
function excerpt(text = 'missing', other = 'missing'): string {
  let at = 0;
  while (at < text.length && text[at] === other[at]) at++;
  return JSON.stringify(text.slice(Math.max(0, at - 40), at + 120));
}

function fromUrl(url: string): Buffer {
  return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}
