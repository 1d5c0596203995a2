// Tracks the part of the text that the worker has not received.
//
// In: the changes of the editor's document. Out: the fastest update of the worker's text: the changes, or the whole
// text in pieces. Must not know: the worker, or the purpose of the text.

import type { ChangeSet, Text } from '@codemirror/state';
import { splitIntoPieces } from '../files/line-ends';
import type { TextChange, TextCommand } from '../protocol/protocol';

/**
 * Longer documents are converted to text piece by piece. If more than this is inserted in one go, the whole text is
 * sent.
 */
const MAX_PART_LENGTH = 1 << 20;
/** Each change costs the worker a pass over its text; for more changes than this the whole text is sent. */
const MAX_CHANGES = 100;

export class Unsent {
  /** The whole text must be sent: these pieces, or the content of the document at that time. */
  #wholeText: readonly string[] | 'all' | undefined;
  #changes: ChangeSet | undefined;

  constructor(unsent: 'all' | 'nothing') {
    this.#wholeText = unsent === 'all' ? 'all' : undefined;
  }

  /** Send the whole text again. */
  markAll(): void {
    this.#wholeText = 'all';
    this.#changes = undefined;
  }

  /** The whole text was replaced. */
  recordReplacement(pieces: readonly string[]): void {
    this.#wholeText = pieces;
    this.#changes = undefined;
  }

  recordChanges(changes: ChangeSet): void {
    if (this.#wholeText !== undefined) this.markAll();
    else this.#changes = this.#changes?.compose(changes) ?? changes;
  }

  /** The command to send; undefined if everything was sent. */
  take(doc: Text): TextCommand | undefined {
    const [wholeText, changes] = [this.#wholeText, this.#changes];
    this.#wholeText = this.#changes = undefined;
    if (wholeText === undefined) {
      if (changes === undefined) return undefined;
      const list = changeList(changes);
      if (list !== undefined) return { kind: 'edit', changes: list };
    }
    return { kind: 'text', pieces: wholeText === undefined || wholeText === 'all' ? piecesOf(doc) : wholeText };
  }
}

/**
 * From the end of the text, so that each offset stays valid. Undefined if there are too many changes, or too long ones.
 */
function changeList(changes: ChangeSet): TextChange[] | undefined {
  const list: TextChange[] = [];
  let inserted = 0;
  changes.iterChanges((from, to, _newFrom, _newTo, insert) => {
    inserted += insert.length;
    if (list.length <= MAX_CHANGES && inserted <= MAX_PART_LENGTH) list.push({ from, to, insert: insert.toString() });
  });
  return list.length > MAX_CHANGES || inserted > MAX_PART_LENGTH ? undefined : list.reverse();
}

function piecesOf(doc: Text): string[] {
  if (doc.length <= MAX_PART_LENGTH) return [doc.toString()];
  const pieces: string[] = [];
  for (let from = 0; from < doc.length; ) {
    const line = doc.lineAt(Math.min(from + MAX_PART_LENGTH, doc.length));
    const to = Math.min(line.to + 1, doc.length);
    pieces.push(...splitIntoPieces(doc.sliceString(from, to)));
    from = to;
  }
  return pieces;
}
