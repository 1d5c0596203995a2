// The button "Expand cycles" and its dialog: the program with every cycle as plain moves, to read, copy or apply.
//
// In: the text to show, with its colours, as an answer. Out: that text as the program, if the user applies it. Must not
// know: how a cycle is expanded.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { CodeView } from '../editor/code-view';
import type { ExpandedProgram } from '../protocol/protocol';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Shell } from './panel';
import writtenOutStyles from './written-out.css?inline';

const COPIED_FOR_MS = 2_000;

export const writtenOut: PanelKind = {
  control: 'tools',
  styles: writtenOutStyles,
  make: (shell) => new ExpandedPanel(shell),
};

class ExpandedPanel implements Panel {
  readonly #shell: Shell;
  readonly #button = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #text = make('div', { className: 'text' });
  readonly #copy = make('button', { type: 'button', className: 'framed' });
  readonly #applyButton = make('button', { type: 'button', className: 'primary' });
  readonly #news = make('span', { className: 'unseen', role: 'log' });
  readonly #dialog = new Dialog('written-out', [this.#text], [this.#news, this.#copy, this.#applyButton]);
  /** Made each time the dialog opens; its code is loaded with the editor's. */
  #view: CodeView | undefined;
  #copiedTimer: ReturnType<typeof setTimeout> | undefined;

  readonly elements = { 'more-menu': [this.#button], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#open());
    this.#copy.addEventListener('click', () => void this.#copyAll());
    this.#applyButton.addEventListener('click', () => this.#apply());
    this.#dialog.element.addEventListener('close', () => this.#clear());
    this.available = false;
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#button.textContent = texts.writeOut;
    this.#button.title = texts.writeOutHint;
    this.#dialog.setTexts(texts.writtenOut, COMMON[language].close);
    this.#applyButton.textContent = texts.apply;
    this.#showCopy('copy');
  }

  /** Whether there is a finished run with motions to expand. */
  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  get #words(): (typeof WORDS)['en'] {
    return WORDS[this.#shell.language];
  }

  async #open(): Promise<void> {
    const { editor } = this.#shell;
    this.#shell.flush();
    const { revision } = editor;
    const load = loadPart(
      this.#shell,
      () => import('../editor/code-view'),
      () => void this.#open(),
    );
    const [expanded, part] = await Promise.all([this.#shell.ask('expand', undefined), load]);
    if (expanded !== undefined && part !== undefined && editor.revision === revision)
      this.#show(expanded, editor.text, part.CodeView);
  }

  /** `before` is the current text of the editor. */
  #show(expanded: ExpandedProgram, before: string, View: typeof CodeView): void {
    const changed = expanded.text.trimEnd() !== before.trimEnd();
    this.#dialog.about = changed ? this.#words.writtenOutAbout : this.#words.nothingToWriteOut;
    this.#applyButton.hidden = !changed || this.#shell.readonly;
    this.#view?.destroy();
    this.#view = new View(
      this.#text,
      this.#shell.root,
      expanded.text.trimEnd(),
      expanded.tokens,
      this.#words.writtenOut,
    );
    this.#dialog.show();
    this.#view.onVisible();
  }

  #apply(): void {
    const text = this.#view?.text;
    this.#dialog.close();
    if (text === undefined) return;
    this.#shell.rewrite(`${text}\n`);
    this.#shell.service('notice')(this.#words.applied, 'program');
    this.#shell.editor.focus();
  }

  async #copyAll(): Promise<void> {
    const view = this.#view;
    if (view === undefined) return;
    try {
      await navigator.clipboard.writeText(`${view.text}\n`);
      this.#showCopy('copied');
      this.#copiedTimer = setTimeout(() => this.#showCopy('copy'), COPIED_FOR_MS);
    } catch {
      // Copying is not allowed here: select the text for the user's own Ctrl C.
      view.selectAll();
      this.#news.textContent = '';
      this.#dialog.about = this.#words.copyYourself;
    }
  }

  #showCopy(state: 'copy' | 'copied'): void {
    clearTimeout(this.#copiedTimer);
    this.#copy.textContent = state === 'copied' ? this.#words.copied : this.#words.copy;
    this.#news.textContent = state === 'copied' ? this.#words.copied : '';
  }

  #clear(): void {
    this.#showCopy('copy');
    this.#view?.destroy();
    this.#view = undefined;
  }
}

const WORDS = words({
  en: {
    writeOut: 'Expand cycles',
    writeOutHint: 'Show the program with every cycle expanded to plain moves',
    writtenOut: 'The expanded program',
    writtenOutAbout: 'Every cycle, corner and compensation as plain moves. The tool path is the same.',
    nothingToWriteOut: 'This program consists of plain moves only: there is nothing to expand.',
    copy: 'Copy',
    copied: 'Copied',
    copyYourself: 'Copying is not allowed here. All of it is selected: press Ctrl C.',
    apply: 'Put into the editor',
    applied: 'The program is expanded. Ctrl Z in the editor restores yours.',
  },
  zh: {
    writeOut: '展开循环',
    writeOutHint: '显示将所有循环展开为普通移动指令后的程序',
    writtenOut: '展开后的程序',
    writtenOutAbout: '循环、倒角和刀尖补偿均已写成普通移动指令，刀具轨迹不变。',
    nothingToWriteOut: '此程序只有普通移动指令，没有可展开的内容。',
    copy: '复制',
    copied: '已复制',
    copyYourself: '此处不允许自动复制。已全部选中，请按 Ctrl C。',
    apply: '放入编辑器',
    applied: '程序已展开。在编辑器中按 Ctrl Z 可恢复原程序。',
  },
  ru: {
    writeOut: 'Развернуть циклы',
    writeOutHint: 'Показать программу, в которой каждый цикл развёрнут в простые перемещения',
    writtenOut: 'Развёрнутая программа',
    writtenOutAbout: 'Циклы, фаски, скругления и коррекция записаны простыми перемещениями. Траектория та же.',
    nothingToWriteOut: 'В этой программе только простые перемещения: разворачивать нечего.',
    copy: 'Копировать',
    copied: 'Скопировано',
    copyYourself: 'Копирование здесь запрещено. Текст выделен: нажмите Ctrl C.',
    apply: 'Поместить в редактор',
    applied: 'Программа развёрнута. Ctrl Z в редакторе вернёт прежнюю.',
  },
});
