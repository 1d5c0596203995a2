// The dialog for stock, tools, start, machine and tailstock, and for the place where the setup is stored.
//
// In: the groups of fields, and answers to the entries; both come from the interpreter, with labels and messages as
// text. Out: `read` and `toolGroup` (questions), `onApplied` (the user has applied the setup). Must not know: the
// purpose of a field, or its valid values.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { LengthUnit, SetupAnswer, SetupForm, SetupGroup, SetupPlace } from '../protocol/protocol';
import { SetupInput } from './setup-input';
import type { TurretSide } from './setup-pictures';

/** Entries typed within this time are sent in one question. */
const ASK_AFTER_MS = 80;

export interface SetupEntries {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
}

interface SetupFormEvents {
  read(entries: SetupEntries): Promise<SetupAnswer | undefined>;
  toolGroup(word: string): Promise<SetupGroup | undefined>;
  onApplied(answer: SetupAnswer, place: SetupPlace): void;
}

const TURRET_KEY = 'machine.turret';
/** The values of the offset table of the control. */
const OFFSET_KEY = /^tools\.\w+\.(geometry|wear)[XZR]$/;

/** Groups that are seldom filled in are collapsed. */
const COLLAPSED_GROUPS: ReadonlySet<SetupGroup['group']> = new Set([
  'start',
  'machine',
  'tailstock',
  'control',
  'rules',
]);

