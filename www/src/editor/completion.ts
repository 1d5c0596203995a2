// What can be written at the cursor: a list under it while the reader types, or asks for it.
//
// In: proposals of the interpreter, in their order. Out: what the reader takes of them. Must not know: what is proposed.

import {
  acceptCompletion,
  autocompletion,
  closeCompletion,
  completionStatus,
  currentCompletions,
  hasNextSnippetField,
  moveCompletionSelection,
  nextSnippetField,
  selectedCompletionIndex,
  setSelectedCompletion,
  snippet,
  startCompletion,
} from '@codemirror/autocomplete';
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import {
  cursorLineDown,
  cursorLineUp,
  cursorPageDown,
  cursorPageUp,
  insertNewlineAndIndent,
} from '@codemirror/commands';
import { Prec, type Extension } from '@codemirror/state';
import { EditorView, keymap, ViewPlugin, type Command, type KeyBinding, type ViewUpdate } from '@codemirror/view';
import type { CompletionItem } from '../protocol/protocol';
import { completes } from './completes';
import type { EditorEvents } from './holder';
import { rem } from './theme';

/** A list that has not caught up by then is closed, ms. */
const LONGEST_WAIT_MS = 1000;

export function completion(events: EditorEvents): Extension {
  const source = async (context: CompletionContext): Promise<CompletionResult | null> => {
    if (!context.explicit && !completes()) return null;
    const found = await events.completionAt(context.pos, context.explicit);
    // An answer that a newer letter has overtaken is an empty list: the editor then asks again. After `null` it would wait for
    // the next letter.
    if (context.view?.state.doc !== context.state.doc) return { from: context.pos, filter: false, options: [] };
    if (found === undefined || context.aborted || found.to !== context.pos) return null;
    return { from: found.from, filter: false, options: found.items.map(option) };
  };
  return [
    // Nothing is chosen at first: Enter ends the block, unless the reader went into the list.
    wishes,
    Prec.highest(keymap.of(LIST_KEYS)),
    autocompletion({
      override: [source],
      icons: false,
      maxRenderedOptions: 60,
      selectOnOpen: false,
      interactionDelay: 0,
      addToOptions: [{ render: pressed, position: 100 }],
    }),
    look,
  ];
}

