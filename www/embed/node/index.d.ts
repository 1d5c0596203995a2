import type {
  Diagnostic,
  LeftWord,
  Motion,
  Part,
  ProgramDifference,
  ProgramForm,
  Summary,
} from './gcode_playground.js';
import type { Setup } from './setup.js';

export type { Diagnostic, LeftWord, Motion, Part, ProgramDifference, ProgramForm, Summary };
export type {
  Setup,
  SetupDialect,
  SetupLimits,
  SetupMachine,
  SetupPosition,
  SetupStock,
  SetupTailstock,
  SetupTool,
  SetupTravel,
} from './setup.js';

export interface Options {
  /** The language of messages and drawings; default: English. */
  readonly language?: 'en' | 'zh' | 'ru';
}

/**
 * The problems of a program, in source order, including collisions if the setup or the program defines a blank. `from`
 * and `to` of a message and of the edits of its fixes are UTF-16 offsets into `text` as passed: `text.slice(from, to)`.
 * `setup` contains everything that is not in the program, as an object or as JSON. Bytes must be UTF-8; offsets then
 * refer to the text that `TextDecoder` with `ignoreBOM: true` returns.
 *
 * @throws `Error` that names what is wrong with the setup.
 */
export function check(text: string | Uint8Array, setup?: Setup | string, options?: Options): Diagnostic[];

/** All motions of a program, lengths in mm, X as a diameter. Throws as `check` does. */
export function motions(text: string | Uint8Array, setup?: Setup | string, options?: Options): Motion[];

/** The drawing of a program with the finished part, as one `<svg>`. Throws as `check` does. */
export function svg(text: string | Uint8Array, setup?: Setup | string, options?: Options): string;

/** Counts, times and sizes of a run, with the finished part. Throws as `check` does. */
export function summary(text: string | Uint8Array, setup?: Setup | string, options?: Options): Summary;

/** The finished part as polygons of its half-section, mm; `undefined` without a blank. Throws as `check` does. */
export function part(text: string | Uint8Array, setup?: Setup | string, options?: Options): Part | undefined;

/** The program with every cycle, corner and compensation as plain moves. Throws as `check` does. */
export function expand(text: string | Uint8Array, setup?: Setup | string, options?: Options): string;

/** The program with all safe fixes, as `gcode-playground check --fix` writes it. Throws as `check` does. */
export function repair(text: string | Uint8Array, setup?: Setup | string, options?: Options): string;

/**
 * The program with blanks, case and leading zeros of G and M codes written uniformly. It is run before and after.
 *
 * @throws `Error` with line and reason if it would not be the same program, and as `check` does.
 */
export function format(text: string | Uint8Array, setup?: Setup | string, options?: Options): string;

export interface Numbering {
  /** The number of the first block; default: 10. */
  readonly from?: number;
  /** The difference between two numbers; default: 10. */
  readonly step?: number;
  /** The blocks that get a number; `none` removes the numbers that nothing refers to. Default: `numbered`. */
  readonly blocks?: 'numbered' | 'all' | 'none';
}

/**
 * The program with new sequence numbers; P, Q, GOTO, M97 and M99 P follow. It is run before and after.
 *
 * @throws `Error` with line and reason if the numbers stay, and as `check` does.
 */
export function renumber(
  text: string | Uint8Array,
  numbering?: Numbering,
  setup?: Setup | string,
  options?: Options,
): string;

export interface Converted {
  readonly text: string;
  /** Number of words that stay in their form. */
  readonly left: number;
  /** The first of them, or the block that prevents the conversion; `line` counts from 1. */
  readonly firstLeft: LeftWord | undefined;
}

/**
 * The program in another form: U and W as X and Z (`absolute`) or back (`incremental`), arcs by R (`radius`) or by I and
 * K (`center`), G71 to G76 in `one-block` or `two-blocks`, lengths in `mm` or `inch`, or the codes of another G-code
 * system. It is run before and after: the motions stay the same.
 *
 * @throws `Error` if the program is for another control, and as `check` does.
 */
export function convert(
  text: string | Uint8Array,
  form: ProgramForm,
  setup?: Setup | string,
  options?: Options,
): Converted;

/** The differences between two versions of a program. Throws as `check` does. */
export function diff(
  before: string | Uint8Array,
  after: string | Uint8Array,
  setup?: Setup | string,
  options?: Options,
): ProgramDifference;

/** The programs inside another text, such as a page of a manual, with the printed readings. */
export function clean(text: string | Uint8Array, options?: Options): string[];
