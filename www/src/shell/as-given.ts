// Converts offsets that leave the element to offsets into the original text.
//
// In: rows with internal offsets, which count each line end as one unit; the text. Out: the same rows with offsets into
// the text with its own line ends (`opened.text`). Must not know: who receives the events.

import type { Program } from '../editor/program';
import { offsetsInFile } from '../files/line-ends';
import type { Diagnostic, Stroke } from '../protocol/protocol';

type Place = { readonly from: number; readonly to: number };

/** A stroke that the user has clicked. */
export function strokeAsGiven(stroke: Stroke, program: Program): Stroke {
  return placed(
    offsetsInFile(program.lineEnds, () => program.text),
    stroke,
  );
}

/** The messages of a run, with their fixes. */
export function diagnosticsAsGiven(diagnostics: readonly Diagnostic[], program: Program): readonly Diagnostic[] {
  if (diagnostics.length === 0) return diagnostics;
  const offset = offsetsInFile(program.lineEnds, () => program.text);
  const { most } = program.lineEnds;
  return diagnostics.map((found) =>
    placed(offset, {
      ...found,
      fixes: found.fixes.map((fix) => ({
        ...fix,
        edits: fix.edits.map((edit) => placed(offset, { ...edit, text: edit.text.replaceAll('\n', most) })),
      })),
    }),
  );
}

function placed<Row extends Place>(offset: (folded: number) => number, row: Row): Row {
  return { ...row, from: offset(row.from), to: offset(row.to) };
}
