// The dialog with the table of supported codes, the selected control's column first, and a filter field.
//
// In: the rows, as the interpreter answers them. Must not know: the meaning of a code.

import { Dialog } from '../dom/dialog';
import { make, renderProse } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { COMMON, words } from '../dom/words';
import { codeLink } from '../editor/rule-link';
import type { CodeRow, Codes } from '../protocol/protocol';
import type { Panel, PanelKind, Services, Shell } from './panel';
import codesStyles from './codes.css?inline';

/** A row of the table, with the lower-case text that the filter searches. */
interface Row {
  readonly element: HTMLElement;
  readonly body: HTMLElement;
  readonly codes: readonly string[];
  readonly words: string;
}

export const codes: PanelKind = { control: 'help', styles: codesStyles, make: (shell) => new CodesPanel(shell) };

class CodesPanel implements Panel {
  readonly #shell: Shell;
  readonly #caption = make('span');
  readonly #filter = make('input', { type: 'search', autocomplete: 'off', spellcheck: false });
  readonly #found = make('span', { className: 'found', role: 'log' });
  readonly #table = make('table', { 'aria-labelledby': 'codes-title' });
  readonly #text = make(
    'div',
    { className: 'text', tabIndex: 0, role: 'region', 'aria-labelledby': 'codes-title' },
    this.#table,
  );
  readonly #dialog = new Dialog('codes', [
    make('label', { className: 'find' }, this.#caption, this.#filter, this.#found),
    this.#text,
  ]);
  #rows: readonly Row[] = [];
  readonly elements = { dialogs: [this.#dialog.element] };
  readonly services: Partial<Services> = { openCodes: () => void this.#open() };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#filter.addEventListener('input', () => this.#find());
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.codes, COMMON[language].close);
    this.#caption.textContent = texts.codesFilter;
    this.#filter.placeholder = texts.codesFilterHint;
    if (this.#dialog.open) void this.#open();
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  async #open(): Promise<void> {
    const codes = await this.#shell.ask('codes', undefined);
    if (codes !== undefined) this.#show(codes);
  }

  #show({ columns, rows }: Codes): void {
    const [first, ...others] = columns;
    if (first === undefined) return;
    this.#dialog.about = WORDS[this.#shell.language].codesAbout(first.name);
    const heading = (text: string, className = ''): HTMLElement => make('th', { scope: 'col', className }, text);
    const head = make(
      'tr',
      {},
      heading(first.name),
      heading(WORDS[this.#shell.language].codesWhat),
      ...others.map(({ name }) => heading(name, 'other')),
      heading(WORDS[this.#shell.language].codesGroup, 'group'),
    );
    const bodies = new Map<string, HTMLElement>();
    this.#rows = rows.map((row) => {
      let body = bodies.get(row.section);
      if (body === undefined) {
        const title = make('th', { scope: 'rowgroup', colSpan: columns.length + 2, className: 'section' }, row.section);
        body = make('tbody', {}, make('tr', {}, title));
        bodies.set(row.section, body);
      }
      const firstCode = row[first.key];
      // If there is no room for the other columns, their codes are shown after the description if they differ.
      const differing = others.filter(({ key }) => row[key] !== '' && row[key] !== firstCode);
      const description = make('td', {}, ...renderProse(row.does));
      if (row.note !== '') description.append(make('span', { className: 'note' }, row.note));
      const link = codeLink(row.a.split(/\s/)[0] ?? '', this.#shell.language);
      if (link !== undefined) description.append(' ', link);
      for (const { key, name } of differing)
        description.append(make('span', { className: 'elsewhere' }, `${name}: `, ...renderCodes(row[key])));
      const element = make(
        'tr',
        { className: firstCode === '' ? 'absent' : row.effect },
        make('th', { scope: 'row' }, ...renderCodes(firstCode)),
        description,
        ...others.map(({ key }) =>
          make('td', { className: row[key] === firstCode ? 'other same' : 'other' }, ...renderCodes(row[key])),
        ),
        make('td', { className: 'group' }, groupOf(row)),
      );
      body.append(element);
      return {
        element,
        body,
        codes: columns
          .flatMap(({ key }) => row[key].toLowerCase().match(/\S+/g) ?? [])
          .flatMap((code) => [code, withoutLeadingZeros(code)]),
        words: `${row.section} ${row.does} ${row.note}`.toLowerCase(),
      };
    });
    this.#table.replaceChildren(make('thead', {}, head), ...bodies.values());
    if (this.#dialog.show()) {
      this.#filter.value = '';
      this.#text.scrollTop = 0;
      this.#filter.focus();
    }
    this.#find();
  }

  /** Shows codes that begin with the filter text; otherwise rows whose description contains all of its words. */
  #find(): void {
    const query = this.#filter.value.trim().toLowerCase();
    const words = query.split(/\s+/);
    const byCode = this.#rows.filter(
      ({ codes }) => codes.includes(query) || codes.includes(withoutLeadingZeros(query)),
    );
    const matches = (row: Row): boolean =>
      words.every((word) => row.words.includes(word) || row.codes.some((code) => code.startsWith(word)));
    const found = new Set(byCode.length > 0 ? byCode : this.#rows.filter(matches));
    for (const row of this.#rows) row.element.hidden = !found.has(row);
    const bodies = new Set([...found].map(({ body }) => body));
    for (const { body } of this.#rows) body.hidden = !bodies.has(body);
    this.#found.textContent = query === '' ? '' : WORDS[this.#shell.language].codesFound(found.size);
  }
}

/** The code without leading zeros, as it may also be typed: G1 for G01. */
function withoutLeadingZeros(code: string): string {
  return code.replace(/^([a-z])0+(?=\d)/, '$1');
}

function renderCodes(codes: string): (Node | string)[] {
  if (codes === '') return ['–'];
  return codes.split(' ').flatMap((code, i) => [i > 0 ? ' ' : '', make('code', { lang: 'en' }, code)]);
}

function groupOf({ group }: CodeRow): string {
  return group === undefined ? '' : String(group).padStart(2, '0');
}

const WORDS = words({
  en: {
    codes: 'Supported codes',
    codesAbout: (control: string) =>
      `As ${control} writes them, then the other controls. – : this control has no such code.`,
    codesFilter: 'Filter',
    codesFilterHint: 'G92, thread …',
    codesFound: counter('en', { one: 'row', other: 'rows' }),
    codesWhat: 'What it does',
    codesGroup: 'Group',
  },
  zh: {
    codes: '支持的代码',
    codesAbout: (control) => `先列 ${control} 的写法，再列其他数控系统。– 表示该系统没有此代码。`,
    codesFilter: '筛选',
    codesFilterHint: 'G92、螺纹……',
    codesFound: counter('zh', { other: '行' }),
    codesWhat: '功能',
    codesGroup: '组',
  },
  ru: {
    codes: 'Поддерживаемые коды',
    codesAbout: (control) => `Сначала запись для ${control}, затем для других систем. – : такого кода в системе нет.`,
    codesFilter: 'Поиск',
    codesFilterHint: 'G92, резьба …',
    codesFound: counter('ru', { one: 'строка', few: 'строки', other: 'строк' }),
    codesWhat: 'Что делает',
    codesGroup: 'Группа',
  },
});
