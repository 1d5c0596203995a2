// The outline of the program: a list of its programs, tools, operations and cycles, with a filter field.
//
// In: the entries, as the interpreter answers them, and the cursor. Out: the offset of the selected block. Must not
// know: the meaning of an entry.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import type { OutlineEntry, OutlineHelp } from '../protocol/protocol';

/** An entry of the list, with the lower-case text that the filter searches. */
interface ListEntry {
  readonly element: HTMLElement;
  readonly from: number;
  readonly words: string;
}

export class OutlineDialog {
  readonly #onChoose: (offset: number) => void;
  readonly #field = make('input', {
    type: 'search',
    autocomplete: 'off',
    spellcheck: false,
    role: 'combobox',
    'aria-expanded': 'true',
    'aria-autocomplete': 'list',
    'aria-controls': 'outline-list',
  });
  readonly #found = make('span', { className: 'found', role: 'log' });
  readonly #caption = make('span');
  readonly #empty = make('div', { className: 'outline-empty' });
  readonly #list = make('div', {
    className: 'outline-list',
    id: 'outline-list',
    role: 'listbox',
    'aria-labelledby': 'outline-title',
  });
  readonly #dialog: Dialog;
  #language: Language;
  #entries: readonly ListEntry[] = [];
  #isTruncated = false;
  #active: ListEntry | undefined;

  constructor(language: Language, onChoose: (offset: number) => void) {
    this.#onChoose = onChoose;
    this.#dialog = new Dialog('outline', [
      make('label', { className: 'find' }, this.#caption, this.#field, this.#found),
      this.#list,
      this.#empty,
    ]);
    this.#field.addEventListener('input', () => this.#applyFilter());
    this.#field.addEventListener('keydown', (event) => this.#handleKey(event));
    this.#list.addEventListener('click', ({ target }) =>
      this.#choose(this.#entries.find(({ element }) => target instanceof Node && element.contains(target))),
    );
    this.element.addEventListener('close', () => {
      this.#entries = [];
      this.#active = undefined;
      this.#list.replaceChildren();
    });
    this.#language = language;
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.outline, COMMON[language].close);
    this.#caption.textContent = texts.filter;
    if (this.open) this.#showStatus();
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** Opens the dialog with an empty list. */
  openEmpty(): void {
    if (!this.#dialog.show()) return;
    this.#field.value = '';
    this.#found.textContent = '';
    this.#empty.hidden = true;
    this.#field.focus();
  }

  /** Shows an outline. If the filter is empty, selects the entry that contains the cursor. */
  show({ entries, cut }: OutlineHelp, cursor: number): void {
    this.#entries = entries.map((entry, at) => this.#makeEntry(entry, at));
    this.#isTruncated = cut;
    this.#list.replaceChildren(...this.#entries.map(({ element }) => element));
    this.#applyFilter();
    if (this.#field.value === '')
      this.#setActive(this.#entries.filter(({ from }) => from <= cursor).at(-1) ?? this.#entries[0], 'center');
  }

  close(): void {
    this.#dialog.close();
  }

  #makeEntry({ kind, depth, from, line, name, detail }: OutlineEntry, at: number): ListEntry {
    const place = make('span', { className: 'outline-line' }, String(line));
    const element = make(
      'div',
      { className: `outline-entry ${kind}`, role: 'option', id: `outline-${at}`, 'aria-selected': 'false' },
      make('span', { className: 'outline-name' }, name),
      make('span', { className: 'outline-detail' }, detail),
      place,
    );
    element.style.setProperty('--depth', String(depth));
    return { element, from, words: `${name} ${detail}`.toLowerCase() };
  }

  get #visibleEntries(): readonly ListEntry[] {
    return this.#entries.filter(({ element }) => !element.hidden);
  }

  /** Shows the entries that contain all words of the filter. */
  #applyFilter(): void {
    const terms = this.#field.value.trim().toLowerCase().split(/\s+/);
    for (const { element, words } of this.#entries) element.hidden = !terms.every((word) => words.includes(word));
    this.#showStatus();
    const shown = this.#visibleEntries;
    this.#setActive(this.#active !== undefined && shown.includes(this.#active) ? this.#active : shown[0], 'nearest');
  }

  #showStatus(): void {
    const texts = WORDS[this.#language];
    const { length } = this.#visibleEntries;
    this.#found.textContent = this.#field.value.trim() === '' ? '' : texts.found(length);
    this.#empty.hidden = length > 0 && !this.#isTruncated;
    this.#empty.textContent =
      this.#entries.length === 0 ? texts.nothing : this.#isTruncated ? texts.cut : texts.notFound;
  }

  #setActive(active: ListEntry | undefined, block: 'nearest' | 'center'): void {
    this.#active?.element.setAttribute('aria-selected', 'false');
    this.#active = active;
    if (active === undefined) return this.#field.removeAttribute('aria-activedescendant');
    active.element.setAttribute('aria-selected', 'true');
    this.#field.setAttribute('aria-activedescendant', active.element.id);
    active.element.scrollIntoView({ block });
  }

  #handleKey(event: KeyboardEvent): void {
    const shown = this.#visibleEntries;
    const at = this.#active === undefined ? -1 : shown.indexOf(this.#active);
    const page = Math.max(1, Math.floor(this.#list.clientHeight / (this.#active?.element.offsetHeight || 28)) - 1);
    const target = { ArrowDown: at + 1, ArrowUp: at - 1, PageDown: at + page, PageUp: at - page }[event.key];
    if (target !== undefined) this.#setActive(shown[Math.min(Math.max(target, 0), shown.length - 1)], 'nearest');
    else if (event.key === 'Enter') this.#choose(this.#active);
    // In some browsers, Escape would only clear the field.
    else if (event.key === 'Escape') this.#dialog.close();
    else return;
    event.preventDefault();
  }

  #choose(entry: ListEntry | undefined): void {
    if (entry === undefined) return;
    this.#dialog.close();
    this.#onChoose(entry.from);
  }
}

const WORDS = words({
  en: {
    outline: 'Outline of the program',
    filter: 'Find',
    found: counter('en', { one: 'entry', other: 'entries' }),
    nothing: 'There is nothing to list: no program number, tool, cycle or comment is in this text.',
    notFound: 'No entry contains these words.',
    cut: 'The program goes on; the outline ends here.',
  },
  zh: {
    outline: '程序大纲',
    filter: '查找',
    found: counter('zh', { other: '项' }),
    nothing: '没有可列的内容：文本中没有程序号、刀具、循环或注释。',
    notFound: '没有条目包含这些字词。',
    cut: '程序还有后文，大纲到此为止。',
  },
  ru: {
    outline: 'Структура программы',
    filter: 'Поиск',
    found: counter('ru', { one: 'пункт', few: 'пункта', other: 'пунктов' }),
    nothing: 'Показать нечего: в тексте нет ни номера программы, ни инструмента, ни цикла, ни комментария.',
    notFound: 'Пунктов с такими словами нет.',
    cut: 'Программа продолжается, структура показана до этого места.',
  },
});
