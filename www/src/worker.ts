// The interpreter's own thread: owns the `Playground`, its text and the canvas it draws on.
//
// In: commands and questions of protocol.ts. Out: its events. A program is run in slices, and between
// slices the messages that have come in are read, so newer text ends an older run at once.
// Must not know: the page, the editor, or anything of what the program means.

import init, { Drawn, Playground } from '../pkg/gcode_playground.js';
import { mayTellOfSwitches, SwitchFinder } from './switches-in-text';
import { fileOf } from './worker-files';
import type {
  Command, Question, QuestionKind, Questions, TextChange, WorkerEvent, WrittenOut,
} from './protocol';
import { handIn } from './text-in';
import { piecesOf, programsIn } from './worker-paste';
import { answerView, doView, drawAll, viewsState } from './worker-views';
import { toolAnswers } from './tool-answers';

const BLOCKS_PER_SLICE = 20_000;
/** The reader can stop a run any time; this is for when nobody is there. */
const RUN_LIMIT_MS = 60_000;
/** Lines looked at for switches in one go. */
const LINES_PER_LOOK = 20_000;
/** Longer changes are not looked at for switches: all of the text is. */
const LOOK_LIMIT = 100_000;
/** Longer texts are written out without colours. */
const COLOUR_LIMIT = 200_000;
/** Motions whose material is taken off in one go, and how long a report waits for the part. */
const MOTIONS_PER_SLICE = 20;
const WAIT_FOR_PART_MS = 8;
const PROGRESS_AFTER_MS = 150;
const PROGRESS_EVERY_MS = 100;

const MOVES: ReadonlySet<Command['kind']> = new Set(['canvas', 'resize', 'palette', 'fit', 'pan', 'zoom', 'on-face', 'turret']);

interface Run {
  readonly startedAt: number;
  lastProgressAt: number;
}

let core: Playground | undefined;
let revision = 0;
/** Looks for switches in the text; undefined when all of it was looked at. */
let looking: { readonly finder: SwitchFinder; nextLine: number } | undefined;
let switchesTold = '';
let run: Run | undefined;
/** The newest run has ended and been reported; its messages can be asked for again in another language. */
let reported = false;
let drawWanted = false;
/** A picture of very many strokes is under way. */
let drawing = false;
/** Material is being taken off the blank. */
let machining: Run | undefined;
/** The path has been reported before the part was there. */
let pathReported = false;

/** Messages that came before the interpreter was loaded. */
const early: (Command | Question)[] = [];
const slices = new MessageChannel();
let sliceQueued = false;

self.onmessage = (event: MessageEvent<Command | Question>) => {
  if (core === undefined) early.push(event.data);
  else guarded(() => receive(event.data));
};
slices.port1.onmessage = () => {
  sliceQueued = false;
  guarded(slice);
};

void load();

async function load(): Promise<void> {
  try {
    await init({ module_or_path: new URL('../pkg/gcode_playground_bg.wasm', import.meta.url) });
    core = new Playground();
  } catch (error) {
    send({ kind: 'load-failed', reason: describe(error) });
    return;
  }
  send({ kind: 'ready' });
  for (const message of early.splice(0)) guarded(() => receive(message));
}

function receive(message: Command | Question): void {
  if (core === undefined) return;
  switch (message.kind) {
    case 'question':
      void reply(message.id, answer(core, message));
      return;
    case 'canvas':
      core.attachCanvas(message.canvas);
      core.setPalette(message.palette);
      core.resize(message.size.width, message.size.height, message.size.pixelRatio);
      break;
    case 'resize':
      core.resize(message.size.width, message.size.height, message.size.pixelRatio);
      break;
    case 'palette':
      core.setPalette(message.palette);
      break;
    case 'language':
      core.setLanguage(message.tag);
      if (reported) report(core);
      break;
    case 'setup':
      changeSetup(core, message.json);
      break;
    case 'text':
      handIn(core, message.pieces);
      lookForSwitches();
      changed(core, message);
      break;
    case 'edit':
      for (const change of message.changes) edit(core, change);
      if (message.came === 'at-once') core.decideDecimalRule();
      changed(core, message);
      break;
    case 'stop':
      stop(core);
      break;
    case 'cursor':
      core.setCursor(message.offset);
      break;
    case 'hover':
      core.setHover(message.motion);
      break;
    case 'on-face':
    case 'turret':
    case 'keep':
    case 'end-comparison':
    case 'leave-edge':
      if (doView(core, message)) send({ kind: 'views', views: viewsState(core) });
      break;
    case 'fit':
      core.fit();
      break;
    case 'pan':
      core.pan(message.dx, message.dy);
      break;
    case 'zoom':
      core.zoom(message.factor, message.x, message.y);
      break;
  }
  // Of a run under way there is only a part to draw: what was there stays until it has ended, or the reader moves it.
  if (run === undefined || MOVES.has(message.kind)) wantDraw();
}

