// The canvas that shows a picture, and what it takes of memory.
//
// In: images of the worker. Out: that an image is wanted again. Far from the view a canvas keeps a small copy of its
// picture, so that a manual with thirty drawings takes little; it is whole again before the reader is there. On paper
// the copy is what is printed of it. Must not know: what is in a picture.

import { make } from '../dom/dom';

/** How far from the view a picture is whole, in sizes of the window. */
const NEAR = '100%';
/** The copy has one pixel for so many, in each direction. */
const COARSER = 2;
const REST_AFTER_MS = 1_000;

export class PictureCanvas {
  readonly element = make('canvas', { tabIndex: 0, role: 'img', part: 'canvas' });
  readonly #context = this.element.getContext('bitmaprenderer');
  readonly #wanted: () => void;
  #isFar = false;
  /** The images shown so far: a copy of an earlier one is of no use. */
  #shown = 0;
  #isCopy = false;
  #rest: ReturnType<typeof setTimeout> | undefined;

  /** `wanted` is called when the picture is to be painted once more as it is. */
  constructor(wanted: () => void) {
    this.#wanted = wanted;
    new IntersectionObserver((entries) => this.#moved(entries.at(-1)), { rootMargin: NEAR }).observe(this.element);
  }

  /** Shows a picture in place of the one before. */
  show(image: ImageBitmap): void {
    this.#put(image);
    this.#isCopy = false;
    this.#restSoon();
  }

  #put(image: ImageBitmap): void {
    const [{ element: canvas }, { width, height }] = [this, image];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    this.#context?.transferFromImageBitmap(image);
    this.#shown++;
  }

  #moved(entry: IntersectionObserverEntry | undefined): void {
    if (entry === undefined) return;
    // What is hidden for a while, as on another tab, is not far.
    this.#isFar = !entry.isIntersecting && entry.boundingClientRect.width > 0;
    this.#restSoon();
    if (this.#isFar || !this.#isCopy) return;
    this.#isCopy = false;
    this.#wanted();
  }

  #restSoon(): void {
    clearTimeout(this.#rest);
    if (this.#isFar && !this.#isCopy && this.#shown > 0)
      this.#rest = setTimeout(() => void this.#keepCopy(), REST_AFTER_MS);
  }

  async #keepCopy(): Promise<void> {
    const { element: canvas } = this;
    const size = (pixels: number): number => Math.max(Math.ceil(pixels / COARSER), 1);
    const before = this.#shown;
    // Where an engine cannot make a copy, the picture stays as it is.
    const copy = await createImageBitmap(canvas, {
      resizeWidth: size(canvas.width),
      resizeHeight: size(canvas.height),
      resizeQuality: 'medium',
    }).catch(() => undefined);
    if (copy === undefined) return;
    if (!this.#isFar || this.#isCopy || this.#shown !== before) return copy.close();
    this.#put(copy);
    this.#isCopy = true;
  }
}
