// Separates the line ends from a text.
//
// In: the text of a file. Out: the text with folded line ends (each as `\n`), in pieces; and the original line ends.
// Must not know: bytes, the editor, or the purpose of the text.

export type LineEndText = '\n' | '\r\n' | '\r';

export interface LineEnds {
  readonly usual: LineEndText;
  /** Line ends that differ from `usual`, in order, as offsets into the folded text. */
  readonly exceptions: readonly (readonly [at: number, end: LineEndText])[];
}

/** UTF-16 units of a piece: short enough to be processed without a visible delay. */
const MIN_PIECE_LENGTH = 1 << 18;

/** The text with every line end as `\n`. */
export function foldLineEnds(text: string): string {
  return text.includes('\r') ? text.replace(/\r\n?/g, '\n') : text;
}

export function lineEndsOf(text: string): LineEnds {
  if (!text.includes('\r')) return { usual: '\n', exceptions: [] };
  const counts = new Map<LineEndText, number>();
  const forEachLineEnd = (visit: (end: LineEndText, at: number) => void): void => {
    let folded = 0;
    for (const match of text.matchAll(/\r\n?|\n/g)) {
      const end = match[0] as LineEndText;
      visit(end, match.index - folded);
      folded += end.length - 1;
    }
  };
  forEachLineEnd((end) => counts.set(end, (counts.get(end) ?? 0) + 1));
  const [usual] = [...counts].reduce((most, entry) => (entry[1] > most[1] ? entry : most), ['\n', 0] as [
    LineEndText,
    number,
  ]);
  const exceptions: [number, LineEndText][] = [];
  if (counts.size > 1) {
    forEachLineEnd((end, at) => {
      if (end !== usual) exceptions.push([at, end]);
    });
  }
  return { usual, exceptions };
}

/** Splits a folded text after line ends; long lines are not split. */
export function splitIntoPieces(text: string): string[] {
  const pieces: string[] = [];
  let from = 0;
  do {
    const end = text.indexOf('\n', from + MIN_PIECE_LENGTH);
    const next = end < 0 ? text.length : end + 1;
    pieces.push(text.slice(from, next));
    from = next;
  } while (from < text.length);
  return pieces;
}

/** Returns a function that maps offsets in the folded text to offsets in the file's text. */
export function offsetsInFile({ usual, exceptions }: LineEnds, text: () => string): (offset: number) => number {
  if (usual !== '\r\n' && !exceptions.some(([, end]) => end === '\r\n')) return (offset) => offset;
  const exceptionAt = new Map(exceptions);
  /** Folded offsets of the CRLF line ends, in order. */
  const crlfOffsets = [...text().matchAll(/\n/g)]
    .map(({ index }) => index)
    .filter((at) => (exceptionAt.get(at) ?? usual) === '\r\n');
  return (offset) => {
    let [low, high] = [0, crlfOffsets.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (crlfOffsets[middle]! < offset) low = middle + 1;
      else high = middle;
    }
    return offset + low;
  };
}
