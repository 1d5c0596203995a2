// What the tests that run in every engine may ask of a page. It is a part of Playwright's interface, so
// Playwright's own page is one of these, and `ForeignPage` is the other, on top of a driver that knows
// nothing but scripts, keys and the pointer.

/**
 * A text that is looked for: a string is found anywhere, upper and lower case alike,
 * unless it has to be `exact`.
 */
export type Text = string | RegExp;

/** The roles the page has and the tests ask for. */
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
  /** By a CSS selector, through shadow roots; `visible=true` keeps of what was found what can be seen. */
  locator(selector: string, options?: { has?: Locator; hasText?: Text }): Locator;
}

/**
 * Elements, found anew whenever something is asked of them. An act waits until there is one
 * element and it can be acted on.
 */
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
  /** By the value of the option, or the text that is shown. */
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
  /** A key with what is held meanwhile: `F9`, `Control+A`, `Alt+Shift+F9`. */
  press(keys: string): Promise<void>;
  /** Key by key. */
  type(text: string, options?: { delay?: number }): Promise<void>;
  /** All at once, as an input method or a paste does it. */
  insertText(text: string): Promise<void>;
}

export interface Mouse {
  move(x: number, y: number): Promise<void>;
  down(): Promise<void>;
  up(): Promise<void>;
  click(x: number, y: number): Promise<void>;
  wheel(deltaX: number, deltaY: number): Promise<void>;
}

/** A file the page has saved. */
export interface Download {
  suggestedFilename(): string;
  path(): Promise<string>;
}

/** What most tests need of a page. */
export interface BasicPage extends Finds {
  readonly keyboard: Keyboard;
  readonly mouse: Mouse;
  goto(address: string): Promise<unknown>;
  reload(): Promise<unknown>;
  /** To the page before, as with the button of the browser. */
  goBack(): Promise<unknown>;
  url(): string;
  /**
   * Evaluates a function in the page; it uses nothing from outside itself, and its
   * argument and result are JSON.
   */
  evaluate<R, A>(act: (argument: A) => R | Promise<R>, argument: A): Promise<R>;
  evaluate<R>(act: () => R | Promise<R>): Promise<R>;
  /** Runs in every page before its own scripts. */
  addInitScript(act: () => void): Promise<unknown>;
  setViewportSize(size: { width: number; height: number }): Promise<void>;
  waitForTimeout(ms: number): Promise<void>;
  waitForLoadState(): Promise<void>;
  screenshot(options: { path: string }): Promise<Buffer>;
  on(event: 'pageerror', listener: (error: Error) => void): unknown;
}

export interface Page extends BasicPage {
  waitForEvent(event: 'download'): Promise<Download>;
  /** A page that a link opened beside this one. */
  waitForEvent(event: 'popup'): Promise<Page>;
}
