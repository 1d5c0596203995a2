// The interpreter's own thread: owns the `Playground`, its text and the canvas it draws on.
//
// In: the module of the interpreter, then commands and questions of protocol.ts. Out: its events, each with the number of the run it belongs to:
// `tell` is the only door. A program is run in slices, and between slices the messages that have come in are
// read, so newer text ends an older run at once. Pictures cross as images, one at a time: the next one leaves
// when the page has shown the last, so that "settled" is what the page shows, not what was painted here. Must
// not know: the page, the editor, or anything of what the program means.

import init, { Drawn, Playground } from '../../pkg/gcode_playground.js';
import { ANSWERS, type AnswerRow } from './answers';
import { mayTellOfSwitches, SwitchFinder } from './switches-in-text';
import {
  counts, type BeginRun, type Came, type Command, type Core, type LifeEvent, type Question, type QuestionKind, type Report, type RunEvent, type SwitchesInText, type TextChange, type TextCommand,
  type Work } from '../protocol/protocol';
import { fetchPart, Parts, type PartName } from './parts';
import { handIn } from './text-in';
import { changePicture, drawAll, fitAll, takePictures, viewsState } from './pictures';

/** The only setup that is read without the part `setup`. */
const NO_SETUP = '{}';
const BLOCKS_PER_SLICE = 20_000;
/** The reader can stop a run any time; this is for when nobody is there. */
const RUN_LIMIT_MS = 60_000;
/** Lines looked at for switches in one go. */
const LINES_PER_LOOK = 20_000;
/** Longer changes are not looked at for switches: all of the text is. */
const LOOK_LIMIT = 100_000;
/** Motions whose material is taken off in one go, and how long a report waits for the part. */
const MOTIONS_PER_SLICE = 20;
const WAIT_FOR_PART_MS = 8;
/** Longer than this nobody looks at the picture of the run before: the path is shown without the part. */
const SHOW_PATH_AFTER_MS = 300;
/** Where no picture is drawn, as in a tab that nobody sees, the parts are loaded all the same. */
const LOAD_PARTS_AFTER_MS = 500;
const PROGRESS_AFTER_MS = 150;
const PROGRESS_EVERY_MS = 100;

/** Which run a picture is of, and what that run had. */
interface Pictured {
  readonly run: number;
  readonly motions: number;
  readonly errors: number;
}

/** How long something has been going on, and when that was reported last. */
interface Going {
  readonly startedAt: number;
  lastProgressAt: number;
}

/** How far the current run is. */
type Stage =
  | ({ readonly kind: 'running' } & Going)
  /** It cannot go on without a part that is being loaded; nothing of it is drawn. */
  | { readonly kind: 'lacking' }
  /** The path is drawn; what takes material off and says what is wrong has not been loaded yet. */
  | { readonly kind: 'waiting' }
  /**
   * Material is being taken off; whether the path has been reported before the part is
   * there, and its picture shown.
   */
  | ({ readonly kind: 'machining'; pathTold: boolean; pathShown: boolean } & Going)
  | { readonly kind: 'done' };

/** Whether a picture is wanted: once there is one of the whole run, or of as much as there is. */
type Wanted = 'no' | 'when-whole' | 'now';

let core: Playground | undefined;
let parts: Parts | undefined;
/** What waits for parts of the interpreter. */
const waiting: { readonly needs: readonly PartName[]; readonly act: () => void }[] = [];
/** Nothing is loaded that could delay the first picture; a part that did not come is not waited for. */
let loading: 'held' | 'begun' | 'failed' = 'held';
let language: PartName = 'en';
/** The number of the current run, as the page counts them. */
let run = 0;
let stage: Stage = { kind: 'done' };
/** Why the setup that was sent last was not taken. */
let setupRejected: string | undefined;
/** A setup whose reader has not been loaded yet. */
let unreadSetup: string | undefined;
/** Looks for switches in the text; undefined when all of it was looked at. */
let looking: { readonly finder: SwitchFinder; nextLine: number } | undefined;
let switches: SwitchesInText | undefined;
let drawWanted: Wanted = 'no';
let frameAsked = false;
/** A picture of very many strokes is under way. */
let drawing = false;
/** The page has not shown the last picture yet. */
let onTheWay = false;
/** The last picture that was painted of a whole path. */
let pictured: Pictured | undefined;
/** The line in which the current run was typed; undefined where its text came otherwise. */
let typedLine: number | undefined;
/** The picture on the page is that of an earlier run, as long as the reader stays in this line. */
let keepsOld: { readonly line: number } | undefined;
/** A report waits for the sentences of a language. */
let reportsLate = false;
/** Messages heard that may change what is shown, and how many of them the page knows to be settled. */
let heard = 0;
let settledAt = -1;
/** What has to wait until there is all of the part. */
const onceWhole: (() => void)[] = [];

