// Separates the line ends from a text.
//
// In: the text of a file. Out: the text with folded line ends (each as `\n`), in pieces; and the original line ends.
// Must not know: bytes, the editor, or the purpose of the text.

export type LineEndText = '\n' | '\r\n' | '\r';

export interface LineEnds {
  readonly most: LineEndText;
  /** Line ends that differ from `most`, in order, as offsets into the folded text. */
  readonly others: readonly (readonly [at: number, end: LineEndText])[];
}

/** UTF-16 units of a piece: short enough to be processed without a visible delay. */
const PIECE = 1 << 18;

/** The text with every line end as `\n`. */
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

/** Splits a folded text after line ends; long lines are not split. */
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

/** Returns a function that maps offsets in the folded text to offsets in the file's text. */
export function offsetsInFile({ most, others }: LineEnds, text: () => string): (offset: number) => number {
  if (most !== '\r\n' && !others.some(([, end]) => end === '\r\n')) return (offset) => offset;
  const other = new Map(others);
  /** Folded offsets of the CRLF line ends, in order. */
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
