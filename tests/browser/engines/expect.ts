// `expect` for every engine: Playwright's assertions on locators, for the elements of other engines. Each matcher
// retries until it passes or times out; its message contains the last value seen.
import { expect as playwrights } from '@playwright/test';
import { setTimeout as pause } from 'node:timers/promises';
import type { Question } from './finder';
import { ForeignLocator, ForeignPage } from './foreign';
import type { BasicPage, Locator, Text } from './interface';

/** Timeout of a matcher, ms; same as `expect.timeout` in playwright.config.ts. */
const TIMEOUT = 20_000;
const PAUSE = 60;

interface Patience {
  timeout?: number;
}

export interface Matchers {
  readonly not: Matchers;
  toHaveText(text: Text | readonly Text[], options?: Patience): Promise<void>;
  toContainText(text: Text, options?: Patience): Promise<void>;
  toHaveValue(value: Text, options?: Patience): Promise<void>;
  toHaveAttribute(name: string, value: Text, options?: Patience): Promise<void>;
  toHaveJSProperty(name: string, value: unknown, options?: Patience): Promise<void>;
  toHaveCount(count: number, options?: Patience): Promise<void>;
  toBeVisible(options?: Patience): Promise<void>;
  toBeHidden(options?: Patience): Promise<void>;
  toBeFocused(options?: Patience): Promise<void>;
  toBeChecked(options?: Patience): Promise<void>;
  toBeEnabled(options?: Patience): Promise<void>;
  toBeDisabled(options?: Patience): Promise<void>;
  toBeInViewport(options?: Patience): Promise<void>;
}

interface PageMatchers {
  toHaveURL(url: RegExp, options?: Patience): Promise<void>;
}

type Playwrights = typeof playwrights;

interface Expect {
  (actual: Locator): Matchers;
  (actual: BasicPage): PageMatchers;
  <T>(actual: T, message?: string): ReturnType<typeof playwrights<T>>;
  soft: Playwrights['soft'];
  poll: typeof poll;
}

/** Playwright's `poll` repeats after 100, 250, 500 and 1000 ms; most values change sooner. */
function poll<T>(ask: () => T | Promise<T>, options: Parameters<Playwrights['poll']>[1] = {}) {
  return playwrights.poll<T>(ask, {
    intervals: [50, 50, 100, 200],
    ...(typeof options === 'string' ? { message: options } : options),
  });
}

export const expect: Expect = Object.assign(
  (actual: unknown, message?: string): never => {
    if (actual instanceof ForeignLocator) return matchers(actual, true) as never;
    if (actual instanceof ForeignPage) return pageMatchers(actual) as never;
    return playwrights(actual, message) as never;
  },
  { soft: playwrights.soft, poll },
);

const folded = (text: string): string =>
  text
    .replace(/\u200b/g, '')
    .replace(/\s+/g, ' ')
    .trim();

function is(actual: unknown, wanted: Text): boolean {
  if (typeof actual !== 'string') return false;
  return wanted instanceof RegExp ? wanted.test(actual) : folded(actual) === folded(wanted);
}

/** Polls until the values are as expected. */
async function until<T>(
  page: ForeignPage,
  what: string,
  patience: Patience,
  look: () => Promise<T>,
  good: (seen: T) => boolean,
): Promise<void> {
  const end = Date.now() + (patience.timeout ?? TIMEOUT);
  for (;;) {
    const seen = await look();
    if (good(seen)) return;
    if (Date.now() > end) throw new Error(`${what}; it was ${JSON.stringify(seen)}; ${await page.condition()}`);
    await pause(PAUSE);
  }
}

function matchers(of: ForeignLocator, wantsIt: boolean): Matchers {
  /**
   * A matcher for one element. `none` is the result if there is no element; without it, neither the matcher nor its
   * negation passes then.
   */
  const one = (
    name: string,
    question: Question,
    good: (answer: unknown) => boolean,
    patience: Patience = {},
    none?: boolean,
  ): Promise<void> =>
    until(
      of.owner,
      `${of}: ${wantsIt ? '' : 'not '}${name}`,
      patience,
      () => of.ask(question),
      (seen) => (seen.length === 1 ? good(seen[0]) === wantsIt : seen.length === 0 && none === wantsIt),
    );
  return {
    get not() {
      return matchers(of, !wantsIt);
    },
    toHaveText: (text, patience) =>
      Array.isArray(text)
        ? until(
            of.owner,
            `${of}: toHaveText ${JSON.stringify(text)}`,
            patience ?? {},
            () => of.ask('text'),
            (seen) =>
              (seen.length === text.length && seen.every((each, i) => is(each, (text as Text[])[i]!))) === wantsIt,
          )
        : one(`toHaveText ${String(text)}`, 'text', (seen) => is(seen, text as Text), patience),
    toContainText: (text, patience) =>
      one(
        `toContainText ${String(text)}`,
        'text',
        (seen) => (text instanceof RegExp ? is(seen, text) : folded(seen as string).includes(folded(text))),
        patience,
      ),
    toHaveValue: (value, patience) =>
      one(
        `toHaveValue ${String(value)}`,
        'value',
        (seen) => (value instanceof RegExp ? is(seen, value) : seen === value),
        patience,
      ),
    toHaveAttribute: (name, value, patience) =>
      one(
        `toHaveAttribute ${name} ${String(value)}`,
        { attribute: name },
        (seen) => (value instanceof RegExp ? is(seen, value) : seen === value),
        patience,
      ),
    toHaveJSProperty: (name, value, patience) =>
      one(`toHaveJSProperty ${name} ${String(value)}`, { property: name }, (seen) => seen === value, patience),
    toHaveCount: (count, patience) =>
      // Texts of the elements, for the error message.
      until(
        of.owner,
        `${of}: toHaveCount ${count}`,
        patience ?? {},
        () => of.ask('text'),
        (seen) => (seen.length === count) === wantsIt,
      ),
    toBeVisible: (patience) => one('toBeVisible', 'visible', (seen) => seen === true, patience, false),
    toBeHidden: (patience) => one('toBeHidden', 'visible', (seen) => seen === false, patience, true),
    toBeFocused: (patience) => one('toBeFocused', 'focused', (seen) => seen === true, patience),
    toBeChecked: (patience) => one('toBeChecked', 'checked', (seen) => seen === true, patience),
    toBeEnabled: (patience) => one('toBeEnabled', 'enabled', (seen) => seen === true, patience),
    toBeDisabled: (patience) => one('toBeDisabled', 'enabled', (seen) => seen === false, patience),
    toBeInViewport: (patience) => one('toBeInViewport', 'inViewport', (seen) => seen === true, patience, false),
  };
}

function pageMatchers(of: ForeignPage): PageMatchers {
  return {
    toHaveURL: (url, patience) =>
      until(
        of,
        `the address: toHaveURL ${url}`,
        patience ?? {},
        () => of.look(),
        (seen) => url.test(seen),
      ),
  };
}
