// Language, theme and text size of the page: the first rows of the menu "More". All are saved.
//
// In: the choices of earlier visits. Out: attributes of the page and of the element. Must not know: the texts of other
// parts.

import { make } from '../dom/dom';
import { LANGUAGES, type Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import { readChoices, saveChoices } from './storage';
import { PAGE_WORDS } from './words';

const THEMES = ['auto', 'light', 'dark'] as const;
/** In percent of the browser's default size. */
const TEXT_SIZES = ['87.5', '100', '125', '150', '200'] as const;

/** A row of a menu of which one value is chosen. */
class Choice<V extends string> {
  readonly element = make('div', { className: 'choice-row', role: 'group' });
  readonly #items: ReadonlyMap<V, HTMLButtonElement>;

  constructor(values: readonly V[], onChoose: (value: V) => void) {
    this.#items = new Map(
      values.map((value) => {
        const item = menuItem({ role: 'menuitemradio' });
        item.addEventListener('click', () => onChoose(value));
        return [value, item];
      }),
    );
    this.element.append(...this.#items.values());
  }

  setTexts(label: string, text: (value: V) => string): void {
    this.element.setAttribute('aria-label', label);
    this.element.title = label;
    for (const [value, item] of this.#items) item.textContent = text(value);
  }

  set value(chosen: V) {
    for (const [value, item] of this.#items) item.setAttribute('aria-checked', String(value === chosen));
  }
}

export class Appearance {
  readonly #playground: GcodePlayground;
  readonly #language: Choice<Language>;
  readonly #theme: Choice<(typeof THEMES)[number]>;
  readonly #textSize: Choice<(typeof TEXT_SIZES)[number]>;

  constructor(playground: GcodePlayground, onLanguage: (language: Language) => void) {
    this.#playground = playground;
    this.#language = new Choice(LANGUAGES, onLanguage);
    this.#theme = new Choice(THEMES, (theme) => {
      saveChoices({ theme });
      this.#showTheme(theme);
    });
    this.#textSize = new Choice(TEXT_SIZES, (textSize) => {
      saveChoices({ textSize });
      this.#showTextSize(textSize);
    });
    find('more-menu').prepend(this.#language.element, this.#theme.element, this.#textSize.element);
    const { theme, textSize } = readChoices();
    this.#showTheme(THEMES.find((known) => known === theme) ?? 'auto');
    this.#showTextSize(TEXT_SIZES.find((known) => known === textSize) ?? '100');
  }

  showLanguage(language: Language): void {
    const texts = PAGE_WORDS[language];
    this.#language.value = language;
    this.#language.setTexts(texts.language, (tag) => PAGE_WORDS[tag].languageName);
    this.#theme.setTexts(texts.theme, (theme) => texts.themes[theme]);
    this.#textSize.setTexts(texts.textSize, (percent) => `${percent} %`);
  }

  #showTheme(theme: (typeof THEMES)[number]): void {
    this.#theme.value = theme;
    document.documentElement.dataset['theme'] = theme;
    this.#playground.theme = theme;
  }

  /** The root font size scales the whole page, including the text in the drawing. */
  #showTextSize(percent: (typeof TEXT_SIZES)[number]): void {
    this.#textSize.value = percent;
    document.documentElement.style.fontSize = percent === '100' ? '' : `${percent}%`;
  }
}
