// The command palette: every action by name, the ones used last first.
//
// In: the commands of the element. Out: the command that the user chooses. Loaded when it is first opened. Must not
// know: the effect of a command.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { UserCommand } from '../panels/panel';
import '../dom/dialog.css';
import './palette.css';
import { readChoices, saveChoices } from './storage';

/** Number of names of recent commands that are kept. */
const MAX_RECENT = 8;

class Palette {
  readonly #field = make('input', {
    type: 'text',
    role: 'combobox',
    autocomplete: 'off',
    spellcheck: false,
    'aria-expanded': 'true',
    'aria-controls': 'palette-list',
    'aria-autocomplete': 'list',
  });
  readonly #list = make('ul', { id: 'palette-list', role: 'listbox' });
  readonly #dialog = new Dialog('palette', [this.#field, this.#list]);
  #commands: readonly UserCommand[] = [];
  #found: readonly UserCommand[] = [];
  #active = 0;

  constructor() {
    this.#field.addEventListener('input', () => this.#find());
    this.#field.addEventListener('keydown', (event) => this.#handleKey(event));
    document.body.append(this.#dialog.element);
  }

  open(commands: readonly UserCommand[], language: Language): void {
    const texts = WORDS[language];
    this.#commands = byRecent(commands);
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#field.setAttribute('aria-label', texts.title);
    this.#field.placeholder = texts.hint;
    this.#list.setAttribute('aria-label', texts.title);
    this.#field.value = '';
    this.#dialog.show();
    this.#field.focus();
    this.#find();
  }

  #find(): void {
    const typed = this.#field.value.trim().toLocaleLowerCase();
    const terms = typed.split(/\s+/);
    const found = this.#commands.filter(({ name }) => terms.every((term) => name.toLocaleLowerCase().includes(term)));
    // The whole name first.
    const isWhole = ({ name }: UserCommand): boolean => name.toLocaleLowerCase() === typed;
    this.#found = [...found.filter(isWhole), ...found.filter((command) => !isWhole(command))];
    this.#list.replaceChildren(
      ...this.#found.map((command, at) => {
        const keys = command.keys === undefined ? [] : [make('kbd', {}, command.keys)];
        const option = make('li', { id: `palette-${at}`, role: 'option' }, make('span', {}, command.name), ...keys);
        option.addEventListener('click', () => this.#run(command));
        return option;
      }),
    );
    this.#activate(0);
  }

  #activate(index: number): void {
    this.#active = Math.min(Math.max(index, 0), this.#found.length - 1);
    for (const [at, option] of [...this.#list.children].entries())
      option.setAttribute('aria-selected', String(at === this.#active));
    const active = this.#list.children[this.#active];
    active?.scrollIntoView({ block: 'nearest' });
    if (active === undefined) this.#field.removeAttribute('aria-activedescendant');
    else this.#field.setAttribute('aria-activedescendant', active.id);
  }

  #handleKey(event: KeyboardEvent): void {
    const command = this.#found[this.#active];
    if (event.key === 'ArrowDown') this.#activate(this.#active + 1);
    else if (event.key === 'ArrowUp') this.#activate(this.#active - 1);
    else if (event.key === 'Enter' && command !== undefined) this.#run(command);
    else return;
    event.preventDefault();
  }

  #run(command: UserCommand): void {
    this.#dialog.close();
    const others = recentNames().filter((name) => name !== command.name);
    saveChoices({ recent: JSON.stringify([command.name, ...others].slice(0, MAX_RECENT)) });
    command.run();
  }
}

/** Names of the commands used last, in the language in which they were used. */
function recentNames(): readonly string[] {
  try {
    const names: unknown = JSON.parse(readChoices().recent ?? '[]');
    return Array.isArray(names) ? names.filter((name) => typeof name === 'string') : [];
  } catch {
    return [];
  }
}

function byRecent(commands: readonly UserCommand[]): readonly UserCommand[] {
  const recent = recentNames();
  const used = recent.flatMap((name) => commands.find((command) => command.name === name) ?? []);
  return [...used, ...commands.filter((command) => !used.includes(command))];
}

let palette: Palette | undefined;

export function openPalette(commands: readonly UserCommand[], language: Language): void {
  palette ??= new Palette();
  palette.open(commands, language);
}

const WORDS = words({
  en: { title: 'Commands', hint: 'What do you want to do?' },
  zh: { title: '命令', hint: '要做什么？' },
  ru: { title: 'Команды', hint: 'Что сделать?' },
});
