// The hostile programs in the shipped wasm, each in a fresh process, beside their native times: one
// table, and an error when one takes too long or is not answered by its message. Run by
// `cargo xtask test --all` and `cargo xtask bench`.
//
//   node tests/speed/hostile.mjs FOLDER [--show ROWS] [--report FILE]
//
// FOLDER has the programs and cases.json, as tests/speed/hostile.rs writes them.
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs, promisify } from 'node:util';

/** In wasm an answer may take so many times as long as natively. */
const WASM_FACTOR = 2;
/** Most memory of the module, bytes. */
const MOST_MEMORY = 600e6;
/** Rows of the report; all others are quick. */
const REPORTED = 60;

const here = fileURLToPath(import.meta.url);
const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { show: { type: 'string' }, report: { type: 'string' }, one: { type: 'string' } },
});
const [folder] = positionals;
const { mostSeconds, attempts, shownLines, cases } = JSON.parse(readFileSync(join(folder, 'cases.json'), 'utf8'));
/** Longest times for an answer, ms. */
const MOST = { native: 1000 * mostSeconds, wasm: 1000 * WASM_FACTOR * mostSeconds };

if (options.one !== undefined) console.log(JSON.stringify(await answer(JSON.parse(options.one))));
else await judge();

async function judge() {
  const problems = await allProblems();
  cases.sort((a, b) => b.wasm - a.wasm);
  console.log(table(Number(options.show ?? cases.length)));
  if (options.report) writeFileSync(options.report, table(REPORTED));
  for (const problem of problems) console.error(problem);
  process.exitCode = problems.length > 0 ? 1 : 0;
}

/** Runs all programs in wasm, one on each processor. One that is late runs again with nothing beside it: V8 compiles on other processors. */
async function allProblems() {
  const waiting = [...cases];
  const problems = [];
  const worker = async () => {
    for (let one = waiting.shift(); one !== undefined; one = waiting.shift()) problems.push(...(await run(one)));
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  for (const one of cases) {
    for (let attempt = 1; attempt < attempts && one.wasm > MOST.wasm; attempt++) problems.push(...(await run(one)));
  }
  return [...problems, ...cases.flatMap(lateness)];
}

/** Runs a program in wasm: its time, if that is the shortest, and what else is wrong. */
async function run(one) {
  const argv = [here, folder, '--one', JSON.stringify(one)];
  const ended = await promisify(execFile)(process.execPath, argv, { timeout: 60_000 }).catch((error) => ({ error }));
  if (ended.error !== undefined) return [`${one.name}: ${ended.error.message}`];
  const { ms, told, memory } = JSON.parse(ended.stdout);
  one.wasm = Math.min(one.wasm ?? Infinity, ms);
  return [
    ...(told ? [] : [`${one.name}: ${one.code} is not told on line ${one.line} in wasm`]),
    ...(one.told ? [] : [`${one.name}: ${one.code} is not told on line ${one.line} natively`]),
    ...(memory > MOST_MEMORY ? [`${one.name}: ${memory} bytes of memory`] : []),
  ];
}

function lateness(one) {
  return [
    ...(one.answer > MOST.native ? [`${one.name}: ${one.answer.toFixed(0)} ms natively`] : []),
    ...(one.wasm > MOST.wasm ? [`${one.name}: ${one.wasm.toFixed(0)} ms in wasm`] : []),
  ];
}

function table(rows) {
  const highest = (column, from = 0) => Math.max(...cases.slice(from).map((one) => one[column])).toFixed(0);
  const lines = [
    `${cases.length} programs; native at most ${highest('answer')} ms, wasm at most ${highest('wasm')} ms.`,
    '',
    '| program | bytes | native, ms | wasm, ms | motions | message |',
    '|---|---:|---:|---:|---:|---|',
  ];
  for (const one of cases.slice(0, rows)) {
    const name = one.name.replaceAll('|', '\\|');
    lines.push(`| ${name} | ${one.bytes} | ${one.answer.toFixed(0)} | ${one.wasm.toFixed(0)} | ${one.motions} | ${one.code} |`);
  }
  if (rows < cases.length) {
    const [native, wasm] = [highest('answer', rows), highest('wasm', rows)];
    lines.push(`| the other ${cases.length - rows}, at most | | ${native} | ${wasm} | | |`);
  }
  return lines.join('\n') + '\n';
}

/** Everything a page asks for at once, from a module that is new to this process. */
async function answer(one) {
  const { Playground, wasm } = await import('./module.mjs');
  const bytes = readFileSync(join(folder, one.file));
  const { memory } = wasm;
  const playground = new Playground();
  playground.setSetup(one.setup);
  const [begun, computed] = [performance.now(), process.cpuUsage()];
  playground.setBytes(bytes);
  while (!playground.advance(1000));
  const summary = playground.summary();
  const told = playground.diagnostics().some((row) => row.code === one.code && row.line === one.line);
  playground.tokens(0, Math.min(summary.lines, shownLines));
  playground.fit('section');
  // On a busy machine the processor time, which counts what V8 compiles beside the run as well.
  const { user, system } = process.cpuUsage(computed);
  const ms = Math.min(performance.now() - begun, (user + system) / 1000);
  return { ms, told, memory: memory.buffer.byteLength };
}
