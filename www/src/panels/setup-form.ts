// The dialog for stock, tools, start, machine and tailstock, and for the place where the setup is stored.
//
// In: the groups of fields, and answers to the entries; both come from the interpreter, with labels and messages as
// text. Out: `read` and `another` (questions), `kept` (the user has applied the setup). Must not know: the purpose of a
// field, or its valid values.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { SetupAnswer, SetupForm, SetupGroup, SetupPlace } from '../protocol/protocol';
import { SetupInput } from './setup-input';

/** Entries typed within this time are sent in one question. */
const ASK_AFTER_MS = 80;

export interface SetupEntries {
  readonly keys: readonly string[];
  readonly texts: readonly string[];
  readonly keep: SetupPlace;
}

export interface SetupFormEvents {
  read(entries: SetupEntries): Promise<SetupAnswer | undefined>;
  another(word: string): Promise<SetupGroup | undefined>;
  kept(answer: SetupAnswer, place: SetupPlace): void;
}

/** Groups that are seldom filled in are collapsed. */
const FOLDED: ReadonlySet<SetupGroup['group']> = new Set(['start', 'machine', 'tailstock', 'control', 'rules']);

export class SetupDialog {
  readonly #events: SetupFormEvents;
  readonly #groups = make('div', { className: 'groups' });
  readonly #place = make('fieldset', { className: 'place-of-setup' });
  readonly #moves = make('p', { className: 'moves' });
  readonly #form = make('form', { id: 'setup-form', className: 'text', noValidate: true });
  readonly #apply = make('button', { type: 'submit', className: 'framed apply' });
  readonly #news = make('p', { className: 'errors', role: 'status' });
  readonly #word = make('input', { type: 'text', autocomplete: 'off', spellcheck: false, size: 8, id: 'another-tool' });
  readonly #add = make('button', { type: 'button', className: 'framed' });
  readonly #noTool = make('p', { className: 'error', id: 'another-tool-error', hidden: true });
  readonly #leftText = make('span');
  readonly #discard = make('button', { type: 'button', className: 'quiet clear' });
  readonly #left = make('p', { className: 'left', role: 'status', hidden: true }, this.#leftText, ' ', this.#discard);
  readonly #dialog: Dialog;
  #language: Language;
  #shown: SetupForm | undefined;
  /** Entries that were not applied, by the key of the field, with the field's value at that time (`instead`). */
  readonly #unapplied = new Map<string, { readonly instead: string; readonly text: string }>();
  /** Groups for tools that the program does not name. */
  #added: readonly SetupGroup[] = [];
  #placeChosen: SetupPlace | undefined;
  #inputs: SetupInput[] = [];
  /** The first field of each group. */
  readonly #first = new Map<SetupGroup['group'] | undefined, SetupInput>();
  #wasIn: SetupPlace = 'page';
  #keep: SetupPlace = 'page';
  #asking: ReturnType<typeof setTimeout> | undefined;
  #asked = 0;

