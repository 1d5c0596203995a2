// The exercises: the list with the learner's progress, its export and a certificate.
//
// In: `exercises/list.json`, the stored progress. Out: the address of an exercise; files. Loaded when it is first opened.
// Must not know: the contents of an exercise.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import { COMMON, words } from '../dom/words';
import { loadExercises, titleOf, type ListedExercise } from './exercise-list';
import { parseProgress, readProgress, writeProgress, type Progress } from './exercise-progress';
import type { PageHost } from './page-host';
import { printedPage, printedTable, setFile } from './printed';
import '../dom/dialog.css';
import './exercises.css';

let dialog: ExercisesDialog | undefined;

export function openExercises(host: PageHost): void {
  dialog ??= new ExercisesDialog();
  void dialog.open(host);
}

class ExercisesDialog {
  readonly #total = make('p', { className: 'exercises-total', role: 'status' });
  readonly #list = make('ol', { className: 'exercises-list' });
  readonly #export = make('a', { className: 'framed', download: 'exercises.json' });
  readonly #certificate = make('a', { className: 'framed', download: 'certificate.html' });
  readonly #import = make('input', { type: 'file', accept: '.json,application/json', hidden: true });
  readonly #importButton = make('button', { type: 'button', className: 'framed' });
  readonly #answers = make('button', { type: 'button', className: 'framed', 'aria-haspopup': 'dialog' });
  readonly #dialog = new Dialog(
    'exercises',
    [this.#total, this.#list],
    [this.#import, this.#answers, this.#importButton, this.#export, this.#certificate],
  );
  #rows: readonly ListedExercise[] = [];
  #language: Language = 'en';
  #host: PageHost | undefined;

  constructor() {
    document.body.append(this.#dialog.element);
    this.#importButton.addEventListener('click', () => this.#import.click());
    this.#import.addEventListener('change', () => void this.#importFile());
    this.#answers.addEventListener('click', () => void this.#openAnswers());
  }

  async open(host: PageHost): Promise<void> {
    const { language } = host;
    this.#host = host;
    this.#language = language;
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#export.textContent = texts.export;
    this.#certificate.textContent = texts.certificate;
    this.#importButton.textContent = texts.import;
    this.#answers.textContent = texts.answers;
    this.#dialog.show();
    const rows = await loadExercises();
    if (rows === undefined) {
      this.#total.textContent = texts.notLoaded;
      return;
    }
    this.#rows = rows;
    this.#render();
  }

  #render(): void {
    const texts = WORDS[this.#language];
    const progress = readProgress();
    const passed = this.#rows.filter(({ id }) => progress[id]?.passed === true);
    const sum = (rows: readonly ListedExercise[]): number => rows.reduce((all, { points }) => all + points, 0);
    this.#total.textContent = texts.total(passed.length, this.#rows.length, sum(passed), sum(this.#rows));
    this.#list.replaceChildren(...this.#rows.map((row) => this.#item(row, progress)));
    setFile(this.#export, JSON.stringify(progress, undefined, 2), 'application/json');
    setFile(this.#certificate, certificate(passed, progress, this.#language), 'text/html;charset=utf-8');
    this.#certificate.hidden = passed.length === 0;
  }

  #item(row: ListedExercise, progress: Progress): HTMLElement {
    const texts = WORDS[this.#language];
    const own = progress[row.id];
    const state = own === undefined ? texts.open : own.passed ? texts.passed : texts.tried(own.tries);
    const link = make('a', { className: 'link', href: `#exercise=${row.id}` }, titleOf(row, this.#language));
    link.addEventListener('click', () => this.#dialog.close());
    return make(
      'li',
      { className: own?.passed === true ? 'passed' : '' },
      link,
      make('span', { className: 'exercises-state' }, `${state} · ${texts.points(row.points)}`),
    );
  }

  /** Opens the answers of a class. */
  async #openAnswers(): Promise<void> {
    try {
      const { openAnswers } = await importWithRetry(() => import('./answers-dialog'));
      if (this.#host === undefined) return;
      this.#dialog.close();
      openAnswers(this.#host);
    } catch {
      this.#total.textContent = WORDS[this.#language].notLoaded;
    }
  }

  /** Adds the progress of a file. An exercise that was passed in either is passed. */
  async #importFile(): Promise<void> {
    const file = this.#import.files?.[0];
    this.#import.value = '';
    if (file === undefined) return;
    try {
      const now = readProgress();
      const added = parseProgress(await file.text());
      const isKept = (id: string): boolean => now[id]?.passed === true && added[id]?.passed !== true;
      const kept = Object.entries(added).filter(([id]) => !isKept(id));
      writeProgress({ ...now, ...Object.fromEntries(kept) });
      this.#render();
    } catch {
      this.#total.textContent = WORDS[this.#language].notProgress;
    }
  }
}

/** A page to print: the passed exercises with points, hints and day. */
function certificate(passed: readonly ListedExercise[], progress: Progress, language: Language): string {
  const texts = WORDS[language];
  const rows = passed.map((row) => {
    const { hints = 0, date = '' } = progress[row.id] ?? {};
    return [titleOf(row, language), String(row.points), String(hints), date];
  });
  const head = [texts.exercise, texts.pointsHead, texts.hints, texts.day];
  const name = make('p', {}, `${texts.name}: ______________________________`);
  return printedPage(texts.certificate, language, name, printedTable(head, rows));
}

const WORDS = words({
  en: {
    title: 'Exercises',
    about: 'Write a program, and check the part. Your work and your progress are kept in this browser.',
    total: (passed: number, all: number, points: number, allPoints: number) =>
      `${passed} of ${all} passed · ${points} of ${allPoints} points`,
    open: 'not tried',
    passed: 'passed',
    tried: (tries: number) => `checked ${tries}×`,
    points: (points: number) => `${points} points`,
    export: 'Save progress',
    import: 'Load progress…',
    answers: 'Answers of a class…',
    certificate: 'Certificate',
    notLoaded: 'The exercises could not be loaded.',
    notProgress: 'The file contains no progress.',
    exercise: 'Exercise',
    pointsHead: 'Points',
    hints: 'Hints',
    day: 'Day',
    name: 'Name',
  },
  zh: {
    title: '练习',
    about: '编写程序并检查零件。您的程序和进度保存在本浏览器中。',
    total: (passed, all, points, allPoints) => `已通过 ${passed}/${all} · ${points}/${allPoints} 分`,
    open: '未做',
    passed: '已通过',
    tried: (tries) => `检查过 ${tries} 次`,
    points: (points) => `${points} 分`,
    export: '保存进度',
    import: '载入进度…',
    answers: '全班的答案…',
    certificate: '成绩单',
    notLoaded: '练习加载失败。',
    notProgress: '文件中没有进度。',
    exercise: '练习',
    pointsHead: '分数',
    hints: '提示',
    day: '日期',
    name: '姓名',
  },
  ru: {
    title: 'Упражнения',
    about: 'Напишите программу и проверьте деталь. Работы и результаты хранятся в этом браузере.',
    total: (passed, all, points, allPoints) => `Выполнено ${passed} из ${all} · баллов ${points} из ${allPoints}`,
    open: 'не начато',
    passed: 'выполнено',
    tried: (tries) => `проверок: ${tries}`,
    points: (points) => `баллов: ${points}`,
    export: 'Сохранить результаты',
    import: 'Загрузить результаты…',
    answers: 'Ответы группы…',
    certificate: 'Сертификат',
    notLoaded: 'Упражнения не удалось загрузить.',
    notProgress: 'В файле нет результатов.',
    exercise: 'Упражнение',
    pointsHead: 'Баллы',
    hints: 'Подсказки',
    day: 'День',
    name: 'Имя',
  },
});