/** Messages that came before the interpreter was loaded. */
const early: (Command | Question)[] = [];
const slices = new MessageChannel();
let sliceQueued = false;

self.onmessage = ({ data: message }: MessageEvent<Core | Command | Question>) => {
  if (message.kind === 'core') void load(message.module);
  else if (core === undefined) hearEarly(message);
  else guarded(() => receive(message));
};
slices.port1.onmessage = () => {
  sliceQueued = false;
  guarded(slice);
};

async function load(module: WebAssembly.Module): Promise<void> {
  try {
    const exports = await init({ module_or_path: module });
    parts = new Parts(exports, { loaded: () => guarded(goOnWithParts), failed: (reason) => guarded(() => partFailed(reason)) });
    core = new Playground();
  } catch (error) {
    tellOfLife({ kind: 'load-failed', reason: describe(error) });
    return;
  }
  tellOfLife({ kind: 'ready' });
  for (const message of early.splice(0)) guarded(() => receive(message));
}

/** What is said to need another part has it fetched together with the interpreter. */
function hearEarly(message: Command | Question): void {
  early.push(message);
  if (message.kind === 'run' && message.setup !== undefined && message.setup !== NO_SETUP) fetchPart('setup');
}

function receive(message: Command | Question): void {
  if (core === undefined) return;
  if (counts(message)) heard++;
  if (message.kind === 'question') {
    ask(core, message);
    return;
  }
  const row = COMMANDS[message.kind] as CommandRow<Command['kind']>;
  row.act(core, message);
  if (keepsOld !== undefined && oldPictureStays(core, message, keepsOld.line)) return;
  if (row.draws !== 'no') wantDraw(row.draws);
}

/** Whether an old picture is still the one to show: the reader has neither left the line nor moved the picture. */
function oldPictureStays(playground: Playground, message: Command, line: number): boolean {
  switch (message.kind) {
    case 'cursor':
      return message.offset !== undefined && playground.lineAt(message.offset) === line ? true : showCurrent();
    case 'picture':
      // What is said of the new run takes room.
      return message.what.kind === 'resize' ? true : showCurrent();
    case 'run': case 'shown': case 'hover': case 'leave-edge': case 'load-parts': case 'stop':
      return true;
    case 'palette': case 'language': case 'unit': case 'turret': case 'keep': case 'end-comparison':
      return showCurrent();
  }
}

/** The picture of the current run takes the place of an old one. */
function showCurrent(): false {
  keepsOld = undefined;
  wantDraw('now');
  return false;
}

/**
 * A block that is being typed is half a word now and then, and a contour with a fault is not cut at all: the picture
 * of before is of more use than an empty one, for as long as this run has more errors and fewer motions.
 */
function keepsOldPicture(playground: Playground): boolean {
  keepsOld = undefined;
  if (typedLine === undefined || pictured === undefined) return false;
  const [motions = 0, errors = 0] = playground.motionsAndErrors();
  if (motions >= pictured.motions || errors <= pictured.errors) return false;
  keepsOld = { line: typedLine };
  tell({ kind: 'old-picture', of: pictured.run });
  return true;
}

interface CommandRow<K extends Command['kind']> {
  /** What was there stays until the run is whole, unless the reader moves it. */
  readonly draws: Wanted;
  act(playground: Playground, command: Extract<Command, { readonly kind: K }>): void;
}

