// What the page asks of whatever holds the program's text: a plain text at first, then the editor.
//
// Offsets count every line end as one unit, as everywhere in this page. What the page does to the text fires
// no event; what the reader does, does.

import type { CompletionHelp, Fix, Setting, TextCommand, WordHelp } from '../protocol/protocol';
import type { LineEnds } from '../files/line-ends';
import type { ProgramFile, ProgramText } from './program-text';

export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A place of the text and what is to stand there. */
export type Change = Pick<Fix['edits'][number], 'from' | 'to' | 'text'>;

/** Lines counted from 1, both included. */
export interface LineRange {
  readonly first: number;
  readonly last: number;
}

/** Whether the reader can change the text. */
export type Access = 'editable' | 'readonly';

export interface TextEvents {
  changed(): void;
  fileChanged(): void;
}

/** How a program is run, and whose it is: what goes with it. */
export interface ProgramContext {
  readonly control: string | null;
  /** JSON */
  readonly setup: string | null;
  readonly blockSkip: string | null;
  readonly program: string | null;
  /** What the page around knows it by; nothing for a program of the reader's own. */
  readonly origin: string | null;
}

export interface ContextEvents {
  /** The context as it is. */
  context(): ProgramContext;
  /** That of a program which has nothing to do with the one before. */
  neutral(): ProgramContext;
}

export interface EditorEvents extends TextEvents, ContextEvents {
  /** The reader has put another program in the place of the one before, or brought one back, with its context. */
  contextChanged(context: ProgramContext): void;

  cursorMoved(): void;
  /** The reader tries other values of variables, or their blocks stand elsewhere. */
  triedChanged(): void;
  /** What the word at an offset is; nothing where there is none, or nobody knows yet. */
  wordAt(offset: number): Promise<WordHelp | undefined>;
  /** What can be written at an offset; `askedFor`: the reader asks for it. */
  completionAt(offset: number, askedFor: boolean): Promise<CompletionHelp | undefined>;
  /** The proposals could not be loaded; `again` loads them. */
  completionFailed(reason: unknown, again: () => void): void;
  completionLoaded(): void;
  /** The answer to a problem is a setting. */
  settingChosen(setting: Setting): void;
  /** The program is about to get the focus: the reader is to see it. */
  wanted(): void;
  /** Other lines are in sight. */
  viewMoved(): void;
  /** A text was pasted or dropped; it stands there now. */
  pasted(from: number, to: number): void;
}

export interface TextHolder {
  readonly text: string;
  /** With the line ends of the file. */
  readonly textWithLineEnds: string;
  readonly lineEnds: LineEnds;
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
  /**
   * Another text from outside; `undoable` when it takes the place of something the reader may want back, with
   * the context as it is until now where it is given another one.
   */
  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void;
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
