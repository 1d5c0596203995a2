// Parses the attributes by which the author of a page sets marked lines, shown lines and the initial tool position.
//
// In: texts of attributes. Out: their values; an invalid text counts as missing. Must not know: the program.

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

export const FRAMES = ['part', 'path'] as const;
export type Frame = (typeof FRAMES)[number];
export const SIDES = ['front', 'rear'] as const;
export type Side = (typeof SIDES)[number];

/** The value of an attribute if it is one of `allowed`, or undefined. */
export function oneOf<T extends string>(allowed: readonly T[], attribute: string | null): T | undefined {
  return allowed.find((word) => word === attribute);
}
