// Files the reader opens, drops or saves: bytes to text and back.
//
// In: a `File`, or a text and its file. Out: the text and how it was read, or why there is none; the bytes to save. What
// was opened and is saved unchanged has the same bytes. Must not know: what the text is for.

import { guess } from './encoding-guess';
import { decode, encode, isUnicode, type Encoding } from './encodings';
import type { ProgramFile } from './editor-file';

const SIZE_LIMIT = 64 * 1024 * 1024;
/** The name of a program that never was a file. */
const NEW_FILE: ProgramFile = { name: 'program.nc', encoding: 'utf-8' };

export type Opened =
  | { readonly kind: 'text'; readonly text: string; readonly file: ProgramFile; readonly binary: boolean }
  | { readonly kind: 'too-large'; readonly name: string }
  | { readonly kind: 'unreadable'; readonly name: string };

export async function readProgram(file: File): Promise<Opened> {
  const { name } = file;
  if (file.size > SIZE_LIMIT) return { kind: 'too-large', name };
  let bytes: Uint8Array;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch {
    return { kind: 'unreadable', name };
  }
  const { encoding, text, binary } = guess(bytes);
  return { kind: 'text', text, file: { name, encoding }, binary };
}

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
 * The text when another encoding is chosen. One that was guessed may be wrong: its bytes are read again, with what was
 * edited since. The characters stay as they are when it was certain, or becomes Unicode and the bytes are none.
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
