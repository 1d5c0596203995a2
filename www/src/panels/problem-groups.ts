// The problems of a run in the order and the groups of the list.
//
// In: the diagnostics, and which of them the reader wants to see. Out: groups: the problems of one rule with one
// code and one severity. Must not know: what a rule is about, or how a group is shown.

import type { Diagnostic } from '../protocol/protocol';

export type Severity = Diagnostic['severity'];
export type Order = 'severity' | 'place';

/** Worst first. */
export const SEVERITIES: readonly Severity[] = ['error', 'warning', 'info'];

/** What of the problems is shown. */
export interface Wanted {
  readonly order: Order;
  /** Severities that are left out. */
  readonly without: ReadonlySet<Severity>;
  /** The slug of the only rule that is shown. */
  readonly rule: string | undefined;
}

/** In the order of their places; at least one. */
export type Group = readonly [Diagnostic, ...Diagnostic[]];

export function groups(diagnostics: readonly Diagnostic[], { order, without, rule }: Wanted): readonly Group[] {
  const found = new Map<string, [Diagnostic, ...Diagnostic[]]>();
  for (const diagnostic of diagnostics) {
    const { severity, code, slug } = diagnostic;
    if (without.has(severity) || (rule !== undefined && slug !== rule)) continue;
    const key = `${severity} ${code} ${slug}`;
    const group = found.get(key);
    if (group === undefined) found.set(key, [diagnostic]);
    else group.push(diagnostic);
  }
  // The first of each is the first in the text: the groups stand in the order of their places.
  const all = [...found.values()];
  if (order === 'place') return all;
  return SEVERITIES.flatMap((severity) => all.filter(([first]) => first.severity === severity));
}

/** How many problems each rule has, in the order of their slugs. */
export function countByRule(diagnostics: readonly Diagnostic[]): ReadonlyMap<string, number> {
  const counts = new Map<string, number>();
  for (const { slug } of diagnostics) counts.set(slug, (counts.get(slug) ?? 0) + 1);
  return new Map([...counts].sort(([a], [b]) => (a < b ? -1 : 1)));
}
