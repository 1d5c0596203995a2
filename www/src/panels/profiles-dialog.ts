// The dialog in which machines and tool tables are stored under names, applied, exported and imported. It also offers
// example machines. A file contains a setup, as the command line reads it.
//
// In: the profiles of the run. Out: the profile that the user applies. Must not know: the contents of a profile.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import { download } from '../editor/program-files';
import type { ProfileKind, ProfilesResult, Profiles } from '../protocol/protocol';
import { EXAMPLE_MACHINE_IDS, EXAMPLE_MACHINES } from './example-machines';
import { MM_PER_UNIT } from './lengths';
import {
  chosenMachine,
  deleteProfile,
  machineName,
  saveProfile,
  storedProfile,
  storedProfileNames,
  type MachineChoice,
} from './stored-profiles';

/** A setup is short: a longer file is rejected. */
const MAX_FILE_BYTES = 1 << 20;
const KINDS = ['machine', 'tools'] as const;

interface ProfilesEvents {
  /** Undefined: no particular machine. */
  onUseMachine(machine: MachineChoice | undefined): void;
  onUseTools(name: string): void;
  /** Undefined if there is no worker. */
  read(json: string): Promise<ProfilesResult | undefined>;
  /** The stored profiles have changed. */
  onChange(): void;
}

export class ProfilesDialog {
  readonly #events: ProfilesEvents;
  readonly #lists = make('div', { className: 'profile-lists' });
  readonly #import = make('button', { type: 'button', className: 'framed' });
  readonly #file = make('input', { type: 'file', hidden: true, accept: '.json,application/json' });
  readonly #status = make('p', { className: 'news', role: 'status' });
  readonly #dialog: Dialog;
  #language: Language;
  /** The profiles of the program, and its machine, if it is the chosen one. */
  #current: Profiles = {};
  #machine: MachineChoice | undefined;

  constructor(language: Language, events: ProfilesEvents) {
    this.#language = language;
    this.#events = events;
    this.#dialog = new Dialog(
      'profiles',
      [make('div', { className: 'text' }, this.#lists), this.#file],
      [this.#status, this.#import],
    );
    this.#import.addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const file = this.#file.files?.[0];
      this.#file.value = '';
      if (file !== undefined) void this.#importFile(file);
    });
    this.language = language;
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    this.#dialog.setTexts(texts.title, COMMON[language].close);
    this.#dialog.about = texts.about;
    this.#import.textContent = texts.import;
    this.#file.setAttribute('aria-label', texts.import);
    this.#render();
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  show(own: Profiles, machine: MachineChoice | undefined): void {
    this.#current = own;
    this.#machine = machine;
    this.#status.textContent = '';
    this.#render();
    this.#dialog.show();
  }

  #render(): void {
    this.#lists.replaceChildren(...KINDS.map((kind) => this.#renderList(kind)));
  }

  #renderList(kind: ProfileKind): HTMLElement {
    const texts = WORDS[this.#language];
    const title = texts.titles[kind];
    const rows = storedProfileNames(kind).map((name) => this.#renderRow(kind, name));
    const none = kind === 'machine' && chosenMachine() !== undefined ? [this.#noMachineRow()] : [];
    const list = [...none, ...rows];
    return make(
      'section',
      { 'aria-label': title },
      make('h3', {}, title),
      ...(rows.length === 0 ? [make('p', { className: 'about' }, texts.nothing[kind])] : []),
      ...(list.length === 0 ? [] : [make('ul', {}, ...list)]),
      this.#saveForm(kind),
      ...(kind === 'machine' ? this.#renderExamples() : []),
    );
  }

  #renderExamples(): HTMLElement[] {
    const texts = WORDS[this.#language];
    const rows = EXAMPLE_MACHINE_IDS.map((id) => {
      const machine: MachineChoice = { from: 'examples', id };
      const { dialect, machine: values } = EXAMPLE_MACHINES[id];
      const { rapidX, rapidZ, maxSpeed, turret } = values;
      const { unit = 'mm' } = dialect;
      const format = new Intl.NumberFormat(this.#language, { maximumFractionDigits: 0 });
      const numbers = [rapidX, rapidZ].map((rate) => format.format(rate / MM_PER_UNIT[unit])).join(' / ');
      const rates = `${numbers} ${texts.rate[unit]}`;
      return make(
        'li',
        {},
        make(
          'span',
          { className: 'profile-name' },
          this.#nameOf(machine),
          make('span', { className: 'profile-facts' }, texts.facts(rates, maxSpeed, texts.turret[turret ?? 'rear'])),
        ),
        this.#button(texts.use, machine, () => this.#useMachine(machine)),
      );
    });
    return [
      make('h4', {}, texts.examples),
      make('p', { className: 'about' }, texts.aboutExamples),
      make('ul', { 'aria-label': texts.examples }, ...rows),
    ];
  }

  #renderRow(kind: ProfileKind, name: string): HTMLElement {
    const texts = WORDS[this.#language];
    const profile: MachineChoice = { from: 'stored', name };
    return make(
      'li',
      {},
      make('span', { className: 'profile-name' }, kind === 'machine' ? this.#nameOf(profile) : name),
      this.#button(texts.use, profile, () => {
        if (kind === 'machine') return this.#useMachine(profile);
        this.#dialog.close();
        this.#events.onUseTools(name);
      }),
      this.#button(texts.export, profile, () =>
        download(`${name}.json`, new TextEncoder().encode(storedProfile(kind, name) ?? '{}')),
      ),
      this.#button(texts.delete, profile, () => {
        deleteProfile(kind, name);
        this.#onStored(texts.deleted(name));
      }),
    );
  }

