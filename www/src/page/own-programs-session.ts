// Synchronises a tab with the list of saved programs: writes entries, takes over what other tabs left in the journal,
// follows their changes, and shows notices over the element.
//
// In: entries of the journal; events of other tabs and of the database. Out: rows of the list; the notice. Writes one
// entry at a time, only the newest of each program, and retries failed writes. Must not know: the dialog, or
// the layout of the database.

import type { SavedProgramList, TabProgram } from './page-host';
import { makePicture } from './own-programs-picture';
import { isSame, nameOf, type ProgramRow } from './own-programs';
import { NewsLine, type News, type NewsAct } from './own-programs-news';
import * as store from './own-programs-store';
import { Tabs, type TabNews } from './own-programs-tabs';
import {
  removeWritten,
  readJournal,
  saveInJournal,
  hasNoLastEntry,
  TAB_ID,
  type Entry,
  type SavedProgram,
} from './storage';
import { find } from './find';

const RETRY_AFTER_MS = 5000;
const ANSWER_TIMEOUT_MS = 10_000;
/** Delay after an edit, so that the picture does not occupy the worker while the user types. */
const PICTURE_AFTER_MS = 1500;

type JournalOutcome = 'saved' | 'refused';
/** Notices about one program, removed when another one is opened. */
const PROGRAM_NEWS: readonly News['kind'][] = ['changed-elsewhere', 'both-kept', 'deleted-elsewhere'];
/** Notices that saving failed, removed when it succeeds. */
const FAILURE_NEWS: readonly News['kind'][] = ['full', 'refused', 'last-only', 'too-many'];

