// Sorts and groups the problems of a run for the list.
//
// In: the diagnostics, and the user's filter and order. Out: groups: the problems of one rule with one code and one
// severity. Must not know: the subject of a rule, or how a group is shown.

import type { Diagnostic } from '../protocol/protocol';

export type Severity = Diagnostic['severity'];
export type Order = 'severity' | 'place';

/** Worst first. */
export const SEVERITIES: readonly Severity[] = ['error', 'warning', 'info'];

/** Filter and order of the problems. */
export interface ProblemFilter {
  readonly order: Order;
  /** Severities that are hidden. */
  readonly hiddenSeverities: ReadonlySet<Severity>;
  /** Slug of the only rule that is shown; undefined: all rules. */
  readonly rule: string | undefined;
}

/** In source order; never empty. */
export type Group = readonly [Diagnostic, ...Diagnostic[]];

export function groupProblems(
  diagnostics: readonly Diagnostic[],
  { order, hiddenSeverities, rule }: ProblemFilter,
): readonly Group[] {
  const found = new Map<string, [Diagnostic, ...Diagnostic[]]>();
  for (const diagnostic of diagnostics) {
    const { severity, code, slug } = diagnostic;
    if (hiddenSeverities.has(severity) || (rule !== undefined && slug !== rule)) continue;
    const key = `${severity} ${code} ${slug}`;
    const group = found.get(key);
    if (group === undefined) found.set(key, [diagnostic]);
    else group.push(diagnostic);
  }
  // The first problem of each group is its first in the text, so the groups are in source order.
  const all = [...found.values()];
  if (order === 'place') return all;
  return SEVERITIES.flatMap((severity) => all.filter(([first]) => first.severity === severity));
}

/** Number of problems of each rule, sorted by slug. */
export function countsByRule(diagnostics: readonly Diagnostic[]): ReadonlyMap<string, number> {
  const counts = new Map<string, number>();
  for (const { slug } of diagnostics) counts.set(slug, (counts.get(slug) ?? 0) + 1);
  return new Map([...counts].sort(([a], [b]) => (a < b ? -1 : 1)));
}
