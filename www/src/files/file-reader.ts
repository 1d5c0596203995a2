// The worker that reads a program file: guessing the encoding of a long file would block the page too long.
//
// In: a `File`. Out: its text in pieces, then its encoding and line ends; or an event that it cannot be read. Each
// worker reads one file. Must not know: the page, or the purpose of the text.

import { guessEncoding } from './encoding-guess';
import type { Encoding } from './encoding-list';
import { foldLineEnds, splitIntoPieces, lineEndsOf, type LineEnds } from './line-ends';

export type ReaderEvent =
  /** With folded line ends; a piece ends with a line end. */
  | { readonly kind: 'piece'; readonly text: string }
  | { readonly kind: 'read'; readonly ends: LineEnds; readonly encoding: Encoding; readonly binary: boolean }
  | { readonly kind: 'unreadable' };

self.onmessage = (event: MessageEvent<File>) => {
  void read(event.data);
};

async function read(file: File): Promise<void> {
  let bytes: Uint8Array;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch {
    send({ kind: 'unreadable' });
    return;
  }
  const { encoding, text, binary } = guessEncoding(bytes);
  for (const piece of splitIntoPieces(foldLineEnds(text))) send({ kind: 'piece', text: piece });
  send({ kind: 'read', ends: lineEndsOf(text), encoding, binary });
}

function send(event: ReaderEvent): void {
  self.postMessage(event);
}
