// Collects all safe fixes, to apply them together.
//
// In: the diagnostics of a run. Out: the edits of the first safe fix of each. Of fixes that touch the same text, only
// the first is applied, as in `src/repair.rs`. Must not know: the purpose of a fix.

import type { Diagnostic, Fix } from '../protocol/protocol';

type Edits = Fix['edits'];

/** Number of diagnostics with a safe fix. */
export function countSafeFixes(diagnostics: readonly Diagnostic[]): number {
  return diagnostics.filter(({ fixes }) => fixes.some(({ safe }) => safe)).length;
}

/** The edits in source order. */
export function safeEdits(diagnostics: readonly Diagnostic[]): Edits {
  const fixes = diagnostics.flatMap(({ fixes }) => fixes.find(({ safe, edits }) => safe && edits.length > 0) ?? []);
  const ranges = fixes.map(({ edits }) => ({ from: edits[0]!.from, to: edits.at(-1)!.to, edits }));
  ranges.sort((a, b) => a.from - b.from);
  const accepted: typeof ranges = [];
  for (const fix of ranges) {
    const last = accepted.at(-1);
    if (last === undefined || (last.to <= fix.from && last.from < fix.from)) accepted.push(fix);
  }
  return accepted.flatMap(({ edits }) => edits);
}
