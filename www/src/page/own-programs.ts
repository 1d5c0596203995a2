// The rules for saved programs: names, which earlier states are kept, and the format of an exported file.
//
// In: plain values; those from a file or a store are untrusted. Out: plain values. Uses no browser APIs. Must not know:
// how programs are stored or shown.

import type { SmallPicture } from '../../small-picture';
import { isCount, isId, LONGEST_KEPT, newId, programIn, type KeptProgram } from './storage';

/** A row of the list; the text of the program is stored separately. */
export interface Listed {
  readonly id: string;
  /** Empty if nothing in the program gives it a name. */
  readonly name: string;
  readonly namedBy: 'program' | 'reader';
  /** Times, ms since 1970. */
  readonly created: number;
  readonly changed: number;
  /** Incremented by each change in any tab. */
  readonly revision: number;
  /** The tab that made the last change. */
  readonly tab: string;
  /**
   * For each tab, the time of its newest journal entry in the list. Older entries can reappear after a browser was
   * killed.
   */
  readonly seen: Readonly<Record<string, number>>;
  /** Length of the text in UTF-16 units. */
  readonly length: number;
  /** Words for the search, besides the name. */
  readonly words: string;
  readonly picture?: SmallPicture;
}

/** An earlier text of a program: its time and its length. */
export interface State {
  readonly time: number;
  readonly length: number;
}

/** A program in an exported file. */
export interface FiledProgram {
  readonly id: string;
  readonly name: string;
  readonly namedBy: Listed['namedBy'];
  readonly created: number;
  readonly changed: number;
  readonly program: KeptProgram;
  readonly states: readonly { readonly time: number; readonly program: KeptProgram }[];
}

export const LIMITS = {
  programs: 1000,
  /** UTF-16 units of the text of one program. */
  length: LONGEST_KEPT,
  /** Earlier states of one program, and the UTF-16 units of all of them. */
  states: 100,
  stateUnits: 20_000_000,
  /** Bytes of an exported file. */
  file: 100_000_000,
  name: 120,
  /** Number of tabs in `seen` of a program. */
  tabs: 50,
} as const;

const SECOND = 1000;
const MINUTE = 60 * SECOND;
const DAY = 24 * 60 * MINUTE;
/** Minimum interval between earlier states. */
const BETWEEN_STATES = 15 * SECOND;
/** The minimum interval between the states that are kept, by their age. */
const KEPT_APART = [
  { upTo: 10 * MINUTE, apart: 0 },
  { upTo: DAY, apart: 10 * MINUTE },
  { upTo: Infinity, apart: DAY },
] as const;

/** Whether the replaced text becomes an earlier state. */
export function isWorthAState(states: readonly State[], now: number): boolean {
  return now - Math.max(0, ...states.map(({ time }) => time)) >= BETWEEN_STATES;
}

/** The states to delete. The last one of each period is kept, and of these the newest ones up to the limits. */
export function superfluous(states: readonly State[], now: number): readonly State[] {
  const newestFirst = [...states].sort((a, b) => b.time - a.time);
  const taken = new Set<string>();
  let [count, units] = [0, 0];
  return newestFirst.filter(({ time, length }) => {
    const { apart } = KEPT_APART.find(({ upTo }) => now - time < upTo) ?? KEPT_APART[2];
    const stretch = `${apart}:${apart === 0 ? time : Math.floor(time / apart)}`;
    if (taken.has(stretch) || count >= LIMITS.states || units + length > LIMITS.stateUnits) return true;
    taken.add(stretch);
    count += 1;
    units += length;
    return false;
  });
}

/** The name derived from a program: from its file, its example or its first line. */
export function nameOf({ text, file }: KeptProgram, exampleTitle: string | undefined): string {
  const numbered = /^[\s%]*[O:](\d{1,8})[^\S\n]*(?:\(([^)\n]*)\))?/.exec(text.slice(0, 1000));
  const [, number, comment = ''] = numbered ?? [];
  const byNumber = number === undefined ? '' : `O${number} ${comment.trim()}`.trim();
  const firstLine =
    text
      .slice(0, 1000)
      .split(/[\r\n]/)
      .map((line) => line.trim())
      .find((line) => line !== '' && line !== '%') ?? '';
  return cut(file?.name || exampleTitle || byNumber || firstLine);
}

/** A name in one line, truncated to the limit. */
export function cut(name: string): string {
  const plain = name.replace(/\s+/g, ' ').trim();
  return [...plain].slice(0, LIMITS.name).join('');
}

/** A name that is not in `names`: "Shaft (2)". */
export function nameBeside(name: string, names: readonly string[]): string {
  const stem = name.replace(/ \(\d{1,4}\)$/, '');
  for (let n = 2; ; n++) {
    const other = `${stem} (${n})`;
    if (!names.includes(other)) return other;
  }
}

/** The G, M and T words of a program, without repetitions, for the search. */
export function wordsOf(text: string): string {
  const written =
    text
      .slice(0, 50_000)
      .replace(/\([^)\n]*\)/g, '')
      .toUpperCase()
      .match(/[GMTO]\d+(?:\.\d+)?/g) ?? [];
  return [...new Set(written)].slice(0, 60).join(' ');
}

