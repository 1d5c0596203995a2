// The rules of the list of the reader's own programs: names, which earlier states stay, and what a file of programs
// may say.
//
// In: plain values, those of a file or a store being anybody's. Out: plain values. Nothing here asks the browser for
// anything. Must not know: how programs are stored or shown.

import type { SmallPicture } from '../../small-picture';
import { isCount, isId, LONGEST_KEPT, newId, programIn, type KeptProgram } from './storage';

/** What the list shows of a program; its text is stored beside it. */
export interface Listed {
  readonly id: string;
  /** Empty: nothing in the program names it. */
  readonly name: string;
  readonly namedBy: 'program' | 'reader';
  /** Times, ms since 1970. */
  readonly created: number;
  readonly changed: number;
  /** Grows with each change, whichever tab makes it. */
  readonly revision: number;
  /** The tab that made the last change. */
  readonly tab: string;
  /** Up to when the list has what each tab wrote into the journal: an older entry can come back when a browser is killed. */
  readonly seen: Readonly<Record<string, number>>;
  /** UTF-16 units of the text. */
  readonly length: number;
  /** Words that it is found by, beside its name. */
  readonly words: string;
  readonly picture?: SmallPicture;
}

/** An earlier text of a program: when it came to be, and how long it is. */
export interface State {
  readonly time: number;
  readonly length: number;
}

/** A program as a file has it. */
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
  /** Units of the text of one program. */
  length: LONGEST_KEPT,
  /** Earlier states of one program, and the units of all of them. */
  states: 100,
  stateUnits: 20_000_000,
  /** Bytes of a file of programs. */
  file: 100_000_000,
  name: 120,
  /** Tabs whose entries are remembered, of one program. */
  tabs: 50,
} as const;

const SECOND = 1000;
const MINUTE = 60 * SECOND;
const DAY = 24 * 60 * MINUTE;
/** An earlier state is kept when the one before it is older than this. */
const BETWEEN_STATES = 15 * SECOND;
/** How old states may be, and how far apart those are that stay. */
const KEPT_APART = [
  { upTo: 10 * MINUTE, apart: 0 },
  { upTo: DAY, apart: 10 * MINUTE },
  { upTo: Infinity, apart: DAY },
] as const;

/** Whether the text that is about to be replaced becomes an earlier state. */
export function isWorthAState(states: readonly State[], now: number): boolean {
  return now - Math.max(0, ...states.map(({ time }) => time)) >= BETWEEN_STATES;
}

/** The states that go: of each stretch of time the last one stays, and of all the newest, up to the limits. */
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

/** What a program is called by itself: after its file, its example, or its first line. */
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

/** A name as the list takes it. */
export function cut(name: string): string {
  const plain = name.replace(/\s+/g, ' ').trim();
  return [...plain].slice(0, LIMITS.name).join('');
}

/** A name that none of these has: "Shaft (2)". */
export function nameBeside(name: string, names: readonly string[]): string {
  const stem = name.replace(/ \(\d{1,4}\)$/, '');
  for (let n = 2; ; n++) {
    const other = `${stem} (${n})`;
    if (!names.includes(other)) return other;
  }
}

/** The G, M and T words of a program, each once: it is found by them. */
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

/** The same text under the same conditions. */
export function isSame(a: KeptProgram, b: KeptProgram): boolean {
  return a.text === b.text && JSON.stringify(contextOf(a)) === JSON.stringify(contextOf(b));
}

function contextOf({ example, control, file, setup, blockSkip, program }: KeptProgram): readonly unknown[] {
  return [example, control, file?.name, file?.encoding, setup ?? '', blockSkip, program];
}

/** A row of the list, of whatever was stored. */
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

/** With what the list has now of a tab, which is the newest of all. */
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

/** Times that no date has would stop the list from being shown. */
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

/** What is done with each program of a file: nothing there is overwritten. */
export function importAs(filed: FiledProgram, there: KeptProgram | undefined): 'there-already' | 'new' | 'beside' {
  if (there === undefined) return 'new';
  return isSame(filed.program, there) ? 'there-already' : 'beside';
}
