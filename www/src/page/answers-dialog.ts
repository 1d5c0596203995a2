// The dialog "Answers of a class": links and files of learners, and one row with the verdict on each.
//
// In: the host; texts and files. Out: a table, sorted and filtered; the same as CSV and as a page to print; links to the
// answers. Nothing is sent. Must not know: how an answer is graded.

import '../dom/dialog.css';
import './share.css';
import './answers.css';
import { Dialog } from '../dom/dialog';
import { make, setChildren, setText } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import { COMMON } from '../dom/words';
import { EMPTY_SHARED, makeLink, NAME_LIMIT } from '../files/shared-link';
import {
  AnswerGrader,
  HEAD_KEYS,
  isSameAnswer,
  MAX_ANSWERS,
  readFiles,
  readLinks,
  withSame,
  type AnswerRow,
  type ChosenExercise,
  type HeadKey,
} from './answers';
import { cellsOf, csvOf, sortKeyOf } from './answers-table';
import { ANSWERS_WORDS } from './answers-words';
import { loadExercise, loadExercises, titleOf } from './exercise-list';
import { field } from './fields';
import type { PageHost } from './page-host';
import { printedPage, printedTable, setFile } from './printed';
import { publishedFile } from './published';

/** The value of the option for the exercises that the links name, and for a file of the teacher. */
const FROM_LINKS = '';
const OWN_FILE = '.file';

interface HeadCell {
  readonly key: HeadKey;
  readonly cell: HTMLElement;
  /** Sorts by the column. */
  readonly button: HTMLElement;
}

let dialog: AnswersDialog | undefined;

export function openAnswers(host: PageHost): void {
  dialog ??= new AnswersDialog();
  void dialog.open(host);
}

class AnswersDialog {
  readonly #exercise = make('select');
  readonly #links = make('textarea', { rows: 4, spellcheck: false, autocomplete: 'off', dir: 'ltr' });
  readonly #filter = make('input', { type: 'search', autocomplete: 'off' });
  readonly #files = make('input', { type: 'file', multiple: true, hidden: true });
  readonly #ownExercise = make('input', { type: 'file', accept: '.md', hidden: true });
  readonly #openOwn = make('button', { type: 'button', className: 'framed' });
  readonly #scorm = make('a', { className: 'framed', hidden: true });
  readonly #openFiles = make('button', { type: 'button', className: 'framed' });
  readonly #clear = make('button', { type: 'button', className: 'framed' });
  readonly #status = make('p', { role: 'status', className: 'answers-status' });
  readonly #headCells = HEAD_KEYS.map((key) => this.#headCell(key));
  readonly #head = make('tr', {}, ...this.#headCells.map(({ cell }) => cell));
  readonly #body = make('tbody');
  readonly #table = make(
    'div',
    { className: 'answers-table', tabIndex: 0, role: 'region', hidden: true },
    make('table', {}, make('thead', {}, this.#head), this.#body),
  );
  readonly #csv = make('a', { className: 'framed', download: 'answers.csv', hidden: true });
  readonly #print = make('a', { className: 'framed', download: 'answers.html', hidden: true });
  readonly #check = make('button', { type: 'button', className: 'primary' });
  readonly #fields = { exercise: field(this.#exercise), links: field(this.#links), filter: field(this.#filter) };
  readonly #dialog = new Dialog(
    'answers',
    [
      make(
        'div',
        { className: 'answers-from' },
        this.#fields.exercise.label,
        this.#openOwn,
        this.#scorm,
        this.#ownExercise,
      ),
      this.#fields.links.label,
      this.#files,
      make('div', { className: 'answers-found' }, this.#status, this.#fields.filter.label),
      this.#table,
    ],
    [this.#clear, this.#csv, this.#print, this.#openFiles, this.#check],
  );
  #host: PageHost | undefined;
  /** As they were read. */
  #answers: readonly AnswerRow[] = [];
  readonly #graded = new Map<AnswerRow, AnswerRow>();
  /** The elements of the rows, by their answers: an unchanged one keeps the focus, and a click that has begun. */
  readonly #rendered = new WeakMap<object, { readonly contents: string; readonly element: HTMLElement }>();
  /** The removed answers, until there are new ones. */
  #cleared: readonly AnswerRow[] = [];
  #shownLanguage: Language | undefined;
  #grader: AnswerGrader | undefined;
  #ownText: string | undefined;
  #sortedBy: { readonly key: HeadKey; readonly isDescending: boolean } | undefined;
  /** Number of requests; an earlier one ends. */
  #requestCount = 0;

  constructor() {
    document.body.append(this.#dialog.element);
    this.#check.addEventListener('click', () => void this.#addLinks());
    this.#openFiles.addEventListener('click', () => this.#files.click());
    this.#openOwn.addEventListener('click', () => this.#ownExercise.click());
    this.#clear.addEventListener('click', () => this.#clearOrUndo());
    this.#filter.addEventListener('input', () => this.#render());
    this.#files.addEventListener('change', () => {
      const files = [...(this.#files.files ?? [])];
      this.#files.value = '';
      void this.#add(() => readFiles(files));
    });
    this.#ownExercise.addEventListener('change', () => void this.#readOwnExercise());
    this.#exercise.addEventListener('change', () => {
      void this.#packExercise();
      void this.#gradeAgain();
    });
    acceptFiles(this.#dialog.element, {
      hint: () => ANSWERS_WORDS[this.#language].dropHere,
      onDrop: (...files) => void this.#add(() => readFiles(files)),
    });
  }

  get #language(): Language {
    return this.#host?.language ?? 'en';
  }

