// Applies the setup of a session, which the part `early` parses unless the setup is empty.
//
// In: setups as JSON. Out: the setup in the core, now or once the part is loaded; why it was rejected. Must not know: how
// parts are loaded.

import type { Playground } from '../../pkg/gcode_playground.js';
import { describe } from './describe';

/** The only setup that does not need the part `early`. */
export const EMPTY_SETUP = '{}';

export class SetupChange {
  readonly #core: Playground;
  readonly #canParse: () => boolean;
  /** A setup that waits for the part `early`. */
  #pending: string | undefined;
  #rejected: string | undefined;

  /** `canParse`: whether the part `early` is loaded. */
  constructor(core: Playground, canParse: () => boolean) {
    this.#core = core;
    this.#canParse = canParse;
  }

  /** Why the last setup was rejected. */
  get rejected(): string | undefined {
    return this.#rejected;
  }

  /** Whether a setup waits for the part `early`. */
  get isPending(): boolean {
    return this.#pending !== undefined;
  }

  set(json: string): void {
    this.#pending = undefined;
    if (json !== EMPTY_SETUP && !this.#canParse()) {
      this.#pending = json;
      return;
    }
    try {
      this.#core.setSetup(json);
      this.#rejected = undefined;
    } catch (reason) {
      if (reason instanceof WebAssembly.RuntimeError) throw reason;
      this.#rejected = describe(reason);
    }
  }

  /** Applies the setup that has waited. Returns whether there was one. */
  applyPending(): boolean {
    const setup = this.#pending;
    if (setup !== undefined) this.set(setup);
    return setup !== undefined;
  }
}
