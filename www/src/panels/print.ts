// Printing: program, drawing, problems and setup below each other, in light colours; before them the exercise, or the
// exercise alone with an empty form. Page breaks fall between blocks, not inside them.
//
// In: the newest report; Ctrl P. Out: a sheet that is visible only in print. If the user prints from the browser's
// menu, nothing can be requested before: the sheet has no setup, and the drawing of the screen is printed.

import { make, renderProse } from '../dom/dom';
import type { Language } from '../dom/language';
import { isPrinting } from '../dom/printing';
import { COMMON, words } from '../dom/words';
import { programName } from '../editor/program-files';
import type { Diagnostic, SetupForm, SetupState } from '../protocol/protocol';
import type { Key, Panel, PanelKind, Services, Shell } from './panel';
import printStyles from './print.css?inline';

/**
 * Groups whose assumed values are printed, too, because the operator needs them: to clamp the blank and to move the
 * tool to the start.
 */
const WITH_ASSUMED: readonly string[] = ['stock', 'start'];

/** Maximum number of lines of the program that are printed. */
const MAX_LINES = 5_000;

/** Number of rows of the empty form for a program. */
const FORM_ROWS = 20;

/** Maximum number of problems that are printed. */
const MAX_PROBLEMS = 500;

export const print: PanelKind = { styles: printStyles, make: (shell) => new Print(shell) };

