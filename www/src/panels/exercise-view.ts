// An exercise: the task with its drawing, hints on request, and the report on the learner's program.
//
// In: the address of an exercise file, or its text; the answers of the worker, in the language of the element. Out: the first program
// and the setup of the exercise; the events `gcode-exercise`, when the task is shown, and `gcode-checked`, after each
// check. Loaded when it is first shown. Must not know: how a part is measured.

import { make, renderUnbroken } from '../dom/dom';
import { loadText } from '../dom/load-text';
import { COMMON, words } from '../dom/words';
import { programText } from '../editor/program-text';
import { chapterLink } from '../editor/rule-link';
import type { ExerciseText, Graded } from '../protocol/protocol';
import { formOf, type ExerciseForm } from './exercise-form';
import type { Place, Shell } from './panel';
import exerciseStyles from './exercise-view.css?inline';

export { exerciseStyles };

/** The longest exercise file, characters, as the interpreter reads it. */
const MAX_LENGTH = 65_536;

/** Space above the report, CSS pixels. */
const REPORT_MARGIN_PX = 8;

/** The detail of the event `gcode-exercise`. */
export interface ExerciseDetail {
  readonly id: string;
  /** The checksum of the exercise file. */
  readonly version: string;
  /** In the language of the element. */
  readonly title: string;
  /** The program that the learner begins with. */
  readonly program: string;
}

/** The detail of the event `gcode-checked`. */
export interface CheckedDetail {
  readonly id: string;
  /** The checksum of the exercise file. */
  readonly version: string;
  readonly passed: boolean;
  /** Number of hints that the learner has opened. */
  readonly hints: number;
  readonly checks: readonly { readonly name: string; readonly passed: boolean }[];
}

export class ExerciseView {
  readonly element: HTMLElement;
  readonly #shell: Shell;
  readonly #address: string;
  readonly #title = make('h3', { className: 'exercise-title' });
  readonly #task = make('div', { className: 'exercise-task' });
  readonly #drawing = make('img', { className: 'exercise-drawing', alt: '', hidden: true });
  readonly #formPlace = make('div');
  readonly #hints = make('ol', { className: 'exercise-hints' });
  readonly #checkButton = make('button', { type: 'button', className: 'primary' });
  readonly #hintButton = make('button', { type: 'button' });
  readonly #printButton = make('button', { type: 'button' });
  readonly #chapter = make('span');
  readonly #report = make('div', { className: 'exercise-report', 'aria-live': 'polite' });
  #text = '';
  #exercise: ExerciseText | undefined;
  #form: ExerciseForm | undefined;
  /** The program that the learner begins with, once it is in the editor. */
  #begin: string | undefined;
  #shownHints = 0;
  /** Number of the check, so that a late report on an earlier program is dropped. */
  #check = 0;

