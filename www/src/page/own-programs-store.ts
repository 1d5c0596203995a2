// The list of saved programs in IndexedDB (through `idb`, which makes promises of its events).
//
// In: programs with the revision they were made from. Out: the outcome; the list, texts, earlier states. Each change is
// one transaction over all stores that compares the revision, so tabs need no locks and never overwrite each other's
// text (`conflict`). A page in the back/forward cache closes the database and repeats its transactions afterwards.
// Loaded after the first picture. Must not know: the page, or the meaning of a program.

import { openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction } from 'idb';
import {
  importMode,
  isSame,
  shouldKeepState,
  LIMITS,
  parseRow,
  uniqueName,
  statesToDelete,
  withSeen,
  searchWords,
  type ExportedProgram,
  type ProgramRow,
  type State,
} from './own-programs';
import { newId, parseProgram, TAB_ID, type Entry, type SavedProgram } from './storage';
import type { SmallPicture } from '../../small-picture';

type StateKey = [id: string, time: number, length: number];

interface Schema extends DBSchema {
  programs: { key: string; value: ProgramRow };
  texts: { key: string; value: SavedProgram };
  states: { key: StateKey; value: SavedProgram };
}

type Stores = ['programs', 'texts', 'states'];
type Mode = 'readonly' | 'readwrite';
type Transaction<As extends Mode> = IDBPTransaction<Schema, Stores, As>;
type WriteTransaction = Transaction<'readwrite'>;
type Operation<As extends Mode, Outcome> = (transaction: Transaction<As>) => Promise<Outcome>;

const NAME = `gcode-playground:programs:${location.pathname}`;
const STORES: Stores = ['programs', 'texts', 'states'];

/** Events of the database. */
interface StoreEvents {
  /** The stored programs were deleted, or the browser has closed the database. */
  onClosed(): void;
}

let databasePromise: Promise<IDBPDatabase<Schema>> | undefined;
let upgradeTransaction: { abort(): void } | undefined;
let events: StoreEvents = { onClosed: () => undefined };

export function setStoreEvents(to: StoreEvents): void {
  events = to;
}

function openDatabase(): Promise<IDBPDatabase<Schema>> {
  if (databasePromise !== undefined) return databasePromise;
  const opening = openDB<Schema>(NAME, 1, {
    upgrade(db, _old, _new, transaction) {
      upgradeTransaction = transaction;
      db.createObjectStore('programs', { keyPath: 'id' });
      db.createObjectStore('texts');
      db.createObjectStore('states');
    },
    // Another tab wants to delete or upgrade the database: close it, and open it again on the next use.
    blocking(_now, _wanted, event) {
      (event.target as IDBDatabase).close();
      onClosed();
    },
    terminated: onClosed,
  });
  databasePromise = opening;
  opening.catch(() => {
    if (databasePromise === opening) databasePromise = undefined;
  });
  return opening;
}

function onClosed(): void {
  databasePromise = undefined;
  events.onClosed();
}

// A page in the back/forward cache receives no more database events (Firefox), and its open transactions block those on
// all other pages (WebKit). So it aborts all of them and repeats them when it is shown again. Meanwhile the journal
// contains the text; if it is too long for the journal, the page asks before it is left (`ProgramSaver`). A committed
// transaction can be repeated without harm, because all of them are idempotent.

const attempts = new Set<AbortController>();
let suspended: Promise<void> | undefined;

addEventListener('pagehide', ({ persisted }) => {
  if (!persisted) return;
  suspended ??= new Promise((resume) =>
    addEventListener(
      'pageshow',
      () => {
        suspended = undefined;
        resume();
      },
      { once: true },
    ),
  );
  void databasePromise?.then(
    (open) => open.close(),
    () => undefined,
  );
  databasePromise = undefined;
  if (upgradeTransaction !== undefined) abort(upgradeTransaction);
  for (const attempt of attempts) attempt.abort();
});

function read<Outcome>(operation: Operation<'readonly', Outcome>): Promise<Outcome> {
  return inTransaction('readonly', operation);
}

function change<Outcome>(operation: Operation<'readwrite', Outcome>): Promise<Outcome> {
  return inTransaction('readwrite', operation);
}

