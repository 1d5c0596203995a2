// One notice with "Try again" for everything that could not be loaded or has failed; it stays until all of it works.
//
// In: the missing parts, the reasons, and functions that load them again. Out: the notice. All missing parts are loaded
// again when the user clicks the button or edits the program, and when the network returns. Each has one attempt at a
// time; an edit starts one no sooner than `PAUSE_MS` after the last failure. Must not know: how a part is loaded.

import type { Language } from '../dom/language';
import { whenOnline } from '../dom/network';

/** In order of importance: the notice names only the first one that is missing. */
const KINDS = ['interpreter', 'parts', 'panels', 'editor', 'completion'] as const;
export type MissingKind = (typeof KINDS)[number];

/** Minimum delay between a failure and an attempt after an edit. */
const PAUSE_MS = 2_000;

interface Thing {
  readonly say: (language: Language) => string;
  /** Retries; `'reload'` if only reloading the page helps. */
  readonly again: (() => void) | 'reload';
  isTried: boolean;
  /** Another attempt was requested during the current one: the network may have returned meanwhile. */
  isWanted: boolean;
}

export interface MissingEvents {
  /** Shows the text of the notice with its button; `undefined` hides the notice. */
  show(text: string | undefined, remedy: 'try-again' | 'reload'): void;
}

export class Missing {
  readonly #events: MissingEvents;
  readonly #things = new Map<MissingKind, Thing>();
  #language: Language;
  /** Earliest time of an attempt after an edit (`performance.now`). */
  #notBefore = 0;
  #soon: ReturnType<typeof setTimeout> | undefined;
  /** Set during an attempt, so that the run it starts does not count as an edit. */
  #isTrying = false;
  #stopWaiting: (() => void) | undefined;

  constructor(language: Language, events: MissingEvents) {
    this.#language = language;
    this.#events = events;
  }

  set language(language: Language) {
    this.#language = language;
    this.#show();
  }

  /** Reports a failure; `again` retries it, and then either `failed` or `works` is called. */
  failed(kind: MissingKind, say: (language: Language) => string, again: Thing['again']): void {
    // Several callers can report the same failure.
    const before = this.#things.get(kind);
    if (before?.isTried !== false) this.#notBefore = performance.now() + PAUSE_MS;
    this.#things.set(kind, { say, again, isTried: false, isWanted: false });
    this.#show();
    if (before?.isWanted === true) this.changed();
    this.#stopWaiting ??= whenOnline(() => {
      this.#stopWaiting = undefined;
      this.tryAgain();
    });
  }

  /** Reports an attempt that was started elsewhere. */
  tried(kind: MissingKind): void {
    const thing = this.#things.get(kind);
    if (thing !== undefined) thing.isTried = true;
  }

  works(kind: MissingKind): void {
    if (!this.#things.delete(kind)) return;
    if (this.#things.size === 0) this.leave();
    this.#show();
  }

  tryAgain(): void {
    clearTimeout(this.#soon);
    this.#soon = undefined;
    this.#isTrying = true;
    for (const thing of [...this.#things.values()]) {
      if (thing.again === 'reload') continue;
      thing.isWanted = thing.isTried;
      if (thing.isTried) continue;
      thing.isTried = true;
      thing.again();
    }
    this.#isTrying = false;
  }

  /** The user has edited the program. */
  changed(): void {
    if (this.#things.size === 0 || this.#isTrying) return;
    this.#soon ??= setTimeout(
      () => {
        this.#soon = undefined;
        // An attempt may have failed since the timer was set.
        if (performance.now() < this.#notBefore) this.changed();
        else this.tryAgain();
      },
      Math.max(0, this.#notBefore - performance.now()),
    );
  }

  /** Cancels all retries. */
  leave(): void {
    clearTimeout(this.#soon);
    this.#soon = undefined;
    this.#stopWaiting?.();
    this.#stopWaiting = undefined;
  }

  #show(): void {
    const first = KINDS.find((kind) => this.#things.has(kind));
    const thing = first && this.#things.get(first);
    this.#events.show(thing?.say(this.#language), thing?.again === 'reload' ? 'reload' : 'try-again');
  }
}
