// Runs the hostile programs in the shipped wasm, each in a fresh process, and prints one table beside their native
// times. Fails if one takes too long or does not report its message. Run by `cargo xtask test --all` and
// `cargo xtask bench`.
//
//   node tests/speed/hostile.mjs FOLDER [--show ROWS] [--report FILE]
//
// FOLDER contains the programs and cases.json, written by tests/speed/hostile.rs.
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs, promisify } from 'node:util';

/** Allowed time in wasm, as a multiple of the native limit. */
const WASM_FACTOR = 2;
/** Maximum memory of the module, bytes. */
const MOST_MEMORY = 600e6;
/** Rows of the report; all other programs are fast. */
const REPORTED = 60;

const here = fileURLToPath(import.meta.url);
const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { show: { type: 'string' }, report: { type: 'string' }, one: { type: 'string' } },
});
const [folder] = positionals;
const { mostSeconds, attempts, shownLines, cases } = JSON.parse(readFileSync(join(folder, 'cases.json'), 'utf8'));
/** Time limits for an answer, ms. */
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

/**
 * Runs all programs in wasm, one per processor. A program that is too slow runs again alone: V8 compiles on other
 * processors.
 */
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

/** Runs a program in wasm. Records its time, if it is the shortest, and other problems. */
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

/** Everything that a page requests at once, from a module that is new to this process. */
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
  // On a busy machine the processor time is used; it includes what V8 compiles during the run.
  const { user, system } = process.cpuUsage(computed);
  const ms = Math.min(performance.now() - begun, (user + system) / 1000);
  return { ms, told, memory: memory.buffer.byteLength };
}
