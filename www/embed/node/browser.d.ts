import type {
  Converted,
  Diagnostic,
  Motion,
  Numbering,
  Part,
  ProgramDifference,
  ProgramForm,
  Summary,
} from './index.js';
import type { Setup } from './setup.js';

export type * from './index.js';

export interface AsyncOptions {
  /** The language of messages and drawings; default: English. */
  readonly language?: 'en' | 'zh' | 'ru';
  /** Ends a run: the promise is rejected with the reason of the signal. */
  readonly signal?: AbortSignal;
}

/** A function of a program, as the function of the same name for Node. Rejects as that throws. */
type OfProgram<R> = (text: string | Uint8Array, setup?: Setup | string, options?: AsyncOptions) => Promise<R>;

export declare const check: OfProgram<Diagnostic[]>;
export declare const motions: OfProgram<Motion[]>;
export declare const svg: OfProgram<string>;
export declare const summary: OfProgram<Summary>;
export declare const part: OfProgram<Part | undefined>;
export declare const expand: OfProgram<string>;
export declare const repair: OfProgram<string>;
export declare const format: OfProgram<string>;

export declare function renumber(
  text: string | Uint8Array,
  numbering?: Numbering,
  setup?: Setup | string,
  options?: AsyncOptions,
): Promise<string>;

export declare function convert(
  text: string | Uint8Array,
  form: ProgramForm,
  setup?: Setup | string,
  options?: AsyncOptions,
): Promise<Converted>;

export declare function diff(
  before: string | Uint8Array,
  after: string | Uint8Array,
  setup?: Setup | string,
  options?: AsyncOptions,
): Promise<ProgramDifference>;

export declare function clean(text: string | Uint8Array, options?: AsyncOptions): Promise<string[]>;
