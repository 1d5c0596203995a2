// One line of news above the program: something failed, a file was opened.
//
// In: a text and what it is about. Out: nothing; the reader can dismiss it.
// Must not know: who says it.

import { make, name } from '../dom/dom';
import type { Strings } from '../dom/i18n';

export type Topic = 'file' | 'program' | 'program-setup' | 'setup' | 'core';

export class Notice {
  readonly element = make('div', { className: 'notice', part: 'notice', role: 'alert', hidden: true });
  readonly #text = make('p');
  readonly #close = make('button', { type: 'button', className: 'quiet' }, '×');
  #topic: Topic | undefined;

  constructor(strings: Strings) {
    this.#close.addEventListener('click', () => this.#hide());
    this.element.append(this.#text, this.#close);
    this.strings = strings;
  }

  set strings(strings: Strings) {
    name(this.#close, strings.dismiss);
  }

  show(text: string, topic: Topic = 'file'): void {
    this.#topic = topic;
    this.#text.textContent = text;
    this.element.hidden = false;
  }

  /** Hides the notice when it is about this; another one stays. */
  hide(topic: Topic): void {
    if (this.#topic === topic) this.#hide();
  }

  #hide(): void {
    this.#topic = undefined;
    this.element.hidden = true;
  }
}
