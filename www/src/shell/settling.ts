// Detects that everything is shown.
//
// In: that something is in progress, and that the worker has nothing more to show. Out: a promise of the number of the
// run, and a callback. The layout may still follow what was shown, and then the picture the layout: so two frames
// without further events must pass. Must not know: the cause of an event.

import { inNextFrame } from '../worker/frame';

export class Settling {
  readonly #onSettled: (run: number) => void;
  #promise!: Promise<number>;
  #resolve!: (run: number) => void;
  #isSettled = true;
  /** Incremented whenever something is in progress. */
  #turn = 0;

  constructor(onSettled: (run: number) => void) {
    this.#onSettled = onSettled;
    this.unsettle();
  }

  /** Resolved with the number of the newest run when all of it is shown. */
  get promise(): Promise<number> {
    return this.#promise;
  }

  unsettle(): void {
    this.#turn++;
    if (!this.#isSettled) return;
    this.#isSettled = false;
    this.#promise = new Promise((resolve) => (this.#resolve = resolve));
  }

  settle(run: number): void {
    const turn = ++this.#turn;
    const ifCurrent = (next: () => void) => (): void => {
      if (turn === this.#turn) next();
    };
    const end = ifCurrent(() => {
      this.#isSettled = true;
      this.#resolve(run);
      this.#onSettled(run);
    });
    // `ResizeObserver` callbacks run after the callbacks of a frame, so a second frame is needed to notice them.
    inNextFrame(ifCurrent(() => inNextFrame(ifCurrent(() => setTimeout(end)))));
  }
}
