// The button "Write out" and its dialog: the program with every cycle as plain moves, to read, copy or take over.
//
// In: the text to show, with its colours, as an answer. Out: `wanted` (the reader asks for it) and `taken` (it shall
// become the program). Must not know: how a cycle is written out, or where the text goes.

import { defaultKeymap } from '@codemirror/commands';
import { EditorState } from '@codemirror/state';
import { drawSelection, EditorView, keymap, lineNumbers } from '@codemirror/view';
import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import { marks, showTokens } from '../editor/marks';
import { editorTheme } from '../editor/theme';
import type { Strings } from '../dom/i18n';
import type { WrittenOut } from '../protocol/protocol';

const COPIED_FOR_MS = 2_000;

export interface WrittenOutEvents {
  wanted(): void;
  taken(text: string): void;
}

export class WrittenOutDialog {
  readonly button = make('button', { type: 'button', className: 'written-out-button quiet', 'aria-haspopup': 'dialog' });
  readonly #events: WrittenOutEvents;
  readonly #text = make('div', { className: 'text' });
  readonly #copy = make('button', { type: 'button', className: 'framed' });
  readonly #take = make('button', { type: 'button', className: 'framed' });
  readonly #news = make('span', { className: 'unseen', role: 'log' });
  readonly #dialog: Dialog;
  readonly #root: ShadowRoot;
  #strings: Strings;
  #view: EditorView | undefined;
  #copied: ReturnType<typeof setTimeout> | undefined;

  constructor(root: ShadowRoot, strings: Strings, events: WrittenOutEvents) {
    this.#root = root;
    this.#strings = strings;
    this.#events = events;
    this.#dialog = new Dialog('written-out', [this.#text], [this.#copy, this.#take, this.#news]);
    this.button.addEventListener('click', () => this.#events.wanted());
    this.#copy.addEventListener('click', () => void this.#copyAll());
    this.#take.addEventListener('click', () => this.#takeOver());
    this.element.addEventListener('close', () => this.#clear());
    this.available = false;
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.button.textContent = strings.writeOut;
    this.button.title = strings.writeOutHint;
    this.#dialog.name(strings.writtenOut, strings.close);
    this.#take.textContent = strings.takeOver;
    this.#showCopy('copy');
  }

  /** Whether there is a finished run with motions to write out. */
  set available(available: boolean) {
    this.button.disabled = !available;
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** `before` is the program as it stands in the editor. */
  show(written: WrittenOut, before: string): void {
    const changed = written.text.trimEnd() !== before.trimEnd();
    this.#dialog.about = changed ? this.#strings.writtenOutAbout : this.#strings.nothingToWriteOut;
    this.#take.hidden = !changed;
    this.#view?.destroy();
    this.#view = new EditorView({
      parent: this.#text,
      root: this.#root,
      state: EditorState.create({
        doc: written.text.trimEnd(),
        extensions: [
          EditorState.readOnly.of(true), EditorView.editable.of(false), lineNumbers(), drawSelection(), marks, editorTheme,
          keymap.of(defaultKeymap),
          EditorView.contentAttributes.of({
            tabindex: '0', lang: 'en', 'aria-label': this.#strings.writtenOut, 'aria-readonly': 'true',
          }),
        ],
      }),
    });
    this.#view.dispatch({ effects: showTokens.of(written.tokens) });
    this.#dialog.show();
    this.#view.requestMeasure();
    this.#view.focus();
  }

  #takeOver(): void {
    const text = this.#view?.state.doc.toString();
    this.#dialog.close();
    if (text !== undefined) this.#events.taken(`${text}\n`);
  }

  async #copyAll(): Promise<void> {
    const view = this.#view;
    if (view === undefined) return;
    try {
      await navigator.clipboard.writeText(`${view.state.doc.toString()}\n`);
      this.#showCopy('copied');
      this.#copied = setTimeout(() => this.#showCopy('copy'), COPIED_FOR_MS);
    } catch {
      // Not allowed here: what the reader's own Ctrl C needs is a selection.
      view.dispatch({ selection: { anchor: 0, head: view.state.doc.length } });
      view.focus();
      this.#news.textContent = '';
      this.#dialog.about = this.#strings.copyYourself;
    }
  }

  #showCopy(state: 'copy' | 'copied'): void {
    clearTimeout(this.#copied);
    this.#copy.textContent = state === 'copied' ? this.#strings.copied : this.#strings.copy;
    this.#news.textContent = state === 'copied' ? this.#strings.copied : '';
  }

  #clear(): void {
    this.#showCopy('copy');
    this.#view?.destroy();
    this.#view = undefined;
  }
}