async function inTransaction<As extends Mode, Outcome>(mode: As, operation: Operation<As, Outcome>): Promise<Outcome> {
  for (;;) {
    await suspended;
    const attempt = new AbortController();
    const { signal } = attempt;
    const aborted = new Promise<undefined>((end) => signal.addEventListener('abort', () => end(undefined)));
    attempts.add(attempt);
    try {
      const done = await Promise.race([transact(mode, operation, signal), aborted]);
      if (done !== undefined) return done.outcome;
    } finally {
      attempts.delete(attempt);
    }
  }
}

async function transact<As extends Mode, Outcome>(
  mode: As,
  operation: Operation<As, Outcome>,
  signal: AbortSignal,
): Promise<{ readonly outcome: Outcome }> {
  const open = await openDatabase();
  signal.throwIfAborted();
  const transaction = open.transaction(STORES, mode, { durability: 'relaxed' });
  signal.addEventListener('abort', () => abort(transaction));
  try {
    const outcome = await operation(transaction);
    // Commit explicitly: it then completes even if the page is put into the back/forward cache.
    transaction.commit();
    await transaction.done;
    return { outcome };
  } catch (error) {
    abort(transaction);
    // Both errors have the same cause, but only one of them may be the `QuotaExceededError`.
    const transactionError: unknown = await transaction.done.then(
      () => undefined,
      (reason: unknown) => reason,
    );
    throw isFull(transactionError) ? transactionError : error;
  }
}

function abort(transaction: { abort(): void }): void {
  try {
    transaction.abort();
  } catch {
    // It has already finished.
  }
}

/** Whether the browser's storage quota is exceeded. */
export function isFull(error: unknown): boolean {
  return error instanceof DOMException && error.name === 'QuotaExceededError';
}

// ---- reading --------------------------------------------------------------------------------------

/** All programs, the last changed one first. */
export async function listPrograms(): Promise<readonly ProgramRow[]> {
  const rows = await read((transaction) => transaction.objectStore('programs').getAll());
  return rows.flatMap((row) => parseRow(row) ?? []).sort((a, b) => b.changed - a.changed);
}

export async function readRow(id: string): Promise<ProgramRow | undefined> {
  return parseRow(await read((transaction) => transaction.objectStore('programs').get(id)));
}

export async function readProgram(id: string): Promise<SavedProgram | undefined> {
  return parseProgram(await read((transaction) => transaction.objectStore('texts').get(id)));
}

/** The earlier states of a program, newest first. */
export async function readStates(id: string): Promise<readonly State[]> {
  const keys = await read((transaction) => transaction.objectStore('states').getAllKeys(keyRange(id)));
  return keys.map(([, time, length]) => ({ time, length })).sort((a, b) => b.time - a.time);
}

export async function readState(id: string, state: State): Promise<SavedProgram | undefined> {
  return parseProgram(await read((transaction) => transaction.objectStore('states').get(keyOf(id, state))));
}

/** All programs with their states, in the form of an exported file. */
export async function readAll(): Promise<readonly ExportedProgram[]> {
  const all = await listPrograms();
  return (await Promise.all(all.map(({ id }) => readExported(id)))).flatMap((one) => one ?? []);
}

