// Browser tests: the built page in three engines, found by role and text. Run `cargo xtask site`
// first. tests/browser/README.md says which tests run where, and how to run one of
// them in one engine. PLAYGROUND_TEST_PORT is the port of the page, where 4317 is taken. PLAYGROUND_CHROMIUM
// names an installed Chrome or Chromium; without it Playwright's own is used. PLAYGROUND_ALL_ENGINES=1 runs
// every test in every engine that can run it. The variables of the other engines are in tests/browser/engines/programs.ts.
import { defineConfig } from '@playwright/test';
import type { WorkerOptions } from '../tests/browser/engines/options';

const PORT = Number(process.env['PLAYGROUND_TEST_PORT'] ?? 4317);
const SERVER = `http://127.0.0.1:${PORT}/`;
const executablePath = process.env['PLAYGROUND_CHROMIUM'];

/** The files of these tests. */
const files = (...names: string[]): string[] => names.map((name) => `**/${name}.spec.ts`);

/** What does not run in every engine; tests/browser/README.md says why. */
const CHROMIUM_ONLY = files(
  'accessible',
  'devices',
  'docs',
  'killed-while-typing',
  'links',
  'long-program',
  'many',
  'origins',
  'own-programs-rules',
  'package',
  'parts',
  'phone',
  'playing-smoothly',
  'report',
  'room',
  'solid',
  'stored',
);
const NOT_IN_WEBKIT = files('encodings');
/** Input, storage, canvas, clipboard, worker, layout: what engines differ in. */
const WHERE_ENGINES_DIFFER = files(
  'completion',
  'embedding',
  'failed-loads',
  'files',
  'first-program',
  'layout',
  'own-program',
  'paste',
  'playback',
  'policy',
  'views',
);
/** Their product is built for `cargo xtask test --all` alone. */
const OF_THE_PACKAGE = files('package');

/** Tests that only `cargo xtask test --all` runs, and those that run in Chromium alone without it. */
const [NIGHT, ONE_ENGINE] = [/@night\b/, /@one-engine\b/];

const everywhere = process.env['PLAYGROUND_ALL_ENGINES'] === '1';
const tested = everywhere ? files('*') : WHERE_ENGINES_DIFFER;
const leftOut = everywhere ? [] : [NIGHT, ONE_ENGINE];

export default defineConfig<object, WorkerOptions>({
  testDir: '../tests/browser',
  outputDir: 'test-results',
  globalSetup: './test-finder.ts',
  timeout: 60_000,
  expect: { timeout: 10_000 },
  retries: 1,
  workers: 2,
  reporter: [['list'], ['../tests/browser/engines/flaky.ts']],
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
      testIgnore: everywhere ? [] : OF_THE_PACKAGE,
      grepInvert: everywhere ? [] : NIGHT,
    },
    { name: 'firefox', use: { engine: 'firefox' }, testMatch: tested, testIgnore: CHROMIUM_ONLY, grepInvert: leftOut },
    {
      name: 'webkit',
      use: { engine: 'webkit' },
      testMatch: tested,
      testIgnore: [...CHROMIUM_ONLY, ...NOT_IN_WEBKIT],
      grepInvert: leftOut,
    },
  ],
});
