// Texts of links: the dialog that makes them, and the bar of an opened link.

import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words, type Words } from '../dom/words';
import type { AddressContent } from './linked';

type Fault = Extract<AddressContent, { readonly kind: 'fault' }>['fault'];

const FORMS = ['link', 'markdown', 'element', 'frame', 'qr', 'picture'] as const;
export type Form = (typeof FORMS)[number];
export const VIEWS = ['all', 'picture', 'playback', 'code'] as const;
export type SharedView = (typeof VIEWS)[number];

const CHARACTERS: Words<(n: number) => string> = {
  en: counter('en', { one: 'character', other: 'characters' }),
  zh: counter('zh', { other: '个字符' }),
  ru: counter('ru', { one: 'знак', few: 'знака', many: 'знаков', other: 'знака' }),
};
/** The forms after «не более» and «не хватает». */
const OF_CHARACTERS = counter('ru', { one: 'знака', other: 'знаков' });
const OF_BYTES = counter('ru', { one: 'байта', other: 'байтов' });

function number(language: string, n: number): string {
  return new Intl.NumberFormat(language).format(n);
}

/** Errors in an address. */
export const FAULTS: Words<(fault: Fault) => string> = {
  en: (fault) => {
    switch (fault.kind) {
      case 'too-long':
        return `This link is ${CHARACTERS.en(fault.length)} long; at most ${number('en', fault.limit)} are read. Ask for the program as a file.`;
      case 'unpacked-too-long':
        return `The program of this link is longer than ${number('en', fault.limit)} bytes, and was not opened. Ask for it as a file.`;
      case 'newer':
        return `This link was made by a newer version of the playground (format ${fault.version}). Reload the page, or open the link where it was made.`;
      case 'cut':
        return `This link is not complete: ${fault.missing === undefined ? 'its end is missing' : `${CHARACTERS.en(fault.missing)} missing at its end`}. Copy all of it, or ask for it again.`;
      case 'damaged':
        return 'This link is damaged: some of its characters have changed on the way. Ask for it again.';
      case 'browser-too-old':
        return 'This browser cannot unpack links. Open the link in a newer browser.';
      case 'unknown':
        return 'This address names no example, and holds no program.';
      case 'not-loaded':
        return 'What reads links could not be loaded. Reload the page when the network is there.';
    }
  },
  zh: (fault) => {
    switch (fault.kind) {
      case 'too-long':
        return `此链接长 ${CHARACTERS.zh(fault.length)}，最多只读取 ${number('zh', fault.limit)} 个。请让对方以文件形式发送程序。`;
      case 'unpacked-too-long':
        return `此链接中的程序超过 ${number('zh', fault.limit)} 字节，未打开。请让对方以文件形式发送。`;
      case 'newer':
        return `此链接由更新版本的演练场生成（格式 ${fault.version}）。请刷新页面，或在生成链接的网站上打开。`;
      case 'cut':
        return `此链接不完整：${fault.missing === undefined ? '末尾缺失' : `末尾缺少 ${CHARACTERS.zh(fault.missing)}`}。请完整复制，或请对方重新发送。`;
      case 'damaged':
        return '此链接已损坏：部分字符在传送中被改动。请对方重新发送。';
      case 'browser-too-old':
        return '此浏览器无法解压链接。请用较新的浏览器打开。';
      case 'unknown':
        return '此地址不对应任何示例，也不含程序。';
      case 'not-loaded':
        return '读取链接的组件加载失败。请在网络恢复后刷新页面。';
    }
  },
  ru: (fault) => {
    switch (fault.kind) {
      case 'too-long':
        return `Длина этой ссылки — ${CHARACTERS.ru(fault.length)}, а читается не более ${OF_CHARACTERS(fault.limit)}. Попросите прислать программу файлом.`;
      case 'unpacked-too-long':
        return `Программа в этой ссылке длиннее ${OF_BYTES(fault.limit)}, она не открыта. Попросите прислать её файлом.`;
      case 'newer':
        return `Эта ссылка создана более новой версией песочницы (формат ${fault.version}). Обновите страницу или откройте ссылку там, где она создана.`;
      case 'cut':
        return `Ссылка неполная: ${fault.missing === undefined ? 'нет её конца' : `в конце не хватает ${OF_CHARACTERS(fault.missing)}`}. Скопируйте её целиком или попросите прислать ещё раз.`;
      case 'damaged':
        return 'Ссылка повреждена: часть знаков изменилась при пересылке. Попросите прислать её ещё раз.';
      case 'browser-too-old':
        return 'Этот браузер не умеет распаковывать ссылки. Откройте ссылку в более новом.';
      case 'unknown':
        return 'По этому адресу нет ни примера, ни программы.';
      case 'not-loaded':
        return 'Не удалось загрузить то, что читает ссылки. Обновите страницу, когда появится сеть.';
    }
  },
};

