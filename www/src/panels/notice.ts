// Two lines above the program: one for missing files, one for the newest other notice, such as an opened file. The
// user can dismiss each.
//
// In: a text and its topic. Must not know: the caller.

import { make, name } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Panel, PanelKind, Remedy, Services, Topic } from './panel';
import noticeStyles from './notice.css?inline';

export const notice: PanelKind = { styles: noticeStyles, make: () => new Notice() };

class Notice implements Panel {
  readonly #news = new Line((act) => {
    this.#hide();
    act?.();
  });
  readonly #missing = new Line((act) => act?.());
  #topic: Topic | undefined;
  readonly places = { notices: [this.#missing.element, this.#news.element] };
  readonly services: Partial<Services> = {
    notice: (text, topic = 'file', remedy) => {
      if (topic === 'missing') return this.#missing.show(text, remedy);
      this.#topic = topic;
      this.#news.show(text, remedy);
    },
    // A notice of another topic remains.
    hideNotice: (topic) => {
      if (topic === 'missing') this.#missing.hide();
      else if (this.#topic === topic) this.#hide();
    },
  };

  set language(language: Language) {
    for (const line of [this.#missing, this.#news]) line.language = language;
  }

  #hide(): void {
    this.#topic = undefined;
    this.#news.hide();
  }
}

/** A text, a button for its remedy, and a button that dismisses it. */
class Line {
  readonly element = make('div', { className: 'notice', part: 'notice', role: 'alert', hidden: true });
  readonly #text = make('p');
  readonly #remedy = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #close = make('button', { type: 'button', className: 'quiet' }, '×');
  #act: (() => void) | undefined;

  constructor(pressed: (act: (() => void) | undefined) => void) {
    this.#close.addEventListener('click', () => this.hide());
    this.#remedy.addEventListener('click', () => pressed(this.#act));
    this.element.append(this.#text, this.#remedy, this.#close);
  }

  set language(language: Language) {
    name(this.#close, WORDS[language].dismiss);
  }

  show(text: string, remedy: Remedy | undefined): void {
    // The same text is not announced again.
    if (this.#text.textContent !== text) this.#text.textContent = text;
    this.#remedy.hidden = remedy === undefined;
    this.#remedy.textContent = remedy?.title ?? '';
    this.#act = remedy?.act;
    this.element.hidden = false;
  }

  hide(): void {
    this.element.hidden = true;
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
