// The line that says how the program was read, and for which machine. Each fact that a setting determines is a link to
// its field in the setup form.
//
// In: the facts of the newest run, as text. Out: the field to open. Must not know: the meaning of a fact.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { ReadAs, ReadFact } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import readAsStyles from './read-as.css?inline';

export const readAs: PanelKind = { control: 'setup', styles: readAsStyles, make: (shell) => new ReadAsLine(shell) };

/** The field that is opened by "change". */
const FIRST_FIELD = 'dialect.control';

class ReadAsLine implements Panel {
  readonly #shell: Shell;
  readonly #facts = make('span', { className: 'facts-read' });
  readonly #change = make('button', { type: 'button', className: 'change quiet' });
  readonly #element = make('div', { className: 'read-as', part: 'read-as', role: 'group' }, this.#facts, this.#change);
  #hasMachine = false;
  #read: ReadAs | undefined;
  #isReading = true;
  /** The rendered facts as text: an unchanged line is not rebuilt, so that a fact keeps the focus. */
  #renderedKey = '';
  readonly elements = { bar: [this.#element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#change.addEventListener('click', () => this.#openField(this.#read?.facts[0]?.key ?? FIRST_FIELD));
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#element.setAttribute('aria-label', texts.name);
    this.#change.textContent = texts.change;
    this.#change.setAttribute('aria-label', texts.changeName);
    // The language is first set after all panels are made, so the services of other panels exist.
    if (!this.#hasMachine) this.#element.append(this.#shell.service('machineButton')());
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
    const list = facts.flatMap((fact, at) => [at === 0 ? ' ' : texts.comma, this.#renderFact(fact)]);
    this.#facts.replaceChildren(facts.length === 0 ? placeholder : texts.readAs, ...list);
  }

  #renderFact({ key, text, basis }: ReadFact): HTMLElement {
    const texts = WORDS[this.#shell.language];
    const label = basis === 'recognised' ? texts.recognised(text) : basis === 'set' ? texts.set(text) : text;
    const className = `fact ${basis}`;
    if (key === undefined) return make('span', { className }, label);
    const button = make('button', { type: 'button', className }, label);
    button.addEventListener('click', () => this.#openField(key));
    return button;
  }

  #openField(key: string): void {
    this.#shell.service('openSetup')('control', key);
  }
}

const WORDS = words({
  en: {
    name: 'How the program was read',
    readAs: 'Read as',
    reading: 'Reading …',
    notRead: 'Not read',
    comma: ', ',
    /** Recognised from the program. */
    recognised: (fact: string) => `${fact} (recognised)`,
    /** Given by the setup. */
    set: (fact: string) => `${fact} (set)`,
    change: 'change',
    changeName: 'change how the program is read',
  },
  zh: {
    name: '程序的读法',
    readAs: '读作',
    reading: '正在读取……',
    notRead: '未读取',
    comma: '，',
    recognised: (fact) => `${fact}（识别）`,
    set: (fact) => `${fact}（设定）`,
    change: '更改',
    changeName: '更改程序的读法',
  },
  ru: {
    name: 'Как прочитана программа',
    readAs: 'Прочитано как',
    reading: 'Чтение …',
    notRead: 'Не прочитано',
    comma: ', ',
    recognised: (fact) => `${fact} (распознано)`,
    set: (fact) => `${fact} (задано)`,
    change: 'изменить',
    changeName: 'изменить чтение программы',
  },
});
