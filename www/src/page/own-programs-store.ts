// The list of saved programs in IndexedDB (through `idb`, which makes promises of its events).
//
// In: programs with the revision they were made from. Out: the outcome; the list, texts, earlier states. Each change is
// one transaction over all stores that compares the revision, so tabs need no locks and never overwrite each other's
// text (`conflict`). A page in the back/forward cache closes the database and repeats its transactions afterwards.
// Loaded after the first picture. Must not know: the page, or the meaning of a program.

import { openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction } from 'idb';
import {
  importAs,
  isSame,
  isWorthAState,
  LIMITS,
  listedIn,
  nameBeside,
  superfluous,
  withSeen,
  wordsOf,
  type FiledProgram,
  type Listed,
  type State,
} from './own-programs';
import { newId, programIn, TAB, type Entry, type KeptProgram } from './storage';
import type { SmallPicture } from '../../small-picture';

type StateKey = [id: string, time: number, length: number];

interface Schema extends DBSchema {
  programs: { key: string; value: Listed };
  texts: { key: string; value: KeptProgram };
  states: { key: StateKey; value: KeptProgram };
}

type Stores = ['programs', 'texts', 'states'];
type Mode = 'readonly' | 'readwrite';
type Transaction<As extends Mode> = IDBPTransaction<Schema, Stores, As>;
type Writing = Transaction<'readwrite'>;
type Act<As extends Mode, Outcome> = (transaction: Transaction<As>) => Promise<Outcome>;

const NAME = `gcode-playground:programs:${location.pathname}`;
const STORES: Stores = ['programs', 'texts', 'states'];

/** Events of the database. */
export interface StoreEvents {
  /** The stored programs were deleted, or the browser has closed the database. */
  closed(): void;
}

let opened: Promise<IDBPDatabase<Schema>> | undefined;
let upgrading: { abort(): void } | undefined;
let events: StoreEvents = { closed: () => undefined };

export function listen(to: StoreEvents): void {
  events = to;
}

function database(): Promise<IDBPDatabase<Schema>> {
  if (opened !== undefined) return opened;
  const opening = openDB<Schema>(NAME, 1, {
    upgrade(db, _old, _new, transaction) {
      upgrading = transaction;
      db.createObjectStore('programs', { keyPath: 'id' });
      db.createObjectStore('texts');
      db.createObjectStore('states');
    },
    // Another tab wants to delete or upgrade the database: close it, and open it again on the next use.
    blocking(_now, _wanted, event) {
      (event.target as IDBDatabase).close();
      closed();
    },
    terminated: closed,
  });
  opened = opening;
  opening.catch(() => {
    if (opened === opening) opened = undefined;
  });
  return opening;
}

function closed(): void {
  opened = undefined;
  events.closed();
}

// A page in the back/forward cache receives no more database events (Firefox), and its open transactions block those on
// all other pages (WebKit). So it aborts all of them and repeats them when it is shown again. Meanwhile the journal
// contains the text; if it is too long for the journal, the page asks before it is left (`Keeping`). A committed
// transaction can be repeated without harm, because all of them are idempotent.

const running = new Set<AbortController>();
let away: Promise<void> | undefined;

addEventListener('pagehide', ({ persisted }) => {
  if (!persisted) return;
  away ??= new Promise((back) =>
    addEventListener(
      'pageshow',
      () => {
        away = undefined;
        back();
      },
      { once: true },
    ),
  );
  void opened?.then(
    (open) => open.close(),
    () => undefined,
  );
  opened = undefined;
  if (upgrading !== undefined) abort(upgrading);
  for (const attempt of running) attempt.abort();
});

function read<Outcome>(act: Act<'readonly', Outcome>): Promise<Outcome> {
  return inTransaction('readonly', act);
}

function change<Outcome>(act: Act<'readwrite', Outcome>): Promise<Outcome> {
  return inTransaction('readwrite', act);
}

