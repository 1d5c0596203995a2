// The calculators: a dialog for the word at the cursor, or a form over the program if the host page has chosen one.
//
// In: the name of a calculator. Out: the result as edits of the block at the cursor (one undo), or as the program that
// the picture shows. Must not know: a formula.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { Calculated } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { CalculatorFields } from './calculator-fields';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Services, Shell } from './panel';
import calculatorStyles from './calculator.css?inline';

export const calculator: PanelKind = { styles: calculatorStyles, make: (shell) => new CalculatorPanel(shell) };

class CalculatorPanel implements Panel {
  readonly #shell: Shell;
  /** The form that the host page has chosen. */
  readonly #own = make('div', { className: 'calculator-own', hidden: true });
  readonly #contents = make('div');
  readonly #write = make('button', { type: 'button', className: 'primary', disabled: true });
  readonly #dialog = new Dialog('calculator', [this.#contents], [this.#write]);
  readonly #chosen: string | undefined;
  #isOwnShown = false;
  /** The form in the dialog. */
  #fields: CalculatorFields | undefined;
  #ownFields: CalculatorFields | undefined;
  #result: Calculated | undefined;
  readonly elements = { bar: [this.#own], dialogs: [this.#dialog.element] };
  readonly services: Partial<Services> = { openCalculator: (name) => void this.#open(name) };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#chosen = shell.calculator;
    this.#write.addEventListener('click', () => this.#apply());
    this.#dialog.element.addEventListener('close', () => this.#fields?.drop());
  }

  set language(language: Language) {
    this.#write.textContent = WORDS[language].write;
    this.#ownFields?.reload();
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report' || this.#chosen === undefined || this.#isOwnShown) return;
    this.#isOwnShown = true;
    void this.#showOwn(this.#chosen);
  }

  async #showOwn(name: string): Promise<void> {
    const part = await this.#load(() => void this.#showOwn(name));
    if (part === undefined) return;
    this.#ownFields = new part.CalculatorFields(this.#shell, name, 'example', (result) => {
      if (result !== undefined && result.program.trimEnd() !== this.#shell.editor.text.trimEnd())
        this.#shell.rewrite(result.program);
    });
    this.#own.append(this.#ownFields.element);
    this.#own.hidden = false;
    await this.#ownFields.start();
  }

  async #open(name: string): Promise<void> {
    const part = await this.#load(() => void this.#open(name));
    if (part === undefined) return;
    const texts = WORDS[this.#shell.language];
    const fields = new part.CalculatorFields(this.#shell, name, 'cursor', (result) => {
      this.#result = result;
      this.#write.disabled = result === undefined || result.edits.length === 0;
      this.#dialog.about = result !== undefined && result.edits.length === 0 ? texts.unchanged : '';
    });
    this.#fields = fields;
    this.#contents.replaceChildren(fields.element);
    if (!(await fields.start())) return;
    this.#dialog.setTexts(fields.title, COMMON[this.#shell.language].close);
    this.#write.hidden = this.#shell.readonly;
    this.#dialog.show();
    fields.focus();
  }

  #load(retry: () => void): Promise<typeof import('./calculator-fields') | undefined> {
    return loadPart(this.#shell, () => import('./calculator-fields'), retry);
  }

  #apply(): void {
    const { editor, language } = this.#shell;
    const edits = this.#result?.edits ?? [];
    this.#dialog.close();
    if (edits.length === 0) return;
    editor.change(edits);
    this.#shell.commitEdit();
    this.#shell.service('notice')(WORDS[language].written, 'program');
    editor.focus();
  }
}

const WORDS = words({
  en: {
    write: 'Write into the block',
    unchanged: 'The block has these values.',
    written: 'The result is in the block. Ctrl Z in the editor restores the previous values.',
  },
  zh: {
    write: '写入程序段',
    unchanged: '程序段中已是这些值。',
    written: '结果已写入程序段。在编辑器中按 Ctrl Z 可恢复原来的值。',
  },
  ru: {
    write: 'Записать в кадр',
    unchanged: 'В кадре уже эти значения.',
    written: 'Результат записан в кадр. Ctrl Z в редакторе вернёт прежние значения.',
  },
});
