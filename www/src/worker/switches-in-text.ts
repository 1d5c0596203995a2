// Finds the switches of the operator's panel that have an effect on a text.
//
// In: a text, in parts. Out: the block skip levels in it, and the programs that start in it. A quick search, not a
// parser: a switch that is shown needlessly does no harm. Must not know: the effect of a skipped block or a selected
// program.

import type { ProgramHead, SwitchesInText } from '../protocol/protocol';

/** Nobody would choose among more. */
const MAX_PROGRAMS = 500;
/** The rest of a longer line is not searched. */
const MAX_LINE_LENGTH = 1_000;

const CANDIDATE = /\/|[Oo:][ \t]*\d|</;
const COMMENT = /\([^)]*\)?/g;
const PROGRAM_NUMBER = /^\s*(?:\/\d?\s*)*[O:]\s*(\d{1,8})/i;
/** A program with a name instead of a number (`src/text/program_name.rs`). */
const PROGRAM_NAME = /^\s*(?:\/\d?\s*)*O?<([A-Z0-9+\-_. ]{1,32})>/i;
const SLASH_AT_START = /^\s*(?:N\s*\d+\s*)?\/([1-9])?/i;
const SLASH = /\/([1-9])?/g;
/**
 * A block with these characters contains an expression, where a slash is a division unless it is the first character.
 */
const EXPRESSION = /[#[=]/;

/** A quick test whether the lines can contain switches; most do not. */
export function mayContainSwitches(lines: string): boolean {
  return CANDIDATE.test(lines);
}

/** The number that the interpreter gives to a name: FNV-1a of its capital letters, above all O numbers. */
function numberOfName(name: string): number {
  const hash =
    [...name.toUpperCase()].reduce(
      (hash, character) => Math.imul(hash ^ character.charCodeAt(0), 0x01000193),
      0x811c9dc5,
    ) >>> 0;
  return 2 ** 30 + ((hash ^ (hash >>> 30)) & (2 ** 30 - 1));
}

export class SwitchFinder {
  readonly #levels = new Set<number>();
  readonly #programs = new Map<number, ProgramHead>();

  /** Searches the next complete lines of the text. */
  search(lines: string): void {
    if (!mayContainSwitches(lines)) return;
    for (let from = 0; from < lines.length; ) {
      const at = lines.indexOf('\n', from);
      const end = at < 0 ? lines.length : at;
      this.#searchLine(lines.slice(from, Math.min(end, from + MAX_LINE_LENGTH)));
      from = end + 1;
    }
  }

  /** The switches found until now. */
  get found(): SwitchesInText {
    return { blockSkip: [...this.#levels].sort((a, b) => a - b), programs: [...this.#programs.values()] };
  }

  #searchLine(line: string): void {
    if (!mayContainSwitches(line)) return;
    for (const block of line.replace(COMMENT, ' ').split(';')) {
      for (const slash of EXPRESSION.test(block) ? [SLASH_AT_START.exec(block)] : block.matchAll(SLASH)) {
        if (slash !== null) this.#levels.add(Number(slash[1] ?? 1));
      }
      const digits = PROGRAM_NUMBER.exec(block)?.[1];
      const name = PROGRAM_NAME.exec(block)?.[1]?.trim() ?? '';
      if (digits !== undefined) this.#add({ number: Number(digits), name: `O${digits}` });
      else if (name !== '') this.#add({ number: numberOfName(name), name: `<${name}>` });
    }
  }

  #add(program: ProgramHead): void {
    if (this.#programs.size < MAX_PROGRAMS && !this.#programs.has(program.number))
      this.#programs.set(program.number, program);
  }
}