export class SetupDialog {
  readonly #events: SetupFormEvents;
  readonly #groups = make('div', { className: 'groups' });
  readonly #placeFieldset = make('fieldset', { className: 'place-of-setup' });
  readonly #placeHint = make('p', { className: 'moves' });
  readonly #form = make('form', { id: 'setup-form', className: 'text', noValidate: true });
  readonly #applyButton = make('button', { type: 'submit', className: 'primary' });
  readonly #status = make('p', { className: 'errors', role: 'status' });
  readonly #toolInput = make('input', {
    type: 'text',
    autocomplete: 'off',
    spellcheck: false,
    size: 8,
    id: 'another-tool',
  });
  readonly #addButton = make('button', { type: 'button', className: 'framed' });
  readonly #toolError = make('p', { className: 'error', id: 'another-tool-error', hidden: true });
  readonly #unappliedText = make('span');
  readonly #discard = make('button', { type: 'button', className: 'link' });
  readonly #unappliedNotice = make(
    'p',
    { className: 'left', role: 'status', hidden: true },
    this.#unappliedText,
    ' ',
    this.#discard,
  );
  readonly #dialog: Dialog;
  #language: Language;
  /** The unit of lengths in the form. */
  #unit: LengthUnit = 'mm';
  /** The side of the turret in the picture. */
  #turret: TurretSide = 'rear';
  #shown: SetupForm | undefined;
  /** Entries that were not applied, by the key of the field, with the field's value at that time (`instead`). */
  readonly #unapplied = new Map<string, { readonly instead: string; readonly text: string }>();
  /** Groups for tools that the program does not name. */
  #addedGroups: readonly SetupGroup[] = [];
  #chosenPlace: SetupPlace | undefined;
  #inputs: SetupInput[] = [];
  /** The first field of each group. */
  readonly #firstInputs = new Map<SetupGroup['group'] | undefined, SetupInput>();
  #storedIn: SetupPlace = 'page';
  #selectedPlace: SetupPlace = 'page';
  #askTimer: ReturnType<typeof setTimeout> | undefined;
  #askCount = 0;

  constructor(language: Language, events: SetupFormEvents) {
    this.#language = language;
    this.#events = events;
    this.#applyButton.setAttribute('form', 'setup-form');
    this.#form.append(this.#groups);
    this.#dialog = new Dialog(
      'setup',
      [this.#unappliedNotice, this.#form, this.#placeFieldset],
      [this.#status, this.#applyButton],
    );
    this.#form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#onSubmit();
    });
    this.#discard.addEventListener('click', () => {
      const form = this.#shown;
      this.clearUnapplied();
      if (form !== undefined) this.show(form, this.#unit, this.#turret);
    });
    this.#addButton.addEventListener('click', () => void this.#addTool());
    this.#toolInput.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter') return;
      event.preventDefault();
      void this.#addTool();
    });
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#applyButton.textContent = texts.apply;
    this.#addButton.textContent = texts.add;
    this.#toolInput.placeholder = texts.anotherHint;
    this.#toolError.textContent = texts.invalidTool;
    this.#unappliedText.textContent = texts.unapplied;
    this.#discard.textContent = texts.discard;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /**
   * `unit`: of lengths in the form; `turret`: its side in the picture; `opened` and `key`: the group and the field to
   * open.
   */
  show(form: SetupForm, unit: LengthUnit, turret: TurretSide, opened?: SetupGroup['group'], key?: string): void {
    this.#saveUnapplied();
    this.#unit = unit;
    this.#turret = turret;
    const { groups, place } = form;
    this.#shown = form;
    this.#storedIn = place;
    const present = new Set(groups.flatMap(({ fields }) => fields.map(({ key }) => key)));
    this.#addedGroups = this.#addedGroups.filter(({ fields }) =>
      fields.some(({ key }) => this.#unapplied.has(key) && !present.has(key)),
    );
    this.#inputs = [];
    this.#firstInputs.clear();
    this.#toolError.hidden = true;
    const texts = WORDS[this.#language];
    const addToolRow = make(
      'div',
      { className: 'another' },
      make('label', { htmlFor: 'another-tool' }, texts.another),
      this.#toolInput,
      this.#addButton,
      this.#toolError,
    );
    const elements = groups.map((group) => this.#renderGroup(group, opened));
    // After the last tool or, without tools, after the stock.
    const last = groups.findLastIndex(({ group }) => group === 'tool' || group === 'stock');
    elements.splice(last + 1, 0, ...this.#addedGroups.map((group) => this.#renderGroup(group)), addToolRow);
    this.#groups.replaceChildren(...elements);
    this.#restoreUnapplied();
    this.#selectedPlace = (this.#unappliedNotice.hidden ? undefined : this.#chosenPlace) ?? place;
    this.#showPlace();
    this.#status.textContent = '';
    this.#dialog.show();
    this.#form.scrollTop = 0;
    (this.#inputs.find((input) => input.key === key) ?? this.#firstInputs.get(opened) ?? this.#inputs[0])?.focus();
    void this.#ask();
  }

  // ---- entries that were not applied --------------------------------------------------------------

  /** Another program was loaded, or everything was applied: drops the entries that were not applied. */
  clearUnapplied(): void {
    this.#unapplied.clear();
    this.#addedGroups = [];
    this.#inputs = [];
    this.#chosenPlace = undefined;
    this.#toolInput.value = '';
  }

  /** Stores the entries that are not applied. */
  #saveUnapplied(): void {
    for (const { key, value, text } of this.#inputs) {
      if (text === value) this.#unapplied.delete(key);
      else this.#unapplied.set(key, { instead: value, text });
    }
  }

  /** Restores an entry if the field still has the value that it had then. */
  #restoreUnapplied(): void {
    const restored = this.#inputs.flatMap((input) => {
      const { instead, text } = this.#unapplied.get(input.key) ?? {};
      return text !== undefined && instead === input.value ? [{ input, text }] : [];
    });
    for (const { input, text } of restored) {
      input.text = text;
      input.expand();
    }
    this.#unappliedNotice.hidden = restored.length === 0;
  }

  // ---- building -----------------------------------------------------------------------------------

  #renderGroup({ group, title, source, fields }: SetupGroup, opened?: SetupGroup['group']): HTMLElement {
    const texts = WORDS[this.#language];
    const events = { onChange: () => this.#scheduleAsk(), turret: () => this.#turretInForce };
    const inputs = fields.map((field) => new SetupInput(field, this.#language, this.#unit, events));
    this.#inputs.push(...inputs);
    if (inputs[0] !== undefined) this.#firstInputs.set(group, inputs[0]);
    const clear = make(
      'button',
      { type: 'button', className: 'link clear', 'aria-label': texts.clear(title) },
      texts.clearShort,
    );
    clear.addEventListener('click', () => {
      for (const input of inputs) input.text = '';
      inputs[0]?.focus();
      this.#scheduleAsk();
    });
    const isOffset = ({ key }: SetupInput): boolean => OFFSET_KEY.test(key);
    const grid = fieldGrid(inputs.filter((input) => !isOffset(input)));
    const offsets = this.#renderOffsets(inputs.filter(isOffset));
    const from = make('span', { className: `source ${source}` }, texts.source[source]);
    if (COLLAPSED_GROUPS.has(group)) {
      const summary = make('summary', {}, make('span', { className: 'group-title' }, title), from);
      return make(
        'details',
        { className: 'group', open: source !== 'nobody' || group === opened },
        summary,
        grid,
        clear,
      );
    }
    const legend = make(
      'div',
      { className: 'group-head' },
      make('h3', { className: 'group-title' }, title),
      from,
      clear,
    );
    return make('section', { className: 'group', 'aria-label': title }, legend, grid, offsets);
  }

  /** The geometry and wear values of a tool, closed if none is set. */
  #renderOffsets(inputs: readonly SetupInput[]): HTMLElement | string {
    if (inputs.length === 0) return '';
    const { offsets, offsetsAbout } = WORDS[this.#language];
    return make(
      'details',
      { className: 'offsets', open: inputs.some(({ value }) => value !== '') },
      make('summary', {}, make('span', { className: 'group-title' }, offsets)),
      make('p', { className: 'about' }, offsetsAbout),
      fieldGrid(inputs),
    );
  }

  /** The side that is entered, or, as long as it is not changed, that of the picture. */
  get #turretInForce(): TurretSide {
    const input = this.#inputs.find(({ key }) => key === TURRET_KEY);
    if (input === undefined || input.text === input.value) return this.#turret;
    return input.text === 'front' ? 'front' : 'rear';
  }

  #showPlace(): void {
    const texts = WORDS[this.#language];
    const choice = (place: SetupPlace, text: string): HTMLElement => {
      const radio = make('input', {
        type: 'radio',
        name: 'place',
        value: place,
        checked: this.#selectedPlace === place,
      });
      radio.addEventListener('change', () => {
        this.#selectedPlace = this.#chosenPlace = place;
        this.#showPlaceHint();
      });
      return make('label', {}, radio, text);
    };
    this.#placeFieldset.replaceChildren(
      make('legend', {}, texts.place),
      choice('program', texts.inProgram),
      choice('page', texts.onPage),
      this.#placeHint,
    );
    this.#showPlaceHint();
  }

  #showPlaceHint(): void {
    const texts = WORDS[this.#language];
    this.#placeHint.textContent =
      this.#storedIn === 'program' && this.#selectedPlace === 'page' ? texts.willMove : texts.programFirst;
  }

  // ---- asking -------------------------------------------------------------------------------------

  #scheduleAsk(): void {
    clearTimeout(this.#askTimer);
    this.#askTimer = setTimeout(() => void this.#ask(), ASK_AFTER_MS);
  }

  /** Shows the result of the current entries; only the newest answer counts. */
  async #ask(): Promise<SetupAnswer | undefined> {
    clearTimeout(this.#askTimer);
    const askId = ++this.#askCount;
    const answer = await this.#events.read({
      keys: this.#inputs.map(({ key }) => key),
      texts: this.#inputs.map(({ text }) => text),
      keep: this.#selectedPlace,
    });
    if (answer === undefined || askId !== this.#askCount) return undefined;
    const states = new Map(answer.fields.map((state) => [state.key, state]));
    for (const input of this.#inputs) {
      input.state = states.get(input.key);
      // An insert of a threading tool has no shape of this kind.
      const angle = states.get(input.key.replace(/\.insert$/, '.pointAngle'));
      if (input.key.endsWith('.insert')) input.hasPictures = angle?.shown === 'shown';
    }
    const wrong = answer.fields.filter(({ error }) => error !== undefined).length;
    const news = wrong === 0 ? '' : WORDS[this.#language].errors(wrong);
    if (this.#status.textContent !== news) this.#status.textContent = news;
    return answer;
  }

  async #onSubmit(): Promise<void> {
    const keep = this.#selectedPlace;
    const answer = await this.#ask();
    if (answer === undefined) return;
    const error = answer.fields.find((state) => state.error !== undefined);
    if (error !== undefined) {
      this.#inputs.find(({ key }) => key === error.key)?.focus();
      return;
    }
    this.clearUnapplied();
    this.#dialog.close();
    this.#events.onApplied(answer, keep);
  }

  async #addTool(): Promise<void> {
    const group = await this.#events.toolGroup(this.#toolInput.value);
    this.#toolError.hidden = group !== undefined;
    if (group === undefined) {
      this.#toolInput.focus();
      return;
    }
    const existing = this.#inputs.find(({ key }) => key === group.fields[0]?.key);
    if (existing === undefined) {
      this.#addedGroups = [...this.#addedGroups, group];
      this.#toolInput.closest('.another')?.before(this.#renderGroup(group));
    }
    this.#toolInput.value = '';
    this.#inputs.find(({ key }) => key === group.fields[0]?.key)?.focus();
    void this.#ask();
  }
}