/** One program with its states, in the form of an exported file. */
function readExported(id: string): Promise<ExportedProgram | undefined> {
  return read(async (transaction) => {
    const row = parseRow(await transaction.objectStore('programs').get(id));
    const program = parseProgram(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return undefined;
    const [keys, texts] = await Promise.all([
      transaction.objectStore('states').getAllKeys(keyRange(id)),
      transaction.objectStore('states').getAll(keyRange(id)),
    ]);
    const states = keys.flatMap(([, time], i) => {
      const saved = parseProgram(texts[i]);
      return saved === undefined ? [] : [{ time, program: saved }];
    });
    const { name, namedBy, created, changed } = row;
    return { id, name, namedBy, created, changed, program, states };
  });
}

// ---- changing -------------------------------------------------------------------------------------

type WriteOutcome =
  /** `superseded`: the list already had this entry, and another tab has changed the program since. */
  | { readonly kind: 'written'; readonly row: ProgramRow; readonly result: 'new' | 'updated' | 'same' | 'superseded' }
  /** Another tab has changed it since; nothing was written. */
  | { readonly kind: 'conflict'; readonly row: ProgramRow }
  | { readonly kind: 'too-many' };

interface WriteRequest extends Entry {
  /** The name derived from the program. */
  readonly name: string;
  /**
   * Whether the replaced text becomes an earlier state: if the last one is old enough (`in-time`), or always (`now`).
   */
  readonly state: 'in-time' | 'now';
}

export function writeProgram(request: WriteRequest): Promise<WriteOutcome> {
  return change((transaction) => write(transaction, request));
}

async function write(
  transaction: WriteTransaction,
  { id, tab, time, base, program, name, state }: WriteRequest,
): Promise<WriteOutcome> {
  const [programs, texts] = [transaction.objectStore('programs'), transaction.objectStore('texts')];
  const row = parseRow(await programs.get(id));
  const before = parseProgram(await texts.get(id));
  if (row === undefined || before === undefined) {
    if ((await programs.count()) >= LIMITS.programs) return { kind: 'too-many' };
    const created: ProgramRow = {
      id,
      name,
      namedBy: 'program',
      created: time,
      changed: time,
      revision: base + 1,
      tab,
      seen: { [tab]: time },
      length: program.text.length,
      words: searchWords(program.text),
    };
    await Promise.all([programs.put(created), texts.put(program, id)]);
    return { kind: 'written', row: created, result: 'new' };
  }
  // The list already had this entry of the journal.
  if ((row.seen[tab] ?? 0) >= time)
    return { kind: 'written', row, result: row.tab === tab || isSame(before, program) ? 'same' : 'superseded' };
  const seen = withSeen(row, tab, time);
  if (isSame(before, program)) {
    await programs.put({ ...row, seen });
    return { kind: 'written', row, result: 'same' };
  }
  if (row.revision !== base && row.tab !== tab) return { kind: 'conflict', row };
  // A text of another tab always becomes an earlier state, since this tab has not edited it.
  await saveState(transaction, row, before, time, row.tab === tab ? state : 'now');
  // Keep the old picture until there is a new one.
  const changed: ProgramRow = {
    ...row,
    name: row.namedBy === 'reader' ? row.name : name,
    changed: time,
    revision: row.revision + 1,
    tab,
    seen,
    length: program.text.length,
    words: searchWords(program.text),
  };
  await Promise.all([programs.put(changed), texts.put(program, id)]);
  return { kind: 'written', row: changed, result: 'updated' };
}

/**
 * Saves an entry that is in conflict with another tab's text as a separate program, with a name derived from the other.
 */
export function saveConflictCopy({ id, tab, time, program }: Entry): Promise<ProgramRow | 'too-many'> {
  const copyId = newId();
  return change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const all = (await programs.getAll()).flatMap((row) => parseRow(row) ?? []);
    const done = all.find((row) => row.id === copyId);
    if (done !== undefined) return done;
    if (all.length >= LIMITS.programs) return 'too-many';
    const existing = all.find((row) => row.id === id);
    const copy: ProgramRow = {
      id: copyId,
      name: uniqueName(
        existing?.name ?? '',
        all.map(({ name }) => name),
      ),
      namedBy: 'reader',
      created: time,
      changed: time,
      revision: 1,
      tab,
      seen: {},
      length: program.text.length,
      words: searchWords(program.text),
    };
    await Promise.all([programs.put(copy), transaction.objectStore('texts').put(program, copy.id)]);
    if (existing !== undefined) await programs.put({ ...existing, seen: withSeen(existing, tab, time) });
    return copy;
  });
}

async function saveState(
  transaction: WriteTransaction,
  { id, changed }: ProgramRow,
  before: SavedProgram,
  now: number,
  when: WriteRequest['state'],
): Promise<void> {
  const states = transaction.objectStore('states');
  const existing = (await states.getAllKeys(keyRange(id))).map(([, time, length]) => ({ time, length }));
  if (when === 'in-time' && !shouldKeepState(existing, now)) return;
  const added: State = { time: changed, length: before.text.length };
  await states.put(before, keyOf(id, added));
  const expired = statesToDelete([...existing, added], now);
  await Promise.all(expired.map((state) => states.delete(keyOf(id, state))));
}

/** Restores an earlier state; the replaced text becomes an earlier state. */
export async function restoreState(id: string, state: State): Promise<SavedProgram | undefined> {
  return change(async (transaction) => {
    const [row, saved] = await Promise.all([
      transaction.objectStore('programs').get(id),
      transaction.objectStore('states').get(keyOf(id, state)),
    ]);
    const [now, program] = [parseRow(row), parseProgram(saved)];
    if (now === undefined || program === undefined) return undefined;
    await write(transaction, {
      id,
      tab: TAB_ID,
      time: Math.max(Date.now(), now.changed + 1),
      base: now.revision,
      program,
      name: now.name,
      state: 'now',
    });
    return program;
  });
}

