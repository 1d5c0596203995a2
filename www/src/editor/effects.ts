// Helpers for the effects of CodeMirror.

import type { StateEffect, StateEffectType } from '@codemirror/state';

/** The value of the last effect of a type; undefined if there is none. */
export function lastOf<T>(effects: readonly StateEffect<unknown>[], type: StateEffectType<T>): T | undefined {
  return effects.filter((effect) => effect.is(type)).at(-1)?.value;
}
