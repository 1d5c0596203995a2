// `test` and `expect` of the tests that run in every engine: the page they are given is Playwright's
// own in Chromium, and a `ForeignPage` in Firefox and WebKit. Which engine it is stands in the
// project of playwright.config.ts.
import {
  test as base,
  type Page as PlaywrightPage,
  type PlaywrightTestArgs,
  type PlaywrightTestOptions,
  type PlaywrightWorkerArgs,
  type PlaywrightWorkerOptions,
  type TestType,
} from '@playwright/test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
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

/** Runs in the page: it finds no service workers, as in a browser that has none. */
const withoutStoring = (): void => void Reflect.deleteProperty(Navigator.prototype, 'serviceWorker');

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
      // Engines that Playwright does not drive have none of its browsers.
      const browser = engine === 'chromium' ? await playwright.chromium.launch(launchOptions) : undefined;
      await use(browser as never);
      await browser?.close();
    },
    { scope: 'worker', timeout: 120_000 },
  ],
  page: async ({ driver, browser, server, storing }, use) => {
    if (driver === undefined) {
      // With windows Chromium lets a page copy at a press; without them it needs this permission.
      const context = await browser.newContext({ permissions: ['clipboard-write'] });
      if (storing === 'off') await context.addInitScript(withoutStoring);
      await use(await context.newPage());
      await context.close();
      return;
    }
    const finder = readFileSync(join(__dirname, '..', '..', '..', 'www', 'test-build', 'finder.js'), 'utf8');
    const page = new ForeignPage(await driver.open(), finder, server);
    if (storing === 'off') await page.addInitScript(withoutStoring);
    await use(page as never);
    await page.close();
  },
});

/** What a test of every engine is given, and no more. */
interface Given extends TestOptions {
  page: Page;
  engine: EngineName;
}

export const test = extended as unknown as TestType<Given, object>;

/** Playwright's own page, which is a `Page`, too, but for types of arguments. */
export type ChromiumPage = PlaywrightPage & Page;

/** For what only Chromium has or reports: the page is Playwright's own, with all it can do. */
export const chromiumTest = base.extend<TestOptions>({
  storing: ['off', { option: true }],
  context: async ({ context, storing }, use) => {
    if (storing === 'off') await context.addInitScript(withoutStoring);
    await use(context);
  },
}) as unknown as TestType<
  Omit<PlaywrightTestArgs, 'page'> & PlaywrightTestOptions & TestOptions & { page: ChromiumPage },
  PlaywrightWorkerArgs & PlaywrightWorkerOptions
>;
