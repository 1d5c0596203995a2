// Finds the switches of the operator's panel that have an effect on a text.
//
// In: a text, in parts. Out: the block skip levels in it, and the programs that start in it. A quick search, not a
// parser: a switch that is shown needlessly does no harm. Must not know: the effect of a skipped block or a selected
// program.

import type { ProgramHead, SwitchesInText } from '../protocol/protocol';

/** Nobody would choose among more. */
const PROGRAMS_LIMIT = 500;
/** The rest of a longer line is not searched. */
const LINE_LIMIT = 1_000;

const INTERESTING = /\/|[Oo:][ \t]*\d|</;
const COMMENT = /\([^)]*\)?/g;
const HEAD = /^\s*(?:\/\d?\s*)*[O:]\s*(\d{1,8})/i;
/** A program with a name instead of a number (`src/text/program_name.rs`). */
const NAME = /^\s*(?:\/\d?\s*)*O?<([A-Z0-9+\-_. ]{1,32})>/i;
const SLASH_AT_HEAD = /^\s*(?:N\s*\d+\s*)?\/([1-9])?/i;
const SLASH = /\/([1-9])?/g;
/**
 * A block with these characters contains an expression, where a slash is a division unless it is the first character.
 */
const EXPRESSION = /[#[=]/;

/** A quick test whether the lines can contain switches; most do not. */
export function mayTellOfSwitches(lines: string): boolean {
  return INTERESTING.test(lines);
}

/** The number that the interpreter gives to a name: FNV-1a of its capital letters, above all O numbers. */
function numberOf(name: string): number {
  const hash =
    [...name.toUpperCase()].reduce((hash, sign) => Math.imul(hash ^ sign.charCodeAt(0), 0x01000193), 0x811c9dc5) >>> 0;
  return 2 ** 30 + ((hash ^ (hash >>> 30)) & (2 ** 30 - 1));
}

export class SwitchFinder {
  readonly #levels = new Set<number>();
  readonly #programs = new Map<number, ProgramHead>();

  /** Searches the next complete lines of the text. */
  look(lines: string): void {
    if (!mayTellOfSwitches(lines)) return;
    for (let from = 0; from < lines.length; ) {
      const at = lines.indexOf('\n', from);
      const end = at < 0 ? lines.length : at;
      this.#lookAtLine(lines.slice(from, Math.min(end, from + LINE_LIMIT)));
      from = end + 1;
    }
  }

  /** The switches found until now. */
  get found(): SwitchesInText {
    return { blockSkip: [...this.#levels].sort((a, b) => a - b), programs: [...this.#programs.values()] };
  }

  #lookAtLine(line: string): void {
    if (!mayTellOfSwitches(line)) return;
    for (const block of line.replace(COMMENT, ' ').split(';')) {
      for (const slash of EXPRESSION.test(block) ? [SLASH_AT_HEAD.exec(block)] : block.matchAll(SLASH)) {
        if (slash !== null) this.#levels.add(Number(slash[1] ?? 1));
      }
      const digits = HEAD.exec(block)?.[1];
      const name = NAME.exec(block)?.[1]?.trim() ?? '';
      if (digits !== undefined) this.#add({ number: Number(digits), name: `O${digits}` });
      else if (name !== '') this.#add({ number: numberOf(name), name: `<${name}>` });
    }
  }

  #add(program: ProgramHead): void {
    if (this.#programs.size < PROGRAMS_LIMIT && !this.#programs.has(program.number))
      this.#programs.set(program.number, program);
  }
}
