// The list of problems under the editor.
//
// In: the diagnostics of the newest run. Out: `chosen` (the reader wants to see the place) and `fixed`
// (the reader wants a repair applied, or all safe ones at once). Must not know: the editor, or what a diagnostic is about.

import { icon, make, prose } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { Diagnostic, Fix } from '../protocol/protocol';
import { ruleLink } from '../editor/rule-link';
import { countSafe, safeEdits } from './safe-fixes';

/** A program can have any number of problems; nobody reads more than these. */
const SHOWN = 200;

export interface ProblemsEvents {
  chosen(diagnostic: Diagnostic): void;
  fixed(edits: Fix['edits']): void;
}

export class Problems {
  readonly element: HTMLElement;
  readonly #events: ProblemsEvents;
  readonly #toggle = make('button', { type: 'button', className: 'problems-toggle', 'aria-expanded': 'true' });
  readonly #fixSafe = make('button', { type: 'button', className: 'fix fix-safe' });
  readonly #list = make('ul', { className: 'problems-list', id: 'problems-list' });
  #strings: Strings;
  #diagnostics: readonly Diagnostic[] = [];

  constructor(strings: Strings, events: ProblemsEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#toggle.setAttribute('aria-controls', this.#list.id);
    this.#toggle.addEventListener('click', () => this.#setOpen(this.#list.hidden === true));
    this.#fixSafe.addEventListener('click', () => this.#events.fixed(safeEdits(this.#diagnostics)));
    const head = make('div', { className: 'problems-head' }, this.#toggle, this.#fixSafe);
    this.element = make('section', { className: 'problems', part: 'problems' }, head, this.#list);
    this.#render();
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.#render();
  }

  set diagnostics(diagnostics: readonly Diagnostic[]) {
    this.#diagnostics = diagnostics;
    this.#render();
  }

  #setOpen(open: boolean): void {
    this.#list.hidden = !open;
    this.#toggle.setAttribute('aria-expanded', String(open));
  }

  #render(): void {
    const strings = this.#strings;
    const count = this.#diagnostics.length;
    this.element.hidden = count === 0;
    this.element.setAttribute('aria-label', strings.problems);
    this.#toggle.replaceChildren(
      icon('chevron'),
      make('span', {}, strings.problems),
      make('span', { className: 'count' }, String(count)),
    );
    const safe = countSafe(this.#diagnostics);
    this.#fixSafe.hidden = safe === 0;
    this.#fixSafe.textContent = strings.fixSafe(safe);
    this.#fixSafe.title = strings.fixSafeHelp;
    const items = this.#diagnostics.slice(0, SHOWN).map((diagnostic) => this.#item(diagnostic));
    if (count > SHOWN) items.push(make('li', { className: 'more' }, strings.moreProblems(count - SHOWN)));
    this.#list.replaceChildren(...items);
  }

  #item(diagnostic: Diagnostic): HTMLLIElement {
    const strings = this.#strings;
    const title = strings.severity[diagnostic.severity];
    const mark = icon(diagnostic.severity);
    const facts = [strings.place(diagnostic.line, diagnostic.column), strings.kind[diagnostic.kind], diagnostic.alarm === diagnostic.code ? '' : diagnostic.code];
    if (diagnostic.alarm !== undefined) facts.push(strings.alarm(diagnostic.alarm));
    const button = make(
      'button',
      { type: 'button', className: `problem ${diagnostic.severity}` },
      mark,
      make('span', { className: 'unseen' }, `${title}: `),
      make(
        'span',
        { className: 'what' },
        make('span', { className: 'message' }, ...prose(diagnostic.message)),
        ' ',
        make('span', { className: 'facts' }, facts.filter((fact) => fact !== '').join(' · ')),
      ),
    );
    button.addEventListener('click', () => this.#events.chosen(diagnostic));
    const fixes = diagnostic.fixes.map((fix) => {
      const repair = make('button', { type: 'button', className: 'fix' }, ...prose(strings.fix(fix.title)));
      repair.addEventListener('click', () => this.#events.fixed(fix.edits));
      return repair;
    });
    const item = make('li', {}, button, ruleLink(diagnostic, strings.rules));
    if (fixes.length > 0) item.append(make('div', { className: 'fixes' }, ...fixes));
    return item;
  }
}
