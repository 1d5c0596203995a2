// The tabs of a narrow element, under the drawing: program, problems, explanation. If the element is wide enough, the
// style sheet hides the tabs, and they have no effect.
//
// In: the number of problems; the request to show the program. Out: `data-tab` of the frame, for the style sheet. Must
// not know: the size of the element, or the contents of a region.

import { make, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import tabsStyles from './tabs.css?inline';

export const tabs: PanelKind = { styles: tabsStyles, make: (shell) => new Tabs(shell) };

const TABS = ['program', 'problems', 'explain'] as const;
type Tab = (typeof TABS)[number];

class Tabs implements Panel {
  readonly #row = make('div', { className: 'tab-list', role: 'tablist' });
  readonly #frame: HTMLElement;
  readonly #shell: Shell;
  readonly #tabPanel: HTMLElement;
  readonly #tabs: Readonly<Record<Tab, HTMLButtonElement>>;
  readonly #names: Readonly<Record<Tab, HTMLElement>> = {
    program: make('span'),
    problems: make('span'),
    explain: make('span'),
  };
  readonly #count = make('span', { className: 'count', hidden: true });
  /** Shown instead of an empty list of problems. */
  readonly #noProblems = make('p', { className: 'no-problems', hidden: true });
  #tab: Tab = 'program';
  readonly elements = { tabs: [this.#row], problems: [this.#noProblems] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#frame = shell.frame;
    const written = this.#frame.querySelector<HTMLElement>('#written');
    if (written === null) throw new Error('the frame has no #written');
    this.#tabPanel = written;
    const tab = (which: Tab): HTMLButtonElement => {
      const more = which === 'problems' ? [' ', this.#count] : [];
      const button = make(
        'button',
        { type: 'button', className: 'tab', role: 'tab', id: `tab-${which}` },
        this.#names[which],
        ...more,
      );
      button.setAttribute('aria-controls', 'written');
      button.addEventListener('click', () => this.#open(which));
      button.addEventListener('keydown', (event) => this.#handleKey(event));
      return button;
    };
    this.#tabs = { program: tab('program'), problems: tab('problems'), explain: tab('explain') };
    this.#row.append(...Object.values(this.#tabs));
    this.#choose('program');
    // The style sheet decides whether there are tabs.
    new ResizeObserver(() => this.#showRoles()).observe(this.#row);
  }

  set language(language: Language) {
    const { shown, tabs, noProblems } = WORDS[language];
    this.#row.setAttribute('aria-label', shown);
    for (const which of TABS) setText(this.#names[which], which === 'program' ? COMMON[language].program : tabs[which]);
    setText(this.#noProblems, noProblems);
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    const { length } = event.report.diagnostics;
    setText(this.#count, String(length));
    this.#count.hidden = length === 0;
    this.#noProblems.hidden = length > 0;
  }

  onShowProgram(): void {
    this.#choose('program');
  }

  #open(chosen: Tab): void {
    this.#choose(chosen);
    if (chosen === 'explain') this.#shell.service('explain')();
  }

  #choose(chosen: Tab): void {
    this.#tab = chosen;
    this.#frame.dataset['tab'] = chosen;
    for (const which of TABS) {
      this.#tabs[which].setAttribute('aria-selected', String(which === chosen));
      this.#tabs[which].tabIndex = which === chosen ? 0 : -1;
    }
    this.#showRoles();
  }

  /** The region is a tab panel only if the tabs are visible. */
  #showRoles(): void {
    if (this.#row.checkVisibility()) {
      this.#tabPanel.setAttribute('role', 'tabpanel');
      this.#tabPanel.setAttribute('aria-labelledby', `tab-${this.#tab}`);
    } else {
      this.#tabPanel.removeAttribute('role');
      this.#tabPanel.removeAttribute('aria-labelledby');
    }
  }

  #handleKey(event: KeyboardEvent): void {
    const at = TABS.indexOf(this.#tab);
    const next = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: -1 }[event.key];
    const which = next === undefined ? undefined : TABS.at(next % TABS.length);
    if (which === undefined) return;
    this.#open(which);
    this.#tabs[which].focus();
    this.#tabs[which].scrollIntoView({ block: 'nearest', inline: 'nearest' });
    event.preventDefault();
  }
}

const WORDS = words({
  en: {
    shown: 'What is shown',
    tabs: { problems: 'Problems', explain: 'Explain' },
    noProblems: 'No problems',
  },
  zh: {
    shown: '显示内容',
    tabs: { problems: '问题', explain: '说明' },
    noProblems: '没有问题',
  },
  ru: {
    shown: 'Что показано',
    tabs: { problems: 'Замечания', explain: 'Пояснение' },
    noProblems: 'Замечаний нет',
  },
});
