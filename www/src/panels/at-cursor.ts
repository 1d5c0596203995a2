// Help at the cursor: the meaning of the word, and the state of the control before and after its block.
//
// In: answers of the interpreter about the block at the cursor, once the user has focused the text. Out: the block that
// the user selects. Must not know: the meaning of a word or a row.

import { setChildren, icon, make, renderUnbroken, setAccessibleName, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { isCompletionEnabled, setCompletionEnabled } from '../editor/completion-setting';
import { codeLink } from '../editor/rule-link';
import { factList, wordLine } from '../editor/word-help';
import type {
  CalculatorName,
  FormHelp,
  FormLine,
  FormWord,
  Help,
  HelpLine,
  StateHelp,
  StateRow,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { CycleChooser } from './cycle-chooser';
import { loadPart } from './load-part';
import {
  isInProgram,
  type Key,
  type NewestQuestion,
  type Panel,
  type PanelKind,
  type Services,
  type Shell,
  type UserCommand,
} from './panel';
import atCursorStyles from './at-cursor.css?inline';

/** Delay until the panel shows that an answer is pending, ms: an answer may need another pass over the program. */
const PENDING_AFTER_MS = 250;

export const atCursor: PanelKind = { control: 'help', styles: atCursorStyles, make: (shell) => new AtCursor(shell) };

class AtCursor implements Panel {
  readonly #shell: Shell;
  readonly #question: NewestQuestion<'help'>;
  readonly #title = make('span', { id: 'at-cursor-name' });
  readonly #line = make('span', { className: 'at-cursor-line' });
  readonly #toggle = make('button', {
    type: 'button',
    className: 'at-cursor-toggle',
    'aria-expanded': 'false',
    'aria-controls': 'at-cursor-body',
  });
  /** Shown in a blank line. */
  readonly #insert = make('button', {
    type: 'button',
    className: 'framed insert-cycle',
    'aria-haspopup': 'dialog',
    hidden: true,
  });
  readonly #header = make('div', { className: 'at-cursor-header' }, this.#toggle, this.#insert);
  /** Loaded when it is first opened. */
  #chooser: CycleChooser | undefined;
  readonly #facts = make('div', { className: 'at-cursor-facts' });
  readonly #form = make('div', { className: 'at-cursor-form' });
  readonly #previous = make('button', { type: 'button', className: 'small' }, icon('previous'));
  readonly #next = make('button', { type: 'button', className: 'small' }, icon('next'));
  readonly #executionText = make('span');
  readonly #executions = make(
    'div',
    { className: 'at-cursor-times', hidden: true },
    this.#previous,
    this.#executionText,
    this.#next,
  );
  readonly #state = make('div', { className: 'at-cursor-state' });
  readonly #completionToggle = make('input', { type: 'checkbox' });
  readonly #completionLabel = make('span');
  readonly #completionSwitch = make(
    'label',
    { className: 'at-cursor-switch' },
    this.#completionToggle,
    this.#completionLabel,
  );
  readonly #playBlock = make('button', { type: 'button', className: 'framed' });
  readonly #toCursor = make('button', { type: 'button', className: 'framed' });
  readonly #breakpoint = make('button', { type: 'button', className: 'framed' });
  readonly #actions = make('div', { className: 'at-cursor-acts' }, this.#playBlock, this.#toCursor, this.#breakpoint);
  readonly #body = make(
    'div',
    { className: 'at-cursor-body', id: 'at-cursor-body', hidden: true },
    this.#actions,
    this.#facts,
    this.#form,
    this.#executions,
    this.#state,
    this.#completionSwitch,
  );
  readonly #element = make(
    'section',
    { className: 'at-cursor', part: 'at-cursor', 'aria-labelledby': 'at-cursor-name caption' },
    this.#header,
    this.#body,
  );
  /** Whether the user has focused the text. Until then the panel asks no question and loads nothing. */
  #hasFocusedText = false;
  /** Whether to announce the next answer to screen readers. */
  #announceNext = false;
  /** Just opened, and not yet at its full height: the cursor may have to be scrolled into view. */
  #justOpened = false;
  /** Which execution of the block is shown; undefined: the default one. */
  #chosenExecution: number | undefined;
  #shown: Help | undefined;
  /** The content of each part with its language, as text, to compare; no entry if the part shows something else. */
  readonly #renderedKeys = new Map<HTMLElement, string>();
  /** Timer that shows that an answer is pending. */
  #pendingTimer: ReturnType<typeof setTimeout> | undefined;
  /** The worker cannot answer questions now. */
  #cannotAnswer = false;
  #hasNavigation = false;
  #hasMark = false;
  readonly elements = { problems: [this.#element] };
  readonly services: Partial<Services> = {
    explain: () => {
      this.#hasFocusedText = true;
      this.#setOpen(true);
    },
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#question = shell.newest('help', (help) => this.#onAnswer(help));
    this.#toggle.append(icon('chevron'), this.#title, this.#line);
    this.#toggle.addEventListener('click', () => this.#setOpen(this.#body.hidden === true));
    this.#insert.addEventListener('click', () => void this.#chooseCycle());
    // The text keeps the focus, and on a phone the button its place.
    this.#insert.addEventListener('mousedown', (event) => event.preventDefault());
    this.#previous.addEventListener('click', () => this.#chooseExecution(-1));
    this.#next.addEventListener('click', () => this.#chooseExecution(1));
    this.#completionToggle.checked = isCompletionEnabled();
    this.#completionToggle.addEventListener('change', () => setCompletionEnabled(this.#completionToggle.checked));
    this.#completionSwitch.hidden = shell.readonly;
    this.#playBlock.addEventListener('click', () => shell.service('playBlock')());
    this.#toCursor.addEventListener('click', () => shell.service('playToCursor')());
    this.#breakpoint.addEventListener('click', () => shell.service('toggleBreakpoint')());
  }

  get commands(): readonly UserCommand[] {
    const texts = WORDS[this.#shell.language];
    return [
      { name: texts.atCursor, keys: 'F1', run: () => this.services.explain?.() },
      { name: texts.playBlock, keys: 'F10', run: () => this.#shell.service('playBlock')() },
      { name: texts.toCursor, keys: 'Ctrl F10', run: () => this.#shell.service('playToCursor')() },
      { name: texts.breakpoint, keys: 'Ctrl F8', run: () => this.#shell.service('toggleBreakpoint')() },
      ...(this.#isInBlankLine ? [{ name: texts.insert, run: () => void this.#chooseCycle() }] : []),
    ];
  }

  set language(language: Language) {
    const texts = WORDS[language];
    setText(this.#title, texts.atCursor);
    setText(this.#insert, texts.insert);
    setText(this.#completionLabel, texts.completion);
    setAccessibleName(this.#previous, texts.previousExecution);
    setAccessibleName(this.#next, texts.nextExecution);
    this.#toggle.title = texts.hint;
    for (const [button, text, key] of [
      [this.#playBlock, texts.playBlock, 'F10'],
      [this.#toCursor, texts.toCursor, 'Ctrl F10'],
      [this.#breakpoint, texts.breakpoint, 'Ctrl F8'],
    ] as const) {
      setText(button, text);
      button.title = `${text} (${key})`;
    }
    // The language is first set after all panels are made, so the services of other panels exist.
    if (!this.#hasNavigation) {
      this.#header.append(this.#shell.service('outlineButton')());
      this.#state.after(this.#shell.service('usesSection')());
    }
    this.#hasNavigation = true;
    if (this.#shown === undefined) this.#clear();
    this.#ask();
  }

  onCursorMoved(): void {
    this.#hasFocusedText = true;
    this.#chosenExecution = undefined;
    this.#showInsert();
    this.#ask();
  }

  get capturesKeys(): boolean {
    return this.#chooser?.isOpen === true;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report') this.#showInsert();
    if (event.kind === 'report' || event.kind === 'parts-loaded') {
      this.#cannotAnswer = false;
      this.#ask();
    } else if (event.kind === 'part-failed') this.onRunFailed();
  }

  onRunStarted(): void {
    this.#cannotAnswer = false;
  }

  onRunFailed(): void {
    this.#cannotAnswer = true;
    if (this.#pendingTimer === undefined) return;
    this.#cancelPending();
    this.#shown = undefined;
    this.#clear();
  }

  onInputChanged(): void {
    this.#showInsert();
    this.#question.cancel();
    this.#cancelPending();
    this.#setMark(undefined);
  }

  onWorkerLost(): void {
    this.#cannotAnswer = true;
    this.#question.cancel();
    this.#cancelPending();
    this.#shown = undefined;
    this.#clear();
  }

  onKey(key: Key): 'handled' | 'ignored' {
    const { event } = key;
    if (event.key !== 'F1' || event.ctrlKey || event.altKey || event.metaKey || !isInProgram(key, this.#shell))
      return 'ignored';
    this.#hasFocusedText = true;
    this.#announceNext = true;
    this.#setOpen(true);
    return 'handled';
  }

  #setOpen(open: boolean): void {
    this.#body.hidden = !open;
    this.#toggle.setAttribute('aria-expanded', String(open));
    this.#justOpened = open;
    this.#ask();
  }

  #ask(): void {
    if (!this.#hasFocusedText) return;
    const [offset, time] = [this.#offset, this.#chosenExecution];
    if (!this.#cannotAnswer) this.#pendingTimer ??= setTimeout(() => this.#showPending(), PENDING_AFTER_MS);
    this.#question.ask(
      this.#body.hidden ? { by: 'cursor', about: 'word', offset } : { by: 'cursor', about: 'block', offset, time },
    );
  }

  get #isInBlankLine(): boolean {
    const { editor, readonly } = this.#shell;
    const { from, to } = editor.selection;
    return !readonly && from === to && editor.isBlankLine(from);
  }

  #showInsert(): void {
    this.#insert.hidden = !this.#isInBlankLine;
  }

  async #chooseCycle(): Promise<void> {
    const part = await loadPart(
      this.#shell,
      () => import('./cycle-chooser'),
      () => void this.#chooseCycle(),
    );
    if (part === undefined) return;
    this.#chooser ??= new part.CycleChooser(this.#shell);
    await this.#chooser.open((chosen) => {
      this.#hasFocusedText = true;
      this.#shell.editor.insertProposal(chosen).catch(() => undefined);
    });
  }

  /** The offset of the cursor, or of the start of the selection. */
  get #offset(): number {
    const { editor } = this.#shell;
    const { from, to } = editor.selection;
    return from === to ? editor.cursor : from;
  }

  /** Shows the previous or next execution of the block. */
  #chooseExecution(step: -1 | 1): void {
    const state = this.#shown?.state;
    if (state === undefined) return;
    this.#chosenExecution = Math.min(Math.max(state.number + step, 1), state.times);
    this.#ask();
  }

  /** Shows that the content is for another place or another execution, and that the answer is pending. */
  #showPending(): void {
    this.#element.setAttribute('aria-busy', 'true');
    setText(this.#line, WORDS[this.#shell.language].pending);
    this.#renderedKeys.delete(this.#line);
  }

  #cancelPending(): void {
    clearTimeout(this.#pendingTimer);
    this.#pendingTimer = undefined;
    this.#element.removeAttribute('aria-busy');
  }

  #onAnswer(help: Help | undefined): void {
    if (help === undefined) return;
    this.#cancelPending();
    this.#shown = help;
    const texts = WORDS[this.#shell.language];
    const { word, form, state } = help;
    // Re-render only changed sections, so that focus and hover survive a re-run.
    const hasChanged = (part: HTMLElement, content: unknown): boolean => {
      const key = JSON.stringify([this.#shell.language, content]);
      const before = this.#renderedKeys.get(part);
      this.#renderedKeys.set(part, key);
      return key !== before;
    };
    if (hasChanged(this.#line, word)) {
      const reason = word?.facts[0]?.text;
      this.#line.replaceChildren(
        word === undefined ? texts.nothing : wordLine(word),
        ...(reason === undefined ? [] : [' ', make('span', { className: 'word-reason' }, ...renderUnbroken(reason))]),
      );
    }
    if (hasChanged(this.#facts, word))
      this.#facts.replaceChildren(
        ...(word === undefined
          ? []
          : [factList(word.facts, (offset) => this.#goTo(offset)), ...this.#renderCalculators(word.calculators)]),
      );
    if (hasChanged(this.#form, form)) this.#form.replaceChildren(...(form === undefined ? [] : this.#renderForm(form)));
    if (state !== undefined && hasChanged(this.#state, state)) this.#showState(state);
    this.#setMark(word?.marks[0]);
    if (this.#justOpened) {
      this.#justOpened = false;
      this.#shell.editor.scrollToCursor();
    }
    // An answer to an earlier question is shown, but not announced.
    if (!this.#announceNext || help.request.about === 'motion' || help.request.offset !== this.#offset) return;
    this.#announceNext = false;
    const announcement =
      word === undefined
        ? [texts.nothing]
        : [`${[word.word, word.title, word.value ?? ''].join(' ').trim()}.`, ...word.facts.map(({ text }) => text)];
    this.#shell.editor.announce([...announcement, state?.explanation ?? ''].join(' ').trim());
  }

  /** No answer: the line shows a hint. */
  #clear(): void {
    this.#renderedKeys.clear();
    setText(this.#line, WORDS[this.#shell.language].empty);
    this.#facts.replaceChildren();
    this.#form.replaceChildren();
    this.#executions.hidden = true;
    this.#state.replaceChildren();
  }

  /** A button for each calculator that fits the word. */
  #renderCalculators(calculators: readonly CalculatorName[]): HTMLElement[] {
    if (calculators.length === 0) return [];
    const buttons = calculators.map(({ name, title }) => {
      const button = make('button', { type: 'button', className: 'framed', 'aria-haspopup': 'dialog' }, `${title}…`);
      button.addEventListener('click', () => this.#shell.service('openCalculator')(name));
      return button;
    });
    return [make('div', { className: 'word-calculators' }, ...buttons)];
  }

  /** The form of the block: its words in a row, and under it the missing and the omitted ones. */
  #renderForm(form: FormHelp): HTMLElement[] {
    const texts = WORDS[this.#shell.language];
    const rows = form.lines.map((line) =>
      make('p', { className: line.own ? 'form-line own' : 'form-line', lang: 'en' }, ...this.#renderFormWords(line)),
    );
    const ownLines = form.lines.filter((line) => line.own);
    const own = ownLines.flatMap(({ words }) => words);
    const link = codeLink(ownLines[0]?.inManual ?? '', this.#shell.language);
    const missing = own
      .filter((word) => word.state !== 'there')
      .sort((a, b) => Number(a.optional) - Number(b.optional));
    const items = missing.map((word) =>
      make(
        'li',
        { className: word.state },
        make('code', { lang: 'en' }, word.letters),
        ` ${texts.open(word.title, word.otherwise)}`,
      ),
    );
    return [
      make('h3', { className: 'at-cursor-heading' }, texts.form),
      ...rows,
      ...(items.length === 0 ? [] : [make('ul', { className: 'word-facts' }, ...items)]),
      ...(link === undefined ? [] : [make('p', {}, link)]),
    ];
  }

  #renderFormWords({ code, words }: FormLine): (HTMLElement | string)[] {
    const shown = ({ letters, title, optional, state, marked }: FormWord): HTMLElement =>
      make(marked ? 'mark' : 'span', { className: `form-word ${state}`, title }, optional ? `[${letters}]` : letters);
    return [make('b', {}, code), ...words.flatMap((word) => [' ', shown(word)])];
  }

  #setMark(marks: readonly [number, number] | undefined): void {
    if (marks === undefined && !this.#hasMark) return;
    this.#hasMark = marks !== undefined;
    this.#shell.editor.hovered = marks === undefined ? undefined : { from: marks[0], to: marks[1] };
  }

  #showState(state: StateHelp): void {
    const texts = WORDS[this.#shell.language];
    this.#executions.hidden = state.times < 2;
    this.#previous.disabled = state.number <= 1;
    this.#next.disabled = state.number >= state.times;
    setText(this.#executionText, texts.execution(state.number, state.times));
    if (state.number === 0) {
      this.#state.replaceChildren(make('p', {}, texts.never(state.line)));
      return;
    }
    const parts = [
      ...[state.purpose, state.explanation]
        .filter((text): text is string => text !== undefined && text !== '')
        .map((text) => make('p', {}, ...renderUnbroken(text))),
      this.#renderTable(texts.state(state.line), [...state.axes, ...state.rows], state.speeds),
      ...(state.variables.length === 0 ? [] : [this.#renderTable(texts.variables, state.variables)]),
      ...(state.hidden === 0 ? [] : [make('p', {}, texts.hidden(state.hidden))]),
      ...(state.frames.length === 0
        ? []
        : [make('p', { className: 'at-cursor-heading' }, texts.frames), this.#renderFrames(state.frames)]),
    ];
    setChildren(this.#state, parts);
  }

  #renderTable(caption: string, rows: readonly StateRow[], speeds?: string): HTMLTableElement {
    const texts = WORDS[this.#shell.language];
    const heading = (text: string): HTMLElement => make('th', { scope: 'col' }, text);
    const head = make('tr', {}, heading(''), heading(texts.before), heading(texts.after), heading(texts.since));
    const lines = rows.map((row) => this.#renderRow(row));
    if (speeds !== undefined)
      lines.push(
        make('tr', {}, make('th', { scope: 'row' }, texts.speeds), make('td', { colSpan: 2 }, speeds), make('td')),
      );
    return make(
      'table',
      { className: 'state-table' },
      make('caption', {}, caption),
      make('thead', {}, head),
      make('tbody', {}, ...lines),
    );
  }

  #renderRow({ name, before, after, changed, line, at, variable }: StateRow): HTMLTableRowElement {
    const texts = WORDS[this.#shell.language];
    const where = make('td', { className: 'since' });
    if (line !== undefined && at !== undefined) {
      const button = make('button', { type: 'button', className: 'link', title: texts.toLine(line) }, String(line));
      button.setAttribute('aria-label', texts.toLine(line));
      button.addEventListener('click', () => this.#goTo(at));
      where.append(button);
    }
    const cells = changed
      ? [make('td', {}, before), make('td', { className: 'changed' }, make('strong', {}, after))]
      : [make('td', { colSpan: 2 }, after)];
    // A block that a cycle only reads is not executed, so no variable can be set before it.
    const state = this.#shown?.state;
    if (variable !== undefined && state !== undefined && state.execution > 0)
      cells.at(-1)?.append(' ', this.#tryButton(name, variable, state));
    return make('tr', { className: changed ? 'changed' : '' }, make('th', { scope: 'row' }, name), ...cells, where);
  }

  /** The button to try another value of a variable: a field replaces it. */
  #tryButton(name: string, variable: number, { block, execution }: StateHelp): HTMLElement {
    const texts = WORDS[this.#shell.language];
    const button = make(
      'button',
      { type: 'button', className: 'try-value', title: texts.tryHint(name) },
      texts.tryValue,
    );
    button.setAttribute('aria-label', `${texts.tryValue} ${texts.tryHint(name)}`);
    button.addEventListener('click', () => {
      const field = make('input', {
        type: 'text',
        inputMode: 'decimal',
        className: 'tried-field',
        size: 8,
        autocomplete: 'off',
        'aria-label': texts.tryHint(name),
      });
      const end = (): void => {
        if (!field.isConnected) return;
        field.replaceWith(button);
        button.focus();
      };
      field.addEventListener('keydown', (event) => {
        if (event.key === 'Escape') end();
        else if (event.key === 'Enter') {
          const value = numberIn(field.value);
          field.setAttribute('aria-invalid', String(value === undefined));
          if (value === undefined) return;
          end();
          // The table is usually rendered again soon, and its buttons are replaced.
          this.#toggle.focus({ preventScroll: true });
          this.#shell.editor.tryValue({ at: block, time: execution, variable, value });
        } else return;
        event.preventDefault();
        event.stopPropagation();
      });
      button.replaceWith(field);
      field.focus();
    });
    return button;
  }

  #renderFrames(frames: readonly HelpLine[]): HTMLElement {
    return factList(frames, (offset) => this.#goTo(offset));
  }

  /** Selects the block at an offset. */
  #goTo(offset: number): void {
    this.#shell.goTo({ from: offset, to: this.#shell.editor.endOfLine(offset) });
  }
}

/** A number as the user types it, with a point or a comma. */
function numberIn(text: string): number | undefined {
  const typed = text.trim().replace(',', '.');
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(typed) ? Number(typed) : undefined;
}

const WORDS = words({
  en: {
    atCursor: 'At the cursor',
    hint: 'Meaning of the word at the cursor, and the codes in force there (F1)',
    completion: 'Propose words while typing (Ctrl Space asks for them)',
    playBlock: 'Play this block',
    toCursor: 'Play to here',
    breakpoint: 'Stop here',
    insert: 'Insert cycle…',
    empty: 'Change a number: the picture follows. Point at a word to read what it means.',
    nothing: 'no word',
    pending: 'the program is being run again …',
    form: 'Form of the block',
    open: (title: string, what: string) => `${title}. ${what}`,
    state: (line: number) => `The control before and after line ${line}`,
    before: 'Before',
    after: 'After',
    since: 'Line',
    speeds: 'Spindle after the block',
    variables: 'Variables',
    tryValue: 'what if …',
    tryHint: (name: string) => `Try another value for ${name} from here on`,
    hidden: (count: number) => `${count} more variables`,
    frames: 'Calls and loops',
    execution: (number: number, times: number) => `time ${number} of ${times}`,
    previousExecution: 'The time before',
    nextExecution: 'The next time',
    never: (line: number) => `Line ${line} is not carried out.`,
    toLine: (line: number) => `To line ${line}`,
  },
  zh: {
    atCursor: '光标处',
    hint: '光标处的字的含义，以及此处有效的指令（F1）',
    completion: '输入时给出建议（Ctrl 空格随时可用）',
    playBlock: '播放本段',
    toCursor: '播放到此处',
    breakpoint: '在此停下',
    insert: '插入循环…',
    empty: '修改一个数，图形随之变化。把指针放在字上，可看到它的含义。',
    nothing: '没有字',
    pending: '正在重新执行程序……',
    form: '本程序段的格式',
    open: (title, what) => `${title}。${what}`,
    state: (line) => `第 ${line} 行之前与之后的系统状态`,
    before: '之前',
    after: '之后',
    since: '行',
    speeds: '本段之后的主轴',
    variables: '变量',
    tryValue: '假如……',
    tryHint: (name) => `从此处起为 ${name} 试用另一个值`,
    hidden: (count) => `另有 ${count} 个变量`,
    frames: '调用与循环',
    execution: (number, times) => `第 ${number} 次，共 ${times} 次`,
    previousExecution: '上一次',
    nextExecution: '下一次',
    never: (line) => `第 ${line} 行不会执行。`,
    toLine: (line) => `转到第 ${line} 行`,
  },
  ru: {
    atCursor: 'У курсора',
    hint: 'Значение слова у курсора и действующие здесь коды (F1)',
    completion: 'Предлагать слова при вводе (по запросу – Ctrl Пробел)',
    playBlock: 'Показать кадр',
    toCursor: 'Показать до него',
    breakpoint: 'Пауза здесь',
    insert: 'Вставить цикл…',
    empty: 'Измените число — рисунок последует за ним. Смысл слова — под указателем.',
    nothing: 'слова нет',
    pending: 'программа выполняется ещё раз …',
    form: 'Форма кадра',
    open: (title, what) => `${title}. ${what}`,
    state: (line) => `Система ЧПУ до и после строки ${line}`,
    before: 'До',
    after: 'После',
    since: 'Строка',
    speeds: 'Шпиндель после кадра',
    variables: 'Переменные',
    tryValue: 'что если …',
    tryHint: (name) => `Попробовать другое значение ${name} с этого места`,
    hidden: (count) => `Ещё переменных: ${count}`,
    frames: 'Вызовы и циклы',
    execution: (number, times) => `раз ${number} из ${times}`,
    previousExecution: 'Предыдущий раз',
    nextExecution: 'Следующий раз',
    never: (line) => `Строка ${line} не выполняется.`,
    toLine: (line) => `К строке ${line}`,
  },
});
