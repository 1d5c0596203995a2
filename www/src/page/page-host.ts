// What the page provides to actions and to saving.
//
// In and out: types only. Must not know: their users.

import type { Language } from '../dom/language';
import type { GcodePlayground } from '../shell/element';
import type { Example } from './gallery';
import type { TabNews } from './own-programs-tabs';
import type { Entry, KeptProgram, OwnProgram } from './storage';

/** What the page provides to `Keeping`. */
export interface KeepingHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The current program with its context. */
  readonly program: KeptProgram;
  /** The title of an example in the language of the page. */
  titleOf(example: string): string | undefined;
  /** Replaces the current program; undo restores it. */
  show(program: OwnProgram): Promise<void>;
  /** Saves pending changes immediately. */
  keepNow(): void;
  openList(): void;
}

/** The saved program in this tab (`keeping.ts`). */
export interface ProgramOfTab {
  readonly host: KeepingHost;
  /** The newest revision that this tab has seen, for each program. */
  readonly known: Map<string, number>;
  /** The journal entry that the page started with. */
  began: Entry | undefined;
  /** The id of the saved program in the editor; undefined for an unchanged example. */
  readonly id: string | undefined;
  takes(id: string | undefined): void;
  remember(id: string, text: string): void;
  keep(program: KeptProgram): void;
  /** The list contains this entry. */
  isInList(entry: Entry): void;
}

/** The connection of a tab to the list of saved programs (`own-programs-session.ts`). */
export interface KeptList {
  /** Calls `heard` after each change of the list, in any tab. */
  follow(heard: () => void): void;
  /** Reports a change of the list that was not made by saving the program. */
  changed(news: TabNews): void;
  /** Records a revision that this tab has written or shown. */
  knows(row: { readonly id: string; readonly revision: number }): void;
  /** Resolved when no entry is waiting, or writing has failed. */
  written(): Promise<void>;
}

/** What the page provides to an action. */
export interface PageHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The current example, or the example that the program started from. */
  readonly example: Example | undefined;
  /** The current program with its context. */
  readonly program: KeptProgram;
  /** Saves the current program and replaces it; undo restores it. */
  readonly show: (program: OwnProgram) => Promise<void>;
  /** The saved program in this tab, and the list of all. */
  readonly keeping: ProgramOfTab & { session(): Promise<KeptList> };
}
