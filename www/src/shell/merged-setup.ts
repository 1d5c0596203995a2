// Merges the attributes of the element into one setup.
//
// In: the attributes. Out: the setup as JSON. Must not know: the content of a setup, except for the keys that are
// attributes too.

import type { SwitchState } from '../panels/panel';
import { describe } from '../worker/describe';

/** The default control. */
const DEFAULT_CONTROL = 'fanuc';

type MergedSetup =
  | { readonly kind: 'setup'; readonly json: string }
  | { readonly kind: 'unreadable'; readonly reason: string };

/** Attributes that override keys of the setup; null: the setup decides. */
interface SetupAttributes {
  readonly control: string | null;
  readonly blockSkip: string | null;
  readonly program: string | null;
}

/** The `setup` attribute with the values of the other attributes. */
export function mergeSetup(json: string | null, { control, blockSkip, program }: SetupAttributes): MergedSetup {
  if (control === null && blockSkip === null && program === null) return { kind: 'setup', json: json ?? '{}' };
  let setup: unknown;
  try {
    setup = JSON.parse(json ?? '{}');
  } catch (error) {
    return { kind: 'unreadable', reason: describe(error) };
  }
  // The interpreter reports anything but an object.
  if (typeof setup !== 'object' || setup === null || Array.isArray(setup)) return { kind: 'setup', json: json ?? '{}' };
  const merged: Record<string, unknown> = { ...setup };
  const dialect = merged['dialect'];
  // Without any settings, the part of the interpreter that parses setups is not needed.
  if (control !== null && (dialect !== undefined || control !== DEFAULT_CONTROL)) {
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

/** The interpreter reports a text that is not a number. */
function numberOrText(text: string): number | string {
  return /^\d+$/.test(text) ? Number(text) : text;
}

export function readSwitches(merged: MergedSetup): SwitchState {
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
