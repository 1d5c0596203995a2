// The texts of the page in all languages.
//
// Each panel has its texts in its own file; texts that several panels share are here. The interpreter translates the
// messages about a program. A text with a number is a function, so that each language forms its own plurals.

import type { Language } from './language';

export type Words<W> = Readonly<Record<Language, W>>;

/** A table in which texts may be missing. */
type DeepPartial<W> = W extends readonly unknown[] | ((...given: never[]) => unknown)
  ? W
  : W extends object
    ? { readonly [K in keyof W]?: DeepPartial<W[K]> }
    : W;

/**
 * A table of texts, with the same keys in each language. A text that is missing in a language is shown in English, and
 * `cargo xtask translations` lists it.
 */
export function words<W>(
  all: { readonly en: W } & Readonly<Partial<Record<Exclude<Language, 'en'>, DeepPartial<NoInfer<W>>>>>,
): Words<W> {
  return { en: all.en, zh: withFallback(all.en, all.zh), ru: withFallback(all.en, all.ru) };
}

function withFallback<W>(english: W, translated: DeepPartial<NoInfer<W>> | undefined): W {
  if (translated === undefined) return english;
  if (typeof english !== 'object' || english === null || Array.isArray(english)) return translated as W;
  const entries = Object.entries(english).map(
    ([name, text]) =>
      [name, withFallback<unknown>(text, (translated as Readonly<Record<string, unknown>>)[name])] as const,
  );
  return Object.fromEntries(entries) as W;
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
