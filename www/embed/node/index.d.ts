import type { Diagnostic, Motion } from './gcode_playground.js';

export type { Diagnostic, Motion };

/** What is not in the program, as `docs/setup.html` of the site describes it: an object, or the same as JSON. */
export type Setup = object | string;

export interface Options {
  /** The language of messages and drawings; English if nothing is said. */
  readonly language?: 'en' | 'zh' | 'ru';
}

/**
 * What is wrong with a program, in the order of the text; collisions too, where the setup or the program names a blank.
 * `from` and `to` of a message and of the edits of its fixes are UTF-16 offsets into `text` as it was given: `text.slice(from, to)`.
 * Bytes are UTF-8; offsets then count in the text as `TextDecoder` with `ignoreBOM: true` decodes it. Throws an `Error` that names what is wrong with the setup.
 */
export function check(text: string | Uint8Array, setup?: Setup, options?: Options): Diagnostic[];

/** All motions of a program, lengths in mm, X as a diameter. Throws as `check` does. */
export function motions(text: string | Uint8Array, setup?: Setup, options?: Options): Motion[];

/** The drawing of a program with the finished part, as one `<svg>`. Throws as `check` does. */
export function svg(text: string | Uint8Array, setup?: Setup, options?: Options): string;
