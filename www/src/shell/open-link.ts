// The link "Open in the playground" of an element in another page.
//
// In: the element's attributes and its program. Out: an anchor, whose address is made when the pointer or the focus
// reaches it, since a program can be long. Must not know: how the page reads the address.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { plainTextLink } from '../files/plain-text-link';

/** The properties of the element that the link uses. */
export interface LinkHost {
  readonly language: Language;
  readonly playground: string | null;
  readonly controls: string | null;
  readonly value: string;
  getAttribute(name: string): string | null;
}

export class OpenLink {
  readonly element = make(
    'a',
    { className: 'open-link', part: 'open-link', target: '_blank', rel: 'noopener', hidden: true },
    icon('open'),
  );
  readonly #host: LinkHost;
  readonly #defaultPage: string | undefined;

  /** `defaultPage`: the page to link to if the attribute `playground` is missing. */
  constructor(host: LinkHost, defaultPage: string | undefined) {
    this.#host = host;
    this.#defaultPage = defaultPage;
    // These come before a click, a middle click and the context menu.
    for (const eventName of ['pointerenter', 'pointerdown', 'focus', 'click'])
      this.element.addEventListener(eventName, () => this.#updateAddress());
    this.changed();
  }

  /** An attribute or the language has changed. */
  changed(): void {
    const { language, controls } = this.#host;
    setAccessibleName(this.element, WORDS[language].open);
    const page = this.#page;
    this.element.hidden = page === undefined || (controls !== null && !/\blink\b/.test(controls));
    // Without an `href` it would not be a link.
    if (page !== undefined) this.element.href = page.href;
  }

  get #page(): URL | undefined {
    const { playground } = this.#host;
    const address = playground ?? this.#defaultPage ?? '';
    if (address === '') return undefined;
    try {
      const page = new URL(address, document.baseURI);
      return /^https?:$/.test(page.protocol) ? page : undefined;
    } catch {
      return undefined;
    }
  }

  #updateAddress(): void {
    const page = this.#page;
    if (page === undefined) return;
    const { value: text, language } = this.#host;
    const attribute = (name: string): string | null => this.#host.getAttribute(name);
    page.hash = plainTextLink({
      text,
      language,
      setup: attribute('setup'),
      control: attribute('control'),
      blockSkip: attribute('block-skip'),
      program: attribute('program'),
      view: null,
      step: attribute('step'),
      readonly: false,
    });
    this.element.href = page.href;
  }
}

const WORDS = words({
  en: { open: 'Open in the playground' },
  zh: { open: '在演练场中打开' },
  ru: { open: 'Открыть в песочнице' },
});
