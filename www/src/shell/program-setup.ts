// The setup that belongs to the program in the editor: it goes with it, and comes back with undo.
//
// In: what the reader does with the text. Out: attributes as they are to be. Must not know: what a setup
// holds beyond the control.

import { neutralSetup, type SetupAttributes } from './start';

/** How a program is run: the attributes that belong to it. */
export interface RunAs extends Omit<SetupAttributes, 'control'> {
  readonly setup: string | null;
}

export interface Attributes {
  readonly control: string | null;
  readonly runAs: RunAs;
}

export class ProgramSetup {
  /** UTF-16 units of the program before the last change. */
  #lengthBefore = 0;
  /** How the program before this one was run, for undo. */
  #before: { readonly length: number; readonly runAs: RunAs } | undefined;

  /** The program is so long now. */
  know(length: number): void {
    this.#lengthBefore = length;
  }

  /** The setup for a program that has nothing to do with the one before, which was so long. */
  another(length: number, { control, runAs }: Attributes): string | null {
    this.#before = { length, runAs };
    // Where there is an attribute for the control, it stays by itself.
    return control === null ? neutralSetup(runAs.setup) : null;
  }

  /**
   * How the program is run once the reader has edited it: an emptied editor begins another program,
   * though the switches stay in sight; undo brings back the one before, and how it was run. Nothing
   * where all stays as it is.
   */
  follow(how: 'edited' | 'undone', length: number, attributes: Attributes): RunAs | undefined {
    const lengthBefore = this.#lengthBefore;
    this.#lengthBefore = length;
    if (length === 0 && how === 'edited') return { ...attributes.runAs, setup: this.another(lengthBefore, attributes) };
    if (how !== 'undone' || this.#before?.length !== length) return undefined;
    const { runAs } = this.#before;
    this.#before = undefined;
    return runAs;
  }
}
