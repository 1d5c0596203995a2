// Keeps the running block visible, unless the user is looking elsewhere.
//
// In: the editor's view, a position in its text. Out: the scrolled editor; the page around does not scroll. Must not
// know: the playback.

import type { EditorView } from '@codemirror/view';

/** How long to pause after the user has scrolled or typed, ms. */
const PAUSE_AFTER_INPUT_MS = 4000;
/** Margin above and below the block, lines. */
const MARGIN_LINES = 2.5;

export class Follower {
  readonly #view: EditorView;
  #pausedUntil = 0;

  constructor(view: EditorView) {
    this.#view = view;
    const pause = (): void => {
      this.#pausedUntil = performance.now() + PAUSE_AFTER_INPUT_MS;
    };
    for (const type of ['wheel', 'touchmove', 'keydown'] as const)
      view.dom.addEventListener(type, pause, { passive: true });
    view.dom.addEventListener('pointerdown', () => {
      // The user may hold the scroll bar for long.
      this.#pausedUntil = Infinity;
      for (const type of ['pointerup', 'pointercancel'] as const) addEventListener(type, pause, { once: true });
    });
  }

  /** Ends the pause: the user has asked to see the running block. */
  resume(): void {
    this.#pausedUntil = 0;
  }

  /** Scrolls to a position of the text. */
  reveal(offset: number): void {
    if (performance.now() < this.#pausedUntil) return;
    const { scrollDOM, documentPadding, defaultLineHeight } = this.#view;
    const block = this.#view.lineBlockAt(offset);
    const margin = MARGIN_LINES * defaultLineHeight;
    const [top, bottom] = [block.top + documentPadding.top - margin, block.bottom + documentPadding.top + margin];
    // An effect of the view would also scroll the page around the editor.
    if (top < scrollDOM.scrollTop) scrollDOM.scrollTop = Math.max(top, 0);
    else if (bottom > scrollDOM.scrollTop + scrollDOM.clientHeight)
      scrollDOM.scrollTop = bottom - scrollDOM.clientHeight;
  }
}
