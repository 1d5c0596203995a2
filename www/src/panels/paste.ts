// Searches a pasted, dropped or opened text for programs. If it contains more than a program, a dialog offers the
// programs that were found. For a few stray characters, only a notice is shown, which leads to the dialog.
//
// In: a text that was pasted, dropped or opened. Out: questions to the interpreter; an edit if the user takes a
// program. The text itself is already in the editor, so nothing is lost. Must not know: how programs are found.

import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Shell } from './panel';
import type { PasteDialog } from './paste-dialog';
import pasteStyles from './paste.css?inline';

/**
 * Longest text, UTF-16 units, that is searched automatically: a longer one is usually a program, and the search would
 * take a while.
 */
const MAX_AUTO_SEARCH_LENGTH = 1_000_000;
/** Shortest text, UTF-16 units, that is searched: a shorter one is a word or two. */
const MIN_SEARCH_LENGTH = 12;

export const paste: PanelKind = {
  control: 'file',
  edits: true,
  styles: pasteStyles,
  make: (shell) => new Paste(shell),
};

class Paste implements Panel {
  readonly #shell: Shell;
  readonly #button = menuItem({ 'aria-haspopup': 'dialog' });
  /** Loaded when a text with programs is first found. */
  #dialog: PasteDialog | undefined;
  /** Range of the text that was searched. */
  #range: { readonly from: number; readonly to: number } | undefined;

  readonly elements = { 'program-menu': [this.#button] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#search(0, shell.editor.length, 'requested'));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#button.textContent = texts.buttonName;
    this.#button.title = texts.buttonHint;
    if (this.#dialog !== undefined) this.#dialog.language = language;
  }

  get capturesKeys(): boolean {
    return this.#dialog?.open ?? false;
  }

  onTextInserted(from: number, to: number): void {
    if (to - from >= MIN_SEARCH_LENGTH && to - from <= MAX_AUTO_SEARCH_LENGTH) void this.#search(from, to, 'inserted');
  }

  async #search(from: number, to: number, trigger: 'inserted' | 'requested'): Promise<void> {
    const { editor } = this.#shell;
    const { revision } = editor;
    const found = await this.#shell.ask('programs-in', { text: editor.textBetween(from, to) });
    // The text was edited in the meantime.
    if (found === undefined || editor.revision !== revision || this.capturesKeys) return;
    const texts = WORDS[this.#shell.language];
    if (trigger === 'inserted' && found.review === 'nothing') return;
    if (trigger === 'inserted' && found.review === 'few-characters') {
      // The run of the new text would hide the notice, so begin it first.
      this.#shell.flush();
      const action = { title: texts.clean, act: () => void this.#search(from, to, 'requested') };
      return this.#shell.service('notice')(texts.fewCharacters, 'program', action);
    }
    if (found.programs.length === 0) return this.#notify(found.tooLong ? texts.tooLong : texts.none);
    const part = await loadPart(
      this.#shell,
      () => import('./paste-dialog'),
      () => void this.#search(0, editor.length, 'requested'),
    );
    // The text was edited, or searched again, while the dialog was loading.
    if (part === undefined || editor.revision !== revision || this.capturesKeys) return;
    this.#range = { from, to };
    if (this.#dialog === undefined) {
      this.#dialog = new part.PasteDialog(this.#shell.language, {
        piecesOf: (program) => this.#shell.ask('pieces-of', { program, language: this.#shell.language }),
        onApply: (text) => this.#apply(text),
      });
      this.#shell.region('dialogs').append(this.#dialog.element);
    }
    this.#dialog.show(found, trigger);
  }

  #apply(text: string): void {
    if (this.#range === undefined) return;
    const { from, to } = this.#range;
    const { editor, language } = this.#shell;
    this.#shell.markAsInserted();
    editor.change([{ from, to, text }]);
    this.#notify(WORDS[language].applied);
    editor.focus();
  }

  #notify(text: string): void {
    this.#shell.service('notice')(text, 'program');
  }
}

const WORDS = words({
  en: {
    /** Accessible name, with the context that the page shows. */
    buttonName: 'Programs in a text…',
    buttonHint: 'Finds the programs in the text of the editor, such as a page of a book or a forum, and cleans them',
    none: 'No program was found in this text.',
    tooLong: 'The text is too long to be searched for programs.',
    fewCharacters: 'There are characters in this text that do not belong in a program.',
    clean: 'Clean it…',
    applied: 'The program replaced the text. Undo restores the text.',
  },
  zh: {
    buttonName: '文本中的程序…',
    buttonHint: '在编辑器的文本（如书页、论坛帖子）中查找程序并清理',
    none: '文本中没有找到程序。',
    tooLong: '文本过长，无法查找程序。',
    fewCharacters: '文本中有不属于程序的字符。',
    clean: '清理…',
    applied: '程序已替换文本。可用撤销恢复。',
  },
  ru: {
    buttonName: 'Программы в тексте…',
    buttonHint: 'Находит программы в тексте редактора (страница учебника, форум) и очищает их',
    none: 'Программ в этом тексте не найдено.',
    tooLong: 'Текст слишком длинный для поиска программ.',
    fewCharacters: 'В этом тексте есть знаки, которым не место в программе.',
    clean: 'Очистить…',
    applied: 'Программа заменила текст. Отмена вернёт его.',
  },
});
