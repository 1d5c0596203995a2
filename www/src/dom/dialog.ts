// A modal dialog: a heading, a line that explains it, the contents, and buttons; the last button is Close.
//
// In: the contents between heading and buttons. Out: an element to put into the page. A click outside the dialog closes
// it. Must not know: the purpose of its contents.

import { make } from './dom';

export class Dialog {
  readonly element: HTMLDialogElement;
  readonly #title: HTMLElement;
  readonly #about = make('p', { className: 'about' });
  readonly #close = make('button', { type: 'button', className: 'framed' });

  /** `name` is its class and part; `actions` come before the Close button. */
  constructor(name: string, body: readonly Node[], actions: readonly Node[] = []) {
    this.#title = make('h2', { id: `${name}-title` });
    this.element = make(
      'dialog',
      { className: `dialog ${name}`, part: name, 'aria-labelledby': this.#title.id },
      this.#title,
      this.#about,
      ...body,
      make('div', { className: 'actions' }, ...actions, this.#close),
    );
    this.#close.addEventListener('click', () => this.close());
    // A click outside the dialog arrives at the dialog element, but outside its box.
    this.element.addEventListener('click', (event) => {
      if (event.target !== this.element) return;
      const { left, right, top, bottom } = this.element.getBoundingClientRect();
      const inside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
      if (!inside) this.close();
    });
  }

  /** Sets the heading, and the text of the last button. */
  setTexts(title: string, close: string): void {
    this.#title.textContent = title;
    this.#close.textContent = close;
  }

  set about(text: string) {
    this.#about.textContent = text;
  }

  get open(): boolean {
    return this.element.open;
  }

  /** Opens the dialog; returns false if it was already open. */
  show(): boolean {
    if (this.element.open) return false;
    this.element.showModal();
    return true;
  }

  close(): void {
    this.element.close();
  }
}
