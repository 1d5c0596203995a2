// Lines before which the tool is held while it plays: the reader marks them beside the text, or by a key.
//
// In: clicks on the line numbers; a line to mark. Out: the lines, which move with every change of the text and go with their
// line; a mark on their numbers. Must not know: what is played.

import {
  MapMode,
  RangeSet,
  StateEffect,
  StateField,
  type ChangeDesc,
  type EditorState,
  type Extension,
  type Text,
} from '@codemirror/state';
import { gutterLineClass, GutterMarker, lineNumbers, type EditorView } from '@codemirror/view';

/** Most of them: each is looked for with every frame. */
const MOST = 50;

/** Marks the line that begins at an offset, or takes its mark away. */
const toggle = StateEffect.define<number>();

class Marked extends GutterMarker {
  override elementClass = 'cm-breakpoint';
}

const MARKED = new Marked();

/** Where the marked lines begin, in order. */
const lines = StateField.define<readonly number[]>({
  create: () => [],
  update(before, { changes, docChanged, effects, newDoc }) {
    let now = docChanged ? moved(before, changes, newDoc) : before;
    for (const effect of effects) {
      if (!effect.is(toggle)) continue;
      const others = now.filter((at) => at !== effect.value);
      now = others.length < now.length ? others : [...now, effect.value].sort((a, b) => a - b).slice(0, MOST);
    }
    return now;
  },
  provide: (field) => gutterLineClass.from(field, (starts) => RangeSet.of(starts.map((at) => MARKED.range(at)))),
});

function moved(before: readonly number[], changes: ChangeDesc, doc: Text): readonly number[] {
  const places = before.map((at) => changes.mapPos(at, 1, MapMode.TrackDel)).filter((at): at is number => at !== null);
  return [...new Set(places.map((at) => doc.lineAt(at).from))];
}

/** Line numbers that can be clicked. */
export const breakpoints: Extension = [
  lines,
  lineNumbers({
    domEventHandlers: {
      mousedown(view, line, event) {
        // The editor keeps the focus it has, or has not.
        event.preventDefault();
        toggleBreakpoint(view, line.from);
        return true;
      },
    },
  }),
];

/** Says whether the line of an offset is marked now. */
export function toggleBreakpoint(view: EditorView, offset: number): boolean {
  const { from } = view.state.doc.lineAt(offset);
  view.dispatch({ effects: toggle.of(from) });
  return view.state.field(lines).includes(from);
}

/** The marked lines, from 0, in order. */
export function breakpointsOf(state: EditorState): number[] {
  return state.field(lines).map((at) => state.doc.lineAt(at).number - 1);
}
