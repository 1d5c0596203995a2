// The state of the newest run, as its events report it.
//
// In: the events of the newest run, edits, a lost worker. Out: the same events and failures for the panels, the problems
// for the editor, the event `gcode-report`, the notice about a rejected setup, the missing parts. Messages about a program
// that is still being typed are held back (`unfinished`). Must not know: how runs are started.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Program } from '../editor/program';
import type { Diagnostic, Report, Summary } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { diagnosticsInFile } from './file-offsets';
import type { Missing } from './missing';
import { hasMotions, type PanelSet } from './panel-set';
import type { ReportedLoss } from './runs';
import { Unfinished, type ReportEvent } from './unfinished';

interface RunReportsOptions {
  readonly editor: Program;
  readonly panels: PanelSet;
  readonly missing: Missing;
  readonly readonly: boolean;
  language(): Language;
  /** Why the setup could not be sent. */
  setupError(): string | undefined;
  /** Loads failed parts of the interpreter again. */
  loadParts(): void;
  /** Starts a new worker, unless there is one. */
  restart(): void;
  fire<Detail>(type: string, detail: Detail): void;
}

export class RunReports {
  readonly #options: RunReportsOptions;
  readonly #unfinished: Unfinished;
  #diagnostics: readonly Diagnostic[] = [];
  /** Whether the newest run was reported. */
  #isReported = false;
  /** Whether no run is in progress that would report the current program. */
  #isIdle = false;

  constructor(options: RunReportsOptions) {
    const { editor, panels } = options;
    this.#options = options;
    this.#unfinished = new Unfinished(editor, (event) => {
      panels.onEvent(event);
      editor.diagnostics = event.report.diagnostics;
    });
  }

  /** All problems of the newest report, also those that are held back. */
  get diagnostics(): readonly Diagnostic[] {
    return this.#diagnostics;
  }

  /** Whether there will be no report of the current program. */
  get hasFailed(): boolean {
    return this.#isIdle && !this.#isReported;
  }

  onEvent(event: CoreEvent): void {
    const { panels, missing, readonly } = this.#options;
    const received = readonly && event.kind === 'report' ? withoutFixes(event) : event;
    const shownEvent = received.kind === 'report' ? this.#unfinished.shown(received) : received;
    panels.onEvent(shownEvent);
    if (event.kind === 'path' || event.kind === 'report') missing.markLoaded('interpreter');
    if (received.kind === 'report' && shownEvent.kind === 'report')
      this.#onReport(received.report, shownEvent.report.diagnostics);
    else if (event.kind === 'part-failed') this.#onPartFailed(event);
    else if (event.kind === 'parts-loaded') missing.markLoaded('parts');
  }

  /** Text or setup have changed; the last report is outdated. */
  onInputChanged(): void {
    this.#isReported = false;
    this.#unfinished.drop();
    this.#options.panels.onInputChanged();
    if (this.#isIdle) this.#onRunFailed();
  }

  onRunStarted(): void {
    this.#options.missing.markRetrying('interpreter');
    this.#isIdle = false;
    this.#options.panels.onRunStarted();
  }

  /** The worker was lost, with all results of the run. */
  onLost(loss: ReportedLoss): void {
    console.error('gcode-playground: the interpreter was lost', loss);
    const { panels, missing } = this.#options;
    panels.available = false;
    panels.onWorkerLost();
    this.#isIdle = true;
    if (!this.#isReported) this.#onRunFailed();
    const retry = (): void => this.#options.restart();
    if (loss.kind === 'load-failed') missing.markFailed('interpreter', loss.reason, retry);
    else missing.markLost(loss.kind, retry);
  }

  onTyped(): void {
    this.#unfinished.onTyped();
  }

  onCursorMoved(): void {
    this.#unfinished.onCursorMoved();
  }

  /** The element was removed from the document. */
  disconnect(): void {
    this.#unfinished.drop();
  }

  /** `shown`: the problems without those that are held back. */
  #onReport(report: Report, shown: readonly Diagnostic[]): void {
    const { summary, diagnostics, setupRejected } = report;
    const { editor, panels, setupError, language, fire } = this.#options;
    this.#diagnostics = diagnostics;
    this.#isReported = true;
    const rejected = setupError() ?? setupRejected;
    if (rejected === undefined) panels.service('hideNotice')('setup');
    else panels.service('notice')(WORDS[language()].setupRejected(rejected), 'setup');
    panels.available = hasMotions(report);
    editor.diagnostics = shown;
    fire<{ summary: Summary; diagnostics: readonly Diagnostic[] }>('gcode-report', {
      summary,
      diagnostics: diagnosticsInFile(diagnostics, editor),
    });
  }

  #onPartFailed({ reason, neededFor }: Extract<CoreEvent, { readonly kind: 'part-failed' }>): void {
    this.#options.missing.markFailed('parts', reason, () => this.#options.loadParts());
    if (neededFor === 'the-report') this.#onRunFailed();
  }

  #onRunFailed(): void {
    const { editor, panels } = this.#options;
    this.#isIdle = true;
    panels.available = false;
    editor.diagnostics = [];
    panels.notify((panel) => panel.onRunFailed?.());
  }
}

/** Removes the fixes, which are useless if the program is read-only. */
function withoutFixes(event: ReportEvent): ReportEvent {
  const diagnostics = event.report.diagnostics.map((diagnostic) => ({ ...diagnostic, fixes: [] }));
  return { ...event, report: { ...event.report, diagnostics } };
}

const WORDS = words({
  en: { setupRejected: (reason: string) => `The setup was not accepted: ${reason}` },
  zh: { setupRejected: (reason) => `设置未被接受：${reason}` },
  ru: { setupRejected: (reason) => `Наладка отклонена: ${reason}` },
});
