// What becomes of a text that may hold more than a program: it is searched, and where it does, a dialog offers its programs.
//
// In: `arrived` for a text that was pasted, dropped or opened. Out: questions to the interpreter; an edit when the reader
// takes a program. The text itself is in the editor before, so nothing is lost. Must not know: how programs are found.

import type { CoreClient } from '../worker/core-client';
import { make } from '../dom/dom';
import type { Editor } from '../editor/editor';
import type { Strings } from '../dom/i18n';
import { PasteDialog } from './paste-dialog';

/** UTF-16 units of a text that is searched without being asked to: longer ones are programs, as a rule, and take a while. */
const SEARCHED = 1_000_000;
/** A shorter text is a word or two. */
const WORTH_SEARCHING = 12;

export interface PastingEvents {
  client(): CoreClient | undefined;
  editor(): Editor | undefined;
  language(): string;
  /** A program has been taken out of the text. */
  taken(): void;
  notice(text: string): void;
}

export class Pasting {
  readonly button = make('button', { type: 'button', className: 'paste-button quiet', 'aria-haspopup': 'dialog' });
  readonly #events: PastingEvents;
  readonly #dialog: PasteDialog;
  #strings: Strings;
  /** Where the text stands that is looked at. */
  #range: { readonly from: number; readonly to: number } | undefined;

  constructor(strings: Strings, events: PastingEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#dialog = new PasteDialog(strings, {
      chosen: (program) => void this.#choose(program),
      taken: (text) => this.#take(text),
    });
    this.button.addEventListener('click', () => void this.#search(0, undefined, 'asked'));
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.button.textContent = strings.paste.button;
    this.button.setAttribute('aria-label', strings.paste.buttonName);
    this.button.title = strings.paste.buttonHint;
    this.#dialog.strings = strings;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** A text has come into the editor, all of it without a range. */
  arrived(from = 0, to = this.#events.editor()?.length ?? 0): void {
    if (to - from >= WORTH_SEARCHING && to - from <= SEARCHED) void this.#search(from, to, 'arrived');
  }

  async #search(from: number, end: number | undefined, how: 'arrived' | 'asked'): Promise<void> {
    const editor = this.#events.editor();
    const client = this.#events.client();
    if (editor === undefined || client === undefined) return;
    const to = end ?? editor.length;
    const { revision } = editor;
    const found = await client.ask('programs-in', { text: editor.textBetween(from, to) });
    // Something else has been typed since.
    if (editor.revision !== revision || this.open) return;
    const texts = this.#strings.paste;
    if (how === 'arrived' && (!found.doubtful || found.programs.length === 0)) return;
    if (found.programs.length === 0) return this.#events.notice(found.tooLong ? texts.tooLong : texts.none);
    this.#range = { from, to };
    this.#dialog.show(found, how);
  }

  async #choose(program: number): Promise<void> {
    const pieces = await this.#events.client()?.ask('pieces-of', { program, language: this.#events.language() });
    if (pieces !== undefined) this.#dialog.showPieces(program, pieces);
  }

  #take(text: string): void {
    const editor = this.#events.editor();
    if (editor === undefined || this.#range === undefined) return;
    const { from, to } = this.#range;
    this.#events.taken();
    editor.change([{ from, to, text }]);
    this.#events.notice(this.#strings.paste.taken);
    editor.focus();
  }
}
