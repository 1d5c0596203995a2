// The button "Motions" and its table: all motions as text, the accessible form of the drawing.
//
// In: motions as text, one page at a time, an explanation of the block of a motion, and the tool position. Out: the
// motion to move the tool to. The table stays open while the program is played or edited, and its marked row follows
// the tool. Of a long program only the rows around the tool are in the document; the arrow keys load more. Must not
// know: the meaning of a motion.

import { make, name, showText, unbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { Help, Readout, Stroke } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { NewestQuestion, Panel, PanelKind, Shell } from './panel';
import motionsStyles from './motions.css?inline';

/** Most rows in the document; the next page overlaps them by half. */
const ROWS = 60;
const PAGE = 10;

export const motions: PanelKind = { control: 'tools', styles: motionsStyles, make: (shell) => new MotionsPanel(shell) };

class MotionsPanel implements Panel {
  readonly #shell: Shell;
  readonly #question: NewestQuestion<'strokes'>;
  readonly #explanation: NewestQuestion<'help'>;
  readonly #button = make('button', {
    type: 'button',
    className: 'motions-button quiet outlined',
    'aria-haspopup': 'dialog',
    'aria-expanded': 'false',
  });
  readonly #title = make('h2');
  readonly #close = make('button', { type: 'button', className: 'quiet close' }, '×');
  readonly #keys = make('p', { className: 'keys', id: 'motions-keys' });
  /** What the block of the marked row does. */
  readonly #does = make('p', { className: 'does', 'aria-live': 'polite' });
  readonly #head = make('tr', { role: 'row' });
  readonly #body = make('tbody', { role: 'rowgroup' });
  readonly #table = make(
    'table',
    { role: 'grid', 'aria-describedby': 'motions-keys' },
    make('thead', { role: 'rowgroup' }, this.#head),
    this.#body,
  );
  readonly #earlier = make('button', { type: 'button', className: 'quiet' });
  readonly #later = make('button', { type: 'button', className: 'quiet' });
  readonly #scroller = make('div', { className: 'scroller' }, this.#earlier, this.#table, this.#later);
  readonly #element = make(
    'div',
    { className: 'motions', part: 'motions', role: 'dialog', popover: 'manual' },
    this.#title,
    this.#close,
    this.#keys,
    this.#scroller,
    this.#does,
  );
  /** Number of motions of the newest run. */
  #count = 0;
  /** The first loaded motion, and the loaded rows. */
  #first = 0;
  #rows: readonly Stroke[] = [];
  /** Content of the rows, as text, to compare. */
  #shownAs = '';
  /** The motion that the tool is on. */
  #at: number | undefined;
  /** The motion whose row can have the focus, and whether to focus it once it is rendered. */
  #active = 0;
  #focusing = false;
  /** The element that had the focus when the row was to be focused. */
  #keysWantedAt: Element | null = null;
  /** Describes the drawing to screen readers: says where its text is. */
  readonly #about = make('span', { id: 'motions-about', hidden: true });
  readonly places = { foot: [this.#button], dialogs: [this.#element, this.#about] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#question = shell.newest('strokes', (rows) => this.#take(rows));
    this.#explanation = shell.newest('help', (help) => this.#explain(help));
    this.#button.addEventListener('click', () => this.#toggle());
    this.#close.addEventListener('click', () => this.#shut());
    this.#element.addEventListener('keydown', (event) => this.#key(event));
    this.#body.addEventListener('click', (event) => {
      const row = (event.target as Element).closest('tr');
      if (row !== null) this.#go(Number(row.getAttribute('aria-rowindex')) - 2);
    });
    this.#earlier.addEventListener('click', () => this.#show(this.#first - ROWS / 2));
    this.#later.addEventListener('click', () => this.#show(this.#first + ROWS / 2));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#button.textContent = texts.motions;
    this.#button.title = texts.about;
    this.#about.textContent = texts.described;
    for (const drawing of this.#shell.region('pictures').querySelectorAll('[role=img]'))
      drawing.setAttribute('aria-describedby', this.#about.id);
    this.#title.textContent = texts.title;
    this.#keys.textContent = texts.keys;
    for (const element of [this.#element, this.#table]) element.setAttribute('aria-label', texts.title);
    name(this.#close, COMMON[language].close);
    this.#earlier.textContent = texts.earlier;
    this.#later.textContent = texts.later;
    this.#head.replaceChildren(
      ...[texts.number, texts.line, texts.motion].map((text) =>
        make('th', { scope: 'col', role: 'columnheader' }, text),
      ),
    );
  }

  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  get #open(): boolean {
    return this.#element.matches(':popover-open');
  }

  heard(event: Heard): void {
    if (event.kind !== 'report') return;
    const { stage, summary } = event.report;
    if (stage === 'whole' || stage === 'path') {
      this.#count = summary.motions;
      this.#at = undefined;
      this.#active = Math.min(this.#active, Math.max(this.#count - 1, 0));
    } else if (stage === 'part') return;
    this.#rows = [];
    if (this.#open) this.#show(this.#first);
  }

  toolMoved(place: Readout | undefined): void {
    this.#at = place?.stroke.motion;
    if (this.#at !== undefined) this.#active = this.#at;
    if (this.#open) this.#follow();
  }

  /** Opening moves the focus to the table, closing to the button. */
  #toggle(): void {
    if (this.#open) return this.#shut();
    this.#shell.flush();
    this.#element.showPopover();
    this.#button.setAttribute('aria-expanded', 'true');
    this.#wantKeys();
    this.#follow();
  }

  #shut(): void {
    this.#element.hidePopover();
    this.#button.setAttribute('aria-expanded', 'false');
    this.#rows = [];
    this.#body.replaceChildren();
    this.#shownAs = '';
    this.#button.focus();
  }

  #key(event: KeyboardEvent): void {
    if (event.key === 'Escape') this.#shut();
    else if ((event.target as Element).getAttribute('role') !== 'row' || event.ctrlKey || event.altKey || event.metaKey)
      return;
    else if (event.key === 'Enter' || event.key === ' ') this.#go(this.#active);
    else {
      const steps: Readonly<Record<string, number>> = {
        ArrowDown: 1,
        ArrowUp: -1,
        PageDown: PAGE,
        PageUp: -PAGE,
        Home: -this.#count,
        End: this.#count,
      };
      const step = steps[event.key];
      if (step === undefined) return;
      this.#wantKeys();
      this.#go(Math.min(Math.max(this.#active + step, 0), this.#count - 1));
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /** Focuses the row of the tool once it is rendered, unless the user has moved the focus by then. */
  #wantKeys(): void {
    this.#keysWantedAt = this.#shell.root.activeElement;
    this.#focusing = true;
  }

  /** Moves the tool to the end of a motion and keeps the focus in its row. */
  #go(motion: number): void {
    this.#active = motion;
    void this.#shell.service('goTo')(motion);
  }

  /** Loads the row of the tool and scrolls it into view. */
  #follow(): void {
    const within = this.#active >= this.#first && this.#active < this.#first + this.#rows.length;
    if (within) this.#mark();
    else this.#show(this.#active - ROWS / 2);
  }

  /** Asks for the rows from `first`. */
  #show(first: number): void {
    this.#first = Math.max(0, Math.min(first, this.#count - ROWS));
    this.#question.ask({ first: this.#first, end: this.#first + ROWS });
  }

  #take(rows: readonly Stroke[] | undefined): void {
    // Another run has begun since; its report asks again.
    if (rows === undefined || !this.#open) return;
    this.#rows = rows;
    this.#first = rows[0]?.motion ?? 0;
    this.#active = Math.min(Math.max(this.#active, this.#first), this.#first + Math.max(rows.length - 1, 0));
    this.#table.setAttribute('aria-rowcount', String(this.#count + 1));
    this.#earlier.hidden = this.#first === 0;
    this.#later.hidden = this.#first + rows.length >= this.#count;
    // Unchanged rows are kept: the user may be pressing one.
    const shownAs = JSON.stringify(rows);
    if (shownAs !== this.#shownAs) {
      const hadFocus = this.#body.contains(this.#shell.root.activeElement);
      this.#body.replaceChildren(...rows.map((row) => this.#row(row)));
      this.#focusing ||= hadFocus;
    }
    this.#shownAs = shownAs;
    this.#mark();
  }

  #row({ motion, line, text, kind }: Stroke): HTMLElement {
    const cells = [String(motion + 1), String(line)].map((text) => make('td', { role: 'gridcell' }, text));
    const swatch = make('span', {
      className: `swatch ${kind === 'arc' || kind === 'dwell' ? 'feed' : kind}`,
      'aria-hidden': 'true',
    });
    const what = make('td', { role: 'gridcell' }, swatch, make('span', {}, ...unbroken(text)));
    return make('tr', { role: 'row', 'aria-rowindex': motion + 2, tabIndex: -1 }, ...cells, what);
  }

  /** Marks the row of the tool and the row that can have the focus. */
  #mark(): void {
    const focused = this.#shell.root.activeElement;
    const hasGone = focused !== null && focused !== this.#keysWantedAt && !this.#body.contains(focused);
    if (hasGone) this.#focusing = false;
    for (const row of this.#body.rows) {
      const motion = Number(row.getAttribute('aria-rowindex')) - 2;
      row.tabIndex = motion === this.#active ? 0 : -1;
      row.ariaSelected = String(motion === this.#at);
      if (motion !== this.#active) continue;
      if (this.#focusing) row.focus({ preventScroll: true });
      row.scrollIntoView({ block: 'nearest' });
    }
    this.#focusing = false;
    this.#explanation.ask({ by: 'motions', about: 'motion', motion: this.#active });
  }

  /** Changed only if the text differs, because a change is announced to screen readers. */
  #explain(help: Help | undefined): void {
    if (help?.asked.about === 'motion' && help.asked.motion === this.#active)
      showText(this.#does, help.explanation ?? '');
  }
}

const WORDS = words({
  en: {
    motions: 'Motions',
    about: 'All motions in words; the row of the tool is marked',
    described: 'Its motions in words: button Motions',
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
    described: '动作的文字说明：“动作”按钮',
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
    described: 'Перемещения словами: кнопка «Перемещения»',
    title: 'Перемещения словами',
    keys: 'Стрелки передвигают инструмент.',
    number: '№',
    line: 'Строка',
    motion: 'Перемещение',
    earlier: 'Предыдущие перемещения',
    later: 'Следующие перемещения',
  },
});
