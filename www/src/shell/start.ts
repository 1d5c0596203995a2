// The setup the element is run with.
//
// In: its attributes. Out: the setup as one JSON text.
// Must not know: what a setup may hold beyond the keys that are attributes too.

import type { SwitchesSet } from '../panels/panel';

/** The control where a setup names none. */
const CONTROL_IF_UNSAID = 'fanuc';

export type MergedSetup =
  | { readonly kind: 'setup'; readonly json: string }
  | { readonly kind: 'unreadable'; readonly reason: string };

/** Attributes that stand for keys of the setup; null where the setup itself decides. */
export interface SetupAttributes {
  readonly control: string | null;
  readonly blockSkip: string | null;
  readonly program: string | null;
}

/** The `setup` attribute with the other attributes put in their places. */
export function mergedSetup(json: string | null, { control, blockSkip, program }: SetupAttributes): MergedSetup {
  if (control === null && blockSkip === null && program === null) return { kind: 'setup', json: json ?? '{}' };
  let setup: unknown;
  try {
    setup = JSON.parse(json ?? '{}');
  } catch (error) {
    return { kind: 'unreadable', reason: error instanceof Error ? error.message : String(error) };
  }
  // Anything but an object is the interpreter's to refuse.
  if (typeof setup !== 'object' || setup === null || Array.isArray(setup)) return { kind: 'setup', json: json ?? '{}' };
  const merged: Record<string, unknown> = { ...setup };
  const dialect = merged['dialect'];
  // A setup that says nothing is read without the part of the interpreter that reads others.
  if (control !== null && (dialect !== undefined || control !== CONTROL_IF_UNSAID)) {
    merged['dialect'] = { ...(typeof dialect === 'object' ? dialect : {}), control };
  }
  if (blockSkip !== null)
    merged['blockSkip'] = blockSkip
      .split(/[\s,]+/)
      .filter((part) => part !== '')
      .map(numberOrText);
  if (program !== null) merged['program'] = numberOrText(program);
  return { kind: 'setup', json: JSON.stringify(merged) };
}

/** What is no number is the interpreter's to refuse. */
function numberOrText(text: string): number | string {
  return /^\d+$/.test(text) ? Number(text) : text;
}

export function switchesSet(merged: MergedSetup): SwitchesSet {
  if (merged.kind === 'unreadable') return { blockSkip: [], program: undefined };
  let setup: unknown;
  try {
    setup = JSON.parse(merged.json);
  } catch {
    return { blockSkip: [], program: undefined };
  }
  const { blockSkip, program } = Object(setup) as { readonly blockSkip?: unknown; readonly program?: unknown };
  return {
    blockSkip: Array.isArray(blockSkip) ? blockSkip.filter((level) => typeof level === 'number') : [],
    program: typeof program === 'number' ? program : undefined,
  };
}
