// Words of the links to the pages of the rules, in the three languages.

import type { Language } from './language';

export interface RuleStrings {
  /** The language the pages are read in. */
  readonly language: Language;
  readonly more: string;
  readonly moreAbout: (message: string) => string;
  readonly all: string;
  /** The reference, which is in English. */
  readonly reference: string;
}

export const ruleStrings: Readonly<Record<Language, RuleStrings>> = {
  en: { language: 'en', more: 'More', moreAbout: (message) => `More: ${message}`, all: 'All rules', reference: 'Documentation' },
  zh: { language: 'zh', more: '详情', moreAbout: (message) => `详情：${message}`, all: '全部规则', reference: '文档（英文）' },
  ru: { language: 'ru', more: 'Подробнее', moreAbout: (message) => `Подробнее: ${message}`, all: 'Все правила', reference: 'Документация (на английском)' },
};
