// The interpreter's own thread: owns the `Playground`, its text and the canvas it draws on.
//
// In: commands and questions of protocol.ts. Out: its events. A program is run in slices, and between
// slices the messages that have come in are read, so newer text ends an older run at once.
// Must not know: the page, the editor, or anything of what the program means.

import init, { Playground } from '../pkg/gcode_playground.js';
import { NO_SWITCHES, switchesIn } from './switches-in-text';
import type { Command, Question, QuestionKind, Questions, ToolPlace, WorkerEvent, WrittenOut } from './protocol';

const BLOCKS_PER_SLICE = 20_000;
const RUN_LIMIT_MS = 10_000;
/** Longer texts are written out without colours. */
const COLOUR_LIMIT = 200_000;
const PROGRESS_AFTER_MS = 150;
const PROGRESS_EVERY_MS = 100;

interface Run {
  readonly startedAt: number;
  lastProgressAt: number;
}

let core: Playground | undefined;
let revision = 0;
let inText = NO_SWITCHES;
let run: Run | undefined;
let runWanted = false;
/** The newest run has ended and been reported; its messages can be asked for again in another language. */
let reported = false;
let drawWanted = false;

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
      send({ kind: 'answer', id: message.id, answer: answer(core, message) });
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
      revision = message.revision;
      inText = switchesIn(message.text);
      core.setPlayhead(undefined);
      core.setHover(undefined);
      core.setText(message.text);
      core.setCursor(message.cursor);
      wantRun();
      break;
    case 'cursor':
      core.setCursor(message.offset);
      break;
    case 'hover':
      core.setHover(message.motion);
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
  wantDraw();
}

function answer(playground: Playground, question: Question): Questions[QuestionKind]['answer'] {
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
    case 'playhead': {
      const { distance } = question.ask as Questions['playhead']['ask'];
      wantDraw();
      if (distance !== undefined) return toolAt(playground, distance);
      playground.setPlayhead(undefined);
      return undefined;
    }
    case 'step': {
      const { distance, direction } = question.ask as Questions['step']['ask'];
      wantDraw();
      return toolAt(playground, motionEnd(playground, distance, direction));
    }
    case 'locate': {
      const { x, z } = question.ask as Questions['locate']['ask'];
      const [px = 0, py = 0] = playground.screenOf(x, z);
      return { x: px, y: py };
    }
    case 'expand':
      return writtenOut(playground);
    case 'codes':
      return playground.codes();
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
  playground.setPlayhead(undefined);
  wantRun();
}

// ---- the run --------------------------------------------------------------------------------------

function wantRun(): void {
  runWanted = true;
  reported = false;
  queueSlice();
}

function queueSlice(): void {
  if (sliceQueued) return;
  sliceQueued = true;
  slices.port2.postMessage(undefined);
}

function slice(): void {
  if (core === undefined) return;
  const now = performance.now();
  if (runWanted) {
    runWanted = false;
    run = { startedAt: now, lastProgressAt: now };
    core.start();
  }
  if (run === undefined) return;
  let ended = core.advance(BLOCKS_PER_SLICE);
  const later = performance.now();
  if (!ended && later - run.startedAt > RUN_LIMIT_MS) {
    core.stop((later - run.startedAt) / 1000);
    ended = true;
  }
  if (ended) {
    run = undefined;
    report(core);
    wantDraw();
    return;
  }
  if (later - run.startedAt > PROGRESS_AFTER_MS && later - run.lastProgressAt > PROGRESS_EVERY_MS) {
    run.lastProgressAt = later;
    send({ kind: 'progress', revision, done: core.progress() });
  }
  queueSlice();
}

function report(playground: Playground): void {
  reported = true;
  send({
    kind: 'report',
    report: {
      revision,
      summary: playground.summary(),
      diagnostics: playground.diagnostics(),
      pathLength: playground.pathLength(),
      inText,
    },
  });
}

// ---- the tool -------------------------------------------------------------------------------------

function toolAt(playground: Playground, distance: number): ToolPlace {
  playground.setPlayhead(distance);
  return { distance, stroke: playground.playhead() };
}

/** The nearest end of a motion after (before) `distance`, mm along the path. */
function motionEnd(playground: Playground, distance: number, direction: 'next' | 'previous'): number {
  const length = playground.pathLength();
  // Steps off the end the tool may stand on; what is counted in hairs is far below what is shown.
  const hair = Math.max(1e-9 * length, 1e-9);
  const inside = distance + (direction === 'next' ? 2 : -2) * hair;
  const motion = toolAt(playground, Math.min(Math.max(inside, 0), length)).stroke?.motion;
  if (motion === undefined) return distance;
  const end = playground.lengthBefore(direction === 'next' ? motion + 1 : motion);
  // A hair before it: the motion that ends there is named, not the one that begins.
  return Math.min(Math.max(end - hair, 0), length);
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
    guarded(() => core?.draw());
  });
}

/** A panic leaves the interpreter unusable: say so once, and take no further message. */
function guarded(step: () => void): void {
  try {
    step();
  } catch (error) {
    core = undefined;
    run = undefined;
    send({ kind: 'crashed', reason: describe(error) });
  }
}

function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function send(event: WorkerEvent): void {
  self.postMessage(event);
}
