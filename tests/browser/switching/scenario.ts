// Switching at random, and what the page shows then held against a fresh start of the same state: pixels,
// motions, messages, words.
//
// In: a page of any engine, of which it uses nothing but opening an address and evaluating a function. Out:
// an error that names the seed and the steps, and what differs. The pixels are read from the canvas of the
// page, so they are what is presented, not what the worker believes to have painted.

import { go, look, picture, prepare, ready, type Look } from './in-page';
import { pool, random, step, type State, type Step } from './state';

/** What the test needs of an engine. */
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
  /** How many states are gone through; each is started afresh once. */
  readonly states: number;
  /** Programs of the gallery. */
  readonly programs: readonly string[];
  /** Keeps a picture of a failure: its name and the PNG. */
  readonly keep: (name: string, png: Buffer) => void;
}

/** Most steps between two looks at the page. */
const MOST_AT_ONCE = 5;
/** Longest time between two steps, ms. Many are shorter than what a run takes. */
const LONGEST_DELAY = 160;

/** `PLAYGROUND_SWITCHING_STEPS`, `…_SEED` and `…_STATES`, or what the test takes without them. */
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

/** Another document each time. */
async function open(page: Page, program: string): Promise<void> {
  await page.goto(`./?opened=${++opened}#${program}`);
  await page.evaluate(ready);
}

/** What a fresh page shows in a state. */
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
      // At times as fast as can be, at times long enough for a run to end.
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

/** The first program, loaded again and again: the same picture each time, that of its finished part. */
export async function freshLoads(page: Page, loads: number, keep: Options['keep']): Promise<void> {
  await page.addInitScript(prepare);
  let first: Look | undefined;
  for (let load = 1; load <= loads; load++) {
    await open(page, '');
    const shown = await page.evaluate(look);
    // Painted anew from the same run by a turn of the turret there and back: it must be what was there.
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
    playground.shadowRoot?.querySelector<HTMLButtonElement>('.views > button.level')?.click();
    await playground.settled;
  }
}

/** What is shown and should not be; nothing where all is as it should be. */
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

/** The text from shortly before the first place where it is another. */
function excerpt(text = 'missing', other = 'missing'): string {
  let at = 0;
  while (at < text.length && text[at] === other[at]) at++;
  return JSON.stringify(text.slice(Math.max(0, at - 40), at + 120));
}

function fromUrl(url: string): Buffer {
  return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}
