// The list of examples in the header, and the button of the gallery.
//
// In: the current example. Out: the example that the user selects. The list is loaded after the first picture, or when
// the user opens it; the gallery's dialog when it is first opened. Must not know: how an example is loaded.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import type { GcodePlayground } from '../shell/element';
import { find, label } from './find';
import { loadSubjects, type Example, type Subject } from './gallery';
import type { GalleryDialog } from './gallery-dialog';
import { PAGE_WORDS } from './words';

/** What the page provides to the list of examples. */
interface ExamplesHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  readonly example: Example | undefined;
  choose(id: string): void;
  /** Reports that the gallery could not be loaded, with a function that retries; `undefined` once it is loaded. */
  onGalleryMissing(retry: (() => void) | undefined): void;
}

export class ExampleList {
  readonly #host: ExamplesHost;
  readonly #select = find<HTMLSelectElement>('example');
  readonly #button = find<HTMLButtonElement>('gallery');
  /** In the language of the page; empty until loaded. */
  #subjects: readonly Subject[] = [];
  #dialog: GalleryDialog | undefined;

  constructor(host: ExamplesHost) {
    this.#host = host;
    this.#button.append(icon('gallery'));
    this.#button.addEventListener('click', () => void this.#openGallery());
    this.#select.addEventListener('change', () => host.choose(this.#select.value));
    for (const [target, event] of [
      [host.playground, 'gcode-settled'],
      [this.#select, 'pointerdown'],
      [this.#select, 'focus'],
    ] as const) {
      target.addEventListener(event, () => void this.#load(), { once: true });
    }
  }

  showLanguage(): void {
    const texts = PAGE_WORDS[this.#host.language];
    label(this.#select, texts.example);
    setAccessibleName(this.#button, texts.gallery);
    if (this.#subjects.length > 0) void this.#load();
    this.show();
  }

  /** Renders the list; only the current example until the list is loaded. */
  show(): void {
    const { example, language } = this.#host;
    const options = this.#subjects.map(({ subject, examples }) => {
      const group = make('optgroup', { label: subject });
      group.append(...examples.map(({ id, title }) => make('option', { value: id }, title)));
      return group;
    });
    const listed = this.#subjects.some(({ examples }) => examples.some(({ id }) => id === example?.id));
    const currentOnly =
      example === undefined
        ? make('option', { value: '', hidden: true }, PAGE_WORDS[language].ownProgram)
        : make('option', { value: example.id, hidden: this.#subjects.length > 0 }, example.title[language]);
    this.#select.replaceChildren(...(listed ? [] : [currentOnly]), ...options);
    this.#select.value = example?.id ?? '';
  }

  /** Loads the list in the language of the page; the page works without it. */
  async #load(): Promise<readonly Subject[]> {
    const { language } = this.#host;
    try {
      const list = await loadSubjects(language);
      if (language === this.#host.language && this.#subjects !== list) {
        this.#subjects = list;
        this.show();
      }
      return list;
    } catch {
      return [];
    }
  }

  async #openGallery(): Promise<void> {
    const host = this.#host;
    const [list, module] = await Promise.all([
      this.#load(),
      importWithRetry(() => import('./gallery-dialog')).catch(() => undefined),
    ]);
    if (list.length === 0 || module === undefined) return host.onGalleryMissing(() => void this.#openGallery());
    host.onGalleryMissing(undefined);
    if (this.#dialog === undefined) {
      this.#dialog = new module.GalleryDialog((id) => host.choose(id));
      document.body.append(this.#dialog.element);
    }
    this.#dialog.open(list, host.language, host.example?.id ?? '');
  }
}
