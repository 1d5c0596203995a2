// The dialog "Insert a cycle": a card with a figure for each cycle of the control that the interpreter proposes as a
// whole.
//
// In: the proposals for the line of the cursor, and the table of codes. Out: the chosen cycle with its fields, in place
// of the line. Loaded when it is first opened. Must not know: the words of a cycle.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import { COMMON, words } from '../dom/words';
import { completionAt } from '../editor/place-help';
import type { CodeRow, Codes, CompletionItem } from '../protocol/protocol';
import { cycleFigure } from './cycle-figures';
import type { Shell } from './panel';
import chooserStyles from './cycle-chooser.css?inline';

export class CycleChooser {
  readonly #shell: Shell;
  readonly #list = make('ul', { className: 'cycles' });
  readonly #dialog = new Dialog('cycle-chooser', [this.#list]);
  #insert: (chosen: CompletionItem) => void = () => undefined;

  constructor(shell: Shell) {
    this.#shell = shell;
    shell.addStyles(chooserStyles);
    shell.region('dialogs').append(this.#dialog.element);
    this.#list.addEventListener('keydown', (event) => this.#handleKey(event));
  }

  get isOpen(): boolean {
    return this.#dialog.open;
  }

  /** Shows the cycles that fit the line of the cursor. `insert` is called with the chosen one, after the dialog. */
  async open(insert: (chosen: CompletionItem) => void): Promise<void> {
    const { editor, language } = this.#shell;
    const [proposals, codes] = await Promise.all([
      completionAt(this.#shell, editor.cursor, true),
      this.#shell.ask('codes', undefined),
    ]);
    const texts = WORDS[language];
    const cards = codes === undefined ? [] : (proposals?.items ?? []).flatMap((item) => this.#card(item, codes));
    this.#insert = insert;
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    const about = matchMedia('(pointer: coarse)').matches ? texts.about : `${texts.about}${texts.keys}`;
    this.#dialog.about = cards.length === 0 ? texts.none : about;
    this.#list.replaceChildren(...cards.map((card) => make('li', {}, card)));
    this.#dialog.show();
    cards[0]?.focus();
  }

  /** The card of a proposal; none if it is not a cycle. */
  #card(item: CompletionItem, codes: Codes): readonly HTMLButtonElement[] {
    const code = /^G\d+(\.\d+)?\b/.exec(item.text)?.[0];
    const figure = item.kind === 'snippet' && code !== undefined ? cycleFigure(inSystemA(code, codes)) : undefined;
    if (figure === undefined || code === undefined) return [];
    const card = make(
      'button',
      { type: 'button', className: 'framed cycle' },
      make('span', {}, make('span', { className: 'cycle-code', lang: 'en' }, code), ' ', item.detail),
    );
    card.prepend(figure);
    card.addEventListener('click', () => {
      this.#dialog.close();
      this.#insert(item);
    });
    return [card];
  }

  /** The arrow keys move between the cards. */
  #handleKey(event: KeyboardEvent): void {
    const cards = [...this.#list.querySelectorAll('button')];
    const at = cards.findIndex((card) => card.matches(':focus'));
    const [first, second] = [cards[0]?.offsetTop, cards.findIndex((card) => card.offsetTop !== cards[0]?.offsetTop)];
    const columns = first === undefined || second < 1 ? cards.length : second;
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns, ArrowDown: columns }[event.key];
    const next = step === undefined || at < 0 ? undefined : cards[at + step];
    if (step === undefined) return;
    next?.focus();
    event.preventDefault();
  }
}

/** A code of the selected control as FANUC's system A has it. */
function inSystemA(code: string, { columns, rows }: Codes): string {
  const own = columns[0]?.key;
  const has = (row: CodeRow): boolean => own !== undefined && row[own].split(' ').includes(code);
  const [inA = code, ...further] = rows.find(has)?.a.split(' ') ?? [];
  return further.includes(code) ? code : inA;
}

const WORDS = words({
  en: {
    title: 'Insert a cycle',
    about: 'The cycle is inserted at the cursor.',
    keys: ' Tab leads from number to number, Ctrl Z removes the cycle.',
    none: 'No cycle can be inserted here.',
  },
  zh: {
    title: '插入循环',
    about: '循环插入在光标处。',
    keys: '按 Tab 依次转到各数值，按 Ctrl Z 删去循环。',
    none: '此处不能插入循环。',
  },
  ru: {
    title: 'Вставка цикла',
    about: 'Цикл вставляется у курсора.',
    keys: ' Tab переводит от числа к числу, Ctrl Z убирает цикл.',
    none: 'Здесь нельзя вставить цикл.',
  },
});
