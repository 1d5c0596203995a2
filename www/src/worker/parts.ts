// The parts of the interpreter, and the texts of languages, that are loaded after the first picture. `late` needs
// `early`.
//
// In: the needed parts, and callbacks that wait for them. Out: whether they are loaded; the callbacks run when they
// are, and waiters are notified of failures. Only `loadAll` retries a part that has failed, so the page decides when.
// (Loading `late` also loads `early`, whose files it needs.) Must not know: the content of a part, or the purpose of a
// callback.

import { loadPart } from '../../pkg/parts.js';
import type { PartFiles, PartName } from '../protocol/protocol';

export type { PartName };

/** A session that waits for parts. */
export interface Waiter {
  /** Runs a callback that has waited. */
  runGuarded(step: () => void): void;
  onPartFailed(reason: unknown): void;
  /** All parts that had failed are loaded. */
  onPartsLoaded(): void;
}

export class LateParts<W extends Waiter> {
  readonly #exports: object;
  readonly #files: PartFiles;
  readonly #allWaiters: () => Iterable<W>;
  readonly #loaded = new Set<PartName>();
  readonly #loading = new Map<PartName, Promise<void>>();
  /** The errors of parts that could not be loaded, until they are. */
  readonly #missing = new Map<PartName, unknown>();
  #waiting: { readonly waiter: W; readonly needs: readonly PartName[]; readonly callback: () => void }[] = [];
  /** Set until the first picture: loading parts could delay it. */
  #isOnHold = true;

  /** `exports`: of the module; `allWaiters`: the possible waiters. */
  constructor(exports: object, files: PartFiles, allWaiters: () => Iterable<W>) {
    this.#exports = exports;
    this.#files = files;
    this.#allWaiters = allWaiters;
  }

  has(...parts: readonly PartName[]): boolean {
    return parts.every((part) => this.#loaded.has(part));
  }

  /** Whether some parts have failed and are not being retried. */
  get failed(): boolean {
    return [...this.#missing.keys()].some(
      (part) => !this.#loading.has(part) && !(part === 'early' && this.#loading.has('late')),
    );
  }

  /** Loads missing parts in the given order, one after the other. Failures are reported to the waiters. */
  load(...parts: readonly PartName[]): void {
    void this.#loadSequentially(parts);
  }

  /** Calls `callback` as soon as the parts it needs are loaded. */
  whenLoaded(waiter: W, needs: readonly PartName[], callback: () => void): void {
    if (this.has(...needs)) return callback();
    this.#waiting.push({ waiter, needs, callback });
    const missing = needs.find((part) => this.#missing.has(part) && !this.#loading.has(part));
    if (missing !== undefined) waiter.onPartFailed(this.#missing.get(missing));
    else if (!this.#isOnHold) this.load(...needs);
  }

  /** Loads the parts that are waited for, and retries the failed ones. */
  loadAll(): void {
    this.#isOnHold = false;
    for (const part of this.#missing.keys()) void this.#load(part, 'retry').catch(() => undefined);
    for (const { needs } of this.#waiting) this.load(...needs);
  }

  /** The first picture was sent: loading parts no longer delays it. */
  release(): void {
    if (this.#isOnHold) this.loadAll();
  }

  /** Removes all callbacks of a waiter. */
  remove(waiter: W): void {
    this.#waiting = this.#waiting.filter((entry) => entry.waiter !== waiter);
  }

  async #loadSequentially(parts: readonly PartName[]): Promise<void> {
    try {
      for (const part of parts) await this.#load(part);
    } catch {
      // `#load` has reported it.
    }
  }

  async #load(part: PartName, attempt: 'first' | 'retry' = 'first'): Promise<void> {
    if (this.#loaded.has(part)) return;
    const inProgress = this.#loading.get(part);
    if (inProgress !== undefined) return inProgress;
    if (attempt === 'first' && this.#missing.has(part)) throw this.#missing.get(part);
    const loading = loadPart(part, this.#exports, this.#files[part]);
    this.#loading.set(part, loading);
    try {
      await loading;
    } catch (reason) {
      this.#loading.delete(part);
      this.#missing.set(part, reason);
      this.#reportFailure(part, reason);
      throw reason;
    }
    this.#loading.delete(part);
    let hadFailed = false;
    for (const loaded of part === 'late' ? (['early', 'late'] as const) : [part]) {
      this.#loaded.add(loaded);
      hadFailed = this.#missing.delete(loaded) || hadFailed;
    }
    this.#runReady();
    if (hadFailed && this.#missing.size === 0)
      for (const waiter of this.#allWaiters()) waiter.runGuarded(() => waiter.onPartsLoaded());
  }

  #runReady(): void {
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const entry of waiting) {
      if (this.has(...entry.needs)) entry.waiter.runGuarded(entry.callback);
      else this.#waiting.push(entry);
    }
  }

  /** Reports a failure to the waiters of the part, or to all if none waits: then it was loaded in advance. */
  #reportFailure(part: PartName, reason: unknown): void {
    if (this.#isOnHold) {
      // A failed part must not delay other parts.
      this.#isOnHold = false;
      for (const { needs } of this.#waiting) this.load(...needs.filter((need) => !this.#missing.has(need)));
    }
    const waiting = new Set(this.#waiting.filter(({ needs }) => needs.includes(part)).map(({ waiter }) => waiter));
    for (const waiter of waiting.size > 0 ? waiting : this.#allWaiters())
      waiter.runGuarded(() => waiter.onPartFailed(reason));
  }
}