  async open(host: PageHost): Promise<void> {
    this.#host = host;
    const { language } = host;
    const isOtherLanguage = this.#shownLanguage !== undefined && language !== this.#shownLanguage;
    this.#shownLanguage = language;
    const texts = ANSWERS_WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    for (const [part, text] of [
      [this.#fields.exercise.caption, texts.exercise],
      [this.#fields.links.caption, texts.links],
      [this.#fields.filter.caption, texts.filter],
      [this.#openOwn, texts.openExercise],
      [this.#scorm, texts.scorm],
      [this.#openFiles, texts.openFiles],
      [this.#csv, texts.csv],
      [this.#print, texts.print],
      [this.#check, texts.check],
    ] as const)
      part.textContent = text;
    this.#links.placeholder = texts.linksHint;
    this.#table.setAttribute('aria-label', texts.title);
    this.#render();
    this.#dialog.show();
    this.#links.focus();
    await this.#fillExercises(language);
    if (isOtherLanguage) await this.#gradeAgain();
  }

  async #fillExercises(language: Language, chosen = this.#exercise.value): Promise<void> {
    const texts = ANSWERS_WORDS[language];
    const list = (await loadExercises()) ?? [];
    const own = this.#ownText === undefined ? [] : [make('option', { value: OWN_FILE }, texts.ownExercise)];
    this.#exercise.replaceChildren(
      make('option', { value: FROM_LINKS }, texts.fromLinks),
      ...own,
      ...list.map((row) => make('option', { value: row.id }, titleOf(row, language))),
    );
    this.#exercise.value = chosen;
    await this.#packExercise();
  }

  async #readOwnExercise(): Promise<void> {
    const file = this.#ownExercise.files?.[0];
    this.#ownExercise.value = '';
    if (file === undefined) return;
    this.#ownText = await file.text().catch(() => undefined);
    await this.#fillExercises(this.#language, this.#ownText === undefined ? this.#exercise.value : OWN_FILE);
    await this.#gradeAgain();
  }

  /** Makes the package of the chosen exercise for a learning platform. */
  async #packExercise(): Promise<void> {
    const host = this.#host;
    const chosen = this.#exercise.value;
    this.#scorm.hidden = true;
    const text = (await this.#chosenExercise())?.text;
    if (host === undefined || text === undefined) return;
    const answer = await host.playground.ask('exercise', { text }).catch(() => undefined);
    if (answer === undefined || chosen !== this.#exercise.value) return;
    const { read } = answer;
    if (read.kind === 'fault') {
      this.#status.textContent = ANSWERS_WORDS[host.language].fault({
        kind: 'faulty-exercise',
        line: read.line,
        message: read.message,
      });
      return;
    }
    const { scormPackage } = await importWithRetry(() => import('./scorm'));
    const { id, title } = read;
    this.#scorm.download = `${id}.zip`;
    const packed = scormPackage({ id, title, text, language: host.language }, publishedFile('sco.js'));
    setFile(this.#scorm, packed, 'application/zip');
    this.#scorm.hidden = false;
  }

  async #addLinks(): Promise<void> {
    const text = this.#links.value;
    if (text.trim() === '') return;
    const isRead = await this.#add(() => readLinks(text));
    if (isRead) this.#links.value = '';
  }

  /** Adds answers, except those that the table has, and grades them. Returns whether there were any. */
  async #add(read: () => Promise<AnswerRow[]>): Promise<boolean> {
    const texts = ANSWERS_WORDS[this.#language];
    const found = (await read().catch(() => undefined)) ?? [];
    const isNew = (row: AnswerRow, at: number): boolean =>
      ![...this.#answers, ...found.slice(0, at)].some((other) => isSameAnswer(row, other));
    const added = found.filter(isNew);
    const fitting = added.slice(0, MAX_ANSWERS - this.#answers.length);
    if (fitting.length === 0) {
      const isFull = added.length > 0;
      this.#status.textContent = isFull ? texts.tooMany(MAX_ANSWERS) : found.length > 0 ? texts.known : texts.none;
      return found.length > 0 && !isFull;
    }
    this.#cleared = [];
    this.#answers = [...this.#answers, ...fitting];
    await this.#grade();
    if (fitting.length < added.length) this.#status.append(` ${texts.tooMany(MAX_ANSWERS)}`);
    return true;
  }

  /** Grades the answers that have no row, one after the other. */
  async #grade(): Promise<void> {
    const host = this.#host;
    if (host === undefined) return;
    const request = ++this.#requestCount;
    const texts = ANSWERS_WORDS[this.#language];
    const chosen = await this.#chosenExercise();
    this.#grader ??= new AnswerGrader((text, answer) => host.playground.ask('grade-answer', { text, answer }));
    const waiting = this.#answers.filter((answer) => !this.#graded.has(answer));
    for (const [done, answer] of waiting.entries()) {
      if (request !== this.#requestCount) return;
      this.#status.textContent = texts.checking(done + 1, waiting.length);
      const row = await withLink(await this.#grader.grade(answer, chosen));
      if (request !== this.#requestCount) return;
      this.#graded.set(answer, row);
      this.#renderTable();
    }
    if (request !== this.#requestCount) return;
    this.#render();
    const passed = this.#rows.filter(({ graded }) => graded?.report.passed === true).length;
    this.#status.textContent = texts.summary(passed, this.#rows.length);
  }

  /** The rows of the graded answers. */
  get #rows(): readonly AnswerRow[] {
    return withSame(this.#answers.flatMap((answer) => this.#graded.get(answer) ?? []));
  }

  /** Grades all answers by another exercise, or in another language. */
  async #gradeAgain(): Promise<void> {
    this.#graded.clear();
    if (this.#answers.length > 0) await this.#grade();
  }

  /** The exercise of the select element. */
  async #chosenExercise(): Promise<ChosenExercise | undefined> {
    const id = this.#exercise.value;
    if (id === FROM_LINKS) return undefined;
    const isForAll = id === OWN_FILE;
    const text = isForAll ? this.#ownText : await loadExercise(id);
    return text === undefined ? undefined : { text, isForAll };
  }

  /** Removes the answers, or brings the removed ones back. */
  #clearOrUndo(): void {
    this.#requestCount++;
    const { length } = this.#answers;
    [this.#answers, this.#cleared] = length === 0 ? [this.#cleared, []] : [[], this.#answers];
    this.#status.textContent = '';
    this.#render();
    if (this.#answers.length > 0) void this.#grade();
  }

  #sortBy(key: HeadKey): void {
    const isSame = this.#sortedBy?.key === key;
    this.#sortedBy = { key, isDescending: isSame && this.#sortedBy?.isDescending === false };
    this.#render();
  }

  /** The rows with the filter, in their order. */
  get #shownRows(): readonly AnswerRow[] {
    const texts = ANSWERS_WORDS[this.#language];
    const wanted = this.#filter.value.trim().toLocaleLowerCase();
    // The names of others in the note do not count.
    const searched = (row: AnswerRow): string => cellsOf(alone(row), texts).join(' ').toLocaleLowerCase();
    const found = this.#rows.filter((row) => searched(row).includes(wanted));
    const sorted = this.#sortedBy;
    if (sorted === undefined) return found;
    const collator = new Intl.Collator(this.#language, { numeric: true });
    const compare = (a: AnswerRow, b: AnswerRow): number =>
      collator.compare(sortKeyOf(a, sorted.key, texts), sortKeyOf(b, sorted.key, texts));
    return [...found].sort((a, b) => (sorted.isDescending ? compare(b, a) : compare(a, b)));
  }

  /** Renders the shown rows. */
  #renderTable(): readonly AnswerRow[] {
    const isEmpty = this.#answers.length === 0;
    for (const part of [this.#table, this.#csv, this.#print, this.#fields.filter.label]) part.hidden = isEmpty;
    const texts = ANSWERS_WORDS[this.#language];
    this.#clear.hidden = isEmpty && this.#cleared.length === 0;
    this.#clear.textContent = isEmpty ? texts.undoClear : texts.clear;
    // The table needs the room.
    this.#links.rows = isEmpty ? 4 : 1;
    this.#dialog.about = isEmpty ? texts.about : '';
    this.#renderHead();
    const rows = this.#shownRows;
    setChildren(
      this.#body,
      rows.map((row) => this.#tableRow(row)),
    );
    return rows;
  }

  /** Renders the shown rows, and makes their files. */
  #render(): void {
    const rows = this.#renderTable();
    if (this.#rows.length === 0) return;
    const language = this.#language;
    const texts = ANSWERS_WORDS[language];
    const head = HEAD_KEYS.map((key) => texts.head[key]);
    // A spreadsheet reads UTF-8 only after a byte order mark.
    setFile(this.#csv, `\ufeff${csvOf(rows, texts)}`, 'text/csv;charset=utf-8');
    const table = printedTable(
      head,
      rows.map((row) => cellsOf(row, texts)),
    );
    setFile(this.#print, printedPage(texts.title, language, table), 'text/html;charset=utf-8');
  }

  #renderHead(): void {
    for (const { key, cell, button } of this.#headCells) {
      setText(button, ANSWERS_WORDS[this.#language].head[key]);
      const sorted = this.#sortedBy?.key === key ? this.#sortedBy : undefined;
      cell.setAttribute('aria-sort', sorted === undefined ? 'none' : sorted.isDescending ? 'descending' : 'ascending');
    }
  }

  #headCell(key: HeadKey): HeadCell {
    const button = make('button', { type: 'button', className: 'link' });
    button.addEventListener('click', () => this.#sortBy(key));
    return { key, cell: make('th', { scope: 'col' }, button), button };
  }

  /** The element of a row; the same as before if its contents are unchanged. */
  #tableRow(row: AnswerRow): HTMLElement {
    const [name = '', ...cells] = cellsOf(row, ANSWERS_WORDS[this.#language]);
    const { graded, link } = row;
    const state = graded === undefined ? 'not-graded' : graded.report.passed ? 'passed' : 'failed';
    const contents = JSON.stringify([state, link, name, cells]);
    const answer = row.answer ?? row;
    const rendered = this.#rendered.get(answer);
    if (rendered?.contents === contents) return rendered.element;
    const title =
      link === undefined ? name : make('a', { className: 'link', href: link, target: '_blank', rel: 'noopener' }, name);
    const element = make(
      'tr',
      { className: state },
      make('th', { scope: 'row' }, title),
      ...cells.map((text) => make('td', {}, text)),
    );
    this.#rendered.set(answer, { contents, element });
    return element;
  }
}

/** A row without the names of answers with the same text. */
function alone(row: AnswerRow): AnswerRow {
  return row.graded === undefined ? row : { ...row, graded: { ...row.graded, sameAs: [] } };
}

/** Adds the link that opens a graded answer with its exercise. */
async function withLink(row: AnswerRow): Promise<AnswerRow> {
  const { answer, graded } = row;
  if (answer === undefined || graded === undefined) return row;
  const { id, version, hints = 0, exerciseText } = graded;
  const made = await makeLink({
    ...EMPTY_SHARED,
    text: answer.text,
    exercise: { id, version, hints },
    exerciseText,
    name: answer.name === '' ? null : answer.name.slice(0, NAME_LIMIT),
  }).catch(() => undefined);
  return made?.kind === 'link' ? { ...row, link: made.link } : row;
}
