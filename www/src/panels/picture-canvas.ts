// The canvas that shows a picture, with limited memory.
//
// In: images of the worker. Out: a request for the image again. A canvas far from the viewport keeps only a small copy
// of its picture, so that a manual with thirty drawings needs little memory; the full image is restored before the user
// scrolls to it. A print shows the copy. Must not know: the contents of a picture.

import { make } from '../dom/dom';

/** Margin of the viewport within which a picture keeps its full size, relative to the window. */
const VIEWPORT_MARGIN = '100%';
/** Pixels of the picture for one pixel of the copy, in each direction. */
const COPY_SCALE = 2;
const SHRINK_AFTER_MS = 1_000;

export class PictureCanvas {
  readonly element = make('canvas', { tabIndex: 0, role: 'img', part: 'canvas' });
  readonly #context = this.element.getContext('bitmaprenderer');
  readonly #requestPicture: () => void;
  #isFar = false;
  /** Number of images shown. A copy of an earlier image is discarded. */
  #imageCount = 0;
  #isCopy = false;
  #shrinkTimer: ReturnType<typeof setTimeout> | undefined;

  /** `requestPicture` is called to request the same picture again. */
  constructor(requestPicture: () => void) {
    this.#requestPicture = requestPicture;
    new IntersectionObserver((entries) => this.#onIntersection(entries.at(-1)), {
      rootMargin: VIEWPORT_MARGIN,
    }).observe(this.element);
  }

  /** Shows a picture in place of the previous one. */
  show(image: ImageBitmap): void {
    this.#transfer(image);
    this.#isCopy = false;
    this.#scheduleShrink();
  }

  #transfer(image: ImageBitmap): void {
    const [{ element: canvas }, { width, height }] = [this, image];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    this.#context?.transferFromImageBitmap(image);
    this.#imageCount++;
  }

  #onIntersection(entry: IntersectionObserverEntry | undefined): void {
    if (entry === undefined) return;
    // A hidden picture, for example on another tab, is not far.
    this.#isFar = !entry.isIntersecting && entry.boundingClientRect.width > 0;
    this.#scheduleShrink();
    if (this.#isFar || !this.#isCopy) return;
    this.#isCopy = false;
    this.#requestPicture();
  }

  #scheduleShrink(): void {
    clearTimeout(this.#shrinkTimer);
    if (this.#isFar && !this.#isCopy && this.#imageCount > 0)
      this.#shrinkTimer = setTimeout(() => void this.#shrink(), SHRINK_AFTER_MS);
  }

  async #shrink(): Promise<void> {
    const { element: canvas } = this;
    const size = (pixels: number): number => Math.max(Math.ceil(pixels / COPY_SCALE), 1);
    const before = this.#imageCount;
    // If the browser cannot make a copy, the picture keeps its full size.
    const copy = await createImageBitmap(canvas, {
      resizeWidth: size(canvas.width),
      resizeHeight: size(canvas.height),
      resizeQuality: 'medium',
    }).catch(() => undefined);
    if (copy === undefined) return;
    if (!this.#isFar || this.#isCopy || this.#imageCount !== before) return copy.close();
    this.#transfer(copy);
    this.#isCopy = true;
  }
}
