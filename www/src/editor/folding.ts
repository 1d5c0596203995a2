// Folding of programs, tools, contours and loops by the user.
//
// In: ranges from the end of a line to the end of the last line of the range, sent as an effect; they move with edits
// until new ones arrive. Out: markers in the gutter, and CodeMirror's keys. Must not know: the meaning of a range.

import { foldGutter, foldKeymap, foldService } from '@codemirror/language';
import { StateEffect, StateField, type ChangeDesc, type Extension } from '@codemirror/state';
import { keymap } from '@codemirror/view';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { lastOf } from './effects';
import type { Span } from './text-store';

export const showFoldable = StateEffect.define<readonly Span[]>();

/** In the order of the text; of several that start in one line, the longest first. */
const foldable = StateField.define<readonly Span[]>({
  create: () => [],
  update(before, transaction) {
    const spans = lastOf(transaction.effects, showFoldable);
    if (spans !== undefined) return spans.filter(({ to }) => to <= transaction.newDoc.length);
    return transaction.docChanged ? mapSpans(before, transaction.changes) : before;
  },
});

function mapSpans(spans: readonly Span[], changes: ChangeDesc): readonly Span[] {
  return spans
    .map(({ from, to }) => ({ from: changes.mapPos(from), to: changes.mapPos(to) }))
    .filter(({ from, to }) => from < to);
}

/** `language` is called for each marker. */
export function folding(language: () => Language): Extension {
  const service = foldService.of((state, start, end) => {
    const spans = state.field(foldable, false) ?? [];
    const span = spans[firstFrom(spans, start)];
    // From the end of the line, so that its blanks and comments stay visible.
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

/** Index of the first span that starts at or after an offset. */
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
