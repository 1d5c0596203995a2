// The line ends of a text, apart from the text.
//
// In: a text as it is in its file. Out: the same with every line end as one unit, in pieces; which line ends
// they were. Must not know: bytes, the editor, or what the text is for.

export type LineEndText = '\n' | '\r\n' | '\r';

export interface LineEnds {
  readonly most: LineEndText;
  /** Those that are not as most are, in order; offsets into the folded text. */
  readonly others: readonly (readonly [at: number, end: LineEndText])[];
}

/** About as long as is read in one go without anybody noticing. */
const PIECE = 1 << 18;

/** The text with every line end as one unit. */
export function folded(text: string): string {
  return text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text;
}

export function lineEndsOf(text: string): LineEnds {
  if (!text.includes('\r')) return { most: '\n', others: [] };
  const counts = new Map<LineEndText, number>();
  const each = (visit: (end: LineEndText, at: number) => void): void => {
    let folded = 0;
    for (const match of text.matchAll(/\r\n?|\n/g)) {
      const end = match[0] as LineEndText;
      visit(end, match.index - folded);
      folded += end.length - 1;
    }
  };
  each((end) => counts.set(end, (counts.get(end) ?? 0) + 1));
  const [most] = [...counts].reduce((most, one) => (one[1] > most[1] ? one : most), ['\n', 0] as [LineEndText, number]);
  const others: [number, LineEndText][] = [];
  if (counts.size > 1) {
    each((end, at) => {
      if (end !== most) others.push([at, end]);
    });
  }
  return { most, others };
}

/** A folded text cut after line ends; a long line stays whole. */
export function inPieces(text: string): string[] {
  const pieces: string[] = [];
  let from = 0;
  do {
    const end = text.indexOf('\n', from + PIECE);
    const next = end < 0 ? text.length : end + 1;
    pieces.push(text.slice(from, next));
    from = next;
  } while (from < text.length);
  return pieces;
}

/** Offsets into the folded text as offsets into the text as it is in its file. */
export function offsetsInFile({ most, others }: LineEnds, text: () => string): (offset: number) => number {
  if (most !== '\r\n' && !others.some(([, end]) => end === '\r\n')) return (offset) => offset;
  const other = new Map(others);
  /** Folded offsets of the line ends of two units, in order. */
  const wide = [...text().matchAll(/\n/g)].map(({ index }) => index).filter((at) => (other.get(at) ?? most) === '\r\n');
  return (offset) => {
    let [low, high] = [0, wide.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (wide[middle]! < offset) low = middle + 1;
      else high = middle;
    }
    return offset + low;
  };
}
