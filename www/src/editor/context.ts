// The context of the program in the editor: a program that replaces another one has its own context, and undo restores
// the old one together with its text.
//
// In: edits of the user; the current context. Out: effects added to the changes. Must not know: the content of a
// context.

import { invertedEffects } from '@codemirror/commands';
import { EditorState, StateEffect, type Extension, type Transaction, type TransactionSpec } from '@codemirror/state';
import { isAnotherProgram, type Removed } from './program-replacement';
import { lastOf } from './effects';
import type { ContextSource, ProgramContext } from './text-store';

const setContext = StateEffect.define<ProgramContext>();

/** User events of changes by the page, which never make another program. */
const SAME_PROGRAM_EVENTS = ['input.setup', 'input.fix'] as const;

export function programContext(events: ContextSource): Extension {
  /** The program before the editor was emptied: if it is cut out and pasted again, it keeps its context. */
  let emptied: { readonly text: string; readonly context: ProgramContext } | undefined;
  const withContext = (transaction: Transaction): Pick<TransactionSpec, 'effects'> | null => {
    if (!transaction.docChanged || !isByUser(transaction)) return null;
    const { doc } = transaction.startState;
    if (doc.length === 0) {
      const before = emptied;
      emptied = undefined;
      const isRestored =
        before !== undefined &&
        !isAnotherProgram(before.text, transaction.newDoc.toString(), [{ from: 0, to: before.text.length }]);
      return isRestored ? { effects: setContext.of(before.context) } : null;
    }
    if (!isReplacement(transaction)) return null;
    emptied = transaction.newDoc.length === 0 ? { text: doc.toString(), context: events.context() } : undefined;
    return { effects: setContext.of(events.neutral()) };
  };
  return [
    EditorState.transactionExtender.of(withContext),
    // Undo restores the context from before the change.
    invertedEffects.of(({ effects }) =>
      effects.some((effect) => effect.is(setContext)) ? [setContext.of(events.context())] : [],
    ),
  ];
}

/** The effect that adds a context to a change. */
export function contextEffect(context: ProgramContext): StateEffect<unknown> {
  return setContext.of(context);
}

/** The context that the transactions have set; undefined if it is unchanged. */
export function contextOf(transactions: readonly Transaction[]): ProgramContext | undefined {
  return lastOf(
    transactions.flatMap(({ effects }) => effects),
    setContext,
  );
}

function isByUser(transaction: Transaction): boolean {
  const isEdit = transaction.isUserEvent('input') || transaction.isUserEvent('delete');
  return isEdit && !SAME_PROGRAM_EVENTS.some((event) => transaction.isUserEvent(event));
}

function isReplacement(transaction: Transaction): boolean {
  const removed: Removed[] = [];
  let length = 0;
  transaction.changes.iterChangedRanges((from, to) => {
    removed.push({ from, to });
    length += to - from;
  });
  const { doc } = transaction.startState;
  // This runs for each key, so compare the texts only if much was removed.
  return 4 * length >= doc.length && isAnotherProgram(doc.toString(), transaction.newDoc.toString(), removed);
}