const COMMANDS: { readonly [K in Command['kind']]: CommandRow<K> } = {
  picture: { draws: 'now', act: (playground, { picture, what }) => changePicture(playground, picture, what) },
  palette: { draws: 'now', act: (playground, { palette }) => playground.setPalette(palette) },
  language: {
    draws: 'when-whole',
    act(playground, { tag }) {
      language = tag;
      playground.setLanguage(tag);
      reportAgain(playground);
    },
  },
  unit: {
    draws: 'when-whole',
    act(playground, { unit }) {
      playground.setUnit(unit ?? '');
      reportAgain(playground);
    },
  },
  run: { draws: 'no', act: begin },
  shown: {
    draws: 'no',
    act(playground, { dropped }) {
      onTheWay = false;
      if (dropped) {
        // It was of an earlier run, and nothing else may have changed since.
        playground.paintAgain();
        if (keepsOld === undefined) wantDraw('when-whole');
      } else present(playground);
    },
  },
  stop: { draws: 'when-whole', act: stop },
  'load-parts': { draws: 'no', act: loadParts },
  cursor: { draws: 'when-whole', act: (playground, { offset }) => playground.setCursor(offset) },
  hover: { draws: 'when-whole', act: (playground, { motion }) => playground.setHover(motion) },
  turret: {
    draws: 'now',
    act(playground, { side }) {
      playground.setTurret(side);
      tellViews(playground);
    },
  },
  keep: {
    draws: 'when-whole',
    act: (playground) =>
      whenWhole(() => {
        if (core === undefined) return;
        playground.keep();
        tellViews(playground);
      }),
  },
  'end-comparison': {
    draws: 'when-whole',
    act(playground) {
      playground.endComparison();
      tellViews(playground);
    },
  },
  'leave-edge': { draws: 'when-whole', act: (playground) => playground.leaveEdge() },
};

/** What was reported is reported in other words. */
function reportAgain(playground: Playground): void {
  if (isTold()) report(playground, 'again');
}

function tellViews(playground: Playground): void {
  if (stage.kind === 'done') tell({ kind: 'views', views: viewsState(playground) });
}

const OF_THE_PICTURE: ReadonlySet<QuestionKind> = new Set<QuestionKind>(['pick', 'dimension']);

function ask(playground: Playground, question: Question): void {
  const row = ANSWERS[question.about] as AnswerRow<QuestionKind>;
  const needs = (): readonly PartName[] => {
    if (row.needs === undefined) return [];
    // What is asked with parts is asked of a program that can run.
    const missing = missingPart(playground);
    return [...(missing === undefined ? [] : [missing]), ...row.needs.map((part) => (part === 'language' ? language : part))];
  };
  const now = (): void => {
    if (!isLoaded(needs())) return whenLoaded(needs(), now);
    // Nothing of this run lies under a pointer that is over the picture of an earlier one.
    if (keepsOld !== undefined && OF_THE_PICTURE.has(question.about)) return void reply(question.id, undefined);
    if (keepsOld !== undefined && row.draws !== undefined) showCurrent();
    void reply(question.id, row.answer(playground, question.ask));
    if (row.draws !== undefined) wantDraw(row.draws);
  };
  if (row.waits === undefined) now();
  else whenWhole(now);
}

// ---- the parts of the interpreter -----------------------------------------------------------------

function isLoaded(needs: readonly PartName[]): boolean {
  return parts?.has(...needs) === true;
}

/** Does something as soon as the parts it needs are there. */
function whenLoaded(needs: readonly PartName[], act: () => void): void {
  if (isLoaded(needs)) return act();
  waiting.push({ needs, act });
  if (loading !== 'held') loadParts();
}

/** Loads what is waited for; what could not be loaded before is tried again. */
function loadParts(): void {
  loading = 'begun';
  // Who waits hears of a failure by `partFailed`.
  for (const { needs } of waiting) parts?.load(...needs).catch(() => undefined);
}

/** The first picture is on its way: nothing is delayed by other parts any more. */
function release(): void {
  if (loading === 'held') loadParts();
}

function goOnWithParts(): void {
  for (const late of waiting.splice(0)) {
    if (isLoaded(late.needs)) late.act();
    else waiting.push(late);
  }
}

