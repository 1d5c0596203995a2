// The source of an element's program: the address in `src`, a script or `pre` inside, or the text of the element; and
// of its setup, if a script inside contains one.
//
// In: the element, its children and their changes. Out: the program whenever it changes, until the user or the page
// replaces it; the setup as JSON. Must not know: the content of a program or setup, or how it is shown.

import { importWithRetry, whenOnline } from '../dom/network';
import type { ProgramFile } from '../editor/program-text';
import type { Encoding } from '../files/encoding-list';
import { foldLineEnds } from '../files/line-ends';
import { describe } from '../worker/describe';

/** A fetch that takes longer than this is reported as slow. */
const SLOW_AFTER_MS = 700;

export const PROGRAM_SCRIPT = 'script[type="text/x-gcode"]';
const SETUP_SCRIPT = 'script[type="application/json"]';
/** The content of these is not text of the page. */
const NON_TEXT = 'script, style, template, noscript';

interface SourceEvents {
  /** The current program, with all changes by the user or the page. */
  current(): string;
  onProgram(text: string, file: ProgramFile | undefined): void;
  onSetup(json: string): void;
  /** A program is being fetched; reported again with `slow` after a while. */
  onLoading(address: string, how: 'started' | 'slow'): void;
  /** `retry` retries the fetch. */
  onFailed(address: string, reason: string, retry: () => void): void;
}

export class Source {
  readonly #element: HTMLElement;
  readonly #events: SourceEvents;
  /** The program that the element was given last. */
  #text: string | undefined;
  #setup: string | undefined;
  /** The address whose program is being fetched or was loaded. */
  #address: string | undefined;
  #abortController: AbortController | undefined;

  constructor(element: HTMLElement, events: SourceEvents) {
    this.#element = element;
    this.#events = events;
    new MutationObserver(() => this.#onMutation()).observe(element, {
      childList: true,
      characterData: true,
      subtree: true,
    });
  }

  /** The initial program; empty if it has to be fetched first. */
  start(): string {
    this.#readSetup();
    if (this.#address !== undefined || addressOf(this.#element) !== undefined) {
      this.addressChanged();
      return (this.#text = '');
    }
    return (this.#text = textInside(this.#element));
  }

  /** The attribute `src` has changed: its program replaces any other. */
  addressChanged(): void {
    const address = addressOf(this.#element);
    if (address === this.#address) return;
    this.#address = address;
    this.#abortController?.abort();
    if (address === undefined) this.#setProgram(textInside(this.#element), undefined);
    else void this.#fetch(address);
  }

  /** The children have changed. */
  #onMutation(): void {
    this.#readSetup();
    if (this.#address !== undefined || this.#text === undefined || this.#events.current() !== this.#text) return;
    const text = textInside(this.#element);
    if (text !== this.#text) this.#setProgram(text, undefined);
  }

  #readSetup(): void {
    const json = setupInside(this.#element);
    if (json === undefined || json === this.#setup) return;
    const attribute = this.#element.getAttribute('setup');
    if (attribute !== null && attribute !== this.#setup) return;
    this.#setup = json;
    this.#events.onSetup(json);
  }

  async #fetch(address: string): Promise<void> {
    const { signal } = (this.#abortController = new AbortController());
    this.#events.onLoading(address, 'started');
    const slowTimer = setTimeout(() => this.#events.onLoading(address, 'slow'), SLOW_AFTER_MS);
    try {
      const response = await fetch(new URL(address, document.baseURI), { signal });
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
      const { text, encoding } = await decode(new Uint8Array(await response.arrayBuffer()));
      signal.throwIfAborted();
      this.#setProgram(text, { name: nameOf(address), encoding });
    } catch (error) {
      if (signal.aborted) return;
      const stop = whenOnline(() => void this.#fetch(address));
      signal.addEventListener('abort', stop);
      const retry = (): void => {
        this.#abortController?.abort();
        void this.#fetch(address);
      };
      this.#events.onFailed(address, describe(error), retry);
    } finally {
      clearTimeout(slowTimer);
    }
  }

  #setProgram(text: string, file: ProgramFile | undefined): void {
    this.#events.onProgram(text, file);
    this.#text = this.#events.current();
  }
}

function addressOf(element: HTMLElement): string | undefined {
  const address = element.getAttribute('src')?.trim();
  return address === '' ? undefined : address;
}

/** The children that are not in a slot. */
function unslottedChildren(element: Element): ChildNode[] {
  return [...element.childNodes].filter((node) => !(node instanceof Element && node.hasAttribute('slot')));
}

function findChild(element: HTMLElement, selector: string): Element | undefined {
  return unslottedChildren(element).find((node): node is Element => node instanceof Element && node.matches(selector));
}

/**
 * The program inside of an element: the content of a script or a `pre`, or else the text; without blank first and last
 * lines, and without the common indent.
 */
export function textInside(element: HTMLElement): string {
  const container = findChild(element, PROGRAM_SCRIPT) ?? findChild(element, 'pre');
  const text =
    container === undefined
      ? unslottedChildren(element).map(textOf).join('')
      : unslottedChildren(container)
          .map((node) => node.textContent ?? '')
          .join('');
  const isWritten = (line: string): boolean => line.trim() !== '';
  const all = foldLineEnds(text).split('\n');
  const lines = all.slice(Math.max(0, all.findIndex(isWritten)), all.findLastIndex(isWritten) + 1);
  const indentOf = (line: string): number => (isWritten(line) ? line.length - line.trimStart().length : Infinity);
  const indent = lines.reduce((least, line) => Math.min(least, indentOf(line)), Infinity);
  return lines.map((line) => line.slice(indent)).join('\n');
}

function textOf(node: ChildNode): string {
  if (node.nodeType === Node.COMMENT_NODE || (node instanceof Element && node.matches(NON_TEXT))) return '';
  return node.textContent ?? '';
}

function setupInside(element: HTMLElement): string | undefined {
  const json = findChild(element, SETUP_SCRIPT)?.textContent.trim();
  return json === '' ? undefined : json;
}

/** The file name of an address. */
function nameOf(address: string): string {
  const { pathname } = new URL(address, document.baseURI);
  const name = pathname.split('/').at(-1) ?? '';
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

/** Most programs are ASCII without the zeros of UTF-16; the detection of encodings is loaded only for others. */
async function decode(bytes: Uint8Array): Promise<{ readonly text: string; readonly encoding: Encoding }> {
  if (bytes.every((byte) => byte > 0 && byte < 0x80))
    return { text: new TextDecoder().decode(bytes), encoding: 'utf-8' };
  return (await importWithRetry(() => import('../files/encoding-guess'))).guessEncoding(bytes);
}
