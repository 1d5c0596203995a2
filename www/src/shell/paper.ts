// The program on paper, in its own lines, where the element shows only its picture.
//
// In: that the page is printed. Out: an element that only a printer shows. Must not know: what is in a program.

import { make } from '../dom/dom';

/** UTF-16 units; more is for nobody. */
const MOST = 200_000;

export class Paper {
  readonly element = make('pre', { className: 'paper', lang: 'en' });
  readonly #text: (from: number, to: number) => string;

  constructor(text: (from: number, to: number) => string) {
    this.#text = text;
  }

  connect(): void {
    window.addEventListener('beforeprint', this.#before);
    window.addEventListener('afterprint', this.#after);
  }

  disconnect(): void {
    window.removeEventListener('beforeprint', this.#before);
    window.removeEventListener('afterprint', this.#after);
  }

  readonly #before = (): void => this.element.replaceChildren(this.#text(0, MOST));
  readonly #after = (): void => this.element.replaceChildren();
}
