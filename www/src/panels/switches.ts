// The switches of the operator's panel that the text uses: levels of block skip, and the program to run.
//
// In: the switches that the text uses, and their state. Out: the switch that the user changes. Must not know: the
// effect of block skip, or how a program is found.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { SwitchesInText } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell, SwitchState } from './panel';
import switchesStyles from './switches.css?inline';

export const switches: PanelKind = { control: 'setup', styles: switchesStyles, make: (shell) => new Switches(shell) };

class Switches implements Panel {
  readonly #shell: Shell;
  readonly #element = make('div', { className: 'switches', part: 'switches', hidden: true });
  readonly #skipText = make('span');
  readonly #levels = make('span', { className: 'levels' });
  readonly #skip = make('div', { className: 'skip', role: 'group' }, this.#skipText, this.#levels);
  readonly #programText = make('span', { 'aria-hidden': 'true' });
  readonly #program = make('select', { className: 'small' });
  readonly #programChoice = make('label', {}, this.#programText, this.#program);
  readonly #buttons = new Map<number, HTMLButtonElement>();
  #inText: SwitchesInText = { blockSkip: [], programs: [] };
  #state: SwitchState = { blockSkip: [], program: undefined };
  /** The current options as text: an unchanged list is not rebuilt, because the user may have opened it. */
  #options = '';

  readonly elements = { reading: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#element.append(this.#programChoice, this.#skip);
    this.#program.addEventListener('change', () => shell.setSwitches({ program: this.#program.value }));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#skipText.textContent = texts.blockSkip;
    this.#skip.setAttribute('aria-label', texts.blockSkip);
    this.#skip.title = texts.blockSkipHint;
    this.#programText.textContent = COMMON[language].program;
    this.#program.setAttribute('aria-label', texts.programToRun);
    this.#render();
  }

  onEvent(event: CoreEvent): void {
    const inText =
      event.kind === 'switches' ? event.inText : event.kind === 'report' ? event.report.switches : undefined;
    if (inText === undefined) return;
    this.#inText = inText;
    this.#render();
  }

  onSwitchesChanged(state: SwitchState): void {
    this.#state = state;
    this.#render();
  }

  #render(): void {
    this.#renderLevels();
    this.#renderPrograms();
    this.#element.hidden = this.#skip.hidden && this.#programChoice.hidden;
  }

  #renderLevels(): void {
    const { blockSkip } = this.#inText;
    for (const level of blockSkip) if (!this.#buttons.has(level)) this.#buttons.set(level, this.#button(level));
    for (const [level, button] of this.#buttons) {
      button.setAttribute('aria-label', WORDS[this.#shell.language].blockSkipLevel(mark(level)));
      button.setAttribute('aria-checked', String(this.#state.blockSkip.includes(level)));
      button.hidden = !blockSkip.includes(level);
    }
    const inOrder = [...this.#buttons].sort(([a], [b]) => a - b).map(([, button]) => button);
    if (inOrder.length > this.#levels.childElementCount) this.#levels.replaceChildren(...inOrder);
    this.#skip.hidden = blockSkip.length === 0;
  }

  #button(level: number): HTMLButtonElement {
    const button = make('button', { type: 'button', className: 'framed', role: 'switch' }, mark(level));
    button.addEventListener('click', () => {
      const { blockSkip } = this.#state;
      const others = blockSkip.filter((other) => other !== level);
      const levels = others.length < blockSkip.length ? others : [...others, level].sort((a, b) => a - b);
      this.#shell.setSwitches({ blockSkip: levels.join(',') });
    });
    return button;
  }

  #renderPrograms(): void {
    const { programs } = this.#inText;
    const selected = this.#state.program;
    const options = programs.map(({ number, name }) => ({ number, name }));
    // A selected program that does not exist is listed, so that the user sees it and can select another one.
    if (selected !== undefined && options.every(({ number }) => number !== selected)) {
      options.push({ number: selected, name: `O${String(selected).padStart(4, '0')} ?` });
    }
    const names = options.map(({ name }) => name).join('\n');
    if (names !== this.#options) {
      this.#options = names;
      this.#program.replaceChildren(
        ...options.map(({ number, name }) => make('option', { value: String(number) }, name)),
      );
    }
    this.#program.value = String(selected ?? programs[0]?.number ?? '');
    this.#programChoice.hidden = options.length < 2;
  }
}

/** The slash as it is written in a program. */
function mark(level: number): string {
  return level === 1 ? '/' : `/${level}`;
}

const WORDS = words({
  en: {
    blockSkip: 'Block skip',
    blockSkipHint: 'When on, blocks marked with this slash are left out',
    /** `mark` as it is written in a program: `/2`. */
    blockSkipLevel: (mark: string) => `Block skip ${mark}`,
    programToRun: 'Program to run',
  },
  zh: {
    blockSkip: '程序段跳过',
    blockSkipHint: '打开后，跳过带此斜杠的程序段',
    blockSkipLevel: (mark) => `程序段跳过 ${mark}`,
    programToRun: '要运行的程序',
  },
  ru: {
    blockSkip: 'Пропуск кадров',
    blockSkipHint: 'Если включено, кадры с этой косой чертой пропускаются',
    blockSkipLevel: (mark) => `Пропуск кадров ${mark}`,
    programToRun: 'Выполняемая программа',
  },
});
