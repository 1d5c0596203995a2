// The bar over the element that describes an opened link: a task or an exercise with a button to hand in, the name and
// task of an answer, a read-only program, or an error in the link.
//
// In: what to show; the program to hand in. Out: clicks, and the link to hand in. Loaded only when needed. Must not
// know: how a program is shown, or the format of an address.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import {
  makeLink,
  NAME_LIMIT,
  type AnsweredExercise,
  type MadeLink,
  type Shared,
  type Task,
} from '../files/shared-link';
import { loadExercises, titleOf } from './exercise-list';
import { copyField, copyWhenReady } from './fields';
import { pageAddress, type AddressContent } from './linked';
import { FAULTS, LINK_WORDS, SHARE_WORDS } from './share-words';
import { toShared } from './shared-program';
import type { SavedProgram } from './storage';
import './link-bar.css';

export type Fault = Extract<AddressContent, { readonly kind: 'fault' }>['fault'];

export type BarContent =
  | { readonly kind: 'fault'; readonly fault: Fault }
  | { readonly kind: 'task'; readonly linked: Shared }
  /** The reader has passed an exercise, or wants to hand in another answer. */
  | {
      readonly kind: 'exercise';
      readonly exercise: AnsweredExercise;
      /** The text of an exercise that is not one of the site. */
      readonly exerciseText: string | null;
      readonly passed: boolean;
      /** The reader has asked for the bar. */
      readonly isWanted: boolean;
    }
  /** An answer, with the name that it was handed in under; an older link does not contain the task. */
  | { readonly kind: 'answer'; readonly from: string | undefined; readonly linked: Shared }
  | { readonly kind: 'only-shown'; readonly from: string | undefined };

type ExerciseContent = Extract<BarContent, { readonly kind: 'exercise' }>;

/** What the page provides to the bar. */
interface BarHost {
  /** Switches to the full view with an editable program. */
  showAll(): void;
  /** The current program. */
  program(): SavedProgram;
  compareWith(other: { readonly name: string; readonly text: string }): void;
  /** The reader has hidden the bar. */
  onHidden(): void;
}

