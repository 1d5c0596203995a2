// A dialog over the page: a heading, a line about it, what it is for, and buttons; Close is the last of them.
//
// In: the parts between heading and buttons. Out: an element to put into the page. A click beside it closes
// it. Must not know: what it shows.

import { make } from './dom';

export class Dialog {
  readonly element: HTMLDialogElement;
  readonly #title: HTMLElement;
  readonly #about = make('p', { className: 'about' });
  readonly #close = make('button', { type: 'button', className: 'framed' });

  /** `name` is its class and part; `actions` stand before the button that closes it. */
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
    // A click beside the dialog is a click on the dialog itself, outside its box.
    this.element.addEventListener('click', (event) => {
      if (event.target !== this.element) return;
      const { left, right, top, bottom } = this.element.getBoundingClientRect();
      const inside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
      if (!inside) this.close();
    });
  }

  /** What it is called, and what its last button says. */
  name(title: string, close: string): void {
    this.#title.textContent = title;
    this.#close.textContent = close;
  }

  set about(text: string) {
    this.#about.textContent = text;
  }

  get open(): boolean {
    return this.element.open;
  }

  /** Opens it; false where it was open already. */
  show(): boolean {
    if (this.element.open) return false;
    this.element.showModal();
    return true;
  }

  close(): void {
    this.element.close();
  }
}
