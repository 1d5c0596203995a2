// A page in an engine that Playwright does not drive, built on its driver and on `finder`, which runs in the page.
import { readdirSync, statSync, writeFileSync } from 'node:fs';
import { copyFile, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { DocumentLeft, type Tab } from './driver';
import type { Question, Ready, Step, Wanted } from './finder';
import type { Box, Download, Finds, Keyboard, Locator, Mouse, Page, Role, Text } from './interface';

/** Timeout of an action, ms. */
export const TIMEOUT = 20_000;
/** Polling interval, ms. */
const PAUSE = 60;

const wanted = (text: Text, exact = false): Wanted =>
  text instanceof RegExp ? { source: text.source, flags: text.flags } : { text, exact };

/**
 * A function and its arguments as an expression. Names that a transpiler leaves undefined, such as `this`, are not part
 * of it.
 */
const call = (act: string, args: readonly unknown[]): string =>
  `(${act})(${args.map((each) => (each === undefined ? 'undefined' : JSON.stringify(each))).join(',')})`;

/** The methods that find elements; subclasses define the starting point. */
abstract class Finder implements Finds {
  protected abstract step(...steps: Step[]): Locator;

  getByRole(
    role: Role,
    {
      name,
      exact,
      includeHidden,
      level,
    }: { name?: Text; exact?: boolean; includeHidden?: boolean; level?: number } = {},
  ): Locator {
    return this.step({
      by: 'role',
      role,
      hidden: includeHidden ?? false,
      ...(name === undefined ? {} : { name: wanted(name, exact) }),
      ...(level === undefined ? {} : { level }),
    });
  }
  getByLabel(text: Text, options: { exact?: boolean } = {}): Locator {
    return this.step({ by: 'label', text: wanted(text, options.exact) });
  }
  getByText(text: Text, options: { exact?: boolean } = {}): Locator {
    return this.step({ by: 'text', text: wanted(text, options.exact) });
  }
  getByPlaceholder(text: Text, options: { exact?: boolean } = {}): Locator {
    return this.step({ by: 'placeholder', text: wanted(text, options.exact) });
  }
  locator(selector: string, options: { has?: Locator; hasText?: Text } = {}): Locator {
    return this.step(
      selector === 'visible=true' ? { by: 'visible' } : { by: 'css', css: selector },
      ...filters(options),
    );
  }
}

function filters({ has, hasText }: { has?: Locator; hasText?: Text }): Step[] {
  return [
    ...(has === undefined ? [] : [{ by: 'has', steps: (has as ForeignLocator).steps } as const]),
    ...(hasText === undefined ? [] : [{ by: 'hasText', text: wanted(hasText) } as const]),
  ];
}

export class ForeignLocator extends Finder implements Locator {
  constructor(
    readonly owner: ForeignPage,
    readonly steps: readonly Step[],
  ) {
    super();
  }

  protected step(...steps: Step[]): ForeignLocator {
    return new ForeignLocator(this.owner, [...this.steps, ...steps]);
  }

  override toString(): string {
    return this.steps
      .map(
        ({ by, ...rest }) =>
          `${by} ${Object.values(rest)
            .map((each) => JSON.stringify(each))
            .join(' ')}`,
      )
      .join(' > ');
  }

  filter(options: { has?: Locator; hasText?: Text }): Locator {
    return this.step(...filters(options));
  }
  first(): Locator {
    return this.nth(0);
  }
  last(): Locator {
    return this.nth(-1);
  }
  nth(index: number): Locator {
    return this.step({ by: 'nth', index });
  }
  or(other: Locator): Locator {
    return this.step({ by: 'or', steps: (other as ForeignLocator).steps });
  }

  /** Answers for each element that exists now. */
  ask(question: Question): Promise<unknown[]> {
    return this.owner.find('ask', this.steps, question) as Promise<unknown[]>;
  }
  async count(): Promise<number> {
    return (await this.ask('visible')).length;
  }
  async all(): Promise<Locator[]> {
    return Array.from({ length: await this.count() }, (_, i) => this.nth(i));
  }
  /** Answer for the only element, once it exists. */
  private one(question: Question): Promise<unknown> {
    return this.until(`asking ${JSON.stringify(question)}`, async () => {
      const answers = await this.ask(question);
      return answers.length === 1 ? { answer: answers[0] } : `there are ${answers.length}`;
    }).then(({ answer }) => answer);
  }
  textContent(): Promise<string | null> {
    return this.one('text') as Promise<string>;
  }
  inputValue(): Promise<string> {
    return this.one('value') as Promise<string>;
  }
  getAttribute(name: string): Promise<string | null> {
    return this.one({ attribute: name }) as Promise<string | null>;
  }
  boundingBox(): Promise<Box | null> {
    return this.one('box') as Promise<Box | null>;
  }

  async click(): Promise<void> {
    for (const end = Date.now() + TIMEOUT; ; ) {
      const { x, y } = await this.ready('click');
      await this.owner.find('watchClick', this.steps);
      await this.owner.mouse.click(x, y);
      if (await this.owner.clickArrived()) return;
      if (Date.now() > end) throw new Error(`click of ${this}: it does not arrive`);
    }
  }
  async dblclick(): Promise<void> {
    const { x, y } = await this.ready('click');
    await this.owner.tab.click(x, y, 2);
  }
  async hover(): Promise<void> {
    const { x, y } = await this.ready('hover');
    await this.owner.mouse.move(x, y);
  }
  async check(): Promise<void> {
    if ((await this.one('checked')) === true) return;
    await this.click();
    if ((await this.one('checked')) !== true) throw new Error(`${this}: a click did not check it`);
  }
  focus(): Promise<void> {
    return this.act('focus');
  }
  fill(text: string): Promise<void> {
    return this.act('fill', text);
  }
  selectOption(value: string): Promise<void> {
    return this.act('select', value);
  }
  scrollIntoViewIfNeeded(): Promise<void> {
    return this.act('scroll');
  }
  async setInputFiles({ name, buffer }: { name: string; buffer: Buffer }): Promise<void> {
    await this.one('value');
    const folder = await this.owner.scratch();
    const path = join(await mkdtemp(join(folder, 'file-')), name);
    writeFileSync(path, buffer);
    await this.owner.installed();
    await this.owner.tab.chooseFile(call('(steps) => globalThis.finder.find(steps)[0]', [this.steps]), path);
  }

  async evaluate(act: (element: never, argument: never) => unknown, argument?: unknown): Promise<never> {
    await this.one('visible');
    return (await this.owner.installedAnd(
      call(`(steps, argument) => (${act})(globalThis.finder.find(steps)[0], argument)`, [this.steps, argument]),
    )) as never;
  }
  async evaluateAll(act: (elements: never) => unknown): Promise<never> {
    return (await this.owner.installedAnd(
      call(`(steps) => (${act})(globalThis.finder.find(steps))`, [this.steps]),
    )) as never;
  }

  private ready(to: 'click' | 'hover'): Promise<{ x: number; y: number }> {
    return this.until(to, async () => {
      const ready = (await this.owner.find('ready', this.steps, to)) as Ready;
      return 'why' in ready ? ready.why : ready;
    });
  }
  private async act(what: string, text = ''): Promise<void> {
    await this.until(what, async () => ((await this.owner.find('act', this.steps, what, text)) as string) || true);
  }
  /** Retries until the result is not a reason for failure (a string). */
  private async until<T>(what: string, look: () => Promise<T | string>): Promise<T> {
    const end = Date.now() + TIMEOUT;
    for (;;) {
      const found = await look();
      if (typeof found !== 'string') return found;
      if (Date.now() > end) throw new Error(`${what} of ${this}: ${found}`);
      await pause(PAUSE);
    }
  }
}

/**
 * Engines report this to `window.onerror` when a ResizeObserver delivers sizes in the next frame. It is not a failure;
 * Playwright only listens to exceptions and does not report it in Chromium.
 */
const LATE_SIZES = 'ResizeObserver loop';

export class ForeignPage extends Finder implements Page {
  readonly keyboard: Keyboard;
  readonly mouse: Mouse;
  private readonly listeners: ((error: Error) => void)[] = [];
  private readonly popups: ForeignPage[] = [];
  /** An opened page that has not yet reached the target of its link. */
  private opening: Tab | undefined;
  private folder: Promise<string> | undefined;
  private address = '';

  /** `finder` is the bundle of `finder.ts`; `base` is the base URL. */
  constructor(
    readonly tab: Tab,
    private readonly finder: string,
    private readonly base: string,
  ) {
    super();
    this.keyboard = keyboard(tab, (text) => this.find('insert', text));
    this.mouse = mouse(tab);
  }

  protected step(...steps: Step[]): Locator {
    return new ForeignLocator(this, steps);
  }

  async goto(address: string): Promise<void> {
    await this.tellErrors();
    await this.tab.goto(new URL(address, this.base).href);
    await this.look();
  }
  async reload(): Promise<void> {
    await this.tellErrors();
    await this.tab.reload();
  }
  async goBack(): Promise<void> {
    await this.tellErrors();
    await this.tab.back();
  }
  /** The URL at the last call of `look`. */
  url(): string {
    return this.address;
  }
  async look(): Promise<string> {
    this.address = await this.tab.url();
    return this.address;
  }
  async waitForLoadState(): Promise<void> {
    await this.tab.evaluate(
      call(
        `() => document.readyState === 'complete' || new Promise((done) => addEventListener('load', () => done(true)))`,
        [],
      ),
    );
    await this.look();
  }

  async evaluate(act: (argument: never) => unknown, argument?: unknown): Promise<never> {
    return (await this.tab.evaluate(call(String(act), [argument]))) as never;
  }
  async addInitScript(act: () => void): Promise<void> {
    await this.tab.addInitScript(call(String(act), []));
  }
  /**
   * Calls a function of `finder` in the page. A function without side effects is retried in the next document if the
   * page navigates.
   */
  async find(name: 'ask' | 'ready' | 'act' | 'insert' | 'watchClick', ...args: unknown[]): Promise<unknown> {
    const looks = name === 'ask' || name === 'ready';
    for (const end = Date.now() + TIMEOUT; ; await pause(PAUSE)) {
      try {
        return await this.installedAnd(call(`(...all) => globalThis.finder.${name}(...all)`, args));
      } catch (error) {
        if (!looks || !(error instanceof DocumentLeft) || Date.now() > end) throw error;
      }
    }
  }
  /** Whether the watched click has arrived at its element; a click that has left the document has. */
  async clickArrived(): Promise<boolean> {
    try {
      return (await this.tab.evaluate('globalThis.finder ? globalThis.finder.clickArrived() : true')) === true;
    } catch (error) {
      if (error instanceof DocumentLeft) return true;
      throw error;
    }
  }
  /** Evaluates an expression that needs `finder`, which is injected first if the document does not have it yet. */
  async installedAnd(expression: string): Promise<unknown> {
    const answer = (await this.tab.evaluate(`globalThis.finder ? (async () => [await ${expression}])() : null`)) as
      | [unknown]
      | null;
    if (answer !== null) return answer[0];
    await this.installed();
    return this.installedAnd(expression);
  }
  async installed(): Promise<void> {
    await this.tab.evaluate(
      `(() => { if (!globalThis.finder) { ${this.finder}\nglobalThis.finder = finder; } return true; })()`,
    );
  }

  setViewportSize({ width, height }: { width: number; height: number }): Promise<void> {
    return this.tab.resize(width, height);
  }
  async waitForTimeout(ms: number): Promise<void> {
    await pause(ms);
  }
  async screenshot({ path }: { path: string }): Promise<Buffer> {
    const png = await this.tab.screenshot();
    writeFileSync(path, png);
    return png;
  }

  waitForEvent(event: 'download'): Promise<Download>;
  waitForEvent(event: 'popup'): Promise<Page>;
  async waitForEvent(event: 'download' | 'popup'): Promise<Download | Page> {
    const end = Date.now() + TIMEOUT;
    for (;;) {
      const found = event === 'popup' ? await this.popup() : await this.download();
      if (found !== undefined) return found;
      if (Date.now() > end) throw new Error(`there was no ${event}`);
      await pause(PAUSE);
    }
  }
  private async popup(): Promise<Page | undefined> {
    const tab = (this.opening ??= await this.tab.opened());
    // While the tab is navigating, its URL is about:blank or cannot be requested.
    if (tab === undefined || (await tab.url().catch(() => 'about:blank')) === 'about:blank') return undefined;
    this.opening = undefined;
    const page = new ForeignPage(tab, this.finder, this.base);
    this.popups.push(page);
    return page;
  }
  /**
   * The next complete file in the download folder: its size has been stable for a while; an empty file needs longer.
   */
  private async download(): Promise<Download | undefined> {
    const names = readdirSync(this.tab.downloads);
    const name = names.find((each) => {
      if (/\.(part|wkdownload)$/.test(each) || names.includes(`${each}.part`)) return false;
      // Firefox may just have renamed it.
      const file = statSync(join(this.tab.downloads, each), { throwIfNoEntry: false });
      return file !== undefined && Date.now() - file.mtimeMs > (file.size === 0 ? 1500 : 150);
    });
    if (name === undefined) return undefined;
    // Move the file out of the folder; otherwise the next download would get another name.
    const path = join(await mkdtemp(join(await this.scratch(), 'saved-')), name);
    await copyFile(join(this.tab.downloads, name), path);
    await rm(join(this.tab.downloads, name));
    return { suggestedFilename: () => name, path: () => Promise.resolve(path) };
  }

  on(_event: 'pageerror', listener: (error: Error) => void): void {
    this.listeners.push(listener);
  }
  private async tellErrors(): Promise<void> {
    for (const error of await this.errors()) for (const listener of this.listeners) listener(new Error(error));
  }

  /** For error messages: URL of the page, its loading state and its errors. */
  async condition(): Promise<string> {
    const describe = async (): Promise<string> => {
      const state = await this.tab.evaluate(
        call('() => `${location.href} is ${document.readyState}, ${document.visibilityState}`', []),
      );
      return [state, ...(await this.errors())].join('; ');
    };
    return Promise.race([describe(), pause(3000, 'the page gives no answer')]).catch((error: unknown) => String(error));
  }
  /** For error messages: the document with its shadow roots and the files it has loaded. */
  async contents(): Promise<string> {
    const contents = this.tab.evaluate(
      call(
        `() => {
          const files = performance.getEntriesByType('resource').map(({ name, responseEnd }) => name + ' ' + responseEnd);
          const roots = [...document.querySelectorAll('*')].map(({ shadowRoot }) => shadowRoot?.innerHTML ?? '');
          return [innerWidth + ' × ' + innerHeight, ...files, document.documentElement.outerHTML, ...roots].join('\\n');
        }`,
        [],
      ),
    ) as Promise<string>;
    return Promise.race([contents, pause(3000, 'the page gives no answer')]).catch((error: unknown) => String(error));
  }
  private async errors(): Promise<string[]> {
    return (await this.tab.errors()).filter((error) => !error.includes(LATE_SIZES));
  }

  /** A temporary folder that is deleted with the page. */
  scratch(): Promise<string> {
    return (this.folder ??= mkdtemp(join(tmpdir(), 'playground-page-')));
  }
  /** Closes the page, after reporting the remaining errors of the page. */
  async close(): Promise<void> {
    try {
      for (const popup of this.popups) await popup.close();
      await this.opening?.close();
      await this.tellErrors();
    } finally {
      await this.tab.close();
      if (this.folder !== undefined) await rm(await this.folder, { recursive: true, force: true });
    }
  }
}

function mouse(tab: Tab): Mouse {
  let [x, y] = [0, 0];
  const move = async (toX: number, toY: number): Promise<void> => {
    [x, y] = [Math.floor(toX), Math.floor(toY)];
    await tab.mouseMove(x, y);
  };
  return {
    move,
    down: () => tab.mouseDown(),
    up: () => tab.mouseUp(),
    click: (toX, toY) => {
      [x, y] = [Math.floor(toX), Math.floor(toY)];
      return tab.click(x, y, 1);
    },
    wheel: (deltaX, deltaY) => tab.wheel(x, y, deltaX, deltaY),
  };
}

function keyboard(tab: Tab, insert: (text: string) => Promise<unknown>): Keyboard {
  return {
    press: async (keys) => {
      const names = keys.split(/(?<=.)\+/);
      const shift = names.includes('Shift');
      const held = names.slice(0, -1);
      const key = names.at(-1)!;
      for (const each of held) await tab.keyDown(each);
      // A letter together with Control is that of the key, without Shift.
      const plain = key.length === 1 && held.length > 0 && !shift ? key.toLowerCase() : key;
      await tab.keyDown(plain);
      await tab.keyUp(plain);
      for (const each of held.reverse()) await tab.keyUp(each);
    },
    type: async (text, { delay } = {}) => {
      if (delay === undefined) return tab.typeKeys(text);
      for (const each of text) {
        await tab.typeKeys(each);
        await pause(delay);
      }
    },
    insertText: async (text) => void (await insert(text)),
  };
}
