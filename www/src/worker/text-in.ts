// How a whole text reaches the interpreter's memory.
//
// In: a text in pieces. Out: nothing; the `Playground` has it. A long text is encoded straight
// into the memory of the module, which takes a tenth of the time of handing over a string. Must
// not know: what the text is.

import type { Playground } from '../../pkg/gcode_playground.js';

/** A shorter text goes as a string: one call, no view to care for. */
const LARGE = 100_000;

const encoder = new TextEncoder();

export function handIn(playground: Playground, pieces: readonly string[]): void {
  let left = pieces.reduce((sum, piece) => sum + piece.length, 0);
  if (left < LARGE) {
    playground.setText(pieces.join(''));
    return;
  }
  // As much as is needed when all of it is ASCII, which most of a program is.
  let room = playground.textBuffer(left);
  let written = 0;
  for (const piece of pieces) {
    for (let rest = piece; ; ) {
      const done = encoder.encodeInto(rest, room.subarray(written));
      written += done.written;
      left -= done.read;
      if (done.read === rest.length) break;
      rest = rest.slice(done.read);
      // No character is more than three bytes a unit; the old view is dead once there is a longer one.
      room = playground.textBuffer(written + 3 * left);
    }
  }
  playground.setTextFromBuffer(written);
}
