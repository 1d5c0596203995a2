// The context of the program in the editor: a program that replaces another one has its own context, and undo restores
// the old one together with its text.
//
// In: edits of the user; the current context. Out: effects added to the changes. Must not know: the content of a
// context.

import { invertedEffects } from '@codemirror/commands';
import {
  EditorState,
  StateEffect,
  type Extension,
  type Text,
  type Transaction,
  type TransactionSpec,
} from '@codemirror/state';
import { isAnotherProgram, type Removed } from './program-replacement';
import { lastOf } from './effects';
import { inputOf } from './input';
import type { ContextSource, ProgramContext } from './text-store';

const setContext = StateEffect.define<ProgramContext>();

/** User events of changes by the page, which never make another program. */
const SAME_PROGRAM_EVENTS = ['input.setup', 'input.fix'] as const;

/** A longer text is not blank. */
const MAX_BLANK_LENGTH = 200;

/** The program before the editor was emptied, and whether its context was dropped then. */
interface Emptied {
  readonly text: string;
  readonly context: ProgramContext;
  readonly isDropped: boolean;
}

type ContextEffect = Pick<TransactionSpec, 'effects'> | null;

export function programContext(events: ContextSource): Extension {
  /** If this program is pasted again, it keeps its context. */
  let emptied: Emptied | undefined;
  const setNeutral = (): ContextEffect => ({ effects: setContext.of(events.neutral()) });

  /** A text is put into an empty editor. */
  const intoBlank = ({ newDoc }: Transaction, canReplace: boolean): ContextEffect => {
    const before = emptied;
    if (before === undefined || isBlank(newDoc)) return null;
    emptied = undefined;
    const isSame = !isAnotherProgram(before.text, newDoc.toString(), [{ from: 0, to: before.text.length }]);
    if (before.isDropped) return isSame ? { effects: setContext.of(before.context) } : null;
    return !isSame && canReplace ? setNeutral() : null;
  };

  /** A text changes or replaces another one. */
  const overText = (transaction: Transaction, canReplace: boolean): ContextEffect => {
    if (!isReplacement(transaction)) return null;
    const { startState, newDoc } = transaction;
    emptied = isBlank(newDoc)
      ? { text: startState.doc.toString(), context: events.context(), isDropped: canReplace }
      : undefined;
    return canReplace ? setNeutral() : null;
  };

  const withContext = (transaction: Transaction): ContextEffect => {
    if (!transaction.docChanged || !isByUser(transaction)) return null;
    const canReplace = events.typedCanReplace() || inputOf([transaction]) === 'inserted';
    const change = isBlank(transaction.startState.doc) ? intoBlank : overText;
    return change(transaction, canReplace);
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

function isBlank(doc: Text): boolean {
  return doc.length <= MAX_BLANK_LENGTH && doc.toString().trim() === '';
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
