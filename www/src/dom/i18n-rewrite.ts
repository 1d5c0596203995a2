// The words of "Write as a cycle". Part of i18n.ts, in a file of its own for its length.

export interface RewriteStrings {
  readonly button: string;
  readonly hint: string;
  readonly title: string;
  readonly about: string;
  readonly none: string;
  readonly lines: (first: number, last: number) => string;
  readonly take: string;
  readonly took: (cycle: string) => string;
}

export const rewriteStrings: { readonly en: RewriteStrings; readonly zh: RewriteStrings; readonly ru: RewriteStrings } = {
  en: {
    button: 'Write as a cycle…',
    hint: 'Write plain moves that form a G90, G92 or G94 as that cycle',
    title: 'Write as a cycle',
    about: 'Each of these was tried: the motions stay the same.',
    none: 'No plain moves of this program form a G90, G92 or G94: rapid in, cut, out, and rapid back to the start point, each in a block of its own with nothing else in it.',
    lines: (first, last) => `Lines ${first} to ${last}`,
    take: 'Write it so',
    took: (cycle) => `Written as ${cycle}; the motions are the same. Ctrl Z in the editor brings the moves back.`,
  },
  zh: {
    button: '写成循环…',
    hint: '将构成 G90、G92 或 G94 的普通移动指令写成该循环',
    title: '写成循环',
    about: '下列各项均已试运行：运动轨迹不变。',
    none: '此程序中没有构成 G90、G92 或 G94 的普通移动指令：快速进刀、切削、退刀、快速返回起点，各占一个程序段，且段内无其他指令。',
    lines: (first, last) => `第 ${first} 至 ${last} 行`,
    take: '改写',
    took: (cycle) => `已写成 ${cycle}，运动轨迹不变。在编辑器中按 Ctrl Z 可恢复原来的程序段。`,
  },
  ru: {
    button: 'Записать циклом…',
    hint: 'Записать простые перемещения, образующие G90, G92 или G94, этим циклом',
    title: 'Записать циклом',
    about: 'Каждая замена проверена: перемещения остаются теми же.',
    none: 'В этой программе нет простых перемещений, образующих G90, G92 или G94: быстрый подвод, резание, отвод и быстрый возврат в начальную точку, каждое в своём кадре, где больше ничего нет.',
    lines: (first, last) => `Строки ${first}–${last}`,
    take: 'Записать так',
    took: (cycle) => `Записано циклом ${cycle}, перемещения те же. Ctrl Z в редакторе вернёт прежние кадры.`,
  },
};
