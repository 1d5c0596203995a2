// What can be written at the cursor: a list under it while the reader types, or asks for it.
//
// In: proposals of the interpreter, in their order. Out: what the reader takes of them. Must not know: what is proposed.

import { acceptCompletion, autocompletion, closeCompletion, completionStatus, hasNextSnippetField, moveCompletionSelection, nextSnippetField, selectedCompletionIndex, snippet, startCompletion } from '@codemirror/autocomplete';
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import { Prec, type Extension } from '@codemirror/state';
import { EditorView, keymap, ViewPlugin, type Command, type ViewUpdate } from '@codemirror/view';
import type { CompletionItem } from '../protocol/protocol';
import { completes } from './completes';
import type { EditorEvents } from './holder';
import { rem } from './theme';

export function completion(events: EditorEvents): Extension {
  const source = async (context: CompletionContext): Promise<CompletionResult | null> => {
    if (!context.explicit && !completes()) return null;
    const found = await events.completionAt(context.pos, context.explicit);
    if (found === undefined || context.aborted || found.to !== context.pos) return null;
    return { from: found.from, filter: false, options: found.items.map(option) };
  };
  return [
    // Nothing is chosen at first: Enter ends the block, unless the reader went into the list.
    autocompletion({ override: [source], icons: false, maxRenderedOptions: 60, selectOnOpen: false, interactionDelay: 0 }),
    keysAhead,
    Prec.highest(keymap.of([
      { key: 'Tab', run: (view) => take(view) || ahead(take)(view) },
      { key: 'ArrowDown', run: ahead(moveCompletionSelection(true)) },
      { key: 'ArrowUp', run: ahead(moveCompletionSelection(false)) },
      { key: 'PageDown', run: ahead(moveCompletionSelection(true, 'page')) },
      { key: 'PageUp', run: ahead(moveCompletionSelection(false, 'page')) },
      { key: 'Enter', run: (view) => view.plugin(keysAhead)?.isWaiting === true && ahead(acceptCompletion)(view) },
    ])),
    look,
  ];
}

const look = EditorView.theme({
  '.cm-tooltip.cm-tooltip-autocomplete > [role=listbox]': { maxHeight: rem(16), minWidth: rem(14), maxWidth: `min(${rem(36)}, 95vw)`, fontFamily: 'var(--playground-font)' },
  '.cm-tooltip.cm-tooltip-autocomplete [role=listbox] > [role=option]': { display: 'flex', gap: rem(0.75), alignItems: 'baseline', padding: `${rem(0.2)} ${rem(0.6)}`, lineHeight: '1.4' },
  '.cm-tooltip.cm-tooltip-autocomplete [role=option][aria-selected]': { backgroundColor: 'var(--playground-accent)', color: 'var(--playground-on-accent)' },
  '.cm-completionLabel': { fontFamily: 'var(--playground-code-font)', flex: 'none' },
  '.cm-completionDetail': { flex: '1 1 auto', marginLeft: '0', fontStyle: 'normal', color: 'var(--playground-muted)', overflow: 'hidden', textOverflow: 'ellipsis' },
  '[aria-selected] .cm-completionDetail': { color: 'inherit' },
  '.cm-snippetField': { backgroundColor: 'var(--playground-accent-soft)' },
  // A finger is wider than a pointer.
  '@media (pointer: coarse)': { '.cm-tooltip.cm-tooltip-autocomplete > [role=listbox]': { maxHeight: rem(11.5) }, '.cm-tooltip.cm-tooltip-autocomplete [role=listbox] > [role=option]': { minHeight: rem(2.75), alignItems: 'center' } },
});

/** The list, as it would be open had it been there when the last word was typed; none where no word stands. */
export function catchUp(view: EditorView): void {
  const { head } = view.state.selection.main;
  if (completes() && view.state.sliceDoc(Math.max(0, head - 1), head).trim() !== '') startCompletion(view);
}

/** Tab takes the first proposal, or the one that is chosen; where there is no list it leaves the editor, as ever. */
function take(view: EditorView): boolean {
  if (completionStatus(view.state) !== 'active') return false;
  const isChosen = selectedCompletionIndex(view.state) !== null;
  if (!isChosen && hasNextSnippetField(view.state)) {
    closeCompletion(view);
    return nextSnippetField(view);
  }
  if (!isChosen) moveCompletionSelection(true)(view);
  acceptCompletion(view);
  return true;
}

/**
 * The keys for the list that came while it was still that of the letter before: the list stands there, and the editor
 * refuses them. They are done when the list has caught up, and forgotten when the reader types on or leaves.
 */
const keysAhead = ViewPlugin.fromClass(
  class {
    #commands: Command[] = [];

    get isWaiting(): boolean {
      return this.#commands.length > 0;
    }

    add(command: Command): void {
      this.#commands.push(command);
    }

    update({ docChanged, selectionSet, state, view }: ViewUpdate): void {
      if (!this.isWaiting) return;
      const status = completionStatus(state);
      if (!docChanged && !selectionSet && status === 'pending') return;
      const commands = this.#commands;
      this.#commands = [];
      // The editor takes no changes within an update.
      if (!docChanged && !selectionSet && status === 'active') queueMicrotask(() => commands.forEach((command) => command(view)));
    }
  },
);

/** Does `command` once the list that is shown has caught up with what was typed; not handled where none is shown. */
function ahead(command: Command): Command {
  return (view) => {
    const isShown = view.contentDOM.getAttribute('aria-haspopup') === 'listbox';
    if (!isShown || completionStatus(view.state) !== 'pending') return false;
    view.plugin(keysAhead)?.add(command);
    return true;
  };
}

function option({ label, text, fills, detail, kind }: CompletionItem): Completion {
  return { label, detail, type: kind, apply: fills.some(([from, to]) => from < to || to < text.length) ? snippet(template(text, fills)) : text };
}

/** The text as a snippet of the editor: each place to fill a field of its own. */
function template(text: string, fills: CompletionItem['fills']): string {
  let written = '';
  let at = 0;
  for (const [index, [from, to]] of fills.entries()) {
    written += `${text.slice(at, from)}\${${index + 1}:${text.slice(from, to)}}`;
    at = to;
  }
  return written + text.slice(at);
}
