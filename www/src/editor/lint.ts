// Problems in the editor: squiggles, gutter marks, tooltips with the message and its fixes.
//
// In: the diagnostics of the newest run. Out: CodeMirror's diagnostics. Applying a fix is an ordinary edit of the user,
// so it can be undone. Must not know: the meaning of a diagnostic.

import { isolateHistory } from '@codemirror/commands';
import { forEachDiagnostic, type Diagnostic as LintDiagnostic } from '@codemirror/lint';
import type { EditorState } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';
import { make, prose } from '../dom/dom';
import type { Language } from '../dom/language';
import type { Diagnostic, Fix, Setting } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';
import { ruleLink } from './rule-link';

/** More squiggles would not be useful, and cost time on every key. */
const SHOWN = 1000;

/** A diagnostic of CodeMirror, and a key of everything it displays. */
export interface Shown extends LintDiagnostic {
  readonly shows: string;
}

/** `now`: returns the newest diagnostics when a fix is applied, since those on display may be older. */
export function lintDiagnostics(
  diagnostics: readonly Diagnostic[],
  language: Language,
  length: number,
  now: () => readonly Diagnostic[],
  set: (setting: Setting) => void,
): readonly Shown[] {
  return diagnostics
    .filter((diagnostic) => diagnostic.from <= diagnostic.to && diagnostic.to <= length)
    .slice(0, SHOWN)
    .map((diagnostic) => ({
      shows: shows(diagnostic, language),
      from: diagnostic.from,
      to: diagnostic.to,
      severity: diagnostic.severity,
      message: diagnostic.message,
      markClass: `cm-problem-${diagnostic.kind}`,
      renderMessage: () => explain(diagnostic, language),
      actions: diagnostic.fixes.map((fix, which) => ({
        name: fix.title.replaceAll('`', ''),
        apply(view: EditorView, from: number) {
          const same = now().filter((other) => shows(other, language) === shows(diagnostic, language));
          const [here] = same.sort((a, b) => Math.abs(a.from - from) - Math.abs(b.from - from));
          if (fix.setting !== undefined) set(fix.setting);
          else applyFix(view, here?.fixes[which]?.edits ?? []);
        },
      })),
    }));
}

function shows({ severity, kind, code, slug, alarm, message, help, fixes }: Diagnostic, language: Language): string {
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
export function areShown(state: EditorState, diagnostics: readonly Shown[]): boolean {
  const there: string[] = [];
  forEachDiagnostic(state, (diagnostic, from, to) => there.push(`${from} ${to} ${(diagnostic as Shown).shows}`));
  if (there.length !== diagnostics.length) return false;
  const wanted = diagnostics.map(({ from, to, shows }) => `${from} ${to} ${shows}`);
  // Sort both: the order of diagnostics on top of each other is not visible.
  there.sort();
  wanted.sort();
  return there.every((one, at) => one === wanted[at]);
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

function explain(diagnostic: Diagnostic, language: Language): HTMLElement {
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
    make('p', { className: 'message' }, ...prose(diagnostic.message)),
  );
  if (diagnostic.help !== undefined)
    explanation.append(make('p', { className: 'help-text' }, ...prose(diagnostic.help)));
  const known = facts.filter((fact) => fact !== '').join(' · ');
  explanation.append(make('p', { className: 'facts' }, `${known} · `, ruleLink(diagnostic, language)));
  return explanation;
}
