// The button beside a field that shows its entry as a picture, and the pictures to choose another entry from.
//
// In: the choices, the entry and the assumed value. Out: the chosen entry. Must not know: the purpose of the field.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { placePopover, returnFocus } from '../dom/popover';
import { words } from '../dom/words';
import type { FieldPictures, PictureChoice, TurretSide } from './setup-pictures';

interface PickedField {
  readonly label: string;
  readonly language: Language;
  readonly pictures: FieldPictures;
  /** The side of the turret for which the pictures are drawn. */
  turret(): TurretSide;
  entry(): string;
  /** The value that is assumed for an empty entry. */
  assumed(): string;
  onChoose(entry: string): void;
}

export class PicturePicker {
  readonly element: HTMLElement;
  readonly #field: PickedField;
  readonly #button = make('button', {
    type: 'button',
    className: 'framed picture-button',
    'aria-haspopup': 'dialog',
    'aria-expanded': 'false',
  });
  readonly #about = make('p', { className: 'about' });
  readonly #list = make('div', { className: 'picture-list', role: 'radiogroup' });
  readonly #popover = make(
    'div',
    { className: 'popover pictures-of-field', role: 'dialog', popover: 'auto' },
    this.#about,
    this.#list,
  );

  constructor(field: PickedField) {
    this.#field = field;
    this.#button.popoverTargetElement = this.#popover;
    const name = WORDS[field.language].choose(field.label);
    setAccessibleName(this.#button, name);
    this.#popover.setAttribute('aria-label', name);
    this.#list.style.setProperty('--columns', String(field.pictures.columns));
    returnFocus(this.#button, this.#popover);
    // Some browsers would close the dialog of the form, too.
    this.#popover.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      this.#popover.hidePopover();
    });
    this.#popover.addEventListener('beforetoggle', (event) => {
      if (event.newState === 'open') this.#render();
    });
    this.#popover.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.#button.setAttribute('aria-expanded', String(open));
      if (!open) return;
      placePopover(this.#button, this.#popover);
      this.#radios.find(({ tabIndex }) => tabIndex === 0)?.focus();
    });
    this.element = make('span', { className: 'picture-picker' }, this.#button, this.#popover);
    this.update();
  }

  /** The entry, the assumed value or the turret may have changed. */
  update(): void {
    const { pictures, language } = this.#field;
    const [entry, value] = [this.#field.entry(), this.#shownValue];
    const choice = pictures.choices(this.#field.turret(), language).find((choice) => choice.value === value);
    this.#button.classList.toggle('unsaid', entry.trim() === '');
    this.#button.replaceChildren(...(choice === undefined ? [] : [choice.draw('beside-field')]), icon('chevron'));
    if (this.#popover.matches(':popover-open')) this.#mark();
  }

  /** The choice of the entry, or of the assumed value if it is empty. */
  get #shownValue(): string | undefined {
    const entry = this.#field.entry();
    return this.#field.pictures.choiceOf(entry.trim() === '' ? this.#field.assumed() : entry);
  }

  get #radios(): HTMLButtonElement[] {
    return [...this.#list.querySelectorAll('button')];
  }

  #render(): void {
    const { pictures, language } = this.#field;
    const about = pictures.about(this.#field.turret(), language);
    this.#about.textContent = about;
    this.#list.setAttribute('aria-label', about);
    this.#list.replaceChildren(
      ...pictures.choices(this.#field.turret(), language).map((choice) => this.#renderChoice(choice)),
    );
    this.#mark();
  }

  #renderChoice({ value, name, caption, draw }: PictureChoice): HTMLElement {
    const radio = make('button', { type: 'button', role: 'radio', value }, draw('in-list'));
    if (caption !== '') radio.append(make('span', { className: 'caption', 'aria-hidden': 'true' }, caption));
    setAccessibleName(radio, name);
    radio.addEventListener('click', () => {
      this.#choose(value);
      this.#popover.hidePopover();
    });
    radio.addEventListener('keydown', (event) => this.#handleKey(event, radio));
    return radio;
  }

  /** Marks the choice; without an entry, the assumed choice has the focus but is not marked. */
  #mark(): void {
    const radios = this.#radios;
    const isEntered = this.#field.entry().trim() !== '';
    const shown = radios.find(({ value }) => value === this.#shownValue);
    for (const radio of radios) {
      radio.setAttribute('aria-checked', String(isEntered && radio === shown));
      radio.classList.toggle('assumed', !isEntered && radio === shown);
      radio.tabIndex = radio === (shown ?? radios[0]) ? 0 : -1;
    }
  }

  #choose(value: string): void {
    this.#field.onChoose(this.#field.pictures.withChoice(this.#field.entry(), value));
    this.update();
  }

  #handleKey(event: KeyboardEvent, from: HTMLButtonElement): void {
    const { columns } = this.#field.pictures;
    const radios = this.#radios;
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns, ArrowDown: columns }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const next = radios[radios.indexOf(from) + step];
    if (next === undefined) return;
    this.#choose(next.value);
    next.focus();
  }
}

const WORDS = words({
  en: { choose: (label: string) => `${label}: choose by picture` },
  zh: { choose: (label) => `${label}：按图选择` },
  ru: { choose: (label) => `${label}: выбрать по рисунку` },
});
