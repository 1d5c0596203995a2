// The tooltip of the word under the pointer.
//
// In: the place of the pointer. Out: what the word there is, as the interpreter answers. Must not know: what that is.

import { forEachDiagnostic } from '@codemirror/lint';
import type { EditorState, Extension } from '@codemirror/state';
import { EditorView, hoverTooltip, type Tooltip } from '@codemirror/view';
import type { EditorEvents } from './holder';
import { wordCard } from './word-help';

/** The pointer rests so long before the word is asked about. */
const REST_MS = 350;

export function wordHover(events: EditorEvents): Extension {
  const source = async (view: EditorView, at: number): Promise<Tooltip | null> => {
    // Between words there is nothing to ask about. What is wrong with a word comes first: both in one would move under the pointer.
    if (!/\S/.test(view.state.sliceDoc(at, at + 1)) || hasProblem(view.state, at)) return null;
    const { doc } = view.state;
    const help = await events.wordAt(at);
    if (help === undefined || view.state.doc !== doc || help.to > doc.length || hasProblem(view.state, at)) return null;
    // Above, as the problems: the lines that follow stay in sight.
    return {
      pos: help.from,
      end: help.to,
      above: true,
      create: () => ({ dom: wordCard(help, (offset) => go(view, offset)) }),
    };
  };
  return hoverTooltip(source, { hoverTime: REST_MS, hideOnChange: true });
}

function hasProblem(state: EditorState, at: number): boolean {
  let found = false;
  forEachDiagnostic(state, (_, from, to) => {
    found ||= from <= at && at <= to;
  });
  return found;
}

/** The cursor goes to a block, as if the reader had put it there. */
function go(view: EditorView, offset: number): void {
  if (offset > view.state.doc.length) return;
  view.dispatch({
    selection: { anchor: offset },
    effects: EditorView.scrollIntoView(offset, { y: 'center' }),
    userEvent: 'select',
  });
  view.focus();
}
