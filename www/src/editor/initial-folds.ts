// Lines of the program that are folded initially; the user can unfold them.
//
// In: the numbers of the lines to show. Out: a button in place of each range of other lines. Must not know: why they
// are folded.

import { codeFolding, foldEffect, foldedRanges, unfoldEffect } from '@codemirror/language';
import type { EditorState, Extension, StateEffect, Text } from '@codemirror/state';
import type { EditorView } from '@codemirror/view';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { LineRange } from './text-store';

/** `language` is called for each button. */
export function initialFolds(language: () => Language): Extension {
  return codeFolding({
    preparePlaceholder({ doc }, { from, to }) {
      const first = doc.lineAt(from);
      // A range that the user has folded starts at the end of a visible line.
      return [first.from < from ? first.number + 1 : first.number, doc.lineAt(to).number];
    },
    placeholderDOM(_, unfold, prepared) {
      const [first, last] = prepared as [number, number];
      const button = make('button', { type: 'button', className: 'folded-lines' }, WORDS[language()](first, last));
      button.addEventListener('click', unfold);
      return button;
    },
  });
}

/** Effects that fold all lines except these, and unfold everything else. */
export function foldAllExcept(state: EditorState, shown: readonly LineRange[]): StateEffect<unknown>[] {
  const effects: StateEffect<unknown>[] = [];
  foldedRanges(state).between(0, state.doc.length, (from, to) => void effects.push(unfoldEffect.of({ from, to })));
  return [...effects, ...hiddenRanges(state.doc, shown).map((range) => foldEffect.of(range))];
}

function hiddenRanges(doc: Text, shown: readonly LineRange[]): { readonly from: number; readonly to: number }[] {
  if (shown.length === 0) return [];
  const found: { from: number; to: number }[] = [];
  const fold = (first: number, last: number): void => {
    if (first > Math.min(last, doc.lines)) return;
    const [from, to] = [doc.line(first).from, doc.line(Math.min(last, doc.lines)).to];
    if (from < to) found.push({ from, to });
  };
  let next = 1;
  for (const { first, last } of [...shown].sort((a, b) => a.first - b.first)) {
    fold(next, first - 1);
    next = Math.max(next, last + 1);
  }
  fold(next, doc.lines);
  return found;
}

/** Effects that unfold the ranges overlapping a position that must be visible. */
export function unfoldAt(view: EditorView, from: number, to: number): StateEffect<unknown>[] {
  const effects: StateEffect<unknown>[] = [];
  foldedRanges(view.state).between(
    from,
    to,
    (start, end) => void effects.push(unfoldEffect.of({ from: start, to: end })),
  );
  return effects;
}

const WORDS = words({
  en: (first: number, last: number) => (first === last ? `Show line ${first}` : `Show lines ${first}–${last}`),
  zh: (first, last) => (first === last ? `显示第 ${first} 行` : `显示第 ${first}–${last} 行`),
  ru: (first, last) => (first === last ? `Показать строку ${first}` : `Показать строки ${first}–${last}`),
});
