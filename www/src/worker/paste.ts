// The worker's half of the programs found in a text.
//
// In: a text, then the number of a program. Out: the list, and its pieces. Must not
// know: what is done with them.

import { PastedText } from '../../pkg/gcode_playground.js';
import type { FoundPiece, FoundPrograms } from '../protocol/protocol';

let pasted: PastedText | undefined;

export function programsIn(text: string): FoundPrograms {
  pasted?.free();
  pasted = new PastedText(text);
  return pasted.programs();
}

export function piecesOf(program: number, language: string): readonly FoundPiece[] {
  return pasted?.pieces(program, language) ?? [];
}
