// The notice over the element about saving the program.
//
// In: a notice, the language, and the handler of its buttons. Out: an element for the page, visible whichever part of
// the program is shown; empty if there is no notice. Must not know: how programs are saved.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { NEWS_WORDS } from './own-programs-words';
import './own-programs-news.css';

export type News =
  /** Another tab has changed the current program. */
  | { readonly kind: 'changed-elsewhere' }
  /** Both tabs have changed the program: this tab continues with a separate one of this name. */
  | { readonly kind: 'both-kept'; readonly name: string }
  | { readonly kind: 'deleted-elsewhere' }
  /** `last-only`: the journal still has the last program. */
  | { readonly kind: 'full' | 'refused' | 'last-only' | 'cleared' | 'too-many' };

export type NewsAct = 'show' | 'keep-both' | 'save-file' | 'open-list';

/** The buttons of each notice. */
const BUTTONS: Readonly<Record<News['kind'], readonly NewsAct[]>> = {
  'changed-elsewhere': ['show', 'keep-both'],
  'both-kept': ['open-list'],
  'deleted-elsewhere': [],
  full: ['save-file', 'open-list'],
  refused: ['save-file'],
  'last-only': ['save-file'],
  cleared: ['save-file'],
  'too-many': ['save-file', 'open-list'],
};

export class NewsLine {
  readonly element = make('div', { id: 'own-news', role: 'status' });
  readonly #onAction: (act: NewsAct) => void;
  #news: News | undefined;
  #language: Language = 'en';

  constructor(act: (act: NewsAct) => void) {
    this.#onAction = act;
  }

  get news(): News['kind'] | undefined {
    return this.#news?.kind;
  }

  set language(language: Language) {
    if (language === this.#language) return;
    this.#language = language;
    this.show(this.#news);
  }

  show(news: News | undefined): void {
    this.#news = news;
    if (news === undefined) {
      this.element.replaceChildren();
      return;
    }
    const texts = NEWS_WORDS[this.#language];
    const text = news.kind === 'both-kept' ? texts.messages[news.kind](news.name) : texts.messages[news.kind];
    const buttons = BUTTONS[news.kind].map((act) => {
      const button = make('button', { type: 'button', className: 'link' }, texts.actions[act]);
      button.addEventListener('click', () => this.#onAction(act));
      return button;
    });
    this.element.replaceChildren(make('p', {}, text), ...buttons);
  }
}
