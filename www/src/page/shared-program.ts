// Converts the program of the page to the content of a link.
//
// In: the program with its context. Out: a `Shared` without display options. Must not know: the format of a link.

import { NOTHING_SAID, type Shared } from '../files/shared-link';
import type { KeptProgram } from './storage';

export function sharedProgram({ text, setup, control, blockSkip, program, file }: KeptProgram): Shared {
  return {
    ...NOTHING_SAID,
    text,
    setup: said(setup),
    control: said(control),
    blockSkip: blockSkip ?? null,
    program: program ?? null,
    file: file ?? null,
  };
}

/** A saved program has an empty text for a missing value. */
function said(text: string | undefined): string | null {
  return text === undefined || text === '' ? null : text;
}
