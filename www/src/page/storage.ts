// The data in `localStorage`: the journal of saved programs, the programs that are work on a task, and the user's
// settings.
//
// In and out: plain values. The journal has an entry for each program and tab, written synchronously; the list of
// programs (`own-programs-store.ts`) takes the entries over and removes them from the journal. The last entry stays:
// the page starts with it before the list is loaded. All stored data is untrusted: values of a wrong type are ignored.
// A browser that refuses to store (private mode, quota exceeded) is not an error: the caller gets `refused`. Must not
// know: the meaning of a program.

export interface SavedProgram {
  /** With the line ends of its file, if it was opened from one. */
  readonly text: string;
  /** The id of the example that it started from; empty if none. */
  readonly example: string;
  readonly control: string;
  readonly file?: { readonly name: string; readonly encoding: string };
  /** The setup, as in the element's attribute; empty if it has none. */
  readonly setup?: string;
  /** The switches, as in the element's attributes. */
  readonly blockSkip?: string;
  readonly program?: string;
}

/** A saved program, with its id in the list. */
export interface OwnProgram extends SavedProgram {
  readonly id?: string;
}

/** A program in the journal. */
export interface Entry {
  readonly id: string;
  /** The tab that wrote it: two tabs can have the same program. */
  readonly tab: string;
  /** When it was written, ms since 1970. */
  readonly time: number;
  /** The revision in the list that it was made from; 0 if it was never in the list. */
  readonly base: number;
  readonly program: SavedProgram;
}

interface Choices {
  readonly language?: string;
  readonly theme?: string;
  /** The hints that are still to be shown. */
  readonly hints?: string;
  /** The width of the program, in percent of the element. */
  readonly split?: string;
  /** Whether the description of the program is open. */
  readonly description?: string;
  /** Names of the commands used last, JSON. */
  readonly recent?: string;
  /** The text size, in percent. */
  readonly textSize?: string;
}

/** The only saved program, in versions of the page without a list. */
const LEGACY_KEY = `gcode-playground:program:${location.pathname}`;
const JOURNAL_PREFIX = `gcode-playground:journal:${location.pathname}:`;
/** The key of the entry that the page starts with. */
const LAST_KEY = `gcode-playground:last:${location.pathname}`;
/** The programs that are the work on a task. */
const WORKS_KEY = `gcode-playground:task:${location.pathname}`;
const CHOICES_KEY = 'gcode-playground:choices';
const CHOICE_NAMES = ['language', 'theme', 'hints', 'split', 'textSize', 'description', 'recent'] as const;
/** The format of `newId`. */
const ID = /^[\da-f]{16,32}$/;

/**
 * Maximum lengths of a program that is saved, and of one in the journal, in UTF-16 units: browsers store about five
 * million there.
 */
export const MAX_SAVED_LENGTH = 10_000_000;
export const MAX_JOURNAL_LENGTH = 2_000_000;

/** Maximum number of tasks with remembered work. */
const MAX_WORKS = 100;

/** The id of this tab, until it is reloaded. */
export const TAB_ID = newId();

