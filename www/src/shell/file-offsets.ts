// Converts offsets that leave the element to offsets into the original text.
//
// In: rows with internal offsets, which count each line end as one unit; the text. Out: the same rows with offsets into
// the text with its own line ends (`opened.text`). Must not know: who receives the events.

import type { Program } from '../editor/program';
import { offsetsInFile } from '../files/line-ends';
import type { Diagnostic, Stroke } from '../protocol/protocol';

type Place = { readonly from: number; readonly to: number };

/** A stroke that the user has clicked. */
export function strokeInFile(stroke: Stroke, program: Program): Stroke {
  return withFileOffsets(
    offsetsInFile(program.lineEnds, () => program.text),
    stroke,
  );
}

/** The messages of a run, with their fixes. */
export function diagnosticsInFile(diagnostics: readonly Diagnostic[], program: Program): readonly Diagnostic[] {
  if (diagnostics.length === 0) return diagnostics;
  const offset = offsetsInFile(program.lineEnds, () => program.text);
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

function withFileOffsets<Row extends Place>(offset: (internalOffset: number) => number, row: Row): Row {
  return { ...row, from: offset(row.from), to: offset(row.to) };
}
