// Keeps the block that runs in sight, unless the reader is looking at another one.
//
// In: the editor's view, a place in its text. Out: the editor scrolled, and nothing around it.
// Must not know: what runs.

import type { EditorView } from '@codemirror/view';

/** A reader who has scrolled or typed is left alone for so long, ms. */
const LEFT_ALONE = 4000;
/** Kept free above and below the block, lines. */
const MARGIN_LINES = 2.5;

export class Follower {
  readonly #view: EditorView;
  #leftAloneUntil = 0;

  constructor(view: EditorView) {
    this.#view = view;
    const leaveAlone = (): void => {
      this.#leftAloneUntil = performance.now() + LEFT_ALONE;
    };
    for (const type of ['wheel', 'touchmove', 'keydown'] as const)
      view.dom.addEventListener(type, leaveAlone, { passive: true });
    view.dom.addEventListener('pointerdown', () => {
      // The scroll bar may be held for long.
      this.#leftAloneUntil = Infinity;
      for (const type of ['pointerup', 'pointercancel'] as const) addEventListener(type, leaveAlone, { once: true });
    });
  }

  /** The reader has asked to see what runs. */
  resume(): void {
    this.#leftAloneUntil = 0;
  }

  /** Brings a place of the text into sight. */
  show(place: number): void {
    if (performance.now() < this.#leftAloneUntil) return;
    const { scrollDOM, documentPadding, defaultLineHeight } = this.#view;
    const block = this.#view.lineBlockAt(place);
    const margin = MARGIN_LINES * defaultLineHeight;
    const [top, bottom] = [block.top + documentPadding.top - margin, block.bottom + documentPadding.top + margin];
    // Not by an effect of the view: that would scroll the page around the editor too.
    if (top < scrollDOM.scrollTop) scrollDOM.scrollTop = Math.max(top, 0);
    else if (bottom > scrollDOM.scrollTop + scrollDOM.clientHeight)
      scrollDOM.scrollTop = bottom - scrollDOM.clientHeight;
  }
}
