// The form of a calculator: its fields, the results, the table of passes and the block.
//
// In: the name of a calculator, and where its values come from. Out: the result after each change of a field. A wrong
// value is explained at its field. Loaded when it is first shown. Must not know: a formula.

import { make } from '../dom/dom';
import { words } from '../dom/words';
import type { Calculated, CalculatorAnswer, CalculatorForm, CalculatorPlace } from '../protocol/protocol';
import type { NewestQuestion, Shell } from './panel';

interface FieldRow {
  readonly input: HTMLInputElement;
  readonly error: HTMLElement;
}

export class CalculatorFields {
  readonly element: HTMLElement;
  readonly #shell: Shell;
  readonly #name: string;
  readonly #place: CalculatorPlace;
  readonly #onResult: (result: Calculated | undefined) => void;
  readonly #question: NewestQuestion<'calculate'>;
  readonly #heading = make('h3', { className: 'calculator-title' });
  readonly #list = make('div', { className: 'calculator-fields' });
  readonly #results = make('dl', { className: 'calculator-results', 'aria-live': 'polite' });
  readonly #passes = make('div', { className: 'calculator-passes' });
  readonly #block = make('pre', { className: 'calculator-block', lang: 'en' });
  readonly #figure = make('img', { className: 'calculator-figure', alt: '', hidden: true });
  /** Names that begin with the text of a field. */
  readonly #names = make('datalist', { id: 'calculator-names' });
  #rows: readonly FieldRow[] = [];
  #title = '';

  constructor(shell: Shell, name: string, place: CalculatorPlace, onResult: (result: Calculated | undefined) => void) {
    this.#shell = shell;
    this.#name = name;
    this.#place = place;
    this.#onResult = onResult;
    this.#question = shell.newest('calculate', (answer) => this.#show(answer));
    this.element = make(
      'form',
      { className: 'calculator-form' },
      ...(place === 'example' ? [this.#heading] : []),
      this.#list,
      this.#figure,
      this.#results,
      this.#block,
      this.#passes,
    );
    this.element.addEventListener('submit', (event) => event.preventDefault());
    this.element.addEventListener('input', () => this.#calculate());
  }

  get title(): string {
    return this.#title;
  }

  /** Shows the fields with their first values. Returns whether there is such a calculator here. */
  async start(): Promise<boolean> {
    const form = await this.#shell.ask('calculator', { name: this.#name, at: this.#place });
    if (form === undefined) return false;
    this.#render(form);
    this.#calculate();
    return true;
  }

  /** Shows everything again in another language, with the current values. */
  reload(): void {
    const values = this.#rows.map(({ input }) => input.value);
    void this.#shell.ask('calculator', { name: this.#name, at: this.#place }).then((form) => {
      if (form === undefined) return;
      this.#render(form);
      for (const [at, { input }] of this.#rows.entries()) input.value = values[at] ?? input.value;
      this.#calculate();
    });
  }

  focus(): void {
    const empty = this.#rows.find(({ input }) => input.value === '') ?? this.#rows[0];
    empty?.input.focus();
    empty?.input.select();
  }

  /** Stops waiting for an answer, and releases the figure. */
  drop(): void {
    this.#question.cancel();
    this.#setFigure('');
  }

  #render({ title, fields }: CalculatorForm): void {
    this.#title = title;
    this.#heading.textContent = title;
    const rows = fields.map(({ letter, title: meaning, unit, value, isText }, at) => {
      const error = make('span', {
        className: 'calculator-error',
        id: `calculator-error-${at}`,
        role: 'alert',
        hidden: true,
      });
      const input = make('input', {
        type: 'text',
        inputMode: isText ? 'text' : 'decimal',
        autocomplete: 'off',
        size: 8,
        value,
        'aria-describedby': error.id,
      });
      if (isText) input.setAttribute('list', this.#names.id);
      const label = make(
        'label',
        { className: 'calculator-field' },
        make('span', { className: 'calculator-letter', lang: 'en' }, letter),
        input,
        make('span', { className: 'calculator-unit' }, unit),
        make('span', { className: 'calculator-meaning' }, meaning),
      );
      return { input, error, element: make('div', { className: 'calculator-row' }, label, error) };
    });
    this.#rows = rows;
    this.#list.replaceChildren(this.#names, ...rows.map(({ element }) => element));
  }

  #calculate(): void {
    const fields = this.#rows.map(({ input }) => input.value);
    this.#question.ask({ name: this.#name, fields, at: this.#place });
  }

  #show(answer: CalculatorAnswer | undefined): void {
    if (answer === undefined) return;
    const { calculation, figure } = answer;
    for (const [at, { input, error }] of this.#rows.entries()) {
      const reason = calculation.kind === 'wrong' && calculation.field === at ? calculation.reason : '';
      error.textContent = reason;
      error.hidden = reason === '';
      input.setAttribute('aria-invalid', String(reason !== ''));
    }
    const names = calculation.kind === 'wrong' ? calculation.suggestions : [];
    this.#names.replaceChildren(...names.map((name) => make('option', { value: name })));
    const result = calculation.kind === 'done' ? calculation : undefined;
    this.#results.replaceChildren(
      ...(result?.results ?? []).flatMap(({ letter, title, value }) => [
        make('dt', {}, make('span', { className: 'calculator-letter', lang: 'en' }, letter), ` ${title}`),
        make('dd', {}, value),
      ]),
    );
    this.#block.textContent = result?.block ?? '';
    this.#block.hidden = (result?.block ?? '') === '';
    this.#passes.replaceChildren(...(result === undefined || result.rows.length === 0 ? [] : [this.#table(result)]));
    this.#setFigure(figure);
    this.#onResult(result);
  }

  #table({ columns, rows }: Calculated): HTMLElement {
    const cells = (tag: 'th' | 'td', texts: readonly string[]): HTMLElement =>
      make('tr', {}, ...texts.map((text) => make(tag, tag === 'th' ? { scope: 'col' } : {}, text)));
    return make(
      'table',
      {},
      make('thead', {}, cells('th', columns)),
      make('tbody', {}, ...rows.map((row) => cells('td', row))),
    );
  }

  #setFigure(svg: string): void {
    if (this.#figure.src !== '') URL.revokeObjectURL(this.#figure.src);
    this.#figure.hidden = svg === '';
    if (svg === '') return this.#figure.removeAttribute('src');
    this.#figure.alt = WORDS[this.#shell.language].figure;
    this.#figure.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  }
}

const WORDS = words({
  en: { figure: 'The result as a tool path' },
  zh: { figure: '结果的刀具轨迹图' },
  ru: { figure: 'Результат в виде траектории' },
});
