// Whether a change of the text makes it another program, which has nothing to do with the one before.
//
// The rule: it is another one when less than half of the old text is left, and what is left is less than half
// of the new text. Left is what the change does not touch, or the lines that stand in the new text as well,
// whichever is more: a text that was edited elsewhere and is pasted over the old one is still the same program.
// What is counted are characters without blanks. A change inside one line, of which something stays, makes no
// other program, and nothing was there before a first text. Must not know: what is written.

/** The same number of units of both texts is looked at; a longer program shows early what it is. */
const LOOKED_AT = 200_000;

/** What a change takes out of the text before. */
export interface Removed {
  readonly from: number;
  readonly to: number;
}

export function isAnotherProgram(before: string, after: string, removed: readonly Removed[]): boolean {
  const [old, now] = [before.slice(0, LOOKED_AT), after.slice(0, LOOKED_AT)];
  const all = weight(old);
  if (all === 0) return false;
  const gone = removed.map(({ from, to }) => old.slice(from, to));
  const untouched = all - gone.reduce((sum, piece) => sum + weight(piece), 0);
  if (2 * untouched >= all || (untouched > 0 && gone.every((piece) => !piece.includes('\n')))) return false;
  const left = Math.max(untouched, weightInCommon(old, now));
  return 2 * left < all && (2 * left < weight(now) || weight(now) === 0);
}

/** How much stands in lines of both texts. */
function weightInCommon(before: string, after: string): number {
  const lines = new Map<string, number>();
  for (const line of inLines(before)) lines.set(line, (lines.get(line) ?? 0) + 1);
  let sum = 0;
  for (const line of inLines(after)) {
    const left = lines.get(line) ?? 0;
    if (left === 0) continue;
    lines.set(line, left - 1);
    sum += line.length;
  }
  return sum;
}

/** Blanks and small letters make no difference. */
function inLines(text: string): readonly string[] {
  return text.split('\n').map((line) => line.replace(/\s+/g, '').toUpperCase());
}

function weight(text: string): number {
  return text.length - (text.match(/\s/g)?.length ?? 0);
}