export class LinkBar {
  readonly #text = make('p');
  readonly #buttons = make('div', { className: 'link-bar-actions' });
  /** Over the picture, so that program and picture keep their size. */
  readonly #solution = make('div', { id: 'solution', hidden: true });
  /** Kept only while the page is open. */
  readonly #name = make('input', { type: 'text', id: 'hand-in-name', autocomplete: 'name', maxLength: NAME_LIMIT });
  readonly #nameCaption = make('span');
  readonly #copy = make('button', { type: 'button', className: 'primary', id: 'hand-in' });
  readonly #message = make('span', { className: 'hand-in-news', role: 'status' });
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
    this.#message,
    this.#link,
  );
  readonly #element = make('section', { id: 'link-bar', hidden: true }, this.#text, this.#handIn, this.#buttons);
  readonly #host: BarHost;
  #content: BarContent | undefined;
  #language: Language = 'en';
  #cachedLink: { readonly of: string; readonly link: Promise<MadeLink> } | undefined;

  /** Inserts the bar before `place`. */
  constructor(place: HTMLElement, host: BarHost) {
    this.#host = host;
    place.before(this.#element, this.#solution);
    // Make the link early, so that it is usually ready at the click.
    for (const eventName of ['pointerenter', 'pointerdown', 'focus'])
      this.#copy.addEventListener(eventName, () => void this.#makeAnswerLink());
    this.#copy.addEventListener('click', () => void this.#copyLink());
    this.#name.addEventListener('input', () => this.programChanged());
  }

  /** Removes the "copied" message once the text to hand in differs from the copied link. */
  programChanged(): void {
    if (this.#message.textContent === '') return;
    const shared = this.#sharedAnswer();
    if (shared === undefined || JSON.stringify(shared) !== this.#cachedLink?.of) this.#clearNews();
  }

  #clearNews(): void {
    this.#message.textContent = '';
    this.#link.hidden = true;
  }

  show(content: BarContent | undefined, language: Language): void {
    this.#content = content;
    this.#language = language;
    this.#element.hidden = content === undefined;
    const texts = LINK_WORDS[language];
    // Only an error needs an alert; other bars appear with the page.
    if (content?.kind === 'fault') this.#text.setAttribute('role', 'alert');
    else this.#text.removeAttribute('role');
    this.#element.setAttribute('aria-label', texts.bar);
    this.#element.dataset['kind'] = content?.kind ?? '';
    this.#handIn.hidden = content?.kind !== 'task' && content?.kind !== 'exercise';
    this.#nameCaption.textContent = texts.name;
    this.#copy.textContent = texts.handIn;
    this.#link.setAttribute('aria-label', texts.linkToHandIn);
    this.#clearNews();
    const hide = (): HTMLElement =>
      this.#createButton(texts.hide, () => {
        this.show(undefined, language);
        this.#host.onHidden();
      });
    switch (content?.kind) {
      case 'fault':
        return this.#showText(`${FAULTS[language](content.fault)} ${texts.nothingLost}`, hide());
      case 'task': {
        const { linked } = content;
        return this.#showText(taskText(linked.task, language), ...this.#solutionButtons(linked, linked.task), hide());
      }
      case 'exercise':
        this.#showText(texts.handInExercise, hide());
        if (content.passed) void this.#offerNext(content);
        if (content.isWanted) this.#name.focus();
        return;
      case 'only-shown':
        this.#showText(
          texts.onlyShown,
          this.#createButton(texts.everything, () => this.#host.showAll()),
        );
        if (content.from !== undefined) this.#text.prepend(...this.#fromLine(content.from), '\n');
        return;
      case 'answer': {
        const { from, linked } = content;
        const { answerTo } = linked;
        const lines = [
          ...(from === undefined ? [] : this.#fromLine(from)),
          ...(from === undefined || answerTo === null ? [] : ['\n']),
          ...(answerTo === null ? [] : [taskText(answerTo, language)]),
        ];
        this.#showText('', ...this.#solutionButtons(linked, answerTo), hide());
        return this.#text.replaceChildren(...lines);
      }
      case undefined:
        return this.#showText('');
    }
  }

  /** A link to the exercise of the site that follows. */
  async #offerNext(content: ExerciseContent): Promise<void> {
    const list = content.exerciseText === null ? ((await loadExercises()) ?? []) : [];
    const at = list.findIndex(({ id }) => id === content.exercise.id);
    const next = at < 0 ? undefined : list[at + 1];
    if (next === undefined || this.#content !== content) return;
    const text = LINK_WORDS[this.#language].nextExercise(titleOf(next, this.#language));
    this.#buttons.prepend(make('a', { className: 'framed', href: `#exercise=${next.id}` }, text));
  }

  set language(language: Language) {
    this.show(this.#content, language);
  }

  /** A name may contain any text; `bdi` isolates its direction. */
  #fromLine(name: string): readonly (Node | string)[] {
    return [`${LINK_WORDS[this.#language].from} `, make('bdi', {}, name)];
  }

  #showText(text: string, ...buttons: readonly HTMLElement[]): void {
    this.#text.textContent = text;
    this.#buttons.replaceChildren(...buttons);
    this.#solution.hidden = true;
    this.#solution.replaceChildren();
  }

  /** None if the link does not contain a solution. A teacher can also compare the part of an answer with the wanted one. */
  #solutionButtons(linked: Shared, task: Task | null): readonly HTMLElement[] {
    const solution = task?.solution ?? null;
    if (solution === null) return [];
    const show = this.#createSolutionButton(linked, solution);
    if (linked.answerTo === null) return [show];
    const { solution: name, compareWithSolution: compare } = LINK_WORDS[this.#language];
    return [this.#createButton(compare, () => this.#host.compareWith({ name, text: solution })), show];
  }

  /** Shows the solution as text beside the user's program, with a separate link, so that the program stays in place. */
  #createSolutionButton(linked: Shared, text: string): HTMLElement {
    const texts = LINK_WORDS[this.#language];
    const button = this.#createButton(texts.showSolution, () => {
      const isShown = this.#solution.hidden;
      this.#solution.hidden = !isShown;
      button.setAttribute('aria-expanded', String(isShown));
      button.textContent = isShown ? texts.hideSolution : texts.showSolution;
      if (!isShown || this.#solution.childElementCount > 0) return;
      const solutionLink = make('a', { target: '_blank', rel: 'noopener' }, texts.openSolution);
      const program = make('pre', { tabIndex: 0, dir: 'ltr' }, text);
      this.#solution.append(make('div', { role: 'region', 'aria-label': texts.solution }, program, solutionLink));
      void makeLink({ ...linked, text, task: null, answerTo: null, name: null }).then((made) => {
        if (made.kind === 'link') solutionLink.href = made.link;
      });
    });
    button.setAttribute('aria-expanded', 'false');
    button.setAttribute('aria-controls', this.#solution.id);
    return button;
  }

  // ---- handing in ------------------------------------------------------------------------------------

  /** The user's program with the task and its setup, without a language. */
  #sharedAnswer(): Shared | undefined {
    const content = this.#content;
    const entered = this.#name.value.trim();
    const name = entered === '' ? null : entered;
    if (content?.kind === 'exercise') {
      const { exercise, exerciseText } = content;
      return { ...toShared(this.#host.program()), exercise, exerciseText, name };
    }
    if (content?.kind !== 'task') return undefined;
    const { setup, control, blockSkip, program, task } = content.linked;
    return {
      ...toShared(this.#host.program()),
      setup,
      control,
      blockSkip,
      program,
      answerTo: task,
      name,
    };
  }

  async #makeAnswerLink(): Promise<MadeLink | undefined> {
    const shared = this.#sharedAnswer();
    if (shared === undefined) return undefined;
    const of = JSON.stringify(shared);
    if (this.#cachedLink?.of !== of) this.#cachedLink = { of, link: makeLink(shared) };
    return this.#cachedLink.link.catch(() => undefined);
  }

  async #copyLink(): Promise<void> {
    const [texts, share] = [LINK_WORDS[this.#language], SHARE_WORDS[this.#language]];
    this.#clearNews();
    const making = this.#makeAnswerLink();
    const isCopiedAlready = copyWhenReady(making.then((made) => (made?.kind === 'link' ? addressOf(made) : undefined)));
    const made = await making;
    if (made?.kind !== 'link') {
      this.#cachedLink = undefined;
      this.#message.textContent = made === undefined ? texts.notMade : share.tooLong(made.length, made.limit);
      return;
    }
    this.#link.value = addressOf(made);
    const isCopied =
      (await isCopiedAlready) ||
      (await copyField(this.#link, () => {
        this.#link.hidden = false;
        this.#link.focus();
      })) === 'copied';
    if (!isCopied) {
      this.#message.textContent = texts.copyByHand;
      return;
    }
    if (!this.#link.hidden) this.#copy.focus();
    this.#link.hidden = true;
    this.#message.textContent = share.copied;
  }

  #createButton(text: string, onClick: () => void): HTMLElement {
    const button = make('button', { type: 'button', className: 'framed' }, text);
    button.addEventListener('click', onClick);
    return button;
  }
}

function taskText(task: Task | null, language: Language): string {
  return `${LINK_WORDS[language].task} ${task?.sentence ?? ''}`.trim();
}

function addressOf({ link }: { readonly link: string }): string {
  return `${pageAddress()}${link}`;
}
