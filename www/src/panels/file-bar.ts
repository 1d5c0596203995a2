// The open file: its name, and the encoding it was read in and is saved in.
//
// In: the file. Out: `chosen` when the reader names another encoding. Must not know: how bytes become text.

import { make } from '../dom/dom';
import type { ProgramFile } from '../editor/file';
import { ENCODING_NAMES, ENCODINGS, type Encoding } from '../files/encodings';
import type { Strings } from '../dom/i18n';

export interface FileBarEvents {
  chosen(encoding: Encoding): void;
}

export class FileBar {
  readonly element = make('div', { className: 'file', part: 'file', hidden: true });
  readonly #name = make('span', { className: 'file-name' });
  readonly #encoding = make('select', { className: 'small' });
  #file: ProgramFile | undefined;

  constructor(strings: Strings, events: FileBarEvents) {
    for (const encoding of ENCODINGS) this.#encoding.append(make('option', { value: encoding }, ENCODING_NAMES[encoding]));
    this.#encoding.addEventListener('change', () => {
      const chosen = this.#encoding.value as Encoding;
      // It stands where the file is; whoever is told may move it.
      this.file = this.#file;
      events.chosen(chosen);
    });
    this.element.append(this.#name, this.#encoding);
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#encoding.setAttribute('aria-label', strings.encoding);
    this.#encoding.title = strings.encodingHint;
  }

  set file(file: ProgramFile | undefined) {
    this.#file = file;
    this.element.hidden = file === undefined;
    if (file === undefined) return;
    this.#name.textContent = this.#name.title = file.name;
    this.#encoding.value = file.encoding;
  }
}