const look = EditorView.theme({
  '.cm-tooltip.cm-tooltip-autocomplete > [role=listbox]': {
    maxHeight: rem(16),
    minWidth: rem(14),
    maxWidth: `min(${rem(36)}, 95vw)`,
    fontFamily: 'var(--playground-font)',
  },
  '.cm-tooltip.cm-tooltip-autocomplete [role=listbox] > [role=option]': {
    display: 'flex',
    gap: rem(0.75),
    alignItems: 'baseline',
    padding: `${rem(0.2)} ${rem(0.6)}`,
    lineHeight: '1.4',
    position: 'relative',
  },
  '.cm-pressed-proposal': { position: 'absolute', inset: '0' },
  '.cm-tooltip.cm-tooltip-autocomplete [role=option][aria-selected]': {
    backgroundColor: 'var(--playground-accent)',
    color: 'var(--playground-on-accent)',
  },
  '.cm-completionLabel': { fontFamily: 'var(--playground-code-font)', flex: 'none' },
  '.cm-completionDetail': {
    flex: '1 1 auto',
    marginLeft: '0',
    fontStyle: 'normal',
    color: 'var(--playground-muted)',
    overflow: 'hidden',
    textOverflow: 'ellipsis',
  },
  '[aria-selected] .cm-completionDetail': { color: 'inherit' },
  '.cm-snippetField': { backgroundColor: 'var(--playground-accent-soft)' },
  // A finger is wider than a pointer.
  '@media (pointer: coarse)': {
    '.cm-tooltip.cm-tooltip-autocomplete > [role=listbox]': { maxHeight: rem(11.5) },
    '.cm-tooltip.cm-tooltip-autocomplete [role=listbox] > [role=option]': {
      minHeight: rem(2.75),
      alignItems: 'center',
    },
  },
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

/** What the reader asks of the list. */
interface Wish {
  /** Whether it could be done. */
  readonly run: Command;
  /** What the key does where there is no list. */
  readonly otherwise: Command;
}

/**
 * Wishes that came while the list was still that of the letter before: it stands there, and the editor refuses them. They
 * are carried out when the list has caught up or has gone, and forgotten when the reader types on or leaves.
 */
const wishes = ViewPlugin.fromClass(
  class {
    readonly #view: EditorView;
    #waiting: Wish[] = [];
    #limit: ReturnType<typeof setTimeout> | undefined;

    constructor(view: EditorView) {
      this.#view = view;
    }

    get isWaiting(): boolean {
      return this.#waiting.length > 0;
    }

    add(wish: Wish): void {
      this.#waiting.push(wish);
      // Nobody is kept in the list by an answer that does not come.
      this.#limit ??= setTimeout(() => {
        this.forget();
        closeCompletion(this.#view);
      }, LONGEST_WAIT_MS);
    }

    forget(): void {
      clearTimeout(this.#limit);
      this.#limit = undefined;
      this.#waiting = [];
    }

    update({ docChanged, selectionSet, state, view }: ViewUpdate): void {
      if (!this.isWaiting) return;
      if (docChanged || selectionSet || !view.hasFocus) return this.forget();
      if (completionStatus(state) === 'pending') return;
      const waiting = this.#waiting;
      this.forget();
      // The editor takes no changes within an update.
      queueMicrotask(() => {
        for (const { run, otherwise } of waiting) if (!run(view)) otherwise(view);
      });
    }

    destroy(): void {
      this.forget();
    }
  },
);

/** Keeps a wish until the list that is shown has caught up with what was typed; false where it need not wait. */
function later(view: EditorView, wish: Wish): boolean {
  const isShown = view.contentDOM.getAttribute('aria-haspopup') === 'listbox';
  if (!isShown || completionStatus(view.state) !== 'pending') return false;
  view.plugin(wishes)?.add(wish);
  return true;
}

/** A key of the list; while the list catches up, it waits. Otherwise the editor has it. */
function listKey(key: string, run: Command, otherwise: Command): KeyBinding {
  return { key, run: (view) => later(view, { run, otherwise }) };
}

const LIST_KEYS: readonly KeyBinding[] = [
  {
    key: 'Tab',
    // To the next place to fill there is no need to wait: nothing is chosen in a list that catches up.
    run: (view) =>
      take(view) ||
      ((isWaiting(view) || !hasNextSnippetField(view.state)) &&
        later(view, { run: take, otherwise: nextSnippetField })),
  },
  listKey('ArrowDown', moveCompletionSelection(true), cursorLineDown),
  listKey('ArrowUp', moveCompletionSelection(false), cursorLineUp),
  listKey('PageDown', moveCompletionSelection(true, 'page'), cursorPageDown),
  listKey('PageUp', moveCompletionSelection(false, 'page'), cursorPageUp),
  // Alone it ends the block.
  {
    key: 'Enter',
    run: (view) => isWaiting(view) && later(view, { run: acceptCompletion, otherwise: insertNewlineAndIndent }),
  },
  {
    key: 'Escape',
    run: (view) => {
      view.plugin(wishes)?.forget();
      return false;
    },
  },
];

function isWaiting(view: EditorView): boolean {
  return view.plugin(wishes)?.isWaiting === true;
}

/** Takes the proposal with this label, where the list has it. */
function takeLabel(label: string): Command {
  return (view) => {
    const at = currentCompletions(view.state).findIndex((each) => each.label === label);
    if (at < 0) return false;
    view.dispatch({ effects: setSelectedCompletion(at) });
    return acceptCompletion(view);
  };
}

/** What is pressed of a proposal: the editor hears nothing of it while the list catches up. */
function pressed({ label }: Completion, _state: unknown, view: EditorView): Node {
  const surface = document.createElement('span');
  surface.className = 'cm-pressed-proposal';
  surface.addEventListener('mousedown', () => void later(view, { run: takeLabel(label), otherwise: () => true }));
  return surface;
}

function option({ label, text, fills, detail, kind }: CompletionItem): Completion {
  return {
    label,
    detail,
    type: kind,
    apply: fills.some(([from, to]) => from < to || to < text.length) ? snippet(template(text, fills)) : text,
  };
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
