// Runs all measurements of `cargo xtask bench`, round by round, and prints their tables. Each measurement is a separate
// process. Every round runs all of them in turn, so that a slow minute of the machine affects all. Ratios are taken
// within a round. Figures are medians over the rounds.
//
//   node tests/speed/measure.mjs FOLDER --binaries DIR [--peers DIR] [--rounds N] [--own] [--report FILE]
//
// FOLDER contains the programs, DIR the native binaries. --own measures only the playground and the floor.
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { median } from './stopwatch.mjs';

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { binaries: { type: 'string' }, peers: { type: 'string' }, rounds: { type: 'string' }, own: { type: 'boolean' }, report: { type: 'string' } },
});
const [folder] = positionals;
const rounds = Number(options.rounds ?? 5);
const here = fileURLToPath(new URL('.', import.meta.url));
const program = (name) => join(folder, `${name}.nc`);
const lines = (name) => readFileSync(program(name), 'latin1').split('\n').length - 1;
const node = (script, ...argv) => [process.execPath, '--max-old-space-size=8000', join(here, script), ...argv];
const TITLES = { plain: 'a million plain lines', shaft: 'a shaft of sixty lines: G71 G70 G74 G75 G76', boxes: 'ten thousand G90 cycles' };
const contours = programsOf('contour');
const passes = programsOf('passes');
const PARTS = ['shaft', ...passes];
const SETTLED = ['plain', 'shaft', 'boxes', ...contours];

const jobs = new Map();
const add = (name, argv, more = {}) => jobs.set(name, { argv, runs: [], ...more });
const FLOOR = 'floor, wasm';
const OWN = 'gcode-playground, wasm';

// The floor runs first in each round: the others are compared with it.
add(FLOOR, node('peers/crates.mjs', 'floor', 'fresh', program('plain')));
add('floor, native', [join(options.peers, 'native'), 'floor', program('plain')]);
add(OWN, node('own.mjs', 'fresh', program('plain')));
add('gcode-playground, native', [join(options.binaries, 'native'), program('plain')]);
if (!options.own) peers();
add('floor settled', node('peers/crates.mjs', 'floor', 'settled', program('plain')));
for (const name of SETTLED) {
  add(`settled ${name}`, node('own.mjs', 'settled', program(name)));
  add(`without lints ${name}`, node('own.mjs', 'without-lints', program(name)));
}
for (const name of PARTS) add(`part ${name}`, node('own.mjs', 'part', program(name)));
for (const what of ['text', 'motions', 'edits']) add(what, node('own.mjs', what, program('plain')));
const HELPED = { short: '3,000 plain lines', plain: 'a million plain lines', rounds: '3,000 lines in loops and calls: 180,000 blocks' };
for (const name of Object.keys(HELPED)) add(`help ${name}`, node('own.mjs', 'help', program(name)));
add('browser', node('page/measure.mjs', program('plain')));

