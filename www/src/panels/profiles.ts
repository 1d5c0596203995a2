// The machine of the program: the button that shows it, and the dialog in which machines and tool tables are stored
// under names.
//
// In: the profiles of the run. Out: the setup with another profile. Must not know: what belongs to a machine.

import { make, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { ProfileKind } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Services, Shell } from './panel';
import type { ProfilesDialog } from './profiles-dialog';
import {
  chooseMachine,
  chosenMachine,
  machineName,
  machineSetup,
  storedProfile,
  type MachineChoice,
} from './stored-profiles';
import profilesStyles from './profiles.css?inline';

export const profiles: PanelKind = {
  control: 'setup',
  edits: true,
  styles: profilesStyles,
  make: (shell) => new Profiles(shell),
};

class Profiles implements Panel {
  readonly #shell: Shell;
  readonly #button = make('button', { type: 'button', className: 'framed', 'aria-haspopup': 'dialog' });
  /** Loaded when it is first opened. */
  #dialog: ProfilesDialog | undefined;
  /** The chosen machine if the program runs on it. */
  #machine: MachineChoice | undefined;
  readonly elements = {};
  readonly services: Partial<Services> = {
    machineButton: () => this.#button,
    defaultSetup: () => chosenMachine()?.json ?? null,
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#button.addEventListener('click', () => void this.#open());
  }

  set language(language: Language) {
    if (this.#dialog !== undefined) this.#dialog.language = language;
    this.#render();
  }

  get capturesKeys(): boolean {
    return this.#dialog?.open ?? false;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report') void this.#compareMachines();
  }

  /**
   * Compares the machine of the program with the chosen one: an example has its own, and a comment may name another.
   */
  async #compareMachines(): Promise<void> {
    const chosen = chosenMachine();
    const current =
      chosen === undefined ? undefined : await this.#shell.ask('profiles-of-run', { json: this.#shell.setup ?? '{}' });
    const chosenProfiles =
      chosen === undefined ? undefined : await this.#shell.ask('profiles-in', { json: chosen.json });
    const same =
      chosenProfiles?.kind === 'profiles' &&
      current !== undefined &&
      current.machine === chosenProfiles.profiles.machine;
    this.#machine = same ? chosen?.machine : undefined;
    this.#render();
  }

  #render(): void {
    const { language } = this.#shell;
    const texts = WORDS[language];
    setText(
      this.#button,
      this.#machine === undefined ? texts.choose : texts.machine(machineName(this.#machine, language)),
    );
  }

  async #open(): Promise<void> {
    const [current, part] = await Promise.all([
      this.#shell.ask('profiles-of-run', { json: this.#shell.setup ?? '{}' }),
      loadPart(
        this.#shell,
        () => import('./profiles-dialog'),
        () => void this.#open(),
      ),
      this.#compareMachines(),
    ]);
    if (part === undefined) return;
    if (this.#dialog === undefined) {
      this.#dialog = new part.ProfilesDialog(this.#shell.language, {
        onUseMachine: (machine) => void this.#useMachine(machine),
        onUseTools: (name) => void this.#apply('tools', storedProfile('tools', name), name),
        read: (json) => this.#shell.ask('profiles-in', { json }),
        onChange: () => void this.#compareMachines(),
      });
      this.#shell.region('dialogs').append(this.#dialog.element);
    }
    this.#dialog.show(current ?? {}, this.#machine);
  }

  /** Undefined: the program runs on no particular machine. */
  async #useMachine(machine: MachineChoice | undefined): Promise<void> {
    chooseMachine(machine);
    const name = machine === undefined ? undefined : machineName(machine, this.#shell.language);
    await this.#apply('machine', machine === undefined ? undefined : machineSetup(machine), name);
    void this.#compareMachines();
  }

  async #apply(kind: ProfileKind, profile: string | undefined, name: string | undefined): Promise<void> {
    const json = this.#shell.setup ?? '{}';
    const setup = await this.#shell.ask('with-profile', { json, kind, profile: profile ?? '{}' });
    if (setup === undefined) return;
    this.#shell.changeSetup(setup === '' ? null : setup);
    this.#shell.service('notice')(WORDS[this.#shell.language].applied(name), 'program-setup');
  }
}

const WORDS = words({
  en: {
    choose: 'Choose machine',
    machine: (name: string) => `Machine: ${name}`,
    applied: (name: string | undefined) =>
      name === undefined
        ? 'No machine is chosen now.'
        : `${name} is in the setup of this page now. Comments of the program override it.`,
  },
  zh: {
    choose: '选择机床',
    machine: (name) => `机床：${name}`,
    applied: (name) => (name === undefined ? '现在未选择机床。' : `${name} 已写入本页的设置。程序注释优先。`),
  },
  ru: {
    choose: 'Выбрать станок',
    machine: (name) => `Станок: ${name}`,
    applied: (name) =>
      name === undefined
        ? 'Станок не выбран.'
        : `${name}: наладка этой страницы. Комментарии программы имеют приоритет.`,
  },
});
