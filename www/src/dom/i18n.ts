// Every word the page itself says, in English, Chinese and Russian.
//
// In: a language. Out: its table of strings; sentences with numbers are functions, so each language
// forms its own plurals. `Strings` is exhaustive: a missing translation is a type error.
// Must not know: the messages about a program; those come translated from the interpreter.

import type { FileFormat } from '../protocol/protocol';
import { setupTexts, type SetupTexts } from './setup-texts';
import { viewStrings, type ViewStrings } from './i18n-views';
import { rewriteStrings, type RewriteStrings } from './i18n-rewrite';
import { pasteStrings, type PasteStrings } from './i18n-paste';
import { playbackStrings, type PlaybackStrings } from './i18n-playback';
import { ruleStrings, type RuleStrings } from './i18n-rules';
import type { Language } from './language';
import { counter } from './plural';

export interface Strings {
  readonly languageName: string;
  // the editor and the problems
  readonly program: string;
  readonly hint: string;
  readonly problems: string;
  readonly noProblems: string;
  readonly problemCount: (n: number) => string;
  readonly moreProblems: (n: number) => string;
  readonly severity: { readonly error: string; readonly warning: string; readonly info: string };
  readonly kind: { readonly wrong: string; readonly unsupported: string; readonly machine: string };
  readonly alarm: (number: string) => string;
  readonly fix: (title: string) => string;
  /** All repairs that need no asking. */
  readonly fixSafe: (n: number) => string;
  readonly fixSafeHelp: string;
  readonly line: (n: number) => string;
  readonly place: (line: number, column: number) => string;
  // the status line
  readonly motions: (n: number) => string;
  readonly lines: (n: number) => string;
  readonly running: (percent: number) => string;
  readonly stopRun: string;
  readonly change: string;
  readonly changeDecimal: string;
  readonly loading: string;
  // the drawing
  readonly drawing: (motions: number) => string;
  readonly nothingToDraw: string;
  readonly fit: string;
  readonly zoomIn: string;
  readonly zoomOut: string;
  readonly rapid: string;
  readonly feed: string;
  readonly thread: string;
  readonly views: ViewStrings;
  readonly rewrite: RewriteStrings;
  readonly paste: PasteStrings;
  // playing
  readonly playback: string;
  readonly play: string;
  readonly pause: string;
  readonly playing: PlaybackStrings;
  readonly wholePath: string;
  readonly position: string;
  readonly positionText: (x: string, z: string) => string;
  readonly speed: string;
  // notices
  readonly dismiss: string;
  readonly loadFailed: (reason: string) => string;
  readonly stopped: string;
  readonly crashed: string;
  readonly setupRejected: (reason: string) => string;
  readonly opened: (name: string) => string;
  readonly openedAs: (name: string, encoding: string) => string;
  readonly openedBinary: (name: string) => string;
  readonly fileTooLarge: (name: string) => string;
  readonly fileUnreadable: (name: string) => string;
  readonly dropHere: string;
  // the file and the switches
  readonly encoding: string;
  readonly encodingHint: string;
  readonly rereadAs: (encoding: string) => string;
  readonly savedFromNowAs: (encoding: string) => string;
  readonly notThisEncoding: (name: string, chosen: string, present: string) => string;
  readonly noPlace: (character: string, chosen: string, present: string) => string;
  readonly savedAsUtf8: (name: string, encoding: string, character: string) => string;
  readonly blockSkip: string;
  readonly blockSkipHint: string;
  /** `mark` as it is written in a program: `/2`. */
  readonly blockSkipLevel: (mark: string) => string;
  readonly programToRun: string;
  // the program written out
  readonly writeOut: string;
  readonly writeOutHint: string;
  readonly writtenOut: string;
  readonly writtenOutAbout: string;
  readonly nothingToWriteOut: string;
  readonly copy: string;
  readonly copied: string;
  readonly copyYourself: string;
  readonly takeOver: string;
  readonly tookOver: string;
  // files for other programs, and the part as a body
  readonly exports: string;
  readonly exportOf: Readonly<Record<FileFormat, string>>;
  readonly noPartToExport: string;
  readonly solid: string;
  readonly solidHint: string;
  readonly solidTitle: string;
  readonly solidAbout: string;
  /** For who does not see it. */
  readonly solidView: string;
  readonly solidLoading: string;
  readonly solidNoPart: string;
  readonly solidNoWebGl: string;
  readonly solidReset: string;
  // the table of codes
  readonly codes: string;
  readonly codesAbout: (control: string) => string;
  readonly codesFilter: string;
  readonly codesFilterHint: string;
  readonly codesFound: (n: number) => string;
  readonly codesWhat: string;
  readonly codesGroup: string;
  // help
  readonly help: string;
  readonly helpTitle: string;
  readonly shortcuts: readonly (readonly [keys: string, what: string])[];
  readonly close: string;
  readonly setup: SetupTexts;
  readonly rules: RuleStrings;
  // the page around the element
  readonly page: {
    readonly title: string;
    readonly example: string;
    readonly ownProgram: string;
    readonly control: string;
    readonly language: string;
    readonly theme: string;
    readonly themes: { readonly auto: string; readonly light: string; readonly dark: string };
    readonly openFile: string;
    readonly saveFile: string;
    readonly settings: string;
    readonly restored: string;
    readonly startAfresh: string;
    readonly kept: string;
    readonly bringBack: string;
    readonly tooLongToKeep: string;
  };
}

