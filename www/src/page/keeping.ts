// Tracks which saved program is in this tab, and saves it.
//
// In: the program, each time it is to be saved; the program that replaces it. Out: an entry of the journal in the same
// turn, then a row of the list (`own-programs-session.ts`, loaded after the first picture). So text survives when the
// tab is killed (the journal is synchronous) and when the browser is killed (the database is written a moment later,
// whereas browsers write the journal's store to disk only after some seconds). Must not know: the database, or how a
// program is shown.

import { inTime } from '../dom/in-time';
import { loaded } from '../dom/network';
import type { Session } from './own-programs-session';
import type { KeepingHost, ProgramOfTab } from './page-host';
import { keepInJournal, LONGEST_IN_JOURNAL, newId, TAB, type Entry, type KeptProgram } from './storage';

/** Timeout for the first picture, after which the list is loaded anyway. */
const LATEST_MS = 10_000;
/** Number of earlier programs that are recognised when undo restores them. */
const MOST_REMEMBERED = 20;

export class Keeping implements ProgramOfTab {
  readonly host: KeepingHost;
  /** The newest revision that this tab has seen, for each program. */
  readonly known = new Map<string, number>();
  /** The journal entry that the page started with, or the program of a task. */
  began: Entry | undefined;
  #id: string | undefined;
  /** The texts of this tab's programs as last saved, by id. */
  readonly #had = new Map<string, string>();
  #session: Promise<Session> | undefined;
  #lastTime = 0;
  /** For each program, the time of its newest entry that is too long for the journal, until the list has it. */
  readonly #onlyHere = new Map<string, number>();
  #longComes = false;
  /** Asks before the page is left, while such an entry exists or is about to be made. */
  readonly #ask = (event: Event): void => event.preventDefault();

  constructor(host: KeepingHost) {
    this.host = host;
  }

  /** The id of the saved program in the editor; undefined for an unchanged example. */
  get id(): string | undefined {
    return this.#id;
  }

  /** Sets the id of the program in the editor; undefined if the list does not contain it. */
  takes(id: string | undefined): void {
    this.#id = id;
  }

  /**
   * Another text has replaced the current one, or undo has restored an earlier one; `undefined` if it is too long to be
   * saved.
   */
  replaced(text: string | undefined): void {
    // Two programs can have the same text.
    if (this.#id !== undefined && text !== undefined && this.#had.get(this.#id) === text) return;
    this.#id = [...this.#had].find(([, before]) => before === text)?.[0];
  }

  keep(program: KeptProgram): void {
    const id = (this.#id ??= newId());
    this.#lastTime = Math.max(Date.now(), this.#lastTime + 1);
    const entry: Entry = {
      id,
      tab: TAB,
      time: this.#lastTime,
      base: this.known.get(id) ?? this.#baseAtStart(id),
      program,
    };
    this.remember(id, program.text);
    const isTooLong = program.text.length > LONGEST_IN_JOURNAL;
    if (isTooLong) this.#onlyHere.set(id, entry.time);
    else this.#onlyHere.delete(id);
    this.#askOrNot();
    const journal = isTooLong ? 'refused' : keepInJournal(entry, this.began);
    void this.session().then(
      (session) => session.keep(entry, journal),
      () => undefined,
    );
  }

  /** Whether a program that is too long for the journal is about to be saved. */
  set longComes(comes: boolean) {
    this.#longComes = comes;
    this.#askOrNot();
  }

  isInList({ id, time }: Entry): void {
    if (time >= (this.#onlyHere.get(id) ?? Infinity)) this.#onlyHere.delete(id);
    this.#askOrNot();
  }

  /** Listens only while needed: some browsers do not put a page with this listener into the back/forward cache. */
  #askOrNot(): void {
    if (this.#longComes || this.#onlyHere.size > 0) addEventListener('beforeunload', this.#ask);
    else removeEventListener('beforeunload', this.#ask);
  }

  remember(id: string, text: string): void {
    this.#had.delete(id);
    this.#had.set(id, text);
    const [oldest] = this.#had.keys();
    if (this.#had.size > MOST_REMEMBERED && oldest !== undefined) this.#had.delete(oldest);
  }

  /** The list, loaded after the first picture or its timeout. A failed load is retried by the next call. */
  session(): Promise<Session> {
    this.#session ??= this.#firstPicture()
      .then(() => loaded(() => import('./own-programs-session')))
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

  async #firstPicture(): Promise<void> {
    await inTime(this.host.playground.settled, LATEST_MS);
  }

  #baseAtStart(id: string): number {
    return this.began?.id === id ? this.began.base : 0;
  }
}
