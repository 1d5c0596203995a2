// The tooltip of the word under the pointer.
//
// In: the position of the pointer. Out: the interpreter's help for the word there. Must not know: the content of the
// help.

import { forEachDiagnostic } from '@codemirror/lint';
import type { EditorState, Extension } from '@codemirror/state';
import { EditorView, hoverTooltip, type Tooltip } from '@codemirror/view';
import type { EditorEvents } from './text-store';
import { wordCard } from './word-help';

/** How long the pointer must rest before help is requested. */
const HOVER_DELAY_MS = 350;

export function wordHover(events: EditorEvents): Extension {
  const source = async (view: EditorView, at: number): Promise<Tooltip | null> => {
    // There is no help between words. A problem has priority: with both, the tooltip would move under the pointer.
    if (!/\S/.test(view.state.sliceDoc(at, at + 1)) || hasProblem(view.state, at)) return null;
    const { doc } = view.state;
    const help = await events.wordAt(at);
    if (help === undefined || view.state.doc !== doc || help.to > doc.length || hasProblem(view.state, at)) return null;
    // Above, like the problems, so that the following lines stay visible.
    return {
      pos: help.from,
      end: help.to,
      above: true,
      create: () => ({ dom: wordCard(help, (offset) => goTo(view, offset)) }),
    };
  };
  return hoverTooltip(source, { hoverTime: HOVER_DELAY_MS, hideOnChange: true });
}

function hasProblem(state: EditorState, at: number): boolean {
  let found = false;
  forEachDiagnostic(state, (_, from, to) => {
    found ||= from <= at && at <= to;
  });
  return found;
}

/** Moves the cursor to a block, as if the user had placed it there. */
function goTo(view: EditorView, offset: number): void {
  if (offset > view.state.doc.length) return;
  view.dispatch({
    selection: { anchor: offset },
    effects: EditorView.scrollIntoView(offset, { y: 'center' }),
    userEvent: 'select',
  });
  view.focus();
}
