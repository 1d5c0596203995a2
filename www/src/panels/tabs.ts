// The tabs of a narrow element: drawing, program, problems, state. The drawing is always visible; its tab gives it the
// whole element. If the element is wide enough, the style sheet hides the tabs, and they have no effect.
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

const TABS = ['drawing', 'program', 'problems', 'state'] as const;
type Tab = (typeof TABS)[number];

class Tabs implements Panel {
  readonly #row = make('div', { className: 'tab-list', role: 'tablist' });
  readonly #frame: HTMLElement;
  readonly #tabPanels: Readonly<Record<'written' | 'shown', HTMLElement>>;
  readonly #tabs: Readonly<Record<Tab, HTMLButtonElement>>;
  readonly #names: Readonly<Record<Tab, HTMLElement>> = {
    drawing: make('span'),
    program: make('span'),
    problems: make('span'),
    state: make('span'),
  };
  readonly #count = make('span', { className: 'count', hidden: true });
  /** Shown instead of an empty list of problems. */
  readonly #noProblems = make('p', { className: 'no-problems', hidden: true });
  #tab: Tab = 'program';
  readonly elements = { tabs: [this.#row], problems: [this.#noProblems] };

  constructor(shell: Shell) {
    this.#frame = shell.frame;
    this.#tabPanels = { written: this.#find('written'), shown: this.#find('shown') };
    const tab = (which: Tab): HTMLButtonElement => {
      const more = which === 'problems' ? [' ', this.#count] : [];
      const button = make(
        'button',
        { type: 'button', className: 'tab', role: 'tab', id: `tab-${which}` },
        this.#names[which],
        ...more,
      );
      button.setAttribute('aria-controls', which === 'drawing' ? 'shown' : 'written');
      button.addEventListener('click', () => this.#choose(which));
      button.addEventListener('keydown', (event) => this.#handleKey(event));
      return button;
    };
    this.#tabs = { drawing: tab('drawing'), program: tab('program'), problems: tab('problems'), state: tab('state') };
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

  #find(id: string): HTMLElement {
    const found = this.#frame.querySelector<HTMLElement>(`#${id}`);
    if (found === null) throw new Error(`the frame has no #${id}`);
    return found;
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

  /** The regions are tab panels only if the tabs are visible. */
  #showRoles(): void {
    const areTabs = this.#row.checkVisibility();
    for (const [id, panel] of Object.entries(this.#tabPanels)) {
      if (areTabs) {
        panel.setAttribute('role', 'tabpanel');
        panel.setAttribute(
          'aria-labelledby',
          `tab-${id === 'shown' || this.#tab === 'drawing' ? 'drawing' : this.#tab}`,
        );
      } else {
        panel.removeAttribute('role');
        panel.removeAttribute('aria-labelledby');
      }
    }
  }

  #handleKey(event: KeyboardEvent): void {
    const at = TABS.indexOf(this.#tab);
    const next = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: -1 }[event.key];
    const which = next === undefined ? undefined : TABS.at(next % TABS.length);
    if (which === undefined) return;
    this.#choose(which);
    this.#tabs[which].focus();
    this.#tabs[which].scrollIntoView({ block: 'nearest', inline: 'nearest' });
    event.preventDefault();
  }
}

const WORDS = words({
  en: {
    shown: 'What is shown',
    tabs: { drawing: 'Drawing', problems: 'Problems', state: 'State' },
    noProblems: 'No problems',
  },
  zh: {
    shown: '显示内容',
    tabs: { drawing: '图形', problems: '问题', state: '状态' },
    noProblems: '没有问题',
  },
  ru: {
    shown: 'Что показано',
    tabs: { drawing: 'Чертёж', problems: 'Замечания', state: 'Состояние' },
    noProblems: 'Замечаний нет',
  },
});
