// Edits from the worker, applied as one change of the text.
//
// In: a question whose answer has edits. Out: the answer, once its edits are applied; undo reverts them in one step.

import type { Change } from '../editor/text-store';
import type { Shell } from './panel';

/** Resolves to undefined if the text has changed meanwhile, or there is no worker: then no edit is applied. */
export async function applyEdits<A extends object>(
  shell: Shell,
  ask: () => Promise<A | undefined>,
): Promise<A | undefined> {
  const { editor } = shell;
  shell.flush();
  const { revision } = editor;
  const answer = await ask();
  if (answer === undefined || editor.revision !== revision) return undefined;
  if (hasEdits(answer) && answer.edits.length > 0) {
    editor.change(answer.edits);
    shell.commitEdit();
  }
  return answer;
}

function hasEdits(answer: object): answer is { readonly edits: readonly Change[] } {
  return 'edits' in answer;
}
