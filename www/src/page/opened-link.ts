// The link that was opened last: its program and address, and what it says beside the program.
//
// In: a link that was unpacked, or what is wrong with one. Out: view, step and read-only as attributes of the element; the bar that
// says so, loaded with the first link that has more to say than its program. Must not know: what becomes of the program.

import type { Language } from '../dom/language';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import type { Fault, InBar, LinkBar } from './link-bar';
import type { LinkedProgram } from './linked';

/** What the page lends to a link. */
interface LinkHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
}

export class OpenedLink {
  readonly #host: LinkHost;
  /** Its program, and the address that holds it; stays when the program has gone. */
  #last: { readonly address: string; readonly linked: LinkedProgram } | undefined;
  #bar: LinkBar | undefined;
  #inBar: InBar | undefined;

  constructor(host: LinkHost) {
    this.#host = host;
  }

  get last(): { readonly address: string; readonly linked: LinkedProgram } | undefined {
    return this.#last;
  }

  /** The link whose program the address still holds. */
  get inAddress(): { readonly address: string; readonly linked: LinkedProgram } | undefined {
    return this.#last?.address === location.hash ? this.#last : undefined;
  }

  /** Its program is there. */
  opened(linked: LinkedProgram): void {
    this.#last = { address: location.hash, linked };
    const { playground } = this.#host;
    const { readonly } = linked;
    playground.setAttribute('view', linked.view ?? 'all');
    playground.readonly = readonly;
    playground.step = linked.step;
    if (linked.task !== null) this.#say({ kind: 'task', linked });
    else if (readonly || playground.view !== 'all') this.#say({ kind: 'only-shown' });
  }

  /** What a link has said beside its program does not reach the next one. */
  end(): void {
    const { playground } = this.#host;
    playground.step = null;
    playground.view = 'all';
    playground.readonly = false;
    this.#say(undefined);
  }

  showFault(fault: Fault): void {
    this.#say({ kind: 'fault', fault });
  }

  showLanguage(): void {
    if (this.#bar !== undefined) this.#bar.language = this.#host.language;
  }

  #say(what: InBar | undefined): void {
    this.#inBar = what;
    if (this.#bar !== undefined) return this.#bar.show(what, this.#host.language);
    if (what === undefined) return;
    void import('./link-bar').then(({ LinkBar }) => {
      this.#bar ??= new LinkBar(find('main'), () => this.end());
      this.#bar.show(this.#inBar, this.#host.language);
    }, () => undefined);
  }
}
