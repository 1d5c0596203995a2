// The parts of the interpreter, and the texts of languages, that are loaded after the first picture. `late` comes with `early`.
//
// In: which parts are wanted, and what waits for them. Out: whether they are there; what waited is done when they
// come, and hears of it when they do not. Only `loadAll` loads a part that has failed once more (and `late`, which needs the files of `early`): the page decides when.
// Must not know: what is in a part, or what waits for it.

import { loadPart } from '../../pkg/parts.js';
import type { PartFiles, PartName } from '../protocol/protocol';

export type { PartName };

/** Who waits for parts. */
export interface Waiter {
  /** What has waited is done. */
  guarded(step: () => void): void;
  partFailed(reason: unknown): void;
  /** All parts that had failed are loaded. */
  partsLoaded(): void;
}

export class LateParts<W extends Waiter> {
  readonly #exports: object;
  readonly #files: PartFiles;
  readonly #all: () => Iterable<W>;
  readonly #loaded = new Set<PartName>();
  readonly #loading = new Map<PartName, Promise<void>>();
  /** Why parts could not be loaded; each until it is. */
  readonly #missing = new Map<PartName, unknown>();
  #waiting: { readonly waiter: W; readonly needs: readonly PartName[]; readonly act: () => void }[] = [];
  /** Nothing is loaded that could delay the first picture of the page. */
  #isHeld = true;

  /** `exports`: of the module; `all` that may want parts. */
  constructor(exports: object, files: PartFiles, all: () => Iterable<W>) {
    this.#exports = exports;
    this.#files = files;
    this.#all = all;
  }

  has(...parts: readonly PartName[]): boolean {
    return parts.every((part) => this.#loaded.has(part));
  }

  /** Parts could not be loaded, and are not being loaded. */
  get failed(): boolean {
    return [...this.#missing.keys()].some(
      (part) => !this.#loading.has(part) && !(part === 'early' && this.#loading.has('late')),
    );
  }

  /** Loads what is not there yet, one after the other: what is wanted first is there first. Who may want it hears of a failure. */
  load(...parts: readonly PartName[]): void {
    void this.#loadInTurn(parts);
  }

  /** Does something as soon as the parts it needs are there. */
  whenLoaded(waiter: W, needs: readonly PartName[], act: () => void): void {
    if (this.has(...needs)) return act();
    this.#waiting.push({ waiter, needs, act });
    const missing = needs.find((part) => this.#missing.has(part) && !this.#loading.has(part));
    if (missing !== undefined) waiter.partFailed(this.#missing.get(missing));
    else if (!this.#isHeld) this.load(...needs);
  }

  /** Loads what is waited for, and what could not be loaded before. */
  loadAll(): void {
    this.#isHeld = false;
    for (const part of this.#missing.keys()) void this.#load(part, 'again').catch(() => undefined);
    for (const { needs } of this.#waiting) this.load(...needs);
  }

  /** The first picture of the page is on its way: nothing is delayed by other parts any more. */
  release(): void {
    if (this.#isHeld) this.loadAll();
  }

  /** Nothing is waited for any more. */
  leave(waiter: W): void {
    this.#waiting = this.#waiting.filter((late) => late.waiter !== waiter);
  }

  async #loadInTurn(parts: readonly PartName[]): Promise<void> {
    try {
      for (const part of parts) await this.#load(part);
    } catch {
      // Heard where it was loaded.
    }
  }

  async #load(part: PartName, which: 'first' | 'again' = 'first'): Promise<void> {
    if (this.#loaded.has(part)) return;
    const known = this.#loading.get(part);
    if (known !== undefined) return known;
    if (which === 'first' && this.#missing.has(part)) throw this.#missing.get(part);
    const loading = loadPart(part, this.#exports, this.#files[part]);
    this.#loading.set(part, loading);
    try {
      await loading;
    } catch (reason) {
      this.#loading.delete(part);
      this.#missing.set(part, reason);
      this.#failed(part, reason);
      throw reason;
    }
    this.#loading.delete(part);
    let hadFailed = false;
    for (const loaded of part === 'late' ? (['early', 'late'] as const) : [part]) {
      this.#loaded.add(loaded);
      hadFailed = this.#missing.delete(loaded) || hadFailed;
    }
    this.#goOn();
    if (hadFailed && this.#missing.size === 0)
      for (const waiter of this.#all()) waiter.guarded(() => waiter.partsLoaded());
  }

  #goOn(): void {
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const late of waiting) {
      if (this.has(...late.needs)) late.waiter.guarded(late.act);
      else this.#waiting.push(late);
    }
  }

  /** Where nothing waits for it, it was to be there before it is needed: that is for all to know. */
  #failed(part: PartName, reason: unknown): void {
    if (this.#isHeld) {
      // What others wait for is not held back by a part that cannot be had.
      this.#isHeld = false;
      for (const { needs } of this.#waiting) this.load(...needs.filter((need) => !this.#missing.has(need)));
    }
    const waiting = new Set(this.#waiting.filter(({ needs }) => needs.includes(part)).map(({ waiter }) => waiter));
    for (const waiter of waiting.size > 0 ? waiting : this.#all()) waiter.guarded(() => waiter.partFailed(reason));
  }
}
