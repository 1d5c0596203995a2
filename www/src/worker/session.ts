// The session of one element in the worker: owns a `Playground`, its text and the canvas it draws on.
//
// In: commands and questions of protocol.ts. Out: events, each with the number of its run; all are sent by `#emit`. A
// program runs in slices, and messages are processed between them, so a newer text ends an older run immediately, and
// no session waits long for another. Pictures are sent as images, one at a time: the next one is sent after the page
// has shown the last, so "settled" refers to the pictures on the page. Must not know: the page, other sessions, or the
// meaning of the program.

import type { Playground } from '../../pkg/gcode_playground.js';
import { ANSWERS, type AnswerRow } from './answers';
import { dropQuestions } from './help';
import {
  mayChangeDisplay,
  type BeginRun,
  type ChangeSource,
  type Command,
  type Question,
  type QuestionKind,
  type Report,
  type RunEvent,
  type SessionEvent,
  type TextCommand,
  type TriedValue,
  type Work,
} from '../protocol/protocol';
import type { LateParts, PartName, Waiter } from './parts';
import { copyText } from './copy-text';
import { describe } from './describe';
import { Drawing, type DrawRequest } from './drawing';
import { OldPicture } from './old-picture';
import { changePicture, fitAll, sectionScale, viewsState } from './pictures';
import { EMPTY_SETUP, SetupChange } from './setup-change';
import { SwitchSearch } from './switch-search';

const BLOCKS_PER_SLICE = 20_000;
/** A limit in case the user is away; otherwise the user can stop a run at any time. */
const RUN_LIMIT_MS = 60_000;
/** Motions whose material is removed before the time is checked, and how long the first report waits for the part. */
const MOTIONS_PER_SLICE = 20;
const WAIT_FOR_PART_MS = 8;
/** After this delay the path replaces the picture of the previous run, without the part. */
const SHOW_PATH_AFTER_MS = 300;
/** Parts are loaded after this delay even if no picture is drawn, as in a hidden tab. */
const LOAD_PARTS_AFTER_MS = 500;
/**
 * After this idle time a session releases its images, if it has at most `MAX_MOTIONS_TO_REPAINT` motions, which are
 * redrawn immediately.
 */
const RELEASE_IMAGES_AFTER_MS = 3_000;
const MAX_MOTIONS_TO_REPAINT = 4_000;
const PROGRESS_AFTER_MS = 150;
const PROGRESS_EVERY_MS = 100;

/** Start time of an activity, and of its last progress report. */
interface Timed {
  readonly startedAt: number;
  lastProgressAt: number;
}

/** The progress of the current run. */
type Stage =
  | ({ readonly kind: 'running' } & Timed)
  /** The run needs a part that is being loaded; nothing is drawn. */
  | { readonly kind: 'blocked' }
  /** The path is drawn; the parts that remove material and make messages are not loaded yet. */
  | { readonly kind: 'waiting' }
  /** Material is being removed; whether the path was reported and drawn before the part is complete. */
  | ({ readonly kind: 'machining'; pathReported: boolean; pathDrawn: boolean } & Timed)
  | { readonly kind: 'done' };

/** What the worker provides to a session. */
export interface Thread {
  /** Calls `nextSlice` after the messages that have arrived by then. */
  queue(): void;
  emit(event: SessionEvent, images: ImageBitmap[]): void;
  /** Runs a step; an exception is reported as a failure of this session. */
  runGuarded(step: () => void): void;
}

interface CommandRow<K extends Command['kind']> {
  /** `when-complete` keeps the old picture until the run is complete; moving the picture redraws it immediately. */
  readonly draws: DrawRequest;
  execute(session: Session, command: Extract<Command, { readonly kind: K }>): void;
}

const PICTURE_QUESTIONS: ReadonlySet<QuestionKind> = new Set<QuestionKind>(['pick', 'dimension', 'measure']);

