// The list of problems under the editor.
//
// In: the diagnostics of the newest run, and the rules that are off. Out: the place to show; the fixes to apply, one or
// all safe ones; the rule to switch off. Problems of one rule with one code share a row, which lists their places. Must
// not know: the meaning of a diagnostic.

import { arrange, icon, make, name, prose, showText } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import { PROBLEM_WORDS } from '../editor/problem-words';
import { ruleLink } from '../editor/rule-link';
import type { Diagnostic, Fix } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { Key, Panel, PanelKind, Shell } from './panel';
import { groups, type Group } from './problem-groups';
import { ProblemsView } from './problems-view';
import { countSafe, safeEdits } from './safe-fixes';
import problemsStyles from './problems.css?inline';

/** Most rows of the list; a program can have any number of problems. */
const SHOWN = 200;
/** Places of a group that are shown until the user expands it. */
const PLACES = 10;

export const problems: PanelKind = {
  control: 'problems',
  styles: problemsStyles,
  make: (shell) => new Problems(shell),
};

/** A row of the list. If an edit elsewhere moves its problems, the row is reused. */
interface Row {
  readonly element: HTMLLIElement;
  group: Group;
}

class Problems implements Panel {
  readonly #shell: Shell;
  readonly #toggle = make('button', { type: 'button', className: 'problems-toggle', 'aria-expanded': 'true' });
  readonly #fixSafe = make('button', { type: 'button', className: 'fix fix-safe' });
  readonly #title = make('span', { id: 'problems-name' });
  readonly #count = make('span', { className: 'count' });
  readonly #view = new ProblemsView(() => this.#render());
  readonly #more = make('li', { className: 'more' });
  /** Rules that the setup switches off. */
  readonly #off = make('li', { className: 'more rules-off' });
  /** Rows by their content; several rows can have the same content. */
  #rows = new Map<string, Row[]>();
  /** Expanded groups, keyed by severity, code and rule. */
  readonly #whole = new Set<string>();
  readonly #list = make('ul', { className: 'problems-list', id: 'problems-list' });
  readonly #body = make('div', { className: 'problems-body' }, this.#view.element, this.#list);
  readonly #element = make(
    // The caption distinguishes the name from that of another element on the page.
    'section',
    { className: 'problems', part: 'problems', 'aria-labelledby': 'problems-name caption' },
    make('div', { className: 'problems-head' }, this.#toggle, this.#fixSafe),
    this.#body,
  );
  #diagnostics: readonly Diagnostic[] = [];
  #rulesOff: readonly string[] = [];
  #offShown = '';
  readonly places = { problems: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#toggle.append(icon('chevron'), this.#title, this.#count);
    this.#toggle.setAttribute('aria-controls', this.#list.id);
    this.#toggle.addEventListener('click', () => this.#setOpen(this.#body.hidden === true));
    this.#fixSafe.addEventListener('click', () => this.#fix(safeEdits(this.#diagnostics)));
    this.#element.addEventListener('mousedown', (event) => {
      // The first click of a double click can remove its button; the second must not focus the button that takes its
      // place.
      if (event.detail > 1 && event.target instanceof Element && event.target.closest('button') !== null)
        event.preventDefault();
    });
  }

  set language(_: Language) {
    this.#render();
  }

  heard(event: Heard): void {
    if (event.kind === 'report') this.#put(event.report.diagnostics, event.report.rulesOff);
  }

  unreported(): void {
    this.#put([], []);
  }

  #put(diagnostics: readonly Diagnostic[], rulesOff: readonly string[]): void {
    this.#diagnostics = diagnostics;
    this.#rulesOff = rulesOff;
    const focused = this.#shell.root.activeElement;
    const isHere = this.#element.contains(focused);
    this.#render();
    // A focused button may have been removed with its problem.
    if (isHere && focused?.checkVisibility() === false) this.#shell.editor.focus();
  }

  pressed({ event }: Key): 'own' | 'not-own' {
    if (event.key !== 'F8' || event.ctrlKey || event.metaKey || event.altKey) return 'not-own';
    this.#shell.editor.nextProblem(event.shiftKey ? 'previous' : 'next');
    return 'own';
  }

  #fix(edits: Fix['edits']): void {
    this.#shell.editor.apply(edits);
    // The clicked button is removed with its problem.
    this.#shell.editor.focus();
  }

  /** Applies a fix: an edit of the program, or a setting. */
  #make(fix: Fix | undefined): void {
    if (fix?.setting !== undefined) this.#shell.service('takeSetting')(fix.setting);
    else this.#fix(fix?.edits ?? []);
  }

  /** Hides or shows the messages of a rule. */
  #set(slug: string, level: 'off' | ''): void {
    this.#shell.service('takeSetting')({ key: `rules.${slug}`, value: level });
    // The clicked button is removed.
    this.#toggle.focus();
  }

  #setOpen(open: boolean): void {
    this.#body.hidden = !open;
    this.#toggle.setAttribute('aria-expanded', String(open));
  }

  #render(): void {
    const strings = WORDS[this.#shell.language];
    const count = this.#diagnostics.length;
    this.#element.hidden = count === 0 && this.#rulesOff.length === 0;
    showText(this.#title, strings.problems);
    const safe = countSafe(this.#diagnostics);
    this.#fixSafe.hidden = safe === 0;
    showText(this.#fixSafe, strings.fixSafe(safe));
    this.#fixSafe.title = strings.fixSafeHelp;
    this.#view.render(this.#shell.language, this.#diagnostics);
    const wanted = groups(this.#diagnostics, this.#view.wanted);
    const seen = wanted.reduce((sum, group) => sum + group.length, 0);
    showText(this.#count, seen === count ? String(count) : strings.someOf(seen, count));
    const rows = wanted.slice(0, SHOWN).map((group) => this.#row(group));
    this.#rows = new Map();
    for (const row of rows) {
      const shows = this.#shows(row.group);
      const same = this.#rows.get(shows);
      if (same === undefined) this.#rows.set(shows, [row]);
      else same.push(row);
    }
    showText(this.#more, strings.moreProblems(wanted.length - SHOWN));
    this.#renderOff();
    arrange(this.#list, [
      ...rows.map(({ element }) => element),
      ...(wanted.length > SHOWN ? [this.#more] : []),
      ...(this.#rulesOff.length > 0 ? [this.#off] : []),
    ]);
  }

  #renderOff(): void {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const shown = JSON.stringify([language, this.#rulesOff]);
    if (shown === this.#offShown) return;
    this.#offShown = shown;
    const buttons = this.#rulesOff.map((slug) => {
      const button = make('button', { type: 'button', className: 'fix' }, strings.showRule(slug));
      button.addEventListener('click', () => this.#set(slug, ''));
      return button;
    });
    this.#off.replaceChildren(strings.rulesOff(this.#rulesOff.length), ' ', ...buttons);
  }

  /** Everything a row shows, as a key. */
  #shows(group: Group): string {
    const [{ severity, kind, code, slug, alarm, message, line, column, fixes }] = group;
    const whole = this.#whole.has(keyOf(group));
    const others =
      group.length === 1
        ? []
        : group.slice(1, whole ? SHOWN : PLACES).map((other) => [other.line, other.column, other.message]);
    const titles = fixes.map(({ title }) => title);
    return JSON.stringify([
      this.#shell.language,
      severity,
      kind,
      code,
      slug,
      alarm,
      message,
      line,
      column,
      titles,
      group.length,
      whole,
      others,
    ]);
  }

  /** Reuses the row with the same content, or makes a new one. */
  #row(group: Group): Row {
    const known = this.#rows.get(this.#shows(group))?.shift();
    if (known === undefined) return this.#made(group);
    known.group = group;
    return known;
  }

  #made(group: Group): Row {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const [first] = group;
    const row: Row = { element: make('li'), group };
    row.element.append(this.#problem(row), ruleLink(first, language));
    if (first.severity !== 'error') row.element.append(this.#hide(first.slug));
    if (group.length > 1) row.element.append(this.#others(row));
    const fixes = first.fixes.map((fix, at) => {
      const repair = make('button', { type: 'button', className: 'fix' }, ...prose(strings.fix(fix.title)));
      repair.addEventListener('click', () => this.#make(row.group[0].fixes[at]));
      return repair;
    });
    if (fixes.length > 0) row.element.append(make('div', { className: 'fixes' }, ...fixes));
    return row;
  }

  /** The first problem of a group; a click selects its place. */
  #problem(row: Row): HTMLButtonElement {
    const { language } = this.#shell;
    const [strings, said] = [WORDS[language], PROBLEM_WORDS[language]];
    const [diagnostic] = row.group;
    const count = row.group.length;
    const facts = [
      strings.place(diagnostic.line, diagnostic.column),
      said.kind[diagnostic.kind],
      diagnostic.alarm === diagnostic.code ? '' : diagnostic.code,
    ];
    if (diagnostic.alarm !== undefined) facts.push(said.alarm(diagnostic.alarm));
    const button = make(
      'button',
      { type: 'button', className: `problem ${diagnostic.severity}` },
      icon(diagnostic.severity),
      make('span', { className: 'unseen' }, `${said.severity[diagnostic.severity]}: `),
      make(
        'span',
        { className: 'what' },
        make('span', { className: 'message' }, ...prose(diagnostic.message)),
        ...(count > 1 ? [' ', make('span', { className: 'count' }, strings.times(count))] : []),
        ' ',
        make('span', { className: 'facts' }, facts.filter((fact) => fact !== '').join(' · ')),
      ),
    );
    button.addEventListener('click', () => this.#shell.chooseProblem(row.group[0]));
    return button;
  }

  #hide(slug: string): HTMLButtonElement {
    const button = make('button', { type: 'button', className: 'hide-rule' }, icon('whole'));
    name(button, WORDS[this.#shell.language].hideRule(slug));
    button.addEventListener('click', () => this.#set(slug, 'off'));
    return button;
  }

  /** The other places of a group. */
  #others(row: Row): HTMLElement {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const { group } = row;
    const key = keyOf(group);
    const end = this.#whole.has(key) ? SHOWN : PLACES;
    const places = group.slice(1, end).map((problem, at) => {
      const place = make(
        'button',
        { type: 'button', className: 'place', title: problem.message.replaceAll('`', '') },
        COMMON[language].line(problem.line),
      );
      place.addEventListener('click', () => {
        const chosen = row.group[at + 1];
        if (chosen !== undefined) this.#shell.chooseProblem(chosen);
      });
      return place;
    });
    const others = make('div', { className: 'other-places' }, strings.also, ...places);
    const left = group.length - end;
    if (left <= 0) return others;
    if (end === SHOWN) {
      others.append(strings.moreProblems(left));
      return others;
    }
    const all = make('button', { type: 'button', className: 'place' }, strings.morePlaces(left));
    all.addEventListener('click', () => {
      this.#whole.add(key);
      this.#render();
      // The list was rendered again, so find the new row.
      const shown = this.#rows.get(this.#shows(row.group))?.[0];
      shown?.element.querySelectorAll<HTMLButtonElement>('.place')[PLACES - 1]?.focus();
    });
    others.append(all);
    return others;
  }
}

function keyOf([{ severity, code, slug }]: Group): string {
  return `${severity} ${code} ${slug}`;
}

const WORDS = words({
  en: {
    problems: 'Problems',
    someOf: (seen: number, all: number) => `${seen} of ${all}`,
    moreProblems: (n: number) => `… and ${n} more`,
    /** Hides all messages of a rule while this setup is used. */
    hideRule: (slug: string) => `Hide this rule here: ${slug}`,
    rulesOff: (n: number) => (n === 1 ? '1 rule is hidden here:' : `${n} rules are hidden here:`),
    showRule: (slug: string) => `Show ${slug}`,
    times: (n: number) => `${n} times`,
    /** Before other places of the same problem. */
    also: 'also',
    morePlaces: (n: number) => `${n} more`,
    fix: (title: string) => `Fix: ${title}`,
    /** Applies all fixes that need no decision. */
    fixSafe: (n: number) => (n === 1 ? 'Apply 1 safe fix' : `Apply ${n} safe fixes`),
    fixSafeHelp: 'Fixes that do not change what the program does. Ctrl Z undoes them.',
    place: (line: number, column: number) => `line ${line}, column ${column}`,
  },
  zh: {
    problems: '问题',
    someOf: (seen, all) => `${seen} / ${all}`,
    moreProblems: (n) => `……还有 ${n} 个`,
    hideRule: (slug) => `此处不再显示这条规则：${slug}`,
    rulesOff: (n) => `此处隐藏了 ${n} 条规则：`,
    showRule: (slug) => `显示 ${slug}`,
    times: (n) => `${n} 处`,
    also: '另见',
    morePlaces: (n) => `还有 ${n} 处`,
    fix: (title) => `修正：${title}`,
    fixSafe: (n) => `一次修正 ${n} 处（安全）`,
    fixSafeHelp: '不会改坏程序含义的修正。按 Ctrl Z 可撤销。',
    place: (line, column) => `第 ${line} 行第 ${column} 列`,
  },
  ru: {
    problems: 'Замечания',
    someOf: (seen, all) => `${seen} из ${all}`,
    moreProblems: (n) => `… и ещё ${n}`,
    hideRule: (slug) => `Не показывать здесь это правило: ${slug}`,
    rulesOff: (n) => `Скрыто здесь правил: ${n}.`,
    showRule: (slug) => `Показать ${slug}`,
    times: (n) => `мест: ${n}`,
    also: 'ещё',
    morePlaces: (n) => `ещё ${n}`,
    fix: (title) => `Исправить: ${title}`,
    fixSafe: (n) => `Исправить безопасные: ${n}`,
    fixSafeHelp: 'Исправления, которые не могут исказить смысл программы. Ctrl Z отменяет их.',
    place: (line, column) => `строка ${line}, столбец ${column}`,
  },
});
