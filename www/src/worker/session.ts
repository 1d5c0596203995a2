// The session of one element in the worker: owns a `Playground`, its text and the canvas it draws on.
//
// In: commands and questions of protocol.ts. Out: events, each with the number of its run; all are sent by `#emit`. A
// program runs in slices, and messages are processed between them, so a newer text ends an older run immediately, and
// no session waits long for another. Pictures are sent as images, one at a time: the next one is sent after the page
// has shown the last, so "settled" refers to the pictures on the page. Must not know: the page, other sessions, or the
// meaning of the program.

import { Drawn, type Playground } from '../../pkg/gcode_playground.js';
import { ANSWERS, type AnswerRow } from './answers';
import { dropQuestions } from './help';
import { mayContainSwitches, SwitchFinder } from './switches-in-text';
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
  type SwitchesInText,
  type TextChange,
  type TextCommand,
  type TriedValue,
  type Work,
} from '../protocol/protocol';
import type { LateParts, PartName, Waiter } from './parts';
import { copyText } from './copy-text';
import { changePicture, drawAll, fitAll, sectionScale, takePictures, viewsState } from './pictures';

/** The only setup that does not need the part `early`. */
const EMPTY_SETUP = '{}';
const BLOCKS_PER_SLICE = 20_000;
/** A limit in case the user is away; otherwise the user can stop a run at any time. */
const RUN_LIMIT_MS = 60_000;
/** Lines searched for switches in one slice. */
const LINES_PER_SLICE = 20_000;
/** After a longer change, the whole text is searched for switches. */
const FULL_SEARCH_ABOVE = 100_000;
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

/** The run of a picture, and its counts. */
interface PictureInfo {
  readonly run: number;
  readonly motions: number;
  readonly errors: number;
}

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

/** Whether to draw a picture: when the run is complete, or immediately. */
type DrawRequest = 'no' | 'when-complete' | 'now';

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

