// The note over the picture while the user tries values of variables: the picture is not that of the program as
// written. A button ends the trial.
//
// In: the values that are tried. Out: the end of the trial. Must not know: the effect of the values.

import { make, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Panel, PanelKind, Shell } from './panel';
import whatIfStyles from './what-if.css?inline';

export const whatIf: PanelKind = { control: 'help', styles: whatIfStyles, make: (shell) => new WhatIf(shell) };

class WhatIf implements Panel {
  readonly #shell: Shell;
  readonly #text = make('span');
  readonly #endButton = make('button', { type: 'button', className: 'framed' });
  readonly #element = make(
    'div',
    { className: 'what-if', part: 'what-if', role: 'alert', hidden: true },
    this.#text,
    this.#endButton,
  );
  readonly elements = { pictures: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#endButton.addEventListener('click', () => {
      const hadFocus = shell.root.activeElement === this.#endButton;
      shell.editor.endTrial();
      // The button is now hidden.
      if (hadFocus) shell.editor.focus();
    });
  }

  set language(language: Language) {
    setText(this.#endButton, WORDS[language].back);
    this.onTrialChanged();
  }

  onTrialChanged(): void {
    const texts = WORDS[this.#shell.language];
    const { tried } = this.#shell.editor;
    this.#element.hidden = tried.length === 0;
    const values = tried.map(({ variable, value }) => `#${variable} = ${value}`).join(', ');
    setText(this.#text, tried.length === 0 ? '' : texts.whatIf(values));
  }
}

const WORDS = words({
  en: {
    whatIf: (values: string) => `What if ${values}? This is not the program as written.`,
    back: 'As written',
  },
  zh: {
    whatIf: (values) => `假如 ${values}：这不是程序原文的结果。`,
    back: '恢复原文',
  },
  ru: {
    whatIf: (values) => `Что если ${values}? Это не программа в том виде, как она написана.`,
    back: 'Как написано',
  },
});
