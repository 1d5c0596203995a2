// The rules for saved programs: names, which earlier states are kept, and the format of an exported file.
//
// In: plain values; those from a file or a store are untrusted. Out: plain values. Uses no browser APIs. Must not know:
// how programs are stored or shown.

import type { SmallPicture } from '../../small-picture';
import { isCount, isId, MAX_SAVED_LENGTH, newId, parseProgram, type SavedProgram } from './storage';

/** A row of the list; the text of the program is stored separately. */
export interface ProgramRow {
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
export interface ExportedProgram {
  readonly id: string;
  readonly name: string;
  readonly namedBy: ProgramRow['namedBy'];
  readonly created: number;
  readonly changed: number;
  readonly program: SavedProgram;
  readonly states: readonly { readonly time: number; readonly program: SavedProgram }[];
}

export const LIMITS = {
  programs: 1000,
  /** UTF-16 units of the text of one program. */
  length: MAX_SAVED_LENGTH,
  /** Earlier states of one program, and the UTF-16 units of all of them. */
  states: 100,
  stateUnits: 20_000_000,
  /** Bytes of an exported file. */
  file: 100_000_000,
  name: 120,
  /** Number of tabs in `seen` of a program. */
  tabs: 50,
} as const;

const SECOND_MS = 1000;
const MINUTE_MS = 60 * SECOND_MS;
const DAY_MS = 24 * 60 * MINUTE_MS;
/** Minimum interval between earlier states. */
const MIN_STATE_INTERVAL_MS = 15 * SECOND_MS;
/** The minimum interval between the states that are kept, by their age. */
const STATE_INTERVALS = [
  { maxAgeMs: 10 * MINUTE_MS, intervalMs: 0 },
  { maxAgeMs: DAY_MS, intervalMs: 10 * MINUTE_MS },
  { maxAgeMs: Infinity, intervalMs: DAY_MS },
] as const;

/** Whether the replaced text becomes an earlier state. */
export function shouldKeepState(states: readonly State[], now: number): boolean {
  return now - Math.max(0, ...states.map(({ time }) => time)) >= MIN_STATE_INTERVAL_MS;
}

/** The states to delete. The last one of each period is kept, and of these the newest ones up to the limits. */
export function statesToDelete(states: readonly State[], now: number): readonly State[] {
  const newestFirst = [...states].sort((a, b) => b.time - a.time);
  const takenPeriods = new Set<string>();
  let [count, units] = [0, 0];
  return newestFirst.filter(({ time, length }) => {
    const { intervalMs } = STATE_INTERVALS.find(({ maxAgeMs }) => now - time < maxAgeMs) ?? STATE_INTERVALS[2];
    const period = `${intervalMs}:${intervalMs === 0 ? time : Math.floor(time / intervalMs)}`;
    if (takenPeriods.has(period) || count >= LIMITS.states || units + length > LIMITS.stateUnits) return true;
    takenPeriods.add(period);
    count += 1;
    units += length;
    return false;
  });
}

/** The name derived from a program: from its file, its example or its first line. */
export function nameOf({ text, file }: SavedProgram, exampleTitle: string | undefined): string {
  const match = /^[\s%]*[O:](\d{1,8})[^\S\n]*(?:\(([^)\n]*)\))?/.exec(text.slice(0, 1000));
  const [, number, comment = ''] = match ?? [];
  const numberedName = number === undefined ? '' : `O${number} ${comment.trim()}`.trim();
  const firstLine =
    text
      .slice(0, 1000)
      .split(/[\r\n]/)
      .map((line) => line.trim())
      .find((line) => line !== '' && line !== '%') ?? '';
  return shortenName(file?.name || exampleTitle || numberedName || firstLine);
}

/** A name in one line, truncated to the limit. */
export function shortenName(name: string): string {
  const plain = name.replace(/\s+/g, ' ').trim();
  return [...plain].slice(0, LIMITS.name).join('');
}

/** A name that is not in `names`: "Shaft (2)". */
export function uniqueName(name: string, names: readonly string[]): string {
  const baseName = name.replace(/ \(\d{1,4}\)$/, '');
  for (let n = 2; ; n++) {
    const candidate = `${baseName} (${n})`;
    if (!names.includes(candidate)) return candidate;
  }
}

/** The G, M and T words of a program, without repetitions, for the search. */
export function searchWords(text: string): string {
  const written =
    text
      .slice(0, 50_000)
      .replace(/\([^()\n]*\)/g, '')
      .toUpperCase()
      .match(/[GMTO]\d+(?:\.\d+)?/g) ?? [];
  return [...new Set(written)].slice(0, 60).join(' ');
}

export function matches(of: Pick<ProgramRow, 'name' | 'words'>, search: string): boolean {
  const text = `${of.name} ${of.words}`.toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((term) => text.includes(term));
}

/** Whether the texts and their contexts are equal. */
export function isSame(a: SavedProgram, b: SavedProgram): boolean {
  return a.text === b.text && JSON.stringify(contextOf(a)) === JSON.stringify(contextOf(b));
}

