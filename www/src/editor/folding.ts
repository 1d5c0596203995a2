// What the reader can fold: a program, a tool, a contour, a loop.
//
// In: ranges from the end of a line to the end of the last line that belongs to it, sent as an effect; they move with
// every change of the text until newer ones come. Out: a sign in the gutter, and the keys of the editor. Must not know: what
// a range is.

import { foldGutter, foldKeymap, foldService } from '@codemirror/language';
import { StateEffect, StateField, type ChangeDesc, type Extension } from '@codemirror/state';
import { keymap } from '@codemirror/view';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { lastOf } from './effects';
import type { Span } from './holder';

export const showFoldable = StateEffect.define<readonly Span[]>();

/** In the order of the text, the longest first where several begin in one line. */
const foldable = StateField.define<readonly Span[]>({
  create: () => [],
  update(before, transaction) {
    const said = lastOf(transaction.effects, showFoldable);
    if (said !== undefined) return said.filter(({ to }) => to <= transaction.newDoc.length);
    return transaction.docChanged ? moved(before, transaction.changes) : before;
  },
});

function moved(spans: readonly Span[], changes: ChangeDesc): readonly Span[] {
  return spans
    .map(({ from, to }) => ({ from: changes.mapPos(from), to: changes.mapPos(to) }))
    .filter(({ from, to }) => from < to);
}

/** `language` is asked each time a sign is made. */
export function folding(language: () => Language): Extension {
  const service = foldService.of((state, start, end) => {
    const spans = state.field(foldable, false) ?? [];
    const span = spans[firstFrom(spans, start)];
    // From the end of the line: its blanks and comments stay.
    return span !== undefined && span.from <= end && span.to > end ? { from: end, to: span.to } : null;
  });
  const gutter = foldGutter({
    foldingChanged: ({ startState, state }) => startState.field(foldable) !== state.field(foldable),
    markerDOM(open) {
      const { fold, unfold } = WORDS[language()];
      return make('span', { className: 'fold-sign', title: open ? fold : unfold }, open ? '▾' : '▸');
    },
  });
  return [foldable, service, gutter, keymap.of(foldKeymap)];
}

/** Index of the first span that begins at an offset, or after it. */
function firstFrom(spans: readonly Span[], offset: number): number {
  let [low, high] = [0, spans.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((spans[middle]?.from ?? 0) < offset) low = middle + 1;
    else high = middle;
  }
  return low;
}

const WORDS = words({
  en: { fold: 'Fold', unfold: 'Unfold' },
  zh: { fold: '折叠', unfold: '展开' },
  ru: { fold: 'Свернуть', unfold: 'Развернуть' },
});