  constructor(shell: Shell, address: string) {
    this.#shell = shell;
    this.#address = address;
    this.#checkButton.addEventListener('click', () => void this.check());
    this.#hintButton.addEventListener('click', () => this.#showNextHint());
    this.#printButton.hidden = !shell.hasService('printTask');
    this.#printButton.addEventListener('click', () => shell.service('printTask')());
    this.element = make(
      'section',
      { className: 'exercise-view' },
      this.#title,
      make('div', { className: 'exercise-text' }, this.#task, this.#drawing),
      this.#formPlace,
      this.#hints,
      this.#report,
      make(
        'div',
        { className: 'exercise-buttons' },
        this.#checkButton,
        this.#hintButton,
        this.#printButton,
        this.#chapter,
        make('slot', { name: 'exercise' }),
      ),
    );
  }

  /** Loads the file and shows the exercise; a program that the host page has set stays. */
  async start(): Promise<void> {
    const texts = WORDS[this.#shell.language];
    const text = await load(this.#address);
    if (text === undefined) return this.#showFault(texts.notLoaded);
    this.#text = text;
    await this.reload();
    const exercise = this.#exercise;
    if (exercise === undefined) return;
    const hasJson = exercise.setup.trimStart().startsWith('{');
    const plain = hasJson ? exercise.program : `${exercise.setup.trim()}\n${exercise.program}`;
    const begin = this.#form?.begin ?? plain;
    if (this.#shell.editor.text.trim() === '' && begin !== '')
      this.#shell.replaceProgram(programText(begin), undefined, 'same');
    if (hasJson) this.#shell.changeSetup(exercise.setup);
    this.#begin = begin;
    // The new program scrolls to its cursor, which may be below the task.
    requestAnimationFrame(() => scrollerOf(this.element)?.scrollTo(0, 0));
    this.#reportExercise(exercise, begin);
  }

  /** Shows the exercise in the language of the element. */
  async reload(): Promise<void> {
    const answer = await this.#shell.ask('exercise', { text: this.#text });
    if (answer === undefined) return;
    const { read, drawing } = answer;
    const texts = WORDS[this.#shell.language];
    if (read.kind === 'fault') return this.#showFault(texts.fault(read.line, read.message));
    this.#exercise = read;
    // The sizes of the drawing are the answers to a prediction.
    this.#render(read, read.taskKind === 'predict' ? undefined : drawing);
    if (this.#begin !== undefined) this.#reportExercise(read, this.#begin);
  }

  #reportExercise({ id, version, title }: ExerciseText, program: string): void {
    this.#fire<ExerciseDetail>('gcode-exercise', { id, version, title, program });
  }

  #fire<Detail>(type: string, detail: Detail): void {
    this.#shell.root.host.dispatchEvent(new CustomEvent(type, { detail, bubbles: true, composed: true }));
  }

  /** Title, task and drawing for a printed sheet. */
  get sheet(): readonly HTMLElement[] {
    if (this.#exercise === undefined) return [];
    const title = make('h1', {}, this.#exercise.title);
    return [title, ...[this.#task, this.#drawing].map((part) => part.cloneNode(true) as HTMLElement)];
  }

  /** A click in the section. Returns whether it is a part of the answer. */
  answerAt(place: Place): boolean {
    return this.#form?.takePlace(place) ?? false;
  }

  /** The report is about an earlier program. */
  programChanged(): void {
    this.#form?.update();
    this.#check++;
    this.#report.classList.add('is-outdated');
  }

  #showFault(message: string): void {
    this.#report.replaceChildren(make('p', { className: 'exercise-fault' }, message));
    this.#checkButton.hidden = this.#hintButton.hidden = this.#printButton.hidden = true;
  }

  #render(exercise: ExerciseText, drawing: string | undefined): void {
    const texts = WORDS[this.#shell.language];
    this.#title.textContent = exercise.title;
    this.#task.replaceChildren(...blocks(exercise.task));
    this.#checkButton.textContent = texts.check;
    this.#printButton.textContent = texts.printTask;
    const { chapter } = exercise;
    this.#chapter.replaceChildren(...(chapter === undefined ? [] : [chapterLink(chapter, this.#shell.language)]));
    this.#setDrawing(drawing);
    this.#form = formOf(exercise, this.#shell);
    this.#formPlace.replaceChildren(...(this.#form === undefined ? [] : [this.#form.element]));
    this.#form?.update();
    this.#renderHints(exercise);
  }

  #setDrawing(svg: string | undefined): void {
    URL.revokeObjectURL(this.#drawing.src);
    this.#drawing.hidden = svg === undefined;
    this.#drawing.alt = WORDS[this.#shell.language].drawing;
    if (svg !== undefined) this.#drawing.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  }

  #renderHints({ hints }: ExerciseText): void {
    this.#hints.replaceChildren(...hints.slice(0, this.#shownHints).map((hint) => make('li', {}, ...inline(hint))));
    this.#hintButton.hidden = this.#shownHints >= hints.length;
    this.#hintButton.textContent = WORDS[this.#shell.language].hint(this.#shownHints + 1, hints.length);
  }

  #showNextHint(): void {
    if (this.#exercise === undefined) return;
    this.#shownHints++;
    this.#renderHints(this.#exercise);
    this.#hints.lastElementChild?.scrollIntoView({ block: 'nearest' });
  }

  /** Checks the program, and shows the report. */
  async check(): Promise<void> {
    this.#shell.flush();
    const check = ++this.#check;
    const report = await this.#shell.ask('check-exercise', { text: this.#text });
    if (report === undefined || check !== this.#check) return;
    this.#showReport(report);
    this.#fire<CheckedDetail>('gcode-checked', {
      id: this.#exercise?.id ?? '',
      version: this.#exercise?.version ?? '',
      passed: report.passed,
      hints: this.#shownHints,
      checks: report.checks.map(({ check, passed }) => ({ name: check, passed })),
    });
  }

  #showReport(report: Graded): void {
    const texts = WORDS[this.#shell.language];
    this.#report.classList.remove('is-outdated');
    const className = report.passed ? 'exercise-verdict passed' : 'exercise-verdict';
    const { cause } = report;
    this.#report.replaceChildren(
      make('p', { className }, report.passed ? texts.passed : texts.failed),
      ...(cause === undefined
        ? []
        : [make('p', { className: 'exercise-cause' }, cause.text, ...this.#lineButton(cause.line))]),
      this.#checkList(report),
      ...(report.sizes.length === 0 ? [] : [measuringReport(report.sizes, texts)]),
    );
    // The host page may change the row of buttons.
    requestAnimationFrame(() => this.#scrollToReport());
  }

  /** Not `scrollIntoView`, which would also move the page around the element. */
  #scrollToReport(): void {
    const scroller = scrollerOf(this.element);
    const top = this.#report.getBoundingClientRect().top - REPORT_MARGIN_PX;
    scroller?.scrollBy(0, top - scroller.getBoundingClientRect().top);
  }

  /** The part and the checks, failed ones first; after an alarm, the part only follows from it. */
  #checkList({ part, samePart, line, checks, errors }: Graded): HTMLElement {
    const texts = WORDS[this.#shell.language];
    const ofChecks = checks.map(({ check, passed, found, line }) => ({
      passed,
      text: [found === '' ? check : texts.found(check, found)],
      line,
    }));
    const ofPart = { passed: samePart, text: renderUnbroken(part), line };
    // The part of a prediction is that of the exercise, which the learner does not change.
    const isPrediction = this.#exercise?.taskKind === 'predict';
    const rows = isPrediction ? ofChecks : errors > 0 ? [...ofChecks, ofPart] : [ofPart, ...ofChecks];
    const sorted = [...rows.filter(({ passed }) => !passed), ...rows.filter(({ passed }) => passed)];
    return make(
      'ul',
      { className: 'exercise-checks' },
      ...sorted.map(({ passed, text, line }) =>
        make(
          'li',
          { className: passed ? 'passed' : 'failed' },
          make('span', { className: 'exercise-mark' }, passed ? texts.passed : texts.failed),
          ...text,
          ...this.#lineButton(passed ? undefined : line),
        ),
      ),
    );
  }

  /** A button that selects a line of the program, after a blank. */
  #lineButton(line: number | undefined): (HTMLElement | string)[] {
    if (line === undefined) return [];
    const button = make('button', { type: 'button', className: 'link' }, COMMON[this.#shell.language].line(line));
    button.addEventListener('click', () => this.#shell.goTo(spanOf(this.#shell.editor.text, line)));
    return [' ', button];
  }
}

/** The element that scrolls the exercise; undefined if all of it is in view. */
function scrollerOf(element: HTMLElement): HTMLElement | undefined {
  for (let at = element.parentElement; at !== null; at = at.parentElement)
    if (at.scrollHeight > at.clientHeight && getComputedStyle(at).overflowY === 'auto') return at;
  return undefined;
}

/** The text of the file; undefined if it cannot be loaded or is too long. A text that begins with `---` is the file itself. */
async function load(address: string): Promise<string | undefined> {
  const text = address.startsWith('---') ? address : await loadText(address);
  return text !== undefined && text.length > MAX_LENGTH ? undefined : text;
}

/** The place of a line, counted from 1. */
function spanOf(text: string, line: number): { readonly from: number; readonly to: number } {
  const before = text
    .split('\n')
    .slice(0, line - 1)
    .join('\n').length;
  const from = line === 1 ? 0 : before + 1;
  const end = text.indexOf('\n', from);
  return { from, to: end === -1 ? text.length : end };
}

type Texts = (typeof WORDS)['en'];

/** Nominal size, actual size, deviation, in or out. */
function measuringReport(sizes: Graded['sizes'], texts: Texts): HTMLElement {
  const head = [texts.size, texts.wanted, texts.actual, texts.deviation, ''];
  const rows = sizes.map((size) => {
    const cells = [
      size.nominal.toFixed(2),
      size.actual?.toFixed(3) ?? '–',
      size.deviation?.toFixed(3) ?? '–',
      size.in ? texts.within : texts.outside,
    ];
    const name = make('th', { scope: 'row' }, `${size.name} ${size.place}`);
    return make('tr', { className: size.in ? '' : 'failed' }, name, ...cells.map((text) => make('td', {}, text)));
  });
  return make(
    'details',
    { className: 'exercise-sizes' },
    make('summary', {}, texts.sizes),
    make(
      'table',
      {},
      make('thead', {}, make('tr', {}, ...head.map((text) => make('th', { scope: 'col' }, text)))),
      make('tbody', {}, ...rows),
    ),
  );
}

/** Paragraphs and lists of the Markdown of a task. */
function blocks(text: string): HTMLElement[] {
  return text
    .split(/\n\s*\n/)
    .filter((block) => block.trim() !== '')
    .flatMap((block) => [...paragraph(block.split(/^(?=\s*(?:[*-]|\d+\.)\s)/m))]);
}

/** A paragraph and the list after it. `pieces`: its text, and the items with their markers. */
function* paragraph(pieces: readonly string[]): Generator<HTMLElement> {
  const marker = /^\s*(?:[*-]|\d+\.)\s+/;
  const items = pieces.filter((piece) => marker.test(piece));
  const before = pieces.filter((piece) => !marker.test(piece)).join('');
  if (before.trim() !== '') yield make('p', {}, ...inline(before.trim()));
  const [first] = items;
  if (first === undefined) return;
  const list = items.map((item) => make('li', {}, ...inline(item.replace(marker, '').trim())));
  yield make(/^\s*\d/.test(first) ? 'ol' : 'ul', {}, ...list);
}

/** Text with `code` between backticks. */
function inline(text: string): (HTMLElement | string)[] {
  return text
    .replace(/\s+/g, ' ')
    .split('`')
    .map((piece, at) => (at % 2 === 1 ? make('code', {}, piece) : piece));
}

const WORDS = words({
  en: {
    check: 'Check',
    printTask: 'Print the task',
    hint: (next: number, all: number) => `Hint ${next} of ${all}`,
    drawing: 'Drawing of the part',
    passed: 'Passed',
    failed: 'Not passed',
    found: (check: string, found: string) => `${check}: ${found}`,
    sizes: 'Measuring report',
    size: 'Size',
    wanted: 'Wanted',
    actual: 'Actual',
    deviation: 'Deviation',
    within: 'in',
    outside: 'out',
    notLoaded: 'The exercise could not be loaded.',
    fault: (line: number, message: string) => `The exercise file has a fault in line ${line}: ${message}`,
  },
  zh: {
    check: '检查',
    printTask: '打印题目',
    hint: (next, all) => `提示 ${next}/${all}`,
    drawing: '零件图',
    passed: '通过',
    failed: '未通过',
    found: (check, found) => `${check}：${found}`,
    sizes: '测量报告',
    size: '尺寸',
    wanted: '要求',
    actual: '实际',
    deviation: '偏差',
    within: '合格',
    outside: '超差',
    notLoaded: '练习加载失败。',
    fault: (line, message) => `练习文件第 ${line} 行有错误：${message}`,
  },
  ru: {
    check: 'Проверить',
    printTask: 'Напечатать задание',
    hint: (next, all) => `Подсказка ${next} из ${all}`,
    drawing: 'Чертёж детали',
    passed: 'Выполнено',
    failed: 'Не выполнено',
    found: (check, found) => `${check}: ${found}`,
    sizes: 'Протокол измерений',
    size: 'Размер',
    wanted: 'Требуется',
    actual: 'Факт',
    deviation: 'Отклонение',
    within: 'в допуске',
    outside: 'вне допуска',
    notLoaded: 'Упражнение не удалось загрузить.',
    fault: (line, message) => `В файле упражнения ошибка в строке ${line}: ${message}`,
  },
});
