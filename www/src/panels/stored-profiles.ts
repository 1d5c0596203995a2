// The machines and tool tables that this browser stores under names.
//
// In and out: names, and setups as JSON. A failure to store (private mode, quota) is not an error: nothing is stored.
// Must not know: the contents of a setup.

import type { ProfileKind } from '../protocol/protocol';

interface StoredProfiles {
  readonly machine: Readonly<Record<string, string>>;
  readonly tools: Readonly<Record<string, string>>;
  /** Name of the user's default machine for new programs. */
  readonly chosen?: string;
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
  const others = Object.fromEntries(Object.entries(all[kind]).filter(([storedName]) => storedName !== name));
  save({
    ...all,
    [kind]: others,
    ...(chosen === undefined || (kind === 'machine' && chosen === name) ? {} : { chosen }),
  });
}

/** The user's default machine for new programs. */
export function chosenMachine(): { readonly name: string; readonly json: string } | undefined {
  const { machine, chosen } = load();
  const json = chosen === undefined ? undefined : machine[chosen];
  return chosen === undefined || json === undefined ? undefined : { name: chosen, json };
}

export function chooseMachine(name: string | undefined): void {
  const { chosen: _, ...all } = load();
  save({ ...all, ...(name === undefined ? {} : { chosen: name }) });
}

function load(): StoredProfiles {
  const none: StoredProfiles = { machine: {}, tools: {} };
  try {
    const all = Object(JSON.parse(localStorage.getItem(KEY) ?? '{}')) as Partial<Record<keyof StoredProfiles, unknown>>;
    const { chosen } = all;
    return {
      machine: stringsIn(all.machine),
      tools: stringsIn(all.tools),
      ...(typeof chosen === 'string' ? { chosen } : {}),
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
