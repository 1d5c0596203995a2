// The worker's half of finding programs in a pasted text.
//
// In: a text, then the number of a program in it. Out: the list, and the pieces of the program. Must not know: their
// use.

import { PastedText } from '../../pkg/gcode_playground.js';
import type { FoundPiece, FoundPrograms } from '../protocol/protocol';

let pasted: PastedText | undefined;

export function findPrograms(text: string): FoundPrograms {
  pasted?.free();
  pasted = new PastedText(text);
  return pasted.programs();
}

export function getPieces(program: number, language: string): readonly FoundPiece[] {
  return pasted?.pieces(program, language) ?? [];
}
