// Calls every export of the package with every kind of JavaScript argument, and reports each call that violates the
// contract: it must return a value or throw an `Error`, in time, and the playground must still work afterwards.
//
//   node tests/package/hostile.mjs PACKAGE [METHOD]        (built for Node; only this method)
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { installCanvas } from './canvas.mjs';

installCanvas();
const require = createRequire(import.meta.url);
const [folder, only] = process.argv.slice(2);
const exported = require(resolve(folder));
Error.stackTraceLimit = 40;

/** Time limit of one call, ms: the programs below have a few blocks. */
const MOST = 5_000;
/** Number of random calls of a method with more argument combinations than that. */
const DRAWN = 400;

const NUMBERS = [
  0, -0, 1, 2, -1, 0.5, -0.5, 1.9999999999, 1e-300, 5e-324, 255.5, 65536, 1e9, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1, 2 ** 32,
  2 ** 53, 2 ** 64, 1e300, -1e300, Number.MAX_VALUE, NaN, Infinity, -Infinity,
];
const TEXTS = [
  '', ' ', '\0', 'section', 'face', 'motion', 'previous', 'all', 'front', 'en', 'ru', 'zh', 'csv', 'stl', 'T0101', '{}', 'null', '[]',
  '{"stock": {"diameter": 1e308, "length": 1e308}}', '{"stock": {"diameter": -1}}', '{"stock":'.repeat(3000), '['.repeat(100_000),
  '\ud800', 'G0 X\udc00 \ud83d', '\ud83d\ude00', '\u2028', '\r', '\n'.repeat(3000), 'G1 X1e999 Z-1e308 F1e-320', '(' + 'x'.repeat(70_000),
  'G0 X50 Z2\nG71 U1 R1\nG71 P1 Q2 U0.4 W0.1 F0.2\nN1 G0 X10\nG1 Z-10\nN2 X50\nM30\n',
];
const OTHERS = [undefined, null, true, {}, [], Symbol('s'), 10n, () => 1, new Date(NaN), new Uint8Array(3), ['G0 X1', 2], new Array(3)];
const HOSTILE = [...NUMBERS, ...TEXTS, ...OTHERS];

/**
 * States in which a method is called: new, while the program runs, after the run, after the material removal, during
 * playback.
 */
const STATES = {
  new: () => {},
  running: (playground) => {
    playground.setText(PROGRAM);
    playground.advance(2);
  },
  run: (playground) => run(playground, PROGRAM),
  machining: (playground) => {
    run(playground, PROGRAM);
    playground.removeMaterial(1);
  },
  machined: (playground) => machine(playground),
  played: (playground) => {
    machine(playground);
    playground.attachCanvas('section', new OffscreenCanvas(300, 200));
    playground.resize('section', 300, 200, 1);
    playground.seek(0.5);
    playground.keep();
  },
};

const PROGRAM = 'O0001 (STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nX32\nG02 X40 Z-24 R4\nG04 X1\nM01\nG00 X100 Z100\nM30\n';

function run(playground, text) {
  playground.setText(text);
  while (!playground.advance(100));
}

function machine(playground) {
  run(playground, PROGRAM);
  while (!playground.removeMaterial(100));
}

let seed = 12345;
/** The same random values in each run. */
function drawn(list) {
  seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
  return list[(seed >>> 8) % list.length];
}

function* lists(arity) {
  if (arity === 0) yield [];
  else if (arity === 1) for (const one of HOSTILE) yield [one];
  else for (let call = 0; call < DRAWN; call++) yield Array.from({ length: arity }, () => drawn(HOSTILE));
  // Numbers only, and a picture name followed by numbers, to get past the validation of names.
  if (arity > 1) {
    for (let call = 0; call < DRAWN; call++) {
      const numbers = Array.from({ length: arity }, () => drawn(NUMBERS));
      yield numbers;
      yield [drawn(['section', 'face']), ...numbers.slice(1)];
    }
  }
}

const problems = new Map();
let calls = 0;

