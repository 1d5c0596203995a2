// Browser tests: the built page in a real Chromium, found by role and text. Run `npm run build` first.
// PLAYGROUND_CHROMIUM names an installed Chrome or Chromium; without it Playwright's own is used.
import { defineConfig } from '@playwright/test';

const PORT = 4317;
const executablePath = process.env['PLAYGROUND_CHROMIUM'];

export default defineConfig({
  testDir: '../tests/browser',
  outputDir: 'test-results',
  timeout: 60_000,
  expect: { timeout: 10_000 },
  retries: 0,
  workers: 2,
  reporter: 'list',
  webServer: {
    command: `npm run preview -- --port ${PORT} --strictPort --host 127.0.0.1`,
    url: `http://127.0.0.1:${PORT}/`,
    timeout: 30_000,
  },
  use: {
    baseURL: `http://127.0.0.1:${PORT}/`,
    browserName: 'chromium',
    locale: 'en-US',
    viewport: { width: 1440, height: 900 },
    launchOptions: {
      ...(executablePath === undefined || executablePath === '' ? {} : { executablePath }),
      args: [
        '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync',
      ],
    },
  },
});