/** Whether a message contains a setup, which the part `early` parses. */
export function mayNeedSetup(message: Command | Question): boolean {
  return message.kind === 'run' && message.setup !== undefined && message.setup !== EMPTY_SETUP;
}

export class Session implements Waiter {
  readonly #core: Playground;
  readonly #parts: LateParts<Session>;
  readonly #thread: Thread;
  #language: PartName = 'en';
  /** The number of the current run, as counted by the page. */
  #run = 0;
  #stage: Stage = { kind: 'done' };
  readonly #setup: SetupChange;
  readonly #switches: SwitchSearch;
  readonly #oldPicture: OldPicture;
  readonly #drawing: Drawing;
  /** A report waits for the texts of a language. */
  #reportPending = false;
  /** The number of received messages that may change the display, and its value when `settled` was last sent. */
  #receivedCount = 0;
  #settledAt = -1;
  /** Callbacks that wait until the part is complete. */
  readonly #completionCallbacks: (() => void)[] = [];
  #sliceQueued = false;
  #isClosed = false;
  #releaseTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(core: Playground, parts: LateParts<Session>, thread: Thread) {
    this.#core = core;
    this.#parts = parts;
    this.#thread = thread;
    this.#setup = new SetupChange(core, () => this.#isLoaded(['early']));
    this.#switches = new SwitchSearch(core);
    this.#oldPicture = new OldPicture(core);
    this.#drawing = new Drawing(core, {
      state: () => this.#drawingState,
      runGuarded: (step) => this.runGuarded(step),
      queueSlice: () => this.#queueSlice(),
      onDrawn: () => this.#onDrawn(),
      send: (pictures) => {
        this.#emit({ kind: 'pictures', pictures, scale: sectionScale(core) }, Object.values(pictures));
        this.#parts.release();
      },
    });
  }

  receive(message: Command | Question): void {
    this.runGuarded(() => this.#handle(message));
  }

  /** Runs the slice that `queue` has requested. */
  nextSlice(): void {
    this.#sliceQueued = false;
    this.runGuarded(() => this.#slice());
  }

  /** Runs a step; sends `settled` if nothing is left to do afterwards. */
  runGuarded(step: () => void): void {
    this.#thread.runGuarded(() => {
      if (this.#isClosed) return;
      step();
      this.#settle();
    });
  }

  onPartFailed(reason: unknown): void {
    const isNeeded = this.#stage.kind === 'blocked' || this.#stage.kind === 'waiting' || this.#reportPending;
    this.#emit({
      kind: 'part-failed',
      reason: describe(reason),
      neededFor: isNeeded ? 'the-report' : 'something-else',
    });
  }

  onPartsLoaded(): void {
    this.#emit({ kind: 'parts-loaded' });
  }

  /** The element was removed. */
  close(): void {
    this.#isClosed = true;
    clearTimeout(this.#releaseTimer);
    this.#stage = { kind: 'done' };
    this.#parts.remove(this);
    dropQuestions(this.#core);
    this.#core.free();
  }

  #handle(message: Command | Question): void {
    clearTimeout(this.#releaseTimer);
    if (mayChangeDisplay(message)) this.#receivedCount++;
    if (message.kind === 'question') {
      this.#answer(message);
      return;
    }
    const row = Session.#COMMANDS[message.kind] as CommandRow<Command['kind']>;
    row.execute(this, message);
    const old = this.#oldPicture.onCommand(message);
    if (old === 'kept') return;
    if (old === 'dropped') this.#drawing.request('now');
    if (row.draws !== 'no') this.#drawing.request(row.draws);
  }

  static readonly #COMMANDS: { readonly [K in Command['kind']]: CommandRow<K> } = {
    picture: {
      draws: 'now',
      execute: (session, { picture, command }) => changePicture(session.#core, picture, command),
    },
    palette: { draws: 'now', execute: (session, { palette }) => session.#core.setPalette(palette) },
    language: {
      draws: 'when-complete',
      execute(session, { tag }) {
        session.#language = tag;
        session.#core.setLanguage(tag);
        session.#repeatReport();
      },
    },
    unit: {
      draws: 'when-complete',
      execute(session, { unit }) {
        session.#core.setUnit(unit ?? '');
        session.#repeatReport();
      },
    },
    run: { draws: 'no', execute: (session, change) => session.#startRun(change) },
    shown: {
      draws: 'no',
      execute(session, { dropped }) {
        session.#oldPicture.onReceived(dropped);
        if (!dropped) return session.#drawing.onShown();
        session.#drawing.onDropped();
        if (!session.#oldPicture.isShown) session.#drawing.request('when-complete');
      },
    },
    stop: { draws: 'when-complete', execute: (session) => session.#stop() },
    'load-parts': { draws: 'no', execute: (session) => session.#parts.loadAll() },
    cursor: { draws: 'when-complete', execute: (session, { offset }) => session.#core.setCursor(offset) },
    hover: { draws: 'when-complete', execute: (session, { motion }) => session.#core.setHover(motion) },
    mark: {
      draws: 'when-complete',
      execute: (session, { lines }) =>
        session.#core.setMarkedLines(Uint32Array.from(lines.flatMap(({ firstLine, endLine }) => [firstLine, endLine]))),
    },
    frame: { draws: 'when-complete', execute: (session, { frame }) => session.#core.setFrame(frame ?? '') },
    turret: {
      draws: 'now',
      execute(session, { side }) {
        session.#core.setTurret(side ?? '');
        session.#emitViews();
      },
    },
    annotate: {
      draws: 'when-complete',
      execute(session, { choice }) {
        session.#core.setAnnotate(choice ?? '');
        session.#whenComplete(() => session.#annotate());
      },
    },
    measuring: {
      draws: 'now',
      execute: (session, { isOn }) => session.#core.setMeasuring(isOn),
    },
    'keep-part': {
      draws: 'when-complete',
      execute: (session) =>
        session.#whenComplete(() => {
          session.#core.keep();
          session.#emitViews();
        }),
    },
    'end-comparison': {
      draws: 'when-complete',
      execute(session) {
        session.#core.endComparison();
        session.#emitViews();
      },
    },
    'leave-edge': { draws: 'when-complete', execute: (session) => session.#core.leaveEdge() },
  };

  /** Sends the last report again, in another language or unit. */
  #repeatReport(): void {
    if (this.#isReported()) this.#report('repeated');
  }

  /** Makes the annotations that do not depend on an answer at the cursor. */
  #annotate(): void {
    if (this.#parts.has('late')) this.#core.annotate(false);
  }

  #emitViews(): void {
    // Before the first run there is nothing to show, and the part that reports it may not be loaded.
    if (this.#stage.kind === 'done' && this.#run > 0) this.#emit({ kind: 'views', views: viewsState(this.#core) });
  }

  #answer(question: Question): void {
    const row = ANSWERS[question.about] as AnswerRow<QuestionKind>;
    const needs = (): readonly PartName[] => {
      if (row.needs === undefined) return [];
      // These questions also need the parts that the run needs.
      const missing = this.#missingPart();
      return [
        ...(missing === undefined ? [] : [missing]),
        ...row.needs.map((part) => (part === 'language' ? this.#language : part)),
      ];
    };
    const answer = (): void => {
      if (!this.#isLoaded(needs())) return this.#whenLoaded(needs(), answer);
      // The strokes of this run are not in the old picture, so the pointer is over none of them.
      if (this.#oldPicture.isShown && PICTURE_QUESTIONS.has(question.about))
        return void this.#reply(question.id, undefined);
      if (row.draws !== undefined) this.#showCurrent();
      const value = row.answer(this.#core, question.args);
      void this.#reply(question.id, value);
      if (row.draws !== undefined) this.#drawing.request(row.draws);
      if (row.changesViews === true) this.#emitViews();
      if (row.annotates?.(question.args) === true) void this.#drawAnnotations(value);
    };
    if (row.waitsFor === undefined) answer();
    else this.#whenComplete(answer);
  }

  /** Draws the annotations that an answer has made; the picture of an earlier run has none. */
  async #drawAnnotations(answer: unknown): Promise<void> {
    await answer;
    if (!this.#oldPicture.isShown && !this.#isClosed) this.#drawing.request('when-complete');
  }

  #isLoaded(needs: readonly PartName[]): boolean {
    return this.#parts.has(...needs);
  }

  #whenLoaded(needs: readonly PartName[], callback: () => void): void {
    this.#parts.whenLoaded(this, needs, callback);
  }

  #whenComplete(callback: () => void): void {
    if (this.#stage.kind === 'done') callback();
    else this.#completionCallbacks.push(callback);
  }

  /** Sends an answer. A synchronous one is sent immediately, so that answers keep the order of their questions. */
  #reply(id: number, answer: unknown): void | Promise<void> {
    if (!(answer instanceof Promise)) return this.#emit({ kind: 'answer', id, answer });
    return answer.then((resolved: unknown) => this.#emit({ kind: 'answer', id, answer: resolved }));
  }

  // ---- from one run to the next ---------------------------------------------------------------------

  #startRun(change: BeginRun): void {
    this.#run = change.run;
    // Needed here, because a rejected setup does not start another run, and the tool would stay.
    this.#core.showWhole();
    if (change.framing === 'fit') fitAll(this.#core);
    if (change.setup !== undefined) this.#setup.set(change.setup);
    if (change.text !== undefined) this.#changeText(change.text, change.changeSource);
    this.#tryValues(change.tried);
    this.#core.setCursor(change.cursor);
    this.#oldPicture.onRunStarted(change);
    // A run in progress can only be drawn in part: keep the old picture until it is complete.
    this.#drawing.cancel();
    const missing = this.#missingPart();
    if (missing === undefined) this.#scheduleAdvance();
    else this.#waitForPart(missing);
  }

  /** The part that the run needs and that is not loaded yet, if any. */
  #missingPart(): PartName | undefined {
    const missing = this.#setup.isPending ? 'early' : (this.#core.missingPart() as PartName | undefined);
    return missing === undefined || this.#isLoaded([missing]) ? undefined : missing;
  }

  /** Suspends the run until a part is loaded; it is loaded even before the first picture. */
  #waitForPart(missing: PartName): void {
    this.#stage = { kind: 'blocked' };
    this.#whenLoaded([missing], () => {
      if (this.#stage.kind === 'blocked') this.#continueRun();
    });
    this.#parts.load(missing);
    this.#queueSlice();
  }

  #scheduleAdvance(): void {
    const now = performance.now();
    this.#stage = { kind: 'running', startedAt: now, lastProgressAt: now };
    this.#queueSlice();
  }

  /** Sets the tried values. Without any, now or before, the run continues unchanged. */
  #tryValues(tried: readonly TriedValue[]): void {
    const list = (of: (value: TriedValue) => number): Uint32Array => Uint32Array.from(tried, of);
    this.#core.tryValues(
      list(({ at }) => at),
      list(({ time }) => time),
      list(({ variable }) => variable),
      Float64Array.from(tried, ({ value }) => value),
    );
  }

  #changeText(text: TextCommand, changeSource: ChangeSource): void {
    if (text.kind === 'edit') {
      for (const change of text.changes) this.#switches.edit(change);
      if (changeSource === 'inserted') this.#core.decideDecimalRule();
    } else {
      copyText(this.#core, text.pieces);
      this.#switches.start();
    }
  }

  /** Searches the next lines; a short text is searched in one go. */
  #searchSwitches(): void {
    const found = this.#switches.searchMore();
    // A pending report will contain them.
    if (found !== undefined && this.#isReported()) this.#emit({ kind: 'switches', inText: found });
  }

  // ---- the run --------------------------------------------------------------------------------------

  #stop(): void {
    if (this.#stage.kind === 'machining') {
      this.#core.stopMachining();
      this.#removeMaterial(this.#stage);
    } else if (this.#stage.kind === 'running') {
      this.#core.stop(Math.round((performance.now() - this.#stage.startedAt) / 100) / 10);
      this.#end();
    }
  }

  #queueSlice(): void {
    if (this.#sliceQueued) return;
    this.#sliceQueued = true;
    this.#thread.queue();
  }

  #slice(): void {
    if (this.#stage.kind === 'running') this.#advance(this.#stage);
    else if (this.#drawing.isInProgress) this.#drawing.draw();
    else if (this.#stage.kind === 'machining') this.#removeMaterial(this.#stage);
    else this.#searchSwitches();
    if (
      this.#stage.kind === 'running' ||
      this.#stage.kind === 'machining' ||
      this.#drawing.isInProgress ||
      this.#switches.isInProgress
    )
      this.#queueSlice();
  }

  #advance(timed: Timed): void {
    const ended = this.#core.advance(BLOCKS_PER_SLICE);
    const now = performance.now();
    if (ended) this.#end();
    else if (now - timed.startedAt > RUN_LIMIT_MS) this.#stop();
    else this.#emitProgress(timed, 'run', () => this.#core.progress());
  }

  #emitProgress(timed: Timed, work: Work, done: () => number): void {
    const now = performance.now();
    if (now - timed.startedAt <= PROGRESS_AFTER_MS || now - timed.lastProgressAt <= PROGRESS_EVERY_MS) return;
    timed.lastProgressAt = now;
    this.#emit({ kind: 'progress', work, done: done() });
  }

  #end(): void {
    this.#searchSwitches();
    const missing = this.#missingPart();
    if (missing !== undefined) return this.#waitForPart(missing);
    if (this.#isLoaded(['late', this.#language]) || this.#core.missingPart() !== undefined) return this.#continueRun();
    this.#oldPicture.drop();
    this.#stage = { kind: 'waiting' };
    this.#emit({ kind: 'path', summary: this.#core.summary() });
    this.#drawing.request('now');
    setTimeout(() => this.#parts.release(), LOAD_PARTS_AFTER_MS);
    this.#whenLoaded(['late', this.#language], () => {
      if (this.#stage.kind === 'waiting') this.#continueRun();
    });
  }

  /** Runs again if parts were loaded for it; otherwise continues after the path. */
  #continueRun(): void {
    const hasSetup = this.#setup.applyPending();
    if (this.#core.beginAgain() || hasSetup) this.#scheduleAdvance();
    else this.#startMachining();
  }

  #startMachining(): void {
    const now = performance.now();
    const of = this.#oldPicture.choose();
    if (of !== undefined) this.#emit({ kind: 'old-picture', of });
    const machining: Stage & { kind: 'machining' } = {
      kind: 'machining',
      pathReported: false,
      pathDrawn: false,
      startedAt: now,
      lastProgressAt: now,
    };
    this.#stage = machining;
    this.#removeMaterial(machining);
  }

  /** Removes more material. Part and collisions are complete when all of it is removed. */
  #removeMaterial(machining: Stage & { kind: 'machining' }): void {
    const deadline = performance.now() + WAIT_FOR_PART_MS;
    let done = false;
    do done = this.#core.removeMaterial(MOTIONS_PER_SLICE);
    while (!done && performance.now() < deadline);
    if (done) {
      this.#stage = { kind: 'done' };
      this.#annotate();
      for (const callback of this.#completionCallbacks.splice(0)) callback();
      this.#report(machining.pathReported ? 'part' : 'whole');
      if (!this.#oldPicture.isShown) this.#drawing.request('now');
      return;
    }
    // If the part takes longer than `WAIT_FOR_PART_MS`, report the path first.
    if (!machining.pathReported) {
      machining.pathReported = true;
      this.#report('path');
    }
    if (
      !this.#oldPicture.isShown &&
      !machining.pathDrawn &&
      performance.now() - machining.startedAt > SHOW_PATH_AFTER_MS
    )
      this.#drawing.request('now');
    this.#emitProgress(machining, 'part', () => this.#core.machiningProgress());
    this.#queueSlice();
  }

  /** Whether the current run was reported. */
  #isReported(): boolean {
    return this.#stage.kind === 'done' ? this.#run > 0 : this.#stage.kind === 'machining' && this.#stage.pathReported;
  }

  /** Reports the run once the texts of the language are loaded, which may have changed during the run. */
  #report(stage: Report['stage']): void {
    const needs = ['late', this.#language] as const;
    if (this.#isLoaded(needs)) return this.#emitReport(stage);
    const run = this.#run;
    this.#reportPending = true;
    this.#whenLoaded(needs, () => {
      this.#reportPending = false;
      if (run === this.#run && this.#isReported()) this.#report(stage);
    });
  }

  #emitReport(stage: Report['stage']): void {
    this.#emit({
      kind: 'report',
      report: {
        summary: this.#core.summary(),
        diagnostics: this.#core.diagnostics(),
        overview: this.#core.setupOverview(),
        readAs: this.#core.readAs(),
        rulesOff: this.#core.rulesOff(),
        units: this.#core.units(),
        decimal: this.#core.decimalNotice(),
        stage,
        setupRejected: this.#setup.rejected,
        views: this.#stage.kind === 'done' ? viewsState(this.#core) : undefined,
        switches: this.#switches.found,
      },
    });
  }

  // ---- the rest -------------------------------------------------------------------------------------

  get #drawingState(): 'blocked' | 'incomplete' | 'complete' {
    const stage = this.#stage;
    if (stage.kind === 'blocked') return 'blocked';
    const isComplete =
      stage.kind === 'done' || stage.kind === 'waiting' || (stage.kind === 'machining' && stage.pathDrawn);
    return isComplete ? 'complete' : 'incomplete';
  }

  #onDrawn(): void {
    if (this.#stage.kind === 'machining') this.#stage.pathDrawn = true;
    if (this.#stage.kind !== 'running') this.#oldPicture.onDrawn(this.#run);
  }

  /** Replaces an old picture by that of the current run. */
  #showCurrent(): void {
    if (!this.#oldPicture.isShown) return;
    this.#oldPicture.drop();
    this.#drawing.request('now');
  }

  /** Sends an event with the number of the run. */
  #emit(event: RunEvent, images: ImageBitmap[] = []): void {
    if (!this.#isClosed) this.#thread.emit({ ...event, run: this.#run }, images);
  }

  /** Sends `settled` if nothing is left to do and the page has shown all pictures. */
  #settle(): void {
    const isWaiting = this.#stage.kind === 'waiting' || this.#stage.kind === 'blocked';
    const isRunning = isWaiting ? !this.#parts.failed : this.#stage.kind !== 'done';
    const busy =
      isRunning || (this.#reportPending && !this.#parts.failed) || this.#drawing.isBusy || this.#switches.isInProgress;
    if (busy || this.#settledAt === this.#receivedCount) return;
    this.#settledAt = this.#receivedCount;
    this.#emit({ kind: 'settled', received: this.#receivedCount });
    this.#releaseTimer = setTimeout(() => this.runGuarded(() => this.#releaseImages()), RELEASE_IMAGES_AFTER_MS);
  }

  #releaseImages(): void {
    const [motions = 0] = this.#core.motionsAndErrors();
    if (motions <= MAX_MOTIONS_TO_REPAINT) this.#core.releaseImages();
  }
}
