// Decorations of the text: tokens, the block under the pointer, the uses of a number, the running block.
//
// In: ranges of the document, sent as effects. Out: decorations, which move with edits until new ranges arrive. Must
// not know: the source of the ranges; a token class is a number with a colour.

import { StateEffect, StateField, type EditorState, type Extension, type Range, type Text } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';
import { lastOf } from './effects';
import type { LineRange, Span } from './text-store';

/** The CSS class suffixes of the token classes 0, 1, 2 … */
const TOKEN_STYLES = [
  'comment',
  'g-word',
  'm-word',
  'axis',
  'data',
  'number-word',
  'rate',
  'macro',
  'unknown',
  'punctuation',
].map((style) => Decoration.mark({ class: `tok-${style}` }));

const HOVERED = Decoration.mark({ class: 'cm-hovered-block' });
const USED = Decoration.mark({ class: 'cm-used-number' });
const MARKED = Decoration.line({ class: 'cm-marked-line' });
const RUNNING = Decoration.line({ class: 'cm-running-line' });

/** Triples `from, to, class`, sorted. */
export const showTokens = StateEffect.define<Uint32Array>();
export const showHovered = StateEffect.define<Span | undefined>();
/** The uses of a number. */
export const showUses = StateEffect.define<readonly Span[]>();
export const showRunning = StateEffect.define<Span | undefined>();
export const showMarked = StateEffect.define<readonly LineRange[]>();

const tokens = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(shown, transaction) {
    let next = shown.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (effect.is(showTokens)) next = tokenMarks(effect.value, transaction.newDoc.length);
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function tokenMarks(triples: Uint32Array, length: number): DecorationSet {
  const marks: Range<Decoration>[] = [];
  for (let i = 0; i + 2 < triples.length; i += 3) {
    const from = triples[i] ?? 0;
    const to = triples[i + 1] ?? 0;
    const style = TOKEN_STYLES[triples[i + 2] ?? -1];
    if (style !== undefined && from < to && to <= length) marks.push(style.range(from, to));
  }
  return Decoration.set(marks, true);
}

/** `after` an edit, the mark is removed, or moves with its block. */
function blockField(
  effectType: typeof showHovered,
  mark: (span: Span, doc: Text) => Range<Decoration>,
  after: 'removed' | 'moved',
): StateField<DecorationSet> {
  return StateField.define<DecorationSet>({
    create: () => Decoration.none,
    update(shown, transaction) {
      let next = after === 'moved' ? shown.map(transaction.changes) : transaction.docChanged ? Decoration.none : shown;
      for (const effect of transaction.effects) {
        if (!effect.is(effectType)) continue;
        const span = effect.value;
        const inside = span !== undefined && span.from < span.to && span.to <= transaction.newDoc.length;
        next = inside ? Decoration.set(mark(span, transaction.newDoc)) : Decoration.none;
      }
      return next;
    },
    provide: (field) => EditorView.decorations.from(field),
  });
}

const uses = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(shown, transaction) {
    const value = lastOf(transaction.effects, showUses);
    if (value === undefined) return transaction.docChanged ? Decoration.none : shown;
    const { length } = transaction.newDoc;
    return Decoration.set(
      value.filter(({ from, to }) => from < to && to <= length).map(({ from, to }) => USED.range(from, to)),
      true,
    );
  },
  provide: (field) => EditorView.decorations.from(field),
});

const running = blockField(showRunning, (span, doc) => RUNNING.range(doc.lineAt(span.from).from), 'moved');

/** Lines that the page highlights. They are line numbers, so they apply to another text as well. */
const markedLines = StateField.define<{ readonly lines: readonly LineRange[]; readonly shown: DecorationSet }>({
  create: () => ({ lines: [], shown: Decoration.none }),
  update(before, transaction) {
    const value = lastOf(transaction.effects, showMarked);
    if (value === undefined && !transaction.docChanged) return before;
    const lines = value ?? before.lines;
    return { lines, shown: lineMarks(lines, transaction.newDoc) };
  },
  provide: (field) => EditorView.decorations.from(field, ({ shown }) => shown),
});

function lineMarks(lines: readonly LineRange[], doc: Text): DecorationSet {
  const marks: Range<Decoration>[] = [];
  for (const { first, last } of lines) {
    for (let line = first; line <= Math.min(last, doc.lines); line++) marks.push(MARKED.range(doc.line(line).from));
  }
  return Decoration.set(marks, true);
}

export const marks: Extension = [
  markedLines,
  tokens,
  blockField(showHovered, (span) => HOVERED.range(span.from, span.to), 'removed'),
  uses,
  running,
];

/** The current start of the line that is marked as running, if any. */
export function runningLineStart(state: EditorState): number | undefined {
  return state.field(running, false)?.iter().value === null ? undefined : state.field(running, false)?.iter().from;
}
