// Prints the program as text, if the element shows only its picture or its panels are not loaded yet.
//
// In: the print events. Out: an element that is visible only in print. Must not know: the content of a program.

import { make } from '../dom/dom';
import { isPrinting } from '../dom/printing';

/** UTF-16 units; the rest of a longer program is not printed. */
const MAX_LENGTH = 200_000;

export class Paper {
  readonly element = make('pre', { className: 'paper', lang: 'en' });
  readonly #text: (from: number, to: number) => string;
  #isEnded = false;

  constructor(text: (from: number, to: number) => string) {
    this.#text = text;
  }

  connect(): void {
    if (this.#isEnded) return;
    // If printing has already started, the event `beforeprint` is over.
    if (isPrinting()) queueMicrotask(this.#fill);
    window.addEventListener('beforeprint', this.#fill);
    window.addEventListener('afterprint', this.#clear);
  }

  disconnect(): void {
    window.removeEventListener('beforeprint', this.#fill);
    window.removeEventListener('afterprint', this.#clear);
  }

  /** The panels are loaded; they have their own print layout. */
  end(): void {
    this.#isEnded = true;
    this.disconnect();
    this.element.remove();
  }

  readonly #fill = (): void => this.element.replaceChildren(this.#text(0, MAX_LENGTH));
  readonly #clear = (): void => this.element.replaceChildren();
}