/** Sets the name of a program; an empty `name` restores the name derived from the program. */
export async function rename(id: string, name: string, derivedName: (program: SavedProgram) => string): Promise<void> {
  await change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const row = parseRow(await programs.get(id));
    const program = parseProgram(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return;
    await programs.put(
      name === '' ? { ...row, name: derivedName(program), namedBy: 'program' } : { ...row, name, namedBy: 'reader' },
    );
  });
}

/** Stores the picture of a revision, if that is still the newest. */
export async function savePicture(id: string, revision: number, picture: SmallPicture | undefined): Promise<void> {
  await change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const row = parseRow(await programs.get(id));
    if (row === undefined || row.revision !== revision) return;
    const { picture: _, ...rest } = row;
    await programs.put(picture === undefined ? rest : { ...rest, picture });
  });
}

/** Saves a copy as a separate program. */
export async function duplicate(id: string): Promise<ProgramRow | 'too-many' | undefined> {
  const copyId = newId();
  return change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const all = (await programs.getAll()).flatMap((row) => parseRow(row) ?? []);
    const done = all.find((row) => row.id === copyId);
    if (done !== undefined) return done;
    const row = all.find((one) => one.id === id);
    const program = parseProgram(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return undefined;
    if (all.length >= LIMITS.programs) return 'too-many';
    const now = Date.now();
    const copy: ProgramRow = {
      ...row,
      id: copyId,
      name: uniqueName(
        row.name,
        all.map(({ name }) => name),
      ),
      namedBy: 'reader',
      created: now,
      changed: now,
      revision: 1,
      tab: TAB_ID,
      seen: {},
    };
    await Promise.all([programs.put(copy), transaction.objectStore('texts').put(program, copy.id)]);
    return copy;
  });
}

/** Deletes a program with its states and returns them, for undo. */
export async function deleteProgram(id: string): Promise<ExportedProgram | undefined> {
  const deleted = await readExported(id);
  await change(async (transaction) => {
    await Promise.all([
      transaction.objectStore('programs').delete(id),
      transaction.objectStore('texts').delete(id),
      transaction.objectStore('states').delete(keyRange(id)),
    ]);
  });
  return deleted;
}

interface Imported {
  readonly added: number;
  readonly duplicates: number;
  readonly noRoom: number;
}

/** Adds programs; existing ones are not changed. */
export async function addPrograms(programs: readonly ExportedProgram[]): Promise<Imported> {
  const withCopyIds = programs.map((one) => ({ one, copyId: newId() }));
  return change(async (transaction) => {
    let [added, duplicates, noRoom] = [0, 0, 0];
    for (const { one, copyId } of withCopyIds) {
      const as = importMode(one, parseProgram(await transaction.objectStore('texts').get(one.id)));
      if (as === 'duplicate' || (await transaction.objectStore('programs').getKey(copyId)) !== undefined) duplicates++;
      else if ((await transaction.objectStore('programs').count()) >= LIMITS.programs) noRoom++;
      else {
        await add(transaction, as === 'new' ? one : { ...one, id: copyId });
        added++;
      }
    }
    return { added, duplicates, noRoom };
  });
}

async function add(
  transaction: WriteTransaction,
  { id, name, namedBy, created, changed, program, states }: ExportedProgram,
): Promise<void> {
  const row: ProgramRow = {
    id,
    name,
    namedBy,
    created,
    changed,
    revision: 1,
    tab: TAB_ID,
    seen: {},
    length: program.text.length,
    words: searchWords(program.text),
  };
  await Promise.all([transaction.objectStore('programs').put(row), transaction.objectStore('texts').put(program, id)]);
  const earlier = states.map((state) => ({ ...state, length: state.program.text.length }));
  const expired = new Set(statesToDelete(earlier, Date.now()));
  for (const state of earlier)
    if (!expired.has(state)) await transaction.objectStore('states').put(state.program, keyOf(id, state));
}

function keyOf(id: string, { time, length }: State): StateKey {
  return [id, time, length];
}

function keyRange(id: string): IDBKeyRange {
  return IDBKeyRange.bound([id], [id, []]);
}
