// The package's functions for Node against the command line, over all programs of the tests: the same messages, in three
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

/** What the command line prints, row by row; 1 is its status where a program has errors. */
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

/** As it is written: keys without a value are left out. */
const json = (value) => JSON.parse(JSON.stringify(value));
/** The command line takes no material off where no blank is given, and then cannot say what of it was left out. */
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
  const expected = rows('check', '--format', 'json', '--language', language, ...more, file).filter(({ code }) => code !== undefined).map(({ file: _, ...row }) => row);
  const isExpected = ({ slug }) => slug !== LEFT_OUT || expected.some((row) => row.slug === LEFT_OUT);
  assert.deepEqual(json(check(program, setup, { language })).filter(isExpected), expected, `messages of ${name}`);
  assert.deepEqual(json(motions(program, setup && JSON.parse(setup))), rows('motions', ...more, file), `motions of ${name}`);
  compared++;
}
console.log(`${compared} programs as on the command line`);
