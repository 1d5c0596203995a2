// Compares the Node functions of the package with the command line, for all test programs: the same messages, in three
// languages, and the same motions.
//
//   node node.mjs ROOT    copied into a project that has the package installed
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { check, motions } from 'gcode-playground';

const [root] = process.argv.slice(2);
const commandLine = join(process.env.CARGO_TARGET_DIR ?? join(root, 'target'), 'debug', process.platform === 'win32' ? 'gcode-playground.exe' : 'gcode-playground');

/** The output rows of the command line. Status 1 means that a program has errors. */
function rows(...words) {
  let text;
  try {
    text = execFileSync(commandLine, words, { encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore'] });
  } catch (error) {
    if (error.status !== 1) throw error;
    text = error.stdout;
  }
  return text.split('\n').filter((line) => line !== '').map((line) => JSON.parse(line));
}

/** As serialised: keys without a value are omitted. */
const json = (value) => JSON.parse(JSON.stringify(value));
/** Without a given blank the command line removes no material, and therefore does not report this rule. */
const LEFT_OUT = 'not-checked-behind-fault';

let compared = 0;
for (const name of readdirSync(join(root, 'tests', 'programs'))) {
  const folder = join(root, 'tests', 'programs', name);
  const [file, setupFile] = [join(folder, 'program.nc'), join(folder, 'setup.json')];
  if (!existsSync(file)) continue;
  const more = existsSync(setupFile) ? ['--setup', setupFile] : [];
  const setup = more.length > 0 ? readFileSync(setupFile, 'utf8') : undefined;
  const language = ['en', 'zh', 'ru'][compared % 3];
  const bytes = readFileSync(file);
  const program = compared % 2 === 0 ? bytes : bytes.toString('utf8');
  // The title of the rule is for tools that do not know the rules.
  const expected = rows('check', '--format', 'json', '--language', language, ...more, file).filter(({ code }) => code !== undefined).map(({ file: _, title: __, ...row }) => row);
  const isExpected = ({ slug }) => slug !== LEFT_OUT || expected.some((row) => row.slug === LEFT_OUT);
  assert.deepEqual(json(check(program, setup, { language })).filter(isExpected), expected, `messages of ${name}`);
  assert.deepEqual(json(motions(program, setup && JSON.parse(setup))), rows('motions', ...more, file), `motions of ${name}`);
  compared++;
}

// Offsets count in the original text, with any line ends: applying safe fixes by offset fixes it.
const faulty = 'O0001 (外圆 😀)\nT0101 (ROUGH\nGO1 X5 F0.1 M3 S500\nM30\n';
const mixed = faulty.replace('\n', '\r\n').replace('ROUGH\n', 'ROUGH\r');
for (const text of [faulty, faulty.replaceAll('\n', '\r\n'), faulty.replaceAll('\n', '\r'), mixed]) {
  const found = check(text);
  const letter = found.find(({ slug }) => slug === 'letter-for-digit');
  assert.equal(text.slice(letter.from, letter.to), 'GO1', JSON.stringify(text));
  const edits = found.flatMap(({ fixes }) => fixes.filter(({ safe }) => safe).flatMap((fix) => fix.edits)).sort((a, b) => b.from - a.from);
  const repaired = edits.reduce((now, { from, to, text: own }) => now.slice(0, from) + own + now.slice(to), text);
  assert.equal(repaired, text.replace('GO1', 'G01').replace('(ROUGH', '(ROUGH)'));
}

console.log(`${compared} programs as on the command line`);
