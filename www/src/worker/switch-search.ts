// Searches the text of a session for switches, in slices.
//
// In: a text that was set, edits of it, slices. Out: the switches, once all lines are searched. An edit that cannot
// change them keeps them. Must not know: runs, or how the switches reach the page.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { SwitchesInText, TextChange } from '../protocol/protocol';
import { mayContainSwitches, SwitchFinder } from './switches-in-text';

/** Lines searched for switches in one slice. */
const LINES_PER_SLICE = 20_000;
/** After a longer change, the whole text is searched for switches. */
const FULL_SEARCH_ABOVE = 100_000;

export class SwitchSearch {
  readonly #core: Playground;
  /** Undefined once the search is complete. */
  #search: { readonly finder: SwitchFinder; nextLine: number } | undefined;
  #found: SwitchesInText | undefined;

  constructor(core: Playground) {
    this.#core = core;
  }

  /** Undefined until the search is complete. */
  get found(): SwitchesInText | undefined {
    return this.#found;
  }

  get isInProgress(): boolean {
    return this.#search !== undefined;
  }

  /** The text was set. */
  start(): void {
    this.#found = undefined;
    this.#search = { finder: new SwitchFinder(), nextLine: 0 };
  }

  /** Edits the text; searches it again if the edit may change the switches. */
  edit({ from, to, insert }: TextChange): void {
    // The edit may move lines that were not searched yet: then search the whole text again.
    const searchAll = this.isInProgress || to - from > FULL_SEARCH_ABOVE || insert.length > FULL_SEARCH_ABOVE;
    const changedLines = (end: number): string =>
      this.#core.linesAsWritten(this.#core.lineAt(from), this.#core.lineAt(end) + 1);
    const oldLines = searchAll ? '' : changedLines(to);
    this.#core.edit(from, to, insert);
    if (searchAll || mayContainSwitches(oldLines) || mayContainSwitches(changedLines(from + insert.length)))
      this.start();
  }

  /** Searches the next lines; a short text is searched in one go. Returns the switches if the search is now complete. */
  searchMore(): SwitchesInText | undefined {
    if (this.#search === undefined) return undefined;
    const { finder, nextLine } = this.#search;
    finder.search(this.#core.linesAsWritten(nextLine, nextLine + LINES_PER_SLICE));
    this.#search.nextLine += LINES_PER_SLICE;
    if (this.#core.linesAsWritten(this.#search.nextLine, this.#search.nextLine + 1) !== '') return undefined;
    this.#search = undefined;
    this.#found = finder.found;
    return this.#found;
  }
}
