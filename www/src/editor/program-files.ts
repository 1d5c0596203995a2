// Files the reader saves, or reads in another encoding: text to bytes and back.
//
// In: a text and its file. Out: the bytes to save, or the text in another encoding. What was opened
// (`read-program.ts`) and is saved unchanged has the same bytes. Must not know: what the text is for.

import { decode, encode, isUnicode, type Encoding } from '../files/encodings';
import type { ProgramFile } from './program-text';

/** The name of a program that never was a file. */
const NEW_FILE: ProgramFile = { name: 'program.nc', encoding: 'utf-8' };

export interface Saved {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** As it is now: in UTF-8 when its own encoding has no place for a character. */
  readonly file: ProgramFile;
  readonly noPlaceFor: string | undefined;
}

export function bytesToSave(text: string, file: ProgramFile = NEW_FILE): Saved {
  const encoded = encode(text, file.encoding);
  if (encoded.kind === 'bytes') return { bytes: encoded.bytes, file, noPlaceFor: undefined };
  const bytes = new TextEncoder().encode(text);
  return { bytes, file: { ...file, encoding: 'utf-8' }, noPlaceFor: encoded.character };
}

export type Reread =
  /** The guess was wrong: the same bytes are this text. */
  | { readonly kind: 'text'; readonly text: string }
  /** The text was right and stays; it is saved differently from now on. */
  | { readonly kind: 'kept' }
  | { readonly kind: 'not-this-encoding' }
  | { readonly kind: 'no-place'; readonly character: string };

/**
 * The text when another encoding is chosen. One that was guessed may be wrong: its bytes are read
 * again, with what was edited since. The characters stay as they are when it was certain, or becomes
 * Unicode and the bytes are none.
 */
export function reread(text: string, from: Encoding, to: Encoding): Reread {
  const before = isUnicode(from) ? undefined : encode(text, from);
  if (before?.kind === 'bytes') {
    const again = decode(before.bytes, to);
    if (again !== undefined) return { kind: 'text', text: again };
    if (!isUnicode(to)) return { kind: 'not-this-encoding' };
  }
  const after = encode(text, to);
  return after.kind === 'bytes' ? { kind: 'kept' } : after;
}

/** Hands bytes to the browser to be saved. */
export function download(name: string, bytes: Uint8Array<ArrayBuffer>): void {
  // With the type of a text, browsers would give some names another ending.
  const address = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
