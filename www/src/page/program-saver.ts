// Tracks which saved program is in this tab, and saves it.
//
// In: the program, each time it is to be saved; the program that replaces it. Out: an entry of the journal in the same
// turn, then a row of the list (`own-programs-session.ts`, loaded after the first picture). So text survives when the
// tab is killed (the journal is synchronous) and when the browser is killed (the database is written a moment later,
// whereas browsers write the journal's store to disk only after some seconds). Must not know: the database, or how a
// program is shown.

import { withTimeout } from '../dom/timeout';
import { importWithRetry } from '../dom/network';
import type { Session } from './own-programs-session';
import type { ProgramSaverHost, TabProgram } from './page-host';
import { saveInJournal, MAX_JOURNAL_LENGTH, newId, TAB_ID, type Entry, type SavedProgram } from './storage';

/** Timeout for the first picture, after which the list is loaded anyway. */
const FIRST_PICTURE_TIMEOUT_MS = 10_000;
/** Number of earlier programs that are recognised when undo restores them. */
const MAX_REMEMBERED = 20;

export class ProgramSaver implements TabProgram {
  readonly host: ProgramSaverHost;
  /** The newest revision that this tab has seen, for each program. */
  readonly knownRevisions = new Map<string, number>();
  /** The journal entry that the page started with, or the program of a task. */
  startEntry: Entry | undefined;
  #id: string | undefined;
  /** The texts of this tab's programs as last saved, by id. */
  readonly #savedTexts = new Map<string, string>();
  #session: Promise<Session> | undefined;
  #lastTime = 0;
  /** For each program, the time of its newest entry that is too long for the journal, until the list has it. */
  readonly #unsavedLong = new Map<string, number>();
  #isLongPending = false;
  /** Asks before the page is left, while such an entry exists or is about to be made. */
  readonly #preventLeaving = (event: Event): void => event.preventDefault();

  constructor(host: ProgramSaverHost) {
    this.host = host;
  }

  /** The id of the saved program in the editor; undefined for an unchanged example. */
  get id(): string | undefined {
    return this.#id;
  }

  /** Sets the id of the program in the editor; undefined if the list does not contain it. */
  setId(id: string | undefined): void {
    this.#id = id;
  }

  /**
   * Another text has replaced the current one, or undo has restored an earlier one; `undefined` if it is too long to be
   * saved.
   */
  onTextReplaced(text: string | undefined): void {
    // Two programs can have the same text.
    if (this.#id !== undefined && text !== undefined && this.#savedTexts.get(this.#id) === text) return;
    this.#id = [...this.#savedTexts].find(([, before]) => before === text)?.[0];
  }

  save(program: SavedProgram): void {
    const id = (this.#id ??= newId());
    this.#lastTime = Math.max(Date.now(), this.#lastTime + 1);
    const entry: Entry = {
      id,
      tab: TAB_ID,
      time: this.#lastTime,
      base: this.knownRevisions.get(id) ?? this.#baseAtStart(id),
      program,
    };
    this.remember(id, program.text);
    const isTooLong = program.text.length > MAX_JOURNAL_LENGTH;
    if (isTooLong) this.#unsavedLong.set(id, entry.time);
    else this.#unsavedLong.delete(id);
    this.#updateLeaveGuard();
    const journal = isTooLong ? 'refused' : saveInJournal(entry, this.startEntry);
    void this.session().then(
      (session) => session.save(entry, journal),
      () => undefined,
    );
  }

  /** Whether a program that is too long for the journal is about to be saved. */
  set isLongPending(isPending: boolean) {
    this.#isLongPending = isPending;
    this.#updateLeaveGuard();
  }

  markWritten({ id, time }: Entry): void {
    if (time >= (this.#unsavedLong.get(id) ?? Infinity)) this.#unsavedLong.delete(id);
    this.#updateLeaveGuard();
  }

  /** Listens only while needed: some browsers do not put a page with this listener into the back/forward cache. */
  #updateLeaveGuard(): void {
    if (this.#isLongPending || this.#unsavedLong.size > 0) addEventListener('beforeunload', this.#preventLeaving);
    else removeEventListener('beforeunload', this.#preventLeaving);
  }

  remember(id: string, text: string): void {
    this.#savedTexts.delete(id);
    this.#savedTexts.set(id, text);
    const [oldest] = this.#savedTexts.keys();
    if (this.#savedTexts.size > MAX_REMEMBERED && oldest !== undefined) this.#savedTexts.delete(oldest);
  }

  /** The list, loaded after the first picture or its timeout. A failed load is retried by the next call. */
  session(): Promise<Session> {
    this.#session ??= this.#waitForFirstPicture()
      .then(() => importWithRetry(() => import('./own-programs-session')))
      .then(({ Session }) => new Session(this));
    this.#session.catch(() => {
      this.#session = undefined;
    });
    return this.#session;
  }

  showLanguage(): void {
    void this.#session?.then(
      (session) => session.showLanguage(),
      () => undefined,
    );
  }

  async #waitForFirstPicture(): Promise<void> {
    await withTimeout(this.host.playground.settled, FIRST_PICTURE_TIMEOUT_MS);
  }

  #baseAtStart(id: string): number {
    return this.startEntry?.id === id ? this.startEntry.base : 0;
  }
}
