// Announces the selected problem to screen readers.
//
// In: the diagnostics in the editor, and the selection. Out: a sentence in the live region of the editor. Must not
// know: the meaning of a diagnostic.

import { forEachDiagnostic } from '@codemirror/lint';
import { EditorView } from '@codemirror/view';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Diagnostic } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';

export function announceProblem(view: EditorView, language: Language): void {
  const { from, to } = view.state.selection.main;
  let [count, at, announcement] = [0, 0, ''];
  forEachDiagnostic(view.state, ({ severity, message }, start, end) => {
    count++;
    if (at > 0 || start !== from || end !== to) return;
    at = count;
    announcement = `${PROBLEM_WORDS[language].severity[severity as Diagnostic['severity']]}: ${message.replaceAll('`', '')}`;
  });
  const texts = WORDS[language];
  const text = at === 0 ? texts.none : texts.problem(at, count, view.state.doc.lineAt(from).number, announcement);
  view.dispatch({ effects: EditorView.announce.of(text) });
}

const WORDS = words({
  en: {
    none: 'No problems',
    problem: (at: number, of: number, line: number, what: string) => `Problem ${at} of ${of}, line ${line}. ${what}`,
  },
  zh: {
    none: '没有问题',
    problem: (at, of, line, what) => `第 ${at} 个问题，共 ${of} 个，第 ${line} 行。${what}`,
  },
  ru: {
    none: 'Замечаний нет',
    problem: (at, of, line, what) => `Замечание ${at} из ${of}, строка ${line}. ${what}`,
  },
});
