// One measurement of the floor, or of a crate, in wasm:
// `node tests/speed/peers/crates.mjs NAME fresh|settled FILE`.
import { readFileSync } from 'node:fs';
import { initSync, Input } from './pkg/bench_peers.js';
import { median } from '../stopwatch.mjs';

const [name, how, file] = process.argv.slice(2);
const program = readFileSync(file, 'latin1');
const { memory } = initSync({ module: readFileSync(new URL('pkg/bench_peers_bg.wasm', import.meta.url)) });
const encoder = new TextEncoder();

function once() {
  const begun = performance.now();
  const input = new Input(program.length);
  encoder.encodeInto(program, new Uint8Array(memory.buffer, input.address(), program.length));
  const outcome = input.run(name);
  const ms = performance.now() - begun;
  if (outcome === undefined) throw new Error(`${name} is not in this build`);
  const { rows } = outcome;
  outcome.free();
  return { ms, rows };
}

if (how === 'fresh') console.log(JSON.stringify(once()));
else {
  const all = Array.from({ length: program.length > 1_000_000 ? 8 : 400 }, once);
  const late = all.slice(all.length >> 1).map(({ ms }) => ms);
  console.log(JSON.stringify({ ms: median(late), rows: all[0].rows }));
}
