// One line of news above the program: something failed, a file was opened. The reader can dismiss it.
//
// In: a text and what it is about. Must not know: who says it.

import { make, name } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Panel, PanelKind, Remedy, Services, Topic } from './panel';
import noticeStyles from './notice.css?inline';

export const notice: PanelKind = { styles: noticeStyles, make: () => new Notice() };

class Notice implements Panel {
  readonly #element = make('div', { className: 'notice', part: 'notice', role: 'alert', hidden: true });
  readonly #text = make('p');
  /** What can be done about it. */
  readonly #remedy = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #close = make('button', { type: 'button', className: 'quiet' }, '×');
  #topic: Topic | undefined;
  #act: (() => void) | undefined;
  readonly places = { notices: [this.#element] };
  readonly services: Partial<Services> = {
    notice: (text, topic = 'file', remedy) => this.#show(text, topic, remedy),
    // Another one stays.
    hideNotice: (topic) => {
      if (this.#topic === topic) this.#hide();
    },
  };

  constructor() {
    this.#close.addEventListener('click', () => this.#hide());
    this.#remedy.addEventListener('click', () => {
      const act = this.#act;
      this.#hide();
      act?.();
    });
    this.#element.append(this.#text, this.#remedy, this.#close);
  }

  set language(language: Language) {
    name(this.#close, WORDS[language].dismiss);
  }

  #show(text: string, topic: Topic, remedy: Remedy | undefined): void {
    this.#topic = topic;
    this.#text.textContent = text;
    this.#remedy.hidden = remedy === undefined;
    this.#remedy.textContent = remedy?.title ?? '';
    this.#act = remedy?.act;
    this.#element.hidden = false;
  }

  #hide(): void {
    this.#topic = undefined;
    this.#element.hidden = true;
  }
}

const WORDS = words({
  en: {
    dismiss: 'Dismiss',
  },
  zh: {
    dismiss: '关闭提示',
  },
  ru: {
    dismiss: 'Скрыть',
  },
});
