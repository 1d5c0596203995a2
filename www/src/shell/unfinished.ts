// Holds back messages about a program that is still being typed: that it has no end yet, or no blocks.
//
// In: changes of the text, moves of the cursor, reports. Out: the report to show, and the whole report when the user
// pauses or leaves the last lines. A program that was opened or pasted is not affected. Must not know: the panels.

import type { Span } from '../editor/text-store';
import type { Diagnostic, Report } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';

/** A report as the worker sends it. */
export type ReportEvent = Extract<CoreEvent, { readonly kind: 'report' }>;

/** The rules whose messages are held back. */
const NO_BLOCKS = 'empty-program';
const NO_END = 'no-program-end';
/** Time without a key after which nothing is held back, ms. */
const PAUSE_MS = 3000;
/** Most UTF-16 units after the line of the cursor in which a further block is looked for. */
const MAX_REST = 200;

/** The text as far as it is needed here. */
interface Text {
  readonly revision: number;
  readonly length: number;
  readonly selection: Span;
  textBetween(from: number, to: number): string;
  endOfLine(offset: number): number;
}

export class Unfinished {
  readonly #text: Text;
  readonly #onEnd: (event: ReportEvent) => void;
  /** The revision that the user has typed; any other change of the text has another one. */
  #typedRevision: number | undefined;
  #typedAt = 0;
  /** The report of which some messages are held back. */
  #whole: ReportEvent | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `onEnd` receives the whole report. */
  constructor(text: Text, onEnd: (event: ReportEvent) => void) {
    this.#text = text;
    this.#onEnd = onEnd;
  }

  onTyped(): void {
    this.#typedRevision = this.#text.revision;
    this.#typedAt = performance.now();
  }

  /** The report without the messages that are held back. */
  shown(event: ReportEvent): ReportEvent {
    this.drop();
    const isBlank = this.#isBlankAfter(0);
    const isTyping = this.#isTyping;
    const isHeldBack = ({ slug }: Diagnostic): boolean =>
      slug === NO_BLOCKS ? isBlank || isTyping : slug === NO_END && isTyping;
    const heldBack = event.report.diagnostics.filter(isHeldBack);
    if (heldBack.length === 0) return event;
    if (isTyping) {
      this.#whole = event;
      this.#timer = setTimeout(() => this.#end(), this.#typedAt + PAUSE_MS - performance.now());
    }
    return { ...event, report: without(event.report, heldBack) };
  }

  onCursorMoved(): void {
    if (this.#whole !== undefined && !this.#isAtEnd) this.#end();
  }

  /** The report is outdated. */
  drop(): void {
    clearTimeout(this.#timer);
    this.#whole = undefined;
  }

  #end(): void {
    const event = this.#whole;
    this.drop();
    this.#typedRevision = undefined;
    if (event !== undefined) this.#onEnd({ ...event, report: { ...event.report, stage: 'repeated' } });
  }

  get #isTyping(): boolean {
    const isPaused = performance.now() >= this.#typedAt + PAUSE_MS;
    return !isPaused && this.#typedRevision === this.#text.revision && this.#isAtEnd;
  }

  /** Whether no block is after the line of the cursor. */
  get #isAtEnd(): boolean {
    return this.#isBlankAfter(this.#text.endOfLine(this.#text.selection.to));
  }

  /** Whether there are only blanks and `%` from an offset on. */
  #isBlankAfter(offset: number): boolean {
    return this.#text.length - offset <= MAX_REST && /^[\s%]*$/.test(this.#text.textBetween(offset, this.#text.length));
  }
}

function without(report: Report, removed: readonly Diagnostic[]): Report {
  const { errors, warnings, infos } = report.summary;
  const count = (of: Diagnostic['severity']): number => removed.filter(({ severity }) => severity === of).length;
  return {
    ...report,
    diagnostics: report.diagnostics.filter((diagnostic) => !removed.includes(diagnostic)),
    summary: {
      ...report.summary,
      errors: errors - count('error'),
      warnings: warnings - count('warning'),
      infos: infos - count('info'),
    },
  };
}