class Print implements Panel {
  readonly #shell: Shell;
  readonly #sheet = make('div', { className: 'sheet' });
  readonly #picture = make('img', { className: 'sheet-drawing', alt: '' });
  /** The answers requested before printing began; undefined if printing was started from the browser's menu. */
  #prepared: { readonly setup: SetupForm | undefined; readonly states: readonly SetupState[] } | undefined;
  /** Whether the sheet is the task of the exercise with a form instead of the program. */
  #isTask = false;
  /** The exercise with its decoded drawing; undefined if printing was started from the browser's menu. */
  #preparedExercise: readonly HTMLElement[] | undefined;
  readonly elements = { dialogs: [this.#sheet] };
  readonly services: Partial<Services> = { printTask: () => void this.#printTask() };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.onWorkerConnected();
  }

  onWorkerConnected(): void {
    window.addEventListener('beforeprint', this.#onBeforePrint);
    window.addEventListener('afterprint', this.#onAfterPrint);
    if (isPrinting()) queueMicrotask(this.#onBeforePrint);
  }

  set language(_: Language) {
    // The texts are filled in when the sheet is printed.
  }

  onKey({ event }: Key): 'handled' | 'ignored' {
    if (event.key.toLowerCase() !== 'p' || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey)
      return 'ignored';
    void this.#print();
    return 'handled';
  }

  onDisconnected(): void {
    window.removeEventListener('beforeprint', this.#onBeforePrint);
    window.removeEventListener('afterprint', this.#onAfterPrint);
  }

  /** Requests the setup and the drawing, then prints. */
  async #print(): Promise<void> {
    this.#shell.flush();
    const [setup, drawing] = await Promise.all([
      this.#shell.ask('setup-form', undefined),
      this.#shell.ask('export', { format: 'svg' }),
    ]);
    await this.#prepareExercise();
    if (drawing?.kind === 'file') {
      this.#picture.src = URL.createObjectURL(new Blob([drawing.content], { type: 'image/svg+xml' }));
      await this.#picture.decode().catch(() => undefined);
    }
    const fields = (setup?.groups ?? []).flatMap(({ fields }) => fields);
    const answer =
      setup === undefined
        ? undefined
        : await this.#shell.ask('read-setup', {
            keys: fields.map(({ key }) => key),
            texts: fields.map(({ value }) => value),
            keep: setup.place,
            json: this.#shell.setup ?? '{}',
          });
    this.#prepared = { setup, states: answer?.fields ?? [] };
    window.print();
  }

  /** Prints when the drawing of the task can be shown. */
  async #printTask(): Promise<void> {
    await this.#prepareExercise();
    if (!this.#shell.root.host.isConnected) return;
    this.#isTask = true;
    window.print();
    // The sheet is filled now. Where printing is not allowed, no event follows.
    this.#isTask = false;
  }

  async #prepareExercise(): Promise<void> {
    this.#preparedExercise = undefined;
    const parts = this.#exercise;
    const drawings = parts.flatMap((part) => (part instanceof HTMLImageElement && !part.hidden ? [part] : []));
    await Promise.all(drawings.map((drawing) => drawing.decode().catch(() => undefined)));
    this.#preparedExercise = parts;
  }

  get #exercise(): readonly HTMLElement[] {
    const sheet = (): readonly HTMLElement[] =>
      this.#shell.hasService('exerciseSheet') ? this.#shell.service('exerciseSheet')() : [];
    return this.#preparedExercise ?? sheet();
  }

  readonly #onBeforePrint = (): void => {
    if (this.#isTask) this.#fillTask();
    else this.#fillProgram();
    this.#shell.frame.classList.toggle('has-sheet-drawing', this.#isTask || this.#picture.src !== '');
  };

  /** The task, and a form to write the program by hand. */
  #fillTask(): void {
    const texts = WORDS[this.#shell.language];
    const cells = ['N', texts.block, texts.remark].map((text) => make('th', { scope: 'col' }, text));
    const rows = Array.from({ length: FORM_ROWS }, () => make('tr', {}, ...cells.map(() => make('td'))));
    this.#sheet.replaceChildren(
      make('p', { className: 'sheet-names' }, make('span', {}, texts.name), make('span', {}, texts.date)),
      ...this.#exercise,
      make(
        'table',
        { className: 'sheet-form' },
        make('thead', {}, make('tr', {}, ...cells)),
        make('tbody', {}, ...rows),
      ),
    );
  }

  #fillProgram(): void {
    const { language, editor } = this.#shell;
    const texts = WORDS[language];
    const name = editor.file?.name ?? programName(editor.text);
    const lines = editor.text.split('\n');
    const marked = new Map<number, Diagnostic['severity']>();
    for (const { line, severity } of this.#shell.diagnostics)
      if (marked.get(line) !== 'error') marked.set(line, severity);
    const program = make('ol', { className: 'sheet-program' });
    program.append(
      ...lines
        .slice(0, MAX_LINES)
        .map((text, at) => make('li', { className: marked.get(at + 1) ?? '' }, make('code', {}, text))),
    );
    const more = lines.length - MAX_LINES;
    this.#sheet.replaceChildren(
      ...this.#exercise,
      ...(name === undefined ? [] : [make('h1', {}, name)]),
      ...(this.#picture.src === '' ? [] : [this.#picture]),
      ...this.#problems(texts),
      ...this.#setup(texts),
      make('h2', {}, COMMON[language].program),
      program,
      ...(more > 0 ? [make('p', {}, texts.more(more))] : []),
    );
  }

  readonly #onAfterPrint = (): void => {
    this.#sheet.replaceChildren();
    if (this.#picture.src !== '') URL.revokeObjectURL(this.#picture.src);
    this.#picture.removeAttribute('src');
    this.#prepared = undefined;
    this.#preparedExercise = undefined;
    this.#shell.frame.classList.remove('has-sheet-drawing');
  };

  #problems(texts: (typeof WORDS)['en']): readonly HTMLElement[] {
    if (this.#shell.diagnostics.length === 0) return [];
    const { language } = this.#shell;
    const list = make('ul', { className: 'sheet-problems' });
    list.append(
      ...this.#shell.diagnostics
        .slice(0, MAX_PROBLEMS)
        .map(({ line, code, message, help }) =>
          make(
            'li',
            {},
            make('strong', {}, `${COMMON[language].line(line)} · ${code}: `),
            ...renderProse(message),
            ...(help === undefined ? [] : [' ', ...renderProse(help)]),
          ),
        ),
    );
    const more = this.#shell.diagnostics.length - MAX_PROBLEMS;
    return [make('h2', {}, texts.problems), list, ...(more > 0 ? [make('p', {}, texts.more(more))] : [])];
  }

  /** The given values, and the assumed ones of blank and start; other fields that are not filled in are left out. */
  #setup(texts: (typeof WORDS)['en']): readonly HTMLElement[] {
    const assumed = new Map(this.#prepared?.states.map((state) => [state.key, state.assumed]));
    const groups = (this.#prepared?.setup?.groups ?? []).map(({ group, title, fields }) => ({
      title,
      filled: fields.flatMap(({ key, label, value, unit, choices }) => {
        const usual = WITH_ASSUMED.includes(group) ? (assumed.get(key) ?? '') : '';
        if (value === '' && usual === '') return [];
        const shown = value === '' ? usual : (choices.find((choice) => choice.value === value)?.text ?? value);
        const text = `${label} ${shown}${unit === '' ? '' : ` ${unit}`}`;
        return [value === '' ? texts.assumed(text) : text];
      }),
    }));
    const [length, grip] = ['stock.length', 'stock.grip'].map((key) => {
      const fields = this.#prepared?.setup?.groups.flatMap(({ fields }) => fields);
      return Number(fields?.find((field) => field.key === key)?.value || assumed.get(key) || Number.NaN);
    });
    const out = Number(((length ?? Number.NaN) - (grip ?? Number.NaN)).toFixed(3));
    const rows = groups
      .filter(({ filled }) => filled.length > 0)
      .map(({ title, filled }) => make('li', {}, make('strong', {}, `${title}: `), filled.join(', ')));
    if (out > 0) rows.push(make('li', {}, texts.outOfJaws(out)));
    return rows.length === 0 ? [] : [make('h2', {}, texts.setup), make('ul', { className: 'sheet-setup' }, ...rows)];
  }
}

const WORDS = words({
  en: {
    problems: 'Problems',
    setup: 'Setup',
    more: (n: number) => `… and ${n} more`,
    assumed: (value: string) => `${value} (assumed)`,
    outOfJaws: (mm: number) => `Blank out of the jaws: ${mm} mm`,
    name: 'Name:',
    date: 'Date:',
    block: 'Block',
    remark: 'Remark',
  },
  zh: {
    problems: '问题',
    setup: '毛坯与刀具',
    more: (n) => `……另有 ${n} 项`,
    assumed: (value) => `${value}（假定）`,
    outOfJaws: (mm) => `毛坯伸出卡爪的长度：${mm} mm`,
    name: '姓名：',
    date: '日期：',
    block: '程序段',
    remark: '说明',
  },
  ru: {
    problems: 'Замечания',
    setup: 'Наладка',
    more: (n) => `… и ещё ${n}`,
    assumed: (value) => `${value} (по умолчанию)`,
    outOfJaws: (mm) => `Вылет заготовки из кулачков: ${mm} мм`,
    name: 'Фамилия, имя:',
    date: 'Дата:',
    block: 'Кадр',
    remark: 'Примечание',
  },
});
