// The link that was opened last: its program, its address and its options.
//
// In: an unpacked link, or an error. Out: view, step and read-only mode of the element; the bar that describes the
// link; the name on an answer in the title of the tab. The bar is loaded with the first link that contains more than
// its program. Must not know: what happens to the program.

import { make } from '../dom/dom';
import { importWithRetry } from '../dom/network';
import type { OtherProgram } from './compare-own';
import type { CheckedExercise } from './exercise-progress';
import { find } from './find';
import type { Fault, BarContent, LinkBar } from './link-bar';
import { cleanName, exerciseAddress, ownExercise, type LinkedProgram } from './linked';
import type { PageHost } from './page-host';
import { PAGE_WORDS } from './words';

export class OpenedLink {
  readonly #host: PageHost;
  /** The program of the link and its address; kept after another program has replaced it. */
  #last: { readonly address: string; readonly linked: LinkedProgram } | undefined;
  #bar: LinkBar | undefined;
  #barContent: BarContent | undefined;
  /** In the exercise: offers to hand in an answer that has not passed. */
  readonly #handIn = make('button', { type: 'button', className: 'framed', slot: 'exercise' });
  #onHandIn: (() => void) | undefined;
  /** Whether the answer of the link has been checked. */
  #isChecked = false;

  constructor(host: PageHost) {
    this.#host = host;
    const { playground } = host;
    this.#handIn.addEventListener('click', () => this.#onHandIn?.());
    playground.addEventListener('gcode-change', () => this.#bar?.programChanged());
    // Remove the name when another program replaces the answer, by opening a file or by undo.
    playground.addEventListener('gcode-context', () => {
      if (this.#isAnswer && host.program.text !== this.#last?.linked.text) this.#showBar(undefined);
    });
  }

  get last(): { readonly address: string; readonly linked: LinkedProgram } | undefined {
    return this.#last;
  }

  /** The last link, if the address still contains it. */
  get current(): { readonly address: string; readonly linked: LinkedProgram } | undefined {
    return this.#last?.address === location.hash ? this.#last : undefined;
  }

  /** Applies the options of a link after its program was loaded. */
  opened(linked: LinkedProgram): void {
    this.#last = { address: location.hash, linked };
    this.#isChecked = false;
    this.#handIn.remove();
    const { playground } = this.#host;
    const { readonly } = linked;
    playground.setAttribute('view', linked.view ?? 'all');
    playground.readonly = readonly;
    playground.step = linked.step;
    const answered = linked.exercise === null ? null : exerciseAddress(linked.exercise.id);
    playground.exercise = linked.exerciseToDo ?? linked.exerciseText ?? answered;
    const from = cleanName(linked.name);
    if (linked.task !== null) this.#showBar({ kind: 'task', linked });
    else if (readonly || playground.view !== 'all') this.#showBar({ kind: 'only-shown', from });
    else this.#showAnswer(from);
  }

  /** The element shows the task of the exercise. An answer that was handed in is shown with the report on it. */
  exerciseShown(): void {
    const { playground } = this.#host;
    if (this.#isChecked || playground.view !== 'all' || (this.current?.linked.exercise ?? null) === null) return;
    this.#isChecked = true;
    playground.checkExercise();
  }

  /**
   * Takes the program that an exercise begins with as the text of its link. Returns whether the current program is that
   * text.
   */
  begins(text: string): boolean {
    const last = this.#last;
    if (last?.linked.exerciseToDo === undefined || this.#host.playground.value !== text) return false;
    this.#last = { ...last, linked: { ...last.linked, text } };
    return true;
  }

  /** Offers to hand in the answer to the exercise of the link after a check. */
  checked({ id, version, hints, passed }: CheckedExercise): void {
    const linked = this.current?.linked;
    if (linked?.exerciseToDo === undefined) return;
    const exercise = { id, version, hints };
    const exerciseText = ownExercise(linked);
    const content = { kind: 'exercise', exercise, exerciseText, passed, isWanted: false } as const;
    this.#onHandIn = () => this.#showBar({ ...content, isWanted: true });
    if (passed) this.#handIn.remove();
    if (passed || this.#barContent?.kind === 'exercise') this.#showBar(content);
    else {
      // The report needs the room of the bar.
      this.#handIn.textContent = PAGE_WORDS[this.#host.language].handIn;
      this.#host.playground.append(this.#handIn);
    }
  }

  /** Resets the options, so that they do not affect the next link. */
  end(): void {
    const { playground } = this.#host;
    this.#handIn.remove();
    playground.step = null;
    playground.exercise = null;
    playground.view = 'all';
    playground.readonly = false;
    this.#showBar(undefined);
  }

  showFault(fault: Fault): void {
    this.#showBar({ kind: 'fault', fault });
  }

  showLanguage(): void {
    if (this.#bar !== undefined) this.#bar.language = this.#host.language;
    this.#handIn.textContent = PAGE_WORDS[this.#host.language].handIn;
    this.#showTitle();
  }

  /** The name on the answer that is shown. */
  get #from(): string | undefined {
    const content = this.#barContent;
    return content?.kind === 'answer' || content?.kind === 'only-shown' ? content.from : undefined;
  }

  get #isAnswer(): boolean {
    return this.#barContent?.kind === 'answer' || this.#from !== undefined;
  }

  /** Puts the name into the title, so that a teacher finds the tabs with the answers of a class. */
  #showTitle(): void {
    const { title } = PAGE_WORDS[this.#host.language];
    document.title = this.#from === undefined ? title : `${this.#from} · ${title}`;
  }

  /** Switches to the full view; the name on the answer stays. */
  #showAll(): void {
    const from = this.#from;
    this.end();
    this.#showAnswer(from);
  }

  /** Shows the name and the task of an answer; a link that has neither has no bar. */
  #showAnswer(from: string | undefined): void {
    const linked = this.#last?.linked;
    const hasBar = linked !== undefined && (from !== undefined || linked.answerTo !== null);
    this.#showBar(hasBar ? { kind: 'answer', from, linked } : undefined);
  }

  async #compareWith(other: OtherProgram): Promise<void> {
    const { compareWith } = await importWithRetry(() => import('./compare-dialog'));
    compareWith(this.#host, other);
  }

  #showBar(content: BarContent | undefined): void {
    this.#barContent = content;
    this.#showTitle();
    if (this.#bar !== undefined) return this.#bar.show(content, this.#host.language);
    if (content === undefined) return;
    void importWithRetry(() => import('./link-bar')).then(
      ({ LinkBar }) => {
        this.#bar ??= new LinkBar(find('main'), {
          showAll: () => this.#showAll(),
          program: () => this.#host.program,
          compareWith: (other) => void this.#compareWith(other),
          onHidden: () => {
            if (this.#barContent?.kind === 'exercise') this.#barContent = undefined;
          },
        });
        this.#bar.show(this.#barContent, this.#host.language);
      },
      () => undefined,
    );
  }
}
