// The popover with keys and gestures, and the ways to the table of codes, to the pages of the rules and to the reference.
//
// In: the language's strings. Out: an element with `toggle`; `codesWanted`. Must not know: who answers to the keys.

import { make, name } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import { allRulesLink, referenceLink } from '../editor/rule-link';

export class Help {
  readonly button = make('button', { type: 'button', className: 'help-button quiet', 'aria-haspopup': 'dialog' }, '?');
  readonly element = make('div', { className: 'help', part: 'help', role: 'dialog', popover: 'auto' });

  readonly #codesWanted: () => void;

  constructor(strings: Strings, codesWanted: () => void) {
    this.#codesWanted = codesWanted;
    this.button.popoverTargetElement = this.element;
    this.strings = strings;
  }

  set strings(strings: Strings) {
    name(this.button, `${strings.help} (?)`);
    this.element.setAttribute('aria-label', strings.helpTitle);
    const close = make('button', { type: 'button', className: 'quiet close' }, '×');
    name(close, strings.close);
    close.addEventListener('click', () => this.element.hidePopover());
    const keys = make('dl');
    for (const [pressed, what] of strings.shortcuts) {
      const term = make('dt');
      for (const [i, key] of pressed.split('  ').entries()) term.append(i > 0 ? ' ' : '', make('kbd', {}, key));
      keys.append(term, make('dd', {}, what));
    }
    const codes = make('button', { type: 'button', className: 'framed', 'aria-haspopup': 'dialog' }, strings.codes);
    codes.addEventListener('click', () => {
      this.element.hidePopover();
      // The dialog gives the focus back to where it was.
      this.button.focus();
      this.#codesWanted();
    });
    this.element.replaceChildren(make('h2', {}, strings.helpTitle), close, make('div', { className: 'further' }, codes, allRulesLink(strings.rules), referenceLink(strings.rules)), keys);
  }

  toggle(): void {
    this.element.togglePopover();
  }
}
