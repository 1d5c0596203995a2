// Texts of saved programs: the notices over the element, and the dialog.

import { counter } from '../dom/plural';
import { words } from '../dom/words';

export const NEWS_WORDS = words({
  en: {
    messages: {
      'changed-elsewhere': 'This program was changed in another tab.',
      'both-kept': (name: string) =>
        `This program was changed in another tab, too. Both are kept: this one is now “${name}”.`,
      'deleted-elsewhere':
        'This program was deleted in another tab. The text stays here; with the next change it is in the list again.',
      full: 'The browser has no room left: the last changes are not kept. Save the program as a file, or delete programs that you no longer need.',
      refused: 'The browser does not keep programs for this page: save the program as a file.',
      'last-only': 'The browser keeps no list of programs for this page: only the last program will be here next time.',
      cleared: 'What the browser had kept for this page was deleted. This program is still here and is kept again.',
      'too-many':
        'The list of your programs is full: this program is not in it. Save it as a file, or delete programs that you no longer need.',
    },
    actions: {
      show: 'Show the other text',
      'keep-both': 'Keep both',
      'save-file': 'Save file',
      'open-list': 'My programs…',
    },
  },
  zh: {
    messages: {
      'changed-elsewhere': '此程序已在另一个标签页中被修改。',
      'both-kept': (name) => `此程序在另一个标签页中也被修改。两份都已保留：这一份现名为“${name}”。`,
      'deleted-elsewhere': '此程序已在另一个标签页中被删除。文本仍在这里；再次修改后会重新进入列表。',
      full: '浏览器存储空间已满：最近的修改未能保留。请将程序保存为文件，或删除不再需要的程序。',
      refused: '浏览器不允许此页面保留程序：请将程序保存为文件。',
      'last-only': '浏览器不允许此页面保留程序列表：下次打开时只有最后一个程序。',
      cleared: '浏览器为此页面保留的内容已被清除。此程序仍在这里，并已重新保留。',
      'too-many': '程序列表已满：此程序不在列表中。请将其保存为文件，或删除不再需要的程序。',
    },
    actions: { show: '显示另一份文本', 'keep-both': '两份都保留', 'save-file': '保存文件', 'open-list': '我的程序…' },
  },
  ru: {
    messages: {
      'changed-elsewhere': 'Эта программа изменена в другой вкладке.',
      'both-kept': (name) =>
        `Эта программа изменена и в другой вкладке. Сохранены обе: эта теперь называется «${name}».`,
      'deleted-elsewhere':
        'Эта программа удалена в другой вкладке. Текст остаётся здесь; после следующей правки он снова появится в списке.',
      full: 'В хранилище браузера нет места: последние правки не сохранены. Сохраните программу в файл или удалите ненужные программы.',
      refused: 'Браузер не хранит программы этой страницы: сохраните программу в файл.',
      'last-only':
        'Браузер не хранит список программ этой страницы: в следующий раз здесь будет только последняя программа.',
      cleared: 'То, что браузер хранил для этой страницы, удалено. Программа остаётся здесь и снова сохранена.',
      'too-many':
        'Список ваших программ заполнен: этой программы в нём нет. Сохраните её в файл или удалите ненужные программы.',
    },
    actions: {
      show: 'Показать другой текст',
      'keep-both': 'Оставить обе',
      'save-file': 'Сохранить в файл',
      'open-list': 'Мои программы…',
    },
  },
});

