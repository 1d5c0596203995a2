// Which switches of the operator's panel a text gives something to do.
//
// In: a text. Out: the levels of the blocks marked with a slash, and the programs that begin in it. A quick look, not a
// reading: a switch shown in vain does nothing. Must not know: what is done with a marked block or a chosen program.

export interface ProgramHead {
  readonly number: number;
  /** As it is written: `O0002`. */
  readonly name: string;
}

export interface SwitchesInText {
  /** Levels in order, each once; a slash without a number is 1. */
  readonly blockSkip: readonly number[];
  /** In the order of the text, each once. */
  readonly programs: readonly ProgramHead[];
}

export const NO_SWITCHES: SwitchesInText = { blockSkip: [], programs: [] };

/** Nobody chooses among more. */
const PROGRAMS_LIMIT = 500;
/** What stands further along a line is not looked at. */
const LINE_LIMIT = 1_000;

const INTERESTING = /\/|[Oo:][ \t]*\d/;
const COMMENT = /\([^)]*\)?/g;
const HEAD = /^\s*(?:\/\d?\s*)*[O:]\s*(\d{1,8})/i;
const SLASH_AT_HEAD = /^\s*(?:N\s*\d+\s*)?\/([1-9])?/i;
const SLASH = /\/([1-9])?/g;
/** Where a slash is a division, unless it stands at the head. */
const EXPRESSION = /[#[=]/;

export function switchesIn(text: string): SwitchesInText {
  const levels = new Set<number>();
  const programs = new Map<number, ProgramHead>();
  for (let from = 0; from < text.length; ) {
    const at = text.indexOf('\n', from);
    const end = at < 0 ? text.length : at;
    const line = text.slice(from, Math.min(end, from + LINE_LIMIT));
    from = end + 1;
    if (!INTERESTING.test(line)) continue;
    for (const block of line.replace(COMMENT, ' ').split(';')) {
      for (const slash of EXPRESSION.test(block) ? [SLASH_AT_HEAD.exec(block)] : block.matchAll(SLASH)) {
        if (slash !== null) levels.add(Number(slash[1] ?? 1));
      }
      const head = HEAD.exec(block);
      if (head === null || programs.size >= PROGRAMS_LIMIT) continue;
      const digits = head[1] ?? '';
      if (!programs.has(Number(digits))) programs.set(Number(digits), { number: Number(digits), name: `O${digits}` });
    }
  }
  return { blockSkip: [...levels].sort((a, b) => a - b), programs: [...programs.values()] };
}
