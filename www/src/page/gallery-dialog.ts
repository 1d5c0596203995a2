// The gallery: all example programs by chapter of the manual, each with a small picture, and a search field.
//
// In: the list in one language. Out: a call of `onChoose` with the id of an example. Loaded when it is first opened.
// Must not know: how an example is loaded or shown.

import { Dialog } from '../dom/dialog';
import { make, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import { renderSource } from './example-source';
import type { Chapter, ListedExample } from './gallery';
import { smallDrawing } from './small-drawing';
import { PAGE_WORDS } from './words';
import '../dom/dialog.css';
import './gallery.css';

export class GalleryDialog {
  readonly #search = make('input', { type: 'search', autocomplete: 'off', spellcheck: false });
  readonly #caption = make('span');
  readonly #found = make('p', { className: 'found', role: 'status' });
  readonly #list = make('div', { className: 'chapters' });
  readonly #dialog = new Dialog('gallery', [
    make('label', { className: 'search' }, this.#caption, this.#search),
    this.#found,
    this.#list,
  ]);
  readonly #onChoose: (id: string) => void;
  #chapters: readonly Chapter[] = [];
  #language: Language = 'en';
  #current = '';

  constructor(onChoose: (id: string) => void) {
    this.#onChoose = onChoose;
    this.#search.addEventListener('input', () => this.#show());
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  /** Opens the dialog; `current` is the id of the current example. */
  open(chapters: readonly Chapter[], language: Language, current: string): void {
    this.#chapters = chapters;
    this.#language = language;
    this.#current = current;
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#caption.textContent = texts.search;
    this.#search.value = '';
    this.#show();
    this.#dialog.show();
    this.#search.focus();
    this.#scrollToCurrent();
  }

  /** Scrolls to the chapter of the current example or, in a long chapter, to its row: no card is cut at the top. */
  #scrollToCurrent(): void {
    const card = this.#list.querySelector('[aria-current]');
    if (card === null) return;
    const isInView = (): boolean => card.getBoundingClientRect().bottom <= this.#list.getBoundingClientRect().bottom;
    this.#list.scrollTop = 0;
    // Room below the last chapter, so that it can be scrolled to the top.
    const last = this.#list.querySelector<HTMLElement>('section:last-child');
    if (last !== null) last.style.minBlockSize = `${this.#list.clientHeight}px`;
    if (!isInView()) card.closest('section')?.scrollIntoView({ block: 'start' });
    if (!isInView()) card.scrollIntoView({ block: 'start' });
  }

  #show(): void {
    const terms = this.#search.value
      .toLowerCase()
      .split(/\s+/)
      .filter((term) => term !== '');
    const matches = (chapter: string, of: ListedExample): boolean => {
      const text = [chapter, of.title, of.shows, of.codes, of.id].join(' ').toLowerCase();
      return terms.every((term) => text.includes(term));
    };
    let count = 0;
    const sections = this.#chapters.flatMap(({ page, title, examples }) => {
      const found = examples.filter((of) => matches(title, of));
      count += found.length;
      return found.length === 0
        ? []
        : [
            make(
              'section',
              {},
              make('h3', {}, manualLink(page, title, this.#language)),
              make('ul', {}, ...found.map((of) => this.#item(of))),
            ),
          ];
    });
    const texts = WORDS[this.#language];
    this.#found.textContent = count === 0 ? texts.none : texts.count(count);
    this.#list.replaceChildren(...sections);
  }

  #item(of: ListedExample): HTMLElement {
    const summary = make('summary', {}, PAGE_WORDS[this.#language].source);
    const source = make('details', {}, summary, ...renderSource(of, this.#language));
    return make('li', { 'data-example': of.id }, this.#card(of), source);
  }

  #card({ id, title, shows, picture }: ListedExample): HTMLElement {
    const card = make('button', { type: 'button', className: 'card' });
    card.append(
      smallDrawing(picture),
      make('span', { className: 'title' }, ...renderUnbroken(title)),
      make('span', { className: 'shows' }, ...renderUnbroken(shows)),
    );
    if (id === this.#current) card.setAttribute('aria-current', 'true');
    card.addEventListener('click', () => {
      this.#dialog.close();
      this.#onChoose(id);
    });
    return card;
  }
}

/** A link to a page of the manual, which is built beside this page. */
function manualLink(page: string, text: string, language: Language): HTMLAnchorElement {
  const { href } = new URL(`manual/${language}/${page}.html`, document.baseURI);
  return make('a', { className: 'link', href, target: '_blank', rel: 'noopener' }, text);
}

const WORDS = words({
  en: {
    title: 'Gallery',
    about: 'Programs to read, run and change. A card opens its program with its blank and tools.',
    search: 'Search',
    count: counter('en', { one: 'example', other: 'examples' }),
    none: 'No example matches.',
  },
  zh: {
    title: '示例',
    about: '可阅读、运行和修改的程序。点击卡片，打开程序及其毛坯和刀具。',
    search: '查找',
    count: counter('zh', { other: '个示例' }),
    none: '没有匹配的示例。',
  },
  ru: {
    title: 'Примеры',
    about:
      'Программы, которые можно читать, запускать и менять. Карточка открывает программу с её заготовкой и инструментами.',
    search: 'Поиск',
    count: counter('ru', { one: 'пример', few: 'примера', many: 'примеров', other: 'примера' }),
    none: 'Подходящих примеров нет.',
  },
});