async function inTransaction<As extends Mode, Outcome>(mode: As, act: Act<As, Outcome>): Promise<Outcome> {
  for (;;) {
    await away;
    const attempt = new AbortController();
    const { signal } = attempt;
    const letGo = new Promise<undefined>((end) => signal.addEventListener('abort', () => end(undefined)));
    running.add(attempt);
    try {
      const done = await Promise.race([transact(mode, act, signal), letGo]);
      if (done !== undefined) return done.outcome;
    } finally {
      running.delete(attempt);
    }
  }
}

async function transact<As extends Mode, Outcome>(
  mode: As,
  act: Act<As, Outcome>,
  signal: AbortSignal,
): Promise<{ readonly outcome: Outcome }> {
  const open = await database();
  signal.throwIfAborted();
  const transaction = open.transaction(STORES, mode, { durability: 'relaxed' });
  signal.addEventListener('abort', () => abort(transaction));
  try {
    const outcome = await act(transaction);
    // Commit explicitly: it then completes even if the page is put into the back/forward cache.
    transaction.commit();
    await transaction.done;
    return { outcome };
  } catch (error) {
    abort(transaction);
    // Both errors have the same cause, but only one of them may be the `QuotaExceededError`.
    const why: unknown = await transaction.done.then(
      () => undefined,
      (reason: unknown) => reason,
    );
    throw isFull(why) ? why : error;
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
export async function listPrograms(): Promise<readonly Listed[]> {
  const rows = await read((transaction) => transaction.objectStore('programs').getAll());
  return rows.flatMap((row) => listedIn(row) ?? []).sort((a, b) => b.changed - a.changed);
}

export async function listed(id: string): Promise<Listed | undefined> {
  return listedIn(await read((transaction) => transaction.objectStore('programs').get(id)));
}

export async function programOf(id: string): Promise<KeptProgram | undefined> {
  return programIn(await read((transaction) => transaction.objectStore('texts').get(id)));
}

/** The earlier states of a program, newest first. */
export async function statesOf(id: string): Promise<readonly State[]> {
  const keys = await read((transaction) => transaction.objectStore('states').getAllKeys(allOf(id)));
  return keys.map(([, time, length]) => ({ time, length })).sort((a, b) => b.time - a.time);
}

export async function programOfState(id: string, state: State): Promise<KeptProgram | undefined> {
  return programIn(await read((transaction) => transaction.objectStore('states').get(keyOf(id, state))));
}

/** All programs with their states, in the form of an exported file. */
export async function everything(): Promise<readonly FiledProgram[]> {
  const all = await listPrograms();
  return (await Promise.all(all.map(({ id }) => filed(id)))).flatMap((one) => one ?? []);
}

/** One program with its states, in the form of an exported file. */
export function filed(id: string): Promise<FiledProgram | undefined> {
  return read(async (transaction) => {
    const row = listedIn(await transaction.objectStore('programs').get(id));
    const program = programIn(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return undefined;
    const [keys, texts] = await Promise.all([
      transaction.objectStore('states').getAllKeys(allOf(id)),
      transaction.objectStore('states').getAll(allOf(id)),
    ]);
    const states = keys.flatMap(([, time], i) => {
      const then = programIn(texts[i]);
      return then === undefined ? [] : [{ time, program: then }];
    });
    const { name, namedBy, created, changed } = row;
    return { id, name, namedBy, created, changed, program, states };
  });
}

// ---- changing -------------------------------------------------------------------------------------

export type Written =
  /** `overtaken`: the list already had this entry, and another tab has changed the program since. */
  | { readonly kind: 'written'; readonly row: Listed; readonly was: 'new' | 'there' | 'same' | 'overtaken' }
  /** Another tab has changed it since; nothing was written. */
  | { readonly kind: 'conflict'; readonly row: Listed }
  | { readonly kind: 'too-many' };

export interface Wanted extends Entry {
  /** The name derived from the program. */
  readonly name: string;
  /**
   * Whether the replaced text becomes an earlier state: if the last one is old enough (`in-time`), or always (`now`).
   */
  readonly state: 'in-time' | 'now';
}

export function writeProgram(wanted: Wanted): Promise<Written> {
  return change((transaction) => write(transaction, wanted));
}

async function write(transaction: Writing, { id, tab, time, base, program, name, state }: Wanted): Promise<Written> {
  const [programs, texts] = [transaction.objectStore('programs'), transaction.objectStore('texts')];
  const row = listedIn(await programs.get(id));
  const before = programIn(await texts.get(id));
  if (row === undefined || before === undefined) {
    if ((await programs.count()) >= LIMITS.programs) return { kind: 'too-many' };
    const created: Listed = {
      id,
      name,
      namedBy: 'program',
      created: time,
      changed: time,
      revision: base + 1,
      tab,
      seen: { [tab]: time },
      length: program.text.length,
      words: wordsOf(program.text),
    };
    await Promise.all([programs.put(created), texts.put(program, id)]);
    return { kind: 'written', row: created, was: 'new' };
  }
  // The list already had this entry of the journal.
  if ((row.seen[tab] ?? 0) >= time)
    return { kind: 'written', row, was: row.tab === tab || isSame(before, program) ? 'same' : 'overtaken' };
  const seen = withSeen(row, tab, time);
  if (isSame(before, program)) {
    await programs.put({ ...row, seen });
    return { kind: 'written', row, was: 'same' };
  }
  if (row.revision !== base && row.tab !== tab) return { kind: 'conflict', row };
  // A text of another tab always becomes an earlier state, since this tab has not edited it.
  await keepState(transaction, row, before, time, row.tab === tab ? state : 'now');
  // Keep the old picture until there is a new one.
  const changed: Listed = {
    ...row,
    name: row.namedBy === 'reader' ? row.name : name,
    changed: time,
    revision: row.revision + 1,
    tab,
    seen,
    length: program.text.length,
    words: wordsOf(program.text),
  };
  await Promise.all([programs.put(changed), texts.put(program, id)]);
  return { kind: 'written', row: changed, was: 'there' };
}

/**
 * Saves an entry that is in conflict with another tab's text as a separate program, with a name derived from the other.
 */
export function writeBeside({ id, tab, time, program }: Entry): Promise<Listed | 'too-many'> {
  const idBeside = newId();
  return change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const all = (await programs.getAll()).flatMap((row) => listedIn(row) ?? []);
    const done = all.find((row) => row.id === idBeside);
    if (done !== undefined) return done;
    if (all.length >= LIMITS.programs) return 'too-many';
    const there = all.find((row) => row.id === id);
    const beside: Listed = {
      id: idBeside,
      name: nameBeside(
        there?.name ?? '',
        all.map(({ name }) => name),
      ),
      namedBy: 'reader',
      created: time,
      changed: time,
      revision: 1,
      tab,
      seen: {},
      length: program.text.length,
      words: wordsOf(program.text),
    };
    await Promise.all([programs.put(beside), transaction.objectStore('texts').put(program, beside.id)]);
    if (there !== undefined) await programs.put({ ...there, seen: withSeen(there, tab, time) });
    return beside;
  });
}

async function keepState(
  transaction: Writing,
  { id, changed }: Listed,
  before: KeptProgram,
  now: number,
  when: Wanted['state'],
): Promise<void> {
  const states = transaction.objectStore('states');
  const there = (await states.getAllKeys(allOf(id))).map(([, time, length]) => ({ time, length }));
  if (when === 'in-time' && !isWorthAState(there, now)) return;
  const added: State = { time: changed, length: before.text.length };
  await states.put(before, keyOf(id, added));
  const gone = superfluous([...there, added], now);
  await Promise.all(gone.map((state) => states.delete(keyOf(id, state))));
}

/** Restores an earlier state; the replaced text becomes an earlier state. */
export async function restoreState(id: string, state: State): Promise<KeptProgram | undefined> {
  return change(async (transaction) => {
    const [row, then] = await Promise.all([
      transaction.objectStore('programs').get(id),
      transaction.objectStore('states').get(keyOf(id, state)),
    ]);
    const [now, program] = [listedIn(row), programIn(then)];
    if (now === undefined || program === undefined) return undefined;
    await write(transaction, {
      id,
      tab: TAB,
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
export async function rename(id: string, name: string, byItself: (program: KeptProgram) => string): Promise<void> {
  await change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const row = listedIn(await programs.get(id));
    const program = programIn(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return;
    await programs.put(
      name === '' ? { ...row, name: byItself(program), namedBy: 'program' } : { ...row, name, namedBy: 'reader' },
    );
  });
}

/** Stores the picture of a revision, if that is still the newest. */
export async function keepPicture(id: string, revision: number, picture: SmallPicture | undefined): Promise<void> {
  await change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const row = listedIn(await programs.get(id));
    if (row === undefined || row.revision !== revision) return;
    const { picture: _, ...rest } = row;
    await programs.put(picture === undefined ? rest : { ...rest, picture });
  });
}

/** Saves a copy as a separate program. */
export async function duplicate(id: string): Promise<Listed | 'too-many' | undefined> {
  const idOfCopy = newId();
  return change(async (transaction) => {
    const programs = transaction.objectStore('programs');
    const all = (await programs.getAll()).flatMap((row) => listedIn(row) ?? []);
    const done = all.find((row) => row.id === idOfCopy);
    if (done !== undefined) return done;
    const row = all.find((one) => one.id === id);
    const program = programIn(await transaction.objectStore('texts').get(id));
    if (row === undefined || program === undefined) return undefined;
    if (all.length >= LIMITS.programs) return 'too-many';
    const now = Date.now();
    const copy: Listed = {
      ...row,
      id: idOfCopy,
      name: nameBeside(
        row.name,
        all.map(({ name }) => name),
      ),
      namedBy: 'reader',
      created: now,
      changed: now,
      revision: 1,
      tab: TAB,
      seen: {},
    };
    await Promise.all([programs.put(copy), transaction.objectStore('texts').put(program, copy.id)]);
    return copy;
  });
}

/** Deletes a program with its states and returns them, for undo. */
export async function deleteProgram(id: string): Promise<FiledProgram | undefined> {
  const whole = await filed(id);
  await change(async (transaction) => {
    await Promise.all([
      transaction.objectStore('programs').delete(id),
      transaction.objectStore('texts').delete(id),
      transaction.objectStore('states').delete(allOf(id)),
    ]);
  });
  return whole;
}

export interface Imported {
  readonly added: number;
  readonly alreadyThere: number;
  readonly noRoom: number;
}

/** Adds programs; existing ones are not changed. */
export async function addPrograms(programs: readonly FiledProgram[]): Promise<Imported> {
  const given = programs.map((one) => ({ one, idBeside: newId() }));
  return change(async (transaction) => {
    let [added, alreadyThere, noRoom] = [0, 0, 0];
    for (const { one, idBeside } of given) {
      const as = importAs(one, programIn(await transaction.objectStore('texts').get(one.id)));
      if (as === 'there-already' || (await transaction.objectStore('programs').getKey(idBeside)) !== undefined)
        alreadyThere++;
      else if ((await transaction.objectStore('programs').count()) >= LIMITS.programs) noRoom++;
      else {
        await add(transaction, as === 'new' ? one : { ...one, id: idBeside });
        added++;
      }
    }
    return { added, alreadyThere, noRoom };
  });
}

async function add(
  transaction: Writing,
  { id, name, namedBy, created, changed, program, states }: FiledProgram,
): Promise<void> {
  const row: Listed = {
    id,
    name,
    namedBy,
    created,
    changed,
    revision: 1,
    tab: TAB,
    seen: {},
    length: program.text.length,
    words: wordsOf(program.text),
  };
  await Promise.all([transaction.objectStore('programs').put(row), transaction.objectStore('texts').put(program, id)]);
  const earlier = states.map((state) => ({ ...state, length: state.program.text.length }));
  const gone = new Set(superfluous(earlier, Date.now()));
  for (const state of earlier)
    if (!gone.has(state)) await transaction.objectStore('states').put(state.program, keyOf(id, state));
}

function keyOf(id: string, { time, length }: State): StateKey {
  return [id, time, length];
}

function allOf(id: string): IDBKeyRange {
  return IDBKeyRange.bound([id], [id, []]);
}
