// Breakpoints: lines before which the playback pauses. The user sets them in the gutter or by a key.
//
// In: clicks on line numbers; a line to toggle. Out: the breakpoints, which move with edits and are removed with their
// line; marks on the line numbers. Must not know: the playback.

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

/** Maximum number; every frame of the playback searches them. */
const MAX_BREAKPOINTS = 50;

/** Toggles the breakpoint of the line that starts at an offset. */
const toggle = StateEffect.define<number>();

class BreakpointMarker extends GutterMarker {
  override elementClass = 'cm-breakpoint';
}

const BREAKPOINT = new BreakpointMarker();

/** The start offsets of the lines with breakpoints, sorted. */
const lines = StateField.define<readonly number[]>({
  create: () => [],
  update(before, { changes, docChanged, effects, newDoc }) {
    let now = docChanged ? mapOffsets(before, changes, newDoc) : before;
    for (const effect of effects) {
      if (!effect.is(toggle)) continue;
      const others = now.filter((at) => at !== effect.value);
      now =
        others.length < now.length ? others : [...now, effect.value].sort((a, b) => a - b).slice(0, MAX_BREAKPOINTS);
    }
    return now;
  },
  provide: (field) => gutterLineClass.from(field, (starts) => RangeSet.of(starts.map((at) => BREAKPOINT.range(at)))),
});

function mapOffsets(before: readonly number[], changes: ChangeDesc, doc: Text): readonly number[] {
  const places = before.map((at) => changes.mapPos(at, 1, MapMode.TrackDel)).filter((at): at is number => at !== null);
  return [...new Set(places.map((at) => doc.lineAt(at).from))];
}

/** Clickable line numbers. */
export const breakpoints: Extension = [
  lines,
  lineNumbers({
    domEventHandlers: {
      mousedown(view, line, event) {
        // Prevents a change of the focus.
        event.preventDefault();
        toggleBreakpoint(view, line.from);
        return true;
      },
    },
  }),
];

/** Toggles the breakpoint of the line at an offset. Returns whether it is set now. */
export function toggleBreakpoint(view: EditorView, offset: number): boolean {
  const { from } = view.state.doc.lineAt(offset);
  view.dispatch({ effects: toggle.of(from) });
  return view.state.field(lines).includes(from);
}

/** The lines with breakpoints, from 0, sorted. */
export function breakpointsOf(state: EditorState): number[] {
  return state.field(lines).map((at) => state.doc.lineAt(at).number - 1);
}
