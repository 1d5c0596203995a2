// What the tool does, over the picture: the readout, the block or stop, and the button that shows the whole path.
//
// In: the readout of the interpreter, and why the playback is held. Out: an element, hidden while there is no tool. Must
// not know: how the tool moves.

import { icon, make, setAccessibleName, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { HeldBy, LengthUnit, Readout } from '../protocol/protocol';
import { ReadoutBoard } from './readout';

export class ToolStatus {
  readonly element: HTMLElement;
  readonly #readout: ReadoutBoard;
  readonly #text = make('p', { className: 'doing', 'aria-live': 'polite' });
  readonly #wholePath = make('button', { type: 'button' }, icon('whole'));
  #shownText = '';
  #language: Language;

  /** `onWholePath` is called by the button. */
  constructor(language: Language, onWholePath: () => void) {
    this.#language = language;
    this.#readout = new ReadoutBoard(language);
    this.#wholePath.addEventListener('click', onWholePath);
    this.element = make(
      'div',
      { className: 'over-picture', part: 'doing' },
      this.#readout.element,
      this.#text,
      this.#wholePath,
    );
  }

  set language(language: Language) {
    this.#language = language;
    setAccessibleName(this.#wholePath, this.wholePathText);
    this.#readout.language = language;
  }

  set unit(unit: LengthUnit) {
    this.#readout.unit = unit;
  }

  /** Whether screen readers announce each change: during playback the announcements would never end. */
  set isAnnounced(isAnnounced: boolean) {
    this.#text.setAttribute('aria-live', isAnnounced ? 'polite' : 'off');
  }

  get wholePathText(): string {
    return WORDS[this.#language].wholePath;
  }

  show(readout: Readout | undefined, heldBy: HeldBy): void {
    this.#readout.shown = readout;
    this.element.hidden = readout === undefined;
    const texts = WORDS[this.#language];
    const { stroke, stop } = readout ?? {};
    const pausedAt = heldBy === 'line' ? stroke?.line : undefined;
    let text = '';
    if (pausedAt !== undefined) text = texts.pausedAt(pausedAt);
    else if (stop !== undefined) text = texts.stopped(stop.code, stop.line);
    else if (stroke !== undefined) text = `${COMMON[this.#language].line(stroke.line)}: ${stroke.text}`;
    if (text === this.#shownText) return;
    this.#shownText = text;
    this.#text.classList.toggle('stopped', stop !== undefined || pausedAt !== undefined);
    this.#text.replaceChildren(...(text === '' ? [] : renderUnbroken(text)));
  }
}

const WORDS = words({
  en: {
    wholePath: 'Show the whole path',
    stopped: (code: string, line: number) => `${code} in line ${line}: the program stops here. Press Play to continue.`,
    pausedAt: (line: number) => `Paused before line ${line}. Press Play to continue.`,
  },
  zh: {
    wholePath: '显示完整轨迹',
    stopped: (code, line) => `第 ${line} 行 ${code}：程序在此停止，按“播放”继续。`,
    pausedAt: (line) => `停在第 ${line} 行之前，按“播放”继续。`,
  },
  ru: {
    wholePath: 'Показать всю траекторию',
    stopped: (code, line) => `${code} в строке ${line}: здесь программа останавливается. «Пуск» — дальше.`,
    pausedAt: (line) => `Пауза перед строкой ${line}. «Пуск» — дальше.`,
  },
});
