// The context of the program in the editor: a program that takes the place of another one has its own, and
// undo brings back the one before together with its text.
//
// In: what the reader does to the text; the context as it is. Out: effects beside the changes. Must not know:
// what a context says.

import { invertedEffects } from '@codemirror/commands';
import { EditorState, StateEffect, type Extension, type Transaction, type TransactionSpec } from '@codemirror/state';
import { isAnotherProgram, type Removed } from './another-program';
import { lastOf } from './effects';
import type { ContextEvents, ProgramContext } from './holder';

const setContext = StateEffect.define<ProgramContext>();

/** How the page changes a program that stays what it is. */
const OF_THE_SAME = ['input.setup', 'input.fix'] as const;

export function programContext(events: ContextEvents): Extension {
  /** What stood in the editor before it was emptied: cut out and put back, it is the same program. */
  let emptied: { readonly text: string; readonly context: ProgramContext } | undefined;
  const withContext = (transaction: Transaction): Pick<TransactionSpec, 'effects'> | null => {
    if (!transaction.docChanged || !isByReader(transaction)) return null;
    const { doc } = transaction.startState;
    if (doc.length === 0) {
      const before = emptied;
      emptied = undefined;
      const isBack =
        before !== undefined &&
        !isAnotherProgram(before.text, transaction.newDoc.toString(), [{ from: 0, to: before.text.length }]);
      return isBack ? { effects: setContext.of(before.context) } : null;
    }
    if (!isReplacement(transaction)) return null;
    emptied = transaction.newDoc.length === 0 ? { text: doc.toString(), context: events.context() } : undefined;
    return { effects: setContext.of(events.neutral()) };
  };
  return [
    EditorState.transactionExtender.of(withContext),
    // What is in force while a change is made is what its undo brings back.
    invertedEffects.of(({ effects }) =>
      effects.some((effect) => effect.is(setContext)) ? [setContext.of(events.context())] : [],
    ),
  ];
}

/** What to add to a change that puts in a text with a context of its own. */
export function contextEffect(context: ProgramContext): StateEffect<unknown> {
  return setContext.of(context);
}

/** The context that changes have brought; nothing where it stays as it is. */
export function contextOf(transactions: readonly Transaction[]): ProgramContext | undefined {
  return lastOf(
    transactions.flatMap(({ effects }) => effects),
    setContext,
  );
}

function isByReader(transaction: Transaction): boolean {
  const isEdit = transaction.isUserEvent('input') || transaction.isUserEvent('delete');
  return isEdit && !OF_THE_SAME.some((same) => transaction.isUserEvent(same));
}

function isReplacement(transaction: Transaction): boolean {
  const removed: Removed[] = [];
  let length = 0;
  transaction.changes.iterChangedRanges((from, to) => {
    removed.push({ from, to });
    length += to - from;
  });
  const { doc } = transaction.startState;
  // Each key passes here; only what takes out much is looked at.
  return 4 * length >= doc.length && isAnotherProgram(doc.toString(), transaction.newDoc.toString(), removed);
}
