// One field of the setup form: its label, unit, assumed value, error message, and pictures to choose its value from.
//
// In: the field and its state, with lengths in mm; the unit in which lengths are shown and typed. Out: `onChange`, the
// entry in mm. Must not know: the purpose of the field.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { LengthUnit, SetupField, SetupState } from '../protocol/protocol';
import { MM_PER_UNIT, unitSymbol } from './lengths';
import { PicturePicker } from './picture-picker';
import { picturesOf, type TurretSide } from './setup-pictures';

/** The unit of a length, or of a feed: "mm", "mm/min". */
const MILLIMETRES = /^(mm|мм)(?=$|\/)/;
/** Decimals of an entry: 0.0001 mm, 0.00001 in. */
const DECIMALS = { mm: 4, inch: 5 } as const;

interface SetupInputEvents {
  onChange(): void;
  /** The side of the turret for which pictures are drawn. */
  turret(): TurretSide;
}

export class SetupInput {
  readonly key: string;
  readonly element: HTMLElement;
  readonly #language: Language;
  readonly #input: HTMLInputElement | HTMLSelectElement;
  /** Millimetres for each unit of an entry; 1 if the field is not a length. */
  readonly #mmPerUnit: number;
  /** The empty option of a choice. */
  readonly #emptyOption: HTMLOptionElement | undefined;
  readonly #error: HTMLElement;
  readonly #picker: PicturePicker | undefined;
  #assumed = '';
  /** The initial value, and as it is shown. */
  readonly value: string;
  readonly #shownValue: string;

  constructor(field: SetupField, language: Language, shownUnit: LengthUnit, events: SetupInputEvents) {
    const { key, label, unit, entry, choices, value } = field;
    this.key = key;
    this.#language = language;
    this.#mmPerUnit = entry === 'number' && MILLIMETRES.test(unit) ? MM_PER_UNIT[shownUnit] : 1;
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
    this.text = value;
    this.#shownValue = this.#input.value;
    // A choice may not offer the value.
    this.value = entry === 'choice' ? this.#shownValue : value;
    this.#input.addEventListener('input', () => events.onChange());
    this.#error = make('p', { className: 'error', id: `${id}-error`, hidden: true });
    const shownUnitText = this.#mmPerUnit === 1 ? unit : unit.replace(MILLIMETRES, unitSymbol(shownUnit, language));
    const unitText = make('span', { className: 'unit', id: `${id}-unit` }, shownUnitText);
    this.#input.setAttribute('aria-describedby', `${id}-unit ${id}-error`);
    const pictures = picturesOf(key);
    if (pictures !== undefined)
      this.#picker = new PicturePicker({
        label,
        language,
        pictures,
        turret: () => events.turret(),
        entry: () => this.text,
        assumed: () => this.#assumed,
        onChoose: (text) => {
          this.text = text;
          events.onChange();
        },
      });
    this.element = make(
      'div',
      { className: 'setup-field' },
      make('label', { htmlFor: id }, label),
      make('div', { className: 'entry' }, this.#input, this.#picker?.element ?? '', unitText),
      this.#error,
    );
  }

  /** The entry, a length in mm. An entry that was not changed keeps all its digits. */
  get text(): string {
    const { value } = this.#input;
    return value === this.#shownValue ? this.value : scaled(value, this.#mmPerUnit, DECIMALS.mm);
  }

  set text(mm: string) {
    this.#input.value = scaled(mm, 1 / this.#mmPerUnit, DECIMALS.inch);
  }

  set state(state: SetupState | undefined) {
    if (state === undefined) return;
    const { assumed, error, shown } = state;
    this.#assumed = assumed;
    this.#picker?.update();
    const placeholder =
      assumed === ''
        ? WORDS[this.#language].nothing
        : WORDS[this.#language].placeholder(scaled(assumed, 1 / this.#mmPerUnit, DECIMALS.inch));
    if (this.#emptyOption !== undefined) this.#emptyOption.textContent = placeholder;
    else (this.#input as HTMLInputElement).placeholder = placeholder;
    this.#input.classList.toggle('unsaid', this.#input.value === '');
    this.element.hidden = shown === 'hidden';
    this.#error.hidden = error === undefined;
    this.#error.textContent = error ?? '';
    this.#input.setAttribute('aria-invalid', String(error !== undefined));
    if (error !== undefined) this.expand();
  }

  set hasPictures(hasPictures: boolean) {
    if (this.#picker !== undefined) this.#picker.element.hidden = !hasPictures;
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

/** A number in another unit; a text that is not a number is returned unchanged. */
function scaled(text: string, factor: number, decimals: number): string {
  const number = Number(text.replace(',', '.'));
  return factor === 1 || text.trim() === '' || Number.isNaN(number)
    ? text
    : String(Number((number * factor).toFixed(decimals)));
}

const WORDS = words({
  en: {
    /** Placeholder of an empty field: the value that is assumed. */
    placeholder: (value: string) => `${value} (assumed)`,
    nothing: 'not set',
  },
  zh: {
    placeholder: (value) => `${value}（假定）`,
    nothing: '未设置',
  },
  ru: {
    placeholder: (value) => `${value} (по умолчанию)`,
    nothing: 'не задано',
  },
});