/** The bar of an opened link. */
export const LINK_WORDS = words({
  en: {
    bar: 'Link',
    nothingLost: 'The contents of this page are unchanged.',
    task: 'Task:',
    showSolution: 'Show solution',
    hideSolution: 'Hide solution',
    solution: 'Solution',
    compareWithSolution: 'Compare with the solution',
    openSolution: 'Open the solution in a new tab',
    onlyShown: 'The link shows this program without a way to change it, or only a part of the page.',
    everything: 'Open for editing',
    from: 'From:',
    name: 'Your name',
    handIn: 'Copy link to hand in',
    handInExercise: 'Your teacher can open and grade your answer from a link.',
    nextExercise: (title: string) => `Next exercise: ${title}`,
    linkToHandIn: 'Link to hand in',
    copyByHand: 'The browser does not allow copying. The link is selected: copy it by hand.',
    notMade: 'The link could not be made. Try again.',
    hide: 'Hide',
  },
  zh: {
    bar: '链接',
    nothingLost: '页面上原有的内容保持不变。',
    task: '练习：',
    showSolution: '显示答案',
    hideSolution: '隐藏答案',
    solution: '答案',
    compareWithSolution: '与答案比较',
    openSolution: '在新标签页中打开答案',
    onlyShown: '此链接以只读方式展示程序，或只显示页面的一部分。',
    everything: '打开并编辑',
    from: '来自：',
    name: '您的姓名',
    handIn: '复制用于提交的链接',
    handInExercise: '老师可以通过链接打开并批改您的答案。',
    nextExercise: (title) => `下一个练习：${title}`,
    linkToHandIn: '用于提交的链接',
    copyByHand: '浏览器不允许复制。链接已选中，请手动复制。',
    notMade: '链接生成失败，请重试。',
    hide: '隐藏',
  },
  ru: {
    bar: 'Ссылка',
    nothingLost: 'Всё, что было на странице, осталось как было.',
    task: 'Задание:',
    showSolution: 'Показать решение',
    hideSolution: 'Скрыть решение',
    solution: 'Решение',
    compareWithSolution: 'Сравнить с решением',
    openSolution: 'Открыть решение в новой вкладке',
    onlyShown: 'Ссылка показывает программу только для чтения или лишь часть страницы.',
    everything: 'Открыть для правки',
    from: 'От:',
    name: 'Ваше имя',
    handIn: 'Копировать ссылку для сдачи',
    handInExercise: 'По ссылке преподаватель откроет и проверит ваш ответ.',
    nextExercise: (title) => `Следующее упражнение: ${title}`,
    linkToHandIn: 'Ссылка для сдачи',
    copyByHand: 'Браузер не разрешает копирование. Ссылка выделена: скопируйте её вручную.',
    notMade: 'Не удалось создать ссылку. Попробуйте ещё раз.',
    hide: 'Скрыть',
  },
});

