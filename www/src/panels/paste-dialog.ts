// The programs found in a text: a list of them, and the chosen one cleaned. Every change is marked, and the dialog asks
// about ambiguous ones.
//
// In: the list, and the pieces of the chosen program, requested by `piecesOf`. Out: `onApply` with its text. Must not
// know: how programs are found, or where the text goes.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import type { FoundPiece, FoundProgram, FoundPrograms } from '../protocol/protocol';

interface PasteDialogEvents {
  /** The pieces of a program; `undefined` if the interpreter has been restarted. */
  piecesOf(program: number): Promise<readonly FoundPiece[] | undefined>;
  onApply(text: string): void;
}

export class PasteDialog {
  readonly #events: PasteDialogEvents;
  readonly #list = make('div', { className: 'found-programs', role: 'radiogroup' });
  readonly #shown = make('div', { className: 'text cleaned', tabIndex: 0, role: 'region', lang: 'en' });
  readonly #reasons = make('ul', { className: 'what' });
  readonly #summary = make('summary');
  readonly #details = make('details', { className: 'changes' }, this.#summary, this.#reasons);
  readonly #allMinus = make('button', { type: 'button', className: 'framed' });
  readonly #applyButton = make('button', { type: 'button', className: 'primary' });
  readonly #leave = make('button', { type: 'button', className: 'framed' });
  readonly #dialog: Dialog;
  #language: Language;
  #found: FoundPrograms | undefined;
  #trigger: 'inserted' | 'requested' = 'requested';
  #program = 0;
  /** Pieces of the chosen program; empty until they arrive. */
  #pieces: readonly FoundPiece[] = [];
  /** Number of the latest request for pieces. */
  #request = 0;
  /** For each piece with a question, the number of the chosen answer. */
  readonly #answers = new Map<number, number>();

  constructor(language: Language, events: PasteDialogEvents) {
    this.#language = language;
    this.#events = events;
    this.#dialog = new Dialog(
      'paste',
      [this.#list, this.#shown, this.#details],
      [this.#allMinus, this.#leave, this.#applyButton],
    );
    this.#leave.addEventListener('click', () => this.#dialog.close());
    this.#applyButton.addEventListener('click', () => {
      const text = this.#text();
      this.#dialog.close();
      this.#events.onApply(text);
    });
    this.#allMinus.addEventListener('click', () => this.#chooseAllMinus());
    this.element.addEventListener('close', () => {
      this.#found = undefined;
      this.#request++;
      this.#showPieces([]);
    });
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.#applyButton.textContent = texts.apply;
    this.#allMinus.textContent = texts.allMinus;
    this.#summary.textContent = texts.what;
    this.#list.setAttribute('aria-label', texts.list);
    this.#shown.setAttribute('aria-label', texts.cleaned);
    if (this.#found === undefined) return;
    this.#showName();
    this.#showList(this.#found);
    void this.#choose(this.#program);
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  /** `trigger`: the text has just arrived, or the user opened the dialog. */
  show(found: FoundPrograms, trigger: 'inserted' | 'requested'): void {
    this.#found = found;
    this.#trigger = trigger;
    this.#program = 0;
    this.#showName();
    this.#showList(found);
    this.#dialog.show();
    void this.#choose(0);
    this.#list.querySelector('input')?.focus();
  }

  /** Chooses a program. Until its pieces arrive, there is nothing to apply. */
  async #choose(program: number): Promise<void> {
    this.#program = program;
    this.#showPieces([]);
    const request = ++this.#request;
    const pieces = await this.#events.piecesOf(program);
    if (pieces !== undefined && request === this.#request) this.#showPieces(pieces);
  }

  #showPieces(pieces: readonly FoundPiece[]): void {
    this.#pieces = pieces;
    this.#applyButton.disabled = pieces.length === 0;
    this.#answers.clear();
    const rows = pieces.map((piece, at) => this.#renderPiece(piece, at));
    this.#shown.replaceChildren(...rows.flat());
    this.#shown.scrollTop = 0;
    this.#allMinus.hidden = this.#minusAnswers().length < 2;
    const reasons = new Map<string, number>();
    for (const { reason } of pieces) if (reason !== '') reasons.set(reason, (reasons.get(reason) ?? 0) + 1);
    this.#reasons.replaceChildren(
      ...[...reasons].map(([reason, count]) => make('li', {}, count > 1 ? `${reason} (${count})` : reason)),
    );
    this.#details.hidden = reasons.size === 0;
  }

  #showName(): void {
    const { title, asItIs } = WORDS[this.#language];
    this.#dialog.setTexts(title, COMMON[this.#language].close);
    this.#leave.textContent = asItIs;
    this.#leave.hidden = this.#trigger === 'requested';
  }

  #showList(found: FoundPrograms): void {
    const texts = WORDS[this.#language];
    const about = texts.about(found.programs.length);
    this.#dialog.about = found.more > 0 ? `${about} ${texts.more(found.more)}` : about;
    this.#list.replaceChildren(...found.programs.map((program, at) => this.#renderRow(program, at)));
  }

