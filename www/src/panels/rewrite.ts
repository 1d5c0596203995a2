// The button "Write as a cycle" and its dialog: the plain moves that can be written as a cycle, each in its current
// form and as a cycle.
//
// In: the offers, as an answer; those at the cursor come first. Out: the edits of the offer that the user applies. Must
// not know: the definition of a cycle.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { Rewriting } from '../protocol/protocol';
import type { Key, Panel, PanelKind, Shell } from './panel';
import rewriteStyles from './rewrite.css?inline';

export const rewrite: PanelKind = {
  control: 'tools',
  edits: true,
  styles: rewriteStyles,
  make: (shell) => new Rewrite(shell),
};

class Rewrite implements Panel {
  readonly #shell: Shell;
  readonly #button = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #list = make('ul', { className: 'rewritings' });
  readonly #dialog = new Dialog('rewrite', [this.#list]);
  readonly elements = { 'more-menu': [this.#button], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#showOffers());
    this.available = false;
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#button.textContent = texts.button;
    this.#button.title = texts.hint;
    this.#dialog.setTexts(texts.title, COMMON[language].close);
  }

  /** Whether there is a finished run with motions. */
  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  get available(): boolean {
    return !this.#button.disabled;
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  onKey({ event }: Key): 'handled' | 'ignored' {
    if (event.key !== 'Enter' || !event.altKey || event.composedPath()[0] instanceof HTMLInputElement) return 'ignored';
    void this.#showOffers();
    return 'handled';
  }

  async #showOffers(): Promise<void> {
    const { editor } = this.#shell;
    if (!this.available) return;
    this.#shell.flush();
    const { revision } = editor;
    const rewritings = await this.#shell.ask('rewritings', editor.selection);
    if (rewritings !== undefined && editor.revision === revision) this.#show(rewritings);
  }

  #apply({ edits, cycle }: Rewriting): void {
    const { editor, language } = this.#shell;
    editor.change(edits);
    this.#shell.commitEdit();
    this.#shell.service('notice')(WORDS[language].applied(cycle), 'program');
    editor.focus();
  }

  #show(rewritings: readonly Rewriting[]): void {
    const texts = WORDS[this.#shell.language];
    this.#dialog.about = rewritings.length === 0 ? texts.none : texts.about;
    this.#list.hidden = rewritings.length === 0;
    const ordered = [...rewritings.filter(({ here }) => here), ...rewritings.filter(({ here }) => !here)];
    this.#list.replaceChildren(...ordered.map((rewriting) => this.#renderItem(rewriting)));
    this.#dialog.show();
    // Enter applies the offer at the cursor.
    this.#list.querySelector('button')?.focus();
  }

  #renderItem(rewriting: Rewriting): HTMLElement {
    const texts = WORDS[this.#shell.language];
    const lines = texts.lines(rewriting.line, rewriting.endLine);
    const applyButton = make(
      'button',
      { type: 'button', className: 'framed', 'aria-label': `${texts.apply}: ${lines}` },
      texts.apply,
    );
    applyButton.addEventListener('click', () => {
      this.#dialog.close();
      this.#apply(rewriting);
    });
    const code = (text: string): HTMLElement => make('pre', { lang: 'en' }, text);
    return make(
      'li',
      { className: rewriting.here ? 'here' : '' },
      make('h3', {}, rewriting.title),
      make('span', { className: 'lines' }, lines),
      applyButton,
      make(
        'div',
        { className: 'both' },
        code(rewriting.before),
        make('span', { 'aria-hidden': 'true' }, '→'),
        code(rewriting.after),
      ),
    );
  }
}

const WORDS = words({
  en: {
    button: 'Write as a cycle…',
    hint: 'Write plain moves that form a G90, G92 or G94 as that cycle',
    title: 'Write as a cycle',
    about: 'Each of these was tried: the motions stay the same.',
    none: 'No plain moves of this program form a G90, G92 or G94: rapid in, cut, out, and rapid back to the start point, each in a block of its own with nothing else in it.',
    lines: (first: number, last: number) => `Lines ${first} to ${last}`,
    apply: 'Write it so',
    applied: (cycle: string) =>
      `Written as ${cycle}; the motions are the same. Ctrl Z in the editor brings the moves back.`,
  },
  zh: {
    button: '写成循环…',
    hint: '将构成 G90、G92 或 G94 的普通移动指令写成该循环',
    title: '写成循环',
    about: '下列各项均已试运行：运动轨迹不变。',
    none: '此程序中没有构成 G90、G92 或 G94 的普通移动指令：快速进刀、切削、退刀、快速返回起点，各占一个程序段，且段内无其他指令。',
    lines: (first, last) => `第 ${first} 至 ${last} 行`,
    apply: '改写',
    applied: (cycle) => `已写成 ${cycle}，运动轨迹不变。在编辑器中按 Ctrl Z 可恢复原来的程序段。`,
  },
  ru: {
    button: 'Записать циклом…',
    hint: 'Записать простые перемещения, образующие G90, G92 или G94, этим циклом',
    title: 'Записать циклом',
    about: 'Каждая замена проверена: перемещения остаются теми же.',
    none: 'В этой программе нет простых перемещений, образующих G90, G92 или G94: ускоренный подвод, резание, отвод и ускоренный возврат в начальную точку, каждое в своём кадре, где больше ничего нет.',
    lines: (first, last) => `Строки ${first}–${last}`,
    apply: 'Записать так',
    applied: (cycle) => `Записано циклом ${cycle}, перемещения те же. Ctrl Z в редакторе вернёт прежние кадры.`,
  },
});
