// One notice with "Try again" for everything that could not be loaded or has failed; it stays until all of it works.
//
// In: the missing parts, the reasons, and functions that load them again. Out: the notice. All missing parts are loaded
// again when the user clicks the button or edits the program, and when the network returns. Each has one attempt at a
// time; an edit starts one no sooner than `MIN_RETRY_DELAY_MS` after the last failure. Must not know: how a part is
// loaded.

import type { Language } from '../dom/language';
import { whenOnline } from '../dom/network';

/** In order of importance: the notice names only the first one that is missing. */
const KINDS = ['interpreter', 'parts', 'panels', 'editor', 'completion'] as const;
export type MissingKind = (typeof KINDS)[number];

/** Minimum delay between a failure and an attempt after an edit. */
const MIN_RETRY_DELAY_MS = 2_000;
/** A failure this soon after the network has returned may be that of a request from before. */
const NETWORK_RETURNS_MS = 5_000;

interface MissingPart {
  readonly message: (language: Language) => string;
  /** Retries; `'reload'` if only reloading the page helps. */
  readonly retry: (() => void) | 'reload';
  isRetrying: boolean;
  /** Another attempt was requested during the current one: the network may have returned meanwhile. */
  isRetryRequested: boolean;
}

interface MissingEvents {
  /** Shows the text of the notice with its button; `undefined` hides the notice. */
  show(text: string | undefined, action: 'try-again' | 'reload'): void;
}

export class Missing {
  readonly #events: MissingEvents;
  readonly #parts = new Map<MissingKind, MissingPart>();
  #language: Language;
  /** Earliest time of an attempt after an edit (`performance.now`). */
  #earliestRetry = 0;
  #retryTimer: ReturnType<typeof setTimeout> | undefined;
  /** Set during an attempt, so that the run it starts does not count as an edit. */
  #isRetryingAll = false;
  #stopWaitingForNetwork: (() => void) | undefined;
  /** When the network last returned (`performance.now`). */
  #onlineAt = -Infinity;

  constructor(language: Language, events: MissingEvents) {
    this.#language = language;
    this.#events = events;
  }

  set language(language: Language) {
    this.#language = language;
    this.#show();
  }

  /** Reports a failure; `retry` retries it, and then either `markFailed` or `markLoaded` is called. */
  markFailed(kind: MissingKind, message: (language: Language) => string, retry: MissingPart['retry']): void {
    // Several callers can report the same failure.
    const before = this.#parts.get(kind);
    if (before?.isRetrying !== false) this.#earliestRetry = performance.now() + MIN_RETRY_DELAY_MS;
    this.#parts.set(kind, { message, retry, isRetrying: false, isRetryRequested: false });
    this.#show();
    const hasJustReturned = performance.now() - this.#onlineAt < NETWORK_RETURNS_MS;
    if (before?.isRetryRequested === true || hasJustReturned) this.onEdit();
    this.#stopWaitingForNetwork ??= whenOnline(() => {
      this.#stopWaitingForNetwork = undefined;
      this.#onlineAt = performance.now();
      this.retryAll();
    });
  }

  /** Reports an attempt that was started elsewhere. */
  markRetrying(kind: MissingKind): void {
    const part = this.#parts.get(kind);
    if (part !== undefined) part.isRetrying = true;
  }

  markLoaded(kind: MissingKind): void {
    if (!this.#parts.delete(kind)) return;
    if (this.#parts.size === 0) this.cancelRetries();
    this.#show();
  }

  retryAll(): void {
    clearTimeout(this.#retryTimer);
    this.#retryTimer = undefined;
    this.#isRetryingAll = true;
    for (const part of [...this.#parts.values()]) {
      if (part.retry === 'reload') continue;
      part.isRetryRequested = part.isRetrying;
      if (part.isRetrying) continue;
      part.isRetrying = true;
      part.retry();
    }
    this.#isRetryingAll = false;
  }

  /** The user has edited the program. */
  onEdit(): void {
    if (this.#parts.size === 0 || this.#isRetryingAll) return;
    this.#retryTimer ??= setTimeout(
      () => {
        this.#retryTimer = undefined;
        // An attempt may have failed since the timer was set.
        if (performance.now() < this.#earliestRetry) this.onEdit();
        else this.retryAll();
      },
      Math.max(0, this.#earliestRetry - performance.now()),
    );
  }

  /** Cancels all retries. */
  cancelRetries(): void {
    clearTimeout(this.#retryTimer);
    this.#retryTimer = undefined;
    this.#stopWaitingForNetwork?.();
    this.#stopWaitingForNetwork = undefined;
  }

  #show(): void {
    const first = KINDS.find((kind) => this.#parts.has(kind));
    const part = first && this.#parts.get(first);
    this.#events.show(part?.message(this.#language), part?.retry === 'reload' ? 'reload' : 'try-again');
  }
}
