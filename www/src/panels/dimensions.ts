// The menu "Dimensions": which dimensions and letters the picture shows, and measuring.
//
// In: the choice, and the events of runs. Out: a command for the worker; the questions at the cursor and at the end of
// a run make the annotations. Must not know: how they are made or drawn.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { Menu, menuItem } from '../dom/menu';
import { words } from '../dom/words';
import { ANNOTATE_CHOICES, type AnnotateChoice, type Command } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { Measuring } from './measuring';
import {
  isInProgram,
  type Key,
  type Panel,
  type PanelKind,
  type Services,
  type Shell,
  type UserCommand,
} from './panel';
import dimensionsStyles from './dimensions.css?inline';

export const dimensions: PanelKind = {
  control: 'views',
  styles: dimensionsStyles,
  make: (shell) => new Dimensions(shell),
};

class Dimensions implements Panel {
  readonly #shell: Shell;
  readonly #items: Readonly<Record<AnnotateChoice, HTMLButtonElement>>;
  readonly #menu: Menu;
  /** In the menu ⋯ where there is no room for the button. */
  readonly #opener = menuItem({ className: 'dimensions-opener', 'aria-haspopup': 'menu' });
  /** The user's choice; undefined: that of the attribute. */
  #choice: AnnotateChoice | undefined;
  readonly #measure = menuItem({ role: 'menuitemcheckbox' });
  readonly #measuring: Measuring;
  readonly elements: Panel['elements'];
  readonly services: Partial<Services> = {
    measureAt: (x, y) => {
      if (this.#measuring.isOn) void this.#measuring.pick(x, y);
      return this.#measuring.isOn;
    },
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    const makeItem = (choice: AnnotateChoice): HTMLButtonElement => {
      const item = menuItem({ role: 'menuitemradio' });
      item.addEventListener('click', () => this.#choose(choice));
      return item;
    };
    this.#items = {
      none: makeItem('none'),
      word: makeItem('word'),
      cycle: makeItem('cycle'),
      part: makeItem('part'),
    };
    this.#menu = new Menu(
      'dimensions',
      [icon('dimensions')],
      [...ANNOTATE_CHOICES.map((choice) => this.#items[choice]), make('hr'), this.#measure],
    );
    this.#measuring = new Measuring(shell);
    this.#measure.addEventListener('click', () => this.#measuring.set(!this.#measuring.isOn));
    this.#opener.addEventListener('click', () => {
      const more = shell.frame.querySelector<HTMLElement>('.more-button');
      if (more !== null) this.#menu.openAt(more);
    });
    this.elements = {
      views: [this.#menu.button],
      'more-menu': [this.#opener],
      pictures: [this.#measuring.note],
      dialogs: [this.#menu.element],
    };
    this.#menu.element.addEventListener('beforetoggle', () => this.#show());
  }

  set language(language: Language) {
    const texts = WORDS[language];
    setAccessibleName(this.#menu.button, texts.dimensions);
    this.#menu.label = texts.dimensions;
    this.#opener.textContent = texts.dimensions;
    for (const choice of ANNOTATE_CHOICES) this.#items[choice].textContent = texts[choice];
    this.#measure.textContent = texts.measure;
    this.#measuring.show();
  }

  get commands(): readonly UserCommand[] {
    const texts = WORDS[this.#shell.language];
    return [
      ...ANNOTATE_CHOICES.map((choice) => ({ name: texts[choice], run: () => this.#choose(choice) })),
      { name: texts.measure, run: () => this.#measuring.set(true) },
    ];
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    this.#measuring.unit = event.report.units.shown;
    this.#measuring.show();
  }

  onInputChanged(): void {
    this.#measuring.restart();
  }

  onKey(key: Key): 'handled' | 'ignored' {
    if (key.event.key !== 'Escape' || !this.#measuring.isOn || isInProgram(key, this.#shell)) return 'ignored';
    this.#measuring.set(false);
    return 'handled';
  }

  #choose(choice: AnnotateChoice): void {
    this.#choice = choice;
    this.#shell.send({ kind: 'annotate', choice });
    // The answer about the block at the cursor makes its annotations.
    const { editor } = this.#shell;
    void this.#shell.ask('help', { by: 'cursor', about: 'block', offset: editor.cursor, time: undefined });
  }

  onWorkerConnected(send: (command: Command) => void): void {
    if (this.#choice !== undefined) send({ kind: 'annotate', choice: this.#choice });
    this.#measuring.sendInitial(send);
  }

  #show(): void {
    const current = this.#choice ?? this.#shell.annotate;
    for (const choice of ANNOTATE_CHOICES) this.#items[choice].setAttribute('aria-checked', String(choice === current));
    this.#measure.setAttribute('aria-checked', String(this.#measuring.isOn));
  }
}

const WORDS = words({
  en: {
    dimensions: 'Dimensions',
    none: 'No dimensions',
    word: 'Dimension of the word at the cursor',
    cycle: 'Letters and dimensions of the cycle',
    part: 'Dimensions of the part',
    measure: 'Measure',
  },
  zh: {
    dimensions: '尺寸',
    none: '不显示尺寸',
    word: '光标处程序字的尺寸',
    cycle: '循环的字母与尺寸',
    part: '零件尺寸',
    measure: '测量',
  },
  ru: {
    dimensions: 'Размеры',
    none: 'Без размеров',
    word: 'Размер слова у курсора',
    cycle: 'Буквы и размеры цикла',
    part: 'Размеры детали',
    measure: 'Измерить',
  },
});
