// The item "Motions" of the menu "More" and its table: all motions as text, the accessible form of the drawing.
//
// In: motions as text, one page at a time, an explanation of the block of a motion, and the tool position. Out: the
// motion to move the tool to. The table stays open while the program is played or edited, and its marked row follows
// the tool. Of a long program only the rows around the tool are in the document; the arrow keys load more. Must not
// know: the meaning of a motion.

import { DialogHead } from '../dom/dialog';
import { make, setText, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { Help, Readout, Stroke } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { NewestQuestion, Panel, PanelKind, Shell } from './panel';
import motionsStyles from './motions.css?inline';

/** Most rows in the document; the next page overlaps them by half. */
const MAX_ROWS = 60;
const PAGE_ROWS = 10;

export const motions: PanelKind = { control: 'tools', styles: motionsStyles, make: (shell) => new MotionsPanel(shell) };

class MotionsPanel implements Panel {
  readonly #shell: Shell;
  readonly #question: NewestQuestion<'strokes'>;
  readonly #explanation: NewestQuestion<'help'>;
  readonly #button = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #head = new DialogHead('motions');
  readonly #keys = make('p', { className: 'about', id: 'motions-keys' });
  /** What the block of the marked row does. */
  readonly #explanationText = make('p', { className: 'does', 'aria-live': 'polite' });
  readonly #columns = make('tr', { role: 'row' });
  readonly #body = make('tbody', { role: 'rowgroup' });
  readonly #table = make(
    'table',
    { role: 'grid', 'aria-describedby': 'motions-keys' },
    make('thead', { role: 'rowgroup' }, this.#columns),
    this.#body,
  );
  readonly #earlier = make('button', { type: 'button' });
  readonly #later = make('button', { type: 'button' });
  readonly #scroller = make('div', { className: 'scroller' }, this.#earlier, this.#table, this.#later);
  readonly #element = make(
    'div',
    { className: 'window motions', part: 'motions', role: 'dialog', popover: 'manual' },
    this.#head.element,
    this.#keys,
    this.#scroller,
    this.#explanationText,
  );
  /** Number of motions of the newest run. */
  #count = 0;
  /** The first loaded motion, and the loaded rows. */
  #first = 0;
  #rows: readonly Stroke[] = [];
  /** Content of the rows, as text, to compare. */
  #renderedKey = '';
  /** The motion that the tool is on. */
  #toolMotion: number | undefined;
  /** The motion whose row can have the focus, and whether to focus it once it is rendered. */
  #activeMotion = 0;
  #focusPending = false;
  /** The element that had the focus when the row was to be focused. */
  #focusBefore: Element | null = null;
  /** The element that had the focus when the table was opened. */
  #opener: Element | null = null;
  /** Describes the drawing to screen readers: says where its text is. */
  readonly #description = make('span', { id: 'motions-about', hidden: true });
  readonly elements = { 'more-menu': [this.#button], dialogs: [this.#element, this.#description] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#question = shell.newest('strokes', (rows) => this.#showRows(rows));
    this.#explanation = shell.newest('help', (help) => this.#explain(help));
    this.#button.addEventListener('click', () => this.#toggle());
    this.#head.close.addEventListener('click', () => this.#closeTable());
    this.#element.addEventListener('keydown', (event) => this.#handleKey(event));
    this.#body.addEventListener('click', (event) => {
      const row = (event.target as Element).closest('tr');
      if (row !== null) this.#goTo(Number(row.getAttribute('aria-rowindex')) - 2);
    });
    this.#earlier.addEventListener('click', () => this.#requestRows(this.#first - MAX_ROWS / 2));
    this.#later.addEventListener('click', () => this.#requestRows(this.#first + MAX_ROWS / 2));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#button.textContent = texts.motions;
    this.#button.title = texts.about;
    this.#description.textContent = texts.described;
    for (const drawing of this.#shell.region('pictures').querySelectorAll('[role=img]'))
      drawing.setAttribute('aria-describedby', this.#description.id);
    this.#head.setTexts(texts.title, COMMON[language].close);
    this.#keys.textContent = texts.keys;
    for (const element of [this.#element, this.#table]) element.setAttribute('aria-label', texts.title);
    this.#earlier.textContent = texts.earlier;
    this.#later.textContent = texts.later;
    this.#columns.replaceChildren(
      ...[texts.number, texts.line, texts.motion].map((text) =>
        make('th', { scope: 'col', role: 'columnheader' }, text),
      ),
    );
  }

  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  get #isOpen(): boolean {
    return this.#element.matches(':popover-open');
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    const { stage, summary } = event.report;
    if (stage === 'whole' || stage === 'path') {
      this.#count = summary.motions;
      this.#toolMotion = undefined;
      this.#activeMotion = Math.min(this.#activeMotion, Math.max(this.#count - 1, 0));
    } else if (stage === 'part') return;
    this.#rows = [];
    if (this.#isOpen) this.#requestRows(this.#first);
  }

  onToolMoved(place: Readout | undefined): void {
    this.#toolMotion = place?.stroke.motion;
    if (this.#toolMotion !== undefined) this.#activeMotion = this.#toolMotion;
    if (this.#isOpen) this.#follow();
  }

  /** Opening moves the focus to the table, closing to where it was. */
  #toggle(): void {
    if (this.#isOpen) return this.#closeTable();
    this.#shell.flush();
    this.#opener = this.#shell.root.activeElement;
    this.#element.showPopover();
    // Until the row is rendered, so that Escape closes the table.
    this.#head.close.focus();
    this.#focusRowWhenRendered();
    this.#follow();
  }

  #closeTable(): void {
    this.#element.hidePopover();
    this.#rows = [];
    this.#body.replaceChildren();
    this.#renderedKey = '';
    if (this.#opener instanceof HTMLElement) this.#opener.focus();
  }

  #handleKey(event: KeyboardEvent): void {
    if (event.key === 'Escape') this.#closeTable();
    else if ((event.target as Element).getAttribute('role') !== 'row' || event.ctrlKey || event.altKey || event.metaKey)
      return;
    else if (event.key === 'Enter' || event.key === ' ') this.#goTo(this.#activeMotion);
    else {
      const steps: Readonly<Record<string, number>> = {
        ArrowDown: 1,
        ArrowUp: -1,
        PageDown: PAGE_ROWS,
        PageUp: -PAGE_ROWS,
        Home: -this.#count,
        End: this.#count,
      };
      const step = steps[event.key];
      if (step === undefined) return;
      this.#focusRowWhenRendered();
      this.#goTo(Math.min(Math.max(this.#activeMotion + step, 0), this.#count - 1));
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** Focuses the row of the tool once it is rendered, unless the user has moved the focus by then. */
  #focusRowWhenRendered(): void {
    this.#focusBefore = this.#shell.root.activeElement;
    this.#focusPending = true;
  }

  /** Moves the tool to the end of a motion and keeps the focus in its row. */
  #goTo(motion: number): void {
    this.#activeMotion = motion;
    void this.#shell.service('moveTool')(this.#shell.ask('go-to', { motion }));
  }

  /** Loads the row of the tool and scrolls it into view. */
  #follow(): void {
    const within = this.#activeMotion >= this.#first && this.#activeMotion < this.#first + this.#rows.length;
    if (within) this.#mark();
    else this.#requestRows(this.#activeMotion - MAX_ROWS / 2);
  }

  /** Asks for the rows from `first`. */
  #requestRows(first: number): void {
    this.#first = Math.max(0, Math.min(first, this.#count - MAX_ROWS));
    this.#question.ask({ first: this.#first, end: this.#first + MAX_ROWS });
  }

  #showRows(rows: readonly Stroke[] | undefined): void {
    // Another run has begun since; its report asks again.
    if (rows === undefined || !this.#isOpen) return;
    this.#rows = rows;
    this.#first = rows[0]?.motion ?? 0;
    this.#activeMotion = Math.min(
      Math.max(this.#activeMotion, this.#first),
      this.#first + Math.max(rows.length - 1, 0),
    );
    this.#table.setAttribute('aria-rowcount', String(this.#count + 1));
    this.#earlier.hidden = this.#first === 0;
    this.#later.hidden = this.#first + rows.length >= this.#count;
    // Unchanged rows are kept: the user may be pressing one.
    const renderedKey = JSON.stringify(rows);
    if (renderedKey !== this.#renderedKey) {
      const hadFocus = this.#body.contains(this.#shell.root.activeElement);
      this.#body.replaceChildren(...rows.map((row) => this.#row(row)));
      this.#focusPending ||= hadFocus;
    }
    this.#renderedKey = renderedKey;
    this.#mark();
  }

  #row({ motion, line, text, kind }: Stroke): HTMLElement {
    const cells = [String(motion + 1), String(line)].map((text) => make('td', { role: 'gridcell' }, text));
    const swatch = make('span', {
      className: `swatch ${kind === 'arc' || kind === 'dwell' ? 'feed' : kind}`,
      'aria-hidden': 'true',
    });
    const what = make('td', { role: 'gridcell' }, swatch, make('span', {}, ...renderUnbroken(text)));
    return make('tr', { role: 'row', 'aria-rowindex': motion + 2, tabIndex: -1 }, ...cells, what);
  }

  /** Marks the row of the tool and the row that can have the focus. */
  #mark(): void {
    const focused = this.#shell.root.activeElement;
    const hasFocusMoved = focused !== null && focused !== this.#focusBefore && !this.#body.contains(focused);
    if (hasFocusMoved) this.#focusPending = false;
    for (const row of this.#body.rows) {
      const motion = Number(row.getAttribute('aria-rowindex')) - 2;
      row.tabIndex = motion === this.#activeMotion ? 0 : -1;
      row.ariaSelected = String(motion === this.#toolMotion);
      if (motion !== this.#activeMotion) continue;
      if (this.#focusPending) row.focus({ preventScroll: true });
      row.scrollIntoView({ block: 'nearest' });
    }
    this.#focusPending = false;
    this.#explanation.ask({ by: 'motions', about: 'motion', motion: this.#activeMotion });
  }

  /** Changed only if the text differs, because a change is announced to screen readers. */
  #explain(help: Help | undefined): void {
    if (help?.request.about === 'motion' && help.request.motion === this.#activeMotion)
      setText(this.#explanationText, help.explanation ?? '');
  }
}

const WORDS = words({
  en: {
    motions: 'Motions',
    about: 'All motions in words; the row of the tool is marked',
    described: 'Its motions in words: menu More, Motions',
    title: 'Motions in words',
    keys: 'Arrow keys move the tool.',
    number: 'No.',
    line: 'Line',
    motion: 'Motion',
    earlier: 'Earlier motions',
    later: 'Later motions',
  },
  zh: {
    motions: '动作',
    about: '用文字列出所有动作，并标出刀具所在的一行',
    described: '动作的文字说明：“更多”菜单中的“动作”',
    title: '动作的文字说明',
    keys: '用方向键移动刀具。',
    number: '序号',
    line: '行',
    motion: '动作',
    earlier: '之前的动作',
    later: '之后的动作',
  },
  ru: {
    motions: 'Перемещения',
    about: 'Все перемещения словами; строка инструмента отмечена',
    described: 'Перемещения словами: меню «Ещё», «Перемещения»',
    title: 'Перемещения словами',
    keys: 'Стрелки передвигают инструмент.',
    number: '№',
    line: 'Строка',
    motion: 'Перемещение',
    earlier: 'Предыдущие перемещения',
    later: 'Следующие перемещения',
  },
});