type Answer = Questions[QuestionKind]['answer'];

/** What is there at once is sent at once: answers keep the order of their questions. */
function reply(id: number, answer: Answer | Promise<Answer>): void | Promise<void> {
  if (!(answer instanceof Promise)) return send({ kind: 'answer', id, answer });
  return answer.then((late) => send({ kind: 'answer', id, answer: late }));
}

function answer(playground: Playground, question: Question): Answer | Promise<Answer> {
  switch (question.about) {
    case 'ping':
      return true;
    case 'tokens': {
      const { firstLine, endLine } = question.ask as Questions['tokens']['ask'];
      return playground.tokens(firstLine, endLine);
    }
    case 'pick': {
      const { x, y } = question.ask as Questions['pick']['ask'];
      return playground.pick(x, y);
    }
    case 'play':
      wantDraw();
      return toolAnswers.play(playground, question.ask as Questions['play']['ask']);
    case 'seek':
      wantDraw();
      return toolAnswers.seek(playground, question.ask as Questions['seek']['ask']);
    case 'step':
      wantDraw();
      return toolAnswers.step(playground, question.ask as Questions['step']['ask']);
    case 'locate': {
      const { x, z } = question.ask as Questions['locate']['ask'];
      const [px = 0, py = 0] = playground.screenOf(x, z);
      return { x: px, y: py };
    }
    case 'pickOnFace':
    case 'dimension':
    case 'locateOnFace':
      if (question.about === 'dimension') wantDraw();
      return answerView(playground, question.about, question.ask as Questions[typeof question.about]['ask']);
    case 'expand':
      return writtenOut(playground);
    case 'rewritings': {
      const { from, to } = question.ask as Questions['rewritings']['ask'];
      return playground.rewritings(from, to);
    }
    case 'codes':
      return playground.codes();
    case 'export':
      return fileOf(playground, (question.ask as Questions['export']['ask']).format);
    case 'section':
      return playground.section();
    case 'programs-in':
      return programsIn((question.ask as Questions['programs-in']['ask']).text);
    case 'pieces-of': {
      const { program, language } = question.ask as Questions['pieces-of']['ask'];
      return piecesOf(program, language);
    }
    case 'setup-form':
      return playground.setupForm();
    case 'another-tool':
      return playground.anotherTool((question.ask as Questions['another-tool']['ask']).word);
    case 'read-setup': {
      const { keys, texts, keep, json } = question.ask as Questions['read-setup']['ask'];
      return playground.readSetupForm([...keys], [...texts], keep, json);
    }
  }
}

function changeSetup(playground: Playground, json: string): void {
  try {
    playground.setSetup(json);
  } catch (reason) {
    if (reason instanceof WebAssembly.RuntimeError) throw reason;
    send({ kind: 'setup-rejected', reason: describe(reason) });
    return;
  }
  send({ kind: 'setup-accepted' });
  wantRun();
}

// ---- the text -------------------------------------------------------------------------------------

function changed(playground: Playground, message: Command & { readonly kind: 'text' | 'edit' }): void {
  revision = message.revision;
  playground.setCursor(message.cursor);
  wantRun();
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
  const inText = finder.found;
  const told = JSON.stringify(inText);
  if (told !== switchesTold) send({ kind: 'switches', inText });
  switchesTold = told;
}

// ---- the run --------------------------------------------------------------------------------------

/** The interpreter has begun a run: by a text, an edit or a setup. */
function wantRun(): void {
  const now = performance.now();
  run = { startedAt: now, lastProgressAt: now };
  machining = undefined;
  pathReported = false;
  reported = false;
  queueSlice();
}

