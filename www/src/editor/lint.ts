// Problems in the editor: squiggles, gutter marks, tooltips with the message and its fixes.
//
// In: the diagnostics of the newest run. Out: CodeMirror's diagnostics. Applying a fix is an ordinary edit of the user,
// so it can be undone. Must not know: the meaning of a diagnostic.

import { isolateHistory } from '@codemirror/commands';
import { forEachDiagnostic, type Diagnostic as LintDiagnostic } from '@codemirror/lint';
import type { EditorState } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';
import { make, renderProse } from '../dom/dom';
import type { Language } from '../dom/language';
import type { Diagnostic, Fix, Setting } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';
import { ruleLink } from './rule-link';

/** More squiggles would not be useful, and cost time on every key. */
const MAX_DIAGNOSTICS = 1000;

/** A diagnostic of CodeMirror, and a key of everything it displays. */
export interface ShownDiagnostic extends LintDiagnostic {
  readonly key: string;
}

/** `newest`: returns the newest diagnostics when a fix is applied, since those on display may be older. */
export function lintDiagnostics(
  diagnostics: readonly Diagnostic[],
  language: Language,
  length: number,
  newest: () => readonly Diagnostic[],
  applySetting: (setting: Setting) => void,
): readonly ShownDiagnostic[] {
  return diagnostics
    .filter((diagnostic) => diagnostic.from <= diagnostic.to && diagnostic.to <= length)
    .slice(0, MAX_DIAGNOSTICS)
    .map((diagnostic) => ({
      key: diagnosticKey(diagnostic, language),
      from: diagnostic.from,
      to: diagnostic.to,
      severity: diagnostic.severity,
      message: diagnostic.message,
      markClass: `cm-problem-${diagnostic.kind}`,
      renderMessage: () => messageElement(diagnostic, language),
      actions: diagnostic.fixes.map((fix, index) => ({
        name: fix.title.replaceAll('`', ''),
        apply(view: EditorView, from: number) {
          const same = newest().filter(
            (other) => diagnosticKey(other, language) === diagnosticKey(diagnostic, language),
          );
          const [nearest] = same.sort((a, b) => Math.abs(a.from - from) - Math.abs(b.from - from));
          if (fix.setting !== undefined) applySetting(fix.setting);
          else applyFix(view, nearest?.fixes[index]?.edits ?? []);
        },
      })),
    }));
}

function diagnosticKey(
  { severity, kind, code, slug, alarm, message, help, fixes }: Diagnostic,
  language: Language,
): string {
  return JSON.stringify([
    language,
    severity,
    kind,
    code,
    slug,
    alarm,
    message,
    help,
    ...fixes.map(({ title }) => title),
  ]);
}

/** Whether the editor already shows exactly these diagnostics; edits move them. */
export function areShown(state: EditorState, diagnostics: readonly ShownDiagnostic[]): boolean {
  const shown: string[] = [];
  forEachDiagnostic(state, (diagnostic, from, to) =>
    shown.push(`${from} ${to} ${(diagnostic as ShownDiagnostic).key}`),
  );
  if (shown.length !== diagnostics.length) return false;
  const expected = diagnostics.map(({ from, to, key }) => `${from} ${to} ${key}`);
  // Sort both: the order of diagnostics on top of each other is not visible.
  shown.sort();
  expected.sort();
  return shown.every((text, at) => text === expected[at]);
}

/** Applies the edits of one or several fixes as one undo step. */
export function applyFix(view: EditorView, edits: Fix['edits']): void {
  const inside = edits.every((edit) => edit.from <= edit.to && edit.to <= view.state.doc.length);
  if (!inside || edits.length === 0) return;
  view.dispatch({
    changes: edits.map((edit) => ({ from: edit.from, to: edit.to, insert: edit.text })),
    annotations: isolateHistory.of('full'),
    userEvent: 'input.fix',
    scrollIntoView: true,
  });
}

function messageElement(diagnostic: Diagnostic, language: Language): HTMLElement {
  const words = PROBLEM_WORDS[language];
  const facts = [
    words.severity[diagnostic.severity],
    words.kind[diagnostic.kind],
    diagnostic.alarm === diagnostic.code ? '' : diagnostic.code,
  ];
  if (diagnostic.alarm !== undefined) facts.push(words.alarm(diagnostic.alarm));
  const explanation = make(
    'div',
    { className: 'explanation' },
    make('p', { className: 'message' }, ...renderProse(diagnostic.message)),
  );
  if (diagnostic.help !== undefined)
    explanation.append(make('p', { className: 'help-text' }, ...renderProse(diagnostic.help)));
  const factText = facts.filter((fact) => fact !== '').join(' · ');
  explanation.append(make('p', { className: 'facts' }, `${factText} · `, ruleLink(diagnostic, language)));
  return explanation;
}
