// The time of the program in the line at the bottom, and the table of each tool's time, paths and extents.
//
// In: the totals of the newest run, requested once its path is complete. Must not know: how they are computed.

import { Dialog } from '../dom/dialog';
import { make, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { LengthUnit, Readout, Totals } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { durationNote, formatClock, formatDuration } from './duration';
import { toUnit, formatLength, unitSymbol } from './lengths';
import type { Panel, PanelKind, Shell } from './panel';
import totalsStyles from './totals.css?inline';

/**
 * Most motions of a program whose totals are computed after each change. For a longer one, they are computed when the
 * table is opened.
 */
const MAX_AUTO_TOTALS = 50_000;

export const totals: PanelKind = { control: 'tools', styles: totalsStyles, make: (shell) => new TotalsPanel(shell) };

class TotalsPanel implements Panel {
  readonly #shell: Shell;
  readonly #button = menuItem({ 'aria-haspopup': 'dialog', hidden: true });
  readonly #body = make('div', { className: 'scroller', tabIndex: 0, role: 'region' });
  readonly #notes = make('p', { hidden: true });
  readonly #dialog = new Dialog('totals', [this.#body, this.#notes]);
  /** One row for each tool, and the last row for the whole program. */
  #rows: readonly Totals[] = [];
  #unit: LengthUnit = 'mm';
  /** "0:49 / 3:14": the time at the tool, if it is shown, and of the whole program. */
  readonly #time = make('span', { className: 'time', part: 'time' });
  /** The time at the tool. */
  #elapsed: string | undefined;
  readonly elements = { 'more-menu': [this.#button], playback: [this.#time], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => {
      this.#dialog.show();
      if (this.#rows.length === 0) void this.#ask();
    });
  }

  set language(language: Language) {
    this.#dialog.setTexts(WORDS[language].title, COMMON[language].close);
    this.#show();
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    const { stage, summary, units } = event.report;
    this.#unit = units.shown;
    if (stage === 'repeated') this.#show();
    if (stage !== 'whole' && stage !== 'path') return;
    this.#button.hidden = summary.motions === 0;
    if (summary.motions > 0 && (summary.motions <= MAX_AUTO_TOTALS || this.#dialog.open)) void this.#ask();
    else this.#set([]);
  }

  onToolMoved(place: Readout | undefined): void {
    this.#elapsed = place === undefined ? undefined : formatClock(place.elapsed.seconds + place.elapsed.assumedSeconds);
    this.#showTime();
  }

  onWorkerLost(): void {
    this.#button.hidden = true;
    this.#set([]);
  }

  async #ask(): Promise<void> {
    const rows = await this.#shell.ask('totals', undefined);
    // Another run has begun since, and asks for its own totals.
    if (rows !== undefined) this.#set(rows);
  }

  #set(rows: readonly Totals[]): void {
    this.#rows = rows;
    this.#show();
  }

  #showTime(): void {
    const all = this.#rows.at(-1);
    const whole = all === undefined ? '' : formatDuration(all, this.#shell.language);
    setText(this.#time, this.#elapsed === undefined || whole === '' ? whole : `${this.#elapsed} / ${whole}`);
    const notes = this.#notes.textContent ?? '';
    this.#time.title = [WORDS[this.#shell.language].time(whole), ...(notes === '' ? [] : [notes])].join('. ');
  }

  #show(): void {
    const { language } = this.#shell;
    const texts = WORDS[language];
    const all = this.#rows.at(-1);
    this.#button.textContent = texts.time(all === undefined ? '…' : formatDuration(all, language));
    this.#body.setAttribute('aria-label', texts.title);
    if (all === undefined) {
      this.#body.replaceChildren();
      this.#notes.hidden = true;
      this.#notes.textContent = '';
      return this.#showTime();
    }
    const head = texts.columns(unitSymbol(this.#unit, language)).map((text) => make('th', { scope: 'col' }, text));
    const rows = this.#rows.map((row) => this.#row(row, row === all ? texts.whole : (row.tool ?? texts.noTool)));
    this.#body.replaceChildren(
      make('table', {}, make('thead', {}, make('tr', {}, ...head)), make('tbody', {}, ...rows)),
    );
    const note = durationNote(all, language);
    this.#notes.hidden = note === '';
    this.#notes.textContent = note;
    this.#showTime();
  }

  #row(row: Totals, first: string): HTMLElement {
    const { low, high, cut, rapid } = row;
    const range = (from: number | undefined, to: number | undefined): string =>
      from === undefined || to === undefined
        ? '–'
        : `${formatLength(from, this.#unit)} … ${formatLength(to, this.#unit)}`;
    const path = (mm: number): string => toUnit(mm, this.#unit).toFixed(this.#unit === 'mm' ? 1 : 2);
    const cells = [
      formatDuration(row, this.#shell.language),
      path(cut),
      path(rapid),
      range(low?.x, high?.x),
      range(low?.z, high?.z),
    ];
    return make('tr', {}, make('th', { scope: 'row' }, first), ...cells.map((cell) => make('td', {}, cell)));
  }
}

const WORDS = words({
  en: {
    time: (time: string) => `Time and totals: ${time}`,
    title: 'Time and totals',
    columns: (unit: string) => ['Tool', 'Time', `Cut, ${unit}`, `Rapid, ${unit}`, 'X of the cuts, Ø', 'Z of the cuts'],
    whole: 'All',
    noTool: '–',
  },
  zh: {
    time: (time) => `时间与合计：${time}`,
    title: '时间与合计',
    columns: (unit) => ['刀具', '时间', `切削，${unit}`, `快移，${unit}`, '切削 X 范围，Ø', '切削 Z 范围'],
    whole: '合计',
    noTool: '–',
  },
  ru: {
    time: (time) => `Время и итоги: ${time}`,
    title: 'Время и итоги',
    columns: (unit) => ['Инструмент', 'Время', `Резание, ${unit}`, `Ускоренно, ${unit}`, 'X резания, Ø', 'Z резания'],
    whole: 'Всего',
    noTool: '–',
  },
});
