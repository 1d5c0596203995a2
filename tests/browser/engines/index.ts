// `test` and `expect` of the tests that run in every engine: the page is Playwright's own in Chromium, and a
// `ForeignPage` in Firefox and WebKit. The project in playwright.config.ts selects the engine.
import {
  test as base,
  type Page as PlaywrightPage,
  type PlaywrightTestArgs,
  type PlaywrightTestOptions,
  type PlaywrightWorkerArgs,
  type PlaywrightWorkerOptions,
  type TestType,
} from '@playwright/test';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { noteCrash, refuseSecondTry } from './crashes';
import type { Driver } from './driver';
import { firefox } from './firefox';
import { ForeignPage } from './foreign';
import type { Page } from './interface';
import type { EngineName, TestOptions, WorkerOptions } from './options';
import { webkit } from './webkit';

export { expect } from './expect';
export type { BasicPage, Box, Download, Locator, Page } from './interface';

interface WorkerFixtures extends WorkerOptions {
  driver: Driver | undefined;
}

/** Runs in the page: removes the service worker API, as in a browser without it. */
const withoutStoring = (): void => void Reflect.deleteProperty(Navigator.prototype, 'serviceWorker');

/** Details of a test in one variant of several: without `--all`, only the usual variant runs. */
export const nightUnless = (isUsual: boolean): { readonly tag: string[] } => ({ tag: isUsual ? [] : ['@night'] });

const VIEWPORT = { width: 1440, height: 900 };

const extended = base.extend<TestOptions, WorkerFixtures>({
  storing: ['off', { option: true }],
  engine: ['chromium', { option: true, scope: 'worker' }],
  server: ['', { option: true, scope: 'worker' }],
  driver: [
    async ({ engine, server }, use) => {
      const driver =
        engine === 'firefox'
          ? await firefox(VIEWPORT)
          : engine === 'webkit'
            ? await webkit(VIEWPORT, server)
            : undefined;
      await use(driver);
      await driver?.close();
    },
    { scope: 'worker', timeout: 120_000 },
  ],
  browser: [
    async ({ engine, playwright, launchOptions }, use) => {
      // Only Chromium runs in a browser that Playwright starts.
      const browser = engine === 'chromium' ? await playwright.chromium.launch(launchOptions) : undefined;
      await use(browser as never);
      await browser?.close();
    },
    { scope: 'worker', timeout: 120_000 },
  ],
  page: async ({ driver, browser, server, storing }, use, testInfo) => {
    refuseSecondTry(testInfo);
    if (driver === undefined) {
      // Headed Chromium lets a page copy after a click; headless Chromium needs this permission.
      const context = await browser.newContext({ permissions: ['clipboard-write'] });
      if (storing === 'off') await context.addInitScript(withoutStoring);
      await use(await context.newPage());
      await context.close();
      return;
    }
    const finder = readFileSync(join(__dirname, '..', '..', '..', 'www', 'test-build', 'finder.js'), 'utf8');
    try {
      const page = new ForeignPage(await driver.open(), finder, server);
      if (storing === 'off') await page.addInitScript(withoutStoring);
      await use(page as never);
      if (testInfo.errors.length > 0) writeFileSync(testInfo.outputPath('page.txt'), await page.contents());
      await page.close();
    } catch (error) {
      noteCrash(testInfo, error);
      throw error;
    }
  },
});

/** The fixtures of a test for every engine. */
interface Given extends TestOptions {
  page: Page;
  engine: EngineName;
}

export const test = extended as unknown as TestType<Given, object>;

/** Playwright's own page, which is also a `Page`, except for some argument types. */
export type ChromiumPage = PlaywrightPage & Page;

/** For features that only Chromium has or reports: the page is Playwright's own, with its full interface. */
export const chromiumTest = base.extend<TestOptions>({
  storing: ['off', { option: true }],
  context: async ({ context, storing }, use, testInfo) => {
    refuseSecondTry(testInfo);
    if (storing === 'off') await context.addInitScript(withoutStoring);
    await use(context);
  },
}) as unknown as TestType<
  Omit<PlaywrightTestArgs, 'page'> & PlaywrightTestOptions & TestOptions & { page: ChromiumPage },
  PlaywrightWorkerArgs & PlaywrightWorkerOptions
>;