const en: Strings = {
  languageName: 'English',
  program: 'Program',
  hint: 'Edit the program — the picture follows. Press ▶ to watch the tool.',
  problems: 'Problems',
  noProblems: 'no problems',
  problemCount: counter('en', { one: 'problem', other: 'problems' }),
  moreProblems: (n) => `… and ${n} more`,
  severity: { error: 'Error', warning: 'Warning', info: 'Note' },
  kind: { wrong: '', unsupported: 'not supported here', machine: 'depends on the machine' },
  alarm: (number) => `alarm ${number}`,
  fix: (title) => `Fix: ${title}`,
  fixSafe: (n) => (n === 1 ? 'Fix 1 safe one' : `Fix ${n} safe ones`),
  fixSafeHelp: 'Repairs that cannot change the meaning for the worse. Ctrl Z takes them back.',
  line: (n) => `line ${n}`,
  place: (line, column) => `line ${line}, column ${column}`,
  motions: counter('en', { one: 'motion', other: 'motions' }),
  lines: counter('en', { one: 'line', other: 'lines' }),
  running: (percent) => `Running … ${percent} %`,
  stopRun: 'Stop',
  change: 'change',
  changeDecimal: 'Change how numbers without a point are read',
  loading: 'Loading …',
  drawing: (n) =>
    `Drawing of the tool path, ${n} motions. Arrow keys move it, plus and minus zoom, F shows all of it.`,
  nothingToDraw: 'No motion yet. Write a move in the program, or choose an example.',
  fit: 'Show all (F)',
  zoomIn: 'Zoom in (+)',
  zoomOut: 'Zoom out (−)',
  rapid: 'rapid',
  feed: 'cutting',
  thread: 'thread',
  views: viewStrings.en,
  rewrite: rewriteStrings.en,
  paste: pasteStrings.en,
  playback: 'Playback',
  play: 'Play',
  pause: 'Pause',
  playing: playbackStrings.en,
  wholePath: 'Show the whole path',
  position: 'Position along the path',
  positionText: (x, z) => `X diameter ${x}, Z ${z}`,
  speed: 'Speed',
  dismiss: 'Dismiss',
  loadFailed: (reason) => `The interpreter could not be loaded (${reason}). Reload the page to try again.`,
  stopped: 'The run took too long and was stopped. Your program is still here: change it to run it again.',
  crashed: 'The interpreter failed on this program; that is our fault. Your program is still here: change it to run it again.',
  setupRejected: (reason) => `The setup was not accepted: ${reason}`,
  opened: (name) => `Opened ${name}`,
  openedAs: (name, encoding) => `Opened ${name} as ${encoding}. If it reads wrong, choose another encoding beside its name.`,
  openedBinary: (name) => `Opened ${name}. It does not look like a text; saved unchanged, its bytes stay the same.`,
  fileTooLarge: (name) => `${name} is larger than 64 MB and was not opened.`,
  fileUnreadable: (name) => `${name} could not be read.`,
  dropHere: 'Drop the program here',
  encoding: 'Encoding',
  encodingHint: 'The encoding the file is read in and saved in',
  rereadAs: (encoding) => `Read again as ${encoding}.`,
  savedFromNowAs: (encoding) => `The text stays as it is and will be saved as ${encoding}.`,
  notThisEncoding: (name, chosen, present) => `${name} is no ${chosen} text; it stays ${present}.`,
  noPlace: (character, chosen, present) => `${chosen} has no place for “${character}”; the file stays ${present}.`,
  savedAsUtf8: (name, encoding, character) => `${encoding} has no place for “${character}”: ${name} was saved as UTF-8.`,
  blockSkip: 'Block skip',
  blockSkipHint: 'When on, blocks marked with this slash are left out',
  blockSkipLevel: (mark) => `Block skip ${mark}`,
  programToRun: 'Program to run',
  writeOut: 'Write out',
  writeOutHint: 'Show the program with every cycle written out as plain moves',
  writtenOut: 'The program, written out',
  writtenOutAbout: 'Every cycle, corner and compensation as plain moves. The tool path is the same.',
  nothingToWriteOut: 'This program has nothing but plain moves: there is nothing to write out.',
  copy: 'Copy',
  copied: 'Copied',
  copyYourself: 'Copying is not allowed here. All of it is selected: press Ctrl C.',
  takeOver: 'Put into the editor',
  tookOver: 'The program is written out. Ctrl Z in the editor brings yours back.',
  exports: 'Export',
  exportOf: {
    card: 'Program card to print (HTML)', svg: 'Drawing (SVG)', png: 'Picture as shown (PNG)', csv: 'Motions as a table (CSV)',
    dxf: 'Profile of the part (DXF)', stl: 'Part as a solid (STL)', program: 'Program written out (NC)',
  },
  noPartToExport: 'There is no part to export: nothing is left of the blank, or it is not known.',
  solid: '3D',
  solidHint: 'Show the part as a solid, a quarter cut away',
  solidTitle: 'The part, a quarter cut away',
  solidAbout: 'Drag or arrow keys turn it, wheel or + and − zoom, Home brings the first view back. Ctrl Enter plays the program, F9 steps.',
  solidView: 'The turned part in three dimensions. Arrow keys turn it, plus and minus zoom, Home brings the first view back.',
  solidLoading: 'Loading …',
  solidNoPart: 'There is no part to show: nothing is left of the blank, or it is not known.',
  solidNoWebGl: 'This browser does not draw in three dimensions (WebGL is missing or switched off). The drawing shows the same part in section.',
  solidReset: 'First view',
  codes: 'Supported codes',
  codesAbout: (control) => `As ${control} writes them, then the other controls. – : this control has no such code.`,
  codesFilter: 'Filter',
  codesFilterHint: 'G92, thread …',
  codesFound: counter('en', { one: 'row', other: 'rows' }),
  codesWhat: 'What it does',
  codesGroup: 'Group',
  help: 'Help',
  helpTitle: 'Keys and gestures',
  shortcuts: [
    ['Ctrl Enter', 'play or pause'],
    ['F9  Shift F9', 'next or previous motion'],
    ['Ctrl F9  Ctrl Shift F9', 'next or previous block'],
    ['Alt F9  Alt Shift F9', 'next or previous pass of a cycle'],
    ['F8  Shift F8', 'next or previous problem'],
    ['Ctrl F', 'search in the program'],
    ['Alt Enter', 'write the moves at the cursor as a cycle'],
    ['Ctrl S', 'save the program as a file'],
    ['Ctrl Z  Ctrl Y', 'undo, redo'],
    ['Tab', 'leave the editor'],
    ['Arrow keys', 'move the drawing (when it has the focus)'],
    ['+  −  F', 'zoom in, zoom out, show all'],
    ['Drag, wheel, pinch', 'move and zoom the drawing'],
    ['Click on a stroke', 'select the block that made it'],
  ],
  close: 'Close',
  setup: setupTexts.en,
  rules: ruleStrings.en,
  page: {
    title: 'G-code playground',
    example: 'Example',
    ownProgram: 'My own program',
    control: 'Control',
    language: 'Language',
    theme: 'Theme',
    themes: { auto: 'As the system', light: 'Light', dark: 'Dark' },
    openFile: 'Open file',
    saveFile: 'Save file',
    settings: 'Settings',
    restored: 'Restored your last program',
    startAfresh: 'Start afresh',
    kept: 'Your last program is kept',
    bringBack: 'Bring it back',
    tooLongToKeep: 'This program is too long to be kept in the browser: save it as a file.',
  },
};

