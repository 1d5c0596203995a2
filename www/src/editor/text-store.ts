// The interface of the text: implemented first by a plain text, then by the editor.
//
// Offsets count each line end as one unit. Only changes by the user fire events, not those by the page.

import type { Fix, Setting, TextCommand } from '../protocol/protocol';
import type { LineEnds } from '../files/line-ends';
import type { HelpSource } from './place-help';
import type { ProgramFile, ProgramText } from './program-text';

export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A range of the text and its replacement. */
export type Change = Pick<Fix['edits'][number], 'from' | 'to' | 'text'>;

/** Lines from 1, both included. */
export interface LineRange {
  readonly first: number;
  readonly last: number;
}

/** Whether the user can edit the text. */
export type Access = 'editable' | 'readonly';

/** How the user has changed the text: key by key or by a proposal, or in one piece. */
export type Input = 'typed' | 'inserted';

export interface TextEvents {
  onTextChanged(input: Input): void;
  onFileChanged(): void;
}

/** How the program is run, and its origin. */
export interface ProgramContext {
  readonly control: string | null;
  /** JSON */
  readonly setup: string | null;
  readonly blockSkip: string | null;
  readonly program: string | null;
  /** An identifier set by the page; null for a program of the user. */
  readonly origin: string | null;
}

export interface ContextSource {
  /** The current context. */
  context(): ProgramContext;
  /** The context for a new, unrelated program. */
  neutral(): ProgramContext;
}

export interface EditorEvents extends TextEvents, ContextSource {
  /** The user has replaced the program, or undo has restored one, with its context. */
  onContextChanged(context: ProgramContext): void;

  onCursorMoved(): void;
  /** The tried values have changed, or their blocks have moved. */
  onTrialChanged(): void;
  /** For help at a place (`place-help`). */
  help(): HelpSource;
  /** Completion could not be loaded; `retry` tries again. */
  onCompletionFailed(reason: unknown, retry: () => void): void;
  onCompletionLoaded(): void;
  /** The user has selected a setting as the fix of a problem. */
  onSettingChosen(setting: Setting): void;
  /** The program is about to get the focus and must become visible. */
  onShowProgram(): void;
  /** Other lines are visible. */
  onViewMoved(): void;
  /** A text was pasted or dropped; the offsets are those after the change. */
  onPasted(from: number, to: number): void;
}

export interface TextStore {
  readonly text: string;
  /** With the line ends of the file. */
  readonly textWithLineEnds: string;
  readonly lineEnds: LineEnds;
  /** UTF-16 units. */
  readonly length: number;
  /** Incremented with each change of the text. */
  readonly revision: number;
  /** The file of the text; setting it changes the file that the text is saved as. */
  get file(): ProgramFile | undefined;
  set file(file: ProgramFile);
  readonly selection: Span;
  readonly cursor: number;
  textBetween(from: number, to: number): string;
  /** The command that updates the worker's text; undefined if it is up to date. Clears the pending changes. */
  takeUnsent(): TextCommand | undefined;
  /** A new worker has no text: send all of it again. */
  markAllUnsent(): void;
  /**
   * Sets another text. `undoable`: undo restores the replaced text, and the current context if another `context` is
   * given.
   */
  setText(
    program: ProgramText,
    file: ProgramFile | undefined,
    undoable: 'undoable' | 'final',
    context?: ProgramContext,
  ): void;
  /** Replaces the text by another form of the same program. */
  rewrite(text: string): void;
  /** Edits by the user that are undone together. */
  change(edits: readonly Change[]): void;
  select(span: Span): void;
}

/** The state that an editor takes over from the plain text. */
export interface InitialState {
  readonly program: ProgramText;
  readonly file: ProgramFile | undefined;
  /** The part of the text that the worker has not received. */
  readonly unsent: 'all' | 'nothing';
}
