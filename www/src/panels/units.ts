// The button that says the unit of the lengths that are shown, and switches to the other one.
//
// In: the unit of the program and the unit that is shown. Out: the unit that the user chooses, which also applies to
// other programs; choosing the unit of the program removes the choice. Must not know: the measured quantity.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Command, LengthUnit, Units } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';

export const units: PanelKind = { control: 'setup', make: (shell) => new UnitsButton(shell) };

class UnitsButton implements Panel {
  readonly #shell: Shell;
  readonly #button = make('button', { type: 'button', className: 'framed', part: 'units', hidden: true });
  #units: Units | undefined;
  #preferred: LengthUnit | undefined;
  readonly elements = { reading: [this.#button] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => this.#switchUnit());
  }

  set language(_: Language) {
    this.#show();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    this.#units = event.report.units;
    this.#show();
  }

  onWorkerConnected(send: (command: Command) => void): void {
    if (this.#preferred !== undefined) send({ kind: 'unit', unit: this.#preferred });
  }

  #switchUnit(): void {
    if (this.#units === undefined) return;
    const other = this.#units.shown === 'mm' ? 'inch' : 'mm';
    this.#preferred = other === this.#units.program ? undefined : other;
    this.#shell.send({ kind: 'unit', unit: this.#preferred });
  }

  #show(): void {
    const { shown } = this.#units ?? {};
    this.#button.hidden = shown === undefined;
    if (shown === undefined) return;
    const texts = WORDS[this.#shell.language];
    this.#button.textContent = texts.name[shown];
  }
}

const WORDS = words({
  en: {
    name: { mm: 'Lengths in mm: show them in inches', inch: 'Lengths in inch: show them in mm' },
  },
  zh: { name: { mm: '长度单位 mm：改为英寸', inch: '长度单位英寸：改为 mm' } },
  ru: { name: { mm: 'Длины, мм: показать в дюймах', inch: 'Длины, дюймы: показать в мм' } },
});
