// Text to motions and messages in wasm under Node, next to a floor: a loop that only reads the numbers and keeps
// the end points. Run by `cargo xtask bench`, which builds www/pkg and writes the programs.
//
//   node benches/wasm.mjs FOLDER          all tables
//
// Every measurement is a process of its own, in turns, so that compiling and first touch of memory count; the
// figures are medians. "Settled" is the same process again and again.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROUNDS = 5;
const here = fileURLToPath(import.meta.url);
const [folder, runner, file] = process.argv.slice(2);

if (runner === undefined) table();
else await measure(runner, file);

function table() {
  console.log('| program | floor (JS), ms | playground (wasm), ms | ratio | motions |');
  console.log('|---|---:|---:|---:|---:|');
  for (const name of ['plain.nc']) {
    const floor = [];
    const own = [];
    for (let round = 0; round < ROUNDS; round++) {
      floor.push(fresh('floor', name));
      own.push(fresh('playground', name));
    }
    const [a, b] = [median(floor.map((run) => run.ms)), median(own.map((run) => run.ms))];
    console.log(`| ${name}, fresh | ${a.toFixed(1)} | ${b.toFixed(1)} | ${(b / a).toFixed(2)} | ${own[0].motions} |`);
  }
  for (const name of ['shaft.nc', 'plain.nc']) {
    const settled = fresh('settled', name);
    console.log(`| ${name}, settled | | ${settled.ms.toFixed(3)} | | ${settled.motions} |`);
  }
}

function fresh(what, name) {
  const run = spawnSync(process.execPath, [here, folder, what, name], { encoding: 'utf8', maxBuffer: 1 << 20 });
  if (run.status !== 0) throw new Error(run.stderr);
  return JSON.parse(run.stdout);
}

async function measure(what, name) {
  const text = readFileSync(join(folder, name), 'latin1');
  if (what === 'floor') {
    const begun = performance.now();
    const motions = floor(text);
    report(performance.now() - begun, motions);
    return;
  }
  const { initSync, Playground } = await import('../www/pkg/gcode_playground.js');
  const module = readFileSync(new URL('../www/pkg/gcode_playground_bg.wasm', import.meta.url));
  initSync({ module });
  const once = () => {
    const playground = new Playground();
    const begun = performance.now();
    playground.setText(text);
    while (!playground.advance(1_000_000));
    const ms = performance.now() - begun;
    const { motions } = playground.summary();
    playground.free();
    return { ms, motions };
  };
  if (what === 'playground') {
    const { ms, motions } = once();
    report(ms, motions);
    return;
  }
  const runs = Array.from({ length: text.length > 1_000_000 ? 6 : 400 }, once);
  const late = runs.slice(runs.length / 2);
  report(median(late.map((run) => run.ms)), late[0].motions);
}

/** Reads every number of the text and keeps X and Z of each line that has one. */
function floor(text) {
  const xs = [];
  const zs = [];
  let [x, z, moved] = [0, 0, false];
  for (let at = 0; at < text.length; ) {
    const letter = text.charCodeAt(at++);
    if (letter === 10) {
      if (moved) {
        xs.push(x);
        zs.push(z);
      }
      moved = false;
    } else if (letter >= 65 && letter <= 90) {
      let [sign, mantissa, scale, point] = [1, 0, 1, false];
      for (; at < text.length; at++) {
        const byte = text.charCodeAt(at);
        if (byte >= 48 && byte <= 57) {
          mantissa = mantissa * 10 + byte - 48;
          if (point) scale *= 10;
        } else if (byte === 46) point = true;
        else if (byte === 45) sign = -1;
        else break;
      }
      const value = (sign * mantissa) / scale;
      if (letter === 88) [x, moved] = [value, true];
      else if (letter === 90) [z, moved] = [value, true];
    }
  }
  return xs.length;
}

function report(ms, motions) {
  console.log(JSON.stringify({ ms, motions }));
}

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[sorted.length >> 1];
}