function fieldGrid(inputs: readonly SetupInput[]): HTMLElement {
  return make('div', { className: 'fields' }, ...inputs.map(({ element }) => element));
}

const WORDS = words({
  en: {
    title: 'Setup',
    about: 'Stock, tools and machine. For empty fields the grey values are assumed.',
    source: { program: 'in the program', page: 'on this page', nobody: 'assumed' },
    place: 'Keep the setup',
    inProgram: 'in the program, as comments',
    onPage: 'on this page',
    programFirst: 'Comments of the program override the setup of the page.',
    willMove: 'The comments are removed from the program.',
    unapplied: 'Your earlier entries are still here; they are not applied yet.',
    discard: 'Discard them',
    apply: 'Apply',
    clear: (group: string) => `Clear: ${group}`,
    clearShort: 'Clear',
    offsets: 'Tool offset: geometry and wear',
    offsetsAbout: 'Geometry X and Z are the length of the tool and move nothing. Wear moves the path and the part.',
    another: 'Another tool',
    anotherHint: 'T0202',
    add: 'Add',
    invalidTool: 'Write T and up to four digits',
    errors: (n: number) => (n === 1 ? '1 invalid value' : `${n} invalid values`),
  },
  zh: {
    title: '毛坯与刀具',
    about: '毛坯、刀具和机床。留空的项目按灰色的值假定。',
    source: { program: '写在程序中', page: '保存在本页', nobody: '假定' },
    place: '保存位置',
    inProgram: '写入程序注释',
    onPage: '保存在本页',
    programFirst: '程序注释优先于本页的设置。',
    willMove: '程序中的这些注释将被删除。',
    unapplied: '之前填写的内容还在，尚未应用。',
    discard: '放弃',
    apply: '应用',
    clear: (group) => `清除：${group}`,
    clearShort: '清除',
    offsets: '刀补：形状与磨损',
    offsetsAbout: '形状 X、Z 是刀具长度，不移动任何图形；磨损会移动刀具路径和零件。',
    another: '添加刀具',
    anotherHint: 'T0202',
    add: '添加',
    invalidTool: '请输入 T 和最多四位数字',
    errors: (n) => `有 ${n} 个值不正确`,
  },
  ru: {
    title: 'Наладка',
    about: 'Заготовка, инструменты и станок. Что не указано, берётся по умолчанию: это серые значения.',
    source: { program: 'в программе', page: 'на этой странице', nobody: 'по умолчанию' },
    place: 'Хранить наладку',
    inProgram: 'в программе, в комментариях',
    onPage: 'на этой странице',
    programFirst: 'Комментарии программы имеют приоритет над наладкой страницы.',
    willMove: 'Комментарии будут убраны из программы.',
    unapplied: 'Заполненное раньше сохранено, но ещё не применено.',
    discard: 'Отменить',
    apply: 'Применить',
    clear: (group) => `Очистить: ${group}`,
    clearShort: 'Очистить',
    offsets: 'Коррекция: геометрия и износ',
    offsetsAbout: 'Геометрия X и Z — это длина инструмента, она ничего не смещает. Износ смещает траекторию и деталь.',
    another: 'Ещё инструмент',
    anotherHint: 'T0202',
    add: 'Добавить',
    invalidTool: 'Напишите T и до четырёх цифр',
    errors: (n) => `Неверных значений: ${n}`,
  },
});