function problem(what, list, why) {
  const shown = list.map((one) => (typeof one === 'string' ? JSON.stringify(one.slice(0, 40)) : String(typeof one === 'object' ? JSON.stringify(one) : String(one))));
  const found = problems.get(what) ?? [];
  found.push(`${what}(${shown.join(', ')}): ${why}`);
  problems.set(what, found);
}

/** The stack of an exception, without the frames that every panic has. */
function frames(thrown) {
  const found = thrown.stack.split('\n').map((line) => line.replace(/\(wasm:.*|gcode_playground\w*\.wasm\.|\[\w{16}\]/g, ''));
  return found.filter((line) => !/rust_|panic|__rustc|std::sys/.test(line)).slice(0, 8).join('\n');
}

/** Makes and judges one call. Returns whether the target can be called again. */
function call(what, list, action) {
  calls++;
  const begun = performance.now();
  let stillThere = true;
  try {
    action();
  } catch (thrown) {
    if (thrown instanceof WebAssembly.RuntimeError) {
      problem(what, list, `trap: ${frames(thrown)}`);
      stillThere = false;
    } else if (!(thrown instanceof Error)) {
      problem(what, list, `throws ${typeof thrown} ${String(thrown)}`);
    } else if (/unsafe aliasing/.test(thrown.message)) {
      stillThere = false;
    }
  }
  const ms = performance.now() - begun;
  if (ms > MOST) problem(what, list, `${ms.toFixed(0)} ms`);
  return stillThere;
}

function begun(prepare) {
  const playground = new exported.Playground();
  playground.setSetup('{}');
  prepare(playground);
  return playground;
}

/** Methods that check the whole state of a playground after a call. */
const AFTERWARDS = ['advance', 'summary', 'diagnostics', 'motions', 'readout', 'progress', 'draw', 'screenOf', 'section', 'setupOverview', 'machiningProgress'];

function afterwards(playground) {
  playground.advance(1000);
  playground.removeMaterial(1000);
  for (const name of AFTERWARDS) {
    const list = { advance: [1], motions: [0, 10], draw: ['section'], screenOf: ['section', 10, -5] }[name] ?? [];
    playground[name](...list);
  }
}

function methods(type) {
  return Object.getOwnPropertyNames(type.prototype).filter((name) => !['constructor', 'free', '__destroy_into_raw'].includes(name));
}

function traverse() {
  const { Playground, PastedText } = exported;
  for (const name of methods(Playground).filter((name) => !only || name === only)) {
    for (const prepare of Object.values(STATES)) {
      let playground = begun(prepare);
      for (const list of lists(Playground.prototype[name].length)) {
        const what = `${name}`;
        let works = call(what, list, () => playground[name](...list));
        works &&= call(`after ${what}`, list, () => afterwards(playground));
        if (!works || ['setText', 'setBytes', 'setSetup', 'stop', 'stopMachining', 'edit', 'setTextFromBuffer'].includes(name)) {
          if (works) playground.free();
          playground = begun(prepare);
        }
        if ((problems.get(what)?.length ?? 0) > 2 || (problems.get(`after ${what}`)?.length ?? 0) > 2) break;
      }
    }
  }
  for (const list of lists(1)) call('new PastedText', list, () => new PastedText(...list).programs());
  const pasted = new PastedText(PROGRAM);
  for (const name of methods(PastedText)) {
    for (const list of lists(pasted[name].length)) call(`PastedText.${name}`, list, () => pasted[name](...list));
  }
  const called = ['Playground', 'PastedText', 'MotionChunk', 'MotionChunkView'];
  const functions = Object.keys(exported).filter((name) => typeof exported[name] === 'function' && !called.includes(name));
  for (const name of functions) {
    for (const list of lists(exported[name].length)) call(name, list, () => exported[name](...list));
  }
}

traverse();
for (const found of problems.values()) console.error(found.slice(0, 2).join('\n'));
console.log(`${calls} calls, ${problems.size} problems`);
process.exitCode = problems.size > 0 || (!only && calls < 100_000) ? 1 : 0;
