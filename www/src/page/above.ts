// The lines above the program: a description of the example, an offer to restore the previous program, or a loading
// error.
//
// In: which of these to show. Out: the lines, and clicks on their buttons. Must not know: how a program is loaded or
// saved.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { whenOnline } from '../dom/network';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import type { Example } from './gallery';
import type { LinkedProgram } from './linked';
import { LONGEST_KEPT, type OwnProgram } from './storage';
import { PAGE_WORDS } from './words';

export type Above =
  | { readonly kind: 'example' | 'restored' }
  /** The network failed; `again` retries once it is back. */
  | { readonly kind: 'not-loaded'; readonly again: () => void }
  | { readonly kind: 'kept'; readonly program: OwnProgram }
  /** The user has edited the program of the link in the address. */
  | { readonly kind: 'linked'; readonly address: string; readonly linked: LinkedProgram; readonly kept?: OwnProgram };

/** What the page provides to the lines above the program. */
interface AboveHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  readonly example: Example | undefined;
  /** The number of requests to show a program. */
  readonly asked: number;
  /** Saves the current program and shows the original example; the first example if the program is not one. */
  startAfresh(): void;
  /** Saves the current program and shows the original program of a link. */
  openAgain(address: string, linked: LinkedProgram): void;
  bringBack(program: OwnProgram): void;
}

export class AboveProgram {
  readonly #host: AboveHost;
  readonly #element = find('intro');
  #now: Above = { kind: 'example' };
  /** The values from which the current lines were rendered. */
  #shown: readonly unknown[] = [];

  constructor(host: AboveHost) {
    this.#host = host;
    host.playground.append(this.#element);
    // When there is little room the element scrolls; make it scrollable by keyboard too.
    new ResizeObserver(() => {
      if (this.#element.scrollHeight > this.#element.clientHeight) this.#element.tabIndex = 0;
      else this.#element.removeAttribute('tabindex');
    }).observe(this.#element);
  }

  get now(): Above {
    return this.#now;
  }

  show(what: Above): void {
    this.#now = what;
    const { playground, language, example } = this.#host;
    const isFile = playground.file !== undefined;
    const isTooLong = playground.length > LONGEST_KEPT;
    // This runs after each key press; skip the re-render if nothing changed, because it would lay out the whole page.
    const shown = [what, language, example, isFile, isTooLong];
    if (shown.every((one, i) => one === this.#shown[i])) return;
    this.#shown = shown;
    const texts = PAGE_WORDS[language];
    const lines: HTMLElement[] = [];
    if (example !== undefined && !isFile) {
      lines.push(make('h2', {}, example.title[language]), make('p', {}, example.shows[language]));
      if (example.added !== undefined) lines.push(make('p', { className: 'added' }, texts.added(example.added)));
    }
    if (isTooLong) lines.push(make('p', { className: 'kept' }, texts.tooLongToKeep));
    lines.push(...this.#offers(what));
    this.#element.replaceChildren(...lines);
    this.#element.hidden = lines.length === 0;
  }

  /** Offers to restore a replaced program, in addition to the current lines. */
  offer(program: OwnProgram): void {
    this.show(this.#now.kind === 'linked' ? { ...this.#now, kept: program } : { kind: 'kept', program });
  }

  /** Call after a change of the language, the program or its length. */
  showAgain(): void {
    this.show(this.#now);
  }

  /** Retries once the network is back, unless the user has opened something else meanwhile. */
  showNotLoaded(again: () => void): void {
    const said: Above = { kind: 'not-loaded', again };
    const { playground, asked } = this.#host;
    const { value } = playground;
    this.show(said);
    whenOnline(() => {
      if (this.#now === said && this.#host.asked === asked && playground.value === value) again();
    });
  }

  #offers(what: Above): HTMLElement[] {
    const host = this.#host;
    const texts = PAGE_WORDS[host.language];
    const bringBack = (program: OwnProgram): HTMLElement =>
      offer(texts.kept, texts.bringBack, () => host.bringBack(program));
    switch (what.kind) {
      case 'example':
        return [];
      case 'restored':
        return [
          offer(texts.restored, host.example === undefined ? texts.firstExample : texts.startAfresh, () =>
            host.startAfresh(),
          ),
        ];
      case 'linked': {
        const asItCame = offer(texts.linked, texts.asLinked, () => host.openAgain(what.address, what.linked));
        return what.kept === undefined ? [asItCame] : [asItCame, bringBack(what.kept)];
      }
      case 'kept':
        return [bringBack(what.program)];
      case 'not-loaded':
        return [offer(texts.exampleNotLoaded, texts.tryAgain, what.again)];
    }
  }
}

function offer(news: string, action: string, accepted: () => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'link' }, action);
  button.addEventListener('click', accepted);
  return make('p', { className: 'kept' }, `${news} · `, button);
}
