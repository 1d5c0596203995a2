// Problems inside the editor: squiggles, gutter marks, tooltips with the message and its repairs.
//
// In: the diagnostics of the newest run. Out: CodeMirror's diagnostics. Applying a repair is an edit by the
// reader like any other, so it can be undone. Must not know: what a diagnostic is about.

import { isolateHistory } from '@codemirror/commands';
import { forEachDiagnostic, type Diagnostic as LintDiagnostic } from '@codemirror/lint';
import type { EditorState } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';
import { make, prose } from '../dom/dom';
import type { Language } from '../dom/language';
import type { Diagnostic, Fix, Setting } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';
import { ruleLink } from './rule-link';

/** More squiggles than this mean nothing and cost time on every key. */
const SHOWN = 1000;

/** A diagnostic of CodeMirror's, and all that is to be seen of it. */
export interface Shown extends LintDiagnostic {
  readonly shows: string;
}

/** `now`: the diagnostics of the newest run, when a repair is made: what is shown may be of one before. */
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

/** Whether the editor shows just these, each where it is to be: an edit has moved them along. */
export function areShown(state: EditorState, diagnostics: readonly Shown[]): boolean {
  const there: string[] = [];
  forEachDiagnostic(state, (diagnostic, from, to) => there.push(`${from} ${to} ${(diagnostic as Shown).shows}`));
  if (there.length !== diagnostics.length) return false;
  const wanted = diagnostics.map(({ from, to, shows }) => `${from} ${to} ${shows}`);
  // Each stands once for each of its kind; which of two is under the other is not to be seen.
  there.sort();
  wanted.sort();
  return there.every((one, at) => one === wanted[at]);
}

/** Makes the edits of a repair, or of several; one undo takes them back. */
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
