// Keeps the caret in view when the editor becomes lower: a panel beside it has grown, or the keyboard of a phone has
// opened.
//
// In: the height of the editor. Out: scrolls to a caret that was in view before. Must not know: the cause.

import { EditorView, ViewPlugin } from '@codemirror/view';

/** Distance between the caret and the edge, CSS pixels. */
const MARGIN_PX = 12;

export const keepCaretInView = ViewPlugin.fromClass(
  class {
    readonly #observer: ResizeObserver;

    constructor(view: EditorView) {
      let height = view.scrollDOM.clientHeight;
      this.#observer = new ResizeObserver(() => {
        const before = height;
        height = view.scrollDOM.clientHeight;
        const { head } = view.state.selection.main;
        // Not `view.hasFocus`: in WebKit a window has no focus while it changes its size.
        const focused = view.root.activeElement === view.contentDOM;
        const caret = height < before && focused ? view.coordsAtPos(head) : null;
        if (caret === null) return;
        const bottom = caret.bottom - view.scrollDOM.getBoundingClientRect().top;
        if (bottom > before || bottom + MARGIN_PX <= height) return;
        view.dispatch({ effects: EditorView.scrollIntoView(head, { y: 'nearest', yMargin: MARGIN_PX }) });
      });
      this.#observer.observe(view.scrollDOM);
    }

    destroy(): void {
      this.#observer.disconnect();
    }
  },
);
