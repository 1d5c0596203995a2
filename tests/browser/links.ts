// Stored links, and random page states to make links of.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Shared } from '../../www/src/files/shared-link';

export interface StoredLink {
  readonly what: string;
  readonly version: number;
  /** Starts with `#`. */
  readonly link: string;
  /** Values that are not listed are unset. */
  readonly opens: Partial<Shared>;
}

/** Links are never removed from the list or changed: they have been published. */
export function storedLinks(): readonly StoredLink[] {
  return JSON.parse(readFileSync(join(__dirname, '..', 'links.json'), 'utf8')) as readonly StoredLink[];
}

export type Random = () => number;

/** Seeded random numbers from 0 to 1. */
export function random(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

export function pick<T>(next: Random, from: readonly T[]): T {
  return from[Math.floor(next() * from.length)] as T;
}

const RANGES = [
  [32, 126],
  [32, 126],
  [32, 126],
  [1, 31],
  [0x410, 0x44f],
  [0x4e00, 0x9fff],
  [0x1f300, 0x1faff],
  [0xd800, 0xdfff],
  [0xa0, 0x2fff],
] as const;

/** Random Unicode text, including lone surrogates and all kinds of line ends. */
export function randomText(next: Random, length: number): string {
  let text = '';
  while (text.length < length) {
    const [first, last] = pick(next, RANGES);
    text +=
      next() < 0.1
        ? pick(next, ['\n', '\r\n', '\r', '\n\n', '\t', '\0', '\u2028'])
        : String.fromCodePoint(first + Math.floor(next() * (last - first + 1)));
  }
  return text;
}

/** A plain-text URL cannot contain a lone surrogate. */
export function wellFormed(text: string): string {
  return Buffer.from(text, 'utf8').toString('utf8');
}

/** A random state, which need not make sense. */
export function randomShared(next: Random): Shared {
  const maybe = <T>(make: () => T): T | null => (next() < 0.5 ? null : make());
  const any = (most: number): string => randomText(next, Math.floor(next() ** 2 * most));
  const task = maybe(() => ({ sentence: any(100), solution: maybe(() => any(2000)) }));
  const isAnswer = next() < 0.5;
  const isOfExercise = task === null && next() < 0.5;
  const hex = (): string => Math.floor(next() * 16).toString(16);
  return {
    text: any(2000),
    setup: maybe(() => any(300)),
    control: maybe(() => any(20)),
    blockSkip: maybe(() => any(10)),
    program: maybe(() => any(10)),
    language: maybe(() => any(5)),
    view: maybe(() => any(10)),
    step: maybe(() => any(10)),
    readonly: next() < 0.5,
    file: maybe(() => ({ name: any(40), encoding: any(12) })),
    task: isAnswer ? null : task,
    answerTo: isAnswer ? task : null,
    exercise: isOfExercise
      ? {
          id: `e-${Math.floor(next() * 1000)}`,
          version: Array.from({ length: 16 }, hex).join(''),
          hints: Math.floor(next() * 4),
        }
      : null,
    exerciseText: task === null && next() < 0.5 ? `---\n${any(500)}` : null,
    name: maybe(() => any(80)),
  };
}

/** A program that runs and is drawn, with its own setup. */
export function randomState(next: Random): Shared {
  const number = (low: number, high: number): string => String(Math.round((low + next() * (high - low)) * 10) / 10);
  const blocks = Array.from({ length: Math.floor(next() * 12) }, () =>
    pick(next, [
      () => `G01 X${number(10, 60)} Z-${number(0, 40)} F0.2`,
      () => `G00 X${number(60, 90)} Z${number(1, 20)}`,
      () => `G90 X${number(20, 50)} Z-${number(5, 30)} F0.2`,
      () => `/G01 Z-${number(1, 30)}`,
      () => `/2 G00 X${number(60, 80)}`,
      () => `(${wellFormed(randomText(next, 12)).replace(/[()\r\n]/g, '')})`,
      () => '',
      () => `G04 X${number(0, 2)}`,
      () => `#1=${number(1, 9)}`,
      () => `N${Math.floor(next() * 900)} X${number(20, 60)}`,
    ])(),
  );
  const text = [
    'O0001',
    'T0101',
    'G97 S800 M03',
    `G00 X${number(60, 70)} Z2`,
    ...blocks,
    'M30',
    'O0002',
    `G00 X${number(40, 50)} Z3`,
    `G01 Z-${number(2, 9)} F0.1`,
    'M30',
    '',
  ].join(pick(next, ['\n', '\n', '\r\n', '\r']));
  const maybe = <T>(make: () => T): T | null => (next() < 0.5 ? null : make());
  const diameter = number(50, 70);
  return {
    text: next() < 0.03 ? '' : text,
    setup: maybe(
      () =>
        `{"stock": {"diameter": ${diameter}, "length": ${number(40, 90)}}${next() < 0.3 ? ', "initial": {"x": 200, "z": 100}' : ''}}`,
    ),
    control: pick(next, ['fanuc', 'gsk', 'forum', null]),
    blockSkip: maybe(() => pick(next, ['1', '2', '1,2', ''])),
    program: maybe(() => pick(next, ['1', '2'])),
    language: pick(next, ['en', 'zh', 'ru']),
    view: pick(next, [null, null, 'picture', 'playback', 'code']),
    step: maybe(() => pick(next, ['1', '3', 'line 5'])),
    readonly: next() < 0.3,
    file: next() < 0.2 ? { name: `${wellFormed(randomText(next, 8))}.nc`, encoding: 'utf-8' } : null,
    task: null,
    answerTo: null,
    exercise: null,
    exerciseText: null,
    name: null,
  };
}
