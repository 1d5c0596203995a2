// Makes the element as high as its contents: the program with a limited number of lines, and the drawing with its least
// height beside or above it; without a program, the drawing in proportion to its width.
//
// In: the sizes of the regions, the number of lines. Out: a style sheet of the element with its height. Must not know:
// the contents of the regions. Loaded by `auto-height`.

import { inNextFrame } from '../worker/frame';
import type { Program } from '../editor/program';
import type { Rows } from './author';
import type { Layout } from './layout';
import type { PendingParts } from './pending-parts';

/** Heights of the drawing, CSS pixels; without a program it has this share of its width. */
const LEAST_DRAWING_PX = 240;
const LARGEST_DRAWING_PX = 540;
const DRAWING_SHARE = 9 / 16;
/** The layout depends on the height, so the height is found in a few passes. */
const MAX_PASSES = 8;

interface ContentHeightOptions {
  readonly root: ShadowRoot;
  readonly layout: Layout;
  readonly editor: Program;
  readonly pending: PendingParts;
}

export class ContentHeight {
  readonly #options: ContentHeightOptions;
  readonly #sheet = new CSSStyleSheet();
  readonly #sizes = new ResizeObserver(() => this.update());
  readonly #editorLoaded = new MutationObserver(() => this.update());
  #rows: Rows = { min: 1, max: 1 };
  #cancelUpdate: (() => void) | undefined;

  constructor(options: ContentHeightOptions) {
    this.#options = options;
    const { root, layout, editor } = options;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, this.#sheet];
    const { head, bar, notices, views, assumptions, pictures, playback } = layout.regions;
    for (const region of [layout.frame, editor.element, head, bar, notices, views, assumptions, pictures, playback])
      this.#sizes.observe(region);
    this.#editorLoaded.observe(editor.element, { childList: true });
    // While the user types, the element only grows.
    editor.element.addEventListener('focusout', this.update);
  }

  set rows(rows: Rows) {
    this.#rows = rows;
    this.update();
  }

  /** Finds the height before the next frame is painted. */
  readonly update = (): void => {
    if (this.#cancelUpdate !== undefined) return;
    const { pending } = this.#options;
    pending.add('height');
    this.#cancelUpdate = inNextFrame(() => {
      this.#cancelUpdate = undefined;
      this.#fit();
      pending.finish('height');
    });
  };

  end(): void {
    const { root, editor, pending } = this.#options;
    this.#sizes.disconnect();
    this.#editorLoaded.disconnect();
    editor.element.removeEventListener('focusout', this.update);
    root.adoptedStyleSheets = root.adoptedStyleSheets.filter((sheet) => sheet !== this.#sheet);
    if (this.#cancelUpdate === undefined) return;
    this.#cancelUpdate();
    pending.finish('height');
  }

  #fit(): void {
    const { root, layout, editor } = this.#options;
    const host = root.host as HTMLElement;
    if (host.offsetHeight === 0 || layout.frame.dataset['presenting'] !== undefined) return;
    const isTyping = editor.element.contains(root.activeElement);
    for (let pass = 0; pass < MAX_PASSES; pass++) {
      const missing = this.#missing();
      // Only the first pass makes it lower: two layouts could otherwise alternate.
      if (Math.abs(missing) < 1 || (missing < 0 && (pass > 0 || isTyping))) return;
      this.#setHeight(host.offsetHeight + missing);
    }
  }

  #setHeight(height: number): void {
    this.#sheet.replaceSync(
      `:host { block-size: ${height}px; } .frame[data-view] { --least-drawing: ${LEAST_DRAWING_PX}px; --least-share: 0px; }`,
    );
  }

  /** By how much the element is too low, CSS pixels; negative: too high. */
  #missing(): number {
    const program = this.#missingForProgram();
    const drawing = this.#missingForDrawing(program !== undefined);
    if (program === undefined || drawing === undefined) return program ?? drawing ?? 0;
    return this.#isSideBySide ? Math.max(program, drawing) : program;
  }

  get #isSideBySide(): boolean {
    const { editor, layout } = this.#options;
    return leftOf(editor.element) !== leftOf(layout.regions.pictures);
  }

  /** Undefined if the view has no program; 0 if a tab hides it. */
  #missingForProgram(): number | undefined {
    const { element, rows } = this.#options.editor;
    if (!element.isConnected) return undefined;
    // The second one is the text before the editor is loaded.
    const content = element.querySelector('.cm-content, .waiting');
    if (content === null || !element.checkVisibility()) return 0;
    const scroller = element.querySelector('.cm-scroller') ?? content;
    const { lineHeight, paddingBlockStart, paddingBlockEnd } = getComputedStyle(content);
    const padding = pixels(paddingBlockStart) + pixels(paddingBlockEnd);
    const wanted = limited(rows, this.#rows.min, this.#rows.max) * pixels(lineHeight) + padding;
    const least = pixels(getComputedStyle(element).minBlockSize);
    return Math.ceil(Math.max(wanted, least) - scroller.clientHeight + overflowOf(element.parentElement));
  }

  /** Undefined if the view has no drawing. */
  #missingForDrawing(hasProgram: boolean): number | undefined {
    const { pictures } = this.#options.layout.regions;
    if (!pictures.isConnected) return undefined;
    const wanted = hasProgram
      ? LEAST_DRAWING_PX
      : limited(pictures.offsetWidth * DRAWING_SHARE, LEAST_DRAWING_PX, LARGEST_DRAWING_PX);
    return Math.ceil(wanted - pictures.offsetHeight + overflowOf(pictures.parentElement));
  }
}

function leftOf(element: Element): number {
  return element.getBoundingClientRect().left;
}

function overflowOf(scroller: Element | null): number {
  return scroller === null ? 0 : scroller.scrollHeight - scroller.clientHeight;
}

function limited(value: number, least: number, most: number): number {
  return Math.min(Math.max(value, least), most);
}

/** A length of a computed style. */
function pixels(length: string): number {
  return Number.parseFloat(length) || 0;
}
