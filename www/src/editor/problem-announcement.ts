// What a reader who does not see the editor hears of the problem that is selected there.
//
// In: the diagnostics, and the selection. Out: a sentence in the live region of the editor. Must not know: what a
// diagnostic is about.

import { EditorView } from '@codemirror/view';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Diagnostic } from '../protocol/protocol';
import { PROBLEM_WORDS } from './problem-words';

export function announceProblem(view: EditorView, diagnostics: readonly Diagnostic[], language: Language): void {
  const { from, to } = view.state.selection.main;
  const at = diagnostics.findIndex((one) => one.from === from && one.to === to);
  const problem = diagnostics[at] ?? diagnostics.find((one) => one.from <= from && from <= one.to);
  const texts = WORDS[language];
  const said = problem === undefined
    ? texts.none
    : texts.problem(diagnostics.indexOf(problem) + 1, diagnostics.length, problem.line, `${PROBLEM_WORDS[language].severity[problem.severity]}: ${problem.message.replaceAll('`', '')}`);
  view.dispatch({ effects: EditorView.announce.of(said) });
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
