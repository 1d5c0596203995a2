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
  /** The language of messages and drawings; English if nothing is said. */
  readonly language?: 'en' | 'zh' | 'ru';
}

/**
 * What is wrong with a program, in the order of the text; collisions too, where the setup or the program names a blank.
 * `from` and `to` of a message and of the edits of its fixes are UTF-16 offsets into `text` as it was given: `text.slice(from, to)`.
 * `setup` is what is not in the program, as an object or as JSON. Bytes are UTF-8; offsets then count in the text as `TextDecoder` with `ignoreBOM: true` decodes it. Throws an `Error` that names what is wrong with the setup.
 */
export function check(text: string | Uint8Array, setup?: Setup | string, options?: Options): Diagnostic[];

/** All motions of a program, lengths in mm, X as a diameter. Throws as `check` does. */
export function motions(text: string | Uint8Array, setup?: Setup | string, options?: Options): Motion[];

/** The drawing of a program with the finished part, as one `<svg>`. Throws as `check` does. */
export function svg(text: string | Uint8Array, setup?: Setup | string, options?: Options): string;
