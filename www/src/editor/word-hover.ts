// The tooltip of the word under the pointer.
//
// In: the position of the pointer. Out: the interpreter's help for the word there. Must not know: the content of the
// help.

import { forEachDiagnostic } from '@codemirror/lint';
import type { EditorState, Extension } from '@codemirror/state';
import { EditorView, hoverTooltip, type Tooltip } from '@codemirror/view';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { WordHelp } from '../protocol/protocol';
import { wordAt } from './place-help';
import type { EditorEvents } from './text-store';
import { wordCard } from './word-help';

/** How long the pointer must rest before help is requested. */
const HOVER_DELAY_MS = 350;

/** `language` is called for each tooltip. */
export function wordHover(events: EditorEvents, language: () => Language): Extension {
  const source = async (view: EditorView, position: number, side: -1 | 1): Promise<Tooltip | null> => {
    // The character under the pointer.
    const at = side < 0 ? position - 1 : position;
    // There is no help between words. A problem has priority: with both, the tooltip would move under the pointer.
    if (!/\S/.test(view.state.sliceDoc(at, at + 1)) || hasProblem(view.state, at)) return null;
    const { doc } = view.state;
    let help: WordHelp | undefined = await wordAt(events.help(), at);
    // The interpreter describes the word that ends there, but the pointer is on the next character.
    if (view.state.doc === doc && doc.sliceString(at, at + 1) === ';' && (help === undefined || help.to <= at))
      help = { word: ';', title: WORDS[language()], facts: [], marks: [], calculators: [], from: at, to: at + 1 };
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

const WORDS = words({
  en: 'end of the block: the key EOB on the control',
  zh: '程序段结束：系统面板上的 EOB 键',
  ru: 'конец кадра: клавиша EOB на пульте',
});
