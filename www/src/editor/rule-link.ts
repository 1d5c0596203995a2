// Links to the pages of the rules, to the pages of the manual and to the reference, which are built beside the page.
//
// In: a diagnostic. Out: a link to the page of its rule, in the user's language. The pages are beside the origin of
// this module, even on another site, or in the folders named by the element's attributes `rules`, `docs` and `manual`: a
// bundler copies only the module. Must not know: the content of a rule.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Diagnostic } from '../protocol/protocol';
import { manualPageOf } from './manual-pages';

/** The folder of the playground: modules are in it, or in its subfolder `assets` (built) or `src` (development). */
const HOME = import.meta.url.replace(/((assets|src(\/[^/]+)?)\/)?[^/]*$/, '');

const WORDS = words({
  en: {
    more: 'More',
    moreAbout: (message: string) => `More: ${message}`,
    all: 'All rules',
    manual: 'Manual',
    reference: 'Reference for developers',
  },
  zh: {
    more: '详情',
    moreAbout: (message) => `详情：${message}`,
    all: '全部规则',
    manual: '手册',
    reference: '开发者参考（英文）',
  },
  ru: {
    more: 'Подробнее',
    moreAbout: (message) => `Подробнее: ${message}`,
    all: 'Все правила',
    manual: 'Руководство',
    reference: 'Справочник разработчика (на английском)',
  },
});

export function ruleLink(diagnostic: Diagnostic, language: Language): HTMLAnchorElement {
  const link = linkTo(diagnostic.slug, WORDS[language].more, language);
  link.setAttribute('aria-label', WORDS[language].moreAbout(diagnostic.message.replaceAll('`', '')));
  return link;
}

export function allRulesLink(language: Language): HTMLAnchorElement {
  return linkTo('index', WORDS[language].all, language);
}

/** The list of the pages of the manual. */
export function manualLink(language: Language): HTMLAnchorElement {
  return link('manual', `${language}/index.html`, WORDS[language].manual, language);
}

/** A page of the manual; `name`: its file without the ending. */
export function chapterLink(name: string, language: Language): HTMLAnchorElement {
  const made = link('manual', `${language}/${encodeURIComponent(name)}.html`, WORDS[language].manual, language);
  made.setAttribute('aria-label', `${WORDS[language].manual}: ${name}`);
  return made;
}

/** The page of a code of G-code system A; undefined if the manual has none. */
export function codeLink(code: string, language: Language): HTMLAnchorElement | undefined {
  const page = manualPageOf(code);
  if (page === undefined) return undefined;
  const made = link('manual', `${language}/${page}`, WORDS[language].manual, language);
  made.setAttribute('aria-label', `${WORDS[language].manual}: ${code}`);
  return made;
}

/** The reference exists in English only. */
export function referenceLink(language: Language): HTMLAnchorElement {
  return link('docs', 'index.html', WORDS[language].reference, 'en');
}

function linkTo(page: string, text: string, language: Language): HTMLAnchorElement {
  return link('rules', `${language}/${encodeURIComponent(page)}.html`, text, language);
}

function link(folder: 'rules' | 'docs' | 'manual', page: string, text: string, hreflang: string): HTMLAnchorElement {
  const href = new URL(`${folder}/${page}`, HOME).href;
  const made = make('a', { className: 'rule-link', href, hreflang, target: '_blank', rel: 'noopener' }, text);
  made.dataset.pages = folder;
  // These come before a click, a middle click and the context menu. Earlier, the link may not be in an element, whose
  // attributes it needs.
  for (const near of ['pointerenter', 'pointerdown', 'focus', 'click']) {
    made.addEventListener(near, () => (made.href = addressIn(made, folder, page) ?? href));
  }
  return made;
}

/** The address in the folder that the element's attribute names, if any. */
function addressIn(link: HTMLElement, folder: string, page: string): string | undefined {
  const root = link.getRootNode();
  const named = root instanceof ShadowRoot ? root.host.getAttribute(folder) : null;
  if (named === null || named === '') return undefined;
  try {
    const address = new URL(page, new URL(named.replace(/\/?$/, '/'), document.baseURI));
    return /^https?:$/.test(address.protocol) ? address.href : undefined;
  } catch {
    return undefined;
  }
}
