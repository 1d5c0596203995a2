// The dialog "New program": control, unit and blank of an empty program.
//
// In: the `PageHost`, and the choices of the user. Out: a program with its setup, in place of the current one. Must not
// know: how a setup is read.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import { field } from './fields';
import type { PageHost } from './page-host';
import '../dom/dialog.css';
import './share.css';

const MM_PER_INCH = 25.4;
/** Names of the controls, as in the setup form. */
const CONTROLS = [
  ['fanuc', 'FANUC'],
  ['gsk', 'GSK'],
] as const;
/** Blank of a first part, in the unit of the program. */
const BLANKS = { mm: { diameter: 50, length: 80 }, inch: { diameter: 2, length: 3 } } as const;
type Unit = keyof typeof BLANKS;

class NewDialog {
  readonly #control = make('select', { id: 'new-control' });
  readonly #unit = make('select', { id: 'new-unit' });
  readonly #diameter = make('input', { type: 'number', id: 'new-diameter', min: '0', step: 'any', required: true });
  readonly #length = make('input', { type: 'number', id: 'new-length', min: '0', step: 'any', required: true });
  readonly #fields = {
    control: field(this.#control),
    unit: field(this.#unit),
    diameter: field(this.#diameter),
    length: field(this.#length),
  };
  readonly #create = make('button', { type: 'submit', className: 'primary' });
  readonly #form = make(
    'form',
    { id: 'new-fields', method: 'dialog' },
    ...Object.values(this.#fields).map(({ label }) => label),
  );
  readonly #dialog = new Dialog('new-program', [this.#form], [this.#create]);
  #host: PageHost | undefined;

  constructor() {
    this.#control.append(...CONTROLS.map(([value, text]) => make('option', { value }, text)));
    this.#unit.append(make('option', { value: 'mm' }), make('option', { value: 'inch' }));
    this.#create.setAttribute('form', this.#form.id);
    this.#unit.addEventListener('change', () => this.#showBlank());
    this.#form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#replaceProgram();
    });
    document.body.append(this.#dialog.element);
  }

  open(host: PageHost): void {
    this.#host = host;
    this.#showTexts(host.language);
    this.#control.value = host.playground.control ?? 'fanuc';
    if (this.#control.value === '') this.#control.value = 'fanuc';
    this.#showBlank();
    this.#dialog.show();
    this.#control.focus();
  }

  #showTexts(language: Language): void {
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    for (const option of this.#unit.options) option.textContent = texts.units[option.value as Unit];
    for (const name of ['control', 'unit', 'diameter', 'length'] as const)
      this.#fields[name].caption.textContent = texts[name];
    this.#create.textContent = texts.create;
  }

  #showBlank(): void {
    const { diameter, length } = BLANKS[this.#unit.value as Unit];
    this.#diameter.value = String(diameter);
    this.#length.value = String(length);
  }

  async #replaceProgram(): Promise<void> {
    const isInch = this.#unit.value === 'inch';
    const mm = (input: HTMLInputElement): number =>
      Number((input.valueAsNumber * (isInch ? MM_PER_INCH : 1)).toFixed(4));
    const stock = { diameter: mm(this.#diameter), length: mm(this.#length) };
    const control = this.#control.value;
    const setup = JSON.stringify({ dialect: { control }, stock });
    this.#dialog.close();
    await this.#host?.showNew({ text: `O0001\n${isInch ? 'G20' : 'G21'}\n\nM30\n`, example: '', control, setup });
  }
}

let dialog: NewDialog | undefined;

export function newProgram(host: PageHost): void {
  dialog ??= new NewDialog();
  dialog.open(host);
}

const WORDS = words({
  en: {
    title: 'New program',
    about: 'Changes to the program in the editor are kept in "My programs".',
    control: 'Control',
    unit: 'Unit',
    units: { mm: 'mm (G21)', inch: 'inch (G20)' },
    diameter: 'Diameter of the blank',
    length: 'Length of the blank',
    create: 'Create',
  },
  zh: {
    title: '新建程序',
    about: '对编辑器中程序的修改保存在“我的程序”中。',
    control: '数控系统',
    unit: '单位',
    units: { mm: '毫米 (G21)', inch: '英寸 (G20)' },
    diameter: '毛坯直径',
    length: '毛坯长度',
    create: '新建',
  },
  ru: {
    title: 'Новая программа',
    about: 'Изменения программы в редакторе сохранятся в «Моих программах».',
    control: 'Система ЧПУ',
    unit: 'Единица',
    units: { mm: 'мм (G21)', inch: 'дюймы (G20)' },
    diameter: 'Диаметр заготовки',
    length: 'Длина заготовки',
    create: 'Создать',
  },
});
