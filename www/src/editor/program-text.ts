// A whole program text, and the file it came from.
//
// In: a text with its own line ends. Out: the same with every line end as one unit, in pieces. Must not know:
// the editor, bytes, or how a file is opened or saved.

import type { Text } from '@codemirror/state';
import type { Encoding } from '../files/encodings';
import { folded, inPieces, lineEndsOf, type LineEnds } from '../files/line-ends';

export interface ProgramFile {
  readonly name: string;
  /** In which it is saved. */
  readonly encoding: Encoding;
}

/** A whole text, ready for the editor and for the worker. */
export interface ProgramText {
  /** As the worker receives it. */
  readonly pieces: readonly string[];
  readonly ends: LineEnds;
  /** The same as the editor's document, where it has been made already. */
  readonly doc?: Text;
}

export function programText(text: string): ProgramText {
  return { pieces: inPieces(folded(text)), ends: lineEndsOf(text) };
}