  #renderRow(program: FoundProgram, at: number): HTMLElement {
    const texts = WORDS[this.#language];
    const lines = texts.lines(program.firstLine, program.lastLine);
    const input = make('input', { type: 'radio', name: 'found', checked: at === this.#program });
    input.addEventListener('change', () => void this.#choose(at));
    const facts = [
      program.name === '' ? '' : lines,
      program.changes > 0 ? texts.changes(program.changes) : '',
      program.questions > 0 ? texts.questions(program.questions) : '',
      program.changes + program.questions === 0 ? texts.unchanged : '',
    ].filter((fact) => fact !== '');
    return make(
      'label',
      {},
      input,
      make('span', { className: 'name' }, program.name === '' ? lines : program.name),
      make('span', { className: 'facts' }, facts.join(' · ')),
    );
  }

  #renderPiece({ was, now, reason, choices }: FoundPiece, at: number): (Node | string)[] {
    if (reason === '') return [now];
    if (choices.length > 1) return [this.#renderQuestion(choices, reason, at)];
    const rendered: (Node | string)[] = [];
    if (was !== '') rendered.push(make('del', { title: reason }, was));
    // A new line is visible without a mark; other additions are marked.
    if (now.trim() === '') rendered.push(now);
    else rendered.push(...(now.startsWith(' ') ? [' '] : []), make('ins', { title: reason }, now.trimStart()));
    return rendered;
  }

  #renderQuestion(choices: readonly string[], reason: string, at: number): HTMLElement {
    const rows = choices.map((choice, number) => {
      const input = make('input', {
        type: 'radio',
        name: `question-${at}`,
        value: String(number),
        checked: number === 0,
      });
      input.addEventListener('change', () => this.#answers.set(at, number));
      return make('label', {}, input, number === 0 ? WORDS[this.#language].asPrinted(choice) : choice);
    });
    return make('span', { className: 'question', role: 'radiogroup', 'aria-label': reason, title: reason }, ...rows);
  }

  /** Pieces that ask whether a minus sign is missing, and the choice that has it. */
  #minusAnswers(): { at: number; number: number }[] {
    return this.#pieces.flatMap(({ choices }, at) => {
      const number = choices.findIndex((choice) => choice.includes('-'));
      return number < 1 ? [] : [{ at, number }];
    });
  }

  #chooseAllMinus(): void {
    for (const { at, number } of this.#minusAnswers()) {
      this.#answers.set(at, number);
      const input = this.#shown.querySelector<HTMLInputElement>(`input[name="question-${at}"][value="${number}"]`);
      if (input !== null) input.checked = true;
    }
  }

  #text(): string {
    return this.#pieces.map(({ now, choices }, at) => choices[this.#answers.get(at) ?? 0] ?? now).join('');
  }
}

const numbers = {
  en: {
    programs: counter('en', { one: 'program', other: 'programs' }),
    changes: counter('en', { one: 'change', other: 'changes' }),
    questions: counter('en', { one: 'question', other: 'questions' }),
  },
  zh: {
    programs: counter('zh', { other: '个程序' }),
    changes: counter('zh', { other: '处修改' }),
    questions: counter('zh', { other: '个问题' }),
  },
  ru: {
    programs: counter('ru', { one: 'программа', few: 'программы', many: 'программ', other: 'программы' }),
    changes: counter('ru', { one: 'исправление', few: 'исправления', many: 'исправлений', other: 'исправления' }),
    questions: counter('ru', { one: 'вопрос', few: 'вопроса', many: 'вопросов', other: 'вопроса' }),
  },
};

const WORDS = words({
  en: {
    title: 'Programs in this text',
    about: (n: number) =>
      `${numbers.en.programs(n)} found. The text is in the editor as it was; undo brings it back after a program is taken.`,
    more: (n: number) => `${numbers.en.programs(n)} more not listed: paste a shorter text.`,
    list: 'Programs found',
    lines: (first: number, last: number) => (first === last ? `line ${first}` : `lines ${first}–${last}`),
    changes: numbers.en.changes,
    questions: numbers.en.questions,
    unchanged: 'as it was',
    cleaned: 'The program, cleaned',
    what: 'What was changed',
    asPrinted: (text: string) => `${text} as printed`,
    allMinus: 'All of these negative',
    apply: 'Take this program',
    asItIs: 'Paste as it is',
  },
  zh: {
    title: '文本中的程序',
    about: (n) => `找到 ${numbers.zh.programs(n)}。文本已原样放入编辑器；采用程序后可撤销恢复。`,
    more: (n) => `还有 ${numbers.zh.programs(n)}未列出：请粘贴较短的文本。`,
    list: '找到的程序',
    lines: (first, last) => (first === last ? `第 ${first} 行` : `第 ${first}–${last} 行`),
    changes: numbers.zh.changes,
    questions: numbers.zh.questions,
    unchanged: '未修改',
    cleaned: '清理后的程序',
    what: '修改内容',
    asPrinted: (text) => `${text}（按原文）`,
    allMinus: '全部取负值',
    apply: '采用此程序',
    asItIs: '原样粘贴',
  },
  ru: {
    title: 'Программы в этом тексте',
    about: (n) =>
      `Найдено: ${numbers.ru.programs(n)}. Текст вставлен в редактор без изменений; когда программа вставлена, отмена вернёт его.`,
    more: (n) => `Не показано ещё: ${numbers.ru.programs(n)}. Вставьте текст короче.`,
    list: 'Найденные программы',
    lines: (first, last) => (first === last ? `строка ${first}` : `строки ${first}–${last}`),
    changes: numbers.ru.changes,
    questions: numbers.ru.questions,
    unchanged: 'без изменений',
    cleaned: 'Очищенная программа',
    what: 'Что изменено',
    asPrinted: (text) => `${text}, как напечатано`,
    allMinus: 'Все со знаком минус',
    apply: 'Принять эту программу',
    asItIs: 'Вставить как есть',
  },
});