function partFailed(reason: unknown): void {
  loading = 'failed';
  tell({ kind: 'part-failed', reason: describe(reason), needed: stage.kind === 'lacking' ? 'by-the-run' : 'after-it' });
}

function whenWhole(act: () => void): void {
  if (stage.kind === 'done') act();
  else onceWhole.push(act);
}

/** What is there at once is sent at once: answers keep the order of their questions. */
function reply(id: number, answer: unknown): void | Promise<void> {
  if (!(answer instanceof Promise)) return tell({ kind: 'answer', id, answer });
  return answer.then((late: unknown) => tell({ kind: 'answer', id, answer: late }));
}

// ---- from one run to the next ---------------------------------------------------------------------

function begin(playground: Playground, change: BeginRun): void {
  run = change.run;
  // A setup that is not taken leaves the run as it was, and so the tool in its place.
  playground.showWhole();
  if (change.framing === 'fit') fitAll(playground);
  typedLine = undefined;
  if (change.setup !== undefined) changeSetup(playground, change.setup);
  if (change.text !== undefined) changeText(playground, change.text, change.came);
  playground.setCursor(change.cursor);
  typedLine = lineTyped(playground, change);
  // Of a run under way there is only a part to draw: what was there stays until there is a whole one.
  drawing = false;
  drawWanted = 'no';
  const missing = missingPart(playground);
  if (missing === undefined) advanceSoon();
  else waitFor(missing, playground);
}

/** The line of the reader's hand: one change of the text, with the cursor in it. */
function lineTyped(playground: Playground, { setup, text, came, framing, cursor }: BeginRun): number | undefined {
  if (setup !== undefined || text?.kind !== 'edit' || text.changes.length !== 1 || came !== 'typed' || framing === 'fit' || cursor === undefined) return undefined;
  const [change] = text.changes;
  const line = playground.lineAt(cursor);
  return change !== undefined && playground.lineAt(change.from) === line ? line : undefined;
}

/** What the run cannot be carried out without, and is not there yet. */
function missingPart(playground: Playground): PartName | undefined {
  const missing = unreadSetup === undefined ? (playground.missingPart() as PartName | undefined) : 'setup';
  return missing === undefined || isLoaded([missing]) ? undefined : missing;
}

/** Leaves the run until a part is there, which is loaded even before the first picture. */
function waitFor(missing: PartName, playground: Playground): void {
  stage = { kind: 'lacking' };
  whenLoaded([missing], () => {
    if (stage.kind === 'lacking') goOn(playground);
  });
  // Who waits hears of a failure by `partFailed`.
  parts?.load(missing).catch(() => undefined);
  queueSlice();
}

function advanceSoon(): void {
  const now = performance.now();
  stage = { kind: 'running', startedAt: now, lastProgressAt: now };
  queueSlice();
}

function changeSetup(playground: Playground, json: string): void {
  unreadSetup = undefined;
  if (json !== NO_SETUP && !isLoaded(['setup'])) {
    unreadSetup = json;
    return;
  }
  try {
    playground.setSetup(json);
    setupRejected = undefined;
  } catch (reason) {
    if (reason instanceof WebAssembly.RuntimeError) throw reason;
    setupRejected = describe(reason);
  }
}

function changeText(playground: Playground, text: TextCommand, came: Came): void {
  if (text.kind === 'edit') {
    for (const change of text.changes) edit(playground, change);
    loadForTyping();
    if (came === 'at-once') playground.decideDecimalRule();
  } else {
    handIn(playground, text.pieces);
    lookForSwitches();
  }
}

/** Who types may type anything, and half a word is a mistake: what reads that is not first asked for when it is met. */
function loadForTyping(): void {
  if (isLoaded(['machine'])) parts?.load('seldom', 'path').catch(() => undefined);
}

function edit(playground: Playground, { from, to, insert }: TextChange): void {
  // Lines that are still to be looked at may stand elsewhere then.
  const anew = looking !== undefined || to - from > LOOK_LIMIT || insert.length > LOOK_LIMIT;
  const touched = (end: number): string => playground.linesAsWritten(playground.lineAt(from), playground.lineAt(end) + 1);
  const before = anew ? '' : touched(to);
  playground.edit(from, to, insert);
  if (anew || mayTellOfSwitches(before) || mayTellOfSwitches(touched(from + insert.length))) lookForSwitches();
}

