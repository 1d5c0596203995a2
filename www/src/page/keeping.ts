// Which of the reader's own programs is in this tab, and keeping it.
//
// In: the program, each time it is to be kept; which one takes its place. Out: an entry of the journal, at once, and
// then a row of the list (`own-programs-session.ts`, loaded after the first picture). So what was typed is safe when
// the tab is killed (the journal is written in the same turn) and when the browser is (the database is written a
// moment later; browsers write the journal's store to the disk only after some seconds).
// Must not know: the database, or what is shown of a program.

import { inTime } from '../dom/in-time';
import { loaded } from '../dom/network';
import type { Session } from './own-programs-session';
import type { KeepingHost, ProgramOfTab } from './page-host';
import { keepInJournal, LONGEST_IN_JOURNAL, newId, TAB, type Entry, type KeptProgram } from './storage';

/** How long the list waits for the first picture. */
const LATEST_MS = 10_000;
/** Undo brings back one of these at most. */
const MOST_REMEMBERED = 20;

export class Keeping implements ProgramOfTab {
  readonly host: KeepingHost;
  /** The newest revision of a program that this tab has seen. */
  readonly known = new Map<string, number>();
  /** The entry of the journal that the page began with, or the program of a task. */
  began: Entry | undefined;
  #id: string | undefined;
  /** The programs this tab has had, as they were kept last. */
  readonly #had = new Map<string, string>();
  #session: Promise<Session> | undefined;
  #lastTime = 0;
  /** Of each program the newest entry that is too long for the journal, until the list has it. */
  readonly #onlyHere = new Map<string, number>();
  #longComes = false;
  /** The page is not left without a question as long as there is such an entry, or one comes. */
  readonly #ask = (event: Event): void => event.preventDefault();

  constructor(host: KeepingHost) {
    this.host = host;
  }

  /** The program of the list that is in the editor; none, where it is an example as it came. */
  get id(): string | undefined {
    return this.#id;
  }

  /** A program of the list is in the editor, or one that the list does not have. */
  takes(id: string | undefined): void {
    this.#id = id;
  }

  /** Another text has taken the place of the one before, or undo has brought back one; nothing: it is too long to be kept. */
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

  /** A program that is too long for the journal waits to be kept, or no longer. */
  set longComes(comes: boolean) {
    this.#longComes = comes;
    this.#askOrNot();
  }

  isInList({ id, time }: Entry): void {
    if (time >= (this.#onlyHere.get(id) ?? Infinity)) this.#onlyHere.delete(id);
    this.#askOrNot();
  }

  /** Heard only where it is needed: a page that hears it is not put aside by every browser. */
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

  /** The list, once the first picture is there, or does not come; what could not be loaded is asked for again the next time. */
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
