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

/** Line numbers, 1-based and inclusive. */
export interface LineRange {
  readonly first: number;
  readonly last: number;
}

/** Whether the user can edit the text. */
export type Access = 'editable' | 'readonly';

/**
 * How the user has changed the text. `typed`: with keys or by completion. `inserted`: by paste, drop or another edit
 * that adds several lines.
 */
export type Input = 'typed' | 'inserted';

export interface TextEvents {
  onTextChanged(input: Input): void;
  onFileChanged(): void;
}

/**
 * The settings that a program is run with, as the attributes of the element have them, and its origin. `null`: not set.
 */
export interface ProgramContext {
  /** `fanuc`, `gsk` or `forum`; overrides the control of the setup. */
  readonly control: string | null;
  /** JSON. */
  readonly setup: string | null;
  /** The active levels of block skip, such as `1,2`; overrides the setup. */
  readonly blockSkip: string | null;
  /** The O number of the program to run; overrides that of the setup. */
  readonly program: string | null;
  /** An identifier set by the page; null for a program of the user. */
  readonly origin: string | null;
}

export interface ContextSource {
  /** The current context. */
  context(): ProgramContext;
  /** The context for a new, unrelated program. */
  neutral(): ProgramContext;
  /** Whether a text that the user types can be another program, too, not only one that is pasted. */
  typedCanReplace(): boolean;
}

export interface EditorEvents extends TextEvents, ContextSource {
  /** The user has replaced the program, or undo has restored one, with its context. */
  onContextChanged(context: ProgramContext): void;

  onCursorMoved(): void;
  /** The tried values have changed, or their blocks have moved. */
  onTrialChanged(): void;
  /** Returns what `place-help` needs to ask for the help at a place of the text. */
  help(): HelpSource;
  /** Completion could not be loaded; `retry` tries again. */
  onCompletionFailed(reason: unknown, retry: () => void): void;
  onCompletionLoaded(): void;
  /** The user has selected a setting as the fix of a problem. */
  onSettingChosen(setting: Setting): void;
  /** The program is about to get the focus and must become visible. */
  onShowProgram(): void;
  /** The visible range of lines has changed. */
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
  /** Replaces the text by the same program in another notation. In the editor, undo restores the previous text. */
  rewrite(text: string): void;
  /** Applies edits as one undo step, as if the user had made them. */
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