const zh: Strings = {
  languageName: '中文',
  program: '程序',
  hint: '修改程序，图形随之变化。按 ▶ 观看刀具运动。',
  problems: '问题',
  noProblems: '没有问题',
  problemCount: counter('zh', { other: '个问题' }),
  moreProblems: (n) => `……还有 ${n} 个`,
  severity: { error: '错误', warning: '警告', info: '提示' },
  kind: { wrong: '', unsupported: '此处不支持', machine: '取决于机床' },
  alarm: (number) => `报警 ${number}`,
  fix: (title) => `修正：${title}`,
  fixSafe: (n) => `一次修正 ${n} 处（安全）`,
  fixSafeHelp: '不会改坏程序含义的修正。按 Ctrl Z 可撤销。',
  line: (n) => `第 ${n} 行`,
  place: (line, column) => `第 ${line} 行第 ${column} 列`,
  motions: counter('zh', { other: '段运动' }),
  lines: counter('zh', { other: '行' }),
  running: (percent) => `正在运行…… ${percent} %`,
  stopRun: '停止',
  change: '更改',
  changeDecimal: '更改无小数点的数的读法',
  loading: '正在加载……',
  drawing: (n) => `刀具轨迹图，共 ${n} 段运动。方向键移动，加号和减号缩放，F 键显示全图。`,
  nothingToDraw: '还没有运动。请编写一段移动指令，或选择一个示例。',
  fit: '显示全图 (F)',
  zoomIn: '放大 (+)',
  zoomOut: '缩小 (−)',
  rapid: '快速移动',
  feed: '切削进给',
  thread: '螺纹切削',
  views: viewStrings.zh,
  rewrite: rewriteStrings.zh,
  paste: pasteStrings.zh,
  playback: '播放',
  play: '播放',
  pause: '暂停',
  playing: playbackStrings.zh,
  wholePath: '显示完整轨迹',
  position: '在轨迹上的位置',
  positionText: (x, z) => `X 直径 ${x}，Z ${z}`,
  speed: '速度',
  dismiss: '关闭提示',
  loadFailed: (reason) => `解释器加载失败（${reason}）。请刷新页面重试。`,
  stopped: '运行时间过长，已停止。您的程序仍在，修改后会重新运行。',
  crashed: '解释器处理此程序时出错，这是我们的问题。您的程序仍在，修改后会重新运行。',
  setupRejected: (reason) => `设置未被接受：${reason}`,
  opened: (name) => `已打开 ${name}`,
  openedAs: (name, encoding) => `已按 ${encoding} 打开 ${name}。如果显示为乱码，请在文件名旁选择其他编码。`,
  openedBinary: (name) => `已打开 ${name}。它不像文本文件；不作修改保存时，字节保持不变。`,
  fileTooLarge: (name) => `${name} 超过 64 MB，未打开。`,
  fileUnreadable: (name) => `无法读取 ${name}。`,
  dropHere: '将程序文件拖放到此处',
  encoding: '编码',
  encodingHint: '读取和保存此文件所用的编码',
  rereadAs: (encoding) => `已按 ${encoding} 重新读取。`,
  savedFromNowAs: (encoding) => `文本不变，将以 ${encoding} 保存。`,
  notThisEncoding: (name, chosen, present) => `${name} 不是 ${chosen} 文本，仍为 ${present}。`,
  noPlace: (character, chosen, present) => `${chosen} 中没有“${character}”，文件仍为 ${present}。`,
  savedAsUtf8: (name, encoding, character) => `${encoding} 中没有“${character}”：${name} 已改用 UTF-8 保存。`,
  blockSkip: '程序段跳过',
  blockSkipHint: '打开后，跳过带此斜杠的程序段',
  blockSkipLevel: (mark) => `程序段跳过 ${mark}`,
  programToRun: '要运行的程序',
  writeOut: '展开循环',
  writeOutHint: '显示将所有循环展开为普通移动指令后的程序',
  writtenOut: '展开后的程序',
  writtenOutAbout: '循环、倒角和刀尖补偿均已写成普通移动指令，刀具轨迹不变。',
  nothingToWriteOut: '此程序只有普通移动指令，没有可展开的内容。',
  copy: '复制',
  copied: '已复制',
  copyYourself: '此处不允许自动复制。已全部选中，请按 Ctrl C。',
  takeOver: '放入编辑器',
  tookOver: '程序已展开。在编辑器中按 Ctrl Z 可恢复原程序。',
  exports: '导出',
  exportOf: {
    card: '可打印的程序卡 (HTML)', svg: '图形 (SVG)', png: '当前画面 (PNG)', csv: '运动列表 (CSV)',
    dxf: '零件轮廓 (DXF)', stl: '零件实体 (STL)', program: '展开后的程序 (NC)',
  },
  noPartToExport: '没有可导出的零件：毛坯已无剩余，或毛坯未知。',
  solid: '三维',
  solidHint: '以剖去四分之一的实体显示零件',
  solidTitle: '零件（剖去四分之一）',
  solidAbout: '拖动或方向键旋转，滚轮或 + − 缩放，Home 键恢复初始视角。Ctrl Enter 播放程序，F9 单步。',
  solidView: '车削零件的三维视图。方向键旋转，加号和减号缩放，Home 键恢复初始视角。',
  solidLoading: '正在加载……',
  solidNoPart: '没有可显示的零件：毛坯已无剩余，或毛坯未知。',
  solidNoWebGl: '此浏览器无法显示三维图形（缺少 WebGL 或已关闭）。平面图中可看到同一零件的剖面。',
  solidReset: '初始视角',
  codes: '支持的代码',
  codesAbout: (control) => `先列 ${control} 的写法，再列其他数控系统。– 表示该系统没有此代码。`,
  codesFilter: '筛选',
  codesFilterHint: 'G92、螺纹……',
  codesFound: counter('zh', { other: '行' }),
  codesWhat: '功能',
  codesGroup: '组',
  help: '帮助',
  helpTitle: '按键与手势',
  shortcuts: [
    ['Ctrl Enter', '播放或暂停'],
    ['F9  Shift F9', '下一段或上一段运动'],
    ['Ctrl F9  Ctrl Shift F9', '下一或上一程序段'],
    ['Alt F9  Alt Shift F9', '循环的下一次或上一次走刀'],
    ['F8  Shift F8', '下一个或上一个问题'],
    ['Ctrl F', '在程序中查找'],
    ['Alt Enter', '将光标处的移动写成循环'],
    ['Ctrl S', '将程序保存为文件'],
    ['Ctrl Z  Ctrl Y', '撤销、重做'],
    ['Tab', '离开编辑器'],
    ['方向键', '移动图形（图形获得焦点时）'],
    ['+  −  F', '放大、缩小、显示全图'],
    ['拖动、滚轮、双指', '移动和缩放图形'],
    ['单击线条', '选中生成它的程序段'],
  ],
  close: '关闭',
  setup: setupTexts.zh,
  rules: ruleStrings.zh,
  page: {
    title: 'G 代码演练场',
    example: '示例',
    ownProgram: '我的程序',
    control: '数控系统',
    language: '语言',
    theme: '主题',
    themes: { auto: '跟随系统', light: '浅色', dark: '深色' },
    openFile: '打开文件',
    saveFile: '保存文件',
    settings: '设置',
    restored: '已恢复您上次的程序',
    startAfresh: '重新开始',
    kept: '您上次的程序已保留',
    bringBack: '恢复',
    tooLongToKeep: '程序太长，浏览器无法保留：请保存为文件。',
  },
};

