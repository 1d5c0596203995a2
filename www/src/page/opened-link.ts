// The link that was opened last: its program and address, and what it says beside the program.
//
// In: a link that was unpacked, or what is wrong with one. Out: view, step and read-only as attributes of the element; the bar that
// says so, and the title of the tab with the name of whose answer it is; the bar is loaded with the first link that has more to say than its program. Must not know: what becomes of the program.

import type { Language } from '../dom/language';
import { loaded } from '../dom/network';
import type { GcodePlayground } from '../shell/element';
import { find } from './find';
import type { Fault, InBar, LinkBar } from './link-bar';
import type { LinkedProgram } from './linked';
import type { KeptProgram } from './storage';
import { PAGE_WORDS } from './words';

/** What the page lends to a link. */
interface LinkHost {
  readonly playground: GcodePlayground;
  readonly language: Language;
  /** The program as it is now, with its context. */
  readonly program: KeptProgram;
}

export class OpenedLink {
  readonly #host: LinkHost;
  /** Its program, and the address that holds it; stays when the program has gone. */
  #last: { readonly address: string; readonly linked: LinkedProgram } | undefined;
  #bar: LinkBar | undefined;
  #inBar: InBar | undefined;

  constructor(host: LinkHost) {
    this.#host = host;
    const { playground } = host;
    playground.addEventListener('gcode-change', () => this.#bar?.programChanged());
    // A name is said of no other program: not of a file that is opened, and not of what undo brings back.
    playground.addEventListener('gcode-context', () => {
      if (this.#from !== undefined && host.program.text !== this.#last?.linked.text) this.#say(undefined);
    });
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
    const from = shownName(linked.name);
    if (linked.task !== null) this.#say({ kind: 'task', linked });
    else if (readonly || playground.view !== 'all') this.#say({ kind: 'only-shown', from });
    else this.#say(from === undefined ? undefined : { kind: 'from', from });
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
    this.#showTitle();
  }

  /** Whose answer is shown. */
  get #from(): string | undefined {
    const said = this.#inBar;
    return said?.kind === 'from' || said?.kind === 'only-shown' ? said.from : undefined;
  }

  /** Tabs with the answers of a class are found by their names. */
  #showTitle(): void {
    const { title } = PAGE_WORDS[this.#host.language];
    document.title = this.#from === undefined ? title : `${this.#from} · ${title}`;
  }

  /** All that the page has; whose answer it is stays. */
  #everything(): void {
    const from = this.#from;
    this.end();
    if (from !== undefined) this.#say({ kind: 'from', from });
  }

  #say(what: InBar | undefined): void {
    this.#inBar = what;
    this.#showTitle();
    if (this.#bar !== undefined) return this.#bar.show(what, this.#host.language);
    if (what === undefined) return;
    void loaded(() => import('./link-bar')).then(
      ({ LinkBar }) => {
        this.#bar ??= new LinkBar(find('main'), {
          everything: () => this.#everything(),
          program: () => this.#host.program,
        });
        this.#bar.show(this.#inBar, this.#host.language);
      },
      () => undefined,
    );
  }
}

/** One line, without signs that turn the text beside it around; nothing where no letter is left. */
function shownName(name: string | null): string | undefined {
  const line = (name ?? '')
    .replace(/[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, '')
    .replace(/[\s\p{Cc}]+/gu, ' ')
    .trim();
  return line === '' ? undefined : line;
}
