// What of the text the worker has not received yet.
//
// In: the changes of the editor's document. Out: what brings the worker's text up to date soonest: what
// changed, or all of it in pieces. Must not know: the worker, or what the text is for.

import type { ChangeSet, Text } from '@codemirror/state';
import { inPieces } from '../files/line-ends';
import type { TextChange, TextCommand } from '../protocol/protocol';

/**
 * Longer documents are made text piece by piece. When more than this is put in at
 * once, all of the text is sent.
 */
const LONG = 1 << 20;
/** Each change costs the worker a walk over its text; of more than these all of the text is sent. */
const MOST_CHANGES = 100;

export class Unsent {
  /** The text has to be sent: these pieces, or all there is in the document by then. */
  #whole: readonly string[] | 'all' | undefined;
  #changes: ChangeSet | undefined;

  constructor(unsent: 'all' | 'nothing') {
    this.#whole = unsent === 'all' ? 'all' : undefined;
  }

  /** The whole text is needed, once more. */
  all(): void {
    this.#whole = 'all';
    this.#changes = undefined;
  }

  /** Another text took the place of the whole. */
  replaced(pieces: readonly string[]): void {
    this.#whole = pieces;
    this.#changes = undefined;
  }

  changed(changes: ChangeSet): void {
    if (this.#whole !== undefined) this.all();
    else this.#changes = this.#changes?.compose(changes) ?? changes;
  }

  /** What to send now; nothing when all was sent. */
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
 * The last in the text first: each then stands where the text was. Nothing when they
 * are too many or too long.
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
