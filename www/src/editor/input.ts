// Whether the user has typed a change, or inserted a text.
//
// In: the transactions of a change. Out: the kind of input. Must not know: its effects.

import type { Transaction } from '@codemirror/state';
import type { Input } from './text-store';

/**
 * Text that was typed contains at most one line end: the keyboard of a phone inserts the clipboard without an event of
 * its own.
 */
export function inputOf(transactions: readonly Transaction[]): Input {
  const isUserEvent = (name: string): boolean => transactions.some((transaction) => transaction.isUserEvent(name));
  if (isUserEvent('input.complete')) return 'typed';
  let isTyped = !isUserEvent('input.paste') && !isUserEvent('input.drop');
  for (const { changes } of transactions)
    changes.iterChanges((_from, _to, _newFrom, _newTo, inserted) => {
      if (inserted.lines > 2) isTyped = false;
    });
  return isTyped ? 'typed' : 'inserted';
}
