// The page interface of tests that run in every engine. It is a subset of Playwright's interface, so Playwright's own
// page implements it; `ForeignPage` is the other implementation, on top of a driver that only supports scripts, keys
// and the pointer.

/** A text to find: a string matches any substring, ignoring case, unless `exact` is set. */
export type Text = string | RegExp;

/** Roles that the page uses and the tests query. */
export type Role =
  | 'alert'
  | 'button'
  | 'columnheader'
  | 'combobox'
  | 'dialog'
  | 'grid'
  | 'group'
  | 'heading'
  | 'img'
  | 'link'
  | 'list'
  | 'listbox'
  | 'listitem'
  | 'log'
  | 'menu'
  | 'menuitem'
  | 'menuitemcheckbox'
  | 'menuitemradio'
  | 'note'
  | 'option'
  | 'radio'
  | 'radiogroup'
  | 'region'
  | 'row'
  | 'rowheader'
  | 'searchbox'
  | 'separator'
  | 'slider'
  | 'status'
  | 'switch'
  | 'tab'
  | 'table'
  | 'tabpanel'
  | 'textbox'
  | 'tooltip';

export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Finds {
  getByRole(role: Role, options?: { name?: Text; exact?: boolean; includeHidden?: boolean; level?: number }): Locator;
  getByLabel(text: Text, options?: { exact?: boolean }): Locator;
  getByText(text: Text, options?: { exact?: boolean }): Locator;
  getByPlaceholder(text: Text, options?: { exact?: boolean }): Locator;
  /** By a CSS selector, through shadow roots; `visible=true` keeps only the visible elements. */
  locator(selector: string, options?: { has?: Locator; hasText?: Text }): Locator;
}

/** A query that is evaluated again for each call. An action waits until exactly one element matches and is ready. */
export interface Locator extends Finds {
  filter(options: { has?: Locator; hasText?: Text }): Locator;
  first(): Locator;
  last(): Locator;
  nth(index: number): Locator;
  or(other: Locator): Locator;
  count(): Promise<number>;
  all(): Promise<Locator[]>;
  click(): Promise<void>;
  dblclick(): Promise<void>;
  hover(): Promise<void>;
  focus(): Promise<void>;
  check(): Promise<void>;
  fill(text: string): Promise<void>;
  /** By the value of the option, or its visible text. */
  selectOption(value: string): Promise<unknown>;
  setInputFiles(file: { name: string; mimeType: string; buffer: Buffer }): Promise<void>;
  scrollIntoViewIfNeeded(): Promise<void>;
  textContent(): Promise<string | null>;
  inputValue(): Promise<string>;
  getAttribute(name: string): Promise<string | null>;
  boundingBox(): Promise<Box | null>;
  evaluate<R, A>(act: (element: HTMLElement, argument: A) => R | Promise<R>, argument: A): Promise<R>;
  evaluate<R>(act: (element: HTMLElement) => R | Promise<R>): Promise<R>;
  evaluateAll<R>(act: (elements: HTMLElement[]) => R | Promise<R>): Promise<R>;
}

export interface Keyboard {
  /** A key with modifiers: `F9`, `Control+A`, `Alt+Shift+F9`. */
  press(keys: string): Promise<void>;
  /** Types the text key by key. */
  type(text: string, options?: { delay?: number }): Promise<void>;
  /** Inserts the text in one step, as an input method or a paste does. */
  insertText(text: string): Promise<void>;
}

export interface Mouse {
  move(x: number, y: number): Promise<void>;
  down(): Promise<void>;
  up(): Promise<void>;
  click(x: number, y: number): Promise<void>;
  wheel(deltaX: number, deltaY: number): Promise<void>;
}

/** A file that the page has saved. */
export interface Download {
  suggestedFilename(): string;
  path(): Promise<string>;
}

/** The part of the interface that most tests need. */
export interface BasicPage extends Finds {
  readonly keyboard: Keyboard;
  readonly mouse: Mouse;
  goto(address: string): Promise<unknown>;
  reload(): Promise<unknown>;
  /** Goes back in the history, like the browser's Back button. */
  goBack(): Promise<unknown>;
  url(): string;
  /** Evaluates a function in the page. It must not use variables from outside; its argument and result are JSON. */
  evaluate<R, A>(act: (argument: A) => R | Promise<R>, argument: A): Promise<R>;
  evaluate<R>(act: () => R | Promise<R>): Promise<R>;
  /** Runs in every document before its own scripts. */
  addInitScript(act: () => void): Promise<unknown>;
  setViewportSize(size: { width: number; height: number }): Promise<void>;
  waitForTimeout(ms: number): Promise<void>;
  waitForLoadState(): Promise<void>;
  screenshot(options: { path: string }): Promise<Buffer>;
  on(event: 'pageerror', listener: (error: Error) => void): unknown;
}

export interface Page extends BasicPage {
  waitForEvent(event: 'download'): Promise<Download>;
  /** A page that a link opened in another tab. */
  waitForEvent(event: 'popup'): Promise<Page>;
}
