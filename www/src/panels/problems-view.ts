// Filter and order of the problems: the row of choices over the list.
//
// In: the diagnostics of the newest run. Out: the user's choices. Must not know: how the problems are shown.

import { setChildren, icon, make, setAccessibleName, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Diagnostic } from '../protocol/protocol';
import { countsByRule, SEVERITIES, type Order, type Severity, type ProblemFilter } from './problem-groups';

/** A shorter list needs no filters. */
const MIN_PROBLEMS_FOR_FILTERS = 10;

interface Toggle {
  readonly button: HTMLButtonElement;
  readonly count: HTMLElement;
}

export class ProblemsView {
  readonly #toggles: Readonly<Record<Severity, Toggle>>;
  readonly #order = make('select', { className: 'small' });
  readonly #rule = make('select', { className: 'small' });
  readonly #severityGroup = make('span', { className: 'severities', role: 'group' });
  readonly #hiddenSeverities = new Set<Severity>();
  #chosenRule: string | undefined;
  /** The current options as text: an unchanged list is not rebuilt, because the user may have opened it. */
  #options = '';
  readonly element = make('div', { className: 'problems-view' }, this.#severityGroup, this.#order, this.#rule);

  constructor(onChange: () => void) {
    const toggle = (severity: Severity): Toggle => {
      const count = make('span');
      const button = make(
        'button',
        { type: 'button', className: `problem-severity ${severity}`, 'aria-pressed': 'true' },
        icon(severity),
        count,
      );
      button.addEventListener('click', () => {
        if (!this.#hiddenSeverities.delete(severity)) this.#hiddenSeverities.add(severity);
        button.setAttribute('aria-pressed', String(!this.#hiddenSeverities.has(severity)));
        onChange();
      });
      return { button, count };
    };
    this.#toggles = { error: toggle('error'), warning: toggle('warning'), info: toggle('info') };
    this.#order.addEventListener('change', onChange);
    this.#rule.addEventListener('change', () => {
      this.#chosenRule = this.#rule.value === '' ? undefined : this.#rule.value;
      onChange();
    });
  }

  get filter(): ProblemFilter {
    return {
      order: this.#order.value === 'place' ? 'place' : 'severity',
      hiddenSeverities: this.#hiddenSeverities,
      rule: this.#chosenRule,
    };
  }

  render(language: Language, diagnostics: readonly Diagnostic[]): void {
    const texts = WORDS[language];
    this.#severityGroup.setAttribute('aria-label', texts.severities);
    this.#order.setAttribute('aria-label', texts.order);
    this.#rule.setAttribute('aria-label', texts.rule);
    const counts = new Map<Severity, number>();
    for (const { severity } of diagnostics) counts.set(severity, (counts.get(severity) ?? 0) + 1);
    for (const severity of SEVERITIES) this.#show(severity, counts.get(severity) ?? 0, texts.count[severity]);
    // A severity that is switched off remains, so that it can be switched on again.
    const present = SEVERITIES.filter((severity) => counts.has(severity));
    const offered =
      present.length > 1 || this.#hiddenSeverities.size > 0
        ? SEVERITIES.filter((severity) => counts.has(severity) || this.#hiddenSeverities.has(severity))
        : [];
    setChildren(
      this.#severityGroup,
      offered.map((severity) => this.#toggles[severity].button),
    );
    const rules = countsByRule(diagnostics);
    if (this.#chosenRule !== undefined && !rules.has(this.#chosenRule)) this.#chosenRule = undefined;
    this.#order.hidden = rules.size < 2;
    this.#rule.hidden = rules.size < 2;
    const isFiltered = this.#hiddenSeverities.size > 0 || this.#chosenRule !== undefined;
    const isLong = diagnostics.length >= MIN_PROBLEMS_FOR_FILTERS;
    this.element.hidden = !(isLong || isFiltered) || (offered.length === 0 && rules.size < 2);
    this.#renderOptions(language, rules);
  }

  #show(severity: Severity, count: number, label: (count: number) => string): void {
    const toggle = this.#toggles[severity];
    setText(toggle.count, String(count));
    if (toggle.button.title !== label(count)) setAccessibleName(toggle.button, label(count));
  }

  #renderOptions(language: Language, rules: ReadonlyMap<string, number>): void {
    const texts = WORDS[language];
    const options = JSON.stringify([language, ...rules]);
    if (options !== this.#options) {
      this.#options = options;
      const { filter } = this;
      const orders: readonly Order[] = ['severity', 'place'];
      this.#order.replaceChildren(...orders.map((order) => make('option', { value: order }, texts.orders[order])));
      this.#order.value = filter.order;
      const all = make('option', { value: '' }, texts.allRules);
      this.#rule.replaceChildren(
        all,
        ...[...rules].map(([slug, count]) => make('option', { value: slug }, `${slug} (${count})`)),
      );
    }
    this.#rule.value = this.#chosenRule ?? '';
  }
}

const WORDS = words({
  en: {
    severities: 'Severities that are shown',
    order: 'Order of the problems',
    orders: { severity: 'by severity', place: 'by place' },
    rule: 'Rule',
    allRules: 'all rules',
    count: {
      error: (n: number) => (n === 1 ? '1 error' : `${n} errors`),
      warning: (n: number) => (n === 1 ? '1 warning' : `${n} warnings`),
      info: (n: number) => (n === 1 ? '1 note' : `${n} notes`),
    },
  },
  zh: {
    severities: '显示的级别',
    order: '问题的顺序',
    orders: { severity: '按级别', place: '按位置' },
    rule: '规则',
    allRules: '所有规则',
    count: { error: (n) => `${n} 个错误`, warning: (n) => `${n} 个警告`, info: (n) => `${n} 个提示` },
  },
  ru: {
    severities: 'Какие замечания показаны',
    order: 'Порядок замечаний',
    orders: { severity: 'по важности', place: 'по месту' },
    rule: 'Правило',
    allRules: 'все правила',
    count: { error: (n) => `ошибок: ${n}`, warning: (n) => `предупреждений: ${n}`, info: (n) => `примечаний: ${n}` },
  },
});
