// Browser tests of the built page in three engines; elements are found by role and text. Run `cargo xtask site` first.
// tests/browser/README.md says which tests run in which engine, and how to run a single one. PLAYGROUND_TEST_PORT: the
// port of the page if 4317 is in use. PLAYGROUND_CHROMIUM: an installed Chrome or Chromium; default: Playwright's own.
// PLAYGROUND_ALL_ENGINES=1 runs every test in every engine that supports it. The variables of the other engines are in
// tests/browser/engines/programs.ts.
import { defineConfig } from '@playwright/test';
import type { WorkerOptions } from '../tests/browser/engines/options';

const PORT = Number(process.env['PLAYGROUND_TEST_PORT'] ?? 4317);
const SERVER = `http://127.0.0.1:${PORT}/`;
const executablePath = process.env['PLAYGROUND_CHROMIUM'];

/** Patterns of test files. */
const specFiles = (...names: string[]): string[] => names.map((name) => `**/${name}.spec.ts`);

/** Tests that do not run in every engine; tests/browser/README.md gives the reasons. */
const CHROMIUM_ONLY = specFiles(
  'accessible',
  'devices',
  'dialogs',
  'docs',
  'frameworks',
  'killed-while-typing',
  'manual',
  'links',
  'long-program',
  'many',
  'origins',
  'own-programs-rules',
  'package',
  'parts',
  'parts-page',
  'phone',
  'playing-smoothly',
  'report',
  'room',
  'solid',
  'stored',
  'vscode',
);
const NOT_IN_WEBKIT = specFiles('encodings');
/** Areas in which engines differ: input, storage, canvas, clipboard, worker, layout. */
const ENGINE_DEPENDENT = specFiles(
  'completion',
  'embedding',
  'files',
  'first-program',
  'layout',
  'own-program',
  'paste',
  'policy',
);
/** Files that run only with `cargo xtask test --all`: they wait for networks, service workers and reloads. */
const NIGHTLY_FILES = specFiles('bad-input', 'failed-loads', 'offline', 'parts', 'sources', 'stored', 'switching');
/** Their packages are built only by `cargo xtask test --all`. */
const PACKAGE_ONLY = specFiles('package', 'vscode');

/** Tests that run only with `cargo xtask test --all`, and tests that otherwise run only in Chromium. */
const [NIGHTLY, ONE_ENGINE] = [/@night\b/, /@one-engine\b/];

const allEngines = process.env['PLAYGROUND_ALL_ENGINES'] === '1';
const engineTests = allEngines ? specFiles('*') : ENGINE_DEPENDENT;
const excludedTags = allEngines ? [] : [NIGHTLY, ONE_ENGINE];

export default defineConfig<object, WorkerOptions>({
  testDir: '../tests/browser',
  outputDir: 'test-results',
  globalSetup: './test-finder.ts',
  timeout: 90_000,
  expect: { timeout: 20_000 },
  workers: 2,
  reporter: 'list',
  webServer: {
    command: `npm run preview -- --port ${PORT} --strictPort --host 127.0.0.1`,
    url: SERVER,
    timeout: 30_000,
  },
  use: {
    baseURL: SERVER,
    server: SERVER,
    browserName: 'chromium',
    locale: 'en-US',
    viewport: { width: 1440, height: 900 },
    launchOptions: {
      ...(executablePath === undefined || executablePath === '' ? {} : { executablePath }),
      args: [
        '--no-sandbox',
        '--disable-gpu',
        '--disable-quic',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
      ],
    },
  },
  projects: [
    {
      name: 'chromium',
      use: { engine: 'chromium' },
      testIgnore: allEngines ? [] : [...PACKAGE_ONLY, ...NIGHTLY_FILES],
      grepInvert: allEngines ? [] : NIGHTLY,
    },
    {
      name: 'firefox',
      use: { engine: 'firefox' },
      testMatch: engineTests,
      testIgnore: CHROMIUM_ONLY,
      grepInvert: excludedTags,
    },
    {
      name: 'webkit',
      use: { engine: 'webkit' },
      // Only for a test whose browser crashed, see engines/crashes.ts. Otherwise a test that passes at the second try is
      // a defect.
      retries: 1,
      testMatch: engineTests,
      testIgnore: [...CHROMIUM_ONLY, ...NOT_IN_WEBKIT],
      grepInvert: excludedTags,
    },
  ],
});
