// The button "Export" and its menu: the files that can be saved, besides the program itself.
//
// In: whether there is a run to export. Out: a file, passed to the browser. A menu button as in the ARIA pattern:
// Enter, Space and arrow up open it; arrows, Home, End and first letters move in it; Escape closes it. Must not know:
// how a file is made.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { bytesToSave, download } from '../editor/program-files';
import type { ExportFormat } from '../protocol/protocol';
import type { Panel, PanelKind, Shell } from './panel';
import exportsStyles from './exports.css?inline';

export const exports: PanelKind = { control: 'file', styles: exportsStyles, make: (shell) => new Exports(shell) };

class Exports implements Panel {
  readonly #shell: Shell;
  readonly #button = make('button', {
    type: 'button',
    className: 'export-button quiet outlined',
    'aria-haspopup': 'menu',
    'aria-expanded': 'false',
  });
  readonly #element = make('div', { className: 'menu', part: 'export-menu', role: 'menu', popover: 'auto' });
  readonly #items: readonly { readonly format: ExportFormat; readonly button: HTMLButtonElement }[];

  readonly elements = { foot: [this.#button], dialogs: [this.#element] };
  readonly services = { exported: (format: ExportFormat) => this.#shell.ask('export', { format }) };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#items = FORMATS.map((format) => {
      const button = make('button', { type: 'button', role: 'menuitem', tabIndex: -1 });
      button.addEventListener('click', () => {
        this.#element.hidePopover();
        this.#button.focus();
        void this.#export(format);
      });
      return { format, button };
    });
    this.#element.append(...this.#items.map(({ button }) => button));
    this.#button.popoverTargetElement = this.#element;
    this.#button.addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      this.#element.showPopover();
      this.#focusItem(event.key === 'ArrowUp' ? -1 : 0);
    });
    this.#element.addEventListener('keydown', (event) => this.#handleKey(event));
    this.#element.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.#button.setAttribute('aria-expanded', String(open));
      if (!open) return;
      this.#placeMenu();
      if (!this.#element.contains(this.#activeElement)) this.#focusItem(0);
    });
    this.available = false;
  }

  set language(language: Language) {
    const strings = WORDS[language];
    this.#button.textContent = strings.exports;
    this.#element.setAttribute('aria-label', strings.exports);
    for (const { format, button } of this.#items) button.textContent = strings.exportOf[format];
  }

  /** Whether there is a finished run to export. */
  set available(available: boolean) {
    this.#button.disabled = !available;
    if (!available && this.#element.matches(':popover-open')) this.#element.hidePopover();
  }

  async #export(format: ExportFormat): Promise<void> {
    const { editor, language } = this.#shell;
    this.#shell.flush();
    const exported = await this.#shell.ask('export', { format });
    // Without a worker, the page reports the error itself.
    if (exported === undefined) return;
    if (exported.kind === 'no-part') {
      this.#shell.service('notice')(WORDS[language].noPartToExport);
      return;
    }
    const { content, ending } = exported;
    const { file } = editor;
    const name = exportName(file?.name, format, ending);
    // A program is saved in the encoding of its file, as "Save file" does.
    const asProgram = file !== undefined && format === 'program';
    download(name, asProgram ? bytesToSave(new TextDecoder().decode(content), { ...file, name }).bytes : content);
  }

  get #activeElement(): Element | null {
    return (this.#element.getRootNode() as ShadowRoot).activeElement;
  }

  /** Places the menu above the button, right-aligned with it, within the window. */
  #placeMenu(): void {
    const { right, top } = this.#button.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = this.#element;
    this.#element.style.left = `${Math.max(8, Math.min(right, window.innerWidth - 8) - width)}px`;
    this.#element.style.top = `${Math.max(8, top - height - 6)}px`;
  }

  #handleKey(event: KeyboardEvent): void {
    const at = this.#items.findIndex(({ button }) => button === this.#activeElement);
    if (event.key === 'ArrowDown') this.#focusItem(at + 1);
    else if (event.key === 'ArrowUp') this.#focusItem(at - 1);
    else if (event.key === 'Home') this.#focusItem(0);
    else if (event.key === 'End') this.#focusItem(-1);
    else if (event.key === 'Tab' || event.key === 'Escape') {
      this.#element.hidePopover();
      this.#button.focus();
    } else if (event.key.length === 1 && event.key !== ' ' && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const letter = event.key.toLocaleLowerCase();
      const order = [...this.#items.keys()].map((step) => (at + 1 + step) % this.#items.length);
      const found = order.find((index) =>
        this.#items[index]?.button.textContent?.toLocaleLowerCase().startsWith(letter),
      );
      if (found !== undefined) this.#focusItem(found);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Focuses an item of the menu; the index wraps around. */
  #focusItem(index: number): void {
    this.#items.at(index % this.#items.length)?.button.focus();
  }
}

/** The file name of an export, made from the name of the program. */
function exportName(program: string | undefined, format: ExportFormat, ending: string): string {
  const stem = (program ?? '').replace(/\.[^.]*$/, '');
  if (stem === '' && format === 'card') return 'setup-sheet.html';
  return `${stem === '' ? 'program' : stem}${ending}`;
}

const WORDS = words({
  en: {
    exports: 'Export',
    exportOf: {
      card: 'Setup sheet to print (HTML)',
      svg: 'Drawing (SVG)',
      png: 'Picture as shown (PNG)',
      csv: 'Motions as a table (CSV)',
      dxf: 'Profile of the part (DXF)',
      stl: 'Part as a solid (STL)',
      program: 'Expanded program (NC)',
    } satisfies Record<ExportFormat, string>,
    noPartToExport: 'There is no part to export: nothing is left of the blank, or it is not known.',
  },
  zh: {
    exports: '导出',
    exportOf: {
      card: '可打印的数控加工程序单 (HTML)',
      svg: '图形 (SVG)',
      png: '当前画面 (PNG)',
      csv: '运动列表 (CSV)',
      dxf: '零件轮廓 (DXF)',
      stl: '零件实体 (STL)',
      program: '展开后的程序 (NC)',
    },
    noPartToExport: '没有可导出的零件：毛坯已无剩余，或毛坯未知。',
  },
  ru: {
    exports: 'Экспорт',
    exportOf: {
      card: 'Карта наладки для печати (HTML)',
      svg: 'Чертёж (SVG)',
      png: 'Рисунок, как на экране (PNG)',
      csv: 'Таблица перемещений (CSV)',
      dxf: 'Контур детали (DXF)',
      stl: 'Деталь как тело (STL)',
      program: 'Развёрнутая программа (NC)',
    },
    noPartToExport: 'Нечего экспортировать: от заготовки ничего не осталось, или она неизвестна.',
  },
});

const FORMATS = Object.keys(WORDS.en.exportOf) as ExportFormat[];
