// What the element waits for before it is settled, besides the run: parts that are being loaded, and the move of the
// tool to its initial position, which comes last.
//
// In: parts that begin and end, the run that the worker has shown. Out: the run when nothing is left to wait for; the
// move of the tool once only it is left. Must not know: how a part is loaded, or how the tool moves.

import { parseStep, type Step } from './author';

export type Part = 'panels' | 'editor' | 'program' | 'step' | 'link' | 'height';

interface PendingEvents {
  /** The attribute `step`. */
  step(): string | null;
  /** Resolved, or rejected, when nothing more is being loaded that moves the tool. */
  complete(): Promise<void>;
  moveTool(step: Step): Promise<void>;
  /** Something that may change the display is in progress. */
  onUnsettled(): void;
  /** Everything of this run is shown. */
  onSettled(run: number): void;
}

export class PendingParts {
  readonly #parts: Set<Part>;
  readonly #events: PendingEvents;
  /** The run that is settled apart from the parts. */
  #settledRun: number | undefined;

  constructor(parts: readonly Part[], events: PendingEvents) {
    this.#parts = new Set(parts);
    this.#events = events;
  }

  has(part: Part): boolean {
    return this.#parts.has(part);
  }

  add(part: Part): void {
    this.#parts.add(part);
    this.#events.onUnsettled();
  }

  /** A part is loaded, or has failed. */
  finish(part: Part): void {
    this.#parts.delete(part);
    this.#settle();
  }

  /** The user has changed the program: the tool is not moved. */
  dropStep(): void {
    this.#parts.delete('step');
  }

  /** The attribute `step` has changed, or another program was loaded. */
  stepChanged(): void {
    if (parseStep(this.#events.step()) === undefined) {
      if (this.#parts.has('step')) this.finish('step');
      return;
    }
    this.add('step');
    if (this.#settledRun !== undefined) void this.#applyStep();
  }

  /** A run is in progress. */
  onRunUnsettled(): void {
    this.#settledRun = undefined;
    this.#events.onUnsettled();
  }

  /** The worker has shown the run. */
  onRunSettled(run: number): void {
    this.#settledRun = run;
    this.#settle();
  }

  #settle(): void {
    if (this.#settledRun === undefined) return;
    if (this.#parts.size === 0) this.#events.onSettled(this.#settledRun);
    else if (this.#parts.has('step') && this.#parts.size === 1) void this.#applyStep();
  }

  /** Moves the tool to the `step`, once the run is complete and its panels are loaded. */
  async #applyStep(): Promise<void> {
    const step = parseStep(this.#events.step());
    const run = this.#settledRun;
    if (step === undefined || !this.#parts.has('step') || run === undefined) return;
    await this.#events.complete().catch(() => undefined);
    // The user may have changed the program meanwhile.
    if (run !== this.#settledRun || !this.#parts.delete('step')) return;
    await this.#events.moveTool(step);
    this.#settle();
  }
}
