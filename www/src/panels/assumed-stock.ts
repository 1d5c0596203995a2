// The line that says that the stock is assumed and what was not checked because of it, and the button that takes it over.
//
// In: what is given and what is assumed; the answers of the setup form. Out: `taken`: the form with that stock filled in. Must not
// know: how a stock is assumed, or what a setup holds beyond the group of the stock.

import { make } from '../dom/dom';
import type { Fitted, SetupAnswer, SetupForm, SetupPlace } from '../protocol/protocol';
import type { SetupEntries } from './setup-form';

export interface AssumedStockEvents {
  form(): Promise<SetupForm | undefined>;
  read(entries: SetupEntries): Promise<SetupAnswer | undefined>;
  taken(answer: SetupAnswer, place: SetupPlace): void;
}

export class AssumedStock {
  readonly #text = make('span', { className: 'said' });
  readonly #use = make('button', { type: 'button', className: 'quiet' });
  readonly element = make(
    'div', { className: 'assumed-stock', hidden: true },
    make('span', { className: 'guess', 'aria-hidden': 'true' }), this.#text, make('span', { 'aria-hidden': 'true' }, '·'), this.#use,
  );
  readonly #events: AssumedStockEvents;

  constructor(events: AssumedStockEvents) {
    this.#events = events;
    this.#use.addEventListener('click', () => void this.#take());
  }

  speak(assumed: string, use: string): void {
    this.#text.textContent = assumed;
    this.#use.textContent = use;
  }

  set fitted(fitted: Fitted) {
    this.element.hidden = fitted.stock !== 'guessed';
  }

  /** The stock that is assumed is filled into the form, which is kept where it would be kept by hand. */
  async #take(): Promise<void> {
    const form = await this.#events.form();
    if (form === undefined) return;
    const fields = form.groups.flatMap(({ group, fields }) => fields.map(({ key, value }) => ({ group, key, value })));
    const keys = fields.map(({ key }) => key);
    const texts = fields.map(({ value }) => value);
    const asItIs = await this.#events.read({ keys, texts, keep: form.place });
    if (asItIs === undefined) return;
    const assumed = new Map(asItIs.fields.map((state) => [state.key, state.assumed]));
    const filled = fields.map(({ group, key, value }) => (group === 'stock' && value === '' ? (assumed.get(key) ?? '') : value));
    const answer = await this.#events.read({ keys, texts: filled, keep: form.place });
    if (answer !== undefined) this.#events.taken(answer, form.place);
  }
}