function lookForSwitches(): void {
  switches = undefined;
  looking = { finder: new SwitchFinder(), nextLine: 0 };
}

/** Looks at some more lines; a short text is looked at in one go. */
function lookOn(playground: Playground): void {
  if (looking === undefined) return;
  const { finder, nextLine } = looking;
  const lines = playground.linesAsWritten(nextLine, nextLine + LINES_PER_LOOK);
  finder.look(lines);
  looking.nextLine += LINES_PER_LOOK;
  if (playground.linesAsWritten(looking.nextLine, looking.nextLine + 1) !== '') return;
  looking = undefined;
  switches = finder.found;
  // A report that is still to come contains them.
  if (isTold()) tell({ kind: 'switches', inText: switches });
}

// ---- the run --------------------------------------------------------------------------------------

function stop(playground: Playground): void {
  if (stage.kind === 'machining') {
    playground.stopMachining();
    removeMaterial(playground, stage);
  } else if (stage.kind === 'running') {
    playground.stop(Math.round((performance.now() - stage.startedAt) / 100) / 10);
    end(playground);
  }
}

function queueSlice(): void {
  if (sliceQueued) return;
  sliceQueued = true;
  slices.port2.postMessage(undefined);
}

function slice(): void {
  if (core === undefined) return;
  if (stage.kind === 'running') advance(core, stage);
  else if (drawing) draw(core);
  else if (stage.kind === 'machining') removeMaterial(core, stage);
  else lookOn(core);
  if (stage.kind === 'running' || stage.kind === 'machining' || drawing || looking !== undefined) queueSlice();
}

function advance(playground: Playground, going: Going): void {
  const ended = playground.advance(BLOCKS_PER_SLICE);
  const now = performance.now();
  if (ended) end(playground);
  else if (now - going.startedAt > RUN_LIMIT_MS) stop(playground);
  else tellProgress(going, 'run', () => playground.progress());
}

function tellProgress(going: Going, work: Work, done: () => number): void {
  const now = performance.now();
  if (now - going.startedAt <= PROGRESS_AFTER_MS || now - going.lastProgressAt <= PROGRESS_EVERY_MS) return;
  going.lastProgressAt = now;
  tell({ kind: 'progress', work, done: done() });
}

function end(playground: Playground): void {
  lookOn(playground);
  const missing = missingPart(playground);
  if (missing !== undefined) return waitFor(missing, playground);
  if (isLoaded(['machine', language]) || playground.missingPart() !== undefined) return goOn(playground);
  keepsOld = undefined;
  stage = { kind: 'waiting' };
  tell({ kind: 'path', summary: playground.summary() });
  wantDraw('now');
  setTimeout(() => guarded(release), LOAD_PARTS_AFTER_MS);
  whenLoaded(['machine', language], () => {
    if (stage.kind === 'waiting') goOn(playground);
  });
}

/** Runs again with what has been loaded since; or, where nothing has, goes on with what comes after the path. */
function goOn(playground: Playground): void {
  const setup = unreadSetup;
  if (setup !== undefined) changeSetup(playground, setup);
  if (playground.beginAgain() || setup !== undefined) advanceSoon();
  else toMachine(playground);
}

function toMachine(playground: Playground): void {
  const now = performance.now();
  keepsOldPicture(playground);
  const machining: Stage & { kind: 'machining' } = { kind: 'machining', pathTold: false, pathShown: false, startedAt: now, lastProgressAt: now };
  stage = machining;
  removeMaterial(playground, machining);
}

/** Takes some more material off; the part, and what runs into what, are there when all of it is. */
function removeMaterial(playground: Playground, machining: Stage & { kind: 'machining' }): void {
  const enough = performance.now() + WAIT_FOR_PART_MS;
  let done = false;
  do done = playground.removeMaterial(MOTIONS_PER_SLICE);
  while (!done && performance.now() < enough);
  if (done) {
    stage = { kind: 'done' };
    for (const late of onceWhole.splice(0)) late();
    report(playground, machining.pathTold ? 'part' : 'whole');
    if (keepsOld === undefined) wantDraw('now');
    return;
  }
  // What takes longer than a blink is reported when it is there.
  if (!machining.pathTold) {
    machining.pathTold = true;
    report(playground, 'path');
  }
  if (keepsOld === undefined && !machining.pathShown && performance.now() - machining.startedAt > SHOW_PATH_AFTER_MS) wantDraw('now');
  tellProgress(machining, 'part', () => playground.machiningProgress());
  queueSlice();
}

