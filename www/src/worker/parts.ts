// The parts of the interpreter that are loaded after the first picture.
//
// In: which parts are wanted. Out: whether they are there, and what happens when they come or do not. A part
// that could not be loaded is tried again when it is asked for again. Must not know: what is in a part, or
// what waits for it.

import { fetchPart, loadPart, type PartName } from '../../pkg/parts.js';

export { fetchPart };
export type { PartName };

export interface PartsListener {
  loaded(): void;
  failed(reason: unknown): void;
}

export class Parts {
  readonly #exports: object;
  readonly #listener: PartsListener;
  readonly #loaded = new Set<PartName>();
  readonly #loading = new Map<PartName, Promise<void>>();

  /** `exports`: of the module. */
  constructor(exports: object, listener: PartsListener) {
    this.#exports = exports;
    this.#listener = listener;
  }

  has(...parts: readonly PartName[]): boolean {
    return parts.every((part) => this.#loaded.has(part));
  }

  /** Loads what is not there yet, one after the other: what is wanted first is there first. */
  async load(...parts: readonly PartName[]): Promise<void> {
    for (const part of parts) await this.#load(part);
  }

  async #load(part: PartName): Promise<void> {
    if (this.#loaded.has(part)) return;
    const loading = this.#loading.get(part) ?? loadPart(part, this.#exports);
    this.#loading.set(part, loading);
    try {
      await loading;
    } catch (reason) {
      this.#loading.delete(part);
      this.#listener.failed(reason);
      throw reason;
    }
    if (this.#loaded.has(part)) return;
    this.#loaded.add(part);
    this.#listener.loaded();
  }
}
