// The bar under the header that describes an opened link: a task with its solution and a button to hand in, the name on
// an answer, a read-only program, or an error in the link.
//
// In: what to show; the program to hand in. Out: clicks, and the link to hand in. Loaded only when needed. Must not
// know: how a program is shown, or the format of an address.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { linkOf, NAME_LIMIT, type MadeLink, type Shared } from '../files/shared-link';
import { copied, copiedOnceMade } from './fields';
import { pageAddress, type InAddress } from './linked';
import { FAULTS, LINK_WORDS, SHARE_WORDS } from './share-words';
import { sharedProgram } from './shared-program';
import type { KeptProgram } from './storage';
import './link-bar.css';

export type Fault = Extract<InAddress, { readonly kind: 'fault' }>['fault'];

export type InBar =
  | { readonly kind: 'fault'; readonly fault: Fault }
  | { readonly kind: 'task'; readonly linked: Shared }
  /** An answer to a task, with the name that it was handed in under. */
  | { readonly kind: 'from'; readonly from: string }
  | { readonly kind: 'only-shown'; readonly from: string | undefined };

/** What the page provides to the bar. */
interface BarHost {
  /** Switches to the full view with an editable program. */
  everything(): void;
  /** The current program. */
  program(): KeptProgram;
}

export class LinkBar {
  readonly #said = make('p');
  readonly #buttons = make('div', { className: 'link-bar-actions' });
  readonly #solution = make('div', { id: 'solution', hidden: true });
  /** Kept only while the page is open. */
  readonly #name = make('input', { type: 'text', id: 'hand-in-name', autocomplete: 'name', maxLength: NAME_LIMIT });
  readonly #nameCaption = make('span');
  readonly #copy = make('button', { type: 'button', id: 'hand-in' });
  readonly #news = make('span', { className: 'hand-in-news', role: 'status' });
  readonly #link = make('textarea', {
    id: 'hand-in-link',
    readOnly: true,
    rows: 2,
    spellcheck: false,
    dir: 'ltr',
    hidden: true,
  });
  readonly #handIn = make(
    'div',
    { className: 'hand-in', hidden: true },
    make('label', { htmlFor: this.#name.id }, this.#nameCaption, this.#name),
    this.#copy,
    this.#news,
    this.#link,
  );
  readonly #element = make(
    'section',
    { id: 'link-bar', hidden: true },
    this.#said,
    this.#handIn,
    this.#buttons,
    this.#solution,
  );
  readonly #host: BarHost;
  #shown: InBar | undefined;
  #language: Language = 'en';
  #made: { readonly of: string; readonly link: Promise<MadeLink> } | undefined;

  /** Inserts the bar before `place`. */
  constructor(place: HTMLElement, host: BarHost) {
    this.#host = host;
    place.before(this.#element);
    // Make the link early, so that it is usually ready at the click.
    for (const near of ['pointerenter', 'pointerdown', 'focus'])
      this.#copy.addEventListener(near, () => void this.#linkToHandIn());
    this.#copy.addEventListener('click', () => void this.#copied());
    this.#name.addEventListener('input', () => this.programChanged());
  }

  /** Removes the "copied" message once the text to hand in differs from the copied link. */
  programChanged(): void {
    if (this.#news.textContent === '') return;
    const shared = this.#toHandIn();
    if (shared === undefined || JSON.stringify(shared) !== this.#made?.of) this.#endNews();
  }

  #endNews(): void {
    this.#news.textContent = '';
    this.#link.hidden = true;
  }

  show(shown: InBar | undefined, language: Language): void {
    this.#shown = shown;
    this.#language = language;
    this.#element.hidden = shown === undefined;
    const texts = LINK_WORDS[language];
    // Only an error needs an alert; other bars appear with the page.
    if (shown?.kind === 'fault') this.#said.setAttribute('role', 'alert');
    else this.#said.removeAttribute('role');
    this.#element.setAttribute('aria-label', texts.bar);
    this.#element.dataset['kind'] = shown?.kind ?? '';
    this.#handIn.hidden = shown?.kind !== 'task';
    this.#nameCaption.textContent = texts.name;
    this.#copy.textContent = texts.handIn;
    this.#link.setAttribute('aria-label', texts.linkToHandIn);
    this.#endNews();
    const hide = (): HTMLElement => this.#button(texts.hide, () => this.show(undefined, language));
    switch (shown?.kind) {
      case 'fault':
        return this.#say(`${FAULTS[language](shown.fault)} ${texts.nothingLost}`, hide());
      case 'task': {
        const { linked } = shown;
        return this.#say(
          `${texts.task} ${linked.task?.sentence ?? ''}`.trim(),
          this.#solutionButton(linked, language),
          hide(),
        );
      }
      case 'only-shown':
        this.#say(
          texts.onlyShown,
          this.#button(texts.everything, () => this.#host.everything()),
        );
        if (shown.from !== undefined) this.#said.prepend(...this.#from(shown.from), '\n');
        return;
      case 'from':
        this.#say('', hide());
        return this.#said.replaceChildren(...this.#from(shown.from));
      case undefined:
        return this.#say('');
    }
  }

  set language(language: Language) {
    this.show(this.#shown, language);
  }

  /** A name may contain any text; `bdi` isolates its direction. */
  #from(name: string): readonly (Node | string)[] {
    return [`${LINK_WORDS[this.#language].from} `, make('bdi', {}, name)];
  }

  #say(text: string, ...buttons: readonly HTMLElement[]): void {
    this.#said.textContent = text;
    this.#buttons.replaceChildren(...buttons);
    this.#solution.hidden = true;
    this.#solution.replaceChildren();
  }

  /** Shows the solution as text under the task, with a separate link, so that the user's program stays in place. */
  #solutionButton(linked: Shared, language: Language): HTMLElement {
    const texts = LINK_WORDS[language];
    const button = this.#button(texts.showSolution, () => {
      const shows = this.#solution.hidden;
      this.#solution.hidden = !shows;
      button.setAttribute('aria-expanded', String(shows));
      button.textContent = shows ? texts.hideSolution : texts.showSolution;
      if (!shows || this.#solution.childElementCount > 0) return;
      const text = linked.task?.solution ?? '';
      const beside = make('a', { target: '_blank', rel: 'noopener' }, texts.openSolution);
      this.#solution.append(
        make('pre', { tabIndex: 0, role: 'region', 'aria-label': texts.solution, dir: 'ltr' }, text),
        beside,
      );
      void linkOf({ ...linked, text, task: null, name: null }).then((made) => {
        if (made.kind === 'link') beside.href = made.link;
      });
    });
    button.setAttribute('aria-expanded', 'false');
    button.setAttribute('aria-controls', this.#solution.id);
    return button;
  }

  // ---- handing in ------------------------------------------------------------------------------------

  /** The user's program with the setup of the task, without the task itself and without a language. */
  #toHandIn(): Shared | undefined {
    if (this.#shown?.kind !== 'task') return undefined;
    const { setup, control, blockSkip, program } = this.#shown.linked;
    const name = this.#name.value.trim();
    return {
      ...sharedProgram(this.#host.program()),
      setup,
      control,
      blockSkip,
      program,
      name: name === '' ? null : name,
    };
  }

  async #linkToHandIn(): Promise<MadeLink | undefined> {
    const shared = this.#toHandIn();
    if (shared === undefined) return undefined;
    const of = JSON.stringify(shared);
    if (this.#made?.of !== of) this.#made = { of, link: linkOf(shared) };
    return this.#made.link.catch(() => undefined);
  }

  async #copied(): Promise<void> {
    const [texts, share] = [LINK_WORDS[this.#language], SHARE_WORDS[this.#language]];
    this.#endNews();
    const making = this.#linkToHandIn();
    const isCopiedAlready = copiedOnceMade(
      making.then((made) => (made?.kind === 'link' ? addressOf(made) : undefined)),
    );
    const made = await making;
    if (made?.kind !== 'link') {
      this.#made = undefined;
      this.#news.textContent = made === undefined ? texts.notMade : share.tooLong(made.length, made.limit);
      return;
    }
    this.#link.value = addressOf(made);
    const isCopied =
      (await isCopiedAlready) ||
      (await copied(this.#link, () => {
        this.#link.hidden = false;
        this.#link.focus();
      })) === 'copied';
    if (!isCopied) {
      this.#news.textContent = texts.copyByHand;
      return;
    }
    if (!this.#link.hidden) this.#copy.focus();
    this.#link.hidden = true;
    this.#news.textContent = share.copied;
  }

  #button(text: string, act: () => void): HTMLElement {
    const button = make('button', { type: 'button' }, text);
    button.addEventListener('click', act);
    return button;
  }
}

function addressOf({ link }: { readonly link: string }): string {
  return `${pageAddress()}${link}`;
}