  #button(text: string, profile: MachineChoice, act: () => void): HTMLElement {
    const label = `${text}: ${machineName(profile, this.#language)}`;
    const button = make('button', { type: 'button', className: 'framed', 'aria-label': label }, text);
    button.addEventListener('click', act);
    return button;
  }

  #nameOf(machine: MachineChoice): string {
    const name = machineName(machine, this.#language);
    return this.#isInUse(machine) ? WORDS[this.#language].inUse(name) : name;
  }

  /** The chosen machine or, without one, a kept machine with the values of the program's machine. */
  #isInUse(machine: MachineChoice): boolean {
    const chosen = this.#machine;
    if (chosen !== undefined)
      return (
        chosen.from === machine.from && machineName(chosen, this.#language) === machineName(machine, this.#language)
      );
    return (
      machine.from === 'stored' &&
      this.#current.machine !== undefined &&
      storedProfile('machine', machine.name) === this.#current.machine
    );
  }

  #useMachine(machine: MachineChoice | undefined): void {
    this.#dialog.close();
    this.#events.onUseMachine(machine);
  }

  /** The button that returns to no particular machine. */
  #noMachineRow(): HTMLElement {
    const texts = WORDS[this.#language];
    const button = make('button', { type: 'button', className: 'framed' }, texts.noMachine);
    button.addEventListener('click', () => this.#useMachine(undefined));
    return make('li', {}, button);
  }

  /** Stores the current profile of the program under a name. */
  #saveForm(kind: ProfileKind): HTMLElement {
    const texts = WORDS[this.#language];
    const json = this.#current[kind];
    if (json === undefined) return make('p', { className: 'about' }, texts.nothingSet[kind]);
    const input = make('input', {
      type: 'text',
      id: `keep-${kind}`,
      required: true,
      maxLength: 60,
      autocomplete: 'off',
    });
    const form = make(
      'form',
      {},
      make('label', { htmlFor: input.id }, texts.saveAs[kind]),
      input,
      make('button', { type: 'submit', className: 'framed', 'aria-label': texts.saveAs[kind] }, texts.save),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const name = input.value.trim();
      if (name === '') return;
      saveProfile(kind, name, json);
      this.#onStored(texts.saved(name));
    });
    return form;
  }

  async #importFile(file: File): Promise<void> {
    const texts = WORDS[this.#language];
    if (file.size > MAX_FILE_BYTES) return this.#showStatus(texts.noSetup(file.name));
    const answer = await this.#events.read(await file.text());
    if (answer === undefined) return;
    if (answer.kind === 'invalid') return this.#showStatus(texts.wrong(file.name, answer.reason));
    const name = file.name.replace(/\.json$/i, '');
    const kinds = KINDS.filter((kind) => answer.profiles[kind] !== undefined);
    for (const kind of kinds) saveProfile(kind, name, answer.profiles[kind] ?? '{}');
    this.#onStored(kinds.length === 0 ? texts.noSetup(file.name) : texts.saved(name));
  }

  #onStored(news: string): void {
    this.#render();
    this.#showStatus(news);
    this.#events.onChange();
  }

  #showStatus(news: string): void {
    this.#status.textContent = news;
  }
}