function contextOf({ example, control, file, setup, blockSkip, program }: SavedProgram): readonly unknown[] {
  return [example, control, file?.name, file?.encoding, setup ?? '', blockSkip, program];
}

/** Validates a stored row. */
export function parseRow(value: unknown): ProgramRow | undefined {
  const { id, name, namedBy, created, changed, revision, tab, seen, length, words, picture } = Object(value) as Partial<
    Record<keyof ProgramRow, unknown>
  >;
  if (!isId(id)) return undefined;
  const drawn = parsePicture(picture);
  return {
    id,
    name: typeof name === 'string' ? shortenName(name) : '',
    namedBy: namedBy === 'reader' ? 'reader' : 'program',
    created: parseTime(created),
    changed: parseTime(changed),
    revision: isCount(revision) ? revision : 0,
    tab: isId(tab) ? tab : '',
    seen: parseSeen(seen),
    length: isCount(length) ? length : 0,
    words: typeof words === 'string' ? words : '',
    ...(drawn === undefined ? {} : { picture: drawn }),
  };
}

function parseSeen(value: unknown): ProgramRow['seen'] {
  const entries = Object.entries(Object(value) as Record<string, unknown>);
  return Object.fromEntries(
    entries.filter((entry): entry is [string, number] => isId(entry[0]) && isCount(entry[1])).slice(-LIMITS.tabs),
  );
}

/** Updates `seen` with the newest entry of a tab; removes the oldest tabs above the limit. */
export function withSeen({ seen }: Pick<ProgramRow, 'seen'>, tab: string, time: number): ProgramRow['seen'] {
  const others = Object.entries(seen)
    .filter(([candidate]) => candidate !== tab)
    .sort(([, a], [, b]) => a - b);
  return Object.fromEntries([...others.slice(1 - LIMITS.tabs), [tab, Math.max(time, seen[tab] ?? 0)]]);
}

function parsePicture(value: unknown): SmallPicture | undefined {
  const { rapid, cut: cutting, axis } = Object(value) as Partial<Record<keyof SmallPicture, unknown>>;
  if (typeof rapid !== 'string' || typeof cutting !== 'string') return undefined;
  return { rapid, cut: cutting, ...(typeof axis === 'number' ? { axis } : {}) };
}

/** Times out of the range of `Date` would make formatting throw. */
function parseTime(value: unknown): number {
  return isCount(value) && value < 8.64e15 ? value : 0;
}

// ---- files of programs ----------------------------------------------------------------------------

const FORMAT = 'gcode-playground programs';
const VERSION = 1;

export function toExportFile(programs: readonly ExportedProgram[]): string {
  return `${JSON.stringify({ format: FORMAT, version: VERSION, programs }, undefined, 1)}\n`;
}

type ParsedExportFile =
  | { readonly kind: 'programs'; readonly programs: readonly ExportedProgram[]; readonly unreadable: number }
  | { readonly kind: 'another-format' | 'newer-version' };

export function parseExportFile(text: string): ParsedExportFile {
  let all: Partial<Record<'format' | 'version' | 'programs', unknown>>;
  try {
    all = Object(JSON.parse(text)) as typeof all;
  } catch {
    return { kind: 'another-format' };
  }
  if (all.format !== FORMAT || !Array.isArray(all.programs)) return { kind: 'another-format' };
  if (all.version !== VERSION) return { kind: 'newer-version' };
  const read = all.programs.map(parseExported);
  const programs = read.filter((one) => one !== undefined);
  return { kind: 'programs', programs, unreadable: read.length - programs.length };
}

function parseExported(value: unknown): ExportedProgram | undefined {
  const {
    id,
    name,
    namedBy,
    created,
    changed,
    program: stored,
    states,
  } = Object(value) as Partial<Record<keyof ExportedProgram, unknown>>;
  const program = parseProgram(stored);
  if (program === undefined || program.text.length > LIMITS.length) return undefined;
  const earlier = (Array.isArray(states) ? states.slice(0, LIMITS.states) : []).flatMap((state: unknown) => {
    const { time, program: then } = Object(state) as Partial<Record<'time' | 'program', unknown>>;
    const text = parseProgram(then);
    return text === undefined || text.text.length > LIMITS.length ? [] : [{ time: parseTime(time), program: text }];
  });
  return {
    id: isId(id) ? id : newId(),
    name: typeof name === 'string' ? shortenName(name) : nameOf(program, undefined),
    namedBy: namedBy === 'reader' ? 'reader' : 'program',
    created: parseTime(created),
    changed: parseTime(changed),
    program,
    states: earlier,
  };
}

/** How to import a program of a file; existing programs are never overwritten. */
export function importMode(filed: ExportedProgram, existing: SavedProgram | undefined): 'duplicate' | 'new' | 'copy' {
  if (existing === undefined) return 'new';
  return isSame(filed.program, existing) ? 'duplicate' : 'copy';
}
