// Links to the pages of the rules and to the reference, which are built beside the page.
//
// In: a diagnostic. Out: a link to the page of its rule, in the reader's language. Also on another site the pages are
// where this module came from. Must not know: what a rule is about.

import { make } from '../dom/dom';
import type { RuleStrings } from '../dom/i18n-rules';
import type { Diagnostic } from '../protocol/protocol';

/** The folder of the playground: modules stand in it, or in its `assets` (built) or `src` (not built). */
const HOME = import.meta.url.replace(/((assets|src(\/[^/]+)?)\/)?[^/]*$/, '');

export function ruleLink(diagnostic: Diagnostic, strings: RuleStrings): HTMLAnchorElement {
  const link = linkTo(diagnostic.slug, strings.more, strings);
  link.setAttribute('aria-label', strings.moreAbout(diagnostic.message.replaceAll('`', '')));
  return link;
}

export function allRulesLink(strings: RuleStrings): HTMLAnchorElement {
  return linkTo('index', strings.all, strings);
}

export function referenceLink(strings: RuleStrings): HTMLAnchorElement {
  return link('docs/index.html', strings.reference, 'en');
}

function linkTo(page: string, text: string, { language }: RuleStrings): HTMLAnchorElement {
  return link(`rules/${language}/${encodeURIComponent(page)}.html`, text, language);
}

function link(path: string, text: string, hreflang: string): HTMLAnchorElement {
  const href = new URL(path, HOME).href;
  return make('a', { className: 'rule-link', href, hreflang, target: '_blank', rel: 'noopener' }, text);
}