export const SHARE_WORDS = words({
  en: {
    title: 'Share',
    about:
      'All of it is in the link: the program, its setup, the control and the switches. Nothing is sent to a server.',
    as: 'As',
    forms: {
      link: 'Link',
      markdown: 'Link in Markdown',
      element: 'Live example for a page (HTML)',
      frame: 'Frame for a page (iframe)',
      qr: 'QR code',
      picture: 'Picture',
    } satisfies Record<Form, string>,
    view: 'Shown',
    views: {
      all: 'Everything',
      picture: 'The drawing',
      playback: 'The drawing, to be played',
      code: 'The program',
    } satisfies Record<SharedView, string>,
    language: 'Opens in English',
    step: (motion: string) => `The tool where it is now (motion ${motion})`,
    readonly: 'Cannot be changed',
    task: 'As a task',
    solution: 'With the solution: the program that is on the page now',
    solutionAbout: 'A button of the task shows it. It is hidden, but not secret.',
    sentence: 'What is to be done',
    start: 'What the pupil begins with',
    startIsSolution: 'The pupil begins with the solution: delete the part to be found.',
    noSolution: 'The page has no program yet, so the task has no solution.',
    emptyTask: 'The task is empty: write what is to be done, or what the pupil begins with.',
    output: 'To copy',
    length: (n: number) => `${CHARACTERS.en(n)}`,
    longer: 'Some mail and chat programs cut off links of more than 2,000 characters.',
    tooLong: (n: number, limit: number) =>
      `This is too long for a link: ${CHARACTERS.en(n)}; at most ${number('en', limit)} can be read. Save the program as a file instead.`,
    copy: 'Copy',
    copied: 'Copied',
    notCopied: 'The browser does not allow copying: the text is selected, press Ctrl C.',
    send: 'Send…',
    qrName: 'QR code of the link',
    qrTooLong: (n: number, limit: number) =>
      `This link is too long for a QR code: ${CHARACTERS.en(n)}; it holds at most ${number('en', limit)}.`,
    saveSvg: 'Save as SVG',
    savePng: 'Save as PNG',
    noPicture: 'There is no picture to save: the program has not run.',
    notMade: 'This could not be made. Close the dialog and try again.',
  },
  zh: {
    title: '分享',
    about: '程序、毛坯与刀具设置、数控系统和开关全部包含在链接中，不会发送到任何服务器。',
    as: '形式',
    forms: {
      link: '链接',
      markdown: 'Markdown 链接',
      element: '网页中的可操作示例 (HTML)',
      frame: '网页框架 (iframe)',
      qr: '二维码',
      picture: '图片',
    },
    view: '显示',
    views: { all: '全部', picture: '图形', playback: '图形和播放', code: '程序' },
    language: '以中文打开',
    step: (motion) => `刀具停在当前位置（第 ${motion} 个运动）`,
    readonly: '不可修改',
    task: '作为练习',
    solution: '包含答案：页面上当前的程序',
    solutionAbout: '练习中点击按钮才显示答案；只是不直接可见，并不保密。',
    sentence: '练习要求',
    start: '学生开始时看到的程序',
    startIsSolution: '学生开始时看到的就是答案：请删去需要学生找出的部分。',
    noSolution: '页面上还没有程序，因此练习没有答案。',
    emptyTask: '练习是空的：请填写练习要求，或学生开始时看到的程序。',
    output: '复制内容',
    length: (n) => `${CHARACTERS.zh(n)}`,
    longer: '有些邮件和聊天软件会截断超过 2000 个字符的链接。',
    tooLong: (n, limit) =>
      `内容太长，无法做成链接：${CHARACTERS.zh(n)}，最多可读取 ${number('zh', limit)} 个。请改为保存文件。`,
    copy: '复制',
    copied: '已复制',
    notCopied: '浏览器不允许复制：文本已选中，请按 Ctrl C。',
    send: '发送…',
    qrName: '链接的二维码',
    qrTooLong: (n, limit) => `链接有 ${CHARACTERS.zh(n)}，二维码最多容纳 ${number('zh', limit)} 个，放不下。`,
    saveSvg: '保存为 SVG',
    savePng: '保存为 PNG',
    noPicture: '没有可保存的图片：程序尚未运行。',
    notMade: '生成失败。请关闭对话框后重试。',
  },
  ru: {
    title: 'Поделиться',
    about:
      'Всё находится в самой ссылке: программа, наладка, система ЧПУ и переключатели. На сервер ничего не отправляется.',
    as: 'Вид',
    forms: {
      link: 'Ссылка',
      markdown: 'Ссылка в Markdown',
      element: 'Живой пример для страницы (HTML)',
      frame: 'Фрейм для страницы (iframe)',
      qr: 'QR-код',
      picture: 'Рисунок',
    },
    view: 'Показать',
    views: { all: 'Всё', picture: 'Чертёж', playback: 'Чертёж с воспроизведением', code: 'Программу' },
    language: 'Открывать на русском',
    step: (motion) => `Инструмент там, где он сейчас (перемещение ${motion})`,
    readonly: 'Только для чтения',
    task: 'Как задание',
    solution: 'С решением: программой, которая сейчас на странице',
    solutionAbout: 'Решение открывается кнопкой задания: скрыто от глаз, но не секретно.',
    sentence: 'Что нужно сделать',
    start: 'С чего начинает ученик',
    startIsSolution: 'Ученик начинает с готового решения: уберите то, что нужно найти.',
    noSolution: 'На странице ещё нет программы, поэтому у задания нет решения.',
    emptyTask: 'Задание пустое: напишите, что нужно сделать или с чего начинает ученик.',
    output: 'Для копирования',
    length: (n) => `${CHARACTERS.ru(n)}`,
    longer: 'Некоторые почтовые программы и чаты обрезают ссылки длиннее 2000 знаков.',
    tooLong: (n, limit) =>
      `Для ссылки это слишком длинно: ${CHARACTERS.ru(n)}, а читается не более ${OF_CHARACTERS(limit)}. Сохраните программу в файл.`,
    copy: 'Копировать',
    copied: 'Скопировано',
    notCopied: 'Браузер не разрешает копирование: текст выделен, нажмите Ctrl C.',
    send: 'Отправить…',
    qrName: 'QR-код ссылки',
    qrTooLong: (n, limit) =>
      `Ссылка слишком длинна для QR-кода: ${CHARACTERS.ru(n)}, а вмещается ${number('ru', limit)}.`,
    saveSvg: 'Сохранить как SVG',
    savePng: 'Сохранить как PNG',
    noPicture: 'Сохранять нечего: программа не выполнена.',
    notMade: 'Не получилось. Закройте окно и попробуйте ещё раз.',
  },
});

export type ShareWords = (typeof SHARE_WORDS)[Language];
export { FORMS };
