// "Format" and "Renumber…": the program is written in another way, and stays the same program.
//
// In: the edits, or the reason why the program stays as it is, as an answer. Out: one change of the text, which undo
// reverts. Must not know: the rules of the format, or the words that refer to a block.

import { Dialog } from '../dom/dialog';
import { make, renderProse } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { Numbering, Tidied } from '../protocol/protocol';
import { applyEdits } from './apply-edits';
import type { Panel, PanelKind, Shell } from './panel';
import tidyStyles from './tidy.css?inline';

const BLOCKS: readonly Numbering['blocks'][] = ['numbered', 'all', 'none'];
/** A block that begins with a number; it may be skipped. */
const NUMBERED = /^[ \t]*(?:\/\d?[ \t]*)?N\d/im;
/** The first number and the step that the form begins with. */
const USUAL = '10';

export const tidy: PanelKind = {
  control: 'tools',
  edits: true,
  styles: tidyStyles,
  make: (shell) => new Tidy(shell),
};

class Tidy implements Panel {
  readonly #shell: Shell;
  readonly #format = menuItem({});
  readonly #renumber = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #blocks = make('select', {}, ...BLOCKS.map((value) => make('option', { value })));
  readonly #from = make('input', { type: 'number', min: '1', max: '99999', value: USUAL });
  readonly #step = make('input', { type: 'number', min: '1', max: '9999', value: USUAL });
  readonly #captions = { blocks: make('span'), from: make('span'), step: make('span') };
  readonly #apply = make('button', { type: 'button', className: 'primary' });
  readonly #status = make('p', { role: 'status' });
  readonly #dialog = new Dialog(
    'renumber',
    [
      make(
        'div',
        { className: 'tidy-fields' },
        make('label', {}, this.#captions.blocks, this.#blocks),
        make('label', {}, this.#captions.from, this.#from),
        make('label', {}, this.#captions.step, this.#step),
      ),
    ],
    [this.#status, this.#apply],
  );
  readonly elements = { 'more-menu': [this.#format, this.#renumber], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#format.addEventListener('click', () => void this.#formatProgram());
    this.#renumber.addEventListener('click', () => this.#openForm());
    this.#apply.addEventListener('click', () => void this.#renumberProgram());
    this.#blocks.addEventListener('change', () => this.#showFields());
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#format.textContent = texts.format;
    this.#format.title = texts.formatHint;
    this.#renumber.textContent = `${texts.renumber}…`;
    this.#renumber.title = texts.renumberHint;
    this.#dialog.setTexts(texts.renumber, COMMON[language].close);
    this.#dialog.about = texts.about;
    for (const name of ['blocks', 'from', 'step'] as const) this.#captions[name].textContent = texts[name];
    for (const option of this.#blocks.options) option.textContent = texts.choices[option.value as Numbering['blocks']];
    this.#apply.textContent = texts.apply;
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  #openForm(): void {
    this.#status.textContent = '';
    if (!NUMBERED.test(this.#shell.editor.text)) this.#blocks.value = 'all';
    this.#showFields();
    this.#dialog.show();
    this.#blocks.focus();
  }

  /** Without numbers there is neither a first one nor a step. */
  #showFields(): void {
    this.#from.disabled = this.#step.disabled = this.#blocks.value === 'none';
  }

  async #formatProgram(): Promise<void> {
    const texts = WORDS[this.#shell.language];
    const refusal = await this.#change(
      () => this.#shell.ask('formatted', undefined),
      [texts.formatted, texts.isFormatted],
    );
    if (refusal !== undefined) this.#shell.service('notice')(texts.notFormatted(refusal), 'program');
  }

  async #renumberProgram(): Promise<void> {
    const texts = WORDS[this.#shell.language];
    const blocks = BLOCKS.find((value) => value === this.#blocks.value) ?? 'numbered';
    const [from, step] = [this.#from, this.#step].map((input) => input.valueAsNumber);
    if (blocks !== 'none' && !(this.#from.checkValidity() && this.#step.checkValidity() && from && step)) {
      this.#status.textContent = texts.wrongNumber;
      return;
    }
    const refusal = await this.#change(
      () => this.#shell.ask('renumbered', { from: from || 1, step: step || 1, blocks }),
      [texts.renumbered, texts.isRenumbered],
    );
    if (refusal === undefined) this.#dialog.close();
    else this.#status.replaceChildren(...renderProse(texts.notRenumbered(refusal)));
  }

  /** Applies the edits of an answer. Returns the reason if the program stays as it is. */
  async #change(
    ask: () => Promise<Tidied | undefined>,
    [changed, same]: readonly [string, string],
  ): Promise<string | undefined> {
    const answer = await applyEdits(this.#shell, ask);
    if (answer === undefined) return undefined;
    if (answer.kind === 'refused') {
      const { line, reason } = answer;
      const { language } = this.#shell;
      const text = line === undefined ? reason : WORDS[language].at(COMMON[language].line(line), reason);
      return text.charAt(0).toLocaleUpperCase(language) + text.slice(1);
    }
    this.#shell.service('notice')(answer.edits.length > 0 ? changed : same, 'program');
    return undefined;
  }
}

const WORDS = words({
  en: {
    format: 'Format',
    formatHint: 'Write blanks, case and leading zeros of G and M codes uniformly',
    renumber: 'Renumber',
    renumberHint: 'Write new N numbers; P, Q, GOTO and M99 P follow',
    about: 'P, Q, GOTO, M97 and M99 P follow. The program is run before and after: motions and messages stay the same.',
    blocks: 'Blocks',
    choices: { numbered: 'those that have a number', all: 'all', none: 'none: remove unused numbers' },
    from: 'First number',
    step: 'Step',
    apply: 'Renumber',
    formatted: 'Formatted; the program is the same. Ctrl Z in the editor brings the old text back.',
    isFormatted: 'The program is formatted already.',
    notFormatted: (reason: string) => `Not formatted. ${reason}.`,
    renumbered: 'Renumbered; the program is the same. Ctrl Z in the editor brings the old numbers back.',
    isRenumbered: 'The numbers are already like this.',
    notRenumbered: (reason: string) => `Not renumbered. ${reason}.`,
    at: (line: string, reason: string) => `${line}: ${reason}`,
    wrongNumber: 'First number and step are whole numbers from 1 on.',
  },
  zh: {
    format: '整理格式',
    formatHint: '统一空格、大小写以及 G、M 代码的前导零',
    renumber: '重编顺序号',
    renumberHint: '写入新的顺序号 N；引用它们的 P、Q、GOTO 和 M99 P 同步更改',
    about: '引用顺序号的 P、Q、GOTO、M97 和 M99 P 同步更改。改写前后各试运行一次，运动轨迹和提示信息保持不变。',
    blocks: '编号范围',
    choices: { numbered: '仅已有顺序号的程序段', all: '全部程序段', none: '不编号：删除未被引用的顺序号' },
    from: '起始顺序号',
    step: '增量',
    apply: '重新编号',
    formatted: '已整理格式，运动轨迹和提示信息不变。在编辑器中按 Ctrl Z 可恢复原文。',
    isFormatted: '格式已符合规范，无需整理。',
    notFormatted: (reason) => `未整理格式。${reason}。`,
    renumbered: '已重新编号，运动轨迹和提示信息不变。在编辑器中按 Ctrl Z 可恢复原顺序号。',
    isRenumbered: '顺序号已符合要求，无需修改。',
    notRenumbered: (reason) => `未重新编号。${reason}。`,
    at: (line, reason) => `${line}：${reason}`,
    wrongNumber: '起始顺序号和增量必须是不小于 1 的整数。',
  },
  ru: {
    format: 'Форматировать',
    formatHint: 'Привести к единому виду пробелы, регистр букв и ведущие нули в кодах G и M',
    renumber: 'Перенумеровать',
    renumberHint: 'Присвоить кадрам новые номера N и исправить ссылки на них в P, Q, GOTO и M99 P',
    about:
      'Ссылки P, Q, GOTO, M97 и M99 P исправляются. Программа проверяется до и после замены: перемещения и сообщения остаются теми же.',
    blocks: 'Нумеровать кадры',
    choices: { numbered: 'только с номером', all: 'все', none: 'никакие: удалить номера, на которые нет ссылок' },
    from: 'Первый номер',
    step: 'Шаг',
    apply: 'Перенумеровать',
    formatted: 'Отформатировано, действие программы не изменилось. Ctrl Z в редакторе вернёт прежний текст.',
    isFormatted: 'Программа уже отформатирована.',
    notFormatted: (reason) => `Не отформатировано. ${reason}.`,
    renumbered: 'Перенумеровано, действие программы не изменилось. Ctrl Z в редакторе вернёт прежние номера.',
    isRenumbered: 'Номера уже соответствуют заданным, менять нечего.',
    notRenumbered: (reason) => `Не перенумеровано. ${reason}.`,
    at: (line, reason) => `${line}: ${reason}`,
    wrongNumber: 'Первый номер и шаг — целые числа от 1.',
  },
});
