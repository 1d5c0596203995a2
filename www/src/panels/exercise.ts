// The exercise over the program: its task, hints, and the report on the answer.
//
// In: the attribute `exercise`, the address of an exercise file. Out: the program that the learner starts with, and the
// blank, tools and machine of the exercise. Must not know: how an answer is checked.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import type { CoreEvent } from '../worker/core-client';
import type { ExerciseView } from './exercise-view';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Services, Shell } from './panel';

export const exercise: PanelKind = { make: (shell) => new ExercisePanel(shell) };

class ExercisePanel implements Panel {
  readonly #shell: Shell;
  readonly #place = make('div', { className: 'exercise', part: 'exercise', hidden: true });
  readonly #address: string | undefined;
  #isRequested = false;
  #view: ExerciseView | undefined;
  readonly elements = { bar: [this.#place] };
  readonly services: Partial<Services> = {
    exerciseSheet: () => this.#view?.sheet ?? [],
    answerAt: (place) => this.#view?.answerAt(place) ?? false,
    checkExercise: () => void this.#view?.check(),
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#address = shell.exercise;
  }

  set language(_: Language) {
    void this.#view?.reload();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report' || this.#address === undefined || this.#isRequested) return;
    this.#isRequested = true;
    void this.#open(this.#address);
  }

  onInputChanged(): void {
    this.#view?.programChanged();
  }

  async #open(address: string): Promise<void> {
    const part = await loadPart(
      this.#shell,
      () => import('./exercise-view'),
      () => void this.#open(address),
    );
    if (part === undefined) return;
    this.#shell.addStyles(part.exerciseStyles);
    this.#view = new part.ExerciseView(this.#shell, address);
    this.#place.append(this.#view.element);
    this.#place.hidden = false;
    await this.#view.start();
  }
}
