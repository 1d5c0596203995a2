// A modal dialog: a title with a button that closes it, a line that explains it, the contents, and buttons, of which the
// last is the main one.
//
// In: the contents and the buttons. Out: an element to put into the page. A click outside the dialog closes it. Must not
// know: the purpose of its contents.

import { icon, make, setAccessibleName } from './dom';

/** The title of a dialog, with the button that closes it. */
export class DialogHead {
  readonly title: HTMLElement;
  readonly close = make('button', { type: 'button', className: 'close' }, icon('whole'));
  readonly element: HTMLElement;

  constructor(name: string) {
    this.title = make('h2', { id: `${name}-title` });
    this.element = make('div', { className: 'dialog-head' }, this.title, this.close);
  }

  setTexts(title: string, close: string): void {
    this.title.textContent = title;
    setAccessibleName(this.close, close);
  }
}

export class Dialog {
  readonly element: HTMLDialogElement;
  /** The contents; it scrolls if they do not fit. */
  readonly body: HTMLElement;
  readonly #head: DialogHead;
  readonly #about = make('p', { className: 'about', hidden: true });

  /** `name` is its class and part; the last of `actions` is the main one. */
  constructor(name: string, body: readonly Node[], actions: readonly Node[] = []) {
    this.#head = new DialogHead(name);
    this.body = make('div', { className: 'dialog-body' }, ...body);
    this.element = make(
      'dialog',
      { className: `dialog ${name}`, part: name, 'aria-labelledby': this.#head.title.id },
      this.#head.element,
      this.#about,
      this.body,
      make('div', { className: 'actions' }, ...actions),
    );
    this.#head.close.addEventListener('click', () => this.close());
    // A press outside the dialog arrives at the dialog element, but outside its box. A press inside that ends outside
    // selects text.
    let isOutside = false;
    this.element.addEventListener('pointerdown', (event) => {
      isOutside = event.target === this.element && !contains(this.element, event);
    });
    this.element.addEventListener('click', (event) => {
      if (isOutside && event.target === this.element) this.close();
    });
  }

  /** Sets the title, and the name of the button that closes the dialog. */
  setTexts(title: string, close: string): void {
    this.#head.setTexts(title, close);
  }

  set about(text: string) {
    this.#about.textContent = text;
    this.#about.hidden = text === '';
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

function contains(element: HTMLElement, { clientX, clientY }: PointerEvent): boolean {
  const { left, right, top, bottom } = element.getBoundingClientRect();
  return clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
}
