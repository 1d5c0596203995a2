// Decides whether a change of the text makes it another program.
//
// The rule: it is another program if less than half of the old text remains, and the remaining text is less than half
// of the new text. What remains is the text that the change does not touch, or the lines that both texts contain,
// whichever is more: so a text that was edited in another application and pasted over the old one is still the same
// program. Only non-blank characters count. A change inside one line, of which something remains, never makes another
// program; nor does the first text in an empty editor. Must not know: G-code.

/** Only this many UTF-16 units of both texts are compared. */
const MAX_COMPARED_LENGTH = 200_000;

/** A range of the old text that the change removes. */
export interface Removed {
  readonly from: number;
  readonly to: number;
}

export function isAnotherProgram(before: string, after: string, removed: readonly Removed[]): boolean {
  const [old, now] = [before.slice(0, MAX_COMPARED_LENGTH), after.slice(0, MAX_COMPARED_LENGTH)];
  const all = weight(old);
  if (all === 0) return false;
  const removedTexts = removed.map(({ from, to }) => old.slice(from, to));
  const untouched = all - removedTexts.reduce((sum, piece) => sum + weight(piece), 0);
  if (2 * untouched >= all || (untouched > 0 && removedTexts.every((piece) => !piece.includes('\n')))) return false;
  const remaining = Math.max(untouched, commonWeight(old, now));
  return 2 * remaining < all && (2 * remaining < weight(now) || weight(now) === 0);
}

/** Whether at least half of the lines of a text, by their characters, are in the other one. */
export function isMostlyIn(text: string, other: string): boolean {
  const all = text.slice(0, MAX_COMPARED_LENGTH);
  return 2 * commonWeight(all, other.slice(0, MAX_COMPARED_LENGTH)) >= weight(all);
}

/** The number of characters in lines that both texts contain. */
function commonWeight(before: string, after: string): number {
  const lines = new Map<string, number>();
  for (const line of normalizedLines(before)) lines.set(line, (lines.get(line) ?? 0) + 1);
  let sum = 0;
  for (const line of normalizedLines(after)) {
    const left = lines.get(line) ?? 0;
    if (left === 0) continue;
    lines.set(line, left - 1);
    sum += line.length;
  }
  return sum;
}

/** The lines without blanks and in upper case. */
function normalizedLines(text: string): readonly string[] {
  return text.split('\n').map((line) => line.replace(/\s+/g, '').toUpperCase());
}

function weight(text: string): number {
  return text.length - (text.match(/\s/g)?.length ?? 0);
}
