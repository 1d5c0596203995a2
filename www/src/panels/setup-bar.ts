// The button that opens the setup form, and beside it whether tools are assumed.
//
// In: what is given and what is assumed. Out: `wanted`. Must not know: how anything is assumed.

import { make } from '../dom/dom';
import type { Fitted } from '../protocol/protocol';
import type { Strings } from '../dom/i18n';

export class SetupBar {
  readonly button = make('button', { type: 'button', className: 'setup-button', 'aria-haspopup': 'dialog' });
  readonly #assumed = make('span', { className: 'assumed' });
  readonly element = make('div', { className: 'setup-bar', part: 'setup' }, this.button, this.#assumed);
  #strings: Strings;
  #fitted: Fitted | undefined;

  constructor(strings: Strings, wanted: () => void) {
    this.#strings = strings;
    this.button.addEventListener('click', wanted);
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.button.textContent = strings.setup.setup;
    this.#render();
  }

  set fitted(fitted: Fitted) {
    this.#fitted = fitted;
    this.#render();
  }

  #render(): void {
    this.#assumed.textContent = this.#strings.setup.toolsAssumed;
    this.#assumed.hidden = !(this.#fitted?.tools.some(({ known }) => known === 'guessed') ?? false);
  }
}
