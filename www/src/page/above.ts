// The lines above the program: what its example shows, what has become of the program before, and what could not be loaded.
//
// In: which of these there is to say. Out: the lines, and a press on what they offer. Must not know: how a program is loaded or kept.

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
  /** The network is missing; what is tried again when it is there. */
  | { readonly kind: 'not-loaded'; readonly again: () => void }
  | { readonly kind: 'kept'; readonly program: OwnProgram }
  /** The reader has changed the program that the address held. */
  | { readonly kind: 'linked'; readonly address: string; readonly linked: LinkedProgram; readonly kept?: OwnProgram };

/** What the page lends to the lines above the program. */
interface AboveHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  readonly example: Example | undefined;
  /** Counts what was asked to be shown. */
  readonly asked: number;
  /** The example as it came, in place of what the reader has made of it; the first one where it was none. */
  startAfresh(): void;
  /** The program of a link as it came. */
  openAgain(address: string, linked: LinkedProgram): void;
  bringBack(program: OwnProgram): void;
}

export class AboveProgram {
  readonly #host: AboveHost;
  readonly #element = find('intro');
  #now: Above = { kind: 'example' };
  /** What the lines were made of. */
  #shown: readonly unknown[] = [];

  constructor(host: AboveHost) {
    this.#host = host;
    host.playground.append(this.#element);
    // Where there is little room it scrolls, by keys as well.
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
    // This follows each key, and all of the page would be laid out again.
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

  /** A program that gave way can be brought back, whatever else there is to say. */
  offer(program: OwnProgram): void {
    this.show(this.#now.kind === 'linked' ? { ...this.#now, kept: program } : { kind: 'kept', program });
  }

  /** After a change of the language, of the program, or of its length. */
  showAgain(): void {
    this.show(this.#now);
  }

  /** Once the network is back it is tried again, unless the reader has gone on to something else. */
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
