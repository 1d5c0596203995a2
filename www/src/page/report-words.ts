// Texts of the report about a difference from a real machine.

import { counter } from '../dom/plural';
import { words } from '../dom/words';

const MORE = {
  en: counter('en', { one: 'motion', other: 'motions' }),
  zh: counter('zh', { other: '个运动' }),
  ru: counter('ru', { one: 'перемещение', few: 'перемещения', many: 'перемещений', other: 'перемещения' }),
};

export interface ReportWords {
  readonly title: string;
  readonly about: string;
  readonly machine: string;
  readonly machineHint: string;
  readonly lineLabel: string;
  readonly block: (line: number) => string;
  readonly did: string;
  readonly didHint: string;
  readonly drawn: string;
  readonly nothingDrawn: string;
  readonly notListed: string;
  readonly more: (n: number) => string;
  readonly unspecified: string;
  readonly versions: string;
  readonly open: string;
  readonly setup: string;
  readonly program: string;
  readonly output: string;
  readonly copy: string;
  readonly copied: string;
  readonly notCopied: string;
  readonly saveFolder: string;
  readonly saved: (name: string) => string;
  readonly unreadableSetup: string;
  readonly inProgress: string;
  readonly notLoaded: string;
}

export const REPORT_WORDS = words<ReportWords>({
  en: {
    title: 'My machine behaves differently',
    about:
      'A report with the program, its setup and the drawn motions. Nothing is sent: copy it, and add it to an issue of the project.',
    machine: 'Machine and control',
    machineHint: 'For example: GSK 980TDb, 2019',
    lineLabel: 'Line of the block',
    block: (line) => `Block in line ${line}`,
    did: 'What the machine did',
    didHint: 'For example: after the cycle it stopped at X40 Z2, not at X42 Z2.',
    drawn: 'What the playground draws there',
    nothingDrawn: 'No motion.',
    notListed: 'The motions are not listed: the program is too long, or it could not be run.',
    more: (n) => `… and ${MORE.en(n)} more`,
    unspecified: '(not given)',
    versions: 'Versions',
    open: 'Open it',
    setup: 'Setup',
    program: 'Program',
    output: 'To copy',
    copy: 'Copy',
    copied: 'Copied',
    notCopied: 'The browser does not allow copying: the text is selected, press Ctrl C.',
    saveFolder: 'Save as a folder for tests',
    saved: (name) => `${name}: unpack it in tests/programs, and put what the machine did into motions.jsonl.`,
    inProgress: 'The report is being prepared…',
    unreadableSetup: 'The setup cannot be read: fix it first.',
    notLoaded: 'This could not be loaded. Try again when you are online.',
  },
  zh: {
    title: '我的机床动作不同',
    about: '报告包含程序、设置和所画的轨迹。不会发送任何内容：复制后添加到项目的问题中。',
    machine: '机床与数控系统',
    machineHint: '例如：GSK 980TDb，2019 年',
    lineLabel: '程序段所在行',
    block: (line) => `第 ${line} 行的程序段`,
    did: '机床的实际动作',
    didHint: '例如：循环结束后停在 X40 Z2，而不是 X42 Z2。',
    drawn: '演练场在此处画出的运动',
    nothingDrawn: '没有运动。',
    notListed: '没有列出运动：程序太长，或者无法运行。',
    more: (n) => `……另有 ${MORE.zh(n)}`,
    unspecified: '（未填写）',
    versions: '版本',
    open: '打开',
    setup: '设置',
    program: '程序',
    output: '可复制的文本',
    copy: '复制',
    copied: '已复制',
    notCopied: '浏览器不允许复制：文本已选中，请按 Ctrl C。',
    saveFolder: '保存为测试文件夹',
    saved: (name) => `${name}：解压到 tests/programs，并在 motions.jsonl 中写入机床的实际动作。`,
    inProgress: '正在生成报告…',
    unreadableSetup: '无法读取设置：请先修正。',
    notLoaded: '加载失败。请在网络恢复后重试。',
  },
  ru: {
    title: 'Мой станок работает иначе',
    about:
      'Отчёт с программой, наладкой и тем, что нарисовано. Ничего не отправляется: скопируйте его и добавьте в обращение к проекту.',
    machine: 'Станок и система ЧПУ',
    machineHint: 'Например: GSK 980TDb, 2019',
    lineLabel: 'Строка кадра',
    block: (line) => `Кадр в строке ${line}`,
    did: 'Что сделал станок',
    didHint: 'Например: после цикла он остановился в X40 Z2, а не в X42 Z2.',
    drawn: 'Что рисует песочница',
    nothingDrawn: 'Нет перемещений.',
    notListed: 'Перемещения не перечислены: программа слишком длинная или её не удалось выполнить.',
    more: (n) => `… и ещё ${MORE.ru(n)}`,
    unspecified: '(не указано)',
    versions: 'Версии',
    open: 'Открыть',
    setup: 'Наладка',
    program: 'Программа',
    output: 'Для копирования',
    copy: 'Копировать',
    copied: 'Скопировано',
    notCopied: 'Браузер не разрешает копирование: текст выделен, нажмите Ctrl C.',
    saveFolder: 'Сохранить папку для тестов',
    saved: (name) => `${name}: распакуйте в tests/programs и запишите в motions.jsonl то, что сделал станок.`,
    inProgress: 'Отчёт составляется…',
    unreadableSetup: 'Наладка не читается: сначала исправьте её.',
    notLoaded: 'Не удалось загрузить. Повторите, когда появится сеть.',
  },
});
