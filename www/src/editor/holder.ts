// What the page asks of whatever holds the program's text: a plain text at first, then the editor.
//
// Offsets count every line end as one unit, as everywhere in this page. What the page does to the text fires
// no event; what the reader does, does.

import type { Fix, TextCommand } from '../protocol/protocol';
import type { ProgramFile, ProgramText } from './program-text';

export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A place of the text and what is to stand there. */
export type Change = Pick<Fix['edits'][number], 'from' | 'to' | 'text'>;

export interface TextEvents {
  /** `undone`: by undo, which brings back what was there before. */
  changed(how: 'edited' | 'undone'): void;
  fileChanged(): void;
}

export interface EditorEvents extends TextEvents {
  cursorMoved(): void;
  /** Other lines are in sight. */
  viewMoved(): void;
  /** A text was pasted or dropped; it stands there now. */
  pasted(from: number, to: number): void;
}

export interface TextHolder {
  readonly text: string;
  /** With the line ends of the file. */
  readonly textWithLineEnds: string;
  /** UTF-16 units. */
  readonly length: number;
  /** Counts the versions of the text. */
  readonly revision: number;
  /** The file the text came from; once set, the same text is saved as that file. */
  get file(): ProgramFile | undefined;
  set file(file: ProgramFile);
  readonly selection: Span;
  readonly cursor: number;
  textBetween(from: number, to: number): string;
  /** What makes the worker's text this one; taken once. Nothing when it is already. */
  takeUnsent(): TextCommand | undefined;
  /** There is a worker that knows nothing yet. */
  unsend(): void;
  /** Another text from outside; `undoable` when it takes the place of something the reader may want back. */
  setText(program: ProgramText, file: ProgramFile | undefined, undoable: 'undoable' | 'final'): void;
  /** The same program written differently. */
  rewrite(text: string): void;
  /** Changes of the reader's that undo takes back in one. */
  change(edits: readonly Change[]): void;
  select(span: Span): void;
}

/** What an editor takes over from the plain text before it. */
export interface Start {
  readonly program: ProgramText;
  readonly file: ProgramFile | undefined;
  /** What of it the worker has not received. */
  readonly unsent: 'all' | 'nothing';
}
