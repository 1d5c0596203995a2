// Interface of an engine's driver. Everything else is built on it.

/** A browser for one worker of the test runner. */
export interface Driver {
  /** Opens a tab with empty storage. */
  open(): Promise<Tab>;
  close(): Promise<void>;
}

export interface Tab {
  /** The download folder of the page; initially empty. */
  readonly downloads: string;
  /** Resolves when the document has loaded. */
  goto(address: string): Promise<void>;
  reload(): Promise<void>;
  /** Goes back in the history, like the browser's Back button. */
  back(): Promise<void>;
  url(): Promise<string>;
  /** Runs in every document before its own scripts. */
  addInitScript(source: string): Promise<void>;
  /**
   * Evaluates an expression and awaits its value, which must be JSON. Exceptions in the page are rethrown here.
   * @throws DocumentLeft if the page navigates to another document meanwhile.
   */
  evaluate(expression: string): Promise<unknown>;
  keyDown(key: string): Promise<void>;
  keyUp(key: string): Promise<void>;
  /** Types each character as a key press. */
  typeKeys(text: string): Promise<void>;
  mouseMove(x: number, y: number): Promise<void>;
  mouseDown(): Promise<void>;
  mouseUp(): Promise<void>;
  /** Moves the pointer to the position and clicks `times` times, as one action. */
  click(x: number, y: number, times: number): Promise<void>;
  wheel(x: number, y: number, deltaX: number, deltaY: number): Promise<void>;
  /** Chooses a file for the input element that the expression returns. */
  chooseFile(expression: string, path: string): Promise<void>;
  resize(width: number, height: number): Promise<void>;
  /** Screenshot of the window, PNG. */
  screenshot(): Promise<Buffer>;
  /** A tab that the page has opened since the last call; `undefined` if there is none. */
  opened(): Promise<Tab | undefined>;
  /** Errors of the page since the last call. */
  errors(): Promise<string[]>;
  close(): Promise<void>;
}

/** The document was left before the expression had a value. */
export class DocumentLeft extends Error {}

/** Runs an action of a driver with a timeout. After the timeout the driver counts as hung, and `end` terminates it. */
export async function within<T>(ms: number, what: string, act: Promise<T>, end: () => void): Promise<T> {
  let timer: NodeJS.Timeout | undefined;
  const late = new Promise<never>((_, reject) => {
    timer = setTimeout(() => {
      end();
      reject(new Error(`${what}: no answer within ${ms / 1000} s; the browser was ended`));
    }, ms);
  });
  try {
    return await Promise.race([act, late]);
  } finally {
    clearTimeout(timer);
  }
}

/** The browser's process of the page has ended. */
export class BrowserCrashed extends Error {}
