// The argument of the method `seek`: where the page moves the tool.
//
// In: the argument. Out: a position of the tool. Must not know: the program, or how the tool moves.

import type { Step } from './author';

/**
 * A fraction of the playback, 0 to 1; the end of a motion, from 1 (0: the start of the program); or the start of a line,
 * from 1.
 */
export type SeekTarget = { readonly share: number } | { readonly motion: number } | { readonly line: number };

/** A position of the tool; `whole`: none, the whole path is shown. */
export type ToolTarget =
  | Step
  | { readonly kind: 'share'; readonly share: number }
  /** No tool: the whole path is shown. */
  | { readonly kind: 'whole' };

/** The largest number of a motion or line. */
const MAX_NUMBER = 999_999_999;

/** Throws a `RangeError` if the argument has another form. */
export function toolTarget(to: SeekTarget | null): ToolTarget {
  if (to === null) return { kind: 'whole' };
  if ('share' in to) return { kind: 'share', share: inRange('share', to.share, 0, 1) };
  if ('line' in to) return { kind: 'line', line: wholeNumber('line', to.line, 1) };
  const motion = wholeNumber('motion', to.motion, 0);
  return motion === 0 ? { kind: 'share', share: 0 } : { kind: 'motion', motion: motion - 1 };
}

function wholeNumber(name: string, value: number, least: number): number {
  return Math.trunc(inRange(name, value, least, MAX_NUMBER));
}

function inRange(name: string, value: number, least: number, most: number): number {
  if (typeof value === 'number' && value >= least && value <= most) return value;
  throw new RangeError(`seek: ${name} is ${value}, expected ${least} to ${most}`);
}
