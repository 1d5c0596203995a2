// The buttons that play and step, in the bar and in dialogs.
//
// In: the state of the playback and the chosen unit of a step. Out: elements, and clicks. Must not know: how the tool
// moves.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { StepDirection, StepUnit } from '../protocol/protocol';

/** The keys of a step forward; Shift reverses the direction. */
export const STEP_KEYS: Record<StepUnit, string> = { motion: 'F9', block: 'Ctrl F9', pass: 'Alt F9' };

/** The names of the steps. */
export const STEP_WORDS = words({
  en: {
    previous: { motion: 'Previous motion', block: 'Previous block', pass: 'Previous pass' },
    next: { motion: 'Next motion', block: 'Next block', pass: 'Next pass' },
  },
  zh: {
    previous: { motion: '上一段运动', block: '上一程序段', pass: '上一次走刀' },
    next: { motion: '下一段运动', block: '下一程序段', pass: '下一次走刀' },
  },
  ru: {
    previous: { motion: 'Предыдущее перемещение', block: 'Предыдущий кадр', pass: 'Предыдущий проход' },
    next: { motion: 'Следующее перемещение', block: 'Следующий кадр', pass: 'Следующий проход' },
  },
});

interface ButtonEvents {
  onPlay(): void;
  onStep(direction: StepDirection): void;
}

/** Play, and a step back and forward. */
class ButtonSet {
  readonly play = make('button', { type: 'button', className: 'primary play', part: 'play' });
  readonly previous = make('button', { type: 'button' }, icon('previous'));
  readonly next = make('button', { type: 'button' }, icon('next'));
  readonly #icon = make('span', { className: 'play-icon' });
  readonly #text = make('span', { className: 'play-text' });

  constructor({ onPlay, onStep }: ButtonEvents) {
    this.play.append(this.#icon, this.#text);
    this.play.addEventListener('click', onPlay);
    this.previous.addEventListener('click', () => onStep('previous'));
    this.next.addEventListener('click', () => onStep('next'));
  }

  get all(): readonly HTMLButtonElement[] {
    return [this.previous, this.play, this.next];
  }

  showPlay(text: string, shown: 'play' | 'pause'): void {
    this.#icon.replaceChildren(icon(shown));
    this.#text.textContent = text;
    this.play.title = `${text} (Ctrl Enter)`;
  }

  nameSteps(unit: StepUnit, language: Language): void {
    const texts = STEP_WORDS[language];
    setAccessibleName(this.previous, `${texts.previous[unit]} (Shift ${STEP_KEYS[unit]})`);
    setAccessibleName(this.next, `${texts.next[unit]} (${STEP_KEYS[unit]})`);
  }
}

/** All sets of buttons: the set of the bar first, then the sets of dialogs. */
export class PlaybackButtons {
  readonly #events: ButtonEvents;
  readonly #bar: ButtonSet;
  readonly #sets: ButtonSet[];

  constructor(events: ButtonEvents) {
    this.#events = events;
    this.#bar = new ButtonSet(events);
    this.#sets = [this.#bar];
  }

  /** The buttons of the bar. */
  get bar(): readonly HTMLButtonElement[] {
    return this.#bar.all;
  }

  /** Buttons for a dialog; name and show them next. */
  make(): HTMLElement {
    const buttons = new ButtonSet(this.#events);
    this.#sets.push(buttons);
    for (const button of buttons.all) button.disabled = this.disabled;
    return make('div', { className: 'playback-buttons' }, ...buttons.all);
  }

  get disabled(): boolean {
    return this.#bar.play.disabled;
  }

  set disabled(isDisabled: boolean) {
    for (const button of this.#sets.flatMap((buttons) => buttons.all)) button.disabled = isDisabled;
  }

  showPlay(text: string, shown: 'play' | 'pause'): void {
    for (const buttons of this.#sets) buttons.showPlay(text, shown);
  }

  nameSteps(unit: StepUnit, language: Language): void {
    for (const buttons of this.#sets) buttons.nameSteps(unit, language);
  }

  focusPlay(): void {
    this.#bar.play.focus({ preventScroll: true });
  }
}
