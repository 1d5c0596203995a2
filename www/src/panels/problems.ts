// The list of problems under the editor.
//
// In: the diagnostics of the newest run, and the rules that are off. Out: the place to show; the fixes to apply, one or
// all safe ones; the rule to switch off. Problems of one rule with one code share a row, which lists their places. Must
// not know: the meaning of a diagnostic.

import { setChildren, icon, make, setAccessibleName, renderProse, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import { PROBLEM_WORDS } from '../editor/problem-words';
import { ruleLink } from '../editor/rule-link';
import type { Diagnostic, Fix } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Key, Panel, PanelKind, Shell, UserCommand } from './panel';
import { groupProblems, SEVERITIES, type Group } from './problem-groups';
import { ProblemsView } from './problems-view';
import { countSafeFixes, safeEdits } from './safe-fixes';
import problemsStyles from './problems.css?inline';

/** Most rows of the list; a program can have any number of problems. */
const MAX_ROWS = 200;
/** Places of a group that are shown until the user expands it. */
const MAX_COLLAPSED_PLACES = 10;

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
  /** "2 errors, 1 warning" over the program; opens and closes the list. */
  readonly #toggle = make('button', {
    type: 'button',
    className: 'problems-toggle',
    'aria-expanded': 'false',
    'aria-controls': 'problems',
  });
  readonly #counts = make('span', { className: 'problem-counts' });
  readonly #fixSafe = make('button', { type: 'button', className: 'fix fix-safe' });
  readonly #title = make('h2', { id: 'problems-name' });
  readonly #close = make('button', { type: 'button', className: 'close' }, icon('whole'));
  readonly #count = make('span', { className: 'count' });
  readonly #filterRow = new ProblemsView(() => this.#render());
  readonly #more = make('li', { className: 'more' });
  /** Rules that the setup switches off. */
  readonly #rulesOffRow = make('li', { className: 'more rules-off' });
  /** Rows by their content; several rows can have the same content. */
  #rows = new Map<string, Row[]>();
  /** Expanded groups, keyed by severity, code and rule. */
  readonly #expandedGroups = new Set<string>();
  readonly #list = make('ul', { className: 'problems-list', id: 'problems-list' });
  readonly #body = make('div', { className: 'problems-body' }, this.#filterRow.element, this.#list);
  readonly #element = make(
    // The caption distinguishes the name from that of another element on the page.
    'section',
    { className: 'problems', id: 'problems', part: 'problems', 'aria-labelledby': 'problems-name caption' },
    make('div', { className: 'problems-head' }, this.#title, this.#count, this.#fixSafe, this.#close),
    this.#body,
  );
  #diagnostics: readonly Diagnostic[] = [];
  /** Whether the problems of the program are known: not before the first report, and not after a run that failed. */
  #isKnown = false;
  #rulesOff: readonly string[] = [];
  #shownRulesOff = '';
  #shownCounts = '';
  /** Whether to open the list with the next report: the program is new. Typing never opens it. */
  #opensWithReport = true;
  readonly elements = { bar: [this.#toggle], problems: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#toggle.append(this.#counts);
    this.#toggle.addEventListener('click', () => this.#setOpen(!this.#isOpen));
    this.#close.addEventListener('click', () => {
      this.#setOpen(false);
      this.#toggle.focus();
    });
    this.#fixSafe.addEventListener('click', () => this.#applyEdits(safeEdits(this.#diagnostics)));
    this.#element.addEventListener('mousedown', (event) => {
      // The first click of a double click can remove its button; the second must not focus the button that takes its
      // place.
      if (event.detail > 1 && event.target instanceof Element && event.target.closest('button') !== null)
        event.preventDefault();
    });
  }

  get commands(): readonly UserCommand[] {
    const texts = WORDS[this.#shell.language];
    return [
      { name: texts.problems, run: () => this.#setOpen(!this.#isOpen) },
      { name: texts.nextProblem, keys: 'F8', run: () => this.#shell.editor.nextProblem('next') },
      { name: texts.previousProblem, keys: 'Shift F8', run: () => this.#shell.editor.nextProblem('previous') },
    ];
  }

  set language(_: Language) {
    this.#render();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    this.#isKnown = true;
    this.#setProblems(event.report.diagnostics, event.report.rulesOff);
    const { stage } = event.report;
    if (!this.#opensWithReport || stage === 'repeated') return;
    const isFaulty = this.#diagnostics.some(({ severity }) => severity !== 'info');
    if (isFaulty && !this.#isOpen) this.#setOpen(true);
    // The part, which is reported later, can have collisions.
    this.#opensWithReport = stage === 'path' && !isFaulty;
  }

  onProgramReplaced(by: 'host' | 'user'): void {
    if (by === 'host') this.#opensWithReport = true;
  }

  onTextInserted(): void {
    this.#opensWithReport = true;
  }

  onRunFailed(): void {
    this.#isKnown = false;
    this.#setProblems([], []);
  }

  #setProblems(diagnostics: readonly Diagnostic[], rulesOff: readonly string[]): void {
    this.#diagnostics = diagnostics;
    this.#rulesOff = rulesOff;
    const focused = this.#shell.root.activeElement;
    const hadFocus = this.#element.contains(focused);
    this.#render();
    // A focused button may have been removed with its problem.
    if (hadFocus && focused?.checkVisibility() === false) this.#shell.editor.focus();
  }

  onKey({ event }: Key): 'handled' | 'ignored' {
    if (event.key !== 'F8' || event.ctrlKey || event.metaKey || event.altKey) return 'ignored';
    this.#shell.editor.nextProblem(event.shiftKey ? 'previous' : 'next');
    return 'handled';
  }

  #applyEdits(edits: Fix['edits']): void {
    this.#shell.editor.applyFixes(edits);
    // The clicked button is removed with its problem.
    this.#shell.editor.focus();
  }

  /** Applies a fix: an edit of the program, or a setting. */
  #applyFix(fix: Fix | undefined): void {
    if (fix?.setting !== undefined) this.#shell.service('applySetting')(fix.setting);
    else this.#applyEdits(fix?.edits ?? []);
  }

  /** Hides or shows the messages of a rule. */
  #setRule(slug: string, level: 'off' | ''): void {
    this.#shell.service('applySetting')({ key: `rules.${slug}`, value: level });
    // The clicked button is removed.
    this.#toggle.focus();
  }

  get #isOpen(): boolean {
    return this.#element.classList.contains('open');
  }

  #setOpen(open: boolean): void {
    this.#element.classList.toggle('open', open);
    this.#toggle.setAttribute('aria-expanded', String(open));
    this.#shell.editor.scrollToCursor();
  }

  #renderCounts(): void {
    this.#toggle.hidden = !this.#isKnown;
    const strings = WORDS[this.#shell.language];
    const counts = SEVERITIES.map(
      (severity) => [severity, this.#diagnostics.filter((found) => found.severity === severity).length] as const,
    ).filter(([, count]) => count > 0);
    this.#toggle.disabled = counts.length === 0 && this.#rulesOff.length === 0;
    const key = JSON.stringify([this.#shell.language, counts]);
    if (key === this.#shownCounts) return;
    this.#shownCounts = key;
    this.#counts.replaceChildren(
      ...(counts.length === 0
        ? [`✓ ${strings.noProblems}`]
        : counts.map(([severity, count]) => make('span', { className: severity }, icon(severity), String(count)))),
    );
    const spoken = counts.map(([severity, count]) => strings.count[severity](count)).join(', ');
    const text = counts.length === 0 ? strings.noProblems : strings.problemsOf(spoken);
    setAccessibleName(this.#toggle, text);
  }

  #render(): void {
    const strings = WORDS[this.#shell.language];
    const count = this.#diagnostics.length;
    this.#element.hidden = count === 0 && this.#rulesOff.length === 0;
    if (this.#element.hidden && this.#isOpen) this.#setOpen(false);
    this.#renderCounts();
    setAccessibleName(this.#close, COMMON[this.#shell.language].close);
    setText(this.#title, strings.problems);
    const safe = countSafeFixes(this.#diagnostics);
    this.#fixSafe.hidden = safe === 0;
    setText(this.#fixSafe, strings.fixSafe(safe));
    this.#fixSafe.title = strings.fixSafeHelp;
    this.#filterRow.render(this.#shell.language, this.#diagnostics);
    const shownGroups = groupProblems(this.#diagnostics, this.#filterRow.filter);
    const shownCount = shownGroups.reduce((sum, group) => sum + group.length, 0);
    setText(this.#count, shownCount === count ? String(count) : strings.someOf(shownCount, count));
    const rows = shownGroups.slice(0, MAX_ROWS).map((group) => this.#row(group));
    this.#rows = new Map();
    for (const row of rows) {
      const key = this.#rowKey(row.group);
      const same = this.#rows.get(key);
      if (same === undefined) this.#rows.set(key, [row]);
      else same.push(row);
    }
    setText(this.#more, strings.moreProblems(shownGroups.length - MAX_ROWS));
    this.#renderRulesOff();
    setChildren(this.#list, [
      ...rows.map(({ element }) => element),
      ...(shownGroups.length > MAX_ROWS ? [this.#more] : []),
      ...(this.#rulesOff.length > 0 ? [this.#rulesOffRow] : []),
    ]);
  }

  #renderRulesOff(): void {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const shown = JSON.stringify([language, this.#rulesOff]);
    if (shown === this.#shownRulesOff) return;
    this.#shownRulesOff = shown;
    const buttons = this.#rulesOff.map((slug) => {
      const button = make('button', { type: 'button', className: 'fix' }, strings.showRule(slug));
      button.addEventListener('click', () => this.#setRule(slug, ''));
      return button;
    });
    this.#rulesOffRow.replaceChildren(strings.rulesOff(this.#rulesOff.length), ' ', ...buttons);
  }

  /** Everything a row shows, as a key. */
  #rowKey(group: Group): string {
    const [{ severity, kind, code, slug, alarm, message, line, column, fixes }] = group;
    const isExpanded = this.#expandedGroups.has(keyOf(group));
    const others =
      group.length === 1
        ? []
        : group
            .slice(1, isExpanded ? MAX_ROWS : MAX_COLLAPSED_PLACES)
            .map((other) => [other.line, other.column, other.message]);
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
      isExpanded,
      others,
    ]);
  }

  /** Reuses the row with the same content, or makes a new one. */
  #row(group: Group): Row {
    const reused = this.#rows.get(this.#rowKey(group))?.shift();
    if (reused === undefined) return this.#makeRow(group);
    reused.group = group;
    return reused;
  }

  #makeRow(group: Group): Row {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const [first] = group;
    const row: Row = { element: make('li'), group };
    row.element.append(this.#problemButton(row), ruleLink(first, language));
    if (first.severity !== 'error') row.element.append(this.#hideRuleButton(first.slug));
    if (group.length > 1) row.element.append(this.#otherPlaces(row));
    const fixes = first.fixes.map((fix, at) => {
      const fixButton = make('button', { type: 'button', className: 'fix' }, ...renderProse(strings.fix(fix.title)));
      fixButton.addEventListener('click', () => this.#applyFix(row.group[0].fixes[at]));
      return fixButton;
    });
    if (fixes.length > 0) row.element.append(make('div', { className: 'fixes' }, ...fixes));
    return row;
  }

  /** The first problem of a group; a click selects its place. */
  #problemButton(row: Row): HTMLButtonElement {
    const { language } = this.#shell;
    const [strings, labels] = [WORDS[language], PROBLEM_WORDS[language]];
    const [diagnostic] = row.group;
    const count = row.group.length;
    const facts = [
      strings.place(diagnostic.line, diagnostic.column),
      labels.kind[diagnostic.kind],
      diagnostic.alarm === diagnostic.code ? '' : diagnostic.code,
    ];
    if (diagnostic.alarm !== undefined) facts.push(labels.alarm(diagnostic.alarm));
    const button = make(
      'button',
      { type: 'button', className: `problem ${diagnostic.severity}` },
      icon(diagnostic.severity),
      make('span', { className: 'unseen' }, `${labels.severity[diagnostic.severity]}: `),
      make(
        'span',
        { className: 'what' },
        make('span', { className: 'message' }, ...renderProse(diagnostic.message)),
        ...(count > 1 ? [' ', make('span', { className: 'count' }, strings.times(count))] : []),
        ' ',
        make('span', { className: 'facts' }, facts.filter((fact) => fact !== '').join(' · ')),
      ),
    );
    button.addEventListener('click', () => this.#shell.chooseProblem(row.group[0]));
    return button;
  }

  #hideRuleButton(slug: string): HTMLButtonElement {
    const button = make('button', { type: 'button', className: 'hide-rule' }, icon('whole'));
    setAccessibleName(button, WORDS[this.#shell.language].hideRule(slug));
    button.addEventListener('click', () => this.#setRule(slug, 'off'));
    return button;
  }

  /** The other places of a group. */
  #otherPlaces(row: Row): HTMLElement {
    const { language } = this.#shell;
    const strings = WORDS[language];
    const { group } = row;
    const key = keyOf(group);
    const end = this.#expandedGroups.has(key) ? MAX_ROWS : MAX_COLLAPSED_PLACES;
    const places = group.slice(1, end).map((problem, at) => {
      const place = make(
        'button',
        { type: 'button', className: 'place', title: problem.message.replaceAll('`', '') },
        COMMON[language].line(problem.line) + placeIfDiffers(problem, group[0]),
      );
      place.addEventListener('click', () => {
        const chosen = row.group[at + 1];
        if (chosen !== undefined) this.#shell.chooseProblem(chosen);
      });
      return place;
    });
    const others = make('div', { className: 'other-places' }, strings.also, ...places);
    const rest = group.length - end;
    if (rest <= 0) return others;
    if (end === MAX_ROWS) {
      others.append(strings.moreProblems(rest));
      return others;
    }
    const all = make('button', { type: 'button', className: 'place' }, strings.morePlaces(rest));
    all.addEventListener('click', () => {
      this.#expandedGroups.add(key);
      this.#render();
      // The list was rendered again, so find the new row.
      const shown = this.#rows.get(this.#rowKey(row.group))?.[0];
      shown?.element.querySelectorAll<HTMLButtonElement>('.place')[MAX_COLLAPSED_PLACES - 1]?.focus();
    });
    others.append(all);
    return others;
  }
}

/** The position in a message, `X20 Z-40`, if the first message of the group has another one. */
function placeIfDiffers({ message }: Diagnostic, { message: first }: Diagnostic): string {
  const position = (text: string): string => (text.match(/\b[XZ]-?\d+(?:\.\d+)?/g) ?? []).join(' ');
  const own = position(message);
  return own === position(first) ? '' : ` (${own})`;
}

function keyOf([{ severity, code, slug }]: Group): string {
  return `${severity} ${code} ${slug}`;
}

const WORDS = words({
  en: {
    problems: 'Problems',
    nextProblem: 'Next problem',
    previousProblem: 'Previous problem',
    problemsOf: (counts: string) => `Problems: ${counts}`,
    noProblems: 'no problems',
    count: {
      error: counter('en', { one: 'error', other: 'errors' }),
      warning: counter('en', { one: 'warning', other: 'warnings' }),
      info: counter('en', { one: 'note', other: 'notes' }),
    },
    someOf: (seen: number, all: number) => `${seen} of ${all}`,
    moreProblems: (n: number) => `… and ${n} more`,
    /** Hides all messages of a rule while this setup is used. */
    hideRule: (slug: string) => `Hide this rule here: ${slug}`,
    rulesOff: (n: number) => (n === 1 ? '1 rule is hidden here:' : `${n} rules are hidden here:`),
    showRule: (slug: string) => `Show ${slug}`,
    times: (n: number) => `${n} places`,
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
    nextProblem: '下一个问题',
    previousProblem: '上一个问题',
    problemsOf: (counts) => `问题：${counts}`,
    noProblems: '没有问题',
    count: { error: (n) => `${n} 个错误`, warning: (n) => `${n} 个警告`, info: (n) => `${n} 条提示` },
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
    fixSafeHelp: '不改变程序动作的修正。按 Ctrl Z 可撤销。',
    place: (line, column) => `第 ${line} 行第 ${column} 列`,
  },
  ru: {
    problems: 'Замечания',
    nextProblem: 'Следующее замечание',
    previousProblem: 'Предыдущее замечание',
    problemsOf: (counts) => `Замечания: ${counts}`,
    noProblems: 'замечаний нет',
    count: {
      error: (n) => `ошибок: ${n}`,
      warning: (n) => `предупреждений: ${n}`,
      info: (n) => `пояснений: ${n}`,
    },
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
    fixSafeHelp: 'Исправления, которые не меняют действия программы. Ctrl Z отменяет их.',
    place: (line, column) => `строка ${line}, столбец ${column}`,
  },
});
