// The choice of the playback speed: a multiple of the machine's speed, or the duration of the whole program.
//
// In: the attribute `speed` of the element. Out: the speed, and the new attribute when the user chooses another one. Must
// not know: how the tool moves.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Pace } from '../protocol/protocol';
import type { Shell } from './panel';

/** The first is the default. */
const PACES: readonly Pace[] = [
  { kind: 'whole', seconds: 20 },
  { kind: 'whole', seconds: 60 },
  ...[0.5, 1, 2, 5, 10, 50].map((factor) => ({ kind: 'times', factor }) as const),
];
const DEFAULT_PACE: Pace = { kind: 'whole', seconds: 20 };

export class SpeedChoice {
  readonly element = make('select', { className: 'speed' });
  readonly caption = make('span');
  readonly #shell: Shell;
  readonly #onShown: () => void;
  /** The speeds of the options. */
  readonly #paces: Pace[] = [];
  #language: Language;

  /** `onShown` is called when another speed or its name in another language is shown. */
  constructor(shell: Shell, onShown: () => void) {
    this.#shell = shell;
    this.#language = shell.language;
    this.#onShown = onShown;
    for (const pace of PACES) this.#add(pace);
    this.element.addEventListener('change', () => {
      shell.changeSpeed(this.pace);
      this.#onShown();
    });
    this.#showAttribute();
  }

  get pace(): Pace {
    return this.#paces[this.element.selectedIndex] ?? DEFAULT_PACE;
  }

  /** The name of the speed. */
  get text(): string {
    return this.#textOf(this.pace);
  }

  set language(language: Language) {
    this.#language = language;
    this.caption.textContent = WORDS[language].speed;
    for (const [i, pace] of this.#paces.entries()) this.element.options[i]!.textContent = this.#textOf(pace);
    this.#onShown();
  }

  /** The attribute has changed. */
  changed(): void {
    this.#showAttribute();
    this.#onShown();
  }

  #showAttribute(): void {
    const pace = this.#shell.speed ?? DEFAULT_PACE;
    const at = this.#paces.findIndex((known) => isSame(known, pace));
    this.element.selectedIndex = at < 0 ? this.#add(pace) : at;
  }

  /** Returns the index of the new option. */
  #add(pace: Pace): number {
    this.element.append(make('option', {}, this.#textOf(pace)));
    return this.#paces.push(pace) - 1;
  }

  #textOf(pace: Pace): string {
    return pace.kind === 'times' ? `${pace.factor}×` : WORDS[this.#language].wholeIn(pace.seconds);
  }
}

function isSame(one: Pace, other: Pace): boolean {
  return one.kind === 'times'
    ? other.kind === 'times' && one.factor === other.factor
    : other.kind === 'whole' && one.seconds === other.seconds;
}

const WORDS = words({
  en: { speed: 'Speed', wholeIn: (seconds: number) => `all in ${seconds} s` },
  zh: { speed: '速度', wholeIn: (seconds) => `全程 ${seconds} 秒` },
  ru: { speed: 'Скорость', wholeIn: (seconds) => `всё за ${seconds} с` },
});
