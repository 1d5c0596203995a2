// Saves files, and converts text to another encoding.
//
// In: a text and its file. Out: the bytes to save, or the text in another encoding. A file that was opened
// (`read-program.ts`) and is saved unchanged has the same bytes. Must not know: the purpose of the text.

import type { Encoding } from '../files/encoding-list';
import { decode, encode, isUnicode } from '../files/encodings';
import type { ProgramFile } from './program-text';

/** The name of a program that was not opened from a file. */
const DEFAULT_FILE: ProgramFile = { name: 'program.nc', encoding: 'utf-8' };

const FIRST_PROGRAM = /^[ \t/]*(?:[O:][ \t]*(\d{1,8})|O?<([A-Z0-9+\-_. ]{1,32})>)/im;
/** The program is searched in the first characters only. */
const HEAD_LENGTH = 5_000;

/** The O number of the first program in a text, or its name. */
export function programName(text: string): string | undefined {
  const [, number, name] = FIRST_PROGRAM.exec(text.slice(0, HEAD_LENGTH)) ?? [];
  return number === undefined ? name : `O${number}`;
}

/** A name, without an ending, for the files that are made of a program: that of its file, or its O number. */
export function fileStem(text: string, file: ProgramFile | undefined): string {
  const stem = file === undefined ? programName(text) : file.name.replace(/(.)\.[^.]*$/, '$1');
  // No system forbids the other characters.
  return (stem ?? '').replace(/[\\/:*?"<>|\p{Cc}]+/gu, '-').trim() || 'program';
}

interface Saved {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** The file as saved: in UTF-8 if its own encoding cannot represent a character. */
  readonly file: ProgramFile;
  readonly unencodable: string | undefined;
}

export function bytesToSave(text: string, file: ProgramFile = DEFAULT_FILE): Saved {
  const encoded = encode(text, file.encoding);
  if (encoded.kind === 'bytes') return { bytes: encoded.bytes, file, unencodable: undefined };
  const bytes = new TextEncoder().encode(text);
  return { bytes, file: { ...file, encoding: 'utf-8' }, unencodable: encoded.character };
}

type Reread =
  /** The guess was wrong: the same bytes mean this text. */
  | { readonly kind: 'text'; readonly text: string }
  /** The text was right and stays; the next save uses the new encoding. */
  | { readonly kind: 'unchanged' }
  | { readonly kind: 'invalid-encoding' }
  | { readonly kind: 'unencodable'; readonly character: string };

/**
 * The text when the user selects another encoding. The old encoding may have been a wrong guess: its bytes, including
 * edits, are decoded again. The characters stay if the old encoding is a Unicode one, which is certain, or if the new
 * one is and the bytes are not valid in it.
 */
export function reread(text: string, from: Encoding, to: Encoding): Reread {
  const before = isUnicode(from) ? undefined : encode(text, from);
  if (before?.kind === 'bytes') {
    const again = decode(before.bytes, to);
    if (again !== undefined) return { kind: 'text', text: again };
    if (!isUnicode(to)) return { kind: 'invalid-encoding' };
  }
  const after = encode(text, to);
  return after.kind === 'bytes' ? { kind: 'unchanged' } : after;
}

/** Saves bytes as a download. */
export function download(name: string, bytes: Uint8Array<ArrayBuffer>): void {
  // With a text type, browsers would change the extension of some names.
  const address = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
