// The slim line at the foot: "42 motions · 14 lines · no problems", and how numbers without a point are read.
//
// In: the summary of the newest run, or how far a long one is. Out: `stopped` (the reader has seen enough of that),
// `change` (they are to be read otherwise).
// Must not know: how a program is run.

import { make } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { Summary, Work } from '../protocol/protocol';

type Shown =
  | { readonly kind: 'loading' }
  | { readonly kind: 'running'; readonly work: Work; readonly done: number }
  | { readonly kind: 'failed' }
  | { readonly kind: 'summary'; readonly summary: Summary; readonly decimal: string | undefined };

export class StatusLine {
  readonly element = make('p', { className: 'status', part: 'status', role: 'status' });
  /** There while a run takes a noticeable time. */
  readonly stop = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #change = make('button', { type: 'button', className: 'change quiet' });
  #strings: Strings;
  #shown: Shown = { kind: 'loading' };

  constructor(strings: Strings, events: { stopped(): void; change(): void }) {
    this.#strings = strings;
    this.stop.addEventListener('click', () => events.stopped());
    this.#change.addEventListener('click', () => events.change());
    this.#render();
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.#render();
  }

  /** `decimal`: how numbers without a point are read, where the reader has to know. */
  show(summary: Summary, decimal: string | undefined): void {
    this.#show({ kind: 'summary', summary, decimal });
  }

  /** How far a long work is, from 0 to 1. */
  progress(work: Work, done: number): void {
    this.#show({ kind: 'running', work, done });
  }

  /** The run gave nothing; the notice says why. */
  fail(): void {
    this.#show({ kind: 'failed' });
  }

  #show(shown: Shown): void {
    this.#shown = shown;
    this.#render();
  }

  #render(): void {
    this.stop.textContent = this.#strings.stopRun;
    this.stop.hidden = this.#shown.kind !== 'running';
    // On a narrow page the line breaks between facts, not inside them.
    const facts = this.#facts().flatMap((fact, i) => [i > 0 ? ' · ' : '', make('span', {}, fact)]);
    this.element.replaceChildren(...facts);
    const decimal = this.#shown.kind === 'summary' ? this.#shown.decimal : undefined;
    if (decimal === undefined) return;
    this.#change.textContent = this.#strings.change;
    this.#change.setAttribute('aria-label', this.#strings.changeDecimal);
    this.element.append(' · ', make('span', { className: 'decimal' }, decimal), ' · ', this.#change);
  }

  #facts(): readonly string[] {
    const strings = this.#strings;
    switch (this.#shown.kind) {
      case 'loading':
        return [strings.loading];
      case 'running': {
        const percent = Math.floor(this.#shown.done * 100);
        return [this.#shown.work === 'part' ? strings.setup.part(percent) : strings.running(percent)];
      }
      case 'failed':
        return ['—'];
      case 'summary': {
        const { motions, lines, errors, warnings, infos } = this.#shown.summary;
        const problems = errors + warnings + infos;
        const found = problems === 0 ? strings.noProblems : strings.problemCount(problems);
        return [strings.motions(motions), strings.lines(lines), found];
      }
    }
  }
}
