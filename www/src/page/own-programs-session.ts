// Synchronises a tab with the list of saved programs: writes entries, takes over what other tabs left in the journal,
// follows their changes, and shows notices under the header.
//
// In: entries of the journal; events of other tabs and of the database. Out: rows of the list; the notice. Writes one
// entry at a time, only the newest of each program, and retries failed writes. Must not know: the dialog, or
// the layout of the database.

import type { KeptList, ProgramOfTab } from './page-host';
import { pictureOf } from './own-programs-picture';
import { isSame, nameOf, type Listed } from './own-programs';
import { NewsLine, type News, type NewsAct } from './own-programs-news';
import * as store from './own-programs-store';
import { Tabs, type TabNews } from './own-programs-tabs';
import { forgetWritten, journal, keepInJournal, knowsNoLast, TAB, type Entry, type KeptProgram } from './storage';

const TRY_AGAIN_MS = 5000;
const NO_ANSWER_MS = 10_000;
/** Delay after an edit, so that the picture does not occupy the worker while the user types. */
const PICTURE_AFTER_MS = 1500;

type Journal = 'kept' | 'refused';
/** Notices about one program, removed when another one is opened. */
const OF_A_PROGRAM: readonly News['kind'][] = ['changed-elsewhere', 'both-kept', 'deleted-elsewhere'];
/** Notices that saving failed, removed when it succeeds. */
const FAILURES: readonly News['kind'][] = ['full', 'refused', 'last-only', 'too-many'];

export class Session implements KeptList {
  readonly #keeping: ProgramOfTab;
  readonly #news = new NewsLine((act) => void this.#act(act));
  readonly #tabs: Tabs;
  readonly #ready: Promise<void>;
  readonly #waiting = new Map<string, Entry>();
  /** Entries that are in the list but could not be removed from the journal yet. */
  readonly #written = new Map<string, Entry>();
  readonly #heardBy = new Set<() => void>();
  readonly #pictured = new Map<string, number>();
  #newsOf: string | undefined;
  #journal: Journal = 'kept';
  #working = false;
  #again: ReturnType<typeof setTimeout> | undefined;
  #pictureSoon: ReturnType<typeof setTimeout> | undefined;

