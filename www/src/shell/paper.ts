// The program on paper, in its own lines, where the element shows only its picture, or what else it shows has not come yet.
//
// In: that the page is printed. Out: an element that only a printer shows. Must not know: what is in a program.

import { make } from '../dom/dom';
import { isPrinting } from '../dom/printing';

/** UTF-16 units; more is for nobody. */
const MOST = 200_000;

export class Paper {
  readonly element = make('pre', { className: 'paper', lang: 'en' });
  readonly #text: (from: number, to: number) => string;
  #isEnded = false;

  constructor(text: (from: number, to: number) => string) {
    this.#text = text;
  }

  connect(): void {
    if (this.#isEnded) return;
    // It was made to be printed: that has been announced.
    if (isPrinting()) queueMicrotask(this.#before);
    window.addEventListener('beforeprint', this.#before);
    window.addEventListener('afterprint', this.#after);
  }

  disconnect(): void {
    window.removeEventListener('beforeprint', this.#before);
    window.removeEventListener('afterprint', this.#after);
  }

  /** Something better has come. */
  end(): void {
    this.#isEnded = true;
    this.disconnect();
    this.element.remove();
  }

  readonly #before = (): void => this.element.replaceChildren(this.#text(0, MOST));
  readonly #after = (): void => this.element.replaceChildren();
}
