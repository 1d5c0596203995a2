// Tracks the part of the text that the worker has not received.
//
// In: the changes of the editor's document. Out: the fastest update of the worker's text: the changes, or the whole
// text in pieces. Must not know: the worker, or the purpose of the text.

import type { ChangeSet, Text } from '@codemirror/state';
import { inPieces } from '../files/line-ends';
import type { TextChange, TextCommand } from '../protocol/protocol';

/**
 * Longer documents are converted to text piece by piece. If more than this is inserted in one go, the whole text is
 * sent.
 */
const LONG = 1 << 20;
/** Each change costs the worker a pass over its text; for more changes than this the whole text is sent. */
const MOST_CHANGES = 100;

export class Unsent {
  /** The whole text must be sent: these pieces, or the content of the document at that time. */
  #whole: readonly string[] | 'all' | undefined;
  #changes: ChangeSet | undefined;

  constructor(unsent: 'all' | 'nothing') {
    this.#whole = unsent === 'all' ? 'all' : undefined;
  }

  /** Send the whole text again. */
  all(): void {
    this.#whole = 'all';
    this.#changes = undefined;
  }

  /** The whole text was replaced. */
  replaced(pieces: readonly string[]): void {
    this.#whole = pieces;
    this.#changes = undefined;
  }

  changed(changes: ChangeSet): void {
    if (this.#whole !== undefined) this.all();
    else this.#changes = this.#changes?.compose(changes) ?? changes;
  }

  /** The command to send; undefined if everything was sent. */
  take(doc: Text): TextCommand | undefined {
    const [whole, changes] = [this.#whole, this.#changes];
    this.#whole = this.#changes = undefined;
    if (whole === undefined) {
      if (changes === undefined) return undefined;
      const list = listed(changes);
      if (list !== undefined) return { kind: 'edit', changes: list };
    }
    return { kind: 'text', pieces: whole === undefined || whole === 'all' ? piecesOf(doc) : whole };
  }
}

/**
 * From the end of the text, so that each offset stays valid. Undefined if there are too many changes, or too long ones.
 */
function listed(changes: ChangeSet): TextChange[] | undefined {
  const list: TextChange[] = [];
  let inserted = 0;
  changes.iterChanges((from, to, _newFrom, _newTo, insert) => {
    inserted += insert.length;
    if (list.length <= MOST_CHANGES && inserted <= LONG) list.push({ from, to, insert: insert.toString() });
  });
  return list.length > MOST_CHANGES || inserted > LONG ? undefined : list.reverse();
}

function piecesOf(doc: Text): string[] {
  if (doc.length <= LONG) return [doc.toString()];
  const pieces: string[] = [];
  for (let from = 0; from < doc.length; ) {
    const line = doc.lineAt(Math.min(from + LONG, doc.length));
    const to = Math.min(line.to + 1, doc.length);
    pieces.push(...inPieces(doc.sliceString(from, to)));
    from = to;
  }
  return pieces;
}
