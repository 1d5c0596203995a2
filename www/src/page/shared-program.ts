// Converts the program of the page to the content of a link.
//
// In: the program with its context. Out: a `Shared` without display options. Must not know: the format of a link.

import { EMPTY_SHARED, type Shared } from '../files/shared-link';
import type { SavedProgram } from './storage';

export function toShared({ text, setup, control, blockSkip, program, file }: SavedProgram): Shared {
  return {
    ...EMPTY_SHARED,
    text,
    setup: valueOrNull(setup),
    control: valueOrNull(control),
    blockSkip: blockSkip ?? null,
    program: program ?? null,
    file: file ?? null,
  };
}

/** A saved program without a setup or a control may have an empty text for it; a link has `null`. */
function valueOrNull(text: string | undefined): string | null {
  return text === undefined || text === '' ? null : text;
}
