// The machines and tool tables that this browser stores under names.
//
// In and out: names, and setups as JSON. A failure to store (private mode, quota) is not an error: nothing is stored.
// Must not know: the contents of a setup.

import type { ProfileKind } from '../protocol/protocol';

interface Kept {
  readonly machine: Readonly<Record<string, string>>;
  readonly tools: Readonly<Record<string, string>>;
  /** Name of the user's default machine for new programs. */
  readonly chosen?: string;
}

const KEY = 'gcode-playground:profiles';

export function profileNames(kind: ProfileKind): readonly string[] {
  return Object.keys(kept()[kind]).sort((a, b) => a.localeCompare(b));
}

export function profile(kind: ProfileKind, name: string): string | undefined {
  return kept()[kind][name];
}

export function keepProfile(kind: ProfileKind, name: string, json: string): void {
  const all = kept();
  keep({ ...all, [kind]: { ...all[kind], [name]: json } });
}

export function forgetProfile(kind: ProfileKind, name: string): void {
  const { chosen, ...all } = kept();
  const others = Object.fromEntries(Object.entries(all[kind]).filter(([own]) => own !== name));
  keep({
    ...all,
    [kind]: others,
    ...(chosen === undefined || (kind === 'machine' && chosen === name) ? {} : { chosen }),
  });
}

/** The user's default machine for new programs. */
export function chosenMachine(): { readonly name: string; readonly json: string } | undefined {
  const { machine, chosen } = kept();
  const json = chosen === undefined ? undefined : machine[chosen];
  return chosen === undefined || json === undefined ? undefined : { name: chosen, json };
}

export function chooseMachine(name: string | undefined): void {
  const { chosen: _, ...all } = kept();
  keep({ ...all, ...(name === undefined ? {} : { chosen: name }) });
}

function kept(): Kept {
  const none: Kept = { machine: {}, tools: {} };
  try {
    const all = Object(JSON.parse(localStorage.getItem(KEY) ?? '{}')) as Partial<Record<keyof Kept, unknown>>;
    const { chosen } = all;
    return { machine: texts(all.machine), tools: texts(all.tools), ...(typeof chosen === 'string' ? { chosen } : {}) };
  } catch {
    return none;
  }
}

function texts(value: unknown): Record<string, string> {
  const entries = Object.entries(Object(value) as Record<string, unknown>);
  return Object.fromEntries(entries.filter((entry): entry is [string, string] => typeof entry[1] === 'string'));
}

function keep(all: Kept): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(all));
  } catch {
    // The current setup is not affected; it is only not stored.
  }
}
