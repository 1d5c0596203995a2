// The title of the program, and the gallery of the examples.
//
// In: the current example. Out: the example that the user selects. The list of examples and the dialog are loaded when
// the gallery is first opened. Must not know: how an example is loaded.

import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import { loadChapters, type Chapter, type Example } from './gallery';
import type { GalleryDialog } from './gallery-dialog';
import { PAGE_WORDS } from './words';

/** What the page provides to the list of examples. */
interface ExamplesHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  readonly example: Example | undefined;
  /** The title of the exercise, once the element shows its task. */
  readonly exerciseTitle: string | undefined;
  choose(id: string): void;
  /** Reports that the gallery could not be loaded, with a function that retries; `undefined` once it is loaded. */
  onGalleryMissing(retry: (() => void) | undefined): void;
}

export class ExampleList {
  readonly #host: ExamplesHost;
  readonly #title = find('title');
  #dialog: GalleryDialog | undefined;

  constructor(host: ExamplesHost) {
    this.#host = host;
  }

  /** Shows the title of the program: of its file, of its example, or that it is an exercise or the user's own. */
  show(): void {
    const { example, exerciseTitle, language, playground } = this.#host;
    const texts = PAGE_WORDS[language];
    const other = playground.exercise === null ? texts.ownProgram : (exerciseTitle ?? texts.exercise);
    this.#title.textContent = playground.file?.name ?? example?.title[language] ?? other;
  }

  /** Loads the list in the language of the page; the page works without it. */
  async #load(): Promise<readonly Chapter[]> {
    const { language } = this.#host;
    try {
      return await loadChapters(language);
    } catch {
      return [];
    }
  }

  async open(): Promise<void> {
    const host = this.#host;
    const [list, module] = await Promise.all([
      this.#load(),
      importWithRetry(() => import('./gallery-dialog')).catch(() => undefined),
    ]);
    if (list.length === 0 || module === undefined) return host.onGalleryMissing(() => void this.open());
    host.onGalleryMissing(undefined);
    if (this.#dialog === undefined) {
      this.#dialog = new module.GalleryDialog((id) => host.choose(id));
      document.body.append(this.#dialog.element);
    }
    this.#dialog.open(list, host.language, host.example?.id ?? '');
  }
}
