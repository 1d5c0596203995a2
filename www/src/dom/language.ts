// The languages of the page.
//
// In: the tag of a language. Out: the language that fits it best.

export const LANGUAGES = ['en', 'zh', 'ru'] as const;
export type Language = (typeof LANGUAGES)[number];

/** The best of our languages for a tag such as `zh-Hant-TW`; English when there is none. */
export function languageOf(tag: string | null | undefined): Language {
  const primary = (tag ?? '').toLowerCase().split('-')[0];
  return LANGUAGES.find((language) => language === primary) ?? 'en';
}
