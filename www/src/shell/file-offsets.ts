// Converts offsets that leave the element to offsets into the original text.
//
// In: rows with internal offsets, which count each line end as one unit; the text. Out: the same rows with offsets into
// the text with its own line ends (`opened.text`), and the position of the cursor. Must not know: who receives the
// events.

import type { Program } from '../editor/program';
import { offsetsInFile } from '../files/line-ends';
import type { Diagnostic, Readout, Stroke } from '../protocol/protocol';

type Place = { readonly from: number; readonly to: number };
type ToFile = (internalOffset: number) => number;

/** The cursor for the page: line and column, in UTF-16 units, from 1. */
export interface CursorPlace {
  readonly line: number;
  readonly column: number;
  readonly offset: number;
}

/** The conversion of the newest text of each program: for a long text with CRLF it takes a search of the whole text. */
const conversions = new WeakMap<Program, { readonly revision: number; readonly toFile: ToFile }>();

function toFile(program: Program): ToFile {
  const { revision } = program;
  const known = conversions.get(program);
  if (known?.revision === revision) return known.toFile;
  const made = offsetsInFile(program.lineEnds, () => program.text);
  conversions.set(program, { revision, toFile: made });
  return made;
}

/** A stroke that the user has clicked. */
export function strokeInFile(stroke: Stroke, program: Program): Stroke {
  return withFileOffsets(toFile(program), stroke);
}

/** The position of the tool. */
export function readoutInFile(place: Readout, program: Program): Readout {
  const offset = toFile(program);
  const stop = place.stop && { stop: withFileOffsets(offset, place.stop) };
  return { ...place, stroke: withFileOffsets(offset, place.stroke), ...stop };
}

export function cursorInFile(program: Program): CursorPlace {
  const { cursor } = program;
  return {
    line: program.lineOf(cursor) + 1,
    column: cursor - program.lineStart(cursor) + 1,
    // A getter: after each key the conversion of a long text would be made again.
    get offset() {
      return toFile(program)(cursor);
    },
  };
}

/** The messages of a run, with their fixes. */
export function diagnosticsInFile(diagnostics: readonly Diagnostic[], program: Program): readonly Diagnostic[] {
  if (diagnostics.length === 0) return [];
  const offset = toFile(program);
  const { usual } = program.lineEnds;
  return diagnostics.map((diagnostic) =>
    withFileOffsets(offset, {
      ...diagnostic,
      fixes: diagnostic.fixes.map((fix) => ({
        ...fix,
        edits: fix.edits.map((edit) => withFileOffsets(offset, { ...edit, text: edit.text.replaceAll('\n', usual) })),
      })),
    }),
  );
}

function withFileOffsets<Row extends Place>(offset: ToFile, row: Row): Row {
  return { ...row, from: offset(row.from), to: offset(row.to) };
}
