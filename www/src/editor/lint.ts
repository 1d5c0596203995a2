// Problems inside the editor: squiggles, gutter marks, tooltips with the message and its repairs.
//
// In: the diagnostics of the newest run. Out: CodeMirror's diagnostics. Applying a repair is an edit by the
// reader like any other, so it can be undone. Must not know: what a diagnostic is about.

import { isolateHistory } from '@codemirror/commands';
import type { Diagnostic as LintDiagnostic } from '@codemirror/lint';
import type { EditorView } from '@codemirror/view';
import { make, prose } from '../dom/dom';
import type { Language } from '../dom/language';
import type { Diagnostic, Fix } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';
import { ruleLink } from './rule-link';

/** More squiggles than this mean nothing and cost time on every key. */
const SHOWN = 1000;

export function lintDiagnostics(
  diagnostics: readonly Diagnostic[],
  language: Language,
  length: number,
): LintDiagnostic[] {
  return diagnostics
    .filter((diagnostic) => diagnostic.from <= diagnostic.to && diagnostic.to <= length)
    .slice(0, SHOWN)
    .map((diagnostic) => ({
      from: diagnostic.from,
      to: diagnostic.to,
      severity: diagnostic.severity,
      message: diagnostic.message,
      markClass: `cm-problem-${diagnostic.kind}`,
      renderMessage: () => explain(diagnostic, language),
      actions: diagnostic.fixes.map((fix) => ({
        name: fix.title.replaceAll('`', ''),
        apply: (view: EditorView) => applyFix(view, fix.edits),
      })),
    }));
}

/** Makes the edits of a repair, or of several; one undo takes them back. */
export function applyFix(view: EditorView, edits: Fix['edits']): void {
  const inside = edits.every((edit) => edit.from <= edit.to && edit.to <= view.state.doc.length);
  if (!inside) return;
  view.dispatch({
    changes: edits.map((edit) => ({ from: edit.from, to: edit.to, insert: edit.text })),
    annotations: isolateHistory.of('full'),
    userEvent: 'input.fix',
    scrollIntoView: true,
  });
}

function explain(diagnostic: Diagnostic, language: Language): HTMLElement {
  const words = PROBLEM_WORDS[language];
  const facts = [words.severity[diagnostic.severity], words.kind[diagnostic.kind], diagnostic.alarm === diagnostic.code ? '' : diagnostic.code];
  if (diagnostic.alarm !== undefined) facts.push(words.alarm(diagnostic.alarm));
  const explanation = make('div', { className: 'explanation' }, make('p', { className: 'message' }, ...prose(diagnostic.message)));
  if (diagnostic.help !== undefined) explanation.append(make('p', { className: 'help-text' }, ...prose(diagnostic.help)));
  const known = facts.filter((fact) => fact !== '').join(' · ');
  explanation.append(make('p', { className: 'facts' }, `${known} · `, ruleLink(diagnostic, language)));
  return explanation;
}
