// One measurement of the playground's wasm package in this process, as one line of JSON.
//
//   node tests/speed/own.mjs fresh|settled|without-lints|part|text|motions|edits|help FILE
import { readFileSync } from 'node:fs';
import { Playground, wasm } from './module.mjs';
import { median, time } from './stopwatch.mjs';

const [what, file] = process.argv.slice(2);
const bytes = readFileSync(file);
const encoder = new TextEncoder();
const EDITS = 200;
const HELPED = 60;

const measures = { fresh, settled, 'without-lints': withoutLints, part, text, motions, edits, help };
console.log(JSON.stringify(measures[what](bytes.toString('latin1'))));

/** From text to motions and messages, for the first time in a process. */
function fresh(program) {
  const playground = new Playground();
  const ms = time(() => run(playground, program));
  const memory = wasm.memory.buffer.byteLength;
  return { ms, rows: playground.summary().motions, memory };
}

/** The same without lints. */
function withoutLints(program) {
  return settled(program, '{"lints": "off"}');
}

/** The same run repeated; the first half warms up. */
function settled(program, setup = '{}') {
  const times = [];
  let rows = 0;
  const enough = performance.now() + 1500;
  while (times.length < 6 || performance.now() < enough) {
    const playground = new Playground();
    playground.setSetup(setup);
    times.push(time(() => run(playground, program)));
    rows = playground.summary().motions;
    playground.free();
  }
  return { ms: median(times.slice(times.length >> 1)), rows };
}

/** Simulates the material removal after the program has run; the first half warms up. */
function part(program) {
  const times = [];
  let corners = 0;
  const enough = performance.now() + 1500;
  while (times.length < 6 || performance.now() < enough) {
    const playground = new Playground();
    run(playground, program);
    times.push(time(() => {
      while (!playground.removeMaterial(1_000));
    }));
    corners = playground.part().polygons.flat().length;
    playground.free();
  }
  return { ms: median(times.slice(times.length >> 1)), corners };
}

/** Ways to pass in a text. Nothing runs: the program is only handed over. */
function text(program) {
  const ways = {
    'setText(string)': (playground) => playground.setText(program),
    'setBytes(bytes)': (playground) => playground.setBytes(bytes),
    'textBuffer, encodeInto, setTextFromBuffer': (playground) => handOver(playground, program),
  };
  const timed = (way) => () => {
    const playground = new Playground();
    const ms = time(() => way(playground));
    playground.free();
    return ms;
  };
  return Object.fromEntries(Object.entries(ways).map(([name, way]) => [name, median(repeated(7, timed(way)))]));
}

/** Ways to read the motions: all columns of all chunks; one column is summed. */
function motions(program) {
  const playground = new Playground();
  run(playground, program);
  const read = (chunk) => {
    let sum = 0;
    for (const x of chunk.x) sum += x;
    return sum;
  };
  const all = (way) => () => time(() => {
    for (let index = 0; index < playground.chunkCount(); index++) read(playground[way](index));
  });
  return {
    'chunk (copies)': median(repeated(9, all('chunk'))),
    'chunkView (views)': median(repeated(9, all('chunkView'))),
  };
}

/** Changes one digit after another at random places; each time everything runs to its end. */
function edits(program) {
  const playground = new Playground();
  run(playground, program);
  playground.summary();
  const random = randomBelow();
  const times = [];
  while (times.length < EDITS) {
    const at = random(program.length);
    if (!(program[at] >= '0' && program[at] <= '9')) continue;
    times.push(time(() => {
      playground.edit(at, at + 1, String(random(10)));
      while (!playground.advance(1000));
      playground.summary();
      playground.diagnostics();
    }));
  }
  return spread(times);
}

/** Requests help at random places: the word there, the state before and after its block, and the completions. */
function help(program) {
  const playground = new Playground();
  run(playground, program);
  const random = randomBelow();
  const asks = { word: () => playground.wordHelp(), state: () => playground.stateHelp(), completion: () => playground.completionHelp(true) };
  const rows = {};
  for (const [name, ask] of Object.entries(asks)) {
    rows[name] = spread(repeated(HELPED, () => {
      const at = random(program.length);
      return time(() => {
        if (!playground.askBlock(at, undefined)) while (!playground.lookForAnswer(20_000));
        ask();
      });
    }));
  }
  return rows;
}

/** Median, 95th percentile and maximum of the times. */
function spread(times) {
  const sorted = times.toSorted((a, b) => a - b);
  return { median: median(sorted), p95: sorted[Math.floor(0.95 * sorted.length)], max: sorted.at(-1) };
}

/** The same pseudo-random numbers in each process. */
function randomBelow() {
  let seed = 1;
  return (below) => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) % below;
}

function run(playground, program) {
  handOver(playground, program);
  while (!playground.advance(1_000_000));
}

/** Hands over the text as the page does; the programs are ASCII. */
function handOver(playground, program) {
  const { written } = encoder.encodeInto(program, playground.textBuffer(program.length));
  playground.setTextFromBuffer(written);
}

function repeated(times, measured) {
  return Array.from({ length: times }, () => measured());
}