const ru: Strings = {
  languageName: 'Русский',
  program: 'Программа',
  hint: 'Меняйте программу — рисунок следует за ней. Нажмите ▶, чтобы увидеть движение резца.',
  problems: 'Замечания',
  noProblems: 'замечаний нет',
  problemCount: counter('ru', { one: 'замечание', few: 'замечания', other: 'замечаний' }),
  moreProblems: (n) => `… и ещё ${n}`,
  severity: { error: 'Ошибка', warning: 'Предупреждение', info: 'Примечание' },
  kind: { wrong: '', unsupported: 'здесь не поддерживается', machine: 'зависит от станка' },
  alarm: (number) => `сигнал ${number}`,
  fix: (title) => `Исправить: ${title}`,
  fixSafe: (n) => `Исправить безопасные: ${n}`,
  fixSafeHelp: 'Исправления, которые не могут исказить смысл программы. Ctrl Z отменяет их.',
  line: (n) => `строка ${n}`,
  place: (line, column) => `строка ${line}, столбец ${column}`,
  motions: counter('ru', { one: 'перемещение', few: 'перемещения', other: 'перемещений' }),
  lines: counter('ru', { one: 'строка', few: 'строки', other: 'строк' }),
  running: (percent) => `Выполняется … ${percent} %`,
  stopRun: 'Остановить',
  change: 'изменить',
  changeDecimal: 'Изменить чтение чисел без точки',
  loading: 'Загрузка …',
  drawing: (n) =>
    `Чертёж траектории, перемещений: ${n}. Стрелки сдвигают его, плюс и минус меняют масштаб, F показывает всё.`,
  nothingToDraw: 'Перемещений пока нет. Напишите кадр с перемещением или выберите пример.',
  fit: 'Показать всё (F)',
  zoomIn: 'Крупнее (+)',
  zoomOut: 'Мельче (−)',
  rapid: 'ускоренный ход',
  feed: 'рабочий ход',
  thread: 'резьба',
  views: viewStrings.ru,
  rewrite: rewriteStrings.ru,
  paste: pasteStrings.ru,
  playback: 'Воспроизведение',
  play: 'Пуск',
  pause: 'Пауза',
  playing: playbackStrings.ru,
  wholePath: 'Показать всю траекторию',
  position: 'Положение на траектории',
  positionText: (x, z) => `X диаметр ${x}, Z ${z}`,
  speed: 'Скорость',
  dismiss: 'Скрыть',
  loadFailed: (reason) => `Не удалось загрузить интерпретатор (${reason}). Обновите страницу.`,
  stopped: 'Выполнение длилось слишком долго и было остановлено. Программа сохранена: измените её, чтобы запустить снова.',
  crashed: 'Интерпретатор не справился с этой программой — это наша ошибка. Программа сохранена: измените её, чтобы запустить снова.',
  setupRejected: (reason) => `Наладка не принята: ${reason}`,
  opened: (name) => `Открыт файл ${name}`,
  openedAs: (name, encoding) => `Файл ${name} открыт в кодировке ${encoding}. Если текст нечитаем, выберите другую рядом с именем.`,
  openedBinary: (name) => `Открыт файл ${name}. Он не похож на текст; без правок его байты сохранятся без изменений.`,
  fileTooLarge: (name) => `Файл ${name} больше 64 МБ и не открыт.`,
  fileUnreadable: (name) => `Файл ${name} не читается.`,
  dropHere: 'Отпустите файл с программой здесь',
  encoding: 'Кодировка',
  encodingHint: 'Кодировка, в которой файл читается и сохраняется',
  rereadAs: (encoding) => `Прочитано заново в кодировке ${encoding}.`,
  savedFromNowAs: (encoding) => `Текст остаётся как есть и будет сохранён в кодировке ${encoding}.`,
  notThisEncoding: (name, chosen, present) => `Файл ${name} — не текст в кодировке ${chosen}; остаётся ${present}.`,
  noPlace: (character, chosen, present) => `В кодировке ${chosen} нет знака «${character}»; остаётся ${present}.`,
  savedAsUtf8: (name, encoding, character) => `В кодировке ${encoding} нет знака «${character}»: файл ${name} сохранён в UTF-8.`,
  blockSkip: 'Пропуск кадров',
  blockSkipHint: 'Если включено, кадры с этой косой чертой пропускаются',
  blockSkipLevel: (mark) => `Пропуск кадров ${mark}`,
  programToRun: 'Выполняемая программа',
  writeOut: 'Расписать',
  writeOutHint: 'Показать программу, в которой каждый цикл расписан простыми перемещениями',
  writtenOut: 'Расписанная программа',
  writtenOutAbout: 'Циклы, фаски, скругления и коррекция записаны простыми перемещениями. Траектория та же.',
  nothingToWriteOut: 'В этой программе только простые перемещения: расписывать нечего.',
  copy: 'Копировать',
  copied: 'Скопировано',
  copyYourself: 'Копирование здесь запрещено. Текст выделен: нажмите Ctrl C.',
  takeOver: 'Поместить в редактор',
  tookOver: 'Программа расписана. Ctrl Z в редакторе вернёт прежнюю.',
  exports: 'Экспорт',
  exportOf: {
    card: 'Карта программы для печати (HTML)', svg: 'Чертёж (SVG)', png: 'Рисунок, как на экране (PNG)', csv: 'Таблица перемещений (CSV)',
    dxf: 'Контур детали (DXF)', stl: 'Деталь как тело (STL)', program: 'Развёрнутая программа (NC)',
  },
  noPartToExport: 'Нечего экспортировать: от заготовки ничего не осталось, или она неизвестна.',
  solid: '3D',
  solidHint: 'Показать деталь как тело с вырезанной четвертью',
  solidTitle: 'Деталь с вырезом четверти',
  solidAbout: 'Перетаскивание и стрелки поворачивают, колесо или + и − меняют масштаб, Home возвращает первый вид. Ctrl Enter запускает программу, F9 — один шаг.',
  solidView: 'Точёная деталь в трёх измерениях. Стрелки поворачивают её, плюс и минус меняют масштаб, Home возвращает первый вид.',
  solidLoading: 'Загрузка …',
  solidNoPart: 'Нечего показать: от заготовки ничего не осталось, или она неизвестна.',
  solidNoWebGl: 'Этот браузер не показывает трёхмерную графику (WebGL отсутствует или выключен). На чертеже та же деталь видна в разрезе.',
  solidReset: 'Первый вид',
  codes: 'Поддерживаемые коды',
  codesAbout: (control) => `Сначала запись для ${control}, затем для других систем. – : такого кода в системе нет.`,
  codesFilter: 'Поиск',
  codesFilterHint: 'G92, резьба …',
  codesFound: counter('ru', { one: 'строка', few: 'строки', other: 'строк' }),
  codesWhat: 'Что делает',
  codesGroup: 'Группа',
  help: 'Справка',
  helpTitle: 'Клавиши и жесты',
  shortcuts: [
    ['Ctrl Enter', 'пуск или пауза'],
    ['F9  Shift F9', 'следующее или предыдущее перемещение'],
    ['Ctrl F9  Ctrl Shift F9', 'следующий или предыдущий кадр'],
    ['Alt F9  Alt Shift F9', 'следующий или предыдущий проход цикла'],
    ['F8  Shift F8', 'следующее или предыдущее замечание'],
    ['Ctrl F', 'поиск в программе'],
    ['Alt Enter', 'записать перемещения у курсора циклом'],
    ['Ctrl S', 'сохранить программу в файл'],
    ['Ctrl Z  Ctrl Y', 'отменить, вернуть'],
    ['Tab', 'выйти из редактора'],
    ['Стрелки', 'сдвинуть чертёж (когда он в фокусе)'],
    ['+  −  F', 'крупнее, мельче, показать всё'],
    ['Мышь, колесо, два пальца', 'сдвиг и масштаб чертежа'],
    ['Щелчок по линии', 'выделить её кадр'],
  ],
  close: 'Закрыть',
  setup: setupTexts.ru,
  rules: ruleStrings.ru,
  page: {
    title: 'Песочница G-кода',
    example: 'Пример',
    ownProgram: 'Моя программа',
    control: 'Система ЧПУ',
    language: 'Язык',
    theme: 'Тема',
    themes: { auto: 'Как в системе', light: 'Светлая', dark: 'Тёмная' },
    openFile: 'Открыть файл',
    saveFile: 'Сохранить',
    settings: 'Настройки',
    restored: 'Ваша последняя программа восстановлена',
    startAfresh: 'Начать заново',
    kept: 'Ваша последняя программа сохранена',
    bringBack: 'Вернуть',
    tooLongToKeep: 'Программа слишком длинная, браузер её не сохранит: сохраните её в файл.',
  },
};

const TABLES: Readonly<Record<Language, Strings>> = { en, zh, ru };

export function strings(language: Language): Strings {
  return TABLES[language];
}
