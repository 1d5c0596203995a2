// The hints for a first visit, one after the other, over the picture. A hint is not shown again once the user has done what it says or has dismissed it.
//
// In: the remaining hints, from the element's attribute `hints` (no attribute: no hints). Out: the new value of the
// attribute, and the event `gcode-hint`, so that the page can store it. Must not know: where it is stored.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Readout } from '../protocol/protocol';
import type { Panel, PanelKind, Shell } from './panel';
import hintsStyles from './hints.css?inline';

const NAMES = ['play', 'pick'] as const;
type Name = (typeof NAMES)[number];

export const hints: PanelKind = { styles: hintsStyles, make: (shell) => new Hints(shell) };

class Hints implements Panel {
  readonly #host: Element;
  readonly #hints: Readonly<Record<Name, Hint>>;
  readonly elements: Panel['elements'];

  constructor(shell: Shell) {
    this.#host = shell.root.host;
    this.#hints = { play: this.#hint('play'), pick: this.#hint('pick') };
    const { play, pick } = this.#hints;
    // These hints float over the pictures, so the pictures keep their size.
    const overPictures = make('div', { className: 'over-pictures' }, pick.element, play.element);
    this.elements = { pictures: [overPictures] };
    this.#host.addEventListener('gcode-select', () => this.#finish('pick'));
    this.#show();
  }

  set language(language: Language) {
    for (const name of NAMES) this.#hints[name].setTexts(WORDS[language][name], WORDS[language].dismiss);
  }

  onToolMoved(place: Readout | undefined): void {
    if (place !== undefined) this.#finish('play');
  }

  #hint(name: Name): Hint {
    return new Hint(name, () => this.#finish(name));
  }

  get #remaining(): readonly Name[] {
    const remaining = (this.#host.getAttribute('hints') ?? '').split(' ');
    return NAMES.filter((name) => remaining.includes(name));
  }

  #finish(name: Name): void {
    const before = this.#remaining;
    if (!before.includes(name)) return;
    const remaining = before.filter((other) => other !== name).join(' ');
    this.#host.setAttribute('hints', remaining);
    this.#host.dispatchEvent(
      new CustomEvent('gcode-hint', { detail: { left: remaining }, bubbles: true, composed: true }),
    );
    this.#show();
  }

  /** Shows the next remaining hint. */
  #show(): void {
    const [next] = this.#remaining;
    for (const name of NAMES) this.#hints[name].element.hidden = name !== next;
  }
}

class Hint {
  readonly element: HTMLElement;
  readonly #text = make('p');
  readonly #dismiss = make('button', { type: 'button' });

  constructor(name: Name, onDismiss: () => void) {
    this.element = make('div', { className: `hint at-${name}`, part: 'hint', role: 'note' }, this.#text, this.#dismiss);
    this.#dismiss.addEventListener('click', onDismiss);
  }

  setTexts(text: string, dismiss: string): void {
    this.#text.textContent = text;
    this.#dismiss.textContent = dismiss;
  }
}

const WORDS = words({
  en: {
    play: 'Play below shows the tool at work; its block is marked in the program.',
    pick: 'Click a stroke to find the block that made it.',
    dismiss: 'Got it',
  },
  zh: {
    play: '按下方的“播放”观看刀具运动，程序中会标出正在执行的程序段。',
    pick: '单击线条，找到生成它的程序段。',
    dismiss: '知道了',
  },
  ru: {
    play: '«Пуск» внизу показывает работу инструмента; его кадр отмечен в программе.',
    pick: 'Щёлкните по линии, чтобы найти её кадр.',
    dismiss: 'Понятно',
  },
});
