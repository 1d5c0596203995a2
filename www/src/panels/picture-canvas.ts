// The canvas that shows a picture, with limited memory.
//
// In: images of the worker. Out: a request for the image again. A canvas far from the viewport keeps only a small copy
// of its picture, so that a manual with thirty drawings needs little memory; the full image is restored before the user
// scrolls to it. A print shows the copy. Must not know: the contents of a picture.

import { make } from '../dom/dom';

/** Margin of the viewport within which a picture keeps its full size, relative to the window. */
const NEAR = '100%';
/** Pixels of the picture for one pixel of the copy, in each direction. */
const COARSER = 2;
const REST_AFTER_MS = 1_000;

export class PictureCanvas {
  readonly element = make('canvas', { tabIndex: 0, role: 'img', part: 'canvas' });
  readonly #context = this.element.getContext('bitmaprenderer');
  readonly #wanted: () => void;
  #isFar = false;
  /** Number of images shown. A copy of an earlier image is discarded. */
  #shown = 0;
  #isCopy = false;
  #rest: ReturnType<typeof setTimeout> | undefined;

  /** `wanted` is called to request the same picture again. */
  constructor(wanted: () => void) {
    this.#wanted = wanted;
    new IntersectionObserver((entries) => this.#moved(entries.at(-1)), { rootMargin: NEAR }).observe(this.element);
  }

  /** Shows a picture in place of the previous one. */
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
    // A hidden picture, for example on another tab, is not far.
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
    // If the browser cannot make a copy, the picture keeps its full size.
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