/** The current run has been reported. */
function isTold(): boolean {
  return stage.kind === 'done' ? run > 0 : stage.kind === 'machining' && stage.pathTold;
}

/** Says how the run has come out, once the sentences of the language are there: it may have changed in the midst of the run. */
function report(playground: Playground, told: Report['stage']): void {
  const needs = ['machine', language] as const;
  if (isLoaded(needs)) return tellReport(playground, told);
  const of = run;
  reportsLate = true;
  whenLoaded(needs, () => {
    reportsLate = false;
    if (run === of && isTold()) report(playground, told);
  });
}

function tellReport(playground: Playground, told: Report['stage']): void {
  tell({
    kind: 'report',
    report: {
      summary: playground.summary(),
      diagnostics: playground.diagnostics(),
      overview: playground.setupOverview(),
      readAs: playground.readAs(),
      rulesOff: playground.rulesOff(),
      units: playground.units(),
      decimal: playground.decimalNotice(),
      stage: told,
      setupRejected,
      views: stage.kind === 'done' ? viewsState(playground) : undefined,
      switches,
    },
  });
}

// ---- the rest -------------------------------------------------------------------------------------

function wantDraw(how: Exclude<Wanted, 'no'>): void {
  if (drawWanted !== 'now') drawWanted = how;
  if (frameAsked) return;
  frameAsked = true;
  requestAnimationFrame(() => {
    frameAsked = false;
    const wanted = drawWanted;
    drawWanted = 'no';
    const ready = stage.kind === 'done' || stage.kind === 'waiting' || (stage.kind === 'machining' && stage.pathShown);
    guarded(() => {
      if (stage.kind === 'lacking') drawWanted = wanted;
      else if (core !== undefined && (wanted === 'now' || (wanted === 'when-whole' && ready))) draw(core);
    });
  });
}

function draw(playground: Playground): void {
  if (stage.kind === 'machining') stage.pathShown = true;
  const drawn = drawAll(playground);
  drawing = drawn === Drawn.Part;
  if (stage.kind !== 'running') {
    const [motions = 0, errors = 0] = playground.motionsAndErrors();
    pictured = { run, motions, errors };
  }
  if (drawing) queueSlice();
  if (drawn === Drawn.Moved) wantDraw('now');
  present(playground);
}

/** Hands what was painted to the page, unless it has not shown the last picture yet. */
function present(playground: Playground): void {
  if (onTheWay) return;
  const pictures = takePictures(playground);
  if (pictures === undefined) return;
  onTheWay = true;
  tell({ kind: 'pictures', pictures }, Object.values(pictures));
  release();
}

/** Once nothing is left to do, and the page has shown all there is. */
function settle(): void {
  const waits = stage.kind === 'waiting' || stage.kind === 'lacking';
  const atWork = waits ? loading !== 'failed' : stage.kind !== 'done';
  const busy = atWork || (reportsLate && loading !== 'failed') || drawing || (drawWanted !== 'no' && stage.kind !== 'lacking') || onTheWay || looking !== undefined;
  if (core === undefined || busy || settledAt === heard) return;
  settledAt = heard;
  tell({ kind: 'settled', heard });
}

/** A panic leaves the interpreter unusable: say so once, and take no further message. */
function guarded(step: () => void): void {
  try {
    step();
    settle();
  } catch (error) {
    core = undefined;
    stage = { kind: 'done' };
    drawing = false;
    tellOfLife({ kind: 'crashed', reason: describe(error) });
  }
}

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Whatever is reported of a run names it. */
function tell(event: RunEvent, images: ImageBitmap[] = []): void {
  self.postMessage({ ...event, run }, { transfer: images });
}

function tellOfLife(event: LifeEvent): void {
  self.postMessage(event);
}
