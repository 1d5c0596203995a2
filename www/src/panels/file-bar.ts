// The open file: its name and encoding, opening and saving.
//
// In: files that are chosen or dropped on the element, the encoding that the user selects. Out: the program, the bytes
// to save. Must not know: how bytes become text.

import { make } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import { bytesToSave, download, fileStem, reread } from '../editor/program-files';
import { programText, type ProgramFile } from '../editor/program-text';
import type { OpenedFile } from '../editor/read-program';
import { ENCODINGS, type Encoding } from '../files/encoding-list';
import { ENCODING_NAMES } from '../files/encoding-names';
import { loadPart } from './load-part';
import type { Key, Panel, PanelKind, Services, Shell } from './panel';
import fileBarStyles from './file-bar.css?inline';

export const fileBar: PanelKind = { control: 'file', styles: fileBarStyles, make: (shell) => new FileBar(shell) };

/** File types that the dialog of the browser offers. */
const FILE_TYPES = '.nc,.cnc,.tap,.txt,.gcode,.ngc,.mpf,.min,.eia,text/plain';

class FileBar implements Panel {
  readonly #shell: Shell;
  readonly #element = make('div', { className: 'file', part: 'file', hidden: true });
  readonly #name = make('span', { className: 'file-name' });
  readonly #encoding = make('select', { className: 'small' });
  #file: ProgramFile | undefined;
  /** The newest file that is being read. */
  #pendingOpen: Promise<unknown> | undefined;
  readonly #input = make('input', { type: 'file', hidden: true, accept: FILE_TYPES });
  readonly #openItem = menuItem();
  readonly #saveItem = menuItem();
  readonly elements = { bar: [this.#element], 'program-menu': [this.#openItem, this.#saveItem, this.#input] };
  readonly services: Partial<Services> = { openFile: (file) => this.#open(file), saveFile: () => this.#save() };

  constructor(shell: Shell) {
    this.#shell = shell;
    for (const encoding of ENCODINGS)
      this.#encoding.append(make('option', { value: encoding }, ENCODING_NAMES[encoding]));
    this.#encoding.disabled = shell.readonly;
    this.#encoding.addEventListener('change', () => {
      const chosen = this.#encoding.value as Encoding;
      // The field shows the encoding of the file, which changes only if `#changeEncoding` succeeds.
      this.onFileChanged(this.#file);
      this.#changeEncoding(chosen);
    });
    this.#element.append(this.#name, this.#encoding);
    this.#openItem.hidden = shell.readonly;
    this.#openItem.addEventListener('click', () => this.#input.click());
    this.#saveItem.addEventListener('click', () => this.#save());
    this.#input.addEventListener('change', () => {
      const file = this.#input.files?.[0];
      if (file !== undefined) void this.#open(file);
      this.#input.value = '';
    });
    // Also over the drawing, where the browser would otherwise navigate to the file.
    acceptFiles(shell.root.host as HTMLElement, {
      hint: () => COMMON[shell.language].dropHere,
      onDrop: (file) => void (shell.readonly ? undefined : this.#open(file)),
    });
  }

  set language(language: Language) {
    this.#encoding.setAttribute('aria-label', WORDS[language].encoding);
    this.#encoding.title = WORDS[language].encodingHint;
    this.#openItem.textContent = WORDS[language].openFile;
    this.#saveItem.textContent = WORDS[language].saveFile;
  }

  onFileChanged(file: ProgramFile | undefined): void {
    // A notice about the previous file is hidden.
    if (file?.name !== this.#file?.name) this.#shell.service('hideNotice')('file');
    this.#file = file;
    this.#element.hidden = file === undefined;
    if (file === undefined) return;
    this.#name.textContent = this.#name.title = file.name;
    this.#encoding.value = file.encoding;
  }

  onKey({ event }: Key): 'handled' | 'ignored' {
    if (!(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return 'ignored';
    const letter = event.key.toLowerCase();
    if (letter === 's') this.#save();
    else if (letter === 'o' && !this.#shell.readonly) this.#input.click();
    else return 'ignored';
    return 'handled';
  }

  get #words(): (typeof WORDS)['en'] {
    return WORDS[this.#shell.language];
  }

  /** Opens a file as the program; undo restores the previous one. */
  async #open(file: File): Promise<void> {
    const opening = this.#read(file);
    this.#pendingOpen = opening;
    const opened = await opening;
    // The user has opened another file since.
    if (this.#pendingOpen !== opening || opened === undefined) return;
    const [notify, texts] = [this.#shell.service('notice'), this.#words];
    if (opened.kind === 'too-large') notify(texts.fileTooLarge(opened.name));
    else if (opened.kind === 'unreadable') notify(texts.fileUnreadable(opened.name));
    else {
      const { name, encoding } = opened.file;
      this.#shell.replaceProgram(opened.program, opened.file, 'another');
      if (opened.binary) notify(texts.openedBinary(name));
      else if (encoding === 'utf-8') notify(texts.opened(name));
      else notify(texts.openedAs(name, ENCODING_NAMES[encoding]));
    }
  }

  /** Reads a file, after loading the code for it. Undefined if that could not be loaded; a notice says so. */
  async #read(file: File): Promise<OpenedFile | undefined> {
    const part = await loadPart(
      this.#shell,
      () => import('../editor/read-program'),
      () => void this.#open(file),
    );
    return part?.readProgram(file).catch(() => ({ kind: 'unreadable', name: file.name }) as const);
  }

  /** Saves the program as a file, with the encoding and line ends that it was opened with. */
  #save(): void {
    const { editor } = this.#shell;
    const before = editor.file;
    const { bytes, file, unencodable } = bytesToSave(editor.textWithLineEnds, before);
    download(before === undefined ? `${fileStem(editor.text, undefined)}.nc` : file.name, bytes);
    if (unencodable === undefined || before === undefined) return;
    editor.file = file;
    this.#shell.service('notice')(this.#words.savedAsUtf8(file.name, ENCODING_NAMES[before.encoding], unencodable));
    this.#shell.notifyFileChanged();
  }

  #changeEncoding(encoding: Encoding): void {
    const { editor } = this.#shell;
    const { file } = editor;
    if (file === undefined) return;
    const [notify, texts] = [this.#shell.service('notice'), this.#words];
    const [chosen, current] = [ENCODING_NAMES[encoding], ENCODING_NAMES[file.encoding]];
    const answer = reread(editor.textWithLineEnds, file.encoding, encoding);
    switch (answer.kind) {
      case 'text':
        this.#shell.replaceProgram(programText(answer.text), { ...file, encoding }, 'same');
        notify(texts.rereadAs(chosen));
        break;
      case 'unchanged':
        editor.file = { ...file, encoding };
        notify(texts.savedFromNowAs(chosen));
        this.#shell.notifyFileChanged();
        break;
      case 'invalid-encoding':
        notify(texts.invalidEncoding(file.name, chosen, current));
        break;
      case 'unencodable':
        notify(texts.unencodable(answer.character, chosen, current));
        break;
    }
  }
}

const WORDS = words({
  en: {
    openFile: 'Open file…',
    saveFile: 'Save file',
    opened: (name: string) => `Opened ${name}`,
    openedAs: (name: string, encoding: string) =>
      `Opened ${name} as ${encoding}. If the text is garbled, choose another encoding beside its name.`,
    openedBinary: (name: string) =>
      `Opened ${name}. It does not look like text; saved unchanged, its bytes stay the same.`,
    fileTooLarge: (name: string) => `${name} is larger than 64 MB and was not opened.`,
    fileUnreadable: (name: string) => `${name} could not be read.`,
    encoding: 'Encoding',
    encodingHint: 'The encoding the file is read in and saved in',
    rereadAs: (encoding: string) => `Read again as ${encoding}.`,
    savedFromNowAs: (encoding: string) => `The text stays as it is and will be saved as ${encoding}.`,
    invalidEncoding: (name: string, chosen: string, present: string) =>
      `${name} is not ${chosen} text; it stays ${present}.`,
    unencodable: (character: string, chosen: string, present: string) =>
      `${chosen} has no character “${character}”; the file stays ${present}.`,
    savedAsUtf8: (name: string, encoding: string, character: string) =>
      `${encoding} has no character “${character}”: ${name} was saved as UTF-8.`,
  },
  zh: {
    openFile: '打开文件…',
    saveFile: '保存文件',
    opened: (name) => `已打开 ${name}`,
    openedAs: (name, encoding) => `已按 ${encoding} 打开 ${name}。如果显示为乱码，请在文件名旁选择其他编码。`,
    openedBinary: (name) => `已打开 ${name}。它不像文本文件；不作修改保存时，字节保持不变。`,
    fileTooLarge: (name) => `${name} 超过 64 MB，未打开。`,
    fileUnreadable: (name) => `无法读取 ${name}。`,
    encoding: '编码',
    encodingHint: '读取和保存此文件所用的编码',
    rereadAs: (encoding) => `已按 ${encoding} 重新读取。`,
    savedFromNowAs: (encoding) => `文本不变，将以 ${encoding} 保存。`,
    invalidEncoding: (name, chosen, present) => `${name} 不是 ${chosen} 文本，仍为 ${present}。`,
    unencodable: (character, chosen, present) => `${chosen} 中没有“${character}”，文件仍为 ${present}。`,
    savedAsUtf8: (name, encoding, character) => `${encoding} 中没有“${character}”：${name} 已改用 UTF-8 保存。`,
  },
  ru: {
    openFile: 'Открыть файл…',
    saveFile: 'Сохранить файл',
    opened: (name) => `Открыт файл ${name}`,
    openedAs: (name, encoding) =>
      `Файл ${name} открыт в кодировке ${encoding}. Если текст нечитаем, выберите другую рядом с именем.`,
    openedBinary: (name) => `Открыт файл ${name}. Он не похож на текст; без правок его байты сохранятся без изменений.`,
    fileTooLarge: (name) => `Файл ${name} больше 64 МБ и не открыт.`,
    fileUnreadable: (name) => `Файл ${name} не читается.`,
    encoding: 'Кодировка',
    encodingHint: 'Кодировка, в которой файл читается и сохраняется',
    rereadAs: (encoding) => `Прочитано заново в кодировке ${encoding}.`,
    savedFromNowAs: (encoding) => `Текст остаётся как есть и будет сохранён в кодировке ${encoding}.`,
    invalidEncoding: (name, chosen, present) => `Файл ${name} — не текст в кодировке ${chosen}; остаётся ${present}.`,
    unencodable: (character, chosen, present) => `В кодировке ${chosen} нет знака «${character}»; остаётся ${present}.`,
    savedAsUtf8: (name, encoding, character) =>
      `В кодировке ${encoding} нет знака «${character}»: файл ${name} сохранён в UTF-8.`,
  },
});
