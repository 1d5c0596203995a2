// Completion: a list under the cursor, opened while the user types or on request.
//
// In: proposals of the interpreter, sorted. Out: the accepted proposal. Must not know: the meaning of a proposal.

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
  isolateHistory,
} from '@codemirror/commands';
import { Prec, type Extension } from '@codemirror/state';
import { EditorView, keymap, ViewPlugin, type Command, type KeyBinding, type ViewUpdate } from '@codemirror/view';
import type { CompletionItem } from '../protocol/protocol';
import { isCompletionEnabled } from './completion-setting';
import { completionAt } from './place-help';
import type { EditorEvents } from './text-store';
import { rem } from './theme';

/** Timeout for an update of the list, ms; then it is closed. */
const MAX_WAIT_MS = 1000;

export function completion(events: EditorEvents): Extension {
  const source = async (context: CompletionContext): Promise<CompletionResult | null> => {
    if (!context.explicit && !isCompletionEnabled()) return null;
    const found = await completionAt(events.help(), context.pos, context.explicit);
    // If the text has changed meanwhile, return an empty list, so that CodeMirror asks again. After `null` it would
    // wait until the next character.
    if (context.view?.state.doc !== context.state.doc) return { from: context.pos, filter: false, options: [] };
    if (found === undefined || context.aborted || found.to !== context.pos) return null;
    return { from: found.from, filter: false, options: found.items.map(toCompletion) };
  };
  return [
    // Nothing is selected at first, so Enter inserts a line break unless the user has moved into the list.
    delayedActions,
    Prec.highest(keymap.of(LIST_KEYS)),
    autocompletion({
      override: [source],
      icons: false,
      maxRenderedOptions: 60,
      selectOnOpen: false,
      interactionDelay: 0,
      addToOptions: [{ render: clickTarget, position: 100 }],
    }),
    listTheme,
  ];
}

const listTheme = EditorView.theme({
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
  // Not a background colour: Chromium would keep it for the text that replaces a field, by a style that the policy of the
  // page forbids. Transparent, so that the selection under it is visible.
  '.cm-snippetField': {
    backgroundColor: 'transparent',
    boxShadow: 'inset 0 0 0 1em var(--playground-field)',
  },
  // The value of a field is selected, but equal numbers elsewhere have nothing to do with it.
  '.cm-content:has(.cm-snippetField) .cm-selectionMatch': { backgroundColor: 'transparent' },
  // Larger targets for touch.
  '@media (pointer: coarse)': {
    '.cm-tooltip.cm-tooltip-autocomplete > [role=listbox]': { maxHeight: rem(11.5) },
    '.cm-tooltip.cm-tooltip-autocomplete [role=listbox] > [role=option]': {
      minHeight: rem(2.75),
      alignItems: 'center',
    },
  },
});

/** Opens the list for text that was typed before this file was loaded, if the cursor is after a word. */
export function completeTypedText(view: EditorView): void {
  const { head } = view.state.selection.main;
  if (isCompletionEnabled() && view.state.sliceDoc(Math.max(0, head - 1), head).trim() !== '') startCompletion(view);
}