export const LIST_WORDS = words({
  en: {
    title: 'My programs',
    about:
      'Each program that you change, open or paste is kept in this browser, on this computer alone. Export them from time to time: browsers delete what they keep.',
    search: 'Search',
    count: counter('en', { one: 'program', other: 'programs' }),
    none: 'Nothing is kept yet: change an example, open a file or paste a program.',
    noneFound: 'No program matches.',
    notRead: 'The browser does not give access to the programs it keeps.',
    full: 'The browser has no room left: nothing was changed. Delete programs that you no longer need.',
    noName: 'Program without a name',
    open: 'Open',
    more: (name: string) => `Actions for ${name}`,
    actions: { rename: 'Rename', duplicate: 'Duplicate', states: 'Earlier states', delete: 'Delete' },
    newName: 'New name',
    confirmRename: 'Rename',
    deleted: (name: string) => `“${name}” was deleted.`,
    undo: 'Undo',
    tooMany: 'The list is full: delete programs that you no longer need.',
    exportAll: 'Export all',
    importAll: 'Import…',
    imported: (added: string, there: number) =>
      `Added: ${added}.${there === 0 ? '' : ` Already in the list: ${there}.`}`,
    noRoom: (n: number) => ` No room for ${n}: the list is full.`,
    unreadable: (n: number) => ` Not readable: ${n}.`,
    wrongFile: {
      'another-format':
        'This is not a file of programs from “Export all”. A single program is opened with “Open file”.',
      'newer-version': 'This file was made by a newer version of this page.',
      'too-large': 'This file is larger than 100 MB.',
    },
    statesOf: (name: string) => `Earlier states of ${name}`,
    statesAbout:
      'States of the last ten minutes are kept 15 seconds apart; then one for each ten minutes of a day, and one for each earlier day: at most 100, and 20 million characters.',
    noStates: 'There is no earlier state yet.',
    restore: 'Restore',
    length: counter('en', { one: 'character', other: 'characters' }),
    back: 'Back to the list',
    here: 'open now',
  },
  zh: {
    title: '我的程序',
    about: '您修改、打开或粘贴的每个程序都保留在本机的这个浏览器中。浏览器可能清除保留的内容，请不时导出。',
    search: '查找',
    count: counter('zh', { other: '个程序' }),
    none: '还没有保留的程序：请修改示例、打开文件或粘贴程序。',
    noneFound: '没有匹配的程序。',
    notRead: '浏览器不允许读取保留的程序。',
    full: '浏览器存储空间已满：未作任何更改。请删除不再需要的程序。',
    noName: '未命名的程序',
    open: '打开',
    more: (name) => `对“${name}”的操作`,
    actions: { rename: '重命名', duplicate: '复制', states: '历史版本', delete: '删除' },
    newName: '新名称',
    confirmRename: '重命名',
    deleted: (name) => `已删除“${name}”。`,
    undo: '撤销',
    tooMany: '列表已满：请删除不再需要的程序。',
    exportAll: '全部导出',
    importAll: '导入…',
    imported: (added, there) => `已添加：${added}。${there === 0 ? '' : `已在列表中：${there}。`}`,
    noRoom: (n) => `列表已满，未添加：${n}。`,
    unreadable: (n) => `无法读取：${n}。`,
    wrongFile: {
      'another-format': '这不是用“全部导出”生成的程序文件。单个程序请用“打开文件”打开。',
      'newer-version': '此文件由本页面的更新版本生成。',
      'too-large': '文件超过 100 MB。',
    },
    statesOf: (name) => `“${name}”的历史版本`,
    statesAbout:
      '最近十分钟内每隔 15 秒保留一个版本；一天之内每十分钟保留一个，更早的每天保留一个：最多 100 个、2000 万个字符。',
    noStates: '还没有历史版本。',
    restore: '恢复',
    length: counter('zh', { other: '个字符' }),
    back: '返回列表',
    here: '当前打开',
  },
  ru: {
    title: 'Мои программы',
    about:
      'Каждая программа, которую вы изменили, открыли или вставили, хранится в этом браузере, только на этом компьютере. Время от времени экспортируйте их: браузер может удалить то, что хранит.',
    search: 'Поиск',
    count: counter('ru', { one: 'программа', few: 'программы', many: 'программ', other: 'программы' }),
    none: 'Пока ничего нет: измените пример, откройте файл или вставьте программу.',
    noneFound: 'Подходящих программ нет.',
    notRead: 'Браузер не даёт доступа к сохранённым программам.',
    full: 'В хранилище браузера нет места: ничего не изменено. Удалите ненужные программы.',
    noName: 'Программа без имени',
    open: 'Открыть',
    more: (name) => `Действия с программой «${name}»`,
    actions: { rename: 'Переименовать', duplicate: 'Создать копию', states: 'Прежние версии', delete: 'Удалить' },
    newName: 'Новое имя',
    confirmRename: 'Переименовать',
    deleted: (name) => `Программа «${name}» удалена.`,
    undo: 'Отменить',
    tooMany: 'Список заполнен: удалите ненужные программы.',
    exportAll: 'Экспортировать все',
    importAll: 'Импорт…',
    imported: (added, there) => `Добавлено: ${added}.${there === 0 ? '' : ` Уже в списке: ${there}.`}`,
    noRoom: (n) => ` Список заполнен, не добавлено: ${n}.`,
    unreadable: (n) => ` Не прочитано: ${n}.`,
    wrongFile: {
      'another-format':
        'Это не файл программ из «Экспортировать все». Отдельную программу откройте кнопкой «Открыть файл».',
      'newer-version': 'Этот файл создан более новой версией страницы.',
      'too-large': 'Файл больше 100 МБ.',
    },
    statesOf: (name) => `Прежние версии программы «${name}»`,
    statesAbout:
      'Хранятся версии последних десяти минут с шагом в четверть минуты, затем по одной на каждые десять минут за сутки и по одной на каждый день раньше: не более 100 версий и 20 миллионов знаков.',
    noStates: 'Прежних версий пока нет.',
    restore: 'Восстановить',
    length: counter('ru', { one: 'знак', few: 'знака', many: 'знаков', other: 'знака' }),
    back: 'К списку',
    here: 'открыта сейчас',
  },
});
