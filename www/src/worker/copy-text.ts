// Copies a text into the interpreter's memory.
//
// In: a text in pieces. Out: nothing; the `Playground` contains it. A long text is encoded directly into the memory of
// the module, which takes a tenth of the time of passing a string. Must not know: the meaning of the text.

import type { Playground } from '../../pkg/gcode_playground.js';

/** A shorter text is passed as a string, which is simpler. */
const MIN_BUFFERED_LENGTH = 100_000;

const encoder = new TextEncoder();

export function copyText(playground: Playground, pieces: readonly string[]): void {
  let remaining = pieces.reduce((sum, piece) => sum + piece.length, 0);
  if (remaining < MIN_BUFFERED_LENGTH) {
    playground.setText(pieces.join(''));
    return;
  }
  // Enough if all of it is ASCII, as most programs are.
  let buffer = playground.textBuffer(remaining);
  let written = 0;
  for (const piece of pieces) {
    for (let rest = piece; ; ) {
      const done = encoder.encodeInto(rest, buffer.subarray(written));
      written += done.written;
      remaining -= done.read;
      if (done.read === rest.length) break;
      rest = rest.slice(done.read);
      // A UTF-16 unit takes at most three bytes. The old view is invalid after the buffer has grown.
      buffer = playground.textBuffer(written + 3 * remaining);
    }
  }
  playground.setTextFromBuffer(written);
}
