// Drives Firefox over WebDriver BiDi, by puppeteer-core.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import {
  launch,
  type Browser,
  type BrowserContext,
  type ElementHandle,
  type KeyInput,
  type Page,
} from 'puppeteer-core';
import { DocumentLeft, type Driver, type Tab, within } from './driver';
import { program } from './programs';

/** Timeout for a response of Firefox, ms; a script may take long. */
const TIMEOUT = 120_000;

export async function firefox(viewport: { width: number; height: number }): Promise<Driver> {
  const browser = await launch({
    browser: 'firefox',
    executablePath: program('PLAYGROUND_FIREFOX'),
    headless: true,
    protocolTimeout: TIMEOUT,
    timeout: 60_000,
    defaultViewport: viewport,
    extraPrefsFirefox: {
      'intl.accept_languages': 'en-US',
      'intl.locale.requested': 'en-US',
      'browser.download.alwaysOpenPanel': false,
    },
  });
  return {
    open: async () => {
      const downloads = await mkdtemp(join(tmpdir(), 'playground-firefox-'));
      const context = await browser.createBrowserContext({
        downloadBehavior: { policy: 'allow', downloadPath: downloads },
      });
      return new FirefoxTab(await context.newPage(), context, downloads);
    },
    close: () => within(20_000, 'closing Firefox', browser.close(), () => end(browser)),
  };
}

/** puppeteer's name of a key; it has no key named `Space`, only the character. */
function named(key: string): KeyInput {
  return (key === 'Space' ? ' ' : key === '\n' ? 'Enter' : key) as KeyInput;
}

function end(browser: Browser): void {
  browser.process()?.kill('SIGKILL');
}

class FirefoxTab implements Tab {
  private readonly pageErrors: string[] = [];
  private readonly beside: Page[] = [];

  constructor(
    private readonly page: Page,
    private readonly context: BrowserContext,
    readonly downloads: string,
  ) {
    page.on('pageerror', (error) =>
      this.pageErrors.push(error instanceof Error ? (error.stack ?? error.message) : String(error)),
    );
    page.on('popup', (popup) => popup !== null && this.beside.push(popup));
  }

  async goto(address: string): Promise<void> {
    await this.page.goto(address, { waitUntil: 'load', timeout: 60_000 });
  }
  async reload(): Promise<void> {
    await this.page.reload({ waitUntil: 'load', timeout: 60_000 });
  }
  async back(): Promise<void> {
    // puppeteer would wait for a load event, which a document restored from the back/forward cache does not fire.
    const here = await this.evaluate('performance.timeOrigin');
    await this.evaluate('void setTimeout(() => history.back())');
    while ((await this.evaluate('performance.timeOrigin').catch(() => here)) === here) await pause(20);
  }
  url(): Promise<string> {
    return this.evaluate('location.href') as Promise<string>;
  }
  async addInitScript(source: string): Promise<void> {
    await this.page.evaluateOnNewDocument(source);
  }
  async evaluate(expression: string): Promise<unknown> {
    return this.page.evaluate(expression).catch((error: unknown) => {
      throw /context was destroyed|frame got detached/i.test(String(error))
        ? new DocumentLeft(String(error), { cause: error })
        : error;
    });
  }
  keyDown(key: string): Promise<void> {
    return this.page.keyboard.down(named(key));
  }
  keyUp(key: string): Promise<void> {
    return this.page.keyboard.up(named(key));
  }
  async typeKeys(text: string): Promise<void> {
    for (const each of text) await this.page.keyboard.press(named(each));
  }
  mouseMove(x: number, y: number): Promise<void> {
    return this.page.mouse.move(x, y);
  }
  mouseDown(): Promise<void> {
    return this.page.mouse.down();
  }
  mouseUp(): Promise<void> {
    return this.page.mouse.up();
  }
  click(x: number, y: number, times: number): Promise<void> {
    return this.page.mouse.click(x, y, { count: times });
  }
  async wheel(_x: number, _y: number, deltaX: number, deltaY: number): Promise<void> {
    await this.page.mouse.wheel({ deltaX, deltaY });
  }
  async chooseFile(expression: string, path: string): Promise<void> {
    const input = (await this.page.evaluateHandle(expression)) as ElementHandle<HTMLInputElement>;
    await input.uploadFile(path);
    await input.dispose();
  }
  async resize(width: number, height: number): Promise<void> {
    await this.page.setViewport({ width, height });
  }
  async screenshot(): Promise<Buffer> {
    return Buffer.from(await this.page.screenshot({ type: 'png' }));
  }
  opened(): Promise<Tab | undefined> {
    const page = this.beside.shift();
    return Promise.resolve(page === undefined ? undefined : new FirefoxTab(page, this.context, this.downloads));
  }
  errors(): Promise<string[]> {
    return Promise.resolve(this.pageErrors.splice(0));
  }
  async close(): Promise<void> {
    await within(20_000, 'closing a tab of Firefox', this.page.close(), () => end(this.context.browser()));
    if ((await this.context.pages()).length > 0) return;
    await within(20_000, 'closing a context of Firefox', this.context.close(), () => end(this.context.browser()));
    await rm(this.downloads, { recursive: true, force: true });
  }
}
