// A whole program text, and its file.
//
// In: a text with its own line ends. Out: the text in pieces, with each line end as one unit. Must not know: the
// editor, bytes, or how a file is opened or saved.

import type { Text } from '@codemirror/state';
import type { Encoding } from '../files/encoding-list';
import { foldLineEnds, splitIntoPieces, lineEndsOf, type LineEnds } from '../files/line-ends';

export interface ProgramFile {
  readonly name: string;
  /** The encoding for saving. */
  readonly encoding: Encoding;
}

/** A whole text, prepared for the editor and for the worker. */
export interface ProgramText {
  /** The pieces that the worker receives. */
  readonly pieces: readonly string[];
  readonly ends: LineEnds;
  /** The document of the editor, if it was already created. */
  readonly doc?: Text;
}

export function programText(text: string): ProgramText {
  return { pieces: splitIntoPieces(foldLineEnds(text)), ends: lineEndsOf(text) };
}
