// The data in `localStorage`: the journal of saved programs, the programs that are work on a task, and the user's
// settings.
//
// In and out: plain values. The journal has an entry for each program and tab, written synchronously; the list of
// programs (`own-programs-store.ts`) takes the entries over and removes them from the journal. The last entry stays:
// the page starts with it before the list is loaded. All stored data is untrusted: values of a wrong type are ignored.
// A browser that refuses to store (private mode, quota exceeded) is not an error: the caller gets `refused`. Must not
// know: the meaning of a program.

export interface KeptProgram {
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
export interface OwnProgram extends KeptProgram {
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
  readonly program: KeptProgram;
}

export interface Choices {
  readonly language?: string;
  readonly theme?: string;
  /** The hints that are still to be shown. */
  readonly hints?: string;
  /** The width of the program, in percent of the element. */
  readonly split?: string;
  /** The text size, in percent. */
  readonly textSize?: string;
}

/** The only saved program, in versions of the page without a list. */
const OF_BEFORE = `gcode-playground:program:${location.pathname}`;
const JOURNAL = `gcode-playground:journal:${location.pathname}:`;
/** The key of the entry that the page starts with. */
const LAST = `gcode-playground:last:${location.pathname}`;
/** The programs that are the work on a task. */
const WORKS = `gcode-playground:task:${location.pathname}`;
const CHOICES = 'gcode-playground:choices';
const CHOSEN = ['language', 'theme', 'hints', 'split', 'textSize'] as const;
/** The format of `newId`. */
const ID = /^[\da-f]{16,32}$/;

/**
 * Maximum lengths of a program that is saved, and of one in the journal, in UTF-16 units: browsers store about five
 * million there.
 */
export const LONGEST_KEPT = 10_000_000;
export const LONGEST_IN_JOURNAL = 2_000_000;

/** Maximum number of tasks with remembered work. */
const MOST_WORKS = 100;

/** The id of this tab, until it is reloaded. */
export const TAB = newId();

/** A random id. Not `randomUUID`, which is missing on pages that are not served over HTTPS. */
export function newId(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(10)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The entry that the page starts with. */
export function lastEntry(): Entry | undefined {
  takeOver();
  return entry(unquoted(stored(LAST)));
}

/** All entries of the journal, of this tab and of others, which may be closed. */
export function journal(): readonly Entry[] {
  try {
    return Object.keys(localStorage)
      .filter((key) => key.startsWith(JOURNAL))
      .flatMap((key) => entry(key) ?? []);
  } catch {
    return [];
  }
}

/**
 * Writes a program of this tab into the journal, as the last entry. Removes `before`, the entry of another tab that it
 * replaces.
 */
export function keepInJournal({ id, time, base, program }: Omit<Entry, 'tab'>, before?: Entry): 'kept' | 'refused' {
  const key = keyOf({ id, tab: TAB });
  const outcome = write(key, { time, base, ...program }) === 'kept' ? write(LAST, key) : 'refused';
  if (outcome === 'kept' && before !== undefined && before.id === id) forgetEntry(before);
  return outcome;
}

/** The list contains this entry: removes it from the journal, unless it is the last one or was overwritten since. */
export function forgetWritten(written: Pick<Entry, 'id' | 'tab' | 'time'>): 'gone' | 'stays' {
  if (isLast(written)) return 'stays';
  forgetEntry(written);
  return 'gone';
}

/** The next visit starts without a program; the entry stays until the list contains it. */
export function forgetLast(): void {
  if (stored(LAST) !== null) write(LAST, '');
}

/** Whether the last entry was never set: a first visit, or the browser has lost its data. */
export function knowsNoLast(): boolean {
  return stored(LAST) === null;
}

/** Removes all entries of a deleted program. */
export function forgetAllOf(id: string): void {
  for (const each of journal()) {
    if (each.id !== id) continue;
    if (isLast(each)) forgetLast();
    remove(keyOf(each));
  }
}

/** The id of the user's work on a task; the list knows whether the program still exists. */
export function workOf(task: string): string | undefined {
  return works().get(task);
}

/** `task`: a unique name of the task. */
export function keepWorkOf(task: string, id: string): void {
  const all = works();
  if (all.get(task) === id) return;
  // The newest one is last.
  all.delete(task);
  write(WORKS, Object.fromEntries([...all, [task, id]].slice(-MOST_WORKS)));
}

function works(): Map<string, string> {
  return new Map(Object.entries(read(WORKS)).filter((one): one is [string, string] => isId(one[1])));
}

export function choices(): Choices {
  const all = read(CHOICES);
  return Object.fromEntries(CHOSEN.flatMap((name) => (typeof all[name] === 'string' ? [[name, all[name]]] : [])));
}

export function keepChoices(change: Choices): void {
  write(CHOICES, { ...choices(), ...change });
}

/** Validates a program from a store or a file; undefined if it is not one. */
export function programIn(value: unknown): KeptProgram | undefined {
  const { text, example, control, file, setup, blockSkip, program } = Object(value) as Partial<
    Record<keyof KeptProgram, unknown>
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
function takeOver(): void {
  const program = programIn(read(OF_BEFORE));
  if (program !== undefined && keepInJournal({ id: newId(), time: Date.now(), base: 0, program }) === 'kept')
    remove(OF_BEFORE);
}

function keyOf({ id, tab }: Pick<Entry, 'id' | 'tab'>): string {
  return `${JOURNAL}${id}:${tab}`;
}

/** Validates the entry of a key, which may be from any source. */
function entry(key: string): Entry | undefined {
  if (!key.startsWith(JOURNAL)) return undefined;
  const [id = '', tab = ''] = key.slice(JOURNAL.length).split(':');
  const kept = read(key);
  const program = programIn(kept);
  const { time, base } = kept;
  if (program === undefined || !ID.test(id) || !ID.test(tab)) return undefined;
  return { id, tab, time: isCount(time) ? time : 0, base: isCount(base) ? base : 0, program };
}

function forgetEntry(which: Pick<Entry, 'id' | 'tab' | 'time'>): void {
  if (entry(keyOf(which))?.time === which.time) remove(keyOf(which));
}

export function isId(value: unknown): value is string {
  return typeof value === 'string' && ID.test(value);
}

export function isCount(value: unknown): value is number {
  return typeof value === 'number' && Number.isSafeInteger(value) && value >= 0;
}

function isLast(which: Pick<Entry, 'id' | 'tab'>): boolean {
  return unquoted(stored(LAST)) === keyOf(which);
}

function unquoted(text: string | null): string {
  try {
    return String(JSON.parse(text ?? '""'));
  } catch {
    return '';
  }
}

function stored(key: string): string | null {
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

function write(key: string, value: unknown): 'kept' | 'refused' {
  try {
    localStorage.setItem(key, JSON.stringify(value));
    return 'kept';
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
