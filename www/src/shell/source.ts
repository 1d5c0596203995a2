// The source of an element's program: the address in `src`, a script or `pre` inside, or the text of the element; and
// of its setup, if a script inside contains one.
//
// In: the element, its children and their changes. Out: the program whenever it changes, until the user or the page
// replaces it; the setup as JSON. Must not know: the content of a program or setup, or how it is shown.

import { loaded, whenOnline } from '../dom/network';
import type { ProgramFile } from '../editor/program-text';
import type { Encoding } from '../files/encodings';
import { folded } from '../files/line-ends';

/** A fetch that takes longer than this is reported as slow. */
const PATIENCE_MS = 700;

export const PROGRAM_SCRIPT = 'script[type="text/x-gcode"]';
const SETUP_SCRIPT = 'script[type="application/json"]';
/** The content of these is not text of the page. */
const NO_TEXT = 'script, style, template, noscript';

export interface SourceEvents {
  /** The current program, with all changes by the user or the page. */
  current(): string;
  program(text: string, file: ProgramFile | undefined): void;
  setup(json: string): void;
  /** A program is being fetched; reported again with `slow` after a while. */
  coming(address: string, how: 'begun' | 'slow'): void;
  /** `again` retries the fetch. */
  failed(address: string, reason: string, again: () => void): void;
}

export class Source {
  readonly #element: HTMLElement;
  readonly #events: SourceEvents;
  /** The program that the element was given last. */
  #text: string | undefined;
  #setup: string | undefined;
  /** The address whose program is being fetched or was loaded. */
  #address: string | undefined;
  #fetching: AbortController | undefined;

  constructor(element: HTMLElement, events: SourceEvents) {
    this.#element = element;
    this.#events = events;
    new MutationObserver(() => this.#look()).observe(element, { childList: true, characterData: true, subtree: true });
  }

  /** The initial program; empty if it has to be fetched first. */
  begin(): string {
    this.#takeSetup();
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
    this.#fetching?.abort();
    if (address === undefined) this.#put(textInside(this.#element), undefined);
    else void this.#fetch(address);
  }

  /** The children have changed. */
  #look(): void {
    this.#takeSetup();
    if (this.#address !== undefined || this.#text === undefined || this.#events.current() !== this.#text) return;
    const text = textInside(this.#element);
    if (text !== this.#text) this.#put(text, undefined);
  }

  #takeSetup(): void {
    const json = setupInside(this.#element);
    if (json === undefined || json === this.#setup) return;
    const given = this.#element.getAttribute('setup');
    if (given !== null && given !== this.#setup) return;
    this.#setup = json;
    this.#events.setup(json);
  }

  async #fetch(address: string): Promise<void> {
    const { signal } = (this.#fetching = new AbortController());
    this.#events.coming(address, 'begun');
    const patience = setTimeout(() => this.#events.coming(address, 'slow'), PATIENCE_MS);
    try {
      const response = await fetch(new URL(address, document.baseURI), { signal });
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
      const { text, encoding } = await decoded(new Uint8Array(await response.arrayBuffer()));
      signal.throwIfAborted();
      this.#put(text, { name: nameOf(address), encoding });
    } catch (error) {
      if (signal.aborted) return;
      const stop = whenOnline(() => void this.#fetch(address));
      signal.addEventListener('abort', stop);
      const again = (): void => {
        this.#fetching?.abort();
        void this.#fetch(address);
      };
      this.#events.failed(address, error instanceof Error ? error.message : String(error), again);
    } finally {
      clearTimeout(patience);
    }
  }

  #put(text: string, file: ProgramFile | undefined): void {
    this.#events.program(text, file);
    this.#text = this.#events.current();
  }
}

function addressOf(element: HTMLElement): string | undefined {
  const address = element.getAttribute('src')?.trim();
  return address === '' ? undefined : address;
}

/** The children that are not in a slot. */
function own(element: Element): ChildNode[] {
  return [...element.childNodes].filter((node) => !(node instanceof Element && node.hasAttribute('slot')));
}

function child(element: HTMLElement, selector: string): Element | undefined {
  return own(element).find((node): node is Element => node instanceof Element && node.matches(selector));
}

/**
 * The program inside of an element: the content of a script or a `pre`, or else the text; without blank first and last
 * lines, and without the common indent.
 */
export function textInside(element: HTMLElement): string {
  const holder = child(element, PROGRAM_SCRIPT) ?? child(element, 'pre');
  const text =
    holder === undefined
      ? own(element).map(textOf).join('')
      : own(holder)
          .map((node) => node.textContent ?? '')
          .join('');
  const lines = folded(text).split('\n');
  while (lines.length > 0 && lines[0]?.trim() === '') lines.shift();
  while (lines.length > 0 && lines.at(-1)?.trim() === '') lines.pop();
  const indents = lines.filter((line) => line.trim() !== '').map((line) => line.length - line.trimStart().length);
  const indent = indents.length === 0 ? 0 : Math.min(...indents);
  return lines.map((line) => line.slice(indent)).join('\n');
}

function textOf(node: ChildNode): string {
  if (node.nodeType === Node.COMMENT_NODE || (node instanceof Element && node.matches(NO_TEXT))) return '';
  return node.textContent ?? '';
}

function setupInside(element: HTMLElement): string | undefined {
  const json = child(element, SETUP_SCRIPT)?.textContent.trim();
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
async function decoded(bytes: Uint8Array): Promise<{ readonly text: string; readonly encoding: Encoding }> {
  if (bytes.every((byte) => byte > 0 && byte < 0x80))
    return { text: new TextDecoder().decode(bytes), encoding: 'utf-8' };
  return (await loaded(() => import('../files/encoding-guess'))).guess(bytes);
}
