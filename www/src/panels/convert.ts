// "Convert…": the program is written in another form and makes the same motions.
//
// In: the edits and the words that stay, as an answer. Out: one change of the text, which undo reverts. Must not know:
// which words a form is about. Another G-code system is not among the forms: the setup would have to change with it.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import type { Converted, ProgramForm } from '../protocol/protocol';
import { applyEdits } from './apply-edits';
import type { Panel, PanelKind, Shell } from './panel';
import convertStyles from './convert.css?inline';

/** The forms by subject. */
const FORMS = {
  coordinates: ['absolute', 'incremental'],
  arcs: ['radius', 'center'],
  cycles: ['one-block', 'two-blocks'],
  units: ['mm', 'inch'],
} as const satisfies Record<string, readonly ProgramForm[]>;

type Subject = keyof typeof FORMS;
type Form = (typeof FORMS)[Subject][number];

export const convert: PanelKind = {
  control: 'tools',
  edits: true,
  styles: convertStyles,
  make: (shell) => new Convert(shell),
};

class Convert implements Panel {
  readonly #shell: Shell;
  readonly #open = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #groups = Object.entries(FORMS).map(([subject, forms]) => ({
    subject: subject as Subject,
    element: make('optgroup', {}, ...forms.map((value) => make('option', { value }))),
  }));
  readonly #form = make('select', {}, ...this.#groups.map(({ element }) => element));
  readonly #caption = make('span');
  readonly #apply = make('button', { type: 'button', className: 'primary' });
  readonly #status = make('p', { role: 'status' });
  readonly #dialog = new Dialog(
    'convert',
    [make('label', { className: 'convert-form' }, this.#caption, this.#form)],
    [this.#status, this.#apply],
  );
  readonly elements = { 'more-menu': [this.#open], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#open.addEventListener('click', () => this.#openForm());
    this.#apply.addEventListener('click', () => void this.#convert());
    this.#form.addEventListener('change', () => (this.#status.textContent = ''));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#open.textContent = `${texts.convert}…`;
    this.#open.title = texts.hint;
    this.#dialog.setTexts(texts.convert, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#caption.textContent = texts.form;
    for (const { subject, element } of this.#groups) element.label = texts.subjects[subject];
    for (const option of this.#form.options) option.textContent = texts.forms[option.value as Form];
    this.#apply.textContent = texts.apply;
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  #openForm(): void {
    this.#status.textContent = '';
    this.#dialog.show();
    this.#form.focus();
  }

  async #convert(): Promise<void> {
    const form = this.#form.value as Form;
    const answer = await applyEdits(this.#shell, () => this.#shell.ask('converted', form));
    if (answer === undefined) return;
    const text = this.#outcome(answer);
    if (answer.kind === 'edits' && answer.edits.length > 0) {
      this.#dialog.close();
      this.#shell.service('notice')(text, 'program');
    } else this.#status.textContent = text;
  }

  /** The text about an answer. */
  #outcome(answer: Converted): string {
    const texts = WORDS[this.#shell.language];
    if (answer.kind === 'refused') return texts.refused(answer.reason);
    const { edits, left, firstLeft } = answer;
    if (firstLeft === undefined) return edits.length > 0 ? texts.converted('') : texts.isConverted;
    const { line, text } = firstLeft;
    return edits.length > 0 ? texts.converted(texts.stays(left, line, text)) : texts.notConverted(line, text);
  }
}

const [en, zh, ru] = [
  counter('en', { one: 'word stays', other: 'words stay' }),
  counter('zh', { other: '个指令字未转换' }),
  counter('ru', { one: 'слово не изменено', few: 'слова не изменены', other: 'слов не изменено' }),
];

const WORDS = words({
  en: {
    convert: 'Convert',
    hint: 'Write coordinates, arcs, cycles or units in another form; the motions stay the same',
    about:
      'The program is run before and after: the motions stay the same. A word stays if it cannot be converted safely: for example, its block has an expression, the tool position is unknown, or the block starts from several positions.',
    form: 'Write',
    subjects: { coordinates: 'Coordinates', arcs: 'Arcs', cycles: 'Cycles', units: 'Units' },
    forms: {
      absolute: 'U and W as X and Z',
      incremental: 'X and Z as U and W',
      radius: 'I and K as R',
      center: 'R as I and K',
      'one-block': 'G71 to G76 in one block',
      'two-blocks': 'G71 to G76 in two blocks',
      mm: 'lengths in millimetres (G21)',
      inch: 'lengths in inches (G20)',
    },
    apply: 'Convert',
    stays: (count: number, line: number, word: string) =>
      count === 1 ? ` ${en(1)}: ${word} in line ${line}.` : ` ${en(count)}, the first in line ${line}: ${word}.`,
    converted: (stays: string) =>
      `Converted; the motions are the same.${stays} Ctrl Z in the editor brings the old text back.`,
    isConverted: 'Nothing to convert: the program is already in this form.',
    notConverted: (line: number, word: string) => `Not converted: ${word} in line ${line} cannot be changed.`,
    refused: (reason: string) => `Not converted: ${reason}.`,
  },
  zh: {
    convert: '转换写法',
    hint: '将坐标、圆弧、循环或单位改用另一种写法，运动轨迹不变',
    about:
      '改写前后各试运行一次，运动轨迹保持不变。无法可靠转换的指令字保持原样，例如：程序段中有表达式、刀具位置未知，或同一程序段从不同位置开始执行。',
    form: '转换内容',
    subjects: { coordinates: '坐标', arcs: '圆弧', cycles: '循环', units: '单位' },
    forms: {
      absolute: 'U、W 改为 X、Z',
      incremental: 'X、Z 改为 U、W',
      radius: 'I、K 改为 R',
      center: 'R 改为 I、K',
      'one-block': 'G71～G76 写成一个程序段',
      'two-blocks': 'G71～G76 写成两个程序段',
      mm: '英制改为公制（G21）',
      inch: '公制改为英制（G20）',
    },
    apply: '转换',
    stays: (count, line, word) =>
      count === 1 ? `${zh(1)}：第 ${line} 行的 ${word}。` : `${zh(count)}，第一个是第 ${line} 行的 ${word}。`,
    converted: (stays) => `已转换，运动轨迹不变。${stays}在编辑器中按 Ctrl Z 可恢复原文。`,
    isConverted: '无需转换：程序已采用这种写法。',
    notConverted: (line, word) => `未转换：第 ${line} 行的 ${word} 无法改写。`,
    refused: (reason) => `未转换：${reason}。`,
  },
  ru: {
    convert: 'Преобразовать',
    hint: 'Записать координаты, дуги, циклы или единицы в другой форме; перемещения не меняются',
    about:
      'Программа проверяется до и после замены: перемещения остаются теми же. Слово не изменяется, если преобразовать его надёжно нельзя: например, в кадре есть выражение, положение инструмента неизвестно или кадр выполняется из разных начальных точек.',
    form: 'Записать',
    subjects: { coordinates: 'Координаты', arcs: 'Дуги', cycles: 'Циклы', units: 'Единицы измерения' },
    forms: {
      absolute: 'X и Z вместо U и W',
      incremental: 'U и W вместо X и Z',
      radius: 'R вместо I и K',
      center: 'I и K вместо R',
      'one-block': 'G71–G76 одним кадром',
      'two-blocks': 'G71–G76 двумя кадрами',
      mm: 'размеры в миллиметрах (G21)',
      inch: 'размеры в дюймах (G20)',
    },
    apply: 'Преобразовать',
    stays: (count, line, word) =>
      count === 1 ? ` ${ru(1)}: ${word} в строке ${line}.` : ` ${ru(count)}, первое — в строке ${line}: ${word}.`,
    converted: (stays) => `Преобразовано, перемещения те же.${stays} Ctrl Z в редакторе вернёт прежний текст.`,
    isConverted: 'Преобразовывать нечего: программа уже записана в этой форме.',
    notConverted: (line, word) => `Не преобразовано: ${word} в строке ${line} нельзя записать в этой форме.`,
    refused: (reason) => `Не преобразовано: ${reason}.`,
  },
});
