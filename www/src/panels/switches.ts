// The switches of the operator's panel that the text has a use for: levels of block skip, and which program is run.
//
// In: what is in the text, and how the switches stand. Out: `skipped` and `chosen` when the reader turns one.
// Must not know: what a skipped block is, or how a program is found.

import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { SwitchesInText } from '../protocol/protocol';

/** How the switches stand. */
export interface SwitchesSet {
  /** Levels that are on. */
  readonly blockSkip: readonly number[];
  /** The program to run; the first of the text when undefined. */
  readonly program: number | undefined;
}

export interface SwitchesEvents {
  skipped(levels: readonly number[]): void;
  chosen(program: number): void;
}

export class Switches {
  readonly element = make('div', { className: 'switches', part: 'switches', hidden: true });
  readonly #events: SwitchesEvents;
  readonly #skipText = make('span');
  readonly #levels = make('span', { className: 'levels' });
  readonly #skip = make('div', { className: 'skip', role: 'group' }, this.#skipText, this.#levels);
  readonly #programText = make('span', { 'aria-hidden': 'true' });
  readonly #program = make('select', { className: 'small' });
  readonly #choice = make('label', {}, this.#programText, this.#program);
  readonly #buttons = new Map<number, HTMLButtonElement>();
  #strings: Strings;
  #inText: SwitchesInText = { blockSkip: [], programs: [] };
  #set: SwitchesSet = { blockSkip: [], program: undefined };
  /** The options as they stand, so that an open list is not built anew under the reader's hand. */
  #options = '';

  constructor(strings: Strings, events: SwitchesEvents) {
    this.#strings = strings;
    this.#events = events;
    this.element.append(this.#choice, this.#skip);
    this.#program.addEventListener('change', () => this.#events.chosen(Number(this.#program.value)));
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.#skipText.textContent = strings.blockSkip;
    this.#skip.setAttribute('aria-label', strings.blockSkip);
    this.#skip.title = strings.blockSkipHint;
    this.#programText.textContent = strings.program;
    this.#program.setAttribute('aria-label', strings.programToRun);
    this.#render();
  }

  /** What the newest text has a use for. */
  set inText(inText: SwitchesInText) {
    this.#inText = inText;
    this.#render();
  }

  /** How the switches stand. */
  set state(state: SwitchesSet) {
    this.#set = state;
    this.#render();
  }

  #render(): void {
    this.#renderLevels();
    this.#renderPrograms();
    this.element.hidden = this.#skip.hidden && this.#choice.hidden;
  }

  #renderLevels(): void {
    const { blockSkip } = this.#inText;
    for (const level of blockSkip) if (!this.#buttons.has(level)) this.#buttons.set(level, this.#button(level));
    for (const [level, button] of this.#buttons) {
      button.setAttribute('aria-label', this.#strings.blockSkipLevel(mark(level)));
      button.setAttribute('aria-checked', String(this.#set.blockSkip.includes(level)));
      button.hidden = !blockSkip.includes(level);
    }
    const inOrder = [...this.#buttons].sort(([a], [b]) => a - b).map(([, button]) => button);
    if (inOrder.length > this.#levels.childElementCount) this.#levels.replaceChildren(...inOrder);
    this.#skip.hidden = blockSkip.length === 0;
  }

  #button(level: number): HTMLButtonElement {
    const button = make('button', { type: 'button', className: 'level', role: 'switch' }, mark(level));
    button.addEventListener('click', () => {
      const { blockSkip } = this.#set;
      const others = blockSkip.filter((one) => one !== level);
      this.#events.skipped(others.length < blockSkip.length ? others : [...others, level].sort((a, b) => a - b));
    });
    return button;
  }

  #renderPrograms(): void {
    const { programs } = this.#inText;
    const wanted = this.#set.program;
    const options = programs.map(({ number, name }) => ({ number, name }));
    // One that is wanted and not there can be seen, and left.
    if (wanted !== undefined && options.every(({ number }) => number !== wanted)) {
      options.push({ number: wanted, name: `O${String(wanted).padStart(4, '0')} ?` });
    }
    const written = options.map(({ name }) => name).join('\n');
    if (written !== this.#options) {
      this.#options = written;
      this.#program.replaceChildren(...options.map(({ number, name }) => make('option', { value: String(number) }, name)));
    }
    this.#program.value = String(wanted ?? programs[0]?.number ?? '');
    this.#choice.hidden = options.length < 2;
  }
}

/** As it is written in a program. */
function mark(level: number): string {
  return level === 1 ? '/' : `/${level}`;
}
