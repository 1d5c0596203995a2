// The words of the page in all its languages.
//
// Each panel has its own, in its file; here are those that several use. The messages about a
// program come translated from the interpreter. Sentences with numbers are functions, so that each
// language forms its own plurals.

import type { Language } from './language';

export type Words<W> = Readonly<Record<Language, W>>;

/** A table of words: what is there in English has to be there in each language, in the same form. */
export function words<W>(all: { readonly en: W } & Readonly<Record<Exclude<Language, 'en'>, NoInfer<W>>>): Words<W> {
  return all;
}

export const COMMON = words({
  en: {
    close: 'Close',
    line: (n: number) => `line ${n}`,
    dropHere: 'Drop the program here',
    program: 'Program',
    rapid: 'rapid',
  },
  zh: {
    close: '关闭',
    line: (n) => `第 ${n} 行`,
    dropHere: '将程序文件拖放到此处',
    program: '程序',
    rapid: '快速移动',
  },
  ru: {
    close: 'Закрыть',
    line: (n) => `строка ${n}`,
    dropHere: 'Отпустите файл с программой здесь',
    program: 'Программа',
    rapid: 'ускоренный ход',
  },
});
