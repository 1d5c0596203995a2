// The line that says that the stock is inferred and which checks were left out, and the button that applies that stock.
//
// In: which parts of the setup are given and which are inferred; the answers of the setup form. Out: `onApplied`: the
// form with the stock filled in. Must not know: how a stock is inferred, or the contents of a setup besides the stock.

import { make } from '../dom/dom';
import type { SetupOverview, SetupAnswer, SetupForm, SetupPlace } from '../protocol/protocol';
import type { SetupEntries } from './setup-form';

interface InferredStockEvents {
  form(): Promise<SetupForm | undefined>;
  read(entries: SetupEntries): Promise<SetupAnswer | undefined>;
  onApplied(answer: SetupAnswer, place: SetupPlace): void;
}

export class InferredStock {
  readonly #text = make('span', { className: 'said' });
  readonly #use = make('button', { type: 'button' });
  readonly element = make(
    'div',
    { className: 'inferred-stock', hidden: true },
    make('span', { className: 'swatch', 'aria-hidden': 'true' }),
    this.#text,
    make('span', { 'aria-hidden': 'true' }, '·'),
    this.#use,
  );
  readonly #events: InferredStockEvents;

  constructor(events: InferredStockEvents) {
    this.#events = events;
    this.#use.addEventListener('click', () => void this.#apply());
  }

  setTexts(inferred: string, use: string): void {
    this.#text.textContent = inferred;
    this.#use.textContent = use;
  }

  set overview(overview: SetupOverview) {
    this.element.hidden = overview.stock !== 'inferred';
  }

  /** Fills the inferred stock into the form and stores the setup in its usual place. */
  async #apply(): Promise<void> {
    const form = await this.#events.form();
    if (form === undefined) return;
    const fields = form.groups.flatMap(({ group, fields }) => fields.map(({ key, value }) => ({ group, key, value })));
    const keys = fields.map(({ key }) => key);
    const texts = fields.map(({ value }) => value);
    const current = await this.#events.read({ keys, texts, keep: form.place });
    if (current === undefined) return;
    const assumed = new Map(current.fields.map((state) => [state.key, state.assumed]));
    const filled = fields.map(({ group, key, value }) =>
      group === 'stock' && value === '' ? (assumed.get(key) ?? '') : value,
    );
    const answer = await this.#events.read({ keys, texts: filled, keep: form.place });
    if (answer !== undefined) this.#events.onApplied(answer, form.place);
  }
}
