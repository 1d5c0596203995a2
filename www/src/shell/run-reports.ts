// The state of the newest run, as its events report it.
//
// In: the events of the newest run, edits, a lost worker. Out: the same events and failures for the panels, the problems
// for the editor, reports to the page (`checked`, the events `gcode-report` and `gcode-error`), the notice about a
// rejected setup, the missing parts. Messages about a program that is still being typed are held back (`unfinished`).
// Must not know: how runs are started.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Program } from '../editor/program';
import type { Diagnostic, Report, Summary } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { diagnosticsInFile } from './file-offsets';
import { deepFreeze } from './frozen';
import type { HostError, Missing } from './missing';
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

/** The result of a run for the page: offsets refer to `opened.text`. */
export interface Checked {
  readonly summary: Summary;
  readonly diagnostics: readonly Diagnostic[];
  /** Whether the part is complete: without it, messages about collisions are missing. */
  readonly complete: boolean;
}

export class RunReports {
  readonly #options: RunReportsOptions;
  readonly #unfinished: Unfinished;
  #diagnostics: readonly Diagnostic[] = [];
  #checked: Checked | undefined;
  /** Callbacks that wait until the newest run is reported, or has failed. */
  readonly #reportCallbacks: (() => void)[] = [];
  /** Reason of the rejection of the newest setup, if the page has received it. */
  #reportedRejection: string | undefined;
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

  /** The result of the current program; undefined until it is reported. */
  get checked(): Checked | undefined {
    return this.#checked;
  }

  /** Resolved when the current program is reported, or when there will be no report of it. */
  whenReported(): Promise<void> {
    if (this.#isReported || this.#isIdle) return Promise.resolve();
    return new Promise((resolve) => this.#reportCallbacks.push(resolve));
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
    this.#checked = undefined;
    this.#unfinished.drop();
    this.#options.panels.onInputChanged();
    if (this.#isIdle) this.#onRunFailed();
  }

  /** The page or the user has changed the setup. */
  onSetupChanged(): void {
    this.#reportedRejection = undefined;
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
    const { summary, diagnostics, stage } = report;
    const { editor, panels, fire } = this.#options;
    this.#diagnostics = diagnostics;
    this.#isReported = true;
    this.#showRejection(report);
    panels.available = hasMotions(report);
    editor.diagnostics = shown;
    // A report in another language is as complete as the last one.
    const complete = stage === 'repeated' ? (this.#checked?.complete ?? false) : stage !== 'path';
    this.#checked = deepFreeze({
      summary: { ...summary },
      diagnostics: diagnosticsInFile(diagnostics, editor),
      complete,
    });
    this.#callBack();
    fire<Checked>('gcode-report', this.#checked);
  }

  /** Shows why the setup was rejected, and fires the event once. */
  #showRejection({ setupRejected, stage }: Report): void {
    const { panels, setupError, language, fire } = this.#options;
    const reason = setupError() ?? setupRejected;
    if (reason === undefined) return panels.service('hideNotice')('setup');
    const message = WORDS[language()].setupRejected(reason);
    panels.service('notice')(message, 'setup');
    if (stage !== 'repeated' && reason !== this.#reportedRejection)
      fire<HostError>('gcode-error', { kind: 'setup', reason, message });
    this.#reportedRejection = reason;
  }

  #callBack(): void {
    for (const callback of this.#reportCallbacks.splice(0)) callback();
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
    this.#callBack();
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
