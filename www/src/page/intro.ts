// The lines above the program: a description of the example, an offer to restore the previous program, or a loading
// error.
//
// In: which of these to show. Out: the lines, and clicks on their buttons. Must not know: how a program is loaded or
// saved.

import { icon, make, renderUnbroken, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { importWithRetry, whenOnline } from '../dom/network';
import { isMostlyIn } from '../editor/program-replacement';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import type { Example } from './gallery';
import type { LinkedProgram } from './linked';
import { MAX_SAVED_LENGTH, readChoices, saveChoices, type OwnProgram } from './storage';
import { PAGE_WORDS } from './words';

type IntroContent =
  | { readonly kind: 'example' | 'restored' }
  /** The network failed; `retry` retries once it is back. */
  | { readonly kind: 'not-loaded'; readonly retry: () => void }
  | { readonly kind: 'previous'; readonly program: OwnProgram }
  /** The user has edited the program of the link in the address. */
  | {
      readonly kind: 'linked';
      readonly address: string;
      readonly linked: LinkedProgram;
      readonly previous?: OwnProgram;
    };

/** What the page provides to the lines above the program. */
interface IntroHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  readonly example: Example | undefined;
  /** The number of requests to show a program. */
  readonly requestCount: number;
  /** Saves the current program and shows the original example; the first example if the program is not one. */
  resetToExample(): void;
  /** Saves the current program and shows the original program of a link. */
  reopenLink(address: string, linked: LinkedProgram): void;
  restoreProgram(program: OwnProgram): void;
}

/** In a narrower window the description is closed until the user opens it, to leave room for the program. */
const MIN_WIDTH_FOR_DESCRIPTION_PX = 1200;

export class Intro {
  readonly #host: IntroHost;
  readonly #element = find('intro');
  #current: IntroContent = { kind: 'example' };
  /** Shows and hides the description of the program. */
  readonly #toggle = make(
    'button',
    { type: 'button', id: 'about', slot: 'about', 'aria-controls': 'intro', 'aria-expanded': 'true' },
    icon('info'),
  );
  #isOpen = (readChoices().description ?? (innerWidth >= MIN_WIDTH_FOR_DESCRIPTION_PX ? 'open' : 'closed')) === 'open';
  /** The values from which the current lines were rendered. */
  #shown: readonly unknown[] = [];

  constructor(host: IntroHost) {
    this.#host = host;
    host.playground.append(this.#element, this.#toggle);
    this.#toggle.addEventListener('click', () => {
      this.#isOpen = !this.#isOpen;
      saveChoices({ description: this.#isOpen ? 'open' : 'closed' });
      this.refresh();
    });
    // When there is little room the element scrolls; make it scrollable by keyboard too.
    new ResizeObserver(() => {
      if (this.#element.scrollHeight > this.#element.clientHeight) this.#element.tabIndex = 0;
      else this.#element.removeAttribute('tabindex');
    }).observe(this.#element);
  }

  get current(): IntroContent {
    return this.#current;
  }

  show(content: IntroContent): void {
    this.#current = content;
    const { playground, language, example } = this.#host;
    const isFile = playground.file !== undefined;
    const isTooLong = playground.length > MAX_SAVED_LENGTH;
    // Of a text that is no longer the example, the description would be wrong.
    const isDescribed = example !== undefined && !isFile && isMostlyIn(example.program, playground.value);
    const described = isDescribed ? example : undefined;
    // This runs after each key press; skip the re-render if nothing changed, because it would lay out the whole page.
    const shown = [content, language, example, described, isTooLong, this.#isOpen];
    if (shown.every((one, i) => one === this.#shown[i])) return;
    this.#shown = shown;
    const texts = PAGE_WORDS[language];
    const lines: HTMLElement[] = [];
    setAccessibleName(this.#toggle, texts.description);
    this.#toggle.setAttribute('aria-expanded', String(this.#isOpen));
    this.#toggle.hidden = described === undefined;
    if (described !== undefined && this.#isOpen) {
      lines.push(make('p', {}, ...renderUnbroken(described.shows[language])));
      // A first lesson keeps its source in the gallery, to leave room for the program.
      if (described.labels !== true) lines.push(sourceDetails(described.id, language));
    }
    if (isTooLong) lines.push(make('p', { className: 'kept' }, texts.tooLongToSave));
    lines.push(...this.#offerLines(content));
    this.#element.replaceChildren(...lines);
    this.#element.hidden = lines.length === 0;
  }

  /** Offers to restore a replaced program, in addition to the current lines. */
  offer(program: OwnProgram): void {
    this.show(
      this.#current.kind === 'linked' ? { ...this.#current, previous: program } : { kind: 'previous', program },
    );
  }

  /** Call after a change of the language, the program or its length. */
  refresh(): void {
    this.show(this.#current);
  }

  /** Retries once the network is back, unless the user has opened something else meanwhile. */
  showNotLoaded(retry: () => void): void {
    const content: IntroContent = { kind: 'not-loaded', retry };
    const { playground, requestCount } = this.#host;
    const { value } = playground;
    this.show(content);
    whenOnline(() => {
      if (this.#current === content && this.#host.requestCount === requestCount && playground.value === value) retry();
    });
  }

  #offerLines(content: IntroContent): HTMLElement[] {
    const host = this.#host;
    const texts = PAGE_WORDS[host.language];
    const restoreProgram = (program: OwnProgram): HTMLElement =>
      offerLine(texts.previousProgram, texts.restoreProgram, () => host.restoreProgram(program));
    switch (content.kind) {
      case 'example':
        return [];
      case 'restored':
        return [
          offerLine(texts.restored, host.example === undefined ? texts.firstExample : texts.resetToExample, () =>
            host.resetToExample(),
          ),
        ];
      case 'linked': {
        const reopen = (): void => host.reopenLink(content.address, content.linked);
        const original =
          content.linked.exerciseToDo === undefined
            ? offerLine(texts.linked, texts.reopenLink, reopen)
            : offerLine(texts.exerciseWork, texts.restartExercise, reopen);
        return content.previous === undefined ? [original] : [original, restoreProgram(content.previous)];
      }
      case 'previous':
        return [restoreProgram(content.program)];
      case 'not-loaded':
        return [offerLine(texts.exampleNotLoaded, texts.tryAgain, content.retry)];
    }
  }
}

/** The source of an example, and the changes against it: loaded with the list of examples when they are first shown. */
function sourceDetails(id: string, language: Language): HTMLElement {
  const texts = PAGE_WORDS[language];
  const content = make('div');
  const details = make('details', { className: 'source' }, make('summary', {}, texts.source), content);
  const load = async (): Promise<void> => {
    try {
      const { loadSource } = await importWithRetry(() => import('./example-source'));
      content.replaceChildren(...(await loadSource(id, language)));
    } catch {
      content.replaceChildren(make('p', {}, texts.exampleNotLoaded));
      whenOnline(() => void load());
    }
  };
  details.addEventListener('toggle', () => void load(), { once: true });
  return details;
}

function offerLine(message: string, action: string, onAccept: () => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'link' }, action);
  button.addEventListener('click', onAccept);
  return make('p', { className: 'kept' }, `${message} · `, button);
}
