// What could not be loaded, or has failed: one notice with "Try again", which stays until all of it works.
//
// In: the missing files, why, and how to load them. Out: the notice. Everything that is missing is loaded again when the
// reader presses the button or changes the program, and when the network returns. Each thing has one attempt at a time; a
// change begins one no sooner than `PAUSE_MS` after the last failure. Must not know: how anything is loaded.

import type { Language } from '../dom/language';
import { whenOnline } from '../dom/network';

/** In the order in which the notice names them: only the first is named. */
const KINDS = ['interpreter', 'parts', 'panels', 'editor', 'completion'] as const;
export type MissingKind = (typeof KINDS)[number];

/** Between a failure and the attempt that a change of the program begins. */
const PAUSE_MS = 2_000;

interface Thing {
  readonly say: (language: Language) => string;
  /** Only the user reloads the page. */
  readonly again: (() => void) | 'reload';
  isTried: boolean;
  /** Another attempt was wanted since the current one began: the network may have returned meanwhile. */
  isWanted: boolean;
}

export interface MissingEvents {
  /** The text of the notice and its remedy; without a text there is none. */
  show(text: string | undefined, remedy: 'try-again' | 'reload'): void;
}

export class Missing {
  readonly #events: MissingEvents;
  readonly #things = new Map<MissingKind, Thing>();
  #language: Language;
  /** Nothing is tried earlier because of a change; a time of `performance.now`. */
  #notBefore = 0;
  #soon: ReturnType<typeof setTimeout> | undefined;
  /** A run that an attempt begins is no change. */
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

  /** `again` loads it; after that either `failed` or `works` is called. */
  failed(kind: MissingKind, say: (language: Language) => string, again: Thing['again']): void {
    // What waits for it can report the same failure more than once.
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

  /** An attempt is under way that was not begun here. */
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

  /** The reader has changed the program. */
  changed(): void {
    if (this.#things.size === 0 || this.#isTrying) return;
    this.#soon ??= setTimeout(
      () => {
        this.#soon = undefined;
        // An attempt may have failed since.
        if (performance.now() < this.#notBefore) this.changed();
        else this.tryAgain();
      },
      Math.max(0, this.#notBefore - performance.now()),
    );
  }

  /** Nothing is tried any more. */
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