export class Session implements SavedProgramList {
  readonly #saver: TabProgram;
  readonly #news = new NewsLine((action) => void this.#runAction(action));
  readonly #tabs: Tabs;
  readonly #ready: Promise<void>;
  readonly #pending = new Map<string, Entry>();
  /** Entries that are in the list but could not be removed from the journal yet. */
  readonly #written = new Map<string, Entry>();
  readonly #listeners = new Set<() => void>();
  readonly #picturedRevisions = new Map<string, number>();
  #newsProgramId: string | undefined;
  #journal: JournalOutcome = 'saved';
  #isWriting = false;
  #retryTimer: ReturnType<typeof setTimeout> | undefined;
  #pictureTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(saver: TabProgram) {
    this.#saver = saver;
    const { playground } = saver.host;
    this.showLanguage();
    find('main').before(this.#news.element);
    this.#tabs = new Tabs((news) => void this.#onTabNews(news));
    store.setStoreEvents({ onClosed: () => void this.#onDatabaseClosed() });
    addEventListener('pageshow', ({ persisted }) => {
      if (persisted) void this.#catchUp();
    });
    playground.addEventListener('gcode-settled', () => {
      const { news } = this.#news;
      if (news !== undefined && PROGRAM_NEWS.includes(news) && this.#newsProgramId !== this.#saver.id)
        this.#showNews(undefined);
      this.#schedulePicture();
    });
    this.#ready = this.#start();
  }

  subscribe(onChange: () => void): void {
    this.#listeners.add(onChange);
  }

  changed(news: TabNews): void {
    if (news.kind === 'deleted') this.#forgetProgram(news.id);
    this.#tabs.post(news);
    this.#notifyListeners();
  }

  noteRevision({ id, revision }: Pick<ProgramRow, 'id' | 'revision'>): void {
    this.#saver.knownRevisions.set(id, revision);
    if (this.#news.news === 'changed-elsewhere' && id === this.#saver.id) this.#showNews(undefined);
  }

  showLanguage(): void {
    this.#news.language = this.#saver.host.language;
  }

  save(entry: Entry, journalOutcome: JournalOutcome): void {
    this.#journal = journalOutcome;
    this.#pending.set(entry.id, entry);
    void this.#writePending();
  }

  async whenWritten(): Promise<void> {
    await this.#writePending();
    while (this.#isWriting) await new Promise((done) => setTimeout(done, 20));
  }

  // ---- writing ------------------------------------------------------------------------------------

  async #writePending(): Promise<void> {
    if (this.#isWriting) return;
    this.#isWriting = true;
    try {
      await this.#reportIfLate(this.#ready);
      for (;;) {
        const [next] = this.#pending.values();
        if (next === undefined) return;
        this.#pending.delete(next.id);
        try {
          if ((await this.#reportIfLate(this.#write(next))) === 'waiting') return;
        } catch (error) {
          if (!this.#pending.has(next.id)) this.#pending.set(next.id, next);
          this.#reportError(error);
          return;
        }
      }
    } finally {
      this.#isWriting = false;
    }
  }

  /**
   * Reports a database that does not answer as a failure. The timeout starts again after the page was in the
   * back/forward cache.
   */
  async #reportIfLate<T>(answer: Promise<T>): Promise<T> {
    const startTimer = (): ReturnType<typeof setTimeout> =>
      setTimeout(() => this.#reportError(undefined), ANSWER_TIMEOUT_MS);
    let timer = startTimer();
    const restartTimer = (): void => {
      clearTimeout(timer);
      timer = startTimer();
    };
    addEventListener('pageshow', restartTimer);
    try {
      return await answer;
    } finally {
      clearTimeout(timer);
      removeEventListener('pageshow', restartTimer);
    }
  }

  async #write(entry: Entry): Promise<'done' | 'waiting'> {
    const { id } = entry;
    const base = this.#saver.knownRevisions.get(id) ?? entry.base;
    // An emptied program that was never in the list is not saved.
    if (base === 0 && entry.program.text.trim() === '') return this.#finishEntry(entry);
    const outcome = await store.writeProgram({ ...entry, base, name: this.#nameOf(entry.program), state: 'in-time' });
    switch (outcome.kind) {
      case 'too-many':
        return this.#keepWaiting(entry);
      case 'conflict':
        return this.#saveAsCopy(entry);
      case 'written': {
        this.#clearFailure();
        this.#finishEntry(entry);
        // Later edits become a separate program beside that of the other tab.
        if (outcome.result === 'superseded') {
          if (id === this.#saver.id && entry.tab === TAB_ID) this.#showNews({ kind: 'changed-elsewhere' });
          return 'done';
        }
        this.noteRevision(outcome.row);
        if (outcome.result === 'new' && base > 0) this.#showNews({ kind: 'cleared' });
        if (outcome.result !== 'same') this.changed({ kind: 'changed', id, revision: outcome.row.revision });
        this.#schedulePicture();
        return 'done';
      }
    }
  }

  /** Another tab has changed the same program: saves this text as a separate program. */
  async #saveAsCopy(entry: Entry): Promise<'done' | 'waiting'> {
    const copy = await store.saveConflictCopy(entry);
    if (copy === 'too-many') return this.#keepWaiting(entry);
    this.noteRevision(copy);
    const { id, startEntry } = this.#saver;
    if (id === entry.id && (entry.tab === TAB_ID || entry.tab === startEntry?.tab)) {
      this.#saver.remember(copy.id, entry.program.text);
      this.#saver.setId(copy.id);
      const { program, time } = entry;
      saveInJournal({ id: copy.id, time, base: copy.revision, program });
      // Move a newer waiting entry to the new id.
      const newer = this.#pending.get(entry.id);
      this.#pending.delete(entry.id);
      if (newer !== undefined) this.#pending.set(copy.id, { ...newer, id: copy.id, base: copy.revision });
      this.#showNews({ kind: 'both-kept', name: copy.name });
    }
    this.#finishEntry(entry);
    this.changed({ kind: 'changed', id: copy.id, revision: copy.revision });
    return 'done';
  }

  /** The list is full: the entry waits, unless a newer one of the program already does. */
  #keepWaiting(entry: Entry): 'waiting' {
    if (!this.#pending.has(entry.id)) this.#pending.set(entry.id, entry);
    this.#showFailure('too-many');
    return 'waiting';
  }

  /** The entry is in the list: removes it from the journal, now or once it is no longer the last one. */
  #finishEntry(entry: Entry): 'done' {
    this.#saver.markWritten(entry);
    this.#written.set(`${entry.id}:${entry.tab}`, entry);
    for (const [key, written] of this.#written) if (removeWritten(written) === 'removed') this.#written.delete(key);
    return 'done';
  }

  #nameOf(program: SavedProgram): string {
    return nameOf(program, program.example === '' ? undefined : this.#saver.host.titleOf(program.example));
  }

  #reportError(error: unknown): void {
    this.#showFailure(store.isFull(error) ? 'full' : this.#journal === 'saved' ? 'last-only' : 'refused');
  }

  #showFailure(kind: 'full' | 'refused' | 'last-only' | 'too-many'): void {
    if (this.#news.news !== kind) this.#showNews({ kind });
    clearTimeout(this.#retryTimer);
    this.#retryTimer = setTimeout(() => void this.#writePending(), RETRY_AFTER_MS);
  }

  #clearFailure(): void {
    clearTimeout(this.#retryTimer);
    const { news } = this.#news;
    if (news !== undefined && FAILURE_NEWS.includes(news)) this.#showNews(undefined);
  }

  // ---- at start, and other tabs --------------------------------------------------------------------

  async #start(): Promise<void> {
    try {
      await this.#writeJournal();
      await this.#compareWithList();
    } catch {
      // Ignored: if there is something to save, writing it reports the failure.
    }
  }

  /** Moves the entries of the journal to the list: from other tabs, or from before the list existed. */
  async #writeJournal(): Promise<void> {
    for (const entry of readJournal()) await this.#write(entry);
  }

  /**
   * Shows the program of the list if it is newer than the journal, which loses some seconds when the browser is killed.
   */
  async #compareWithList(): Promise<void> {
    const { startEntry, host } = this.#saver;
    if (startEntry === undefined) {
      const isFresh =
        hasNoLastEntry() &&
        location.hash === '' &&
        this.#saver.id === undefined &&
        host.program.example !== '' &&
        this.#pending.size === 0;
      const [newest] = isFresh ? await store.listPrograms() : [];
      if (newest !== undefined) await this.#show(newest.id);
      return;
    }
    const [row, program] = await Promise.all([store.readRow(startEntry.id), store.readProgram(startEntry.id)]);
    if (row === undefined || program === undefined) return;
    if (isSame(program, startEntry.program)) this.noteRevision(row);
    else if (
      row.changed > startEntry.time &&
      this.#saver.id === startEntry.id &&
      isSame(host.program, startEntry.program)
    )
      await this.#show(startEntry.id);
  }

  async #show(id: string): Promise<void> {
    const [row, program] = await Promise.all([store.readRow(id), store.readProgram(id)]);
    if (row === undefined || program === undefined) return;
    await this.#saver.host.show({ ...program, id });
    this.noteRevision(row);
  }

  async #onTabNews(news: TabNews): Promise<void> {
    this.#notifyListeners();
    if (news.kind === 'list') return;
    const isCurrent = news.id === this.#saver.id;
    if (news.kind === 'deleted') {
      this.#forgetProgram(news.id);
      if (isCurrent) this.#showNews({ kind: 'deleted-elsewhere' });
    } else if (isCurrent && news.revision > (this.#saver.knownRevisions.get(news.id) ?? 0)) {
      const row = await store.readRow(news.id).catch(() => undefined);
      if (row !== undefined && row.tab !== TAB_ID && news.id === this.#saver.id)
        this.#showNews({ kind: 'changed-elsewhere' });
    }
  }

  /** Catches up with other tabs' changes after the page was in the back/forward cache. */
  async #catchUp(): Promise<void> {
    const { id, knownRevisions } = this.#saver;
    if (id === undefined || !knownRevisions.has(id)) return;
    const row = await store.readRow(id).catch(() => 'unknown' as const);
    if (row === 'unknown') return;
    await this.#onTabNews(
      row === undefined ? { kind: 'deleted', id } : { kind: 'changed', id, revision: row.revision },
    );
  }

  #forgetProgram(id: string): void {
    this.#saver.knownRevisions.delete(id);
    this.#pending.delete(id);
    if (this.#saver.startEntry?.id === id) this.#saver.startEntry = undefined;
  }

  /** The browser has closed the database: save the program again if it was deleted. */
  async #onDatabaseClosed(): Promise<void> {
    const { id, host, knownRevisions } = this.#saver;
    if (id === undefined || !knownRevisions.has(id)) return;
    try {
      if ((await store.readRow(id)) === undefined) this.#saver.save(host.program);
    } catch (error) {
      this.#reportError(error);
    }
  }

  #notifyListeners(): void {
    for (const onChange of this.#listeners) onChange();
  }

  async #runAction(action: NewsAct): Promise<void> {
    const { id, host } = this.#saver;
    switch (action) {
      case 'save-file':
        return host.playground.saveFile();
      case 'open-list':
        return host.openList();
      case 'show':
        // Save the latest edits first: they become a separate program.
        host.saveNow();
        await this.whenWritten();
        if (id === undefined || this.#saver.id !== id) return;
        this.#showNews(undefined);
        return this.#show(id);
      case 'keep-both': {
        if (id !== undefined)
          await this.#saveAsCopy({ id, tab: TAB_ID, time: Date.now(), base: 0, program: host.program });
      }
    }
  }

  #showNews(news: News | undefined): void {
    this.#newsProgramId = this.#saver.id;
    this.#news.show(news);
  }

  // ---- pictures -----------------------------------------------------------------------------------

  #schedulePicture(): void {
    clearTimeout(this.#pictureTimer);
    this.#pictureTimer = setTimeout(() => void this.#updatePicture().catch(() => undefined), PICTURE_AFTER_MS);
  }

  async #updatePicture(): Promise<void> {
    const { id, knownRevisions, host } = this.#saver;
    const revision = id === undefined ? undefined : knownRevisions.get(id);
    if (
      id === undefined ||
      revision === undefined ||
      this.#pending.size > 0 ||
      this.#picturedRevisions.get(id) === revision
    )
      return;
    this.#picturedRevisions.set(id, revision);
    const picture = await makePicture(host.playground);
    if (this.#saver.id !== id) return;
    await store.savePicture(id, revision, picture);
    this.changed({ kind: 'list' });
  }
}
