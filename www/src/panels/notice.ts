// Two lines above the program: one for missing files, one for the newest other notice, such as an opened file. The
// user can dismiss each.
//
// In: a text and its topic. Must not know: the caller.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Panel, PanelKind, NoticeAction, Services, Topic } from './panel';
import noticeStyles from './notice.css?inline';

export const notice: PanelKind = { styles: noticeStyles, make: () => new Notice() };

class Notice implements Panel {
  readonly #latest = new NoticeLine((act) => {
    this.#hide();
    act?.();
  });
  readonly #missing = new NoticeLine((act) => act?.());
  #topic: Topic | undefined;
  readonly elements = { notices: [this.#missing.element, this.#latest.element] };
  readonly services: Partial<Services> = {
    notice: (text, topic = 'file', action) => {
      if (topic === 'missing') return this.#missing.show(text, action);
      this.#topic = topic;
      this.#latest.show(text, action);
    },
    // A notice of another topic remains.
    hideNotice: (topic) => {
      if (topic === 'missing') this.#missing.hide();
      else if (this.#topic === topic) this.#hide();
    },
  };

  set language(language: Language) {
    for (const line of [this.#missing, this.#latest]) line.language = language;
  }

  #hide(): void {
    this.#topic = undefined;
    this.#latest.hide();
  }
}

/** A text, a button for its remedy, and a button that dismisses it. */
class NoticeLine {
  readonly element = make('div', { className: 'notice', part: 'notice', role: 'alert', hidden: true });
  readonly #text = make('p');
  readonly #action = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #close = make('button', { type: 'button', className: 'close' }, icon('whole'));
  #act: (() => void) | undefined;

  constructor(onAction: (act: (() => void) | undefined) => void) {
    this.#close.addEventListener('click', () => this.hide());
    this.#action.addEventListener('click', () => onAction(this.#act));
    this.element.append(this.#text, this.#action, this.#close);
  }

  set language(language: Language) {
    setAccessibleName(this.#close, WORDS[language].dismiss);
  }

  show(text: string, action: NoticeAction | undefined): void {
    // The same text is not announced again.
    if (this.#text.textContent !== text) this.#text.textContent = text;
    this.#action.hidden = action === undefined;
    this.#action.textContent = action?.title ?? '';
    this.#act = action?.act;
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
