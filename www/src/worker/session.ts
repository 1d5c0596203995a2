// The session of one element in the worker: owns a `Playground`, its text and the canvas it draws on.
//
// In: commands and questions of protocol.ts. Out: events, each with the number of its run; all are sent by `#tell`. A
// program runs in slices, and messages are processed between them, so a newer text ends an older run immediately, and
// no session waits long for another. Pictures are sent as images, one at a time: the next one is sent after the page
// has shown the last, so "settled" refers to the pictures on the page. Must not know: the page, other sessions, or the
// meaning of the program.

import { Drawn, type Playground } from '../../pkg/gcode_playground.js';
import { ANSWERS, type AnswerRow } from './answers';
import { forget } from './help';
import { mayTellOfSwitches, SwitchFinder } from './switches-in-text';
import {
  counts,
  type BeginRun,
  type Came,
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
import { handIn } from './text-in';
import { changePicture, drawAll, fitAll, takePictures, viewsState } from './pictures';

/** The only setup that does not need the part `early`. */
const NO_SETUP = '{}';
const BLOCKS_PER_SLICE = 20_000;
/** A limit in case the user is away; otherwise the user can stop a run at any time. */
const RUN_LIMIT_MS = 60_000;
/** Lines searched for switches in one slice. */
const LINES_PER_LOOK = 20_000;
/** After a longer change, the whole text is searched for switches. */
const LOOK_LIMIT = 100_000;
/** Motions whose material is removed before the time is checked, and how long the first report waits for the part. */
const MOTIONS_PER_SLICE = 20;
const WAIT_FOR_PART_MS = 8;
/** After this delay the path replaces the picture of the previous run, without the part. */
const SHOW_PATH_AFTER_MS = 300;
/** Parts are loaded after this delay even if no picture is drawn, as in a hidden tab. */
const LOAD_PARTS_AFTER_MS = 500;
/**
 * After this idle time a session releases its images, if it has at most `MOST_TO_PAINT_AT_ONCE` motions, which are
 * redrawn immediately.
 */
const REST_AFTER_MS = 3_000;
const MOST_TO_PAINT_AT_ONCE = 4_000;
const PROGRESS_AFTER_MS = 150;
const PROGRESS_EVERY_MS = 100;

/** The run of a picture, and its counts. */
interface Pictured {
  readonly run: number;
  readonly motions: number;
  readonly errors: number;
}

/** Start time of an activity, and of its last progress report. */
interface Going {
  readonly startedAt: number;
  lastProgressAt: number;
}

/** The progress of the current run. */
type Stage =
  | ({ readonly kind: 'running' } & Going)
  /** The run needs a part that is being loaded; nothing is drawn. */
  | { readonly kind: 'lacking' }
  /** The path is drawn; the parts that remove material and make messages are not loaded yet. */
  | { readonly kind: 'waiting' }
  /** Material is being removed; whether the path was reported and drawn before the part is complete. */
  | ({ readonly kind: 'machining'; pathTold: boolean; pathShown: boolean } & Going)
  | { readonly kind: 'done' };

/** Whether to draw a picture: when the run is complete, or immediately. */
type Wanted = 'no' | 'when-whole' | 'now';

/** What the worker provides to a session. */
export interface Thread {
  /** Calls `nextSlice` after the messages that have arrived by then. */
  queue(): void;
  tell(event: SessionEvent, images: ImageBitmap[]): void;
  /** Runs a step; an exception is reported as a failure of this session. */
  guarded(step: () => void): void;
}

interface CommandRow<K extends Command['kind']> {
  /** `when-whole` keeps the old picture until the run is complete; moving the picture redraws it immediately. */
  readonly draws: Wanted;
  act(session: Session, command: Extract<Command, { readonly kind: K }>): void;
}

const OF_THE_PICTURE: ReadonlySet<QuestionKind> = new Set<QuestionKind>(['pick', 'dimension']);

/** Whether a message contains a setup, which the part `early` parses. */
export function mayNeedSetup(message: Command | Question): boolean {
  return message.kind === 'run' && message.setup !== undefined && message.setup !== NO_SETUP;
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
  #unreadSetup: string | undefined;
  /** The search for switches in the text; undefined once it is complete. */
  #looking: { readonly finder: SwitchFinder; nextLine: number } | undefined;
  #switches: SwitchesInText | undefined;
  #drawWanted: Wanted = 'no';
  #frameAsked = false;
  /** A picture with very many strokes is being drawn in slices. */
  #drawing = false;
  /** The page has not shown the last picture yet. */
  #onTheWay = false;
  /** The last picture of a complete path. */
  #pictured: Pictured | undefined;
  /**
   * The line in which the current run was typed; undefined if its text changed otherwise, or the cursor has left the
   * line.
   */
  #typedLine: number | undefined;
  /** The page shows the picture of an earlier run, while the cursor stays in this line. */
  #keepsOld: { readonly line: number } | undefined;
  /** A report waits for the texts of a language. */
  #reportsLate = false;
  /** The number of received messages that may change the display, and its value when `settled` was last sent. */
  #heard = 0;
  #settledAt = -1;
  /** Callbacks that wait until the part is complete. */
  readonly #onceWhole: (() => void)[] = [];
  #sliceQueued = false;
  #closed = false;
  #rest: ReturnType<typeof setTimeout> | undefined;

  constructor(core: Playground, parts: LateParts<Session>, thread: Thread) {
    this.#core = core;
    this.#parts = parts;
    this.#thread = thread;
  }

  hear(message: Command | Question): void {
    this.guarded(() => this.#receive(message));
  }

  /** Runs the slice that `queue` has requested. */
  nextSlice(): void {
    this.#sliceQueued = false;
    this.guarded(() => this.#slice());
  }

  /** Runs a step; sends `settled` if nothing is left to do afterwards. */
  guarded(step: () => void): void {
    this.#thread.guarded(() => {
      if (this.#closed) return;
      step();
      this.#settle();
    });
  }

  partFailed(reason: unknown): void {
    const isNeeded = this.#stage.kind === 'lacking' || this.#stage.kind === 'waiting' || this.#reportsLate;
    this.#tell({
      kind: 'part-failed',
      reason: describe(reason),
      neededFor: isNeeded ? 'the-report' : 'something-else',
    });
  }

  partsLoaded(): void {
    this.#tell({ kind: 'parts-loaded' });
  }

  /** The element was removed. */
  close(): void {
    this.#closed = true;
    clearTimeout(this.#rest);
    this.#stage = { kind: 'done' };
    this.#parts.leave(this);
    forget(this.#core);
    this.#core.free();
  }

  #receive(message: Command | Question): void {
    clearTimeout(this.#rest);
    if (counts(message)) this.#heard++;
    if (message.kind === 'question') {
      this.#ask(message);
      return;
    }
    const row = Session.#COMMANDS[message.kind] as CommandRow<Command['kind']>;
    row.act(this, message);
    // The user may leave the line while its run is in progress.
    if (this.#typedLine !== undefined && this.#leaves(message, this.#typedLine)) this.#typedLine = undefined;
    if (this.#keepsOld !== undefined && this.#oldPictureStays(message, this.#keepsOld.line)) return;
    if (row.draws !== 'no') this.#wantDraw(row.draws);
  }

  /**
   * Whether the user has left the line or moved the picture. A resize is not a move: the messages of a new run can
   * cause it.
   */
  #leaves(message: Command, line: number): boolean {
    if (message.kind === 'cursor') return message.offset === undefined || this.#core.lineAt(message.offset) !== line;
    return message.kind === 'picture' && message.what.kind !== 'resize' && message.what.kind !== 'paint-again';
  }

  /** Whether the old picture stays after this message. */
  #oldPictureStays(message: Command, line: number): boolean {
    switch (message.kind) {
      case 'cursor':
      case 'picture':
        return this.#leaves(message, line) ? this.#showCurrent() : true;
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
      case 'keep':
      case 'end-comparison':
        return this.#showCurrent();
    }
  }

  /** Replaces an old picture by that of the current run. */
  #showCurrent(): false {
    this.#keepsOld = undefined;
    this.#wantDraw('now');
    return false;
  }

  /**
   * A block that is being typed is often incomplete, and a faulty contour is not cut at all. Then the previous picture
   * is more useful than an empty one: it stays while this run has more errors and fewer motions.
   */
  #mayKeepOldPicture(): void {
    this.#keepsOld = undefined;
    if (this.#typedLine === undefined || this.#pictured === undefined) return;
    const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
    if (motions >= this.#pictured.motions || errors <= this.#pictured.errors) return;
    this.#keepsOld = { line: this.#typedLine };
    this.#tell({ kind: 'old-picture', of: this.#pictured.run });
  }

  static readonly #COMMANDS: { readonly [K in Command['kind']]: CommandRow<K> } = {
    picture: { draws: 'now', act: (session, { picture, what }) => changePicture(session.#core, picture, what) },
    palette: { draws: 'now', act: (session, { palette }) => session.#core.setPalette(palette) },
    language: {
      draws: 'when-whole',
      act(session, { tag }) {
        session.#language = tag;
        session.#core.setLanguage(tag);
        session.#reportAgain();
      },
    },
    unit: {
      draws: 'when-whole',
      act(session, { unit }) {
        session.#core.setUnit(unit ?? '');
        session.#reportAgain();
      },
    },
    run: { draws: 'no', act: (session, change) => session.#begin(change) },
    shown: {
      draws: 'no',
      act(session, { dropped }) {
        session.#onTheWay = false;
        if (dropped) {
          // Paint again: if nothing has changed since, no other picture would follow the dropped one.
          session.#core.paintAgain();
          if (session.#keepsOld === undefined) session.#wantDraw('when-whole');
        } else session.#present();
      },
    },
    stop: { draws: 'when-whole', act: (session) => session.#stop() },
    'load-parts': { draws: 'no', act: (session) => session.#parts.loadAll() },
    cursor: { draws: 'when-whole', act: (session, { offset }) => session.#core.setCursor(offset) },
    hover: { draws: 'when-whole', act: (session, { motion }) => session.#core.setHover(motion) },
    mark: {
      draws: 'when-whole',
      act: (session, { lines }) =>
        session.#core.setMarkedLines(Uint32Array.from(lines.flatMap(({ firstLine, endLine }) => [firstLine, endLine]))),
    },
    frame: { draws: 'when-whole', act: (session, { frame }) => session.#core.setFrame(frame ?? '') },
    turret: {
      draws: 'now',
      act(session, { side }) {
        session.#core.setTurret(side ?? '');
        session.#tellViews();
      },
    },
    keep: {
      draws: 'when-whole',
      act: (session) =>
        session.#whenWhole(() => {
          session.#core.keep();
          session.#tellViews();
        }),
    },
    'end-comparison': {
      draws: 'when-whole',
      act(session) {
        session.#core.endComparison();
        session.#tellViews();
      },
    },
    'leave-edge': { draws: 'when-whole', act: (session) => session.#core.leaveEdge() },
  };

  /** Sends the last report again, in another language or unit. */
  #reportAgain(): void {
    if (this.#isTold()) this.#report('again');
  }

  #tellViews(): void {
    // Before the first run there is nothing to show, and the part that reports it may not be loaded.
    if (this.#stage.kind === 'done' && this.#run > 0) this.#tell({ kind: 'views', views: viewsState(this.#core) });
  }

  #ask(question: Question): void {
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
    const now = (): void => {
      if (!this.#isLoaded(needs())) return this.#whenLoaded(needs(), now);
      // The strokes of this run are not in the old picture, so the pointer is over none of them.
      if (this.#keepsOld !== undefined && OF_THE_PICTURE.has(question.about))
        return void this.#reply(question.id, undefined);
      if (this.#keepsOld !== undefined && row.draws !== undefined) this.#showCurrent();
      void this.#reply(question.id, row.answer(this.#core, question.ask));
      if (row.draws !== undefined) this.#wantDraw(row.draws);
    };
    if (row.waits === undefined) now();
    else this.#whenWhole(now);
  }

  #isLoaded(needs: readonly PartName[]): boolean {
    return this.#parts.has(...needs);
  }

  #whenLoaded(needs: readonly PartName[], act: () => void): void {
    this.#parts.whenLoaded(this, needs, act);
  }

  #whenWhole(act: () => void): void {
    if (this.#stage.kind === 'done') act();
    else this.#onceWhole.push(act);
  }

  /** Sends an answer. A synchronous one is sent immediately, so that answers keep the order of their questions. */
  #reply(id: number, answer: unknown): void | Promise<void> {
    if (!(answer instanceof Promise)) return this.#tell({ kind: 'answer', id, answer });
    return answer.then((late: unknown) => this.#tell({ kind: 'answer', id, answer: late }));
  }

  // ---- from one run to the next ---------------------------------------------------------------------

  #begin(change: BeginRun): void {
    this.#run = change.run;
    // Needed here, because a rejected setup does not start another run, and the tool would stay.
    this.#core.showWhole();
    if (change.framing === 'fit') fitAll(this.#core);
    this.#typedLine = undefined;
    if (change.setup !== undefined) this.#changeSetup(change.setup);
    if (change.text !== undefined) this.#changeText(change.text, change.came);
    this.#tryValues(change.tried);
    this.#core.setCursor(change.cursor);
    this.#typedLine = this.#lineTyped(change);
    // A run in progress can only be drawn in part: keep the old picture until it is complete.
    this.#drawing = false;
    this.#drawWanted = 'no';
    const missing = this.#missingPart();
    if (missing === undefined) this.#advanceSoon();
    else this.#waitFor(missing);
  }

  /** The line that the user is typing in, if the run has a single typed change in the line of the cursor. */
  #lineTyped({ setup, text, came, framing, cursor }: BeginRun): number | undefined {
    if (
      setup !== undefined ||
      text?.kind !== 'edit' ||
      text.changes.length !== 1 ||
      came !== 'typed' ||
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
    const missing = this.#unreadSetup === undefined ? (this.#core.missingPart() as PartName | undefined) : 'early';
    return missing === undefined || this.#isLoaded([missing]) ? undefined : missing;
  }

  /** Suspends the run until a part is loaded; it is loaded even before the first picture. */
  #waitFor(missing: PartName): void {
    this.#stage = { kind: 'lacking' };
    this.#whenLoaded([missing], () => {
      if (this.#stage.kind === 'lacking') this.#goOn();
    });
    this.#parts.load(missing);
    this.#queueSlice();
  }

  #advanceSoon(): void {
    const now = performance.now();
    this.#stage = { kind: 'running', startedAt: now, lastProgressAt: now };
    this.#queueSlice();
  }

  #changeSetup(json: string): void {
    this.#unreadSetup = undefined;
    if (json !== NO_SETUP && !this.#isLoaded(['early'])) {
      this.#unreadSetup = json;
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

  #changeText(text: TextCommand, came: Came): void {
    if (text.kind === 'edit') {
      for (const change of text.changes) this.#edit(change);
      if (came === 'at-once') this.#core.decideDecimalRule();
    } else {
      handIn(this.#core, text.pieces);
      this.#lookForSwitches();
    }
  }

  #edit({ from, to, insert }: TextChange): void {
    // The edit may move lines that were not searched yet: then search the whole text again.
    const anew = this.#looking !== undefined || to - from > LOOK_LIMIT || insert.length > LOOK_LIMIT;
    const touched = (end: number): string =>
      this.#core.linesAsWritten(this.#core.lineAt(from), this.#core.lineAt(end) + 1);
    const before = anew ? '' : touched(to);
    this.#core.edit(from, to, insert);
    if (anew || mayTellOfSwitches(before) || mayTellOfSwitches(touched(from + insert.length))) this.#lookForSwitches();
  }

  #lookForSwitches(): void {
    this.#switches = undefined;
    this.#looking = { finder: new SwitchFinder(), nextLine: 0 };
  }

  /** Searches the next lines; a short text is searched in one go. */
  #lookOn(): void {
    if (this.#looking === undefined) return;
    const { finder, nextLine } = this.#looking;
    const lines = this.#core.linesAsWritten(nextLine, nextLine + LINES_PER_LOOK);
    finder.look(lines);
    this.#looking.nextLine += LINES_PER_LOOK;
    if (this.#core.linesAsWritten(this.#looking.nextLine, this.#looking.nextLine + 1) !== '') return;
    this.#looking = undefined;
    this.#switches = finder.found;
    // A pending report will contain them.
    if (this.#isTold()) this.#tell({ kind: 'switches', inText: this.#switches });
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
    else if (this.#drawing) this.#draw();
    else if (this.#stage.kind === 'machining') this.#removeMaterial(this.#stage);
    else this.#lookOn();
    if (
      this.#stage.kind === 'running' ||
      this.#stage.kind === 'machining' ||
      this.#drawing ||
      this.#looking !== undefined
    )
      this.#queueSlice();
  }

  #advance(going: Going): void {
    const ended = this.#core.advance(BLOCKS_PER_SLICE);
    const now = performance.now();
    if (ended) this.#end();
    else if (now - going.startedAt > RUN_LIMIT_MS) this.#stop();
    else this.#tellProgress(going, 'run', () => this.#core.progress());
  }

  #tellProgress(going: Going, work: Work, done: () => number): void {
    const now = performance.now();
    if (now - going.startedAt <= PROGRESS_AFTER_MS || now - going.lastProgressAt <= PROGRESS_EVERY_MS) return;
    going.lastProgressAt = now;
    this.#tell({ kind: 'progress', work, done: done() });
  }

  #end(): void {
    this.#lookOn();
    const missing = this.#missingPart();
    if (missing !== undefined) return this.#waitFor(missing);
    if (this.#isLoaded(['late', this.#language]) || this.#core.missingPart() !== undefined) return this.#goOn();
    this.#keepsOld = undefined;
    this.#stage = { kind: 'waiting' };
    this.#tell({ kind: 'path', summary: this.#core.summary() });
    this.#wantDraw('now');
    setTimeout(() => this.#parts.release(), LOAD_PARTS_AFTER_MS);
    this.#whenLoaded(['late', this.#language], () => {
      if (this.#stage.kind === 'waiting') this.#goOn();
    });
  }

  /** Runs again if parts were loaded for it; otherwise continues after the path. */
  #goOn(): void {
    const setup = this.#unreadSetup;
    if (setup !== undefined) this.#changeSetup(setup);
    if (this.#core.beginAgain() || setup !== undefined) this.#advanceSoon();
    else this.#toMachine();
  }

  #toMachine(): void {
    const now = performance.now();
    this.#mayKeepOldPicture();
    const machining: Stage & { kind: 'machining' } = {
      kind: 'machining',
      pathTold: false,
      pathShown: false,
      startedAt: now,
      lastProgressAt: now,
    };
    this.#stage = machining;
    this.#removeMaterial(machining);
  }

  /** Removes more material. Part and collisions are complete when all of it is removed. */
  #removeMaterial(machining: Stage & { kind: 'machining' }): void {
    const enough = performance.now() + WAIT_FOR_PART_MS;
    let done = false;
    do done = this.#core.removeMaterial(MOTIONS_PER_SLICE);
    while (!done && performance.now() < enough);
    if (done) {
      this.#stage = { kind: 'done' };
      for (const late of this.#onceWhole.splice(0)) late();
      this.#report(machining.pathTold ? 'part' : 'whole');
      if (this.#keepsOld === undefined) this.#wantDraw('now');
      return;
    }
    // If the part takes longer than `WAIT_FOR_PART_MS`, report the path first.
    if (!machining.pathTold) {
      machining.pathTold = true;
      this.#report('path');
    }
    if (
      this.#keepsOld === undefined &&
      !machining.pathShown &&
      performance.now() - machining.startedAt > SHOW_PATH_AFTER_MS
    )
      this.#wantDraw('now');
    this.#tellProgress(machining, 'part', () => this.#core.machiningProgress());
    this.#queueSlice();
  }

  /** Whether the current run was reported. */
  #isTold(): boolean {
    return this.#stage.kind === 'done' ? this.#run > 0 : this.#stage.kind === 'machining' && this.#stage.pathTold;
  }

  /** Reports the run once the texts of the language are loaded, which may have changed during the run. */
  #report(told: Report['stage']): void {
    const needs = ['late', this.#language] as const;
    if (this.#isLoaded(needs)) return this.#tellReport(told);
    const run = this.#run;
    this.#reportsLate = true;
    this.#whenLoaded(needs, () => {
      this.#reportsLate = false;
      if (run === this.#run && this.#isTold()) this.#report(told);
    });
  }

  #tellReport(told: Report['stage']): void {
    this.#tell({
      kind: 'report',
      report: {
        summary: this.#core.summary(),
        diagnostics: this.#core.diagnostics(),
        overview: this.#core.setupOverview(),
        readAs: this.#core.readAs(),
        rulesOff: this.#core.rulesOff(),
        units: this.#core.units(),
        decimal: this.#core.decimalNotice(),
        stage: told,
        setupRejected: this.#setupRejected,
        views: this.#stage.kind === 'done' ? viewsState(this.#core) : undefined,
        switches: this.#switches,
      },
    });
  }

  // ---- the rest -------------------------------------------------------------------------------------

  #wantDraw(how: Exclude<Wanted, 'no'>): void {
    if (this.#drawWanted !== 'now') this.#drawWanted = how;
    if (this.#frameAsked) return;
    this.#frameAsked = true;
    requestAnimationFrame(() => {
      this.#frameAsked = false;
      const wanted = this.#drawWanted;
      this.#drawWanted = 'no';
      const ready =
        this.#stage.kind === 'done' ||
        this.#stage.kind === 'waiting' ||
        (this.#stage.kind === 'machining' && this.#stage.pathShown);
      this.guarded(() => {
        if (this.#stage.kind === 'lacking') this.#drawWanted = wanted;
        else if (wanted === 'now' || (wanted === 'when-whole' && ready)) this.#draw();
      });
    });
  }

  #draw(): void {
    if (this.#stage.kind === 'machining') this.#stage.pathShown = true;
    const drawn = drawAll(this.#core);
    this.#drawing = drawn === Drawn.Part;
    if (this.#stage.kind !== 'running') {
      const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
      this.#pictured = { run: this.#run, motions, errors };
    }
    if (this.#drawing) this.#queueSlice();
    if (drawn === Drawn.Moved) this.#wantDraw('now');
    this.#present();
  }

  /** Sends the painted images, unless the page has not shown the last ones yet. */
  #present(): void {
    if (this.#onTheWay) return;
    const pictures = takePictures(this.#core);
    if (pictures === undefined) return;
    this.#onTheWay = true;
    this.#tell({ kind: 'pictures', pictures }, Object.values(pictures));
    this.#parts.release();
  }

  /** Sends an event with the number of the run. */
  #tell(event: RunEvent, images: ImageBitmap[] = []): void {
    if (!this.#closed) this.#thread.tell({ ...event, run: this.#run }, images);
  }

  /** Sends `settled` if nothing is left to do and the page has shown all pictures. */
  #settle(): void {
    const waits = this.#stage.kind === 'waiting' || this.#stage.kind === 'lacking';
    const atWork = waits ? !this.#parts.failed : this.#stage.kind !== 'done';
    const busy =
      atWork ||
      (this.#reportsLate && !this.#parts.failed) ||
      this.#drawing ||
      (this.#drawWanted !== 'no' && this.#stage.kind !== 'lacking') ||
      this.#onTheWay ||
      this.#looking !== undefined;
    if (busy || this.#settledAt === this.#heard) return;
    this.#settledAt = this.#heard;
    this.#tell({ kind: 'settled', heard: this.#heard });
    this.#rest = setTimeout(() => this.guarded(() => this.#restNow()), REST_AFTER_MS);
  }

  #restNow(): void {
    const [motions = 0] = this.#core.motionsAndErrors();
    if (motions <= MOST_TO_PAINT_AT_ONCE) this.#core.releaseImages();
  }
}

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
