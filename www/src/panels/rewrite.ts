// The button "Write as a cycle" and its dialog: which plain moves can be written as a cycle, each as it is and as it would be.
//
// In: the offers, as an answer; those where the cursor stands come first. Out: `wanted` (the reader asks for them) and
// `taken` (one shall be carried out). Must not know: what a cycle is, or where the text goes.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { Rewriting } from '../protocol/protocol';

export interface RewriteEvents {
  wanted(): void;
  taken(rewriting: Rewriting): void;
}

export class RewriteDialog {
  readonly button = make('button', { type: 'button', className: 'rewrite-button quiet', 'aria-haspopup': 'dialog' });
  readonly #events: RewriteEvents;
  readonly #list = make('ul', { className: 'rewritings' });
  readonly #dialog = new Dialog('rewrite', [this.#list]);
  #strings: Strings;

  constructor(strings: Strings, events: RewriteEvents) {
    this.#strings = strings;
    this.#events = events;
    this.button.addEventListener('click', () => this.#events.wanted());
    this.available = false;
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    const texts = strings.rewrite;
    this.button.textContent = texts.button;
    this.button.title = texts.hint;
    this.#dialog.name(texts.title, strings.close);
  }

  /** Whether there is a finished run with motions. */
  set available(available: boolean) {
    this.button.disabled = !available;
  }

  get available(): boolean {
    return !this.button.disabled;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  show(rewritings: readonly Rewriting[]): void {
    const texts = this.#strings.rewrite;
    this.#dialog.about = rewritings.length === 0 ? texts.none : texts.about;
    this.#list.hidden = rewritings.length === 0;
    const ordered = [...rewritings.filter(({ here }) => here), ...rewritings.filter(({ here }) => !here)];
    this.#list.replaceChildren(...ordered.map((rewriting) => this.#item(rewriting)));
    this.#dialog.show();
    // What the cursor is in can be taken with Enter.
    this.#list.querySelector('button')?.focus();
  }

  #item(rewriting: Rewriting): HTMLElement {
    const texts = this.#strings.rewrite;
    const lines = texts.lines(rewriting.line, rewriting.endLine);
    const take = make('button', { type: 'button', className: 'framed', 'aria-label': `${texts.take}: ${lines}` }, texts.take);
    take.addEventListener('click', () => {
      this.#dialog.close();
      this.#events.taken(rewriting);
    });
    const code = (text: string): HTMLElement => make('pre', { lang: 'en' }, text);
    return make(
      'li', { className: rewriting.here ? 'here' : '' },
      make('h3', {}, rewriting.title), make('span', { className: 'lines' }, lines), take,
      make('div', { className: 'both' }, code(rewriting.before), make('span', { 'aria-hidden': 'true' }, '→'), code(rewriting.after)),
    );
  }
}