/** Tab accepts the selected proposal, or the first one. Without a list it leaves the editor. */
function acceptProposal(view: EditorView): boolean {
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

/** Accepts the selected proposal; without one goes to the next field. */
export function toNextField(view: EditorView): void {
  if (!acceptProposal(view)) nextSnippetField(view);
}

/** A key or click for the list, which waits for its update. */
interface DelayedAction {
  /** Returns whether it was possible. */
  readonly run: Command;
  /** The action of the key if the list is closed. */
  readonly otherwise: Command;
}

/**
 * Keys and clicks that arrive while the list still shows the proposals for the text before: CodeMirror ignores them in
 * this state. They run when the list is updated or closed, and are dropped when the user continues typing or leaves the
 * editor.
 */
const delayedActions = ViewPlugin.fromClass(
  class {
    readonly #view: EditorView;
    #actions: DelayedAction[] = [];
    #timeout: ReturnType<typeof setTimeout> | undefined;

    constructor(view: EditorView) {
      this.#view = view;
    }

    get isWaiting(): boolean {
      return this.#actions.length > 0;
    }

    add(action: DelayedAction): void {
      this.#actions.push(action);
      // An answer that never arrives must not block the keys.
      this.#timeout ??= setTimeout(() => {
        this.cancel();
        closeCompletion(this.#view);
      }, MAX_WAIT_MS);
    }

    cancel(): void {
      clearTimeout(this.#timeout);
      this.#timeout = undefined;
      this.#actions = [];
    }

    update({ docChanged, selectionSet, state, view }: ViewUpdate): void {
      if (!this.isWaiting) return;
      if (docChanged || selectionSet || !view.hasFocus) return this.cancel();
      if (completionStatus(state) === 'pending') return;
      const actions = this.#actions;
      this.cancel();
      // CodeMirror does not allow a dispatch during an update.
      queueMicrotask(() => {
        for (const { run, otherwise } of actions) if (!run(view)) otherwise(view);
      });
    }

    destroy(): void {
      this.cancel();
    }
  },
);

/** Delays a wish until the list is updated; returns false if that is not necessary. */
function delay(view: EditorView, action: DelayedAction): boolean {
  const isShown = view.contentDOM.getAttribute('aria-haspopup') === 'listbox';
  if (!isShown || completionStatus(view.state) !== 'pending') return false;
  view.plugin(delayedActions)?.add(action);
  return true;
}

/** A key of the list, which waits while the list is being updated; otherwise CodeMirror handles it. */
function listKey(key: string, run: Command, otherwise: Command): KeyBinding {
  return { key, run: (view) => delay(view, { run, otherwise }) };
}

const LIST_KEYS: readonly KeyBinding[] = [
  {
    key: 'Tab',
    // Moving to the next snippet field need not wait: nothing is selected in a list that is being updated.
    run: (view) =>
      acceptProposal(view) ||
      ((isWaiting(view) || !hasNextSnippetField(view.state)) &&
        delay(view, { run: acceptProposal, otherwise: nextSnippetField })),
  },
  listKey('ArrowDown', moveCompletionSelection(true), cursorLineDown),
  listKey('ArrowUp', moveCompletionSelection(false), cursorLineUp),
  listKey('PageDown', moveCompletionSelection(true, 'page'), cursorPageDown),
  listKey('PageUp', moveCompletionSelection(false, 'page'), cursorPageUp),
  // Without waiting keys, Enter inserts a line break.
  {
    key: 'Enter',
    run: (view) => isWaiting(view) && delay(view, { run: acceptCompletion, otherwise: insertNewlineAndIndent }),
  },
  {
    key: 'Escape',
    run: (view) => {
      view.plugin(delayedActions)?.cancel();
      return false;
    },
  },
];

function isWaiting(view: EditorView): boolean {
  return view.plugin(delayedActions)?.isWaiting === true;
}

/** Accepts the proposal with this label, if the list contains it. */
function acceptLabel(label: string): Command {
  return (view) => {
    const at = currentCompletions(view.state).findIndex((each) => each.label === label);
    if (at < 0) return false;
    view.dispatch({ effects: setSelectedCompletion(at) });
    return acceptCompletion(view);
  };
}

/** Covers a proposal: CodeMirror ignores clicks while the list is being updated, so they are delayed here. */
function clickTarget({ label }: Completion, _state: unknown, view: EditorView): Node {
  const surface = document.createElement('span');
  surface.className = 'cm-pressed-proposal';
  surface.addEventListener('mousedown', () => void delay(view, { run: acceptLabel(label), otherwise: () => true }));
  return surface;
}

function toCompletion({ label, text, fills, detail, kind }: CompletionItem): Completion {
  return {
    label,
    detail,
    type: kind,
    apply: fills.some(([from, to]) => from < to || to < text.length) ? snippet(snippetTemplate(text, fills)) : text,
  };
}

/** Replaces a range by a proposal and selects its first field. Undo removes it without the changes before and after. */
export function insertInto(view: EditorView, proposal: CompletionItem, from: number, to: number): void {
  const isolate = (): void => view.dispatch({ annotations: isolateHistory.of('full') });
  isolate();
  snippet(snippetTemplate(proposal.text, proposal.fills))(view, toCompletion(proposal), from, to);
  isolate();
}

/**
 * The text as a CodeMirror snippet, with a field for each place to fill in, then an empty one at the end: so the last
 * place is still a field, and Tab leads from there to the end.
 */
function snippetTemplate(text: string, fills: CompletionItem['fills']): string {
  let result = '';
  let at = 0;
  for (const [index, [from, to]] of fills.entries()) {
    result += `${text.slice(at, from)}\${${index + 1}:${text.slice(from, to)}}`;
    at = to;
  }
  return `${result}${text.slice(at)}\${${fills.length + 1}:}`;
}
