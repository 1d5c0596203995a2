// The dialog "Exercise with a checked part": makes an exercise of the program on the page.
//
// In: the host. Out: the text of an exercise file, as a link, a QR code and a file. The program is not part of it. Must
// not know: how a part becomes a target.

import '../dom/dialog.css';
import './share.css';
import './make-exercise.css';
import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import { importWithRetry } from '../dom/network';
import { COMMON, words } from '../dom/words';
import { EMPTY_SHARED, makeLink } from '../files/shared-link';
import { exerciseText } from './exercise-text';
import { copyField, field } from './fields';
import { pageAddress } from './linked';
import type { PageHost } from './page-host';
import { setFile } from './printed';

let dialog: MakeExerciseDialog | undefined;

export function makeExercise(host: PageHost): void {
  dialog ??= new MakeExerciseDialog();
  void dialog.open(host);
}

/** The delay before the text is checked while the author types. */
const CHECK_AFTER_MS = 400;

class MakeExerciseDialog {
  readonly #title = make('input', { type: 'text', autocomplete: 'off', maxLength: 100 });
  readonly #task = make('textarea', { rows: 4, autocomplete: 'off', maxLength: 4000 });
  readonly #hints = make('textarea', { rows: 3, autocomplete: 'off', maxLength: 2000 });
  readonly #start = make('textarea', {
    rows: 4,
    spellcheck: false,
    autocomplete: 'off',
    dir: 'ltr',
    className: 'code',
  });
  readonly #blocks = make('textarea', {
    rows: 8,
    spellcheck: false,
    autocomplete: 'off',
    dir: 'ltr',
    className: 'code',
  });
  readonly #require = make('input', { type: 'text', autocomplete: 'off', placeholder: 'G71, G70' });
  readonly #forbid = make('input', { type: 'text', autocomplete: 'off', placeholder: 'G90' });
  readonly #safeEnd = make('input', { type: 'text', inputMode: 'decimal', autocomplete: 'off', value: '2' });
  readonly #points = make('input', { type: 'text', inputMode: 'numeric', autocomplete: 'off', value: '10' });
  readonly #fields = [
    { name: 'title', ...field(this.#title) },
    { name: 'task', ...field(this.#task) },
    { name: 'hints', ...field(this.#hints) },
    { name: 'start', ...field(this.#start) },
    { name: 'blocks', ...field(this.#blocks) },
    { name: 'require', ...field(this.#require) },
    { name: 'forbid', ...field(this.#forbid) },
    { name: 'safeEnd', ...field(this.#safeEnd) },
    { name: 'points', ...field(this.#points) },
  ] as const;
  readonly #status = make('p', { role: 'status' });
  readonly #output = make('textarea', { readOnly: true, hidden: true });
  readonly #qr = make('div', { className: 'drawn' });
  readonly #try = make('a', { className: 'framed', target: '_blank', rel: 'noopener' });
  readonly #save = make('a', { className: 'framed', download: 'exercise.md' });
  readonly #showQr = make('button', { type: 'button', className: 'framed' });
  readonly #copy = make('button', { type: 'button', className: 'primary' });
  readonly #dialog = new Dialog(
    'make-exercise',
    [
      make('div', { className: 'make-exercise-fields' }, ...this.#fields.map(({ label }) => label)),
      this.#qr,
      this.#output,
    ],
    [this.#status, this.#showQr, this.#save, this.#try, this.#copy],
  );
  #host: PageHost | undefined;
  /** The program that the blocks were made of. */
  #program: string | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Number of checks and changes; a result of an earlier text is dropped. */
  #check = 0;

  constructor() {
    document.body.append(this.#dialog.element);
    this.#dialog.element.addEventListener('input', () => this.#changed());
    this.#copy.addEventListener('click', () => void this.#copyLink());
    this.#showQr.addEventListener('click', () => void this.#drawQr());
  }

  async open(host: PageHost): Promise<void> {
    this.#host = host;
    const texts = WORDS[host.language];
    this.#dialog.setTexts(texts.title, COMMON[host.language].close);
    this.#dialog.about = texts.about;
    for (const { name, caption } of this.#fields) caption.textContent = texts.fields[name];
    this.#try.textContent = texts.try;
    this.#save.textContent = texts.save;
    this.#showQr.textContent = texts.qr;
    this.#copy.textContent = texts.copy;
    this.#setReady(undefined);
    this.#dialog.show();
    this.#title.focus();
    const { text } = host.program;
    // What the author has entered stays, unless the program has changed.
    if (this.#program !== text) {
      const made = await host.playground.ask('exercise-blocks', undefined).catch(() => undefined);
      if (made?.kind !== 'blocks') {
        this.#program = undefined;
        this.#blocks.value = '';
        this.#status.textContent = made === undefined ? texts.failed : texts.none(made.reason);
        return;
      }
      this.#program = text;
      this.#blocks.value = made.text;
    }
    await this.#run();
  }

  #changed(): void {
    clearTimeout(this.#timer);
    // A check in progress would offer the previous text.
    this.#check++;
    this.#setReady(undefined);
    this.#timer = setTimeout(() => void this.#run(), CHECK_AFTER_MS);
  }

  get #text(): string {
    return exerciseText({
      language: this.#host?.language ?? 'en',
      title: this.#title.value.trim() === '' ? WORDS[this.#host?.language ?? 'en'].untitled : this.#title.value,
      task: this.#task.value,
      hints: this.#hints.value.split('\n'),
      start: this.#start.value,
      blocks: this.#blocks.value,
      require: this.#require.value,
      forbid: this.#forbid.value,
      safeEnd: this.#safeEnd.value,
      points: this.#points.value,
    });
  }

  /** Checks the author's program as an answer, and makes the link. */
  async #run(): Promise<void> {
    const host = this.#host;
    if (host === undefined || this.#program === undefined) return;
    const check = ++this.#check;
    const texts = WORDS[host.language];
    if (this.#task.value.trim() === '') {
      this.#status.textContent = texts.noTask;
      return;
    }
    const text = this.#text;
    const found = await host.playground.ask('grade-answer', { text, answer: this.#program }).catch(() => undefined);
    if (check !== this.#check) return;
    if (found === undefined) this.#status.textContent = texts.failed;
    else if (found.kind === 'fault')
      this.#status.textContent = texts.fault(text.split('\n')[found.line - 1]?.trim() ?? '', found.message);
    else {
      const { report, id } = found;
      const failed = report.checks.filter(({ passed }) => !passed).map(({ check }) => check);
      const wrong = [...(report.samePart ? [] : [report.part]), ...failed];
      this.#status.textContent = report.passed ? texts.passes : texts.fails(wrong.join('; '));
      const made = await makeLink({ ...EMPTY_SHARED, exerciseText: text }).catch(() => undefined);
      if (check !== this.#check || made?.kind !== 'link') return;
      this.#save.download = `${id}.md`;
      setFile(this.#save, text, 'text/markdown;charset=utf-8');
      this.#setReady(`${pageAddress()}${made.link}`);
    }
  }

  /** The address of the exercise; undefined while there is none. */
  #setReady(address: string | undefined): void {
    this.#output.value = address ?? '';
    this.#copy.disabled = this.#showQr.disabled = address === undefined;
    for (const link of [this.#try, this.#save]) link.hidden = address === undefined;
    if (address !== undefined) this.#try.href = address;
    this.#qr.replaceChildren();
  }

  async #drawQr(): Promise<void> {
    const texts = WORDS[this.#host?.language ?? 'en'];
    const { qrCode, QR_LIMIT } = await importWithRetry(() => import('./qr'));
    const drawn = qrCode(this.#output.value);
    if (drawn === undefined) {
      this.#status.textContent = texts.qrTooLong(this.#output.value.length, QR_LIMIT);
      return;
    }
    drawn.setAttribute('role', 'img');
    drawn.setAttribute('aria-label', texts.qr);
    this.#qr.replaceChildren(drawn);
  }

  async #copyLink(): Promise<void> {
    const texts = WORDS[this.#host?.language ?? 'en'];
    const show = (): void => void (this.#output.hidden = false);
    const isCopied = (await copyField(this.#output, show)) === 'copied';
    this.#status.textContent = isCopied ? texts.copied : texts.notCopied;
  }
}

const WORDS = words({
  en: {
    title: 'Exercise that checks the part',
    about:
      'The part of your program is the wanted part. The exercise contains its outline, the blank and the tools, but not your program.',
    untitled: 'Exercise',
    fields: {
      title: 'Title',
      task: 'Task',
      hints: 'Hints, one in each line (at most three)',
      start: 'Program that the learner begins with',
      blocks: 'Blank, tools and wanted part; a tolerance before parentheses applies to the size in them',
      require: 'Required codes',
      forbid: 'Forbidden codes',
      safeEnd: 'Least distance from the blank at the end, mm',
      points: 'Points',
    },
    try: 'Try as a learner',
    save: 'Save as a file',
    qr: 'QR code',
    copy: 'Copy the link',
    copied: 'Copied',
    notCopied: 'The browser does not allow copying. The link is selected: copy it by hand.',
    passes: 'Your program passes.',
    fails: (wrong: string) => `Your program does not pass. Failed: ${wrong}`,
    noTask: 'Enter the task.',
    fault: (line: string, message: string) => `The exercise has a fault (“${line}”): ${message}`,
    none: (reason: string) => `There is no wanted part: ${reason}.`,
    failed: 'The program could not be run.',
    qrTooLong: (length: number, limit: number) =>
      `The link has ${length} characters; a QR code holds at most ${limit}. Save the exercise as a file.`,
  },
  zh: {
    title: '检查零件的练习',
    about: '您的程序加工出的零件就是要求的零件。练习中有它的轮廓、毛坯和刀具，但没有您的程序。',
    untitled: '练习',
    fields: {
      title: '标题',
      task: '任务',
      hints: '提示，每行一条（最多三条）',
      start: '学生开始时的程序',
      blocks: '毛坯、刀具和要求的零件；括号前的公差对应括号中的尺寸',
      require: '必须使用的代码',
      forbid: '禁止使用的代码',
      safeEnd: '结束时离毛坯的最小距离，mm',
      points: '分数',
    },
    try: '以学生身份试做',
    save: '保存为文件',
    qr: '二维码',
    copy: '复制链接',
    copied: '已复制',
    notCopied: '浏览器不允许复制。链接已选中，请手动复制。',
    passes: '您的程序通过。',
    fails: (wrong) => `您的程序未通过。未通过的检查：${wrong}`,
    noTask: '请填写任务。',
    fault: (line, message) => `练习有错误（“${line}”）：${message}`,
    none: (reason) => `没有要求的零件：${reason}。`,
    failed: '无法运行此程序。',
    qrTooLong: (length, limit) => `链接有 ${length} 个字符，二维码最多容纳 ${limit} 个。请将练习保存为文件。`,
  },
  ru: {
    title: 'Упражнение с проверкой детали',
    about:
      'Деталь вашей программы и есть требуемая. В упражнении есть её контур, заготовка и инструменты, но не ваша программа.',
    untitled: 'Упражнение',
    fields: {
      title: 'Название',
      task: 'Задание',
      hints: 'Подсказки, по одной в строке (не более трёх)',
      start: 'Программа, с которой начинает ученик',
      blocks: 'Заготовка, инструменты и требуемая деталь; допуск перед скобками относится к размеру в скобках',
      require: 'Обязательные коды',
      forbid: 'Запрещённые коды',
      safeEnd: 'Наименьшее расстояние от заготовки в конце, мм',
      points: 'Баллы',
    },
    try: 'Попробовать как ученик',
    save: 'Сохранить файл',
    qr: 'QR-код',
    copy: 'Копировать ссылку',
    copied: 'Скопировано',
    notCopied: 'Браузер не разрешает копирование. Ссылка выделена: скопируйте её вручную.',
    passes: 'Ваша программа выполняет упражнение.',
    fails: (wrong) => `Ваша программа не выполняет упражнение. Не пройдено: ${wrong}`,
    noTask: 'Введите задание.',
    fault: (line, message) => `В упражнении ошибка («${line}»): ${message}`,
    none: (reason) => `Требуемой детали нет: ${reason}.`,
    failed: 'Программу не удалось выполнить.',
    qrTooLong: (length, limit) =>
      `В ссылке ${length} знаков, а в QR-код помещается не более ${limit}. Сохраните упражнение в файл.`,
  },
});
