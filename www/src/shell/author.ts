// Parses the attributes by which the author of a page sets marked lines, shown lines, the initial tool position, the
// playback speed and the rows of an element that is as high as its contents.
//
// In: texts of attributes. Out: their values; an invalid text counts as missing. Must not know: the program.

import type { Pace } from '../protocol/protocol';

/** A range of lines, from 1, both ends included. */
export interface Lines {
  readonly first: number;
  readonly last: number;
}

/** For example `6-8, 12`. */
export function parseLines(attribute: string | null): readonly Lines[] {
  const parts = (attribute ?? '').split(',').map((part) => /^\s*(\d{1,9})(?:\s*[-–]\s*(\d{1,9}))?\s*$/.exec(part));
  return parts.flatMap((part) => {
    if (part === null) return [];
    const first = Number(part[1]);
    const last = part[2] === undefined ? first : Number(part[2]);
    return first >= 1 && first <= last ? [{ first, last }] : [];
  });
}

/** A tool position: after a number of motions, or before a line. */
export type Step =
  | { readonly kind: 'motion'; readonly motion: number }
  | { readonly kind: 'line'; readonly line: number };

/** `12`: after the twelfth motion; `line 8`: before the motions of line 8. */
export function parseStep(attribute: string | null): Step | undefined {
  const found = /^\s*(line)?\s*(\d{1,9})\s*$/i.exec(attribute ?? '');
  const number = Number(found?.[2] ?? 0);
  if (found === null || number < 1) return undefined;
  return found[1] === undefined ? { kind: 'motion', motion: number - 1 } : { kind: 'line', line: number };
}

/** `5`: a multiple of the machine's speed; `20 s`: the duration of the whole program. */
export function parseSpeed(attribute: string | null): Pace | undefined {
  const found = /^\s*(\d{1,4}(?:\.\d{1,3})?)\s*(s)?\s*$/.exec(attribute ?? '');
  const number = Number(found?.[1] ?? 0);
  if (number <= 0) return undefined;
  return found?.[2] === undefined ? { kind: 'times', factor: number } : { kind: 'whole', seconds: number };
}

/** The attribute of a speed. */
export function speedText(pace: Pace): string {
  return pace.kind === 'times' ? String(pace.factor) : `${pace.seconds} s`;
}

/** Limits of the lines of the program for which an element has room. */
export interface Rows {
  readonly min: number;
  readonly max: number;
}

const DEFAULT_ROWS: Rows = { min: 3, max: 30 };

/** A maximum below the minimum counts as the minimum. */
export function parseRows(min: string | null, max: string | null): Rows {
  const least = parseCount(min) ?? DEFAULT_ROWS.min;
  return { min: least, max: Math.max(least, parseCount(max) ?? DEFAULT_ROWS.max) };
}

function parseCount(attribute: string | null): number | undefined {
  const found = /^\s*(\d{1,3})\s*$/.exec(attribute ?? '');
  return found === null ? undefined : Math.max(1, Number(found[1]));
}

export const FRAMES = ['part', 'path'] as const;
export type Frame = (typeof FRAMES)[number];
export const SIDES = ['front', 'rear'] as const;
export type Side = (typeof SIDES)[number];

/** The value of an attribute if it is one of `allowed`, or undefined. */
export function oneOf<T extends string>(allowed: readonly T[], attribute: string | null): T | undefined {
  return allowed.find((word) => word === attribute);
}
