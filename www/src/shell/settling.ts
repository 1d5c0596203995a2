// Whether the page shows all there is to show.
//
// In: that something is under way, and that the worker has nothing more to show. Out: a promise of the
// number of the run, and a call each time. The layout may follow what was shown, and then the picture
// the layout: so the page is settled once two frames have passed in which nothing else came. Must not
// know: what was under way.

export class Settling {
  readonly #settled: (run: number) => void;
  #promise!: Promise<number>;
  #resolve!: (run: number) => void;
  #isSettled = true;
  /** Counts what was under way. */
  #turn = 0;

  constructor(settled: (run: number) => void) {
    this.#settled = settled;
    this.unsettle();
  }

  /** The number of the newest run, once all of it is shown. */
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
    const unless = (next: () => void) => (): void => {
      if (turn === this.#turn) next();
    };
    const end = unless(() => {
      this.#isSettled = true;
      this.#resolve(run);
      this.#settled(run);
    });
    // Boxes are measured after the callbacks of a frame: the second one knows what came of the first.
    requestAnimationFrame(unless(() => requestAnimationFrame(unless(() => setTimeout(end)))));
  }
}
