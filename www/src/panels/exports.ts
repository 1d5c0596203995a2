// The files that can be saved besides the program itself: items of the menu "Share".
//
// In: whether there is a run to export. Out: a file, passed to the browser. Must not know: how a file is made.

import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import { bytesToSave, download, fileStem } from '../editor/program-files';
import type { ExportFormat } from '../protocol/protocol';
import type { Panel, PanelKind, Shell } from './panel';

export const exports: PanelKind = { control: 'file', make: (shell) => new Exports(shell) };

class Exports implements Panel {
  readonly #shell: Shell;
  readonly #items: readonly { readonly format: ExportFormat; readonly button: HTMLButtonElement }[];

  readonly elements: Panel['elements'];
  readonly services = { exported: (format: ExportFormat) => this.#shell.ask('export', { format }) };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#items = FORMATS.map((format) => {
      const button = menuItem();
      button.addEventListener('click', () => void this.#export(format));
      return { format, button };
    });
    this.elements = { 'share-menu': this.#items.map(({ button }) => button) };
    this.available = false;
  }

  set language(language: Language) {
    for (const { format, button } of this.#items) button.textContent = WORDS[language].exportOf[format];
  }

  /** Whether there is a finished run to export. */
  set available(available: boolean) {
    for (const { button } of this.#items) button.disabled = !available;
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
    const stem = fileStem(editor.text, file);
    const name = stem === 'program' && format === 'card' ? 'setup-sheet.html' : `${stem}${ending}`;
    // A program is saved in the encoding of its file, as "Save file" does.
    const asProgram = file !== undefined && format === 'program';
    download(name, asProgram ? bytesToSave(new TextDecoder().decode(content), { ...file, name }).bytes : content);
  }
}

const WORDS = words({
  en: {
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