function stop(playground: Playground): void {
  if (machining !== undefined) {
    playground.stopMachining();
    machine(playground, machining);
  }
  if (run === undefined) return;
  playground.stop(Math.round((performance.now() - run.startedAt) / 100) / 10);
  end(playground);
}

function queueSlice(): void {
  if (sliceQueued) return;
  sliceQueued = true;
  slices.port2.postMessage(undefined);
}

function slice(): void {
  if (core === undefined) return;
  if (run !== undefined) advance(core, run);
  else if (drawing) draw(core);
  else if (machining !== undefined) machine(core, machining);
  else lookOn(core);
  if (run !== undefined || drawing || machining !== undefined || looking !== undefined) queueSlice();
}

function advance(playground: Playground, current: Run): void {
  const ended = playground.advance(BLOCKS_PER_SLICE);
  const now = performance.now();
  if (ended) end(playground);
  else if (now - current.startedAt > RUN_LIMIT_MS) stop(playground);
  else if (now - current.startedAt > PROGRESS_AFTER_MS && now - current.lastProgressAt > PROGRESS_EVERY_MS) {
    current.lastProgressAt = now;
    send({ kind: 'progress', revision, work: 'run', done: playground.progress() });
  }
}

function end(playground: Playground): void {
  run = undefined;
  lookOn(playground);
  const now = performance.now();
  machining = { startedAt: now, lastProgressAt: now };
  machine(playground, machining);
  // What takes longer than a blink is told of when it is there.
  if (machining !== undefined) report(playground);
}

/** Takes some more material off; the part, and what runs into what, are there when all of it is. */
function machine(playground: Playground, current: Run): void {
  const enough = performance.now() + WAIT_FOR_PART_MS;
  let done = false;
  while (!done && performance.now() < enough) done = playground.machine(MOTIONS_PER_SLICE);
  if (!done) {
    const now = performance.now();
    if (now - current.startedAt > PROGRESS_AFTER_MS && now - current.lastProgressAt > PROGRESS_EVERY_MS) {
      current.lastProgressAt = now;
      send({ kind: 'progress', revision, work: 'part', done: playground.machiningProgress() });
    }
    queueSlice();
    return;
  }
  machining = undefined;
  report(playground);
  wantDraw();
}

function report(playground: Playground): void {
  const stage = machining !== undefined ? 'path' : pathReported ? 'part' : 'whole';
  // In another language it is all told anew.
  pathReported = stage === 'path';
  reported = true;
  send({
    kind: 'report',
    report: {
      revision,
      summary: playground.summary(),
      diagnostics: playground.diagnostics(),
      fitted: playground.fitting(),
      decimal: playground.decimalNotice(),
      stage,
    },
  });
  send({ kind: 'views', views: viewsState(playground) });
}

// ---- written out ----------------------------------------------------------------------------------

function writtenOut(playground: Playground): WrittenOut {
  const text = playground.expand();
  if (text.length > COLOUR_LIMIT) return { text, tokens: new Uint32Array() };
  // Colours belong to a text, so the new text needs an interpreter of its own for a moment.
  const reader = new Playground();
  try {
    reader.setText(text);
    return { text, tokens: reader.tokens(0, text.length + 1) };
  } finally {
    reader.free();
  }
}

// ---- the rest -------------------------------------------------------------------------------------

function wantDraw(): void {
  if (drawWanted) return;
  drawWanted = true;
  requestAnimationFrame(() => {
    drawWanted = false;
    guarded(() => {
      if (core !== undefined) draw(core);
    });
  });
}

function draw(playground: Playground): void {
  const drawn = drawAll(playground);
  drawing = drawn === Drawn.Part;
  if (drawing) queueSlice();
  if (drawn === Drawn.Moved) wantDraw();
}

/** A panic leaves the interpreter unusable: say so once, and take no further message. */
function guarded(step: () => void): void {
  try {
    step();
  } catch (error) {
    core = undefined;
    run = undefined;
    drawing = false;
    machining = undefined;
    send({ kind: 'crashed', reason: describe(error) });
  }
}

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function send(event: WorkerEvent): void {
  self.postMessage(event);
}
