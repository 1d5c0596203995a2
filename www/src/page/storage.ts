// What the browser keeps in its small, synchronous store: the journal of the reader's programs, which of them is the work on
// a task, and the choices.
//
// In and out: plain values. The journal has an entry for each program and tab, written at once; the list of programs
// (`own-programs-store.ts`) takes entries over and lets go of them. The last one stays: the page begins with it,
// before the list is there. All that is read can have been written by anybody: what is of another type is not there.
// A browser that refuses to store (private mode, full) is no error here: the caller hears of it. Must not know: what a
// program is.

export interface KeptProgram {
  /** With the line ends of its file, if it is one's. */
  readonly text: string;
  /** The example it began as. */
  readonly example: string;
  readonly control: string;
  readonly file?: { readonly name: string; readonly encoding: string };
  /** The setup as the element's attribute; empty when it has none. */
  readonly setup?: string;
  /** The switches, as the element's attributes. */
  readonly blockSkip?: string;
  readonly program?: string;
}

/** A program of the list of the reader's own. */
export interface OwnProgram extends KeptProgram {
  readonly id?: string;
}

/** A program in the journal. */
export interface Entry {
  readonly id: string;
  /** The tab that wrote it: two can have the same program. */
  readonly tab: string;
  /** When it was written, ms since 1970. */
  readonly time: number;
  /** The revision of the list that it was made of; 0: the list has not had it. */
  readonly base: number;
  readonly program: KeptProgram;
}

export interface Choices {
  readonly language?: string;
  readonly theme?: string;
  /** The hints that are still to be shown. */
  readonly hints?: string;
  /** The share of the program in the width, percent. */
  readonly split?: string;
  /** The size of the type, percent. */
  readonly textSize?: string;
}

/** Where there was no list yet, the one program that was kept. */
const OF_BEFORE = `gcode-playground:program:${location.pathname}`;
const JOURNAL = `gcode-playground:journal:${location.pathname}:`;
/** Which entry the page begins with. */
const LAST = `gcode-playground:last:${location.pathname}`;
/** Which of the reader's programs is the work on a task. */
const WORKS = `gcode-playground:task:${location.pathname}`;
const CHOICES = 'gcode-playground:choices';
const CHOSEN = ['language', 'theme', 'hints', 'split', 'textSize'] as const;
/** As `newId` makes them. */
const ID = /^[\da-f]{16,32}$/;

/** Units of a program that is kept at all, and of one that the journal has room for: browsers keep about five million there. */
export const LONGEST_KEPT = 10_000_000;
export const LONGEST_IN_JOURNAL = 2_000_000;

/** Tasks whose work is remembered. */
const MOST_WORKS = 100;

/** This tab, as long as the page is there. */
export const TAB = newId();

/** A name that nothing else has. Not `randomUUID`, which pages without a certificate do not have. */
export function newId(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(10)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The entry the page begins with. */
export function lastEntry(): Entry | undefined {
  takeOver();
  return entry(unquoted(stored(LAST)));
}

/** All that waits in the journal, of this tab and of others, which may be gone. */
export function journal(): readonly Entry[] {
  try {
    return Object.keys(localStorage)
      .filter((key) => key.startsWith(JOURNAL))
      .flatMap((key) => entry(key) ?? []);
  } catch {
    return [];
  }
}

/** Writes a program of this tab into the journal, as the last one. Where `before` gave way to it, that is let go of. */
export function keepInJournal({ id, time, base, program }: Omit<Entry, 'tab'>, before?: Entry): 'kept' | 'refused' {
  const key = keyOf({ id, tab: TAB });
  const outcome = write(key, { time, base, ...program }) === 'kept' ? write(LAST, key) : 'refused';
  if (outcome === 'kept' && before !== undefined && before.id === id) forgetEntry(before);
  return outcome;
}

/** The list has this entry: it is let go of, unless it is the last one, or another has been written since. */
export function forgetWritten(written: Pick<Entry, 'id' | 'tab' | 'time'>): 'gone' | 'stays' {
  if (isLast(written)) return 'stays';
  forgetEntry(written);
  return 'gone';
}

/** The page begins afresh; the entry stays until the list has it. */
export function forgetLast(): void {
  if (stored(LAST) !== null) write(LAST, '');
}

/** Nothing says what the page begins with: it is the first time, or the browser has lost it. */
export function knowsNoLast(): boolean {
  return stored(LAST) === null;
}

/** The reader has deleted this program. */
export function forgetAllOf(id: string): void {
  for (const each of journal()) {
    if (each.id !== id) continue;
    if (isLast(each)) forgetLast();
    remove(keyOf(each));
  }
}

/** The program that is the reader's work on a task; whether it is still there, the list knows. */
export function workOf(task: string): string | undefined {
  return works().get(task);
}

/** `task`: what no other task is called. */
export function keepWorkOf(task: string, id: string): void {
  const all = works();
  if (all.get(task) === id) return;
  // The newest is the last one.
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

/** A program of whatever was stored, or stood in a file; nothing where it is none. */
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

/** The program that was kept before there was a list becomes an entry, once. */
function takeOver(): void {
  const program = programIn(read(OF_BEFORE));
  if (program !== undefined && keepInJournal({ id: newId(), time: Date.now(), base: 0, program }) === 'kept')
    remove(OF_BEFORE);
}

function keyOf({ id, tab }: Pick<Entry, 'id' | 'tab'>): string {
  return `${JOURNAL}${id}:${tab}`;
}

/** The entry of a key, which may come from anywhere. */
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
    // Nothing was kept.
  }
}