export function matches(of: Pick<Listed, 'name' | 'words'>, search: string): boolean {
  const text = `${of.name} ${of.words}`.toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((term) => text.includes(term));
}

/** Whether the texts and their contexts are equal. */
export function isSame(a: KeptProgram, b: KeptProgram): boolean {
  return a.text === b.text && JSON.stringify(contextOf(a)) === JSON.stringify(contextOf(b));
}

function contextOf({ example, control, file, setup, blockSkip, program }: KeptProgram): readonly unknown[] {
  return [example, control, file?.name, file?.encoding, setup ?? '', blockSkip, program];
}

/** Validates a stored row. */
export function listedIn(value: unknown): Listed | undefined {
  const { id, name, namedBy, created, changed, revision, tab, seen, length, words, picture } = Object(value) as Partial<
    Record<keyof Listed, unknown>
  >;
  if (!isId(id)) return undefined;
  const drawn = pictureIn(picture);
  return {
    id,
    name: typeof name === 'string' ? cut(name) : '',
    namedBy: namedBy === 'reader' ? 'reader' : 'program',
    created: timeIn(created),
    changed: timeIn(changed),
    revision: isCount(revision) ? revision : 0,
    tab: isId(tab) ? tab : '',
    seen: seenIn(seen),
    length: isCount(length) ? length : 0,
    words: typeof words === 'string' ? words : '',
    ...(drawn === undefined ? {} : { picture: drawn }),
  };
}

function seenIn(value: unknown): Listed['seen'] {
  const entries = Object.entries(Object(value) as Record<string, unknown>);
  return Object.fromEntries(
    entries.filter((entry): entry is [string, number] => isId(entry[0]) && isCount(entry[1])).slice(-LIMITS.tabs),
  );
}

/** Updates `seen` with the newest entry of a tab; removes the oldest tabs above the limit. */
export function withSeen({ seen }: Pick<Listed, 'seen'>, tab: string, time: number): Listed['seen'] {
  const others = Object.entries(seen)
    .filter(([other]) => other !== tab)
    .sort(([, a], [, b]) => a - b);
  return Object.fromEntries([...others.slice(1 - LIMITS.tabs), [tab, Math.max(time, seen[tab] ?? 0)]]);
}

function pictureIn(value: unknown): SmallPicture | undefined {
  const { rapid, cut: cutting, axis } = Object(value) as Partial<Record<keyof SmallPicture, unknown>>;
  if (typeof rapid !== 'string' || typeof cutting !== 'string') return undefined;
  return { rapid, cut: cutting, ...(typeof axis === 'number' ? { axis } : {}) };
}

/** Times out of the range of `Date` would make formatting throw. */
function timeIn(value: unknown): number {
  return isCount(value) && value < 8.64e15 ? value : 0;
}

// ---- files of programs ----------------------------------------------------------------------------

const FORMAT = 'gcode-playground programs';
const VERSION = 1;

export function fileOf(programs: readonly FiledProgram[]): string {
  return `${JSON.stringify({ format: FORMAT, version: VERSION, programs }, undefined, 1)}\n`;
}

export type ReadFile =
  | { readonly kind: 'programs'; readonly programs: readonly FiledProgram[]; readonly unreadable: number }
  | { readonly kind: 'another-format' | 'newer-version' };

export function readFile(text: string): ReadFile {
  let all: Partial<Record<'format' | 'version' | 'programs', unknown>>;
  try {
    all = Object(JSON.parse(text)) as typeof all;
  } catch {
    return { kind: 'another-format' };
  }
  if (all.format !== FORMAT || !Array.isArray(all.programs)) return { kind: 'another-format' };
  if (all.version !== VERSION) return { kind: 'newer-version' };
  const read = all.programs.map(filedIn);
  const programs = read.filter((one) => one !== undefined);
  return { kind: 'programs', programs, unreadable: read.length - programs.length };
}

function filedIn(value: unknown): FiledProgram | undefined {
  const {
    id,
    name,
    namedBy,
    created,
    changed,
    program: kept,
    states,
  } = Object(value) as Partial<Record<keyof FiledProgram, unknown>>;
  const program = programIn(kept);
  if (program === undefined || program.text.length > LIMITS.length) return undefined;
  const earlier = (Array.isArray(states) ? states.slice(0, LIMITS.states) : []).flatMap((state: unknown) => {
    const { time, program: then } = Object(state) as Partial<Record<'time' | 'program', unknown>>;
    const text = programIn(then);
    return text === undefined || text.text.length > LIMITS.length ? [] : [{ time: timeIn(time), program: text }];
  });
  return {
    id: isId(id) ? id : newId(),
    name: typeof name === 'string' ? cut(name) : nameOf(program, undefined),
    namedBy: namedBy === 'reader' ? 'reader' : 'program',
    created: timeIn(created),
    changed: timeIn(changed),
    program,
    states: earlier,
  };
}

/** How to import a program of a file; existing programs are never overwritten. */
export function importAs(filed: FiledProgram, there: KeptProgram | undefined): 'there-already' | 'new' | 'beside' {
  if (there === undefined) return 'new';
  return isSame(filed.program, there) ? 'there-already' : 'beside';
}
