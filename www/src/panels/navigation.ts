// Navigation in the program: to all uses of the number at the cursor, and by the outline; also the ranges that can be
// folded.
//
// In: answers of the interpreter about the text, once the user has focused it. Out: the place to show. Must not know:
// the meaning of a number, or the contents of the outline.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { UsesHelp } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { loadPart } from './load-part';
import type { OutlineDialog } from './outline-dialog';
import {
  isInProgram,
  type Key,
  type NewestQuestion,
  type Panel,
  type PanelKind,
  type Services,
  type Shell,
} from './panel';
import navigationStyles from './navigation.css?inline';

export const navigation: PanelKind = {
  control: 'help',
  styles: navigationStyles,
  make: (shell) => new Navigation(shell),
};

/** Most places that are listed, including those next to the cursor. */
const MAX_LISTED = 12;
/** Pause in typing, after which the panel asks for foldable ranges. */
const FOLD_DELAY_MS = 400;

class Navigation implements Panel {
  readonly #shell: Shell;
  readonly #button = make(
    'button',
    { type: 'button', className: 'outline-button', 'aria-haspopup': 'dialog' },
    icon('outline'),
  );
  readonly #section = make('div', { className: 'uses', hidden: true });
  readonly #question: NewestQuestion<'uses'>;
  readonly #outlineQuestion: NewestQuestion<'outline'>;
  /** Loaded once the user focuses the text, or opens the outline. */
  #dialog: OutlineDialog | undefined;
  /** Whether the user has focused the text. Until then the panel asks no question. */
  #hasFocusedText = false;
  /** The uses that are shown now. */
  #uses: UsesHelp | undefined;
  /** Those uses with the cursor and the language, as text, to compare. */
  #renderedKey = '';
  /** Offsets that the user came from, the newest last. */
  #history: number[] = [];
  #foldTimer: ReturnType<typeof setTimeout> | undefined;
  readonly elements = {};
  readonly services: Partial<Services> = { outlineButton: () => this.#button, usesSection: () => this.#section };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#open());
    this.#question = shell.newest('uses', (uses) => this.#show(uses));
    this.#outlineQuestion = shell.newest('outline', (outline) => {
      // Undefined if the text has changed since. The panel then asks again.
      if (outline !== undefined) shell.editor.foldable = outline.folds.map(([from, to]) => ({ from, to }));
    });
  }

  set language(language: Language) {
    setAccessibleName(this.#button, `${WORDS[language].outline} (Ctrl Shift O)`);
    if (this.#dialog !== undefined) this.#dialog.language = language;
    this.#show(this.#uses);
  }

  get capturesKeys(): boolean {
    return this.#dialog?.open ?? false;
  }

  onCursorMoved(): void {
    if (!this.#hasFocusedText) {
      this.#outlineQuestion.ask(undefined);
      // If loading fails, it is tried again when the outline is opened.
      this.#load().catch(() => undefined);
    }
    this.#hasFocusedText = true;
    this.#ask();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report' || !this.#hasFocusedText) return;
    this.#ask();
    clearTimeout(this.#foldTimer);
    this.#foldTimer = setTimeout(() => this.#outlineQuestion.ask(undefined), FOLD_DELAY_MS);
  }

  onInputChanged(): void {
    this.#question.cancel();
  }

  onWorkerLost(): void {
    this.onDisconnected();
    this.#show(undefined);
  }

  onDisconnected(): void {
    clearTimeout(this.#foldTimer);
    this.#question.cancel();
    this.#outlineQuestion.cancel();
  }

  onKey(key: Key): 'handled' | 'ignored' {
    const { event } = key;
    if (event.altKey) return 'ignored';
    const command = event.ctrlKey || event.metaKey;
    if (command && event.shiftKey && event.key.toLowerCase() === 'o') {
      void this.#open();
      return 'handled';
    }
    if (event.key !== 'F12' || command || !isInProgram(key, this.#shell)) return 'ignored';
    if (event.shiftKey) this.#goBack();
    else void this.#follow();
    return 'handled';
  }

  #ask(): void {
    this.#question.ask({ offset: this.#shell.editor.selection.from });
  }

  /** Goes to the block that the number at the cursor names, or to the next use of the number. */
  async #follow(): Promise<void> {
    const { editor } = this.#shell;
    const [from, texts] = [editor.selection.from, WORDS[this.#shell.language]];
    this.#shell.flush();
    const uses = await this.#shell.ask('uses', { offset: from });
    const place = uses?.places[uses.next];
    if (uses === undefined || place === undefined) return this.#notify(texts.noNumber);
    if (place.from <= from && from <= place.to) return this.#notify(texts.onlyHere(uses.name));
    this.#goTo(from, place);
  }

  #goBack(): void {
    const from = this.#history.pop();
    if (from === undefined) return this.#notify(WORDS[this.#shell.language].noWayBack);
    this.#shell.goTo({ from, to: from });
  }

  #goTo(before: number, { from, to }: { readonly from: number; readonly to: number }): void {
    this.#history.push(before);
    this.#shell.goTo({ from, to });
  }

  #show(uses: UsesHelp | undefined): void {
    const wasMarked = this.#uses !== undefined;
    // A number with a single use leads nowhere.
    this.#uses = uses = (uses?.places.length ?? 0) < 2 ? undefined : uses;
    const places = uses?.places ?? [];
    if (wasMarked || places.length > 0) this.#shell.editor.uses = places;
    const here = this.#shell.editor.selection.from;
    const renderedKey = uses === undefined ? '' : JSON.stringify([this.#shell.language, here, uses]);
    // If the content is unchanged, keep the buttons: the user may be pressing one.
    if (renderedKey === this.#renderedKey) return;
    this.#renderedKey = renderedKey;
    this.#section.hidden = uses === undefined;
    if (uses === undefined) return this.#section.replaceChildren();
    const texts = WORDS[this.#shell.language];
    const current = places.findIndex(({ from, to }) => from <= here && here <= to);
    const first = Math.max(0, Math.min(current - MAX_LISTED / 2, places.length - MAX_LISTED));
    const shown = places.slice(first, first + MAX_LISTED);
    const rest = places.length - shown.length;
    const links = shown.map((place, at) => {
      const button = make(
        'button',
        { type: 'button', className: 'use', 'aria-current': first + at === current ? 'location' : 'false' },
        make('span', { className: 'use-line' }, String(place.line)),
        make(place.defines ? 'b' : 'span', { className: 'use-text', lang: 'en' }, place.text),
      );
      button.addEventListener('click', () => this.#goTo(here, place));
      return make('li', {}, button);
    });
    const heading = make('h3', { className: 'at-cursor-heading' }, texts.usesOf(uses.name));
    const more = rest === 0 ? [] : [make('p', {}, uses.cut ? texts.moreThan(rest) : texts.more(rest))];
    this.#section.replaceChildren(heading, make('ul', { className: 'uses-list' }, ...links), ...more);
  }

  /** If it is already loaded, it opens synchronously, so that the next key goes into it. */
  async #open(): Promise<void> {
    const shell = this.#shell;
    // Pending edits must be part of the outline.
    shell.flush();
    const pendingOutline = shell.ask('outline', undefined);
    const cursor = shell.editor.selection.from;
    const dialog = this.#dialog ?? (await this.#load());
    if (dialog === undefined) return;
    dialog.openEmpty();
    const outline = await pendingOutline;
    if (outline === undefined) dialog.close();
    else dialog.show(outline, cursor);
  }

  async #load(): Promise<OutlineDialog | undefined> {
    const shell = this.#shell;
    const part = await loadPart(
      shell,
      () => import('./outline-dialog'),
      () => void this.#open(),
    );
    if (this.#dialog === undefined && part !== undefined) {
      this.#dialog = new part.OutlineDialog(shell.language, (offset) =>
        this.#goTo(shell.editor.selection.from, { from: offset, to: shell.editor.endOfLine(offset) }),
      );
      shell.region('dialogs').append(this.#dialog.element);
    }
    return this.#dialog;
  }

  #notify(text: string): void {
    this.#shell.service('notice')(text, 'editor');
  }
}

const WORDS = words({
  en: {
    outline: 'Outline of the program',
    usesOf: (number: string) => `Places of ${number}`,
    more: (count: number) => `and ${count} more`,
    moreThan: (count: number) => `and more than ${count} more`,
    noNumber:
      'F12 goes from a sequence number, a program number or a variable to its other places. None is at the cursor.',
    onlyHere: (number: string) => `${number} appears only here.`,
    noWayBack: 'This is where the first F12 was pressed.',
  },
  zh: {
    outline: '程序大纲',
    usesOf: (number) => `${number} 出现的位置`,
    more: (count) => `另有 ${count} 处`,
    moreThan: (count) => `另有 ${count} 处以上`,
    noNumber: 'F12 从顺序号、程序号或变量转到它的其他位置。光标处没有这样的编号。',
    onlyHere: (number) => `${number} 只在此处出现。`,
    noWayBack: '这里就是第一次按 F12 的位置。',
  },
  ru: {
    outline: 'Структура программы',
    usesOf: (number) => `Где стоит ${number}`,
    more: (count) => `и ещё ${count}`,
    moreThan: (count) => `и ещё более ${count}`,
    noNumber: 'F12 ведёт от номера кадра, номера программы или переменной к другим их местам. У курсора такого нет.',
    onlyHere: (number) => `${number} стоит только здесь.`,
    noWayBack: 'Здесь клавиша F12 была нажата в первый раз.',
  },
});
