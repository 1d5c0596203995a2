import type { Diagnostic, Motion } from './gcode_playground.js';
import type { Setup } from './setup.js';

export type { Diagnostic, Motion };
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
