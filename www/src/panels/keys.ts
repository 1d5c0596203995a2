// The row of keys above the keyboard of a phone: undo, and what programs need most. The style sheet shows it while the
// user types.
//
// In: a press. Out: the text at the cursor; undo and the next field of the editor. Must not know: the program.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import keysStyles from './keys.css?inline';
import type { Panel, PanelKind, Shell } from './panel';

export const keys: PanelKind = { edits: true, styles: keysStyles, make: (shell) => new Keys(shell) };

const TEXTS = [...'-.;XZGFUWRMSTPQN()'] as const;

class Keys implements Panel {
  readonly #undo = make('button', { type: 'button', className: 'key' }, icon('undo'));
  /** In view while a cycle has fields to fill in. */
  readonly #nextField = make('button', { type: 'button', className: 'key next-field' }, '⇥');
  readonly #row: HTMLElement;
  readonly elements: Panel['elements'];

  constructor(shell: Shell) {
    this.#undo.addEventListener('click', () => shell.editor.travel('undo'));
    this.#nextField.addEventListener('click', () => void shell.editor.nextField());
    const texts = TEXTS.map((text) => {
      const button = make('button', { type: 'button', className: 'key', lang: 'en' }, text === '-' ? '−' : text);
      button.addEventListener('click', () => shell.editor.type(text));
      return button;
    });
    this.#row = make('div', { className: 'keys', role: 'toolbar' }, this.#undo, this.#nextField, ...texts);
    // The text keeps the focus, and the keyboard stays open.
    this.#row.addEventListener('pointerdown', (event) => event.preventDefault());
    this.#row.addEventListener('mousedown', (event) => event.preventDefault());
    this.elements = { problems: [this.#row] };
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#row.setAttribute('aria-label', texts.keys);
    setAccessibleName(this.#undo, texts.undo);
    setAccessibleName(this.#nextField, texts.nextField);
  }
}

const WORDS = words({
  en: { keys: 'Keys', undo: 'Undo', nextField: 'Next number' },
  zh: { keys: '按键', undo: '撤销', nextField: '下一个数值' },
  ru: { keys: 'Клавиши', undo: 'Отменить', nextField: 'Следующее число' },
});
