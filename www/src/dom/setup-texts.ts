// The words of the setup form and of the line that leads to it, in English, Chinese and Russian.
//
// Fields are named by the interpreter. Must not know: what a setup may hold.

export interface SetupTexts {
  readonly setup: string;
  readonly about: string;
  /** Beside the button of the form, where no tools are given. */
  readonly toolsAssumed: string;
  /** The line above the drawing where no stock is given, and its button. */
  readonly stockAssumed: string;
  readonly useStock: string;
  /** In a field that is empty: what counts there. */
  readonly placeholder: (value: string) => string;
  readonly nothing: string;
  readonly source: { readonly program: string; readonly page: string; readonly nobody: string };
  readonly keep: string;
  readonly keepInProgram: string;
  readonly keepOnPage: string;
  readonly programFirst: string;
  readonly willMove: string;
  readonly apply: string;
  readonly clear: (group: string) => string;
  readonly clearShort: string;
  readonly another: string;
  readonly anotherHint: string;
  readonly add: string;
  readonly noTool: string;
  readonly slips: (n: number) => string;
  readonly kept: { readonly program: string; readonly page: string };
  /** The material is being taken off. */
  readonly part: (percent: number) => string;
}

export const setupTexts: { readonly en: SetupTexts; readonly zh: SetupTexts; readonly ru: SetupTexts } = {
  en: {
    setup: 'Setup',
    about: 'Stock, tools and machine. What is left empty is assumed, as the grey values say.',
    toolsAssumed: 'Tools assumed',
    stockAssumed: 'Stock assumed: collisions not checked',
    useStock: 'use this stock',
    placeholder: (value) => `${value} (assumed)`,
    nothing: '—',
    source: { program: 'in the program', page: 'on this page', nobody: 'assumed' },
    keep: 'Keep the setup',
    keepInProgram: 'in the program, as comments',
    keepOnPage: 'on this page',
    programFirst: 'Comments of the program go before the setup of the page.',
    willMove: 'The comments are taken out of the program.',
    apply: 'Apply',
    clear: (group) => `Clear: ${group}`,
    clearShort: 'Clear',
    another: 'Another tool',
    anotherHint: 'T0202',
    add: 'Add',
    noTool: 'Write T and up to four digits',
    slips: (n) => (n === 1 ? 'One value cannot be' : `${n} values cannot be`),
    kept: { program: 'The setup stands in the program now. Ctrl Z takes it out.', page: 'The setup is kept on this page.' },
    part: (percent) => `Part … ${percent} %`,
  },
  zh: {
    setup: '毛坯与刀具',
    about: '毛坯、刀具和机床。留空的项目按灰色的值假定。',
    toolsAssumed: '刀具为假定',
    stockAssumed: '毛坯为假定：未检查碰撞',
    useStock: '采用此毛坯',
    placeholder: (value) => `${value}（假定）`,
    nothing: '—',
    source: { program: '写在程序中', page: '保存在本页', nobody: '假定' },
    keep: '保存位置',
    keepInProgram: '写入程序注释',
    keepOnPage: '保存在本页',
    programFirst: '程序注释优先于本页的设置。',
    willMove: '程序中的这些注释将被删除。',
    apply: '应用',
    clear: (group) => `清除：${group}`,
    clearShort: '清除',
    another: '添加刀具',
    anotherHint: 'T0202',
    add: '添加',
    noTool: '请输入 T 和最多四位数字',
    slips: (n) => `有 ${n} 个值不正确`,
    kept: { program: '设置已写入程序。按 Ctrl Z 可撤销。', page: '设置已保存在本页。' },
    part: (percent) => `零件 … ${percent} %`,
  },
  ru: {
    setup: 'Наладка',
    about: 'Заготовка, инструменты и станок. Что не указано, принимается: это серые значения.',
    toolsAssumed: 'Инструменты приняты',
    stockAssumed: 'Заготовка принята: столкновения не ищутся',
    useStock: 'взять её',
    placeholder: (value) => `${value} (принято)`,
    nothing: '—',
    source: { program: 'в программе', page: 'на этой странице', nobody: 'принято' },
    keep: 'Хранить наладку',
    keepInProgram: 'в программе, в комментариях',
    keepOnPage: 'на этой странице',
    programFirst: 'Комментарии программы важнее наладки страницы.',
    willMove: 'Комментарии будут убраны из программы.',
    apply: 'Применить',
    clear: (group) => `Очистить: ${group}`,
    clearShort: 'Очистить',
    another: 'Ещё инструмент',
    anotherHint: 'T0202',
    add: 'Добавить',
    noTool: 'Напишите T и до четырёх цифр',
    slips: (n) => `Неверных значений: ${n}`,
    kept: { program: 'Наладка записана в программу. Ctrl Z убирает её.', page: 'Наладка хранится на этой странице.' },
    part: (percent) => `Деталь … ${percent} %`,
  },
};