  constructor(keeping: ProgramOfTab) {
    this.#keeping = keeping;
    const { playground } = keeping.host;
    this.showLanguage();
    document.querySelector('header')?.after(this.#news.element);
    this.#tabs = new Tabs((news) => void this.#heard(news));
    store.listen({ closed: () => void this.#closed() });
    addEventListener('pageshow', ({ persisted }) => {
      if (persisted) void this.#isShownAgain();
    });
    playground.addEventListener('gcode-settled', () => {
      const { news } = this.#news;
      if (news !== undefined && OF_A_PROGRAM.includes(news) && this.#newsOf !== this.#keeping.id) this.#say(undefined);
      this.#drawSoon();
    });
    this.#ready = this.#begin();
  }

  follow(heard: () => void): void {
    this.#heardBy.add(heard);
  }

  changed(news: TabNews): void {
    if (news.kind === 'deleted') this.#forget(news.id);
    this.#tabs.tell(news);
    this.#tellHere();
  }

  knows({ id, revision }: Pick<Listed, 'id' | 'revision'>): void {
    this.#keeping.known.set(id, revision);
    if (this.#news.news === 'changed-elsewhere' && id === this.#keeping.id) this.#say(undefined);
  }

  showLanguage(): void {
    this.#news.language = this.#keeping.host.language;
  }

  keep(entry: Entry, journalled: Journal): void {
    this.#journal = journalled;
    this.#waiting.set(entry.id, entry);
    void this.#work();
  }

  async written(): Promise<void> {
    await this.#work();
    while (this.#working) await new Promise((done) => setTimeout(done, 20));
  }

  // ---- writing ------------------------------------------------------------------------------------

  async #work(): Promise<void> {
    if (this.#working) return;
    this.#working = true;
    try {
      await this.#reportIfLate(this.#ready);
      for (;;) {
        const [next] = this.#waiting.values();
        if (next === undefined) return;
        this.#waiting.delete(next.id);
        try {
          if ((await this.#reportIfLate(this.#write(next))) === 'waits') return;
        } catch (error) {
          if (!this.#waiting.has(next.id)) this.#waiting.set(next.id, next);
          this.#failed(error);
          return;
        }
      }
    } finally {
      this.#working = false;
    }
  }

  /**
   * Reports a database that does not answer as a failure. The timeout starts again after the page was in the
   * back/forward cache.
   */
  async #reportIfLate<T>(answer: Promise<T>): Promise<T> {
    const wait = (): ReturnType<typeof setTimeout> => setTimeout(() => this.#failed(undefined), NO_ANSWER_MS);
    let late = wait();
    const waitAgain = (): void => {
      clearTimeout(late);
      late = wait();
    };
    addEventListener('pageshow', waitAgain);
    try {
      return await answer;
    } finally {
      clearTimeout(late);
      removeEventListener('pageshow', waitAgain);
    }
  }

  async #write(entry: Entry): Promise<'done' | 'waits'> {
    const { id } = entry;
    const base = this.#keeping.known.get(id) ?? entry.base;
    // An emptied program that was never in the list is not saved.
    if (base === 0 && entry.program.text.trim() === '') return this.#settle(entry);
    const outcome = await store.writeProgram({ ...entry, base, name: this.#nameOf(entry.program), state: 'in-time' });
    switch (outcome.kind) {
      case 'too-many':
        return this.#wait(entry);
      case 'conflict':
        return this.#goOnBeside(entry);
      case 'written': {
        this.#succeeded();
        this.#settle(entry);
        // Later edits become a separate program beside that of the other tab.
        if (outcome.was === 'overtaken') {
          if (id === this.#keeping.id && entry.tab === TAB) this.#say({ kind: 'changed-elsewhere' });
          return 'done';
        }
        this.knows(outcome.row);
        if (outcome.was === 'new' && base > 0) this.#say({ kind: 'cleared' });
        if (outcome.was !== 'same') this.changed({ kind: 'changed', id, revision: outcome.row.revision });
        this.#drawSoon();
        return 'done';
      }
    }
  }

  /** Another tab has changed the same program: saves this text as a separate program. */
  async #goOnBeside(entry: Entry): Promise<'done' | 'waits'> {
    const beside = await store.writeBeside(entry);
    if (beside === 'too-many') return this.#wait(entry);
    this.knows(beside);
    const { id, began } = this.#keeping;
    if (id === entry.id && (entry.tab === TAB || entry.tab === began?.tab)) {
      this.#keeping.remember(beside.id, entry.program.text);
      this.#keeping.takes(beside.id);
      const { program, time } = entry;
      keepInJournal({ id: beside.id, time, base: beside.revision, program });
      // Move a newer waiting entry to the new id.
      const typed = this.#waiting.get(entry.id);
      this.#waiting.delete(entry.id);
      if (typed !== undefined) this.#waiting.set(beside.id, { ...typed, id: beside.id, base: beside.revision });
      this.#say({ kind: 'both-kept', name: beside.name });
    }
    this.#settle(entry);
    this.changed({ kind: 'changed', id: beside.id, revision: beside.revision });
    return 'done';
  }

  /** The list is full: the entry waits, unless a newer one of the program already does. */
  #wait(entry: Entry): 'waits' {
    if (!this.#waiting.has(entry.id)) this.#waiting.set(entry.id, entry);
    this.#fail('too-many');
    return 'waits';
  }

  /** The entry is in the list: removes it from the journal, now or once it is no longer the last one. */
  #settle(entry: Entry): 'done' {
    this.#keeping.isInList(entry);
    this.#written.set(`${entry.id}:${entry.tab}`, entry);
    for (const [key, written] of this.#written) if (forgetWritten(written) === 'gone') this.#written.delete(key);
    return 'done';
  }

  #nameOf(program: KeptProgram): string {
    return nameOf(program, program.example === '' ? undefined : this.#keeping.host.titleOf(program.example));
  }

  #failed(error: unknown): void {
    this.#fail(store.isFull(error) ? 'full' : this.#journal === 'kept' ? 'last-only' : 'refused');
  }

  #fail(kind: 'full' | 'refused' | 'last-only' | 'too-many'): void {
    if (this.#news.news !== kind) this.#say({ kind });
    clearTimeout(this.#again);
    this.#again = setTimeout(() => void this.#work(), TRY_AGAIN_MS);
  }

  #succeeded(): void {
    clearTimeout(this.#again);
    const { news } = this.#news;
    if (news !== undefined && FAILURES.includes(news)) this.#say(undefined);
  }

  // ---- at start, and other tabs --------------------------------------------------------------------

  async #begin(): Promise<void> {
    try {
      await this.#takeOver();
      await this.#compareWithList();
    } catch {
      // Ignored: if there is something to save, writing it reports the failure.
    }
  }

  /** Moves the entries of the journal to the list: from other tabs, or from before the list existed. */
  async #takeOver(): Promise<void> {
    for (const entry of journal()) await this.#write(entry);
  }

  /**
   * Shows the program of the list if it is newer than the journal, which loses some seconds when the browser is killed.
   */
  async #compareWithList(): Promise<void> {
    const { began, host } = this.#keeping;
    if (began === undefined) {
      const isFresh =
        knowsNoLast() &&
        location.hash === '' &&
        this.#keeping.id === undefined &&
        host.program.example !== '' &&
        this.#waiting.size === 0;
      const [newest] = isFresh ? await store.listPrograms() : [];
      if (newest !== undefined) await this.#show(newest.id);
      return;
    }
    const [row, program] = await Promise.all([store.listed(began.id), store.programOf(began.id)]);
    if (row === undefined || program === undefined) return;
    if (isSame(program, began.program)) this.knows(row);
    else if (row.changed > began.time && this.#keeping.id === began.id && isSame(host.program, began.program))
      await this.#show(began.id);
  }

  async #show(id: string): Promise<void> {
    const [row, program] = await Promise.all([store.listed(id), store.programOf(id)]);
    if (row === undefined || program === undefined) return;
    await this.#keeping.host.show({ ...program, id });
    this.knows(row);
  }

  async #heard(news: TabNews): Promise<void> {
    this.#tellHere();
    if (news.kind === 'list') return;
    const isHere = news.id === this.#keeping.id;
    if (news.kind === 'deleted') {
      this.#forget(news.id);
      if (isHere) this.#say({ kind: 'deleted-elsewhere' });
    } else if (isHere && news.revision > (this.#keeping.known.get(news.id) ?? 0)) {
      const row = await store.listed(news.id).catch(() => undefined);
      if (row !== undefined && row.tab !== TAB && news.id === this.#keeping.id)
        this.#say({ kind: 'changed-elsewhere' });
    }
  }

  /** Catches up with other tabs' changes after the page was in the back/forward cache. */
  async #isShownAgain(): Promise<void> {
    const { id, known } = this.#keeping;
    if (id === undefined || !known.has(id)) return;
    const row = await store.listed(id).catch(() => 'unknown' as const);
    if (row === 'unknown') return;
    await this.#heard(row === undefined ? { kind: 'deleted', id } : { kind: 'changed', id, revision: row.revision });
  }

  #forget(id: string): void {
    this.#keeping.known.delete(id);
    this.#waiting.delete(id);
    if (this.#keeping.began?.id === id) this.#keeping.began = undefined;
  }

  /** The browser has closed the database: save the program again if it was deleted. */
  async #closed(): Promise<void> {
    const { id, host, known } = this.#keeping;
    if (id === undefined || !known.has(id)) return;
    try {
      if ((await store.listed(id)) === undefined) this.#keeping.keep(host.program);
    } catch (error) {
      this.#failed(error);
    }
  }

  #tellHere(): void {
    for (const heard of this.#heardBy) heard();
  }

  async #act(act: NewsAct): Promise<void> {
    const { id, host } = this.#keeping;
    switch (act) {
      case 'save-file':
        return host.playground.saveFile();
      case 'open-list':
        return host.openList();
      case 'show':
        // Save the latest edits first: they become a separate program.
        host.keepNow();
        await this.written();
        if (id === undefined || this.#keeping.id !== id) return;
        this.#say(undefined);
        return this.#show(id);
      case 'keep-both': {
        if (id !== undefined)
          await this.#goOnBeside({ id, tab: TAB, time: Date.now(), base: 0, program: host.program });
      }
    }
  }

  #say(news: News | undefined): void {
    this.#newsOf = this.#keeping.id;
    this.#news.show(news);
  }

  // ---- pictures -----------------------------------------------------------------------------------

  #drawSoon(): void {
    clearTimeout(this.#pictureSoon);
    this.#pictureSoon = setTimeout(() => void this.#draw().catch(() => undefined), PICTURE_AFTER_MS);
  }

  async #draw(): Promise<void> {
    const { id, known, host } = this.#keeping;
    const revision = id === undefined ? undefined : known.get(id);
    if (id === undefined || revision === undefined || this.#waiting.size > 0 || this.#pictured.get(id) === revision)
      return;
    this.#pictured.set(id, revision);
    const picture = await pictureOf(host.playground);
    if (this.#keeping.id !== id) return;
    await store.keepPicture(id, revision, picture);
    this.changed({ kind: 'list' });
  }
}
