// One field of the setup form: its label, unit, assumed value and error message.
//
// In: the field and its state. Out: `onChange`. Must not know: the purpose of the field.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { SetupField, SetupState } from '../protocol/protocol';

export class SetupInput {
  readonly key: string;
  readonly element: HTMLElement;
  readonly #language: Language;
  readonly #input: HTMLInputElement | HTMLSelectElement;
  /** The empty option of a choice. */
  readonly #emptyOption: HTMLOptionElement | undefined;
  readonly #error: HTMLElement;
  /** The initial value. */
  readonly value: string;

  constructor(field: SetupField, language: Language, onChange: () => void) {
    const { key, label, unit, entry, choices, value } = field;
    this.key = key;
    this.#language = language;
    const id = `setup-${key}`;
    if (entry === 'choice') {
      this.#emptyOption = make('option', { value: '' }, WORDS[language].nothing);
      this.#input = make(
        'select',
        { id },
        this.#emptyOption,
        ...choices.map((choice) => make('option', { value: choice.value }, choice.text)),
      );
    } else {
      const mode = entry === 'number' ? 'decimal' : 'text';
      this.#input = make('input', { id, type: 'text', inputMode: mode, autocomplete: 'off', spellcheck: false });
    }
    this.#input.value = value;
    this.value = this.text;
    this.#input.addEventListener('input', onChange);
    this.#error = make('p', { className: 'error', id: `${id}-error`, hidden: true });
    const unitText = make('span', { className: 'unit', id: `${id}-unit` }, unit);
    this.#input.setAttribute('aria-describedby', `${id}-unit ${id}-error`);
    this.element = make(
      'div',
      { className: 'setup-field' },
      make('label', { htmlFor: id }, label),
      make('div', { className: 'entry' }, this.#input, unitText),
      this.#error,
    );
  }

  get text(): string {
    return this.#input.value;
  }

  set text(text: string) {
    this.#input.value = text;
  }

  set state(state: SetupState | undefined) {
    if (state === undefined) return;
    const { assumed, error, shown } = state;
    const placeholder = assumed === '' ? '' : WORDS[this.#language].placeholder(assumed);
    if (this.#emptyOption !== undefined)
      this.#emptyOption.textContent = placeholder === '' ? WORDS[this.#language].nothing : placeholder;
    else (this.#input as HTMLInputElement).placeholder = placeholder;
    this.#input.classList.toggle('unsaid', this.text === '');
    this.element.hidden = shown === 'hidden';
    this.#error.hidden = error === undefined;
    this.#error.textContent = error ?? '';
    this.#input.setAttribute('aria-invalid', String(error !== undefined));
    if (error !== undefined) this.expand();
  }

  /** Opens the collapsed group that contains the field, if any. */
  expand(): void {
    const folded = this.element.closest('details');
    if (folded !== null) folded.open = true;
  }

  focus(): void {
    this.#input.focus();
  }
}

const WORDS = words({
  en: {
    /** Placeholder of an empty field: the value that is assumed. */
    placeholder: (value: string) => `${value} (assumed)`,
    nothing: '—',
  },
  zh: {
    placeholder: (value) => `${value}（假定）`,
    nothing: '—',
  },
  ru: {
    placeholder: (value) => `${value} (по умолчанию)`,
    nothing: '—',
  },
});
