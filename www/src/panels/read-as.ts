// The chip over the program that says how it was read: control, unit, feed. Its popover says for which machine, and has
// the switches of the operator's panel. Each fact that a setting determines is a link to its field in the setup form.
//
// In: the facts of the newest run, as text. Out: the field to open. Must not know: the meaning of a fact.

import { icon, make } from '../dom/dom';
import type { Language } from '../dom/language';
import { placePopover, returnFocus } from '../dom/popover';
import { words } from '../dom/words';
import type { ReadAs, ReadFact } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import readAsStyles from './read-as.css?inline';

export const readAs: PanelKind = { control: 'setup', styles: readAsStyles, make: (shell) => new ReadAsChip(shell) };

/** The field that is opened by "change". */
const FIRST_FIELD = 'dialect.control';

class ReadAsChip implements Panel {
  readonly #shell: Shell;
  readonly #summary = make('span', { className: 'chip-text' });
  readonly #chip = make(
    'button',
    { type: 'button', className: 'chip', part: 'read-as', 'aria-haspopup': 'dialog', 'aria-expanded': 'false' },
    this.#summary,
    icon('chevron'),
  );
  readonly #facts = make('p', { className: 'facts-read' });
  readonly #change = make('button', { type: 'button', className: 'framed' });
  readonly #actions = make('div', { className: 'actions' }, this.#change);
  readonly #popover: HTMLElement;
  #hasMachine = false;
  #read: ReadAs | undefined;
  #isReading = true;
  /** The rendered facts as text: an unchanged line is not rebuilt, so that a fact keeps the focus. */
  #renderedKey = '';
  readonly elements: Panel['elements'];

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#popover = make(
      'div',
      { className: 'popover reading', part: 'reading', role: 'dialog', popover: 'auto' },
      this.#facts,
      shell.region('reading'),
      this.#actions,
    );
    this.#chip.popoverTargetElement = this.#popover;
    returnFocus(this.#chip, this.#popover);
    this.#popover.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.#chip.setAttribute('aria-expanded', String(open));
      if (open) placePopover(this.#chip, this.#popover);
    });
    this.#change.addEventListener('click', () => this.#openField(this.#read?.facts[0]?.key ?? FIRST_FIELD));
    this.elements = { bar: [this.#chip], dialogs: [this.#popover] };
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#popover.setAttribute('aria-label', texts.name);
    this.#chip.title = texts.name;
    this.#change.textContent = texts.change;
    // The language is first set after all panels are made, so the services of other panels exist.
    if (!this.#hasMachine) {
      const machine = this.#shell.service('machineButton')();
      machine.addEventListener('click', () => this.#close());
      this.#actions.append(machine);
    }
    this.#hasMachine = true;
    this.#render();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    this.#read = event.report.readAs;
    this.#render();
  }

  onRunStarted(): void {
    this.#isReading = true;
    this.#render();
  }

  onRunFailed(): void {
    this.#isReading = false;
    this.#read = undefined;
    this.#render();
  }

  #render(): void {
    const texts = WORDS[this.#shell.language];
    const facts = this.#read?.facts ?? [];
    const placeholder = this.#isReading ? texts.reading : texts.notRead;
    const shown = JSON.stringify([this.#shell.language, facts, facts.length === 0 ? placeholder : '']);
    if (shown === this.#renderedKey) return;
    this.#renderedKey = shown;
    // A line never begins with a comma.
    const list = facts.flatMap((fact, at) => {
      const comma = at === facts.length - 1 ? '' : texts.comma;
      return [at === 0 ? ' ' : texts.gap, make('span', { className: 'fact-and-comma' }, this.#renderFact(fact), comma)];
    });
    this.#facts.replaceChildren(facts.length === 0 ? placeholder : texts.readAs, ...list);
    const summary = facts.length === 0 ? placeholder : facts.map(({ text }) => text).join(' · ');
    this.#summary.textContent = summary;
    this.#chip.setAttribute('aria-label', `${texts.name}: ${summary}`);
  }

  #renderFact({ key, text, basis }: ReadFact): HTMLElement {
    const texts = WORDS[this.#shell.language];
    const label = basis === 'recognised' ? texts.recognised(text) : basis === 'set' ? texts.set(text) : text;
    const className = `fact ${basis}`;
    if (key === undefined) return make('span', { className }, label);
    const button = make('button', { type: 'button', className: `link ${className}` }, label);
    button.addEventListener('click', () => this.#openField(key));
    return button;
  }

  /** The dialog that is opened next returns the focus to the chip. */
  #close(): void {
    this.#popover.hidePopover();
    this.#chip.focus();
  }

  #openField(key: string): void {
    this.#close();
    this.#shell.service('openSetup')('control', key);
  }
}

const WORDS = words({
  en: {
    name: 'How the program was read',
    readAs: 'Read as',
    reading: 'Reading …',
    notRead: 'Not read',
    comma: ',',
    /** After the comma. */
    gap: ' ',
    /** Recognised from the program. */
    recognised: (fact: string) => `${fact} (recognised)`,
    /** Given by the setup. */
    set: (fact: string) => `${fact} (set)`,
    change: 'Change…',
  },
  zh: {
    name: '程序的读法',
    readAs: '读作',
    reading: '正在读取……',
    notRead: '未读取',
    comma: '，',
    gap: '',
    recognised: (fact) => `${fact}（识别）`,
    set: (fact) => `${fact}（设定）`,
    change: '更改…',
  },
  ru: {
    name: 'Как прочитана программа',
    readAs: 'Прочитано как',
    reading: 'Чтение …',
    notRead: 'Не прочитано',
    comma: ',',
    gap: ' ',
    recognised: (fact) => `${fact} (распознано)`,
    set: (fact) => `${fact} (задано)`,
    change: 'Изменить…',
  },
});
