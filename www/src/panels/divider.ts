// The divider between program and drawing when they are side by side.
//
// In: a pointer or keys; the attribute `split` of the element, in percent of its width. Out: the new value of the
// attribute, and the event `gcode-split`, so that the page can store it. Must not know: the parts on its sides, or
// where the value is stored.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Panel, PanelKind, Shell } from './panel';
import dividerStyles from './divider.css?inline';

/** Width of the program, percent: default, minimum and maximum. */
const WIDTH_PERCENT = { default: 42, min: 20, max: 75 } as const;
/** Percent for each key press. */
const STEP_PERCENT = 2;

export const divider: PanelKind = { styles: dividerStyles, make: (shell) => new Divider(shell) };

class Divider implements Panel {
  readonly #host: Element;
  readonly #frame: HTMLElement;
  readonly #element = make('div', {
    className: 'divider',
    role: 'separator',
    tabIndex: 0,
    'aria-orientation': 'vertical',
    'aria-valuemin': WIDTH_PERCENT.min,
    'aria-valuemax': WIDTH_PERCENT.max,
    'aria-controls': 'written',
  });
  readonly elements = { divider: [this.#element] };

  constructor(shell: Shell) {
    this.#host = shell.root.host;
    this.#frame = shell.frame;
    this.#element.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.#element.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    this.#element.addEventListener('pointermove', (event) => {
      if (!this.#element.hasPointerCapture(event.pointerId)) return;
      const { left, width } = this.#frame.getBoundingClientRect();
      this.#show(((event.clientX - left) / width) * 100);
    });
    this.#element.addEventListener('pointerup', () => this.#store());
    this.#element.addEventListener('dblclick', () => this.#set(WIDTH_PERCENT.default));
    this.#element.addEventListener('keydown', (event) => this.#handleKey(event));
    this.#show(Number(this.#host.getAttribute('split') ?? WIDTH_PERCENT.default) || WIDTH_PERCENT.default);
  }

  set language(language: Language) {
    this.#element.setAttribute('aria-label', WORDS[language].divider);
    this.#element.title = WORDS[language].hint;
  }

  get #percent(): number {
    return Number(this.#element.getAttribute('aria-valuenow'));
  }

  #show(percent: number): void {
    const rounded = Math.round(Math.min(Math.max(percent, WIDTH_PERCENT.min), WIDTH_PERCENT.max));
    this.#element.setAttribute('aria-valuenow', String(rounded));
    this.#frame.style.setProperty('--split', `${rounded}%`);
  }

  #set(percent: number): void {
    this.#show(percent);
    this.#store();
  }

  #store(): void {
    const split = String(this.#percent);
    if (this.#host.getAttribute('split') === split) return;
    this.#host.setAttribute('split', split);
    this.#host.dispatchEvent(new CustomEvent('gcode-split', { detail: { split }, bubbles: true, composed: true }));
  }

  #handleKey(event: KeyboardEvent): void {
    const to = {
      ArrowLeft: this.#percent - STEP_PERCENT,
      ArrowRight: this.#percent + STEP_PERCENT,
      Home: WIDTH_PERCENT.min,
      End: WIDTH_PERCENT.max,
      Enter: WIDTH_PERCENT.default,
    }[event.key];
    if (to === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    this.#set(to);
    event.preventDefault();
  }
}

const WORDS = words({
  en: {
    divider: 'Width of the program',
    hint: 'Drag to change the widths of program and drawing. Double-click to reset',
  },
  zh: { divider: '程序区宽度', hint: '拖动以调整程序区与图形区的宽度；双击恢复' },
  ru: {
    divider: 'Ширина программы',
    hint: 'Потяните, чтобы изменить ширину программы и чертежа. Двойной щелчок: как было',
  },
});
