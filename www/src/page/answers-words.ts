// Texts of the dialog "Answers of a class".

import { words } from '../dom/words';
import type { AnswerFault, HeadKey } from './answers';

interface HeadWords extends Readonly<Record<HeadKey, string>> {}

export const ANSWERS_WORDS = words({
  en: {
    title: 'Answers of a class',
    about:
      'Each program is run and measured in this browser. A link contains the program, the name, the exercise and the number of hints, but no verdict.',
    exercise: 'Exercise',
    fromLinks: 'As in the links',
    ownExercise: 'Own exercise',
    openExercise: 'Open an exercise file…',
    scorm: 'SCORM package of the exercise',
    links: 'Links that the learners have sent',
    linksHint: 'https://…#share=… (one or many)',
    filter: 'Filter',
    dropHere: 'Drop the programs here',
    openFiles: 'Open program files…',
    clear: 'Clear',
    undoClear: 'Undo',
    csv: 'CSV',
    print: 'Page to print',
    check: 'Check the links',
    none: 'There is no link in this text.',
    known: 'These answers are in the table already.',
    tooMany: (most: number) => `At most ${most} answers fit into the table.`,
    checking: (next: number, all: number) => `Checking ${next} of ${all}…`,
    summary: (passed: number, all: number) => `${passed} of ${all} passed.`,
    noName: 'no name',
    line: (line: number) => `line ${line}`,
    problems: (errors: number, warnings: number) => `${errors} / ${warnings}`,
    passed: 'passed',
    notPassed: 'not passed',
    sameAs: (names: readonly string[], hasMore: boolean) => `same text as ${names.join(', ')}${hasMore ? ', …' : ''}`,
    fromLink: 'exercise as in the link; to grade by your own file, open that file',
    otherVersion: 'another version of the exercise',
    head: {
      name: 'Name',
      exercise: 'Exercise',
      result: 'Result',
      points: 'Points',
      part: 'Part',
      failed: 'Failed checks',
      problems: 'Errors / warnings',
      time: 'Time',
      codes: 'Codes',
      hints: 'Hints',
      note: 'Note',
    } satisfies HeadWords as HeadWords,
    fault: (fault: AnswerFault): string => {
      switch (fault.kind) {
        case 'link':
          return 'The link is damaged or not complete.';
        case 'file':
          return 'The file cannot be read.';
        case 'no-exercise':
          return 'The answer names no exercise: choose one above.';
        case 'not-loaded':
          return `The exercise ${fault.id} could not be loaded: open its file above.`;
        case 'faulty-exercise':
          return `The exercise file has a fault in line ${fault.line}: ${fault.message}`;
        case 'failed':
          return 'The program could not be run.';
      }
    },
  },
  zh: {
    title: '全班的答案',
    about: '每个程序都在本浏览器中运行并测量。链接中有程序、姓名、练习和提示次数，但没有评判结果。',
    exercise: '练习',
    fromLinks: '以链接为准',
    ownExercise: '自己的练习',
    openExercise: '打开练习文件…',
    scorm: '练习的 SCORM 包',
    links: '学生发来的链接',
    linksHint: 'https://…#share=…（一个或多个）',
    filter: '筛选',
    dropHere: '将程序文件拖放到此处',
    openFiles: '打开程序文件…',
    clear: '清空',
    undoClear: '撤销',
    csv: 'CSV',
    print: '打印用页面',
    check: '检查链接',
    none: '这段文字中没有链接。',
    known: '这些答案已在表中。',
    tooMany: (most) => `表中最多容纳 ${most} 份答案。`,
    checking: (next, all) => `正在检查 ${next}/${all}…`,
    summary: (passed, all) => `${all} 份中 ${passed} 份通过。`,
    noName: '无姓名',
    line: (line) => `第 ${line} 行`,
    problems: (errors, warnings) => `${errors} / ${warnings}`,
    passed: '通过',
    notPassed: '未通过',
    sameAs: (names, hasMore) => `与${names.map((name) => `“${name}”`).join('、')}${hasMore ? '等' : ''}的程序文本相同`,
    fromLink: '按链接中的练习评判；如需按原文件评判，请打开练习文件',
    otherVersion: '练习版本不同',
    head: {
      name: '姓名',
      exercise: '练习',
      result: '结果',
      points: '分数',
      part: '零件',
      failed: '未通过的检查',
      problems: '错误 / 警告',
      time: '时间',
      codes: '代码',
      hints: '提示次数',
      note: '备注',
    },
    fault: (fault) => {
      switch (fault.kind) {
        case 'link':
          return '链接已损坏或不完整。';
        case 'file':
          return '无法读取此文件。';
        case 'no-exercise':
          return '答案未注明练习，请在上面选择。';
        case 'not-loaded':
          return `练习“${fault.id}”加载失败：请在上面打开练习文件。`;
        case 'faulty-exercise':
          return `练习文件第 ${fault.line} 行有错误：${fault.message}`;
        case 'failed':
          return '无法运行此程序。';
      }
    },
  },
  ru: {
    title: 'Ответы группы',
    about:
      'Каждая программа выполняется и измеряется в этом браузере. В ссылке есть программа, имя, упражнение и число подсказок, но нет оценки.',
    exercise: 'Упражнение',
    fromLinks: 'Как в ссылках',
    ownExercise: 'Своё упражнение',
    openExercise: 'Открыть файл упражнения…',
    scorm: 'Пакет SCORM с упражнением',
    links: 'Ссылки, которые прислали ученики',
    linksHint: 'https://…#share=… (одна или несколько)',
    filter: 'Фильтр',
    dropHere: 'Отпустите файлы с программами здесь',
    openFiles: 'Открыть файлы программ…',
    clear: 'Очистить',
    undoClear: 'Отменить очистку',
    csv: 'CSV',
    print: 'Страница для печати',
    check: 'Проверить ссылки',
    none: 'В этом тексте нет ссылок.',
    known: 'Эти ответы уже есть в таблице.',
    tooMany: (most) => `В таблице помещается не более ${most} ответов.`,
    checking: (next, all) => `Проверка ${next} из ${all}…`,
    summary: (passed, all) => `Выполнено ${passed} из ${all}.`,
    noName: 'без имени',
    line: (line) => `строка ${line}`,
    problems: (errors, warnings) => `${errors} / ${warnings}`,
    passed: 'выполнено',
    notPassed: 'не выполнено',
    sameAs: (names, hasMore) =>
      `тот же текст, что у ${names.map((name) => `«${name}»`).join(', ')}${hasMore ? ' и др.' : ''}`,
    fromLink: 'упражнение взято из ссылки; чтобы проверить по своему файлу, откройте файл упражнения',
    otherVersion: 'другая версия упражнения',
    head: {
      name: 'Имя',
      exercise: 'Упражнение',
      result: 'Итог',
      points: 'Баллы',
      part: 'Деталь',
      failed: 'Непройденные проверки',
      problems: 'Ошибки / предупреждения',
      time: 'Время',
      codes: 'Коды',
      hints: 'Подсказки',
      note: 'Примечание',
    },
    fault: (fault) => {
      switch (fault.kind) {
        case 'link':
          return 'Ссылка повреждена или неполная.';
        case 'file':
          return 'Файл не читается.';
        case 'no-exercise':
          return 'В ответе не указано упражнение: выберите его выше.';
        case 'not-loaded':
          return `Упражнение «${fault.id}» не удалось загрузить: откройте файл упражнения кнопкой выше.`;
        case 'faulty-exercise':
          return `В файле упражнения ошибка в строке ${fault.line}: ${fault.message}`;
        case 'failed':
          return 'Программу не удалось выполнить.';
      }
    },
  },
});
export type AnswersWords = (typeof ANSWERS_WORDS)['en'];