function peers() {
  const npm = JSON.parse(readFileSync(join(here, 'peers/package.json'), 'utf8')).dependencies;
  for (const [name, version] of Object.entries(npm)) add(`${name} ${version} (npm)`, node('peers/npm.mjs', name, program('plain')));
  const manifest = readFileSync(join(here, 'peers/Cargo.toml'), 'utf8');
  for (const [, name, version] of manifest.matchAll(/^([a-z-]+) = \{ version = "=([\d.]+)", .*optional/gm)) {
    add(`${name} ${version} (crate), wasm`, node('peers/crates.mjs', name, 'fresh', program('plain')));
    add(`${name} ${version} (crate), native`, [join(options.peers, 'native'), name, program('plain')]);
  }
  add('LinuxCNC rs274 (whole process)', ['rs274', '-g', program('plain'), '/dev/null'], { external: true });
}

for (let round = 1; round <= rounds; round++) {
  for (const [name, job] of jobs) if (job.problem === undefined) measure(name, job);
  console.error(`round ${round} of ${rounds} is done`);
}
const report = [interpreting(), settled(), parts(), boundary(), memory(), edits(), help(), browser()].join('\n\n') + '\n';
console.log(report);
if (options.report) writeFileSync(options.report, report);

function measure(name, job) {
  const begun = performance.now();
  const run = spawnSync(job.argv[0], job.argv.slice(1), { encoding: 'utf8', timeout: 120_000, maxBuffer: 1 << 26 });
  const wall = performance.now() - begun;
  if (run.error?.code === 'ENOENT') job.problem = 'not installed';
  else if (run.status !== 0) job.problem = `failed: ${(run.stderr || String(run.error)).trim().split('\n').at(-1)}`;
  else job.runs.push(job.external ? { ms: wall } : JSON.parse(run.stdout.trim().split('\n').at(-1)));
  if (job.problem !== undefined) console.error(`${name}: ${job.problem}`);
}

/** The runs of a job. Fails if one of ours failed. */
function runsOf(name) {
  const { runs, problem } = jobs.get(name);
  if (problem !== undefined) throw new Error(`${name}: ${problem}`);
  return runs;
}

function interpreting() {
  const count = lines('plain');
  const floor = runsOf(FLOOR);
  const measured = [...jobs].filter(([, job]) => job.argv.includes(program('plain')) && job.runs[0]?.ms !== undefined)
    .filter(([name]) => !name.includes('settled') && !name.includes('without lints'));
  measured.sort(([, a], [, b]) => medianOf(a.runs, 'ms') - medianOf(b.runs, 'ms'));
  const rows = measured.map(([name, { runs }]) => {
    const ratio = median(runs.map(({ ms }, round) => ms / floor[round].ms));
    const ms = medianOf(runs, 'ms');
    return [name, fixed(ms), range(runs, 'ms'), ratio.toFixed(2), (count / ms / 1000).toFixed(2), runs[0].rows ?? ''];
  });
  for (const [name, { problem }] of jobs) if (problem !== undefined) rows.push([name, problem, '', '', '', '']);
  return table(`A million plain lines, the first time in a process (${rounds} rounds)`,
    ['', 'ms', 'min–max', '× wasm floor', 'Mlines/s', 'rows'], rows);
}

function settled() {
  const floor = medianOf(runsOf('floor settled'), 'ms');
  const rows = SETTLED.map((name) => {
    const runs = runsOf(`settled ${name}`);
    const ms = medianOf(runs, 'ms');
    const per = name.startsWith('contour') ? ((1e6 * ms) / (runs[0].rows + 2 * numberOf(name))).toFixed(0) : '';
    return [TITLES[name] ?? `G71 by 0.1 mm and G70 over ${numberOf(name)} points`, ms.toFixed(3), range(runs, 'ms'), withoutLints(name), runs[0].rows, per];
  });
  rows.unshift(['a million plain lines, floor', floor.toFixed(3), range(runsOf('floor settled'), 'ms'), '', '', '']);
  return table('Settled: again and again in one process, wasm', ['program', 'ms', 'min–max', 'without lints', 'motions', 'ns for each motion and point read'], rows);
}

/** The time without lints, in percent of the time with them. */
function withoutLints(name) {
  const [with_, without] = [runsOf(`settled ${name}`), runsOf(`without lints ${name}`)];
  return `${(100 * median(without.map(({ ms }, round) => ms / with_[round].ms))).toFixed(0)} %`;
}

function parts() {
  const rows = PARTS.map((name) => {
    const runs = runsOf(`part ${name}`);
    const ms = medianOf(runs, 'ms');
    const per = name.startsWith('passes') ? ((1000 * ms) / numberOf(name)).toFixed(0) : '';
    return [TITLES[name] ?? `G71 in ${numberOf(name)} passes and G70`, ms.toFixed(2), range(runs, 'ms'), runs[0].corners, per];
  });
  return table('The part: the material off the blank, and what runs into what, settled, wasm', ['program', 'ms', 'min–max', 'corners of the part', 'µs a pass'], rows);
}

function boundary() {
  const rows = ['text', 'motions'].flatMap((what) => {
    const runs = runsOf(what);
    return Object.keys(runs[0]).map((way) => [way, fixed(medianOf(runs, way)), range(runs, way)]);
  });
  return table('Over the boundary: 20 MB of text in, the columns of a million motions out and one of them read', ['way', 'ms', 'min–max'], rows);
}

function memory() {
  const [run] = runsOf(OWN);
  const bytes = readFileSync(program('plain')).length;
  const row = [(run.memory / 1e6).toFixed(1), ((run.memory - bytes) / run.rows).toFixed(1), (run.memory / bytes).toFixed(1)];
  return table('Memory of the module after a million plain lines', ['MB', 'bytes a motion, beside the text', 'bytes a byte of text'], [row]);
}

function edits() {
  const runs = runsOf('edits');
  const row = ['median', 'p95', 'max'].map((figure) => medianOf(runs, figure).toFixed(1));
  return table('A digit changed at 200 places of the million lines, each time run to the end again, ms', ['median', '95 %', 'longest'], [row]);
}

function help() {
  const rows = Object.entries(HELPED).map(([name, title]) => {
    const runs = runsOf(`help ${name}`);
    const p95 = (what) => medianOf(runs.map((run) => run[what]), 'p95').toFixed(1);
    return [title, p95('word'), p95('state'), p95('completion')];
  });
  return table('Help at 60 places, each the first time its block is asked about: the 95th percentile, ms', ['program', 'word', 'state', 'what can be written'], rows);
}

function browser() {
  const { runs, problem } = jobs.get('browser');
  if (problem !== undefined) return `### In Chromium\n\n${problem}`;
  const rows = [
    ['interpreting, fresh', 'fresh'], ['interpreting, settled', 'settled'], ['measuring the picture', 'measured'],
    ['painting the whole picture, all slices', 'picture'], ['the longest slice', 'slice'],
    ['plain batches of Path2D: making them', 'building'], ['plain batches of Path2D: stroking them', 'plain'],
  ].map(([name, figure]) => [name, fixed(medianOf(runs, figure)), range(runs, figure)]);
  return table('The same in headless Chromium, drawn by software', ['', 'ms', 'min–max'], rows);
}

/** The programs of a kind, such as `contour-100`, ordered by number. */
function programsOf(kind) {
  const names = readdirSync(folder).filter((name) => new RegExp(`^${kind}-\\d+\\.nc$`).test(name)).map((name) => name.slice(0, -3));
  return names.sort((a, b) => numberOf(a) - numberOf(b));
}

function table(title, head, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  return [`### ${title}`, '', line(head), `|---|${'---:|'.repeat(head.length - 1)}`, ...rows.map(line)].join('\n');
}

/** Number of contour points in a program `contour-N`. */
function numberOf(name) {
  return Number(/\d+$/.exec(name)?.[0]);
}

function medianOf(runs, figure) {
  return median(runs.map((run) => run[figure]));
}

function range(runs, figure) {
  const values = runs.map((run) => run[figure]);
  return `${fixed(Math.min(...values))}–${fixed(Math.max(...values))}`;
}

function fixed(ms) {
  return ms < 1 ? ms.toFixed(3) : ms < 100 ? ms.toFixed(1) : ms.toFixed(0);
}
