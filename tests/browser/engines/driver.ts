// What an engine's driver has to be able to do; everything else is made of it.

/** A browser of one worker of the test runner. */
export interface Driver {
  /** A tab in which nothing is stored. */
  open(): Promise<Tab>;
  close(): Promise<void>;
}

export interface Tab {
  /** The folder the page saves its files in; empty at first. */
  readonly downloads: string;
  /** Resolves when the document has loaded. */
  goto(address: string): Promise<void>;
  reload(): Promise<void>;
  /** To the page before, as with the button of the browser. */
  back(): Promise<void>;
  url(): Promise<string>;
  /** Runs in every document before its own scripts. */
  addInitScript(source: string): Promise<void>;
  /**
   * The value of an expression, awaited; it is JSON. What is thrown in the page is thrown here.
   *
   * @throws DocumentLeft where the page goes to another document meanwhile.
   */
  evaluate(expression: string): Promise<unknown>;
  keyDown(key: string): Promise<void>;
  keyUp(key: string): Promise<void>;
  /** Each character as a key, down and up. */
  typeKeys(text: string): Promise<void>;
  mouseMove(x: number, y: number): Promise<void>;
  mouseDown(): Promise<void>;
  mouseUp(): Promise<void>;
  /** Moves there and clicks so many times, as one act. */
  click(x: number, y: number, times: number): Promise<void>;
  wheel(x: number, y: number, deltaX: number, deltaY: number): Promise<void>;
  /** Chooses a file for the input that the expression gives. */
  chooseFile(expression: string, path: string): Promise<void>;
  resize(width: number, height: number): Promise<void>;
  /** What the window shows, PNG. */
  screenshot(): Promise<Buffer>;
  /** A tab that the page has opened since the last time; `undefined` when there is none. */
  opened(): Promise<Tab | undefined>;
  /** Errors of the page since the last time. */
  errors(): Promise<string[]>;
  close(): Promise<void>;
}

/** The document was left before an expression had its value. */
export class DocumentLeft extends Error {}

/** Runs an act of a driver; when it takes too long the driver hangs, and is ended. */
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
