// The line under the header that says what a link has brought: a task with its solution, a program that is only shown, or
// that the link could not be read.
//
// In: what there is to say. Out: what the reader wants of it. Loaded only where there is something. Must not know: how
// a program is shown, or what an address looks like.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { linkOf, type Shared } from '../files/shared-link';
import type { InAddress } from './linked';
import { FAULTS, LINK_WORDS } from './share-words';
import './link-bar.css';

export type Fault = Extract<InAddress, { readonly kind: 'fault' }>['fault'];

export type InBar =
  | { readonly kind: 'fault'; readonly fault: Fault }
  | { readonly kind: 'task'; readonly linked: Shared }
  | { readonly kind: 'only-shown' };

export class LinkBar {
  readonly #said = make('p');
  readonly #buttons = make('div', { className: 'link-bar-actions' });
  readonly #solution = make('div', { id: 'solution', hidden: true });
  readonly #element = make('section', { id: 'link-bar', hidden: true }, this.#said, this.#buttons, this.#solution);
  readonly #everything: () => void;
  #shown: InBar | undefined;

  /** Stands before `place`; `everything`: all that the page has is wanted, and a program that can be changed. */
  constructor(place: HTMLElement, everything: () => void) {
    this.#everything = everything;
    place.before(this.#element);
  }

  show(shown: InBar | undefined, language: Language): void {
    this.#shown = shown;
    this.#element.hidden = shown === undefined;
    const texts = LINK_WORDS[language];
    // It comes with the page where it is no fault.
    if (shown?.kind === 'fault') this.#said.setAttribute('role', 'alert');
    else this.#said.removeAttribute('role');
    this.#element.setAttribute('aria-label', texts.bar);
    this.#element.dataset['kind'] = shown?.kind ?? '';
    const hide = (): HTMLElement => this.#button(texts.hide, () => this.show(undefined, language));
    switch (shown?.kind) {
      case 'fault':
        return this.#say(`${FAULTS[language](shown.fault)} ${texts.nothingLost}`, hide());
      case 'task': {
        const { linked } = shown;
        return this.#say(`${texts.task} ${linked.task?.sentence ?? ''}`.trim(), this.#solutionButton(linked, language), hide());
      }
      case 'only-shown':
        return this.#say(texts.onlyShown, this.#button(texts.everything, this.#everything));
      case undefined:
        return this.#say('');
    }
  }

  set language(language: Language) {
    this.show(this.#shown, language);
  }

  #say(text: string, ...buttons: readonly HTMLElement[]): void {
    this.#said.textContent = text;
    this.#buttons.replaceChildren(...buttons);
    this.#solution.hidden = true;
    this.#solution.replaceChildren();
  }

  /** The reader's own program stays where it is: a solution is a text under the task, and a link of its own. */
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
      this.#solution.append(make('pre', { tabIndex: 0, role: 'region', 'aria-label': texts.solution, dir: 'ltr' }, text), beside);
      void linkOf({ ...linked, text, task: null }).then((made) => {
        if (made.kind === 'link') beside.href = made.link;
      });
    });
    button.setAttribute('aria-expanded', 'false');
    button.setAttribute('aria-controls', this.#solution.id);
    return button;
  }

  #button(text: string, act: () => void): HTMLElement {
    const button = make('button', { type: 'button' }, text);
    button.addEventListener('click', act);
    return button;
  }
}
