// The program of the page as a link holds it.
//
// In: the program with its context. Out: what is shared of it, with nothing said of how it is shown. Must not know: how a
// link holds it.

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

/** The page keeps nothing as an empty text. */
function said(text: string | undefined): string | null {
  return text === undefined || text === '' ? null : text;
}