const WORDS = words({
  en: {
    title: 'Machines and tool tables',
    about:
      'Kept in this browser. A file contains a setup, which the command line reads with --setup. Your own programs begin with the machine you use.',
    titles: { machine: 'Machines', tools: 'Tool tables' },
    nothing: { machine: 'No machine is kept yet.', tools: 'No tool table is kept yet.' },
    nothingSet: {
      machine: 'The setup has no machine. Enter it in the setup form, then keep it here.',
      tools: 'The setup has no tools. Enter them in the setup form, then keep them here.',
    },
    saveAs: { machine: 'Keep the machine of this program as', tools: 'Keep the tools of this program as' },
    save: 'Keep',
    saved: (name: string) => `${name} is kept.`,
    use: 'Use',
    inUse: (name: string) => `${name} (in use)`,
    noMachine: 'Use no machine',
    examples: 'Example machines',
    aboutExamples: 'Example values: put in those of your machine in the setup form, then keep it here.',
    facts: (rates: string, speed: number, turret: string) => `rapid traverse ${rates}, up to ${speed} rpm, ${turret}`,
    rate: { mm: 'mm/min', inch: 'in/min' },
    turret: { rear: 'rear turret', front: 'front turret' },
    export: 'Export',
    delete: 'Delete',
    deleted: (name: string) => `${name} is deleted.`,
    import: 'Import file',
    noSetup: (file: string) => `${file} contains neither a machine nor tools.`,
    wrong: (file: string, reason: string) => `${file} is not a setup: ${reason}`,
  },
  zh: {
    title: '机床与刀具表',
    about: '保存在此浏览器中。文件内容为设置，命令行用 --setup 读取。您自己的程序从所用机床开始。',
    titles: { machine: '机床', tools: '刀具表' },
    nothing: { machine: '尚未保存机床。', tools: '尚未保存刀具表。' },
    nothingSet: {
      machine: '设置中没有机床。请先在设置表中填写，再保存到这里。',
      tools: '设置中没有刀具。请先在设置表中填写，再保存到这里。',
    },
    saveAs: { machine: '将此程序的机床保存为', tools: '将此程序的刀具保存为' },
    save: '保存',
    saved: (name) => `已保存 ${name}。`,
    use: '使用',
    inUse: (name) => `${name}（使用中）`,
    noMachine: '不使用机床',
    examples: '示例机床',
    aboutExamples: '数值仅为示例：请在设置表中改为您机床的数值，再保存到这里。',
    facts: (rates, speed, turret) => `快速移动 ${rates}，最高 ${speed} r/min，${turret}`,
    rate: { mm: 'mm/min', inch: 'in/min' },
    turret: { rear: '后置刀架', front: '前置刀架' },
    export: '导出',
    delete: '删除',
    deleted: (name) => `已删除 ${name}。`,
    import: '导入文件',
    noSetup: (file) => `${file} 中既没有机床，也没有刀具。`,
    wrong: (file, reason) => `${file} 不是设置：${reason}`,
  },
  ru: {
    title: 'Станки и таблицы инструментов',
    about:
      'Хранятся в этом браузере. В файле наладка, которую командная строка читает с --setup. Ваши программы начинаются с выбранного станка.',
    titles: { machine: 'Станки', tools: 'Таблицы инструментов' },
    nothing: { machine: 'Станков пока нет.', tools: 'Таблиц инструментов пока нет.' },
    nothingSet: {
      machine: 'В наладке нет станка. Укажите его в форме наладки и сохраните здесь.',
      tools: 'В наладке нет инструментов. Укажите их в форме наладки и сохраните здесь.',
    },
    saveAs: { machine: 'Сохранить станок этой программы как', tools: 'Сохранить инструменты этой программы как' },
    save: 'Сохранить',
    saved: (name) => `Сохранено: ${name}.`,
    use: 'Выбрать',
    inUse: (name) => `${name} (выбран)`,
    noMachine: 'Без станка',
    examples: 'Примеры станков',
    aboutExamples: 'Значения — пример: укажите в форме наладки значения своего станка и сохраните его здесь.',
    facts: (rates, speed, turret) => `ускоренное перемещение ${rates}, до ${speed} об/мин, ${turret}`,
    rate: { mm: 'мм/мин', inch: 'дюйм/мин' },
    turret: { rear: 'головка за осью шпинделя', front: 'головка перед осью шпинделя' },
    export: 'Экспорт',
    delete: 'Удалить',
    deleted: (name) => `Удалено: ${name}.`,
    import: 'Импорт файла',
    noSetup: (file) => `В файле ${file} нет ни станка, ни инструментов.`,
    wrong: (file, reason) => `${file} — не наладка: ${reason}`,
  },
});
