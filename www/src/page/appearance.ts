// Theme and text size of the page. Both are saved.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import type { GcodePlayground } from '../shell/element';
import { find, label } from './find';
import { readChoices, saveChoices } from './storage';
import { PAGE_WORDS } from './words';

const THEMES = ['auto', 'light', 'dark'] as const;
/** In percent of the browser's default size. */
const TEXT_SIZES = ['87.5', '100', '125', '150', '200'] as const;

export class Appearance {
  readonly #playground: GcodePlayground;
  readonly #theme = find<HTMLSelectElement>('theme');
  readonly #textSize = find<HTMLSelectElement>('text-size');

  constructor(playground: GcodePlayground) {
    this.#playground = playground;
    for (const value of THEMES) this.#theme.append(make('option', { value }));
    for (const value of TEXT_SIZES) this.#textSize.append(make('option', { value }, `${value} %`));
    const { theme, textSize } = readChoices();
    this.#showTheme(THEMES.find((known) => known === theme) ?? 'auto');
    this.#showTextSize(TEXT_SIZES.find((known) => known === textSize) ?? '100');
    this.#theme.addEventListener('change', () => {
      saveChoices({ theme: this.#theme.value });
      this.#showTheme(this.#theme.value);
    });
    this.#textSize.addEventListener('change', () => {
      saveChoices({ textSize: this.#textSize.value });
      this.#showTextSize(this.#textSize.value);
    });
  }

  showLanguage(language: Language): void {
    const texts = PAGE_WORDS[language];
    label(this.#theme, texts.theme);
    label(this.#textSize, texts.textSize);
    for (const option of this.#theme.options)
      option.textContent = texts.themes[option.value as (typeof THEMES)[number]];
  }

  #showTheme(theme: string): void {
    this.#theme.value = theme;
    document.documentElement.dataset['theme'] = theme;
    this.#playground.theme = theme;
  }

  /** The root font size scales the whole page, including the text in the drawing. */
  #showTextSize(percent: string): void {
    this.#textSize.value = percent;
    document.documentElement.style.fontSize = percent === '100' ? '' : `${percent}%`;
  }
}