/** A random id. Not `randomUUID`, which is missing on pages that are not served over HTTPS. */
export function newId(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(10)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The entry that the page starts with. */
export function readLastEntry(): Entry | undefined {
  migrateLegacy();
  return readEntry(parseString(readItem(LAST_KEY)));
}

/** All entries of the journal, of this tab and of others, which may be closed. */
export function readJournal(): readonly Entry[] {
  try {
    return Object.keys(localStorage)
      .filter((key) => key.startsWith(JOURNAL_PREFIX))
      .flatMap((key) => readEntry(key) ?? []);
  } catch {
    return [];
  }
}

/**
 * Writes a program of this tab into the journal, as the last entry. Removes `before`, the entry of another tab that it
 * replaces.
 */
export function saveInJournal({ id, time, base, program }: Omit<Entry, 'tab'>, before?: Entry): 'saved' | 'refused' {
  const key = keyOf({ id, tab: TAB_ID });
  const outcome = write(key, { time, base, ...program }) === 'saved' ? write(LAST_KEY, key) : 'refused';
  if (outcome === 'saved' && before !== undefined && before.id === id) removeEntry(before);
  return outcome;
}

/** The list contains this entry: removes it from the journal, unless it is the last one or was overwritten since. */
export function removeWritten(written: Pick<Entry, 'id' | 'tab' | 'time'>): 'removed' | 'kept' {
  if (isLast(written)) return 'kept';
  removeEntry(written);
  return 'removed';
}

/** The next visit starts without a program; the entry stays until the list contains it. */
export function clearLastEntry(): void {
  if (readItem(LAST_KEY) !== null) write(LAST_KEY, '');
}

/** Whether the last entry was never set: a first visit, or the browser has lost its data. */
export function hasNoLastEntry(): boolean {
  return readItem(LAST_KEY) === null;
}

/** Removes all entries of a deleted program. */
export function removeFromJournal(id: string): void {
  for (const entry of readJournal()) {
    if (entry.id !== id) continue;
    if (isLast(entry)) clearLastEntry();
    remove(keyOf(entry));
  }
}

/** The id of the user's work on a task; the list knows whether the program still exists. */
export function readWorkId(task: string): string | undefined {
  return readWorks().get(task);
}

/** `task`: a unique name of the task. */
export function saveWorkId(task: string, id: string): void {
  const all = readWorks();
  if (all.get(task) === id) return;
  // The newest one is last.
  all.delete(task);
  write(WORKS_KEY, Object.fromEntries([...all, [task, id]].slice(-MAX_WORKS)));
}

function readWorks(): Map<string, string> {
  return new Map(Object.entries(read(WORKS_KEY)).filter((one): one is [string, string] => isId(one[1])));
}

export function readChoices(): Choices {
  const all = read(CHOICES_KEY);
  return Object.fromEntries(CHOICE_NAMES.flatMap((name) => (typeof all[name] === 'string' ? [[name, all[name]]] : [])));
}

export function saveChoices(change: Choices): void {
  write(CHOICES_KEY, { ...readChoices(), ...change });
}

/** Validates a program from a store or a file; undefined if it is not one. */
export function parseProgram(value: unknown): SavedProgram | undefined {
  const { text, example, control, file, setup, blockSkip, program } = Object(value) as Partial<
    Record<keyof SavedProgram, unknown>
  >;
  if (typeof text !== 'string' || typeof example !== 'string' || typeof control !== 'string') return undefined;
  const { name, encoding } = Object(file) as Partial<Record<'name' | 'encoding', unknown>>;
  return {
    text,
    example,
    control,
    ...(typeof name === 'string' && typeof encoding === 'string' ? { file: { name, encoding } } : {}),
    ...(typeof setup === 'string' ? { setup } : {}),
    ...(typeof blockSkip === 'string' ? { blockSkip } : {}),
    ...(typeof program === 'string' ? { program } : {}),
  };
}

/** Migrates the program that was saved before the list existed to an entry, once. */
function migrateLegacy(): void {
  const program = parseProgram(read(LEGACY_KEY));
  if (program !== undefined && saveInJournal({ id: newId(), time: Date.now(), base: 0, program }) === 'saved')
    remove(LEGACY_KEY);
}

function keyOf({ id, tab }: Pick<Entry, 'id' | 'tab'>): string {
  return `${JOURNAL_PREFIX}${id}:${tab}`;
}

/** Validates the entry of a key, which may be from any source. */
function readEntry(key: string): Entry | undefined {
  if (!key.startsWith(JOURNAL_PREFIX)) return undefined;
  const [id = '', tab = ''] = key.slice(JOURNAL_PREFIX.length).split(':');
  const stored = read(key);
  const program = parseProgram(stored);
  const { time, base } = stored;
  if (program === undefined || !ID.test(id) || !ID.test(tab)) return undefined;
  return { id, tab, time: isCount(time) ? time : 0, base: isCount(base) ? base : 0, program };
}

function removeEntry(entry: Pick<Entry, 'id' | 'tab' | 'time'>): void {
  if (readEntry(keyOf(entry))?.time === entry.time) remove(keyOf(entry));
}

export function isId(value: unknown): value is string {
  return typeof value === 'string' && ID.test(value);
}

export function isCount(value: unknown): value is number {
  return typeof value === 'number' && Number.isSafeInteger(value) && value >= 0;
}

function isLast(entry: Pick<Entry, 'id' | 'tab'>): boolean {
  return parseString(readItem(LAST_KEY)) === keyOf(entry);
}

function parseString(text: string | null): string {
  try {
    return String(JSON.parse(text ?? '""'));
  } catch {
    return '';
  }
}

function readItem(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function read(key: string): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(key) ?? '{}');
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
  } catch {
    return {};
  }
}

function write(key: string, value: unknown): 'saved' | 'refused' {
  try {
    localStorage.setItem(key, JSON.stringify(value));
    return 'saved';
  } catch {
    return 'refused';
  }
}

function remove(key: string): void {
  try {
    localStorage.removeItem(key);
  } catch {
    // Storage is not available.
  }
}
