// The words of the programs found in a text. Part of i18n.ts, in a file of its own for its length. The reasons of changes
// come from the interpreter.

import { counter } from './plural';

export interface PasteStrings {
  readonly button: string;
  /** For who does not see the page around it. */
  readonly buttonName: string;
  readonly buttonHint: string;
  readonly title: string;
  readonly about: (programs: number) => string;
  readonly more: (programs: number) => string;
  readonly none: string;
  readonly tooLong: string;
  readonly list: string;
  readonly lines: (first: number, last: number) => string;
  readonly changes: (n: number) => string;
  readonly questions: (n: number) => string;
  readonly unchanged: string;
  readonly cleaned: string;
  readonly what: string;
  readonly asPrinted: (text: string) => string;
  readonly allMinus: string;
  readonly take: string;
  readonly asItIs: string;
  readonly taken: string;
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

export const pasteStrings: { readonly en: PasteStrings; readonly zh: PasteStrings; readonly ru: PasteStrings } = {
  en: {
    button: 'Programs…',
    buttonName: 'Programs in a text…',
    buttonHint: 'Finds the programs in the text of the editor, such as a page of a book or a forum, and cleans them',
    title: 'Programs in this text',
    about: (n) => `${numbers.en.programs(n)} found. The text is in the editor as it was; undo brings it back after a program is taken.`,
    more: (n) => `${numbers.en.programs(n)} more not listed: paste a shorter text.`,
    none: 'No program was found in this text.',
    tooLong: 'The text is too long to be searched for programs.',
    list: 'Programs found',
    lines: (first, last) => (first === last ? `line ${first}` : `lines ${first}–${last}`),
    changes: numbers.en.changes,
    questions: numbers.en.questions,
    unchanged: 'as it was',
    cleaned: 'The program, cleaned',
    what: 'What was changed',
    asPrinted: (text) => `${text} as printed`,
    allMinus: 'All of these negative',
    take: 'Take this program',
    asItIs: 'Paste as it is',
    taken: 'The program took the place of the text. Undo brings it back.',
  },
  zh: {
    button: '程序…',
    buttonName: '文本中的程序…',
    buttonHint: '在编辑器的文本（如书页、论坛帖子）中查找程序并清理',
    title: '文本中的程序',
    about: (n) => `找到 ${numbers.zh.programs(n)}。文本已原样放入编辑器；采用程序后可撤销恢复。`,
    more: (n) => `还有 ${numbers.zh.programs(n)}未列出：请粘贴较短的文本。`,
    none: '文本中没有找到程序。',
    tooLong: '文本过长，无法查找程序。',
    list: '找到的程序',
    lines: (first, last) => (first === last ? `第 ${first} 行` : `第 ${first}–${last} 行`),
    changes: numbers.zh.changes,
    questions: numbers.zh.questions,
    unchanged: '未修改',
    cleaned: '清理后的程序',
    what: '修改内容',
    asPrinted: (text) => `${text}（按原文）`,
    allMinus: '全部取负值',
    take: '采用此程序',
    asItIs: '原样粘贴',
    taken: '程序已替换文本。可用撤销恢复。',
  },
  ru: {
    button: 'Программы…',
    buttonName: 'Программы в тексте…',
    buttonHint: 'Находит программы в тексте редактора (страница учебника, форум) и очищает их',
    title: 'Программы в этом тексте',
    about: (n) => `Найдено: ${numbers.ru.programs(n)}. Текст вставлен в редактор без изменений; когда программа принята, отмена вернёт его.`,
    more: (n) => `Не показано ещё: ${numbers.ru.programs(n)}. Вставьте текст короче.`,
    none: 'Программ в этом тексте не найдено.',
    tooLong: 'Текст слишком длинный для поиска программ.',
    list: 'Найденные программы',
    lines: (first, last) => (first === last ? `строка ${first}` : `строки ${first}–${last}`),
    changes: numbers.ru.changes,
    questions: numbers.ru.questions,
    unchanged: 'без изменений',
    cleaned: 'Очищенная программа',
    what: 'Что изменено',
    asPrinted: (text) => `${text}, как напечатано`,
    allMinus: 'Все со знаком минус',
    take: 'Принять эту программу',
    asItIs: 'Вставить как есть',
    taken: 'Программа заменила текст. Отмена вернёт его.',
  },
};