  constructor(language: Language, events: SetupFormEvents) {
    this.#language = language;
    this.#events = events;
    this.#apply.setAttribute('form', 'setup-form');
    this.#form.append(this.#groups);
    this.#dialog = new Dialog('setup', [this.#left, this.#form, this.#place], [this.#news, this.#apply]);
    this.#form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#submit();
    });
    this.#discard.addEventListener('click', () => {
      const form = this.#shown;
      this.forget();
      if (form !== undefined) this.show(form);
    });
    this.#add.addEventListener('click', () => void this.#another());
    this.#word.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter') return;
      event.preventDefault();
      void this.#another();
    });
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.#dialog.name(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#apply.textContent = texts.apply;
    this.#add.textContent = texts.add;
    this.#word.placeholder = texts.anotherHint;
    this.#noTool.textContent = texts.noTool;
    this.#leftText.textContent = texts.left;
    this.#discard.textContent = texts.discard;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** `opened` and `key`: the group and the field to open. */
  show(form: SetupForm, opened?: SetupGroup['group'], key?: string): void {
    this.#remember();
    const { groups, place } = form;
    this.#shown = form;
    this.#wasIn = place;
    const there = new Set(groups.flatMap(({ fields }) => fields.map(({ key }) => key)));
    this.#added = this.#added.filter(({ fields }) =>
      fields.some(({ key }) => this.#unapplied.has(key) && !there.has(key)),
    );
    this.#inputs = [];
    this.#first.clear();
    this.#noTool.hidden = true;
    const texts = WORDS[this.#language];
    const another = make(
      'div',
      { className: 'another' },
      make('label', { htmlFor: 'another-tool' }, texts.another),
      this.#word,
      this.#add,
      this.#noTool,
    );
    const elements = groups.map((group) => this.#group(group, opened));
    // After the last tool or, without tools, after the stock.
    const last = groups.findLastIndex(({ group }) => group === 'tool' || group === 'stock');
    elements.splice(last + 1, 0, ...this.#added.map((group) => this.#group(group)), another);
    this.#groups.replaceChildren(...elements);
    this.#fillIn();
    this.#keep = (this.#left.hidden ? undefined : this.#placeChosen) ?? place;
    this.#showPlace();
    this.#news.textContent = '';
    this.#dialog.show();
    this.#form.scrollTop = 0;
    (this.#inputs.find((input) => input.key === key) ?? this.#first.get(opened) ?? this.#inputs[0])?.focus();
    void this.#ask();
  }

  // ---- entries that were not applied --------------------------------------------------------------

  /** Another program was loaded, or everything was applied: drops the entries that were not applied. */
  forget(): void {
    this.#unapplied.clear();
    this.#added = [];
    this.#inputs = [];
    this.#placeChosen = undefined;
    this.#word.value = '';
  }

  /** Stores the entries that are not applied. */
  #remember(): void {
    for (const { key, value, text } of this.#inputs) {
      if (text === value) this.#unapplied.delete(key);
      else this.#unapplied.set(key, { instead: value, text });
    }
  }

  /** Restores an entry if the field still has the value that it had then. */
  #fillIn(): void {
    const left = this.#inputs.flatMap((input) => {
      const { instead, text } = this.#unapplied.get(input.key) ?? {};
      return text !== undefined && instead === input.value ? [{ input, text }] : [];
    });
    for (const { input, text } of left) {
      input.text = text;
      input.unfold();
    }
    this.#left.hidden = left.length === 0;
  }

  // ---- building -----------------------------------------------------------------------------------

  #group({ group, title, source, fields }: SetupGroup, opened?: SetupGroup['group']): HTMLElement {
    const texts = WORDS[this.#language];
    const inputs = fields.map((field) => new SetupInput(field, this.#language, () => this.#changed()));
    this.#inputs.push(...inputs);
    if (inputs[0] !== undefined) this.#first.set(group, inputs[0]);
    const clear = make(
      'button',
      { type: 'button', className: 'quiet clear', 'aria-label': texts.clear(title) },
      texts.clearShort,
    );
    clear.addEventListener('click', () => {
      for (const input of inputs) input.text = '';
      inputs[0]?.focus();
      this.#changed();
    });
    const grid = make('div', { className: 'fields' }, ...inputs.map(({ element }) => element));
    const from = make('span', { className: `source ${source}` }, texts.source[source]);
    if (FOLDED.has(group)) {
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
    const section = make('section', { className: 'group', 'aria-label': title }, legend, grid);
    return section;
  }

  #showPlace(): void {
    const texts = WORDS[this.#language];
    const choice = (place: SetupPlace, text: string): HTMLElement => {
      const radio = make('input', { type: 'radio', name: 'place', value: place, checked: this.#keep === place });
      radio.addEventListener('change', () => {
        this.#keep = this.#placeChosen = place;
        this.#showMoves();
      });
      return make('label', {}, radio, text);
    };
    this.#place.replaceChildren(
      make('legend', {}, texts.keep),
      choice('program', texts.keepInProgram),
      choice('page', texts.keepOnPage),
      this.#moves,
    );
    this.#showMoves();
  }

  #showMoves(): void {
    const texts = WORDS[this.#language];
    this.#moves.textContent = this.#wasIn === 'program' && this.#keep === 'page' ? texts.willMove : texts.programFirst;
  }

  // ---- asking -------------------------------------------------------------------------------------

  #changed(): void {
    clearTimeout(this.#asking);
    this.#asking = setTimeout(() => void this.#ask(), ASK_AFTER_MS);
  }

  /** Shows the result of the current entries; only the newest answer counts. */
  async #ask(): Promise<SetupAnswer | undefined> {
    clearTimeout(this.#asking);
    const asked = ++this.#asked;
    const answer = await this.#events.read({
      keys: this.#inputs.map(({ key }) => key),
      texts: this.#inputs.map(({ text }) => text),
      keep: this.#keep,
    });
    if (answer === undefined || asked !== this.#asked) return undefined;
    const states = new Map(answer.fields.map((state) => [state.key, state]));
    for (const input of this.#inputs) input.state = states.get(input.key);
    const wrong = answer.fields.filter(({ error }) => error !== undefined).length;
    const news = wrong === 0 ? '' : WORDS[this.#language].errors(wrong);
    if (this.#news.textContent !== news) this.#news.textContent = news;
    return answer;
  }

  async #submit(): Promise<void> {
    const keep = this.#keep;
    const answer = await this.#ask();
    if (answer === undefined) return;
    const error = answer.fields.find((state) => state.error !== undefined);
    if (error !== undefined) {
      this.#inputs.find(({ key }) => key === error.key)?.focus();
      return;
    }
    this.forget();
    this.#dialog.close();
    this.#events.kept(answer, keep);
  }

  async #another(): Promise<void> {
    const group = await this.#events.another(this.#word.value);
    this.#noTool.hidden = group !== undefined;
    if (group === undefined) {
      this.#word.focus();
      return;
    }
    const known = this.#inputs.find(({ key }) => key === group.fields[0]?.key);
    if (known === undefined) {
      this.#added = [...this.#added, group];
      this.#word.closest('.another')?.before(this.#group(group));
    }
    this.#word.value = '';
    this.#inputs.find(({ key }) => key === group.fields[0]?.key)?.focus();
    void this.#ask();
  }
}

const WORDS = words({
  en: {
    title: 'Setup',
    about: 'Stock, tools and machine. What is left empty is assumed, as the grey values say.',
    source: { program: 'in the program', page: 'on this page', nobody: 'assumed' },
    keep: 'Keep the setup',
    keepInProgram: 'in the program, as comments',
    keepOnPage: 'on this page',
    programFirst: 'Comments of the program override the setup of the page.',
    willMove: 'The comments are taken out of the program.',
    left: 'What you filled in before is still here; it is not applied yet.',
    discard: 'Discard it',
    apply: 'Apply',
    clear: (group: string) => `Clear: ${group}`,
    clearShort: 'Clear',
    another: 'Another tool',
    anotherHint: 'T0202',
    add: 'Add',
    noTool: 'Write T and up to four digits',
    errors: (n: number) => (n === 1 ? '1 invalid value' : `${n} invalid values`),
  },
  zh: {
    title: '毛坯与刀具',
    about: '毛坯、刀具和机床。留空的项目按灰色的值假定。',
    source: { program: '写在程序中', page: '保存在本页', nobody: '假定' },
    keep: '保存位置',
    keepInProgram: '写入程序注释',
    keepOnPage: '保存在本页',
    programFirst: '程序注释优先于本页的设置。',
    willMove: '程序中的这些注释将被删除。',
    left: '之前填写的内容还在，尚未应用。',
    discard: '放弃',
    apply: '应用',
    clear: (group) => `清除：${group}`,
    clearShort: '清除',
    another: '添加刀具',
    anotherHint: 'T0202',
    add: '添加',
    noTool: '请输入 T 和最多四位数字',
    errors: (n) => `有 ${n} 个值不正确`,
  },
  ru: {
    title: 'Наладка',
    about: 'Заготовка, инструменты и станок. Что не указано, берётся по умолчанию: это серые значения.',
    source: { program: 'в программе', page: 'на этой странице', nobody: 'по умолчанию' },
    keep: 'Хранить наладку',
    keepInProgram: 'в программе, в комментариях',
    keepOnPage: 'на этой странице',
    programFirst: 'Комментарии программы важнее наладки страницы.',
    willMove: 'Комментарии будут убраны из программы.',
    left: 'Заполненное раньше сохранено, но ещё не применено.',
    discard: 'Отменить',
    apply: 'Применить',
    clear: (group) => `Очистить: ${group}`,
    clearShort: 'Очистить',
    another: 'Ещё инструмент',
    anotherHint: 'T0202',
    add: 'Добавить',
    noTool: 'Напишите T и до четырёх цифр',
    errors: (n) => `Неверных значений: ${n}`,
  },
});
