// The list of problems under the editor.
//
// In: the diagnostics of the newest run. Out: the place the reader wants to see, the repairs the reader wants
// made: one, or all safe fixes at once. Must not know: what a diagnostic is about.

import { arrange, icon, make, prose, showText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { PROBLEM_WORDS } from '../editor/problem-words';
import { ruleLink } from '../editor/rule-link';
import type { Diagnostic, Fix } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { Key, Panel, PanelKind, Shell } from './panel';
import { countSafe, safeEdits } from './safe-fixes';
import problemsStyles from './problems.css?inline';

/** A program can have any number of problems; nobody reads more than these. */
const SHOWN = 200;

export const problems: PanelKind = { styles: problemsStyles, make: (shell) => new Problems(shell) };

/** A row of the list; an edit elsewhere moves its problem, and the row stays. */
interface Row {
  readonly element: HTMLLIElement;
  diagnostic: Diagnostic;
}

class Problems implements Panel {
  readonly #shell: Shell;
  readonly #toggle = make('button', { type: 'button', className: 'problems-toggle', 'aria-expanded': 'true' });
  readonly #fixSafe = make('button', { type: 'button', className: 'fix fix-safe' });
  readonly #title = make('span');
  readonly #count = make('span', { className: 'count' });
  readonly #more = make('li', { className: 'more' });
  /** By what they show: many can show the same. */
  #rows = new Map<string, Row[]>();
  readonly #list = make('ul', { className: 'problems-list', id: 'problems-list' });
  readonly #element = make(
    'section', { className: 'problems', part: 'problems' }, make('div', { className: 'problems-head' }, this.#toggle, this.#fixSafe), this.#list,
  );
  #diagnostics: readonly Diagnostic[] = [];
  readonly places = { problems: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#toggle.append(icon('chevron'), this.#title, this.#count);
    this.#toggle.setAttribute('aria-controls', this.#list.id);
    this.#toggle.addEventListener('click', () => this.#setOpen(this.#list.hidden === true));
    this.#fixSafe.addEventListener('click', () => this.#fix(safeEdits(this.#diagnostics)));
  }

  set language(_: Language) {
    this.#render();
  }

  heard(event: Heard): void {
    if (event.kind !== 'report') return;
    this.#diagnostics = event.report.diagnostics;
    this.#render();
  }

  pressed({ event }: Key): 'own' | 'not-own' {
    if (event.key !== 'F8') return 'not-own';
    this.#shell.editor.nextProblem(event.shiftKey ? 'previous' : 'next');
    return 'own';
  }

  #fix(edits: Fix['edits']): void {
    this.#shell.editor.apply(edits);
    // The button that was pressed goes with its problem.
    this.#shell.editor.focus();
  }

  /** A repair of the program, or a setting that answers the problem. */
  #make(fix: Fix | undefined): void {
    if (fix?.setting !== undefined) this.#shell.service('takeSetting')(fix.setting);
    else this.#fix(fix?.edits ?? []);
  }

  #setOpen(open: boolean): void {
    this.#list.hidden = !open;
    this.#toggle.setAttribute('aria-expanded', String(open));
  }

  #render(): void {
    const strings = WORDS[this.#shell.language];
    const count = this.#diagnostics.length;
    this.#element.hidden = count === 0;
    this.#element.setAttribute('aria-label', strings.problems);
    showText(this.#title, strings.problems);
    showText(this.#count, String(count));
    const safe = countSafe(this.#diagnostics);
    this.#fixSafe.hidden = safe === 0;
    showText(this.#fixSafe, strings.fixSafe(safe));
    this.#fixSafe.title = strings.fixSafeHelp;
    const rows = this.#diagnostics.slice(0, SHOWN).map((diagnostic) => this.#row(diagnostic));
    this.#rows = new Map();
    for (const row of rows) {
      const shows = this.#shows(row.diagnostic);
      const same = this.#rows.get(shows);
      if (same === undefined) this.#rows.set(shows, [row]);
      else same.push(row);
    }
    showText(this.#more, strings.moreProblems(count - SHOWN));
    arrange(this.#list, [...rows.map(({ element }) => element), ...(count > SHOWN ? [this.#more] : [])]);
  }

  /** All that a row shows. */
  #shows({ severity, kind, code, slug, alarm, message, line, column, fixes }: Diagnostic): string {
    return JSON.stringify([this.#shell.language, severity, kind, code, slug, alarm, message, line, column, ...fixes.map(({ title }) => title)]);
  }

  /** The row that shows this already, or another one. */
  #row(diagnostic: Diagnostic): Row {
    const known = this.#rows.get(this.#shows(diagnostic))?.shift();
    if (known === undefined) return this.#made(diagnostic);
    known.diagnostic = diagnostic;
    return known;
  }

  #made(diagnostic: Diagnostic): Row {
    const { language } = this.#shell;
    const [strings, said] = [WORDS[language], PROBLEM_WORDS[language]];
    const title = said.severity[diagnostic.severity];
    const mark = icon(diagnostic.severity);
    const facts = [strings.place(diagnostic.line, diagnostic.column), said.kind[diagnostic.kind], diagnostic.alarm === diagnostic.code ? '' : diagnostic.code];
    if (diagnostic.alarm !== undefined) facts.push(said.alarm(diagnostic.alarm));
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
    button.addEventListener('click', () => this.#shell.editor.show(row.diagnostic));
    const fixes = diagnostic.fixes.map((fix, at) => {
      const repair = make('button', { type: 'button', className: 'fix' }, ...prose(strings.fix(fix.title)));
      repair.addEventListener('click', () => this.#make(row.diagnostic.fixes[at]));
      return repair;
    });
    const row: Row = { element: make('li', {}, button, ruleLink(diagnostic, language)), diagnostic };
    if (fixes.length > 0) row.element.append(make('div', { className: 'fixes' }, ...fixes));
    return row;
  }
}

const WORDS = words({
  en: {
    problems: 'Problems',
    moreProblems: (n: number) => `… and ${n} more`,
    fix: (title: string) => `Fix: ${title}`,
    /** All repairs that need no asking. */
    fixSafe: (n: number) => (n === 1 ? 'Apply 1 safe fix' : `Apply ${n} safe fixes`),
    fixSafeHelp: 'Fixes that do not change what the program does. Ctrl Z undoes them.',
    place: (line: number, column: number) => `line ${line}, column ${column}`,
  },
  zh: {
    problems: '问题',
    moreProblems: (n) => `……还有 ${n} 个`,
    fix: (title) => `修正：${title}`,
    fixSafe: (n) => `一次修正 ${n} 处（安全）`,
    fixSafeHelp: '不会改坏程序含义的修正。按 Ctrl Z 可撤销。',
    place: (line, column) => `第 ${line} 行第 ${column} 列`,
  },
  ru: {
    problems: 'Замечания',
    moreProblems: (n) => `… и ещё ${n}`,
    fix: (title) => `Исправить: ${title}`,
    fixSafe: (n) => `Исправить безопасные: ${n}`,
    fixSafeHelp: 'Исправления, которые не могут исказить смысл программы. Ctrl Z отменяет их.',
    place: (line, column) => `строка ${line}, столбец ${column}`,
  },
});
