// The machines and tool tables that this browser stores under names, and the machine chosen for new programs.
//
// In and out: names, and setups as JSON. A failure to store (private mode, quota) is not an error: nothing is stored.
// Must not know: the contents of a setup.

import type { Language } from '../dom/language';
import type { ProfileKind } from '../protocol/protocol';
import { EXAMPLE_MACHINES, exampleMachineName, isExampleMachine, type ExampleMachineId } from './example-machines';

/** A machine that the user keeps under a name, or an example. */
export type MachineChoice =
  | { readonly from: 'stored'; readonly name: string }
  | { readonly from: 'examples'; readonly id: ExampleMachineId };

interface StoredProfiles {
  readonly machine: Readonly<Record<string, string>>;
  readonly tools: Readonly<Record<string, string>>;
  /** Name of the user's default machine for new programs. */
  readonly chosen?: string;
  /** Instead of `chosen`: an example machine. */
  readonly chosenExample?: ExampleMachineId;
}

const KEY = 'gcode-playground:profiles';

export function storedProfileNames(kind: ProfileKind): readonly string[] {
  return Object.keys(load()[kind]).sort((a, b) => a.localeCompare(b));
}

export function storedProfile(kind: ProfileKind, name: string): string | undefined {
  return load()[kind][name];
}

export function saveProfile(kind: ProfileKind, name: string, json: string): void {
  const all = load();
  save({ ...all, [kind]: { ...all[kind], [name]: json } });
}

export function deleteProfile(kind: ProfileKind, name: string): void {
  const { chosen, ...all } = load();
  const isChosen = kind === 'machine' && chosen === name;
  const others = Object.fromEntries(Object.entries(all[kind]).filter(([storedName]) => storedName !== name));
  save({
    ...all,
    [kind]: others,
    ...(chosen === undefined || isChosen ? {} : { chosen }),
  });
}

export function machineName(machine: MachineChoice, language: Language): string {
  return machine.from === 'stored' ? machine.name : exampleMachineName(machine.id, language);
}

/** The setup of a machine, JSON; undefined if it is no longer stored. */
export function machineSetup(machine: MachineChoice): string | undefined {
  return machine.from === 'stored'
    ? storedProfile('machine', machine.name)
    : JSON.stringify(EXAMPLE_MACHINES[machine.id]);
}

/** The user's default machine for new programs. */
export function chosenMachine(): { readonly machine: MachineChoice; readonly json: string } | undefined {
  const { chosen, chosenExample } = load();
  const machine: MachineChoice | undefined =
    chosen !== undefined
      ? { from: 'stored', name: chosen }
      : chosenExample === undefined
        ? undefined
        : { from: 'examples', id: chosenExample };
  const json = machine === undefined ? undefined : machineSetup(machine);
  return machine === undefined || json === undefined ? undefined : { machine, json };
}

export function chooseMachine(machine: MachineChoice | undefined): void {
  const { chosen: _, chosenExample: __, ...all } = load();
  const choice =
    machine === undefined ? {} : machine.from === 'stored' ? { chosen: machine.name } : { chosenExample: machine.id };
  save({ ...all, ...choice });
}

function load(): StoredProfiles {
  const none: StoredProfiles = { machine: {}, tools: {} };
  try {
    const all = Object(JSON.parse(localStorage.getItem(KEY) ?? '{}')) as Partial<Record<keyof StoredProfiles, unknown>>;
    const { chosen, chosenExample } = all;
    return {
      machine: stringsIn(all.machine),
      tools: stringsIn(all.tools),
      ...(typeof chosen === 'string' ? { chosen } : {}),
      ...(typeof chosenExample === 'string' && isExampleMachine(chosenExample) ? { chosenExample } : {}),
    };
  } catch {
    return none;
  }
}

function stringsIn(value: unknown): Record<string, string> {
  const entries = Object.entries(Object(value) as Record<string, unknown>);
  return Object.fromEntries(entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'));
}

function save(all: StoredProfiles): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(all));
  } catch {
    // The current setup is not affected; it is only not stored.
  }
}
