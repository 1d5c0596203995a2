// The button "Export" and its menu: what can be saved as a file, beside the program itself.
//
// In: whether there is a run to export. Out: `chosen`, the kind of file. A menu button as ARIA describes it: Enter, Space and
// the arrow up open it, arrows, Home, End and first letters move in it, Escape closes it.
// Must not know: how a file is made.

import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import { FILE_FORMATS, type FileFormat } from '../protocol/protocol';

export interface ExportsEvents {
  chosen(format: FileFormat): void;
}

/** What a file of each kind is called behind its name. */
const ENDINGS: Readonly<Record<FileFormat, string>> = {
  svg: '.svg', png: '.png', card: '-card.html', csv: '.csv', dxf: '.dxf', stl: '.stl', program: '-plain.nc',
};

export class Exports {
  readonly button = make('button', {
    type: 'button', className: 'export-button quiet', 'aria-haspopup': 'menu', 'aria-expanded': 'false',
  });
  readonly element = make('div', { className: 'menu', part: 'export-menu', role: 'menu', popover: 'auto' });
  readonly #items: readonly { readonly format: FileFormat; readonly button: HTMLButtonElement }[];

  constructor(strings: Strings, events: ExportsEvents) {
    this.#items = FILE_FORMATS.map((format) => {
      const button = make('button', { type: 'button', role: 'menuitem', tabIndex: -1 });
      button.addEventListener('click', () => {
        this.element.hidePopover();
        this.button.focus();
        events.chosen(format);
      });
      return { format, button };
    });
    this.element.append(...this.#items.map(({ button }) => button));
    this.button.popoverTargetElement = this.element;
    this.button.addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      this.element.showPopover();
      this.#focus(event.key === 'ArrowUp' ? -1 : 0);
    });
    this.element.addEventListener('keydown', (event) => this.#key(event));
    this.element.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.button.setAttribute('aria-expanded', String(open));
      if (!open) return;
      this.#place();
      if (!this.element.contains(this.#focused)) this.#focus(0);
    });
    this.available = false;
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.button.textContent = strings.exports;
    this.element.setAttribute('aria-label', strings.exports);
    for (const { format, button } of this.#items) button.textContent = strings.exportOf[format];
  }

  /** Whether there is a finished run to make files of. */
  set available(available: boolean) {
    this.button.disabled = !available;
    if (!available && this.element.matches(':popover-open')) this.element.hidePopover();
  }

  get #focused(): Element | null {
    return (this.element.getRootNode() as ShadowRoot).activeElement;
  }

  /** Above the button, its right edge under that of the menu, as far as the window has room. */
  #place(): void {
    const { right, top } = this.button.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = this.element;
    this.element.style.left = `${Math.max(8, Math.min(right, window.innerWidth - 8) - width)}px`;
    this.element.style.top = `${Math.max(8, top - height - 6)}px`;
  }

  #key(event: KeyboardEvent): void {
    const at = this.#items.findIndex(({ button }) => button === this.#focused);
    if (event.key === 'ArrowDown') this.#focus(at + 1);
    else if (event.key === 'ArrowUp') this.#focus(at - 1);
    else if (event.key === 'Home') this.#focus(0);
    else if (event.key === 'End') this.#focus(-1);
    else if (event.key === 'Tab' || event.key === 'Escape') {
      this.element.hidePopover();
      this.button.focus();
    } else if (event.key.length === 1 && event.key !== ' ' && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const letter = event.key.toLocaleLowerCase();
      const round = [...this.#items.keys()].map((step) => (at + 1 + step) % this.#items.length);
      const found = round.find((index) => this.#items[index]?.button.textContent?.toLocaleLowerCase().startsWith(letter));
      if (found !== undefined) this.#focus(found);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Round and round. */
  #focus(index: number): void {
    this.#items.at(index % this.#items.length)?.button.focus();
  }
}

/** The name of an exported file, after that of the program. */
export function exportName(program: string | undefined, format: FileFormat): string {
  const stem = (program ?? 'program').replace(/\.[^.]*$/, '');
  return `${stem === '' ? 'program' : stem}${ENDINGS[format]}`;
}
