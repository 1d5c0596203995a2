// What the page provides to actions and to saving.
//
// In and out: types only. Must not know: their users.

import type { Language } from '../dom/language';
import type { GcodePlayground } from '../shell/element';
import type { Example } from './gallery';
import type { TabNews } from './own-programs-tabs';
import type { Entry, SavedProgram, OwnProgram } from './storage';

/** What the page provides to `ProgramSaver`. */
export interface ProgramSaverHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The current program with its context. */
  readonly program: SavedProgram;
  /** The title of an example in the language of the page. */
  titleOf(example: string): string | undefined;
  /** Replaces the current program; undo restores it. */
  show(program: OwnProgram): Promise<void>;
  /** Saves pending changes immediately. */
  saveNow(): void;
  openList(): void;
}

/** The saved program in this tab (`program-saver.ts`). */
export interface TabProgram {
  readonly host: ProgramSaverHost;
  /** The newest revision that this tab has seen, for each program. */
  readonly knownRevisions: Map<string, number>;
  /** The journal entry that the page started with. */
  startEntry: Entry | undefined;
  /** The id of the saved program in the editor; undefined for an unchanged example. */
  readonly id: string | undefined;
  setId(id: string | undefined): void;
  remember(id: string, text: string): void;
  save(program: SavedProgram): void;
  /** The list contains this entry. */
  markWritten(entry: Entry): void;
}

/** The connection of a tab to the list of saved programs (`own-programs-session.ts`). */
export interface SavedProgramList {
  /** Calls `onChange` after each change of the list, in any tab. */
  subscribe(onChange: () => void): void;
  /** Reports a change of the list that was not made by saving the program. */
  changed(news: TabNews): void;
  /** Records a revision that this tab has written or shown. */
  noteRevision(row: { readonly id: string; readonly revision: number }): void;
  /** Resolved when no entry is waiting, or writing has failed. */
  whenWritten(): Promise<void>;
}

/** What the page provides to an action. */
export interface PageHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The current example, or the example that the program started from. */
  readonly example: Example | undefined;
  /** The current program with its context. */
  readonly program: SavedProgram;
  /** Saves the current program and replaces it; undo restores it. */
  readonly show: (program: OwnProgram) => Promise<void>;
  /** The same for a program that has just been made. */
  readonly showNew: (program: OwnProgram) => Promise<void>;
  openGallery(): void;
  /** The saved program in this tab, and the list of all. */
  readonly saver: TabProgram & { session(): Promise<SavedProgramList> };
}
