// What the page lends to what can be done with the program, and to keeping it.
//
// In and out: types alone. Must not know: who borrows it.

import type { Language } from '../dom/language';
import type { GcodePlayground } from '../shell/element';
import type { Example } from './gallery';
import type { TabNews } from './own-programs-tabs';
import type { Entry, KeptProgram, OwnProgram } from './storage';

/** What the page lends to keeping. */
export interface KeepingHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The program as it is now, with its context. */
  readonly program: KeptProgram;
  /** What an example is called in the language of the page. */
  titleOf(example: string): string | undefined;
  /** Puts a program in the place of the one that is there; undo brings it back. */
  show(program: OwnProgram): Promise<void>;
  /** What waits to be kept is kept now. */
  keepNow(): void;
  openList(): void;
}

/** Which of the reader's own programs is in this tab (`keeping.ts`). */
export interface ProgramOfTab {
  readonly host: KeepingHost;
  /** The newest revision of a program that this tab has seen. */
  readonly known: Map<string, number>;
  /** The entry of the journal that the page began with. */
  began: Entry | undefined;
  /** The program of the list that is in the editor; none, where it is an example as it came. */
  readonly id: string | undefined;
  takes(id: string | undefined): void;
  remember(id: string, text: string): void;
  keep(program: KeptProgram): void;
  /** The list has this entry. */
  isInList(entry: Entry): void;
}

/** What a tab does about the list of the reader's own programs (`own-programs-session.ts`). */
export interface KeptList {
  /** Calls `heard` after each change of the list, by whichever tab. */
  follow(heard: () => void): void;
  /** This tab has changed the list by other ways than by writing the program. */
  changed(news: TabNews): void;
  /** A revision that this tab has made or shown. */
  knows(row: { readonly id: string; readonly revision: number }): void;
  /** Resolved once nothing waits to be written, or it cannot be. */
  written(): Promise<void>;
}

/** What the page lends to an action. */
export interface PageHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The example that is shown, or that the program began as. */
  readonly example: Example | undefined;
  /** The program as it is now, with its context. */
  readonly program: KeptProgram;
  /** Puts another program in the place of the one that is there, which is kept before; undo brings it back. */
  readonly show: (program: OwnProgram) => Promise<void>;
  /** Which of the reader's own programs it is, and the list of them. */
  readonly keeping: ProgramOfTab & { session(): Promise<KeptList> };
}
