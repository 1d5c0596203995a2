// Links to the pages of the rules and to the reference, which are built beside the page.
//
// In: a diagnostic. Out: a link to the page of its rule, in the reader's language. Also on another site the
// pages are where this module came from. Must not know: what a rule is about.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Diagnostic } from '../protocol/protocol';

/** The folder of the playground: modules stand in it, or in its `assets` (built) or `src` (not built). */
const HOME = import.meta.url.replace(/((assets|src(\/[^/]+)?)\/)?[^/]*$/, '');

const WORDS = words({
  en: { more: 'More', moreAbout: (message: string) => `More: ${message}`, all: 'All rules', reference: 'Documentation' },
  zh: { more: '详情', moreAbout: (message) => `详情：${message}`, all: '全部规则', reference: '文档（英文）' },
  ru: { more: 'Подробнее', moreAbout: (message) => `Подробнее: ${message}`, all: 'Все правила', reference: 'Документация (на английском)' },
});

export function ruleLink(diagnostic: Diagnostic, language: Language): HTMLAnchorElement {
  const link = linkTo(diagnostic.slug, WORDS[language].more, language);
  link.setAttribute('aria-label', WORDS[language].moreAbout(diagnostic.message.replaceAll('`', '')));
  return link;
}

export function allRulesLink(language: Language): HTMLAnchorElement {
  return linkTo('index', WORDS[language].all, language);
}

/** The reference is in English. */
export function referenceLink(language: Language): HTMLAnchorElement {
  return link('docs/index.html', WORDS[language].reference, 'en');
}

function linkTo(page: string, text: string, language: Language): HTMLAnchorElement {
  return link(`rules/${language}/${encodeURIComponent(page)}.html`, text, language);
}

function link(path: string, text: string, hreflang: string): HTMLAnchorElement {
  const href = new URL(path, HOME).href;
  return make('a', { className: 'rule-link', href, hreflang, target: '_blank', rel: 'noopener' }, text);
}
