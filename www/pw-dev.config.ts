import { defineConfig } from '@playwright/test';
const port = process.env['PORT'] ?? '8401';
export default defineConfig({
  testDir: '/tmp/w/pictures/tests/browser', outputDir: `/tmp/pix/results-${port}`, timeout: 60_000, expect: { timeout: 10_000 }, workers: 1, reporter: 'list',
  use: { baseURL: `http://127.0.0.1:${port}/`, browserName: 'chromium', locale: 'en-US', viewport: { width: 1440, height: 900 },
    launchOptions: { executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'] } },
});