const PICTURE_QUESTIONS: ReadonlySet<QuestionKind> = new Set<QuestionKind>(['pick', 'dimension']);

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
  /** Why the last setup was rejected. */
  #setupRejected: string | undefined;
  /** A setup that waits for the part `early`. */
  #pendingSetup: string | undefined;
  /** The search for switches in the text; undefined once it is complete. */
  #switchSearch: { readonly finder: SwitchFinder; nextLine: number } | undefined;
  #switches: SwitchesInText | undefined;
  #drawRequest: DrawRequest = 'no';
  #frameRequested = false;
  /** A picture with very many strokes is being drawn in slices. */
  #isDrawing = false;
  /** The page has not shown the last picture yet. */
  #pictureInFlight = false;
  /** The last picture of a complete path. */
  #lastPicture: PictureInfo | undefined;
  /**
   * The line in which the current run was typed; undefined if its text changed otherwise, or the cursor has left the
   * line.
   */
  #typedLine: number | undefined;
  /** The page shows the picture of an earlier run, while the cursor stays in this line. */
  #oldPicture: { readonly line: number } | undefined;
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
    // The user may leave the line while its run is in progress.
    if (this.#typedLine !== undefined && this.#leavesLine(message, this.#typedLine)) this.#typedLine = undefined;
    if (this.#oldPicture !== undefined && this.#keepsOldPicture(message, this.#oldPicture.line)) return;
    if (row.draws !== 'no') this.#requestDraw(row.draws);
  }

  /**
   * Whether the user has left the line or moved the picture. A resize is not a move: the messages of a new run can
   * cause it.
   */
  #leavesLine(message: Command, line: number): boolean {
    if (message.kind === 'cursor') return message.offset === undefined || this.#core.lineAt(message.offset) !== line;
    return message.kind === 'picture' && message.command.kind !== 'resize' && message.command.kind !== 'repaint';
  }

  /** Whether the old picture stays after this message. */
  #keepsOldPicture(message: Command, line: number): boolean {
    switch (message.kind) {
      case 'cursor':
      case 'picture':
        return this.#leavesLine(message, line) ? this.#showCurrent() : true;
      case 'run':
      case 'shown':
      case 'hover':
      case 'leave-edge':
      case 'load-parts':
      case 'stop':
        return true;
      case 'palette':
      case 'language':
      case 'unit':
      case 'turret':
      case 'mark':
      case 'frame':
      case 'keep-part':
      case 'end-comparison':
        return this.#showCurrent();
    }
  }

  /** Replaces an old picture by that of the current run. */
  #showCurrent(): false {
    this.#oldPicture = undefined;
    this.#requestDraw('now');
    return false;
  }

  /**
   * A block that is being typed is often incomplete, and a faulty contour is not cut at all. Then the previous picture
   * is more useful than an empty one: it stays while this run has more errors and fewer motions.
   */
  #keepOldPictureIfBetter(): void {
    this.#oldPicture = undefined;
    if (this.#typedLine === undefined || this.#lastPicture === undefined) return;
    const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
    if (motions >= this.#lastPicture.motions || errors <= this.#lastPicture.errors) return;
    this.#oldPicture = { line: this.#typedLine };
    this.#emit({ kind: 'old-picture', of: this.#lastPicture.run });
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
        session.#pictureInFlight = false;
        if (dropped) {
          // Paint again: if nothing has changed since, no other picture would follow the dropped one.
          session.#core.paintAgain();
          if (session.#oldPicture === undefined) session.#requestDraw('when-complete');
        } else session.#sendPictures();
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
      if (this.#oldPicture !== undefined && PICTURE_QUESTIONS.has(question.about))
        return void this.#reply(question.id, undefined);
      if (this.#oldPicture !== undefined && row.draws !== undefined) this.#showCurrent();
      void this.#reply(question.id, row.answer(this.#core, question.args));
      if (row.draws !== undefined) this.#requestDraw(row.draws);
    };
    if (row.waitsFor === undefined) answer();
    else this.#whenComplete(answer);
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
    this.#typedLine = undefined;
    if (change.setup !== undefined) this.#changeSetup(change.setup);
    if (change.text !== undefined) this.#changeText(change.text, change.changeSource);
    this.#tryValues(change.tried);
    this.#core.setCursor(change.cursor);
    this.#typedLine = this.#findTypedLine(change);
    // A run in progress can only be drawn in part: keep the old picture until it is complete.
    this.#isDrawing = false;
    this.#drawRequest = 'no';
    const missing = this.#missingPart();
    if (missing === undefined) this.#scheduleAdvance();
    else this.#waitForPart(missing);
  }

  /** The line that the user is typing in, if the run has a single typed change in the line of the cursor. */
  #findTypedLine({ setup, text, changeSource, framing, cursor }: BeginRun): number | undefined {
    if (
      setup !== undefined ||
      text?.kind !== 'edit' ||
      text.changes.length !== 1 ||
      changeSource !== 'typed' ||
      framing === 'fit' ||
      cursor === undefined
    )
      return undefined;
    const [change] = text.changes;
    const line = this.#core.lineAt(cursor);
    return change !== undefined && this.#core.lineAt(change.from) === line ? line : undefined;
  }

  /** The part that the run needs and that is not loaded yet, if any. */
  #missingPart(): PartName | undefined {
    const missing = this.#pendingSetup === undefined ? (this.#core.missingPart() as PartName | undefined) : 'early';
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

  #changeSetup(json: string): void {
    this.#pendingSetup = undefined;
    if (json !== EMPTY_SETUP && !this.#isLoaded(['early'])) {
      this.#pendingSetup = json;
      return;
    }
    try {
      this.#core.setSetup(json);
      this.#setupRejected = undefined;
    } catch (reason) {
      if (reason instanceof WebAssembly.RuntimeError) throw reason;
      this.#setupRejected = describe(reason);
    }
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
      for (const change of text.changes) this.#edit(change);
      if (changeSource === 'inserted') this.#core.decideDecimalRule();
    } else {
      copyText(this.#core, text.pieces);
      this.#startSwitchSearch();
    }
  }

  #edit({ from, to, insert }: TextChange): void {
    // The edit may move lines that were not searched yet: then search the whole text again.
    const searchAll =
      this.#switchSearch !== undefined || to - from > FULL_SEARCH_ABOVE || insert.length > FULL_SEARCH_ABOVE;
    const changedLines = (end: number): string =>
      this.#core.linesAsWritten(this.#core.lineAt(from), this.#core.lineAt(end) + 1);
    const oldLines = searchAll ? '' : changedLines(to);
    this.#core.edit(from, to, insert);
    if (searchAll || mayContainSwitches(oldLines) || mayContainSwitches(changedLines(from + insert.length)))
      this.#startSwitchSearch();
  }

  #startSwitchSearch(): void {
    this.#switches = undefined;
    this.#switchSearch = { finder: new SwitchFinder(), nextLine: 0 };
  }

  /** Searches the next lines; a short text is searched in one go. */
  #searchMoreLines(): void {
    if (this.#switchSearch === undefined) return;
    const { finder, nextLine } = this.#switchSearch;
    const lines = this.#core.linesAsWritten(nextLine, nextLine + LINES_PER_SLICE);
    finder.search(lines);
    this.#switchSearch.nextLine += LINES_PER_SLICE;
    if (this.#core.linesAsWritten(this.#switchSearch.nextLine, this.#switchSearch.nextLine + 1) !== '') return;
    this.#switchSearch = undefined;
    this.#switches = finder.found;
    // A pending report will contain them.
    if (this.#isReported()) this.#emit({ kind: 'switches', inText: this.#switches });
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
    else if (this.#isDrawing) this.#draw();
    else if (this.#stage.kind === 'machining') this.#removeMaterial(this.#stage);
    else this.#searchMoreLines();
    if (
      this.#stage.kind === 'running' ||
      this.#stage.kind === 'machining' ||
      this.#isDrawing ||
      this.#switchSearch !== undefined
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
    this.#searchMoreLines();
    const missing = this.#missingPart();
    if (missing !== undefined) return this.#waitForPart(missing);
    if (this.#isLoaded(['late', this.#language]) || this.#core.missingPart() !== undefined) return this.#continueRun();
    this.#oldPicture = undefined;
    this.#stage = { kind: 'waiting' };
    this.#emit({ kind: 'path', summary: this.#core.summary() });
    this.#requestDraw('now');
    setTimeout(() => this.#parts.release(), LOAD_PARTS_AFTER_MS);
    this.#whenLoaded(['late', this.#language], () => {
      if (this.#stage.kind === 'waiting') this.#continueRun();
    });
  }

  /** Runs again if parts were loaded for it; otherwise continues after the path. */
  #continueRun(): void {
    const setup = this.#pendingSetup;
    if (setup !== undefined) this.#changeSetup(setup);
    if (this.#core.beginAgain() || setup !== undefined) this.#scheduleAdvance();
    else this.#startMachining();
  }

  #startMachining(): void {
    const now = performance.now();
    this.#keepOldPictureIfBetter();
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
      for (const callback of this.#completionCallbacks.splice(0)) callback();
      this.#report(machining.pathReported ? 'part' : 'whole');
      if (this.#oldPicture === undefined) this.#requestDraw('now');
      return;
    }
    // If the part takes longer than `WAIT_FOR_PART_MS`, report the path first.
    if (!machining.pathReported) {
      machining.pathReported = true;
      this.#report('path');
    }
    if (
      this.#oldPicture === undefined &&
      !machining.pathDrawn &&
      performance.now() - machining.startedAt > SHOW_PATH_AFTER_MS
    )
      this.#requestDraw('now');
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
        setupRejected: this.#setupRejected,
        views: this.#stage.kind === 'done' ? viewsState(this.#core) : undefined,
        switches: this.#switches,
      },
    });
  }

  // ---- the rest -------------------------------------------------------------------------------------

  #requestDraw(request: Exclude<DrawRequest, 'no'>): void {
    if (this.#drawRequest !== 'now') this.#drawRequest = request;
    if (this.#frameRequested) return;
    this.#frameRequested = true;
    requestAnimationFrame(() => {
      this.#frameRequested = false;
      const pendingRequest = this.#drawRequest;
      this.#drawRequest = 'no';
      const ready =
        this.#stage.kind === 'done' ||
        this.#stage.kind === 'waiting' ||
        (this.#stage.kind === 'machining' && this.#stage.pathDrawn);
      this.runGuarded(() => {
        if (this.#stage.kind === 'blocked') this.#drawRequest = pendingRequest;
        else if (pendingRequest === 'now' || (pendingRequest === 'when-complete' && ready)) this.#draw();
      });
    });
  }

  #draw(): void {
    if (this.#stage.kind === 'machining') this.#stage.pathDrawn = true;
    const drawn = drawAll(this.#core);
    this.#isDrawing = drawn === Drawn.Part;
    if (this.#stage.kind !== 'running') {
      const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
      this.#lastPicture = { run: this.#run, motions, errors };
    }
    if (this.#isDrawing) this.#queueSlice();
    if (drawn === Drawn.Moved) this.#requestDraw('now');
    this.#sendPictures();
  }

  /** Sends the painted images, unless the page has not shown the last ones yet. */
  #sendPictures(): void {
    if (this.#pictureInFlight) return;
    const pictures = takePictures(this.#core);
    if (pictures === undefined) return;
    this.#pictureInFlight = true;
    this.#emit({ kind: 'pictures', pictures, scale: sectionScale(this.#core) }, Object.values(pictures));
    this.#parts.release();
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
      isRunning ||
      (this.#reportPending && !this.#parts.failed) ||
      this.#isDrawing ||
      (this.#drawRequest !== 'no' && this.#stage.kind !== 'blocked') ||
      this.#pictureInFlight ||
      this.#switchSearch !== undefined;
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

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
